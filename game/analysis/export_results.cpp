#include "game/analysis/export_results.h"

#include <string>
#include <vector>

#include "game/files/text_file.h"
#include "terrains/export.h"

namespace game {
namespace {

// How much of the lower material has been moved and is there, m; empty in a world of one.
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

std::vector<float> deposit_of(const Start& start, const sim::State& state) {
    std::vector<float> deposit(start.grid.size());
    std::size_t i = 0;
    for (int y = 0; y < start.grid.ny; ++y)
        for (int x = 0; x < start.grid.nx; ++x, ++i)
            deposit[i] = state.depth(x, y) + state.rolling(x, y) - start.depth[i];
    return deposit;
}

Outcome<void> export_results(const std::filesystem::path& folder, const Start& start, const Session& session,
                             const Summary& summary) {
    if (auto made = make_folder(folder); !made) return made;
    const std::vector<float> deposit = deposit_of(start, session.state());
    const std::vector<float> lower = lower_material_of(session.state());
    std::vector<std::pair<std::string, const std::vector<float>*>> fields{
        {"deposit", &deposit},
        {"peak_depth", &session.peaks().depth},
        {"peak_speed", &session.peaks().speed}};
    if (start.lower) fields.emplace_back("lower_material", &lower);
    for (const auto& [name, field] : fields)
        for (const auto& written :
             {terrains::write_geotiff(folder / (name + ".tif"), start.grid, start.georeference, *field),
              terrains::write_ascii(folder / (name + ".asc"), start.grid, start.georeference, *field)})
            if (!written) return machine_fails(written.error());

    std::vector<std::uint8_t> extent(start.grid.size());
    for (std::size_t i = 0; i < extent.size(); ++i)
        extent[i] = session.peaks().depth[i] >= Measures::kExtentDepth;
    if (auto written =
            terrains::write_outlines(folder / "extent.geojson", start.grid, start.georeference, extent);
        !written)
        return machine_fails(written.error());
    return write_text(folder / "summary.json", printed(to_json(summary)));
}

void draw_results(Gallery& gallery, const Session& session) {
    const sim::View now = session.view();
    const sim::Field<float> peaks = peak_field(session);
    const sim::View extent{now.grid,       now.bedrock, now.depth,   peaks,     now.velocity_x,
                           now.velocity_y, now.site,    now.mixture, now.datum, now.tick};
    gallery.draw_map(extent, "map_extent");
    gallery.draw_map(now, "map_end");
}

terrains::Terrain ground_of(const Start& start) {
    terrains::Terrain terrain;
    terrain.name = start.terrain;
    terrain.licence = start.licence;
    terrain.grid = start.grid;
    terrain.has_data = start.has_data;
    terrain.cover = start.depth;
    terrain.georeference = start.georeference;
    terrain.surface.resize(start.grid.size());
    for (std::size_t i = 0; i < terrain.surface.size(); ++i)
        terrain.surface[i] = static_cast<float>(start.datum + static_cast<double>(start.bedrock[i]) +
                                                static_cast<double>(start.depth[i]));
    return terrain;
}

}  // namespace game
