#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "assets/shaders/slots.glsl"
#include "render/flow/flow_triangles.h"
#include "render/frame/make_frame_block.h"
#include "render/gl/scoped_state.h"
#include "render/passes/fields_to_gpu.h"
#include "render/passes/flow_pass.h"
#include "render/passes/surface_pass.h"
#include "sim/core/workers.h"
#include "tests/render/gl_scene.h"
#include "tests/support/allocations.h"
#include "tests/support/places.h"

// A flow's picture from the triangles that may show it, against one from all triangles.
namespace render::test {
namespace {

using sim::front::FlowView;

constexpr int kWide = 37, kHigh = 29;    // vertices
constexpr int kAcross = 240, kUp = 180;  // pixels

// What is drawn of a flow: all texels of both of its textures.
struct Skin {
    std::vector<float> albedo, relief;

    bool operator==(const Skin& other) const {
        const auto same = [](const std::vector<float>& a, const std::vector<float>& b) {
            return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
        };
        return same(albedo, other.albedo) && same(relief, other.relief);
    }
    bool is_empty() const {
        return std::ranges::all_of(albedo, [](float value) { return value == 0; });
    }
};

std::vector<float> texels_of(GLuint unit) {
    GLint name = 0;
    glActiveTexture(GL_TEXTURE0 + unit);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
    glActiveTexture(GL_TEXTURE0);
    std::vector<float> texels(std::size_t{4} * kAcross * kUp);
    glGetTextureImage(static_cast<GLuint>(name), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * sizeof(float)), texels.data());
    return texels;
}

class FlowPicture : public Gl {
  protected:
    void SetUp() override {
        Gl::SetUp();
        const auto shaders = support::source_dir() / "assets" / "shaders";
        auto surface = SurfacePass::create(shaders);
        ASSERT_TRUE(surface) << surface.error();
        surface_ = std::move(*surface);
        auto flow = FlowPass::create(shaders);
        ASSERT_TRUE(flow) << flow.error();
        pass_.emplace(std::move(*flow));
        ASSERT_TRUE(pass_->load(support::source_dir() / "assets", FlowPattern::kSnow));
        block_ = make_storage(sizeof(FrameBlock));
        world_.grid = {kWide, kHigh, 2};
        for (sim::Field<float>* field :
             {&world_.bedrock, &world_.depth, &world_.rolling, &world_.velocity_x, &world_.velocity_y})
            *field = sim::Field<float>(world_.grid);
        world_.site = sim::Field<sim::Site>(world_.grid);
        for (int y = 0; y < kHigh; ++y)
            for (int x = 0; x < kWide; ++x) world_.bedrock(x, y) = 0.2f * static_cast<float>(y);
        world_.depth.fill(1);
        mesh_ = sim::front::mesh_of(world_.grid);
        flow_.emplace(mesh_, sim::front::gradient_rule(0.1f, 2), sim::front::PointSource::kFit,
                      sim::front::LayerRule{});
        velocity_.resize(mesh_.position.size());
        rise_.resize(mesh_.position.size());
        flow_->set_rise(rise_);
        look_ = plain_look();
        look_.flow = FlowLook{FlowPattern::kSnow, 9, false};
    }

    void TearDown() override {
        glUseProgram(0);  // otherwise a frame would restore a program of this test
    }

    void send() {
        FrameInput input{.world = world_.view(),
                         .camera = {{36, 28, 4}, 200, 40, 90, 40},
                         .look = look_,
                         .flow = &*flow_,
                         .width = kAcross,
                         .height = kUp,
                         .first_depth = first_depth_};
        if (fields_.upload_ground(world_.view(), first_depth_, {}).terrain) surface_.resize(world_.grid);
        changed_.compare(world_.view(), {}, first_depth_, std::nullopt, RedrawRules(), true);
        fields_.upload_layers(world_.view(), 0, kHigh - 1);
        const FrameBlock frame = make_frame_block(input, fields_.heights(), 1, glm::vec3(1));
        glNamedBufferSubData(block_.name(), 0, sizeof frame, &frame);
        glBindBufferBase(GL_UNIFORM_BUFFER, SLOT_FRAME, block_.name());
        fields_.bind();
        pass_->send(*flow_);
        pass_->cut(*flow_, world_.grid);
        surface_.survey_terrain({0, 0}, {world_.grid.nx - 1, world_.grid.ny - 1});
        surface_.run(changed_.groups());
        surface_.bind();
        target_.resize(kAcross, kUp, 1);
        screen_ = OnScreen(frame.clip_from_world, kAcross, kUp);
    }

    Skin drawn(std::span<const TriangleRun> triangles) {
        const Rectangle all = target_.all();
        target_.begin_scene({&all, 1});
        pass_->find(triangles, changed_, screen_);
        pass_->draw(look_, Overlay::kNone, target_, {&all, 1});
        return {texels_of(SLOT_SKIN_ALBEDO), texels_of(SLOT_SKIN_RELIEF)};
    }

    int below(int count) { return static_cast<int>(dice_() % static_cast<unsigned>(count)); }

