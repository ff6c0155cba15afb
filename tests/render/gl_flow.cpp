#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include <glm/geometric.hpp>

#include "render/passes/flow_texture.h"
#include "sim/core/workers.h"
#include "tests/render/gl_scene.h"
#include "tests/render/watched.h"
#include "tests/support/allocations.h"

// Advected flow textures: on the right side of every front, lit by their relief, and nowhere else.
namespace render::test {
namespace {

using sim::front::FlowView;
using sim::front::PointSource;
using sim::front::TextureLayers;

constexpr int kSquares = 16;
constexpr float kCell = 0.5f;
constexpr double kSide = kSquares * static_cast<double>(kCell);  // m
constexpr int kPixels = 256;
constexpr int kChecks = 8;  // along an edge of the pattern's tile

class Flow : public Gl {
  protected:
    void SetUp() override {
        Gl::SetUp();
        for (const FlowPattern pattern : {FlowPattern::kCheckerboard, FlowPattern::kSnow}) {
            Look look;
            look.flow = FlowLook{pattern};
            const auto loaded = renderer_->load(look, false);
            ASSERT_TRUE(loaded) << loaded.error();
        }
    }

    // Everywhere, with one tile over the whole ground.
    static Look flowing(FlowPattern pattern = FlowPattern::kCheckerboard) {
        Look look = plain_look();
        look.flow = FlowLook{pattern, 1, true};
        return look;
    }

    // Straight down on the whole ground.
    Picture seen(const FlowView& of, const Look& look, const Light& light = {135, 60},
                 const Marks& marks = {}) {
        renderer_->draw({ground.view(), from_above({kSide / 2, kSide / 2, 0}, kSide), light, look, marks, &of,
                         kPixels, kPixels});
        return renderer_->read_back();
    }

    void run(FlowView& of, const std::function<glm::vec2(const glm::vec2&)>& velocity, int steps) {
        std::vector<glm::vec2> v;
        for (const glm::vec2& x : mesh.position) v.push_back(velocity(x));
        for (int i = 0; i < steps; ++i) of.advance({v, {}}, 1 / 60.0, workers);
    }

    // Arbitrary coordinates.
    void lay(FlowView& of, const std::function<glm::vec2(const glm::vec2&)>& coordinates) {
        TextureLayers::Memory memory = of.layers().memory();
        for (std::size_t v = 0; v < mesh.position.size(); ++v)
            memory.offset[v].fill(coordinates(mesh.position[v]) - mesh.position[v]);
        of.layers().restore(memory);
    }

    const World ground = make_world(kSquares, kCell, [](double, double) { return 0; });
    const sim::front::Mesh mesh = sim::front::mesh_of(ground.grid);
    sim::Workers workers{1};
    FlowView flow{mesh, sim::front::gradient_rule(0.1f, kCell), PointSource::kFit, {}};
};

double luminance(const Picture& picture, int x, int y) {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(x));
    return (picture.pixels[at] + picture.pixels[at + 1] + picture.pixels[at + 2]) / 3.0;
}

// Position of a pixel, from the top left, m.
glm::dvec2 place_of(int x, int y) {
    return {(x + 0.5) / kPixels * kSide, (kPixels - y - 0.5) / kPixels * kSide};
}

// Which of a checkerboard's colours a position has, and its distance to the other colour, in pixels.
struct Check {
    bool odd;
    double inside;
};
Check check_at(const glm::dvec2& coordinates) {
    const glm::dvec2 c = coordinates / (kSide / kChecks), from_edge = glm::abs(c - glm::round(c));
    return {((static_cast<int>(std::floor(c.x)) + static_cast<int>(std::floor(c.y))) & 1) != 0,
            std::min(from_edge.x, from_edge.y) * kPixels / kChecks};
}

// Share of pixels, well inside a check and away from the front at y = `front`, whose colour matches the
// coordinates.
template <class Coordinates>
double agreement(const Picture& picture, double front, const Coordinates& coordinates) {
    // The pattern defines which colour comes first.
    double agree = 0, all = 0;
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const glm::dvec2 at = place_of(x, y);
            const Check check = check_at(coordinates(at));
            if (check.inside < 5 || std::abs(at.y - front) / kSide * kPixels < 2) continue;
            agree += (luminance(picture, x, y) > 150) == check.odd, ++all;
        }
    return std::max(agree, all - agree) / all;
}

