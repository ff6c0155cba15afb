#pragma once

#include <array>
#include <optional>

#include <gtest/gtest.h>

#include "render/frame.h"
#include "tests/render/world.h"

// Shared by the rendering tests.
namespace render::test {

using Colour = std::array<double, 3>;  // sRGB, 0 to 255

// Mean over a square of pixels; x from the left, y from the top.
Colour mean_colour(const Picture& picture, int x, int y, int half);

// Pixels whose red differs by more than 3 of 255 between two images of one size.
int differing(const Picture& a, const Picture& b);

// Whether no channel differs by more than `most` of 255 between two images; else says how many pixels do, and where.
testing::AssertionResult alike(const Picture& a, const Picture& b, int most = 0);

// CIE L*a*b* distance; 2.3 is just noticeable to most people, 10 is obvious.
double colour_distance(const Colour& a, const Colour& b);

// The colour as seen by a person without one of the cones (Machado, Oliveira and Fernandes 2009, severity 1).
enum class Cone { kLong, kMiddle, kShort };
inline constexpr std::array kCones{Cone::kLong, Cone::kMiddle, Cone::kShort};
Colour without(Cone cone, const Colour& colour);

Look plain_look();  // grey standing layer, no small-scale relief, so that a colour can be computed by hand

// A GL context for all tests of a program, and a renderer for each.
class Gl : public testing::Test {
  protected:
    void SetUp() override;

    static const HeadlessContext& context();

    // By how much of 255 two shaders may round what is the same otherwise: 0 on the processor, 1 on a GPU.
    static int rounding();

    Picture draw(const World& world, const Camera& camera, const Light& light, const Look& look,
                 int width = 96, int height = 96, const Marks& marks = {});

    std::optional<Renderer> renderer_;
};

}  // namespace render::test
