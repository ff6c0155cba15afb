#pragma once

#include <memory>
#include <span>

#include <glm/vec3.hpp>

#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "game/ui/facts.h"

namespace game {

// Draws a map of what flowed in a session, the darker the faster, on a relief of the ground at tick 0. `by_hand`: what the
// user did. `height`: px; the default is about one and a half of what the card shows. Null if nothing was ever as deep as
// the extent of a slide is.
std::shared_ptr<const ui::SlideMap> map_of_slide(const Scenario& scenario, const Session& session,
                                                 std::span<const TimedCommand> by_hand, int height = 240);
// The colours of top speeds on that map, from slow to SlideMap::fastest in equal steps; sRGB, 0 to 255.
std::span<const glm::vec3> speed_colours();

}  // namespace game
