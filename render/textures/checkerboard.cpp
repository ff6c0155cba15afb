#include <algorithm>

#include "render/base/noise.h"
#include "render/textures/surface.h"

namespace render {
namespace {

constexpr int kSquare = kTextureSize / 8;            // texels
constexpr float kWorn = 5;                           // width of the worn edge of a square, texels
constexpr glm::vec3 kLight{0.886f, 0.859f, 0.796f};  // ivory
constexpr glm::vec3 kDark{0.200f, 0.243f, 0.318f};   // slate

// Distance from the middle of a texel to the edge of its square, texels; at least 0.5.
float to_rim(int texel) {
    const int place = texel % kSquare;
    return static_cast<float>(std::min(place, kSquare - 1 - place)) + 0.5f;
}

}  // namespace

Surface make_checkerboard() {
    Surface surface;
    for (int y = 0; y < kTextureSize; ++y) {
        for (int x = 0; x < kTextureSize; ++x) {
            surface.heights.at(x, y) = ease(std::min(1.f, std::min(to_rim(x), to_rim(y)) / kWorn));
            surface.colours.push_back((x / kSquare + y / kSquare) % 2 == 0 ? kLight : kDark);
        }
    }
    return surface;
}

}  // namespace render