TEST_F(Flow, shows_the_advected_texture_on_either_side_of_a_front) {
    // Above the middle of an edge to the right; below it to the left, by a check and a half in two seconds.
    const double front = 8.5 * static_cast<double>(kCell), way = 1.5 * kSide / kChecks;
    const auto speed = static_cast<float>(way / 2);
    run(
        flow, [&](const glm::vec2& x) { return glm::vec2(x.y > front ? speed : -speed, 0); }, 120);
    const Picture picture = seen(flow, flowing());
    const auto carried = [&](const glm::dvec2& x) {
        return glm::dvec2(x.x + (x.y > front ? -way : way), x.y);
    };
    EXPECT_GT(agreement(picture, front, carried), 0.999);
    // One side shifted by a check: the measure must notice it.
    const auto swapped = [&](const glm::dvec2& x) {
        return carried(x) + glm::dvec2(x.y > front ? kSide / kChecks : 0, 0);
    };
    EXPECT_LT(agreement(picture, front, swapped), 0.7);
    // Without a cut the texture is stretched across the front.
    FlowView uncut(mesh, sim::front::gradient_rule(1e6f, kCell), PointSource::kFit, {});
    run(
        uncut, [&](const glm::vec2& x) { return glm::vec2(x.y > front ? speed : -speed, 0); }, 120);
    EXPECT_LT(agreement(seen(uncut, flowing()), front, carried), 0.99);
}

TEST_F(Flow, is_lit_by_the_relief_of_its_texture) {
    run(
        flow, [](const glm::vec2&) { return glm::vec2(0, 0); }, 1);
    const Picture upright = seen(flow, flowing(FlowPattern::kSnow), {30, 30});
    lay(flow, [](const glm::vec2& x) { return glm::vec2(kSide, kSide) - x; });
    const auto turned_back = [&](const Picture& picture) {
        Picture turned = picture;
        for (std::size_t p = 0; p < picture.pixels.size(); p += 3)
            std::copy_n(picture.pixels.end() - static_cast<std::ptrdiff_t>(p) - 3, 3,
                        turned.pixels.begin() + static_cast<std::ptrdiff_t>(p));
        return turned;
    };
    const auto apart = [](const Picture& a, const Picture& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
        return sum / static_cast<double>(a.pixels.size());
    };
    // With texture and sun rotated by half a turn, the image is the same, rotated, except that the camera is
    // not exactly vertical. With the sun where it was, the image differs.
    const double same = apart(turned_back(seen(flow, flowing(FlowPattern::kSnow), {210, 30})), upright);
    const double other = apart(turned_back(seen(flow, flowing(FlowPattern::kSnow), {30, 30})), upright);
    EXPECT_LT(same, 5);
    EXPECT_GT(other, 5 * same);
}

