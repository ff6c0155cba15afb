#include "game/analysis/export_results.h"

#include <string>
#include <vector>

#include "game/files/text_file.h"
#include "terrains/export.h"

namespace game {
namespace {

// How much of the lower material was moved and is now there, m; empty with one material.
std::vector<float> lower_material_of(const sim::State& state) {
    std::vector<float> amounts;
    if (!state.mixture) return amounts;
    for (int y = 0; y < state.grid.ny; ++y)
        for (int x = 0; x < state.grid.nx; ++x)
            amounts.push_back(state.mixture->settled(x, y) + state.mixture->rolling(x, y));
    return amounts;
}

// The rolling layer's peak as a field that can be drawn.
sim::Field<float> peak_field(const Session& session) {
    const sim::Grid& grid = session.state().grid;
    sim::Field<float> field(grid);
    std::size_t i = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x, ++i) field(x, y) = session.peaks().depth[i];
    return field;
}

}  // namespace

std::vector<float> deposit_of(const Scenario& scenario, const sim::State& state) {
    std::vector<float> deposit(scenario.grid.size());
    std::size_t i = 0;
    for (int y = 0; y < scenario.grid.ny; ++y)
        for (int x = 0; x < scenario.grid.nx; ++x, ++i)
            deposit[i] = state.depth(x, y) + state.rolling(x, y) - scenario.depth[i];
    return deposit;
}

Outcome<void> export_results(const std::filesystem::path& folder, const Scenario& scenario,
                             const Session& session, const Summary& summary) {
    if (auto made = make_folder(folder); !made) return made;
    const std::vector<float> deposit = deposit_of(scenario, session.state());
    const std::vector<float> thickness = peak_thickness_of(scenario, session.peaks());
    const std::vector<float> lower = lower_material_of(session.state());
    std::vector<std::pair<std::string, const std::vector<float>*>> fields{
        {"deposit", &deposit},
        {"peak_depth", &session.peaks().depth},
        {"peak_thickness", &thickness},
        {"peak_speed_slope", &session.peaks().speed_slope},
        {"peak_speed_plan", &session.peaks().speed_plan}};
    if (session.densities()) fields.emplace_back("peak_pressure", &session.peaks().pressure);
    if (scenario.lower) fields.emplace_back("lower_material", &lower);
    for (const auto& [name, field] : fields)
        for (const auto& written :
             {terrains::write_geotiff(folder / (name + ".tif"), scenario.grid, scenario.georeference, *field),
              terrains::write_ascii(folder / (name + ".asc"), scenario.grid, scenario.georeference, *field)})
            if (!written) return machine_fails(written.error());

    std::vector<std::uint8_t> extent(scenario.grid.size());
    for (std::size_t i = 0; i < extent.size(); ++i)
        extent[i] = session.peaks().depth[i] >= Measures::kExtentDepth;
    if (auto written =
            terrains::write_outlines(folder / "extent.geojson", scenario.grid, scenario.georeference, extent);
        !written)
        return machine_fails(written.error());
    return write_text(folder / "summary.json", printed(to_json(summary)));
}

void draw_results(Gallery& gallery, const Session& session) {
    const sim::View now = session.view();
    const sim::Field<float> peaks = peak_field(session);
    const sim::View extent{now.grid,       now.bedrock, now.depth,        peaks,       now.velocity_x,
                           now.velocity_y, now.site,    now.smooth_depth, now.mixture, now.things,
                           now.tiles,      now.datum,   now.tick};
    gallery.draw_map(extent, "map_extent");
    gallery.draw_map(now, "map_end");
}

terrains::Terrain ground_of(const Scenario& scenario) {
    terrains::Terrain terrain;
    terrain.name = scenario.terrain;
    terrain.licence = scenario.licence;
    terrain.grid = scenario.grid;
    terrain.has_data = scenario.has_data;
    terrain.cover = scenario.depth;
    terrain.georeference = scenario.georeference;
    terrain.surface.resize(scenario.grid.size());
    for (std::size_t i = 0; i < terrain.surface.size(); ++i)
        terrain.surface[i] = static_cast<float>(scenario.datum + static_cast<double>(scenario.bedrock[i]) +
                                                static_cast<double>(scenario.depth[i]));
    return terrain;
}

}  // namespace game
