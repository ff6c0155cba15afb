#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <random>

#include <glm/geometric.hpp>

#include "sim/core/workers.h"
#include "sim/fields/texture_score.h"
#include "sim/front/flow_view.h"

// Advected textures: they move with the flow, on either side of a front, without stretch.

namespace {

using sim::fields::Cutting;
using sim::fields::score_texture;
using sim::fields::TestFlow;
using sim::fields::TextureScore;
using sim::fields::TextureTrial;
using sim::front::LayerRule;
using sim::front::Mesh;
using sim::front::mesh_of;
using sim::front::PointSource;
using sim::front::Rule;
using sim::front::TextureLayers;
using sim::front::Tracker;

Mesh mesh_of_squares(int squares) {
    return mesh_of(sim::Grid{squares + 1, squares + 1, 1.f / static_cast<float>(squares)});
}

Rule rule_of_squares(int squares) {
    return sim::front::gradient_rule(0.05f, 1.f / static_cast<float>(squares));
}

// The paper's fronts, with an added smooth field that stretches textures as any flow does.
struct Case {
    const char* name;
    TestFlow flow;
    int squares;
};
const TestFlow with_smooth(TestFlow flow) {
    flow.smooth = 0.03;
    return flow;
}

class TextureOf : public testing::TestWithParam<Case> {
  protected:
    TextureScore score(Cutting cutting, const TextureTrial& trial = {}) const {
        const Case& scene = GetParam();
        return score_texture(mesh_of_squares(scene.squares), rule_of_squares(scene.squares),
                             PointSource::kFit, scene.flow, cutting, trial);
    }
};

TEST_P(TextureOf, is_no_more_distorted_than_without_a_front_and_moves) {
    const TextureScore without = score(Cutting::kNone, {.smooth_alone = true});
    const TextureScore with = score(Cutting::kReseeded);
    EXPECT_LE(with.stretch_p95, 1.1 * without.stretch_p95);
    EXPECT_LE(with.stretched, 0.001);
    EXPECT_LE(with.slip, 0.05);
    EXPECT_LE(with.slip_near, 0.10);
    EXPECT_LE(with.drift_p95, 0.25);  // cells in two seconds
    // Negative controls: no cuts, cuts without reseeding, and coordinates that stand still.
    EXPECT_GT(score(Cutting::kNone).stretch_p95, 5 * with.stretch_p95);
    EXPECT_GT(score(Cutting::kToLetter).stretch_p95, 5 * with.stretch_p95);
    const TextureScore frozen = score(Cutting::kReseeded, {.frozen = true});
    EXPECT_NEAR(frozen.slip, 1, 1e-6);
    EXPECT_NEAR(frozen.slip_near, 1, 1e-6);
    EXPECT_EQ(frozen.stretch_p95 > 1.01, false);
}

INSTANTIATE_TEST_SUITE_P(
    OfThePaper, TextureOf,
    testing::Values(Case{"line_at_30_degrees_coarse", with_smooth(sim::fields::swinging(30)), 10},
                    Case{"line_at_30_degrees", with_smooth(sim::fields::swinging(30)), 20},
                    Case{"line_at_45_degrees_coarse", with_smooth(sim::fields::swinging(45)), 10},
                    Case{"line_at_45_degrees", with_smooth(sim::fields::swinging(45)), 20},
                    Case{"pinwheel_coarse", with_smooth(sim::fields::pinwheel()), 10},
                    Case{"pinwheel", with_smooth(sim::fields::pinwheel()), 20},
                    Case{"pinwheel_fine", with_smooth(sim::fields::pinwheel()), 40},
                    Case{"disc_coarse", with_smooth(sim::fields::disc()), 10},
                    Case{"disc", with_smooth(sim::fields::disc()), 20},
                    Case{"disc_fine", with_smooth(sim::fields::disc()), 40}),
    [](const auto& test) { return std::string(test.param.name); });

// A mesh, a tracker and textures, moved by given velocities.
class Textures : public testing::Test {
  protected:
    static constexpr int kSquares = 16;
    using Velocity = std::function<glm::vec2(const glm::dvec2&, double)>;