    // Does something to a rectangle of vertices.
    template <class Change>
    void in_rectangle(const Change& change) {
        const int x0 = below(kWide), y0 = below(kHigh), x1 = x0 + below(8), y1 = y0 + below(6);
        for (int y = y0; y < std::min(y1, kHigh); ++y)
            for (int x = x0; x < std::min(x1, kWide); ++x) change(x, y);
    }
    void do_something() {
        const glm::vec2 way(static_cast<float>(below(5) - 2), static_cast<float>(below(5) - 2));
        const float some[] = {0, look_.rolling_visible_m, 0.02f, 0.06f, 0.4f};
        const float depth = some[below(5)], rise = 0.0005f * static_cast<float>(below(9));
        switch (below(5)) {
            case 0:
                in_rectangle([&](int x, int y) { world_.rolling(x, y) = depth; });
                break;
            case 1:
                in_rectangle([&](int x, int y) { world_.depth(x, y) = 1 + rise; });
                break;
            case 2:
                in_rectangle([&](int x, int y) { rise_[y * kWide + x] = rise; });
                break;
            default:
                in_rectangle([&](int x, int y) { velocity_[y * kWide + x] = way; });
                break;
        }
    }

    World world_;
    sim::front::Mesh mesh_;
    std::optional<FlowView> flow_;
    std::vector<glm::vec2> velocity_;
    std::vector<float> rise_, first_depth_;
    Look look_;
    sim::Workers workers_{1};
    std::mt19937 dice_{11};

    FieldsToGpu fields_;
    Buffer block_;
    SurfacePass surface_;
    std::optional<FlowPass> pass_;
    Target target_;
    WhatChanged changed_;
    OnScreen screen_;
    FlowTriangles triangles_;
};

TEST_F(FlowPicture, of_the_triangles_that_may_show_it_equals_that_of_all) {
    const std::vector<TriangleRun> all{{0, 2 * (kWide - 1) * (kHigh - 1)}};
    const ScopedState state;
    int visible = 0, fewer = 0;
    for (int round = 0; round < 120; ++round) {
        if (round == 40) first_depth_.assign(world_.grid.size(), 1.f);
        look_.flow->everywhere = round % 30 == 29;
        for (int i = 0; i < 3; ++i) do_something();
        flow_->advance({velocity_, {}}, 1 / 60.0, workers_);
        send();
        const std::vector<std::uint8_t> before(triangles_.shown().begin(), triangles_.shown().end());
        triangles_.find(world_.view(), first_depth_, pass_->coordinates().vertices(), look_);
        ASSERT_TRUE(round == 0 || std::ranges::equal(triangles_.shown_before(), before));
        const Skin whole = drawn(all);
        ASSERT_EQ(drawn(triangles_.runs()), whole) << "round " << round;
        visible += !whole.is_empty();
        fewer += triangles_.runs().size() != 1 ||
                 triangles_.runs()[0].last - triangles_.runs()[0].first < all[0].last;
    }
    EXPECT_GT(visible, 80);
    EXPECT_GT(fewer, 60);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

// The same without joining runs over gaps: what is not shown may be left out.
TEST_F(FlowPicture, needs_no_triangle_that_is_not_shown) {
    const std::vector<TriangleRun> all{{0, 2 * (kWide - 1) * (kHigh - 1)}};
    const ScopedState state;
    first_depth_.assign(world_.grid.size(), 1.f);
    std::vector<TriangleRun> exact, one_missing;
    int differ = 0;
    for (int round = 0; round < 60; ++round) {
        for (int i = 0; i < 3; ++i) do_something();
        flow_->advance({velocity_, {}}, 1 / 60.0, workers_);
        send();
        triangles_.find(world_.view(), first_depth_, pass_->coordinates().vertices(), look_);
        exact.clear();
        for (int t = 0; t < all[0].last; ++t)
            if ((triangles_.shown()[static_cast<std::size_t>(t / 2)] & (t % 2 == 0 ? 1 : 2)) != 0)
                exact.push_back({t, t + 1});
        const Skin whole = drawn(all);
        ASSERT_EQ(drawn(exact), whole) << "round " << round;
        if (exact.empty()) continue;
        one_missing = exact;
        one_missing.erase(one_missing.begin() + below(static_cast<int>(exact.size())));
        differ += !(drawn(one_missing) == whole);
    }
    EXPECT_GT(differ, 20) << "the comparison sees a triangle that is missing";
}

TEST_F(FlowPicture, has_two_triangles_per_square_in_the_order_of_the_mesh) {
    for (int y = 0; y + 1 < kHigh; ++y)
        for (int x = 0; x + 1 < kWide; ++x) {
            const int t = 2 * (y * (kWide - 1) + x), v = y * kWide + x;
            EXPECT_EQ(mesh_.triangle[t], (std::array{v, v + 1, v + kWide + 1}));
            EXPECT_EQ(mesh_.triangle[t + 1], (std::array{v, v + kWide + 1, v + kWide}));
        }
}

TEST_F(FlowPicture, finds_its_triangles_without_allocating) {
    send();
    triangles_.find(world_.view(), first_depth_, pass_->coordinates().vertices(), look_);
    for (int round = 0; round < 30; ++round) {
        do_something();
        const std::int64_t before = support::allocations();
        look_.flow->everywhere = round % 9 == 8;
        triangles_.find(world_.view(), first_depth_, pass_->coordinates().vertices(), look_);
        EXPECT_EQ(support::allocations(), before);
    }
}

}  // namespace
}  // namespace render::test
