#pragma once

#include <string>

#include "game/base/outcome.h"
#include "game/controls/guide.h"

namespace game {

// How far the guide has led this person, kept in couloir/guide.json in the XDG data folder.
struct Remembered {
    Guide guide;
    std::string
        told;  // what was wrong with the file, which is kept beside under another name; empty: nothing
};
Remembered remembered_guide();

// Errors: the file cannot be written (3).
Outcome<void> remember(const Guide& guide);

}  // namespace game