    explicit Textures(Mesh given = mesh_of_squares(kSquares), const LayerRule& rule = {})
        : mesh(std::move(given)), layers(mesh, rule) {}

    void run(const Velocity& velocity, int steps, double steps_per_second = 60) {
        std::vector<glm::vec2> v(mesh.position.size());
        for (int i = 0; i < steps; ++i) {
            time += 1 / steps_per_second;
            for (std::size_t k = 0; k < v.size(); ++k) v[k] = velocity(glm::dvec2(mesh.position[k]), time);
            tracker.advance({v, {}}, 1 / steps_per_second, workers);
            layers.advance(tracker, v, 1 / steps_per_second, workers);
        }
    }
    bool same_as(const TextureLayers& other) const {
        const auto same = [](const auto& a, const auto& b) {
            return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
        };
        return same(layers.offsets(), other.offsets()) && same(layers.mix(), other.mix()) &&
               same(layers.gradients(), other.gradients());
    }

    Mesh mesh;
    sim::Workers workers{1};
    Tracker tracker{mesh, rule_of_squares(kSquares), PointSource::kFit};
    TextureLayers layers;
    double time = 0;
};

TEST_F(Textures, at_rest_are_bit_identical) {
    // The right half flows, the left never does. The front stands still while layers are renewed and phases
    // fade.
    run([](const glm::dvec2& x, double) { return x.x > 0.52 ? glm::vec2(0.02f, 0.2f) : glm::vec2(0, 0); },
        600);
    int rests = 0, moved = 0;
    for (int v = 0; v < mesh.vertices(); ++v) {
        const bool rest = mesh.position[v].x < 0.52f;
        for (const glm::vec2& o : layers.offsets()[v]) {
            if (rest)
                EXPECT_EQ(o, glm::vec2(0, 0));
            else
                moved += glm::length(o) > 0.01f;
        }
        if (rest) {
            ++rests;
            EXPECT_EQ(layers.weight(v, TextureLayers::kSheets - 2), 1);
        }
    }
    EXPECT_GT(rests, 100);
    EXPECT_GT(moved, 100);
}

TEST_F(Textures, do_not_change_after_coming_to_rest) {
    const auto burst = [](const glm::dvec2& x, double t) {
        return t < 1.3 ? glm::vec2(0.2 * x.y, -0.1) : glm::vec2(0, 0);
    };
    run(burst, 80);
    const std::vector<TextureLayers::Offsets> then(layers.offsets().begin(), layers.offsets().end());
    run(burst, 600);
    EXPECT_EQ(std::memcmp(then.data(), layers.offsets().data(), layers.offsets().size_bytes()), 0);
}

// A flow that comes to rest from its right end on, like a heap that grows up the slope.
glm::vec2 halting(const glm::dvec2& x, double t) {
    return x.x < 0.9 - 0.3 * t ? glm::vec2(0.2f, 0) : glm::vec2(0, 0);
}

TEST_F(Textures, of_a_growing_deposit_are_not_stretched_and_stay) {
    run(halting, 110);
    const std::vector<TextureLayers::Offsets> then(layers.offsets().begin(), layers.offsets().end());
    run(halting, 90);
    int lying = 0;
    for (int v = 0; v < mesh.vertices(); ++v) {
        const float x = mesh.position[v].x;
        if (x > 0.9f) {
            EXPECT_FALSE(layers.has_moved(v));
            continue;
        }
        EXPECT_TRUE(layers.has_moved(v));
        if (x < 0.4f || x > 0.8f) continue;
        ++lying;
        EXPECT_EQ(then[v], layers.offsets()[v]);
        // Without help, a vertex would have moved farther the later it stopped: by two thirds of a cell per
        // cell.
        EXPECT_LT(glm::length(layers.offsets()[v][0] - layers.offsets()[v - 1][0]), 0.1f / kSquares);
    }
    EXPECT_GT(lying, 80);
}

TEST_F(Textures, continue_from_a_memory_bit_identically_while_flow_comes_to_rest) {
    run(halting, 60);
    TextureLayers other(mesh, {});
    other.restore(layers.memory());
    std::vector<glm::vec2> v(mesh.position.size());
    for (int i = 0; i < 60; ++i) {
        run(halting, 1);
        for (std::size_t k = 0; k < v.size(); ++k) v[k] = halting(glm::dvec2(mesh.position[k]), time);
        other.advance(tracker, v, 1 / 60.0, workers);
        ASSERT_TRUE(same_as(other)) << i;
    }
}

TEST_F(Textures, stay_on_deposits_but_not_on_added_material) {
    sim::front::FlowView view(mesh, rule_of_squares(kSquares), PointSource::kHalf, {});
    std::vector<glm::vec2> v(mesh.position.size(), glm::vec2(0, 0));
    for (std::size_t k = 0; k < v.size(); ++k)
        if (mesh.position[k].x > 0.52f) v[k] = {0, 0.2f};
    for (int i = 0; i < 30; ++i) view.advance({v, {}}, 1 / 60.0, workers);
    EXPECT_EQ(view.deposit(mesh.vertices() - 1), 0);  // no deposit is known
    std::vector<float> rise(v.size());
    for (std::size_t k = 0; k < v.size(); ++k) rise[k] = mesh.position[k].y > 0.52f ? 0.5f : -0.5f;
    view.set_rise(rise);
    for (int k = 0; k < mesh.vertices(); ++k)
        EXPECT_EQ(view.deposit(k), mesh.position[k].x > 0.52f && mesh.position[k].y > 0.52f ? 0.5f : 0);
}

TEST_F(Textures, of_a_rigid_motion_are_renewed_invisibly) {
    run([](const glm::dvec2&, double) { return glm::vec2(0.1f, -0.05f); }, 600);
    for (const auto& offset : layers.offsets())
        for (const glm::vec2& o : offset) {
            EXPECT_NEAR(o.x, -1.f, 1e-4f);
            EXPECT_NEAR(o.y, 0.5f, 1e-4f);
        }
}

TEST_F(Textures, of_each_side_are_advected_with_it) {
    // Two halves slide past each other, far enough for many renewals.
    run([](const glm::dvec2& x, double) { return glm::vec2(x.y > 0.47 ? 0.3f : -0.1f, 0); }, 600);
    for (int v = 0; v < mesh.vertices(); ++v)
        for (const glm::vec2& o : layers.offsets()[v]) {
            EXPECT_NEAR(o.x, mesh.position[v].y > 0.47f ? -3.f : 1.f, 1e-3f);
            EXPECT_NEAR(o.y, 0, 1e-3f);
        }
    // The gradients beside the cut extend the coordinates up to it.
    int copies = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangle.size()); ++t)
        for (const auto& part : cut_triangle(tracker, t))
            for (const auto& vertex : part) {
                copies += vertex.on_front;
                for (int s = 0; s < TextureLayers::kSheets; ++s)
                    EXPECT_NEAR(layers.offset(vertex, s).x, mesh.position[vertex.side].y > 0.47f ? -3.f : 1.f,
                                1e-3f);
            }
    EXPECT_GT(copies, kSquares);
}

