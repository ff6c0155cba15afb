#pragma once

#include <string>

#include "game/recording/json_values.h"
#include "terrains/release.h"

namespace game {

// What became of the file of a release or of a reference, for the summary of a run: how its thickness was taken, its
// volume and the volume on ground, and each loss with its cause.
Json to_json(const terrains::Release& release);
Json to_json(const terrains::Reference& reference);
// Lines, each with its line break.
std::string to_text(const terrains::Release& release);
std::string to_text(const terrains::Reference& reference);

}  // namespace game
