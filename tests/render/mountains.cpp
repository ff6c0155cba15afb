#include "tests/render/mountains.h"

#include <cmath>
#include <vector>

namespace render::test {

Surroundings mountains_around(const World& world) {
    std::vector<float> bedrock, depth;
    std::vector<std::uint8_t> has_data;
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x) {
            bedrock.push_back(world.bedrock(x, y));
            depth.push_back(world.depth(x, y));
            has_data.push_back(world.site(x, y) != sim::Site::kDrain);
        }
    return {world.grid, bedrock, depth, has_data};
}

World make_strip(int columns, int rows) {
    World world;
    world.grid = {columns, rows, 5};
    for (auto* field : {&world.bedrock, &world.depth, &world.rolling, &world.velocity_x, &world.velocity_y})
        *field = sim::Field<float>(world.grid);
    world.site = sim::Field<sim::Site>(world.grid);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) world.bedrock(x, y) = static_cast<float>(20 * std::sin(y / 90.0));
    return world;
}

}  // namespace render::test
