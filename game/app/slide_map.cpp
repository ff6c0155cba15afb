#include "game/app/slide_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "game/analysis/measures.h"
#include "game/compare/relief.h"
#include "render/pictures/sheet.h"

namespace game {
namespace {

constexpr float kAspect = 2;      // the most by which a side is longer than the other
constexpr float kMargin = 0.12f;  // of the slide, on each side
// Of the top speed, from slow to fast; sRGB.
const std::array<glm::vec3, 5> kSpeeds{
    {{158, 202, 225}, {107, 174, 214}, {66, 133, 198}, {24, 86, 170}, {8, 42, 108}}};

// Vertices, inclusive.
struct Box {
    glm::vec2 first{1e9f}, last{-1e9f};
    bool empty() const { return first.x > last.x; }
    void add(glm::vec2 vertex) { first = glm::min(first, vertex), last = glm::max(last, vertex); }
};

Box box_of_extent(const sim::Grid& grid, std::span<const float> depth) {
    Box box;
    std::size_t i = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x, ++i)
            if (depth[i] >= Measures::kExtentDepth) box.add({x, y});
    return box;
}

// The map's part of the grid: the slide with a margin, widened as far as there is ground. On a narrow grid that may not
// be all of the slide.
Box framed(const Box& slide, const sim::Grid& grid) {
    constexpr float kLeast = 24;  // cells
    const glm::vec2 most(grid.nx - 1, grid.ny - 1);
    const glm::vec2 least =
        glm::min(glm::max((slide.last - slide.first) * (1 + 2 * kMargin), glm::vec2(kLeast)), most);
    const float height = std::min({std::max(least.y, least.x / kAspect), most.y, kAspect * most.x});
    const glm::vec2 half = glm::vec2(std::min(kAspect * height, most.x), height) / 2.f,
                    middle = glm::clamp((slide.first + slide.last) / 2.f, half, most - half);
    return {middle - half, middle + half};
}

void add_marks(const Session& session, std::span<const TimedCommand> by_hand, ui::SlideMap& map) {
    using Kind = ui::SlideMap::Mark::Kind;
    if (const auto& things = session.state().things)
        for (const sim::Thing& thing : things->list)
            if (thing.kind == sim::ThingKind::kHouse || thing.kind == sim::ThingKind::kStation)
                map.marks.push_back({{thing.x, thing.y},
                                     thing.destroyed() ? Kind::kDestroyed
                                     : thing.damaged() ? Kind::kDamaged
                                                       : Kind::kIntact});
    // One mark for what a stroke gave in many ticks, and none over another.
    const double apart = 0.06 * (map.north_east - map.south_west).y;
    for (const TimedCommand& each : by_hand) {
        const sim::Command& command = each.command;
        const auto& numbers = sim::info_of(command.kind).numbers;
        if (std::ranges::find(numbers, &sim::Command::x, &sim::CommandNumber::value) == numbers.end())
            continue;
        const glm::dvec2 at(command.x, command.y);
        const auto is_near = [&](const ui::SlideMap::Mark& mark) {
            return mark.kind == Kind::kCommand &&
                   glm::distance(mark.at, at) < std::max(command.radius, apart);
        };
        if (std::ranges::none_of(map.marks, is_near)) map.marks.push_back({at, Kind::kCommand});
    }
}

}  // namespace

std::span<const glm::vec3> speed_colours() {
    return kSpeeds;
}

std::shared_ptr<const ui::SlideMap> map_of_slide(const Scenario& scenario, const Session& session,
                                                 std::span<const TimedCommand> by_hand, int height) {
    const Peaks& peaks = session.peaks();
    const sim::Grid& grid = scenario.grid;
    const Box slide = box_of_extent(grid, peaks.depth);
    if (slide.empty()) return nullptr;
    const Box frame = framed(slide, grid);

    const glm::vec2 size = frame.last - frame.first;  // cells
    const float scale = static_cast<float>(height) / size.y;
    const int width = static_cast<int>(std::lround(scale * size.x));
    render::Sheet sheet(width, height);
    const Relief relief(scenario, frame.first + 0.5f, frame.last - 0.5f, {0, 0}, scale);
    float fastest = 0;
    for (std::size_t i = 0; i < peaks.depth.size(); ++i)
        if (peaks.depth[i] >= Measures::kExtentDepth) fastest = std::max(fastest, peaks.speed_slope[i]);
    relief.draw(sheet, [&](glm::vec2 cells) -> Relief::Tint {
        if (between(grid, peaks.depth, cells) < Measures::kExtentDepth) return {};
        const float share = between(grid, peaks.speed_slope, cells) / std::max(fastest, 1e-3f);
        const auto last = static_cast<int>(kSpeeds.size()) - 1;
        const int i = std::clamp(static_cast<int>(share * static_cast<float>(kSpeeds.size())), 0, last);
        return {kSpeeds[static_cast<std::size_t>(i)], 0.92f};
    });

    auto map = std::make_shared<ui::SlideMap>();
    map->width = width, map->height = height, map->fastest = static_cast<double>(fastest);
    map->texels = std::move(sheet.picture.pixels);
    map->south_west = glm::dvec2(frame.first) * static_cast<double>(grid.dx);
    map->north_east = glm::dvec2(frame.last) * static_cast<double>(grid.dx);
    add_marks(session, by_hand, *map);
    return map;
}

}  // namespace game
