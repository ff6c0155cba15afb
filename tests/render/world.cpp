#include "tests/render/world.h"

#include <cmath>

namespace render::test {

World make_world(int squares, float cell, const std::function<double(double x, double y)>& bedrock) {
    World world;
    world.grid = {squares + 1, squares + 1, cell};
    world.bedrock = world.depth = world.rolling = world.velocity_x = world.velocity_y =
        sim::Field<float>(world.grid);
    world.site = sim::Field<sim::Site>(world.grid);
    for (int y = 0; y <= squares; ++y) {
        for (int x = 0; x <= squares; ++x)
            world.bedrock(x, y) =
                static_cast<float>(bedrock(x * static_cast<double>(cell), y * static_cast<double>(cell)));
    }
    return world;
}

Camera from_above(glm::dvec3 target, double height) {
    Camera camera;
    camera.target = target;
    camera.azimuth_deg = 180;
    camera.elevation_deg = 89;
    camera.field_of_view_deg = 10;
    camera.distance_m = height / 2 / std::tan(5 * 3.14159265358979 / 180);
    return camera;
}

}  // namespace render::test
