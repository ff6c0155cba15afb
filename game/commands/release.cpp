#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "game/analysis/measures.h"
#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/compare/map_page.h"
#include "game/files/file_use.h"
#include "game/pages/table.h"
#include "game/recording/json_values.h"
#include "render/pictures/picture.h"
#include "terrains/export.h"
#include "terrains/share_raster.h"

namespace game {
namespace {

using terrains::ReleaseArea;
using terrains::ReleaseAreas;

double volume_of(const ReleaseArea& area, double thickness) {
    return area.area_on_slope * thickness;
}

double total_volume(const ReleaseAreas& found, double thickness) {
    double volume = 0;
    for (const ReleaseArea& area : found.areas) volume += volume_of(area, thickness);
    return volume;
}

// What is told of an area, in the file, as a table and as JSON.
struct Column {
    const char *name, *head;
    int digits;
    double (*value)(const ReleaseArea&, double thickness);
};
constexpr Column kColumns[] = {
    {"area_on_slope_m2", "area on slope, m2", 0,
     [](const ReleaseArea& a, double) { return a.area_on_slope; }},
    {"volume_m3", "volume, m3", 0, volume_of},
    {"slope_deg", "slope, deg", 1, [](const ReleaseArea& a, double) { return a.slope; }},
    {"aspect_deg", "aspect, deg", 0, [](const ReleaseArea& a, double) { return a.aspect; }},
    {"lowest_m", "lowest, m", 0, [](const ReleaseArea& a, double) { return a.lowest; }},
    {"highest_m", "highest, m", 0, [](const ReleaseArea& a, double) { return a.highest; }},
    {"favour", "favour", 2, [](const ReleaseArea& a, double) { return a.favour; }},
};

terrains::Properties properties_of(const ReleaseArea& area, int number, double thickness) {
    terrains::Properties properties{{"number", number}, {"thickness_normal", thickness}};
    for (const Column& column : kColumns) {
        const double scale = std::pow(10, column.digits);
        properties.emplace_back(column.name, std::round(column.value(area, thickness) * scale) / scale);
    }
    return properties;
}

std::string report_of(const ReleaseAreas& found, const ReleaseOptions& options, const Scenario& world) {
    constexpr std::size_t kMostShown = 12;
    double area = 0;
    for (const ReleaseArea& each : found.areas) area += each.area;
    std::string text =
        fmt::format("{}: {} release areas on {:.2f} of {:.2f} km2, {:.0f} m3 at {} m normal to the slope\n",
                    world.terrain, found.areas.size(), area / 1e6,
                    static_cast<double>(world.grid.size()) * world.grid.cell_area() / 1e6,
                    total_volume(found, options.thickness), options.thickness);
    if (found.areas.empty()) return text;
    Table table{"", {"number"}, {}};
    for (const Column& column : kColumns) table.head.emplace_back(column.head);
    for (std::size_t i = 0; i < std::min(found.areas.size(), kMostShown); ++i) {
        std::vector<std::string> row{fmt::format("{}", i + 1)};
        for (const Column& column : kColumns)
            row.push_back(
                fmt::format("{:.{}f}", column.value(found.areas[i], options.thickness), column.digits));
        table.rows.push_back(std::move(row));
    }
    text += as_text(table);
    if (found.areas.size() > kMostShown)
        text += fmt::format("  and {} smaller ones\n", found.areas.size() - kMostShown);
    return text;
}

Json json_of(const ReleaseAreas& found, const ReleaseOptions& options) {
    Json json{{"areas", Json::array()}, {"volume_m3", std::round(total_volume(found, options.thickness))}};
    for (std::size_t i = 0; i < found.areas.size(); ++i) {
        Json area;
        for (const auto& [name, value] :
             properties_of(found.areas[i], static_cast<int>(i) + 1, options.thickness))
            area[name] = value;
        json["areas"].push_back(std::move(area));
    }
    return json;
}

// Colours by aspect around the compass, so that neighbours differ and a slope's exposition is seen at once: cold to the
// north, warm to the south.
glm::vec3 colour_of(double aspect) {
    constexpr std::array<std::array<float, 3>, 8> kColours{{{49, 84, 173},
                                                            {46, 139, 170},
                                                            {66, 160, 94},
                                                            {190, 178, 48},
                                                            {217, 84, 43},
                                                            {196, 62, 104},
                                                            {146, 72, 160},
                                                            {94, 72, 180}}};
    const auto& [r, g, b] = kColours.at(static_cast<std::size_t>(std::lround(aspect / 45)) % kColours.size());
    return {r, g, b};
}

// Lines between neighbours of different numbers.
void draw_borders(const ReleaseAreas& found, const sim::Grid& grid, MapPage& page) {
    const glm::vec3 kLine{40, 32, 30};
    const auto number = [&](int x, int y) { return found.number[index_of(grid, x, y)]; };
    const auto draw = [&](glm::vec2 from, glm::vec2 to) {
        page.sheet().line(page.relief().place(from), page.relief().place(to), 0.9f, kLine);
    };
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const glm::vec2 middle(x, y);
            if (x + 1 < grid.nx && number(x, y) != number(x + 1, y))
                draw(middle + glm::vec2(0.5f, -0.5f), middle + glm::vec2(0.5f, 0.5f));
            if (y + 1 < grid.ny && number(x, y) != number(x, y + 1))
                draw(middle + glm::vec2(-0.5f, 0.5f), middle + glm::vec2(0.5f, 0.5f));
        }
}

render::Picture map_of(const ReleaseAreas& found, const ReleaseOptions& options, const Scenario& world) {
    MapPage page(world);
    const sim::Grid& grid = world.grid;
    page.relief().draw(page.sheet(), [&](glm::vec2 cells) {
        const int x = static_cast<int>(std::lround(cells.x)), y = static_cast<int>(std::lround(cells.y));
        Relief::Tint tint;
        if (!grid.contains(x, y)) return tint;
        const int number = found.number[index_of(grid, x, y)];
        if (number > 0) tint = {colour_of(found.areas[static_cast<std::size_t>(number) - 1].aspect), 0.7f};
        return tint;
    });
    draw_borders(found, grid, page);
    page.title("Potential release areas");
    page.say(fmt::format("{}: {} areas, {:.0f} m³ at {} m", world.terrain, found.areas.size(),
                         total_volume(found, options.thickness), options.thickness));
    page.skip(12);
    page.whisper("falls to the");
    constexpr std::array kNames{"north", "north-east", "east", "south-east",
                                "south", "south-west", "west", "north-west"};
    for (std::size_t i = 0; i < kNames.size(); ++i)
        page.swatch(colour_of(45 * static_cast<double>(i)), kNames.at(i));
    page.skip(12);
    const terrains::ReleaseRules& rules = options.rules;
    page.whisper(fmt::format("slope {:g} to {:g}°", rules.least_slope, rules.most_slope));
    page.whisper(fmt::format("ruggedness of 3 × 3 cells up to {:g}", rules.most_ruggedness));
    page.whisper(fmt::format("curvature of contours up to {:g} rad per 100 m", rules.most_curvature));
    if (options.forest)
        page.whisper(fmt::format("crowns over up to {:.0f} % of a cell", 100 * rules.most_forest));
    page.whisper(fmt::format("{:g} to {:.0f} m²", rules.least_area, rules.most_area));
    page.skip(8);
    if (!world.licence.empty()) page.whisper(world.licence);
    page.whisper("Judged by the shape of the ground alone. Not a hazard assessment.");
    page.coordinates();
    page.scale_bar();
    return page.sheet().picture;
}

}  // namespace

