#include <cmath>
#include <cstring>
#include <numeric>

#include <epoxy/gl.h>

#include "render/mountain/overview.h"
#include "tests/render/gl_scene.h"
#include "tests/support/places.h"
#include "tests/support/renderer.h"

namespace render::test {
namespace {

World hill() {
    World world = make_world(
        48, 5, [](double x, double y) { return 0.4 * y + 12 * std::sin(x / 30) * std::cos(y / 40); });
    world.datum = 1200;
    for (int y = 0; y <= 48; ++y) {
        for (int x = 0; x <= 48; ++x) {
            world.depth(x, y) = y > 20 ? 0.7f : 0;
            if (std::hypot(x - 24, y - 24) < 8) world.rolling(x, y) = 1.5f, world.velocity_y(x, y) = -6;
        }
    }
    return world;
}

template <class T>
bool same_bits(const sim::Field<T>& a, const sim::Field<T>& b) {
    const auto size = sizeof(T) * static_cast<std::size_t>(a.nx() + 2);  // with halo
    for (int y = -1; y <= a.ny(); ++y)
        if (std::memcmp(a.row(y) - 1, b.row(y) - 1, size) != 0) return false;
    return true;
}

TEST_F(Gl, draws_the_same_pixels_again_after_any_other_frame) {
    const World world = hill(), other = make_world(20, 9, [](double x, double) { return x; });
    const Picture first = draw(world, overview(world.view()), Light(), Look(), 200, 120);
    draw(other, overview(other.view()), {20, 60}, plain_look(), 64, 64);
    const Picture again = draw(world, overview(world.view()), Light(), Look(), 200, 120);
    EXPECT_EQ(first.width, 200);
    EXPECT_EQ(first.pixels.size(), 200u * 120 * 3);
    EXPECT_TRUE(alike(first, again));
}

TEST_F(Gl, detects_new_bedrock_at_the_address_of_the_old) {
    World world = hill();
    const Camera camera = overview(world.view());
    const Picture before = draw(world, camera, Light(), Look());
    for (int x = 10; x < 20; ++x) world.bedrock(x, 10) += 30;
    const Picture after = draw(world, camera, Light(), Look());
    SetUp();  // a renderer that has not seen the old bedrock
    EXPECT_NE(before.pixels, after.pixels);
    EXPECT_TRUE(alike(draw(world, camera, Light(), Look()), after));
}

TEST_F(Gl, leaves_the_fields_bit_identical) {
    const World world = hill(), copy = world;
    draw(world, overview(world.view()), Light(), Look());
    EXPECT_TRUE(same_bits(world.bedrock, copy.bedrock));
    EXPECT_TRUE(same_bits(world.depth, copy.depth));
    EXPECT_TRUE(same_bits(world.rolling, copy.rolling));
    EXPECT_TRUE(same_bits(world.velocity_x, copy.velocity_x));
    EXPECT_TRUE(same_bits(world.velocity_y, copy.velocity_y));
    EXPECT_TRUE(same_bits(world.site, copy.site));
}

TEST_F(Gl, shows_sky_over_no_data) {
    World holed = hill(), nothing = hill();
    nothing.site.fill(sim::Site::kDrain);
    for (int y = 10; y < 38; ++y) {
        for (int x = 10; x < 38; ++x) holed.site(x, y) = sim::Site::kDrain;
    }
    const Camera camera = from_above({120, 120, 1250}, 250);
    const Picture sky = draw(nothing, camera, Light(), Look());
    const Picture seen = draw(holed, camera, Light(), Look());
    EXPECT_EQ(mean_colour(seen, 48, 48, 4), mean_colour(sky, 48, 48, 4));
    EXPECT_NE(mean_colour(seen, 10, 48, 4), mean_colour(sky, 10, 48, 4));
}

TEST_F(Gl, puts_the_top_row_first_and_north_up) {
    World world = make_world(40, 4, [](double, double) { return 0; });
    for (int x = 0; x <= 40; ++x) {
        for (int y = 30; y <= 40; ++y) world.depth(x, y) = 1;  // bright in the north
    }
    const Picture p = draw(world, from_above({80, 80, 0}, 150), Light(), Look());
    EXPECT_GT(mean_colour(p, 48, 12, 3)[1], mean_colour(p, 48, 84, 3)[1] + 40);
}

TEST_F(Gl, restores_the_state_of_gl) {
    glViewport(3, 4, 50, 60);
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glDepthFunc(GL_LEQUAL);
    const World world = hill();
    draw(world, overview(world.view()), Light(), Look());
    GLint viewport[4], depth_function = 0, origin = 0, program = 1, framebuffer = 1, colour_mask[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_DEPTH_FUNC, &depth_function);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &origin);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_COLOR_WRITEMASK, colour_mask);
    EXPECT_EQ(std::vector<GLint>(viewport, viewport + 4), (std::vector<GLint>{3, 4, 50, 60}));
    EXPECT_EQ(depth_function, GL_LEQUAL);
    EXPECT_EQ(origin, GL_NEGATIVE_ONE_TO_ONE);
    EXPECT_EQ(program, 0);
    EXPECT_EQ(framebuffer, 0);
    EXPECT_EQ(std::vector<GLint>(colour_mask, colour_mask + 4), std::vector<GLint>(4, 1));
    EXPECT_TRUE(glIsEnabled(GL_SCISSOR_TEST) && glIsEnabled(GL_BLEND));
    EXPECT_FALSE(glIsEnabled(GL_DEPTH_TEST) || glIsEnabled(GL_CULL_FACE) || glIsEnabled(GL_FRAMEBUFFER_SRGB));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
}

