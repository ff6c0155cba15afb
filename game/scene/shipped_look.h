#pragma once

#include "game/base/outcome.h"
#include "game/scene/scenario.h"

namespace game {

// Where the look of a recording comes from. A look belongs to the view, never to the simulation.
enum class LookFrom {
    kShipped,   // today's materials of the same names
    kRecorded,  // the recording, as drawn when it was made
};

// Gives a recorded scenario its look. With kShipped, what is not shipped keeps the recorded look: a material of
// the user's own, and the texture of a flow demo. Errors: a shipped material is damaged.
Outcome<void> take_look(LookFrom from, Scenario& scenario);

}  // namespace game