TEST_F(Textures, of_a_vertex_that_a_front_passed_match_its_neighbours) {
    const auto flow = sim::fields::swinging(30);
    const auto velocity = [&](const glm::dvec2& x, double t) { return flow.velocity(x, t); };
    int flips = 0;
    for (int step = 0; step < 240; ++step) {
        run(velocity, 1);
        for (const int v : tracker.detector().flipped())
            for (const auto& spoke : mesh.around(v)) {
                if (tracker.detector().is_cut(spoke.edge)) continue;
                ++flips;
                for (int s = 0; s < TextureLayers::kSheets; ++s)
                    EXPECT_LT(glm::length(layers.offsets()[v][s] - layers.offsets()[spoke.vertex][s]),
                              0.25f / kSquares);
            }
    }
    EXPECT_GT(flips, 200);
}

TEST_F(Textures, are_bit_identical_for_any_number_of_threads) {
    const auto flow = with_smooth(sim::fields::pinwheel());
    const auto velocity = [&](const glm::dvec2& x, double t) { return flow.velocity(x, t); };
    run(velocity, 200);
    for (const int threads : {2, 3, 5}) {
        sim::Workers crew(threads);
        Tracker other_tracker(mesh, rule_of_squares(kSquares), PointSource::kFit);
        TextureLayers other(mesh, {});
        std::vector<glm::vec2> v(mesh.position.size());
        for (int i = 0; i < 200; ++i) {
            for (std::size_t k = 0; k < v.size(); ++k)
                v[k] = velocity(glm::dvec2(mesh.position[k]), (i + 1) / 60.0);
            other_tracker.advance({v, {}}, 1 / 60.0, crew);
            other.advance(other_tracker, v, 1 / 60.0, crew);
        }
        EXPECT_TRUE(same_as(other)) << threads;
    }
}