// A square of ground from above, turned so that its edges are slanted: it fills the middle, the sky the corners.
Picture slanted_square(Renderer& renderer) {
    const World world = make_world(24, 5, [](double, double) { return 0; });
    Camera camera = from_above({60, 60, 0}, 240);
    camera.azimuth_deg += 20;
    renderer.draw({world.view(), camera, Light(), plain_look(), {}, nullptr, 120, 120});
    return renderer.read_back();
}

// Of each row, the pixels whose green is well between those of the corner and the middle of the image.
std::vector<int> between_of_rows(const Picture& picture) {
    const double sky = mean_colour(picture, 3, 3, 2)[1], ground = mean_colour(picture, 60, 60, 2)[1];
    EXPECT_GT(std::abs(ground - sky), 30);
    std::vector<int> between(static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double share = (mean_colour(picture, x, y, 0)[1] - sky) / (ground - sky);
            between[static_cast<std::size_t>(y)] += share > 0.2 && share < 0.8;
        }
    }
    return between;
}

TEST_F(Gl, smooths_slanted_edges_with_one_sample_per_pixel) {
    const std::vector<int> between = between_of_rows(slanted_square(*renderer_));
    const int all = std::accumulate(between.begin(), between.end(), 0);
    EXPECT_GE(all, 60);
    EXPECT_LE(all, 400);  // only a pixel or two on each side of the edge
    EXPECT_EQ(between[3], 0);
    const auto middle = between[60];
    EXPECT_LE(middle, 4);
}

TEST_F(Gl, leaves_the_stencil_test_as_it_was) {
    draw(hill(), overview(hill().view()), Light(), Look());
    GLint function = 0, reference = 1, pass = 0;
    glGetIntegerv(GL_STENCIL_FUNC, &function);
    glGetIntegerv(GL_STENCIL_REF, &reference);
    glGetIntegerv(GL_STENCIL_PASS_DEPTH_PASS, &pass);
    EXPECT_EQ(function, GL_ALWAYS);
    EXPECT_EQ(reference, 0);
    EXPECT_EQ(pass, GL_KEEP);
    EXPECT_FALSE(glIsEnabled(GL_STENCIL_TEST));
}

TEST_F(Gl, differs_between_fine_and_fast_quality_only_at_edges) {
    const World world = hill();
    const Picture fast = draw(world, overview(world.view()), Light(), plain_look(), 160, 90);
    std::optional<Renderer> fine_renderer;
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(fine_renderer, Quality::kFine));
    fine_renderer->draw({world.view(), overview(world.view()), Light(), plain_look(), {}, nullptr, 160, 90});
    const Picture fine = fine_renderer->read_back();
    double sum = 0;
    for (std::size_t i = 0; i < fast.pixels.size(); ++i) sum += std::abs(fast.pixels[i] - fine.pixels[i]);
    EXPECT_LT(sum / static_cast<double>(fast.pixels.size()), 2);
    EXPECT_NE(fast.pixels, fine.pixels);
}

}  // namespace
}  // namespace render::test
