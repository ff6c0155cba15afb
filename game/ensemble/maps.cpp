#include "game/ensemble/maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "game/analysis/measures.h"
#include "game/compare/map_page.h"
#include "game/ensemble/results.h"
#include "render/frame/marks.h"

namespace game {
namespace {

// Classes of a map's values, from small to large: values from `least` up to that of the next.
struct Class {
    float least;
    glm::vec3 colour;
    std::string words;
};

// viridis (van der Walt and Smith 2015), light at 0 and dark at 1.
glm::vec3 colour_at(float share) {
    constexpr std::array<glm::vec3, 6> kRamp{
        {{253, 231, 37}, {122, 209, 81}, {34, 168, 132}, {42, 120, 142}, {65, 68, 135}, {68, 1, 84}}};
    const float place = share * static_cast<float>(kRamp.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
    return glm::mix(kRamp.at(below), kRamp.at(below + 1), place - static_cast<float>(below));
}

// Classes from each bound to the next one.
std::vector<Class> classes_from(const std::vector<float>& bounds, bool dark_is_large, std::string_view unit) {
    std::vector<Class> classes;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const float share =
            bounds.size() > 1 ? static_cast<float>(i) / static_cast<float>(bounds.size() - 1) : 1;
        classes.push_back({bounds[i], colour_at(dark_is_large ? share : 1 - share),
                           i + 1 < bounds.size()
                               ? fmt::format("{:g} to {:g} {}", bounds[i], bounds[i + 1], unit)
                               : fmt::format("{:g} {} and more", bounds[i], unit)});
    }
    return classes;
}

// Those of the window, but that every run of many counts.
std::vector<Class> classes_of_probability() {
    std::vector<float> bounds;
    for (const render::LegendStop& stop : render::legend_of(render::Overlay::kProbability).stops)
        bounds.push_back(stop.value);
    std::vector<Class> classes = classes_from(bounds, true, "%");
    for (Class& each : classes) each.least /= 100;
    classes.front().least = 1e-6f, classes.front().words = fmt::format("below {:g} %", bounds[1]);
    return classes;
}

// Greatest of the values that are there.
float most_of(const std::vector<float>& values) {
    float most = 0;
    for (const float value : values)
        if (value > most) most = value;
    return most;
}

// A 1, 2 or 5 with a power of ten, the `step`-th from 1.
float round_number(int step) {
    constexpr std::array kDigits{1.f, 2.f, 5.f};
    const int power = static_cast<int>(std::floor(step / 3.0));
    return kDigits.at(static_cast<std::size_t>(step - 3 * power)) * static_cast<float>(std::pow(10, power));
}

// Six bounds 1, 2, 5, 10 … up to the greatest value.
std::vector<Class> classes_of_peak(const EnsembleMap& map) {
    constexpr int kClasses = 6, kLeast = -6;  // 0.01
    const float most = most_of(map.values);
    int last = kLeast;
    while (round_number(last + 1) <= most) ++last;
    std::vector<float> bounds;
    for (int step = std::max(kLeast, last - kClasses + 1); step <= last; ++step)
        bounds.push_back(round_number(step));
    return classes_from(bounds, true, map.unit);
}

// At most ten equal classes of round seconds, dark is early.
std::vector<Class> classes_of_arrival(const EnsembleMap& map) {
    constexpr int kMostClasses = 10;
    const float most = most_of(map.values);
    int step = 0;
    while (round_number(step) * kMostClasses < most) ++step;
    std::vector<float> bounds;
    for (int i = 0; static_cast<float>(i) * round_number(step) <= most; ++i)
        bounds.push_back(static_cast<float>(i) * round_number(step));
    return classes_from(bounds, false, map.unit);
}

// Of a number of release areas: each up to three, then 1, 2, 5 with powers of ten.
std::vector<Class> classes_of_areas(const EnsembleMap& map) {
    const float most = most_of(map.values);
    std::vector<float> bounds{0, 1.5f, 2.5f};
    constexpr int kFive = 2;
    for (int step = kFive; round_number(step) <= most; ++step) bounds.push_back(round_number(step));
    std::vector<Class> classes = classes_from(bounds, true, map.unit);
    classes[0].least = 1e-6f, classes[0].words = "1 area", classes[1].words = "2 areas";
    classes[2].words = "3 and more";
    if (bounds.size() > 3) classes[2].words = "3 to 5 areas";
    return classes;
}

std::vector<Class> classes_of(const EnsembleMap& map) {
    switch (map.kind) {
        case EnsembleMap::Kind::kAreas:
            return classes_of_areas(map);
        case EnsembleMap::Kind::kPolygon:
        case EnsembleMap::Kind::kPeak:
            return classes_of_peak(map);
        case EnsembleMap::Kind::kArrival:
            return classes_of_arrival(map);
        case EnsembleMap::Kind::kProbability:
            break;
    }
    return classes_of_probability();
}

std::string legend_of(const Variable& variable) {
    constexpr std::size_t kMostNumbers = 6;
    const std::vector<double>& numbers = variable.distribution.numbers;
    std::string text;
    for (std::size_t i = 0; i < std::min(numbers.size(), kMostNumbers); ++i)
        text += fmt::format("{}{}", i > 0 ? ", " : "", numbers[i]);
    if (numbers.size() > kMostNumbers) text += ", …";
    return fmt::format("{}: {} ({})", variable.name(), info_of(variable.distribution.kind).name, text);
}

// The field with values where it has none, so that it can be interpolated up to its border: the mean of the neighbours', or 0.
std::vector<float> filled(const sim::Grid& grid, const std::vector<float>& field) {
    std::vector<float> full = field;
    std::size_t i = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x, ++i) {
            if (!std::isnan(field[i])) continue;
            float sum = 0, count = 0;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, grid.ny - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, grid.nx - 1); ++u)
                    if (const float near = field[index_of(grid, u, v)]; !std::isnan(near))
                        sum += near, ++count;
            full[i] = count > 0 ? sum / count : 0;
        }
    return full;
}

}  // namespace

