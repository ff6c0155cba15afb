#include "game/scene/viewpoint.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace game {

render::Camera camera_of(const Viewpoint& view, double height, const render::Camera& like) {
    return {.target = {view.east, view.north, height},
            .azimuth_deg = view.azimuth_deg,
            .elevation_deg = view.elevation_deg,
            .distance_m = view.distance_m,
            .field_of_view_deg = like.field_of_view_deg};
}

Outcome<void> look_from(const Viewpoint& view, Scenario& scenario) {
    const sim::Grid& grid = scenario.grid;
    const auto dx = static_cast<double>(grid.dx);
    const double x = view.east / dx, y = view.north / dx;
    if (!(x >= 0 && y >= 0 && x <= grid.nx - 1 && y <= grid.ny - 1))
        return unusable(
            fmt::format("--camera: {:g} m east and {:g} m north is outside the terrain of {:g} by {:g} m",
                        view.east, view.north, (grid.nx - 1) * dx, (grid.ny - 1) * dx));
    const auto vertex = static_cast<std::size_t>(std::lround(y)) * static_cast<std::size_t>(grid.nx) +
                        static_cast<std::size_t>(std::lround(x));
    const double height = scenario.datum + static_cast<double>(scenario.bedrock[vertex]) +
                          static_cast<double>(scenario.depth[vertex]);
    scenario.camera = camera_of(view, height, scenario.camera.value_or(render::Camera{}));
    return {};
}

}  // namespace game
