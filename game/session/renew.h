#pragma once

#include "game/recording/reader.h"

namespace game {

// Gives a renewed recording (Header::renewed) the numbers that its materials have today. One that is not shipped
// leaves the defaults: a recording reaches no other file.
void renew(Recording& recording);

}  // namespace game
