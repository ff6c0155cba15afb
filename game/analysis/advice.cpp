#include "game/analysis/advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "game/analysis/measures.h"
#include "game/words/words.h"
#include "sim/world/things.h"

namespace game {
namespace {

constexpr int kAround = 4;        // cells around a house in which it is looked for what came
constexpr double kStrong = 0.5;   // of the greatest pressure there: counts
constexpr float kHeaped = 0.5f;   // m of earth that are meant to hinder
constexpr double kMiddle = 0.15;  // of the greatest distance from the middle: no side of earth
constexpr double kEven = 0.05;    // of the radius: a slab of which as much is left on each side

const char* toward(glm::dvec2 way) {
    constexpr std::array<const char*, 8> kNames{
        message("north"), message("north-east"), message("east"), message("south-east"),
        message("south"), message("south-west"), message("west"), message("north-west")};
    const double eighths = std::atan2(way.x, way.y) / (std::numbers::pi / 4);
    return tr(kNames.at(static_cast<std::size_t>(std::lrint(eighths) + 8) % 8));
}

bool misses_a_need_on_houses(const Goal& goal, const Score& score) {
    for (std::size_t i = 0; i < goal.needs.size(); ++i) {
        const Measure measure = goal.needs[i].quantity.measure;
        const bool is_on_houses = measure == Measure::kLoad || measure == Measure::kDestroyed;
        if (is_on_houses && goal.needs[i].most && !score.needs[i].met) return true;
    }
    return false;
}

// From where the flow came that pressed hardest beside a house.
std::string what_hit(const sim::Thing& house, const sim::View& world, const Peaks& peaks) {
    const sim::Grid& grid = world.grid;
    const double dx = grid.dx;
    const auto middle_x = static_cast<int>(std::lrint(house.x / dx)),
               middle_y = static_cast<int>(std::lrint(house.y / dx));
    const int x0 = std::max(middle_x - kAround, 0), x1 = std::min(middle_x + kAround, grid.nx - 1),
              y0 = std::max(middle_y - kAround, 0), y1 = std::min(middle_y + kAround, grid.ny - 1);
    float greatest = 0;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) greatest = std::max(greatest, peaks.pressure[index_of(grid, x, y)]);
    glm::dvec2 way(0);
    float deepest = 0;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const double pressure = peaks.pressure[index_of(grid, x, y)];
            if (pressure < kStrong * static_cast<double>(greatest)) continue;
            way += pressure * (glm::dvec2(x * dx, y * dx) - glm::dvec2(house.x, house.y));
            deepest = std::max(deepest, peaks.depth[index_of(grid, x, y)]);
        }
    if (greatest <= 0 || glm::length(way) <= 0) return "";
    return said("The house with the greatest load was hit from the {}, by a flow up to {:.1f} m deep.",
                toward(way), deepest);
}

// How much of the earth that was heaped up the flow ran over, and where.
std::string what_passed(const sim::View& world, const Peaks& peaks) {
    const sim::Grid& grid = world.grid;
    const double dx = grid.dx;
    glm::dvec2 all(0), over(0);
    double heaped = 0, overrun = 0, farthest = 0;
    const auto each = [&](const auto& see) {
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x)
                if (world.things->earth(x, y) >= kHeaped)
                    see(glm::dvec2(x * dx, y * dx), index_of(grid, x, y));
    };
    each([&](glm::dvec2 place, std::size_t i) {
        all += place, ++heaped;
        if (static_cast<double>(peaks.depth[i]) >= Measures::kExtentDepth) over += place, ++overrun;
    });
    if (heaped == 0) return "";
    if (overrun == 0) return tr("The flow went past your earth.");
    const glm::dvec2 middle = all / heaped;
    each([&](glm::dvec2 place, std::size_t) { farthest = std::max(farthest, glm::length(place - middle)); });
    const glm::dvec2 aside = over / overrun - middle;
    const bool has_side = overrun < heaped && glm::length(aside) > kMiddle * farthest;
    return said("The flow ran over {:.0f} % of your earth{}.", 100 * overrun / heaped,
                has_side ? said(", most in the {} of it", toward(aside)) : "");
}

// How much of the slab was left to come down, and where; or that the house was hit before.
std::string what_was_left(const Goal& goal, const AttemptWatch::Slab& slab, std::int64_t load) {
    using sim::CommandKind;
    if (!tool_of(goal, CommandKind::kBlast) && !tool_of(goal, CommandKind::kDig)) return "";
    if (load > 0 && slab.load == load) return tr("That was before the slope let go.");
    const double percent = std::round(100 * slab.left);
    if (percent >= 100) return tr("When the slope let go, all of its cover was still there.");
    return said(
        "When the slope let go, {:.0f} % of its cover was still there{}.", percent,
        glm::length(slab.aside) > kEven ? said(", more in the {} than elsewhere", toward(slab.aside)) : "");
}

}  // namespace

std::string advice_after(const Goal& goal, const Score& score, const sim::View& world, const Peaks& peaks,
                         const std::optional<AttemptWatch::Slab>& slab) {
    if (!misses_a_need_on_houses(goal, score) || !world.things || peaks.pressure.empty()) return "";
    const sim::Thing* hit = nullptr;
    for (const sim::Thing& thing : world.things->list)
        if (thing.kind == sim::ThingKind::kHouse && thing.load > (hit ? hit->load : 0)) hit = &thing;
    if (!hit) return "";
    std::string advice;
    for (const std::string& sentence : {what_hit(*hit, world, peaks), what_passed(world, peaks),
                                        slab ? what_was_left(goal, *slab, hit->load) : std::string()})
        advice += (advice.empty() || sentence.empty() ? "" : " ") + sentence;
    return advice;
}

}  // namespace game