TEST_F(Flow, shows_its_stretch_in_the_colours_of_the_legend) {
    run(
        flow, [](const glm::vec2&) { return glm::vec2(0, 0); }, 1);
    Marks marks;
    marks.overlay = Overlay::kStretch;
    const auto stops = legend_of(Overlay::kStretch).stops;
    // Enlarged equally in all directions; twice as much along x; and rotated as well.
    const float c = std::cos(0.7f), s = std::sin(0.7f);
    const std::vector<std::pair<glm::mat2, std::size_t>> laid{
        {glm::mat2(3, 0, 0, 3), 0},
        {glm::mat2(2, 0, 0, 1), 3},
        {glm::mat2(c, s, -s, c) * glm::mat2(2, 0, 0, 1), 3}};
    for (const auto& [gradient, stop] : laid) {
        lay(flow, [&g = gradient](const glm::vec2& x) { return g * x; });
        const Colour got = mean_colour(seen(flow, flowing(), {180, 89}, marks), kPixels / 2, kPixels / 2, 20);
        // Light changes the brightness, so shares of red, green and blue are compared.
        const auto apart = [&](const LegendStop& other) {
            const glm::dvec3 a(got[0], got[1], got[2]), b(other.colour);
            return glm::distance(a / (a.x + a.y + a.z), b / (b.x + b.y + b.z));
        };
        const auto nearest = std::min_element(
            stops.begin(), stops.end(), [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
        EXPECT_EQ(nearest - stops.begin(), static_cast<std::ptrdiff_t>(stop));
        EXPECT_LT(apart(stops[stop]), 0.06);
    }
}

TEST_F(Flow, shows_its_mesh_and_its_points_where_they_are) {
    const double front = 8.5 * static_cast<double>(kCell);
    run(
        flow, [&](const glm::vec2& x) { return glm::vec2(x.y > front ? 1 : -1, 0); }, 2);
    const Picture bare = seen(flow, flowing());
    Marks marks;
    marks.flow_mesh = true;
    const Picture marked = seen(flow, flowing(), {135, 60}, marks);
    const auto changed = [&](int x, int y) {
        return std::abs(luminance(bare, x, y) - luminance(marked, x, y)) > 4;
    };
    for (const auto& point : flow.tracker().points()) {
        const glm::dvec2 at =
            glm::dvec2(flow.tracker().position(point)) / kSide * static_cast<double>(kPixels);
        const int x = static_cast<int>(at.x), y = kPixels - 1 - static_cast<int>(at.y);
        if (x < 2 || x > kPixels - 3) continue;
        bool any = false;
        for (const int dx : {-1, 0, 1})
            for (const int dy : {-1, 0, 1}) any = any || changed(x + dx, y + dy);
        EXPECT_TRUE(any) << x << ", " << y;
    }
    // Inside a triangle nothing is drawn.
    const int square = kPixels / kSquares;
    EXPECT_FALSE(changed(4 * square + square / 4 * 3, 3 * square + square * 5 / 8));
}

// A ridge from west to east, with the rolling layer only on its far side.
World ridge() {
    World world = make_world(48, 1, [](double, double y) { return y < 24 ? y : 48 - y; });
    world.depth.fill(1);
    for (int y = 30; y < 40; ++y)
        for (int x = 10; x < 38; ++x) world.rolling(x, y) = 1;
    return world;
}

TEST_F(Flow, is_hidden_by_hills_and_visible_only_within_its_layer) {
    const World world = ridge();
    const sim::front::Mesh its_mesh = sim::front::mesh_of(world.grid);
    FlowView its_flow(its_mesh, sim::front::gradient_rule(0.1f, 1), PointSource::kHalf, {});
    const std::vector<glm::vec2> still(its_mesh.position.size(), glm::vec2(0, 0));
    its_flow.advance({still, {}}, 1 / 60.0, workers);
    Look look = plain_look();
    look.roughness = 1;
    look.detail = 1;
    Camera from_south{{24, 24, 12}, 180, 10, 70, 35}, from_north{{24, 24, 12}, 0, 30, 70, 35};
    const auto drawn = [&](const Camera& camera, bool with) {
        look.flow.reset();
        if (with) look.flow = FlowLook{FlowPattern::kSnow, 9, false};
        renderer_->draw({world.view(), camera, {180, 40}, look, {}, &its_flow, 160, 90});
        return renderer_->read_back().pixels;
    };
    // Ground without slides may be drawn by a program of its own, which rounds differently; the edge of snow on rock is
    // steep in what it depends on.
    const auto hidden = drawn(from_south, true), none = drawn(from_south, false);
    for (std::size_t i = 0; i < hidden.size(); ++i)
        ASSERT_LE(std::abs(int{hidden[i]} - int{none[i]}), 4) << "byte " << i;
    const auto with = drawn(from_north, true), without = drawn(from_north, false);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < with.size(); i += 3)
        changed += !std::equal(with.begin() + static_cast<std::ptrdiff_t>(i),
                               with.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                               without.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_GT(changed, with.size() / 3 / 20);
    EXPECT_LT(changed, with.size() / 3 / 2);
}

TEST_F(Flow, that_came_to_rest_keeps_its_texture_as_deposit) {
    World world = make_world(kSquares, kCell, [](double, double) { return 0; });
    world.depth.fill(1);
    run(
        flow, [](const glm::vec2& x) { return glm::vec2(0, x.x > 4.1f ? 0.5f : 0); }, 90);
    run(
        flow, [](const glm::vec2&) { return glm::vec2(0, 0); }, 1);
    std::vector<float> rise;  // also where nothing moved
    for (const glm::vec2& x : mesh.position) rise.push_back(x.y > 1.9f && x.y < 6.1f ? 0.5f : 0);
    Look look = plain_look();
    look.roughness = look.detail = 1;
    look.flow = FlowLook{FlowPattern::kSnow, 1, false};
    const auto drawn = [&](bool known) {
        flow.set_rise(known ? std::span<const float>(rise) : std::span<const float>());
        renderer_->draw({world.view(),
                         from_above({kSide / 2, kSide / 2, 0}, kSide),
                         {135, 40},
                         look,
                         {},
                         &flow,
                         kPixels,
                         kPixels});
        return renderer_->read_back();
    };
    // Share of pixels of a part of the ground that have another colour.
    const auto changed = [](const Picture& a, const Picture& b, const auto& counts) {
        double differ = 0, all = 0;
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x) {
                if (!counts(place_of(x, y))) continue;
                differ += std::abs(luminance(a, x, y) - luminance(b, x, y)) > 3, ++all;
            }
        return differ / all;
    };
    const auto within = [](const glm::dvec2& x) { return x.x > 4.6 && x.y > 2.1 && x.y < 5.9; };
    const auto without = [](const glm::dvec2& x) { return x.x < 3.9 || x.y < 1.4 || x.y > 6.6; };
    const Picture plain = drawn(false), kept = drawn(true);
    EXPECT_GT(changed(plain, kept, within), 0.5);
    EXPECT_EQ(changed(plain, kept, without), 0);
    // It is the advected texture: with other coordinates the image differs.
    lay(flow, [](const glm::vec2& x) { return glm::vec2(x.x + (x.x > 4.1f ? 1.3f : 0), x.y); });
    EXPECT_GT(changed(kept, drawn(true), within), 0.3);
}

TEST_F(Flow, drawn_earlier_leaves_no_trace_in_a_frame) {
    run(
        flow, [](const glm::vec2& x) { return glm::vec2(x.y > 3.3f ? 1 : -1, 0); }, 60);
    const Picture first = seen(flow, flowing());
    FlowView other(mesh, sim::front::gradient_rule(0.1f, kCell), PointSource::kHalf, {});
    run(
        other, [](const glm::vec2& x) { return glm::vec2(0, x.x > 5.1f ? 1 : -1); }, 40);
    EXPECT_NE(seen(other, flowing(FlowPattern::kSnow)).pixels, first.pixels);
    EXPECT_TRUE(alike(seen(flow, flowing()), first));
}

TEST_F(Flow, draws_without_allocating_or_creating_objects) {
    const auto frame = [&](int i) {
        run(
            flow,
            [&](const glm::vec2& x) {
                return glm::vec2(x.y > 2 + 0.01f * static_cast<float>(i) ? 1 : -1, 0);
            },
            1);
        const std::int64_t before = support::allocations_of_all_threads();
        renderer_->draw({ground.view(),
                         from_above({kSide / 2, kSide / 2, 0}, kSide),
                         Light(),
                         flowing(),
                         {},
                         &flow,
                         64,
                         64});
        return support::allocations_of_all_threads() - before;
    };
    for (int i = 0; i < 60; ++i) frame(i);
    const Watched<&epoxy_glCreateTextures> textures;
    const Watched<&epoxy_glCreateFramebuffers> framebuffers;
    const Watched<&epoxy_glCreateBuffers> buffers;
    const Watched<&epoxy_glCreateVertexArrays> vertex_arrays;
    gl_objects = 0;
    std::int64_t allocations = 0;
    for (int i = 60; i < 70; ++i) allocations += frame(i);
    EXPECT_EQ(gl_objects, 0);
    EXPECT_EQ(allocations, 0);
}

TEST_F(Gl, names_the_missing_texture) {
    auto elsewhere = FlowTexture::load("/nowhere", FlowPattern::kStones);
    ASSERT_FALSE(elsewhere);
    EXPECT_NE(elsewhere.error().find("/nowhere/textures/stones.png"), std::string::npos) << elsewhere.error();
}

}  // namespace
}  // namespace render::test