Outcome<int> release(const ReleaseOptions& options) {
    if (options.rules.least_slope >= options.rules.most_slope)
        return unusable(fmt::format("--slope {}:{}: the first is not below the second",
                                    options.rules.least_slope, options.rules.most_slope));
    Overrides overrides = options.overrides;
    overrides.own_grid = true;
    // A scene has a name, or is a file of its own kind.
    const std::string ending = options.ground.extension().string();
    const bool is_scene = ending.empty() || ending == ".toml";
    auto scene = is_scene ? load_scene(options.ground.string(), overrides)
                          : scene_of_terrain(options.ground, std::nullopt, overrides);
    if (!scene) return tl::unexpected(scene.error());
    const Scenario& world = scene->scenario;
    std::vector<std::uint8_t> forest;
    if (options.forest) {
        auto read = terrains::read_shares(*options.forest, world.grid, world.georeference,
                                          options.overrides.references, scene->files);
        if (!read) return unusable(read.error());
        forest = std::move(*read);
    }
    FileUse use;
    use.reads(scene->files).writes("--out", options.out).writes("--map", options.map);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    for (const std::string& warning : scene->warnings) print_line(stderr, "couloir: {}", warning);

    std::vector<float> surface(world.grid.size());
    for (std::size_t i = 0; i < surface.size(); ++i)
        surface[i] = static_cast<float>(world.datum) + world.bedrock[i] + world.depth[i];
    const ReleaseAreas found =
        terrains::find_release_areas(world.grid, surface, world.has_data, forest, options.rules);
    if (options.out) {
        std::vector<terrains::Properties> properties;
        for (const ReleaseArea& area : found.areas)
            properties.push_back(
                properties_of(area, static_cast<int>(properties.size()) + 1, options.thickness));
        if (auto written =
                terrains::write_areas(*options.out, world.grid, world.georeference, found.number, properties);
            !written)
            return machine_fails(written.error());
    }
    if (options.map)
        if (auto written = render::write_png(map_of(found, options, world), *options.map); !written)
            return machine_fails(written.error());
    print_text(options.json ? printed(json_of(found, options)) : report_of(found, options, world));
    return found.areas.empty() ? Failure::kBadAnswer : 0;
}

}  // namespace game
