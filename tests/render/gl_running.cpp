#include <cmath>

#include "render/mountain/overview.h"
#include "tests/render/gl_scene.h"
#include "tests/render/watched.h"
#include "tests/support/allocations.h"
#include "tests/support/places.h"
#include "tests/support/renderer.h"

// Successive frames, as a window draws them.
namespace render::test {
namespace {

World covered_hill() {
    World world = make_world(48, 5, [](double x, double y) { return 0.4 * y + 12 * std::sin(x / 30); });
    world.depth.fill(0.7f);
    return world;
}

Marks all_marks(Overlay overlay) {
    Marks marks;
    marks.overlay = overlay;
    marks.contours = true;
    marks.ring = Ring{{120, 120}, 30, {1, 1, 1}};
    return marks;
}

TEST_F(Gl, allocates_nothing_and_creates_no_object_in_later_frames) {
    World world = covered_hill();
    Camera camera = overview(world.view());
    const auto frame = [&](int i) {
        world.rolling(20 + i, 20) = 1;  // the simulation continues
        camera.azimuth_deg += 1;
        const Marks marks = i % 3 == 0 ? Marks() : all_marks(i % 3 == 1 ? Overlay::kNone : Overlay::kSpeed);
        renderer_->draw({world.view(), camera, Light(), Look(), marks, nullptr, 160, 90});
        glFinish();
    };
    for (int i = 0; i < 6; ++i) frame(i);
    const Watched<&epoxy_glCreateTextures> textures;
    const Watched<&epoxy_glCreateFramebuffers> framebuffers;
    const Watched<&epoxy_glCreateBuffers> buffers;
    const Watched<&epoxy_glCreateVertexArrays> vertex_arrays;
    gl_objects = 0;
    const std::int64_t before = support::allocations_of_all_threads();
    for (int i = 6; i < 12; ++i) frame(i);
    EXPECT_EQ(support::allocations_of_all_threads(), before);
    EXPECT_EQ(gl_objects, 0);

    // The same counters detect a frame of another size, and a plain allocation.
    renderer_->draw({world.view(), camera, Light(), Look(), {}, nullptr, 100, 60});
    EXPECT_GE(gl_objects, 4);
    const std::int64_t after = support::allocations_of_all_threads();
    operator delete(operator new(8));  // the compiler may omit a new expression
    EXPECT_EQ(support::allocations_of_all_threads(), after + 1);
}

TEST_F(Gl, changes_its_quality_between_frames) {
    const World world = covered_hill();
    const Camera camera = overview(world.view());
    std::optional<Renderer> fine;
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(fine, Quality::kFine));
    fine->draw({world.view(), camera, Light(), Look(), {}, nullptr, 160, 90});

    const Picture fast = draw(world, camera, Light(), Look(), 160, 90);
    renderer_->set_quality(Quality::kFine);
    EXPECT_TRUE(alike(renderer_->read_back(), fast));  // of the frame drawn last
    EXPECT_TRUE(alike(draw(world, camera, Light(), Look(), 160, 90), fine->read_back()));
    renderer_->set_quality(Quality::kFast);
    EXPECT_TRUE(alike(draw(world, camera, Light(), Look(), 160, 90), fast));
}

// Its ground is shaded for every second sample along x and y: smooth ground looks the same, and edges and marks are as fine.
TEST_F(Gl, draws_a_moving_frame_like_one_that_stands_still_on_smooth_ground) {
    const World world = covered_hill();
    const Camera camera = overview(world.view());
    Marks marks;
    marks.ring = Ring{{120, 120}, 30, {1, 0, 0}};
    for (const auto& [width, height] : {std::pair{160, 90}, {161, 91}, {1, 1}, {2, 77}}) {
        for (const Marks& drawn : {Marks(), marks}) {
            renderer_->set_quality(Quality::kFast);
            const Picture still = draw(world, camera, Light(), plain_look(), width, height, drawn);
            renderer_->set_quality(Quality::kMoving);
            const Picture moving = draw(world, camera, Light(), plain_look(), width, height, drawn);
            EXPECT_LE(differing(still, moving), width * height / 100 + 2) << width << " by " << height;
            EXPECT_TRUE(alike(draw(world, camera, Light(), plain_look(), width, height, drawn), moving));
            renderer_->set_quality(Quality::kFast);
            EXPECT_TRUE(alike(draw(world, camera, Light(), plain_look(), width, height, drawn), still));
        }
    }
}

TEST_F(Gl, names_the_renderer_of_any_current_context) {
    const std::string name = renderer_name();
    EXPECT_EQ(name, context().renderer_name());
    EXPECT_NE(name.find(reinterpret_cast<const char*>(glGetString(GL_RENDERER))), std::string::npos);
    const bool known = name.find("llvmpipe") == 0 || name.find("softpipe") == 0;
    EXPECT_EQ(is_software_renderer(), known) << name;
}

}  // namespace
}  // namespace render::test