std::vector<EnsembleMap> maps_of(const EnsembleSpec& spec, const EnsembleResult& result) {
    std::vector<EnsembleMap> maps;
    const auto areas = static_cast<float>(spec.scene.patches.size());
    if (areas > 0) {
        EnsembleMap hardest{
            "hardest_polygon", "Release area that hits hardest", {}, EnsembleMap::Kind::kPolygon, "1"};
        for (const std::int64_t member : result.counts.hardest())
            hardest.values.push_back(member == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                 : static_cast<float>(*spec.patch_of(member)));
        maps.push_back(std::move(hardest));
    }
    for (std::size_t i = 0; i < spec.maps.thresholds.size(); ++i) {
        const Threshold& each = spec.maps.thresholds[i];
        const MappedInfo& info = info_of(each.of);
        if (areas > 0) {
            std::vector<float> values = result.counts.probability(i);
            for (float& value : values) value *= areas;
            maps.push_back({fmt::format("areas_{}_over_{}", info.name, each.least),
                            fmt::format("Release areas that bring a {} of {} {} and more", info.name,
                                        each.least, info.unit),
                            std::move(values), EnsembleMap::Kind::kAreas, "areas"});
            continue;
        }
        maps.push_back({fmt::format("probability_{}_over_{}", info.name, each.least),
                        fmt::format("Probability of {} of {} {} and more", info.name, each.least, info.unit),
                        result.counts.probability(i), EnsembleMap::Kind::kProbability, "1"});
    }
    for (const Percentile& each : spec.maps.percentiles) {
        const MappedInfo& info = info_of(each.of);
        const std::vector<float> values = result.counts.percentile(each);
        const std::string name = fmt::format("percentile_{}_of_{}", each.share, info.name);
        if (each.of == Mapped::kArrival)
            maps.push_back({name,
                            fmt::format("Time by which the flow has come in {} % of all members", each.share),
                            values, EnsembleMap::Kind::kArrival, info.unit});
        else
            maps.push_back(
                {name, fmt::format("Greatest {} not exceeded in {} % of all members", info.name, each.share),
                 values, EnsembleMap::Kind::kPeak, info.unit});
    }
    return maps;
}