TEST_F(Textures, agree_at_different_step_rates) {
    const auto flow = with_smooth(sim::fields::disc());
    const auto velocity = [&](const glm::dvec2& x, double t) { return flow.velocity(x, t); };
    run(velocity, 270);
    const std::vector<TextureLayers::Offsets> at_60(layers.offsets().begin(), layers.offsets().end());
    Tracker finer_tracker(mesh, rule_of_squares(kSquares), PointSource::kFit);
    TextureLayers finer(mesh, {});
    std::vector<glm::vec2> v(mesh.position.size());
    for (int i = 1; i <= 540; ++i) {
        for (std::size_t k = 0; k < v.size(); ++k) v[k] = velocity(glm::dvec2(mesh.position[k]), i / 120.0);
        finer_tracker.advance({v, {}}, 1 / 120.0, workers);
        finer.advance(finer_tracker, v, 1 / 120.0, workers);
    }
    double sum = 0;
    for (int k = 0; k < mesh.vertices(); ++k)
        for (int s = 0; s < TextureLayers::kSheets; ++s) {
            const glm::vec2 apart = at_60[k][s] - finer.offsets()[k][s];
            sum += static_cast<double>(glm::dot(apart, apart));
        }
    EXPECT_LT(std::sqrt(sum / (mesh.vertices() * TextureLayers::kSheets)) * kSquares, 0.25);  // cells
}

// A wheel that turns faster at its centre than at its rim, so that every particle moves along a circle.
TEST_F(Textures, have_a_quarter_of_the_error_at_half_the_cell_size) {
    const auto turns = [](const glm::dvec2& from) { return 0.6 * std::exp(-glm::dot(from, from) / 0.04); };
    std::array<double, 2> error{};
    for (const int finer : {0, 1}) {
        const Mesh squares = mesh_of_squares(finer ? 40 : 20);
        TextureLayers fresh(squares, {});
        Tracker uncut(squares, sim::front::uncut_rule(), PointSource::kHalf);
        std::vector<glm::vec2> v(squares.position.size());
        for (std::size_t k = 0; k < v.size(); ++k) {
            const glm::dvec2 from = glm::dvec2(squares.position[k]) - 0.5;
            v[k] = glm::vec2(turns(from) * glm::dvec2(-from.y, from.x));
        }
        constexpr int kSteps = 110;  // before the second layer is renewed
        for (int i = 0; i < kSteps; ++i) {
            uncut.advance({v, {}}, 1 / 60.0, workers);
            fresh.advance(uncut, v, 1 / 60.0, workers);
        }
        double sum = 0;
        for (std::size_t k = 0; k < v.size(); ++k) {
            const glm::dvec2 from = glm::dvec2(squares.position[k]) - 0.5;
            if (glm::length(from) > 0.35) continue;
            const double angle = -turns(from) * kSteps / 60;
            const glm::dvec2 was(std::cos(angle) * from.x - std::sin(angle) * from.y,
                                 std::sin(angle) * from.x + std::cos(angle) * from.y);
            const glm::dvec2 apart = glm::dvec2(fresh.offsets()[k][3]) - (was - from);
            sum += glm::dot(apart, apart) / static_cast<double>(v.size());
        }
        error[finer] = std::sqrt(sum);
    }
    EXPECT_LT(error[0] * 20, 0.05);  // cells
    EXPECT_LT(error[1], error[0] / 3.5);
}

