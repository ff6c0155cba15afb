#pragma once

#include <span>
#include <vector>

#include "game/ui/panels.h"

namespace game::ui {

// How far the challenges that ship have been won.
struct Ladder {
    int challenges = 0, won = 0;  // those that are open or may be opened; with a medal
    int stars = 0;                // three for gold
};
Ladder ladder_of(const std::vector<Catalogue::Entry>& scenes);

// A harder challenge is closed until the other one was won in gold, or it was played itself. The other one; null if this
// one is open.
const Catalogue::Entry* waits_for(const Catalogue::Entry& entry, const Facts& facts);

// "An avalanche in a winter valley, 30 Nov 18:04", of one of the user's recordings; cut to fit.
const char* write_recording(std::span<char> text, const Catalogue::Entry& recording,
                            const Catalogue& catalogue);

void challenges_page(Desk& desk, const Facts& facts, Actions& actions);
void free_play_page(Desk& desk, const Facts& facts, Actions& actions);
void hill_page(Desk& desk, const Facts& facts, Actions& actions);
void pad_page(Desk& desk, const Facts& facts);
void keys_page(Desk& desk, const Facts& facts, Actions& actions);
void watch_page(Desk& desk, const Facts& facts, Actions& actions);

}  // namespace game::ui
