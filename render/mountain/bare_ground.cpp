#include "render/mountain/bare_ground.h"

#include <algorithm>

namespace render {

const sim::Field<float>* BareGround::find(const sim::View& world) {
    if (!world.things) return nullptr;
    const sim::Things& things = *world.things;
    bool any = false;
    for (int y = 0; y < world.grid.ny && !any; ++y) {
        const float* built = things.built.row(y);
        any = std::any_of(built, built + world.grid.nx, [](float high) { return high != 0; });
    }
    if (!any) return nullptr;
    ground_ = world.bedrock;
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x)
            if (things.built(x, y) != 0)
                ground_(x, y) = static_cast<float>(static_cast<double>(things.natural(x, y)) +
                                                   static_cast<double>(things.earth(x, y)));
    return &ground_;
}

}  // namespace render
