#include "game/scene/poured_beside.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/world/disc.h"

namespace game {

std::optional<std::string> warning_of_pours(const sim::Grid& grid, const std::vector<std::uint8_t>& has_data,
                                            const std::vector<TimedCommand>& commands) {
    std::size_t beside = 0;
    double worst = 0;
    const sim::Command* worst_one = nullptr;
    for (const TimedCommand& timed : commands) {
        const sim::Command& command = timed.command;
        if (command.kind != sim::CommandKind::kPour) continue;
        const sim::Disc disc(command, static_cast<double>(grid.dx));
        double on_ground = 0;
        disc.each_vertex(grid, command.profile, [&](int x, int y, double weight) {
            const auto i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
            if (has_data[i] != 0) on_ground += weight;
        });
        const double lost = 1 - on_ground / disc.total_weight(static_cast<double>(grid.dx), command.profile);
        constexpr double kClosedForm = 1e-3;  // how exact total_weight() is of a large disc
        if (lost < kClosedForm) continue;
        ++beside;
        if (lost > worst) worst = lost, worst_one = &command;
    }
    if (beside == 0) return std::nullopt;
    return fmt::format(
        "{} of its commands pour{} beside the ground, where nothing can lie: at {:.6g}, {:.6g} with a radius "
        "of {:.6g} m "
        "{:.0f} % are lost",
        beside, beside == 1 ? "s" : "", worst_one->x, worst_one->y, worst_one->radius,
        std::ceil(100 * worst));
}

}  // namespace game
