#pragma once

#include <memory>
#include <span>

#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "game/ui/facts.h"

namespace game {

// Draws a map of what flowed in a session, the darker the faster, on a relief of the ground at tick 0. `by_hand`: what the
// user did. Null if nothing was ever as deep as the extent of a slide is.
std::shared_ptr<const ui::SlideMap> map_of_slide(const Scenario& scenario, const Session& session,
                                                 std::span<const TimedCommand> by_hand);

}  // namespace game
