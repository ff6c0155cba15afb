#include "game/app/dam_lines.h"

#include <algorithm>
#include <cmath>

#include "sim/world/things.h"

namespace game {

void DamLines::clear() {
    view_.reset();
    lines_.clear();
    note_.reset();
}

void DamLines::trace(const sim::View& world, const View& view,
                     const std::function<double(std::int64_t)>& cubic_metres,
                     const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen,
                     const std::function<std::optional<glm::dvec2>(glm::dvec3)>& on_screen) {
    if (!world.things) return clear();
    if (view_ == view) return;
    clear();
    view_ = view;
    const sim::Grid& grid = world.grid;
    const double dx = grid.dx;
    double highest = 0;
    std::int64_t filled = 0;
    for (int y = std::max(view.y - kReach, 0); y <= std::min(view.y + kReach, grid.ny - 1); ++y)
        for (int x = std::max(view.x - kReach, 0); x <= std::min(view.x + kReach, grid.nx - 1); ++x) {
            const double earth = world.things->earth(x, y);
            if (earth <= 0) continue;
            filled += std::llrint(earth / double{sim::kQuantum});
            if (earth < kLeastHeight) continue;
            const glm::dvec2 place(x * dx, y * dx);
            const auto top = seen(place);
            if (!top) continue;
            const double ground = static_cast<double>(world.bedrock(x, y)) + world.datum - earth;
            if (const auto foot = on_screen({place, ground}))
                lines_.push_back({*foot, *top, ui::GoalLine::Around::kDam});
            if (earth <= highest) continue;
            highest = earth;
            note_ = ui::DamNote{.at = *top};
        }
    if (!note_) return;
    note_->height = highest;
    note_->volume = cubic_metres(filled);
}

}  // namespace game