// In a rigid rotation nothing is stretched.
TEST_F(Textures, in_rotation_stay_in_their_longest_layer) {
    run([](const glm::dvec2& x, double) { return glm::vec2(0.2 * (0.5 - x.y), 0.2 * (x.x - 0.5)); }, 300);
    const int middle = kSquares / 2 * (kSquares + 2);
    EXPECT_NEAR(layers.mix()[middle].latency, TextureLayers::kLatencies - 1, 0.05);
}

TEST_F(Textures, are_renewed_sooner_the_more_they_are_stretched) {
    std::array<float, 3> latency{};
    int i = 0;
    for (const double shear : {0.05, 0.8, 4.0}) {
        TextureLayers fresh(mesh, {});
        std::vector<glm::vec2> v(mesh.position.size());
        for (std::size_t k = 0; k < v.size(); ++k) v[k] = {shear * (mesh.position[k].y - 0.45f), 0};
        Tracker uncut(mesh, sim::front::gradient_rule(10, 1.f / kSquares), PointSource::kHalf);
        for (int step = 0; step < 900; ++step) {
            uncut.advance({v, {}}, 1 / 60.0, workers);
            fresh.advance(uncut, v, 1 / 60.0, workers);
        }
        latency[i++] = fresh.mix()[kSquares / 2 * (kSquares + 2)].latency;
        // Weights are ≥ 0 and add up to 1.
        for (int k = 0; k < mesh.vertices(); ++k) {
            float sum = 0;
            for (int s = 0; s < TextureLayers::kSheets; ++s) {
                EXPECT_GE(fresh.weight(k, s), 0);
                sum += fresh.weight(k, s);
            }
            EXPECT_NEAR(sum, 1, 1e-5f);
        }
    }
    EXPECT_GT(latency[0], 1.9f);
    EXPECT_GT(latency[1], 0.2f);
    EXPECT_LT(latency[1], 1.8f);
    EXPECT_LT(latency[2], 0.1f);
}

Mesh irregular() {
    const Mesh regular = mesh_of_squares(16);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> aside(-0.2f / 16, 0.2f / 16);
    std::vector<glm::vec2> position = regular.position;
    for (glm::vec2& x : position) x += glm::vec2(aside(random), aside(random));
    auto triangle = regular.triangle;
    for (auto& corner : triangle) std::shuffle(corner.begin(), corner.end(), random);
    return std::get<Mesh>(mesh_of(position, triangle));
}
class TexturesAnywhere : public Textures {
  protected:
    TexturesAnywhere() : Textures(irregular()) {}
};

TEST_F(TexturesAnywhere, are_advected_with_the_sides_of_a_moving_front) {
    const auto flow = sim::fields::swinging(30);
    run([&](const glm::dvec2& x, double t) { return flow.velocity(x, t); }, 480);
    // Offsets on one side are equal, so neither side is stretched.
    for (int e = 0; e < mesh.edges(); ++e) {
        if (tracker.detector().is_cut(e)) continue;
        EXPECT_LT(glm::length(layers.offsets()[mesh.edge[e].a][0] - layers.offsets()[mesh.edge[e].b][0]),
                  0.02f / 16);
    }
}

}  // namespace