namespace {

// A colour for a number, far from those of the numbers next to it.
glm::vec3 polygon_colour(int number) {
    constexpr float kGolden = 0.618034f, kTurn = 6.2831853f;
    const float hue = static_cast<float>(number) * kGolden * kTurn;
    const float light = number % 2 == 0 ? 168.f : 132.f;
    return glm::vec3(light) +
           58.f * glm::vec3(std::cos(hue), std::cos(hue - kTurn / 3), std::cos(hue + kTurn / 3));
}

// Each place in the colour of the release area that hits it hardest, and that area itself, darker.
void draw_polygons(const EnsembleMap& map, const EnsembleSpec& spec, MapPage& page) {
    const sim::Grid& grid = spec.scene.scenario.grid;
    std::vector<int> of(grid.size());      // the area that a vertex is in itself
    std::vector<float> inside(of.size());  // 1 in any
    for (std::size_t i = 0; i < spec.scene.patches.size(); ++i)
        for (const std::uint32_t vertex : spec.scene.patches[i].release.vertices)
            of[vertex] = static_cast<int>(i) + 1, inside[vertex] = 1;
    page.relief().draw(page.sheet(), [&](glm::vec2 cells) {
        Relief::Tint tint;
        const int x = static_cast<int>(std::lround(cells.x)), y = static_cast<int>(std::lround(cells.y));
        if (!grid.contains(x, y)) return tint;
        const std::size_t i = index_of(grid, x, y);
        if (of[i] != 0)
            tint = {0.62f * polygon_colour(of[i]), 0.9f};
        else if (!std::isnan(map.values[i]))
            tint = {polygon_colour(static_cast<int>(map.values[i])), 0.72f};
        return tint;
    });
    page.relief().outline(page.sheet(), inside, 0.5f, 1, 0, {20, 20, 24});
}

// The classes of a field, with the outline of one half of a probability. `shown`: 1 where it has a value of a class.
void draw_field(const EnsembleMap& map, const std::vector<Class>& classes, const std::vector<float>& shown,
                const sim::Grid& grid, MapPage& page) {
    const std::vector<float> values = filled(grid, map.values);
    page.relief().draw(page.sheet(), [&](glm::vec2 cells) {
        Relief::Tint tint;
        // Nothing between an early arrival and none.
        if (map.kind == EnsembleMap::Kind::kArrival && between(grid, shown, cells) < 0.5f) return tint;
        const float value = between(grid, values, cells);
        for (const Class& each : classes)
            if (value >= each.least) tint = {each.colour, 0.82f};
        return tint;
    });
    if (map.kind == EnsembleMap::Kind::kProbability)
        page.relief().outline(page.sheet(), values, 0.5f, 1.4f, 0, {20, 20, 24});
}

void tell_polygons(const EnsembleMap& map, const EnsembleSpec& spec, MapPage& page) {
    std::map<int, std::size_t> cells;
    std::size_t all = 0;
    for (const float value : map.values)
        if (!std::isnan(value)) ++cells[static_cast<int>(value)], ++all;
    std::vector<std::pair<std::size_t, int>> order;
    order.reserve(cells.size());
    for (const auto& [number, many] : cells) order.emplace_back(many, number);
    std::ranges::sort(order, [](const auto& a, const auto& b) {
        return std::pair(b.first, a.second) < std::pair(a.first, b.second);
    });
    constexpr std::size_t kMostTold = 8;
    for (std::size_t i = 0; i < std::min(order.size(), kMostTold); ++i)
        page.swatch(polygon_colour(order[i].second),
                    fmt::format("polygon {}: {:.1f} % of what is reached", order[i].second,
                                100 * static_cast<double>(order[i].first) / static_cast<double>(all)));
    page.whisper(fmt::format("by {}; release areas are dark, {} in all", info_of(*spec.maps.hardest).name,
                             spec.scene.patches.size()));
}

}  // namespace

render::Picture picture_of(const EnsembleMap& map, const EnsembleSpec& spec, const EnsembleResult& result) {
    const Scenario& scenario = spec.scene.scenario;
    const std::vector<Class> classes = classes_of(map);
    const float least = classes.front().least;
    std::vector<float> shown(map.values.size());  // 1 where there is a value of a class
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = map.values[i] >= least ? 1 : 0;
    MapPage page(scenario, frame_around(scenario.grid, [&](std::size_t i) { return shown[i] > 0; }));
    const bool is_probability = map.kind == EnsembleMap::Kind::kProbability;
    const bool is_polygon = map.kind == EnsembleMap::Kind::kPolygon;
    if (is_polygon)
        draw_polygons(map, spec, page);
    else
        draw_field(map, classes, shown, scenario.grid, page);
    page.title(map.title);
    page.say(fmt::format("{}: {} members", spec.title, result.counts.members()));
    page.skip(12);
    if (is_polygon)
        tell_polygons(map, spec, page);
    else
        for (std::size_t i = classes.size(); i-- > 0;) page.swatch(classes[i].colour, classes[i].words);
    if (is_probability) {
        page.skip(6);
        page.stroke(1.6f, 0, {20, 20, 24}, "one half");
    }
    page.skip(12);
    const Spread run_out = spread_of(values_of(result, &Member::run_out));
    page.say(fmt::format("run-out {:.0f} m (four of five: {:.0f} to {:.0f})", run_out.middle, run_out.tenth,
                         run_out.nine_tenths));
    page.skip(8);
    for (const Variable& variable : spec.variables) page.whisper(legend_of(variable));
    page.skip(8);
    page.whisper(scenario.terrain + (scenario.licence.empty() ? "" : ". " + scenario.licence));
    page.whisper("Not a hazard assessment.");
    if (const std::string corner = scenario.georeference.describe({0, 0}); !corner.empty())
        page.whisper("South-west corner of the grid: " + corner);
    page.coordinates();
    page.scale_bar();
    return page.sheet().picture;
}

}  // namespace game
