#include "game/controls/cross_section.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "game/controls/probe.h"
#include "game/scene/surface.h"

namespace game {
namespace {

// The greatest of the nearest vertex, as PeakWatch found it.
double peak_near(const sim::View& world, const Square& square, const std::vector<float>& peaks) {
    const int x = square.x + (square.across.x >= 0.5), y = square.y + (square.across.y >= 0.5);
    const auto i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) + static_cast<std::size_t>(x);
    return i < peaks.size() ? static_cast<double>(peaks[i]) : 0;
}

SectionPoint read(const sim::View& world, glm::dvec2 at, const Peaks& peaks) {
    const Square square = square_under(world.grid, at);
    SectionPoint point{.has_data = has_data(square, world.site)};
    if (!point.has_data) return point;
    point.ground = between(square, world.bedrock) + world.datum;
    point.standing = between(square, world.depth);
    point.rolling = between(square, world.rolling);
    point.peak_speed = peak_near(world, square, peaks.speed_slope);
    if (point.rolling < static_cast<double>(Peaks::kVisible)) return point;
    const glm::dvec2 velocity(between(square, world.velocity_x), between(square, world.velocity_y));
    point.speed = speed_along_slope(velocity, slope_of_ground(world, square));
    return point;
}

}  // namespace

double SectionLine::length() const {
    return glm::distance(from, to);
}

void CrossSection::lay(const SectionLine& line, double zero) {
    clear();
    line_ = line;
    zero_ = zero;
}

void CrossSection::see(const sim::View& world, const Peaks& peaks) {
    if (!line_) return;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(points_.size() - 1);
        SectionPoint& point = points_[i];
        point = read(world, glm::mix(line_->from, line_->to, share), peaks);
        point.ground -= zero_;
        deepest_ = std::max(deepest_, point.standing + point.rolling);
    }
}

}  // namespace game
