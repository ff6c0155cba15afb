#include "sim/front/detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace {

using sim::front::Detector;
using sim::front::Mesh;
using sim::front::mesh_of;
using sim::front::Rule;

// Five vertices by three, 1 m apart.
class FrontDetector : public testing::Test {
  protected:
    const Mesh mesh = mesh_of(sim::Grid{5, 3, 1});
    std::vector<glm::vec2> velocity = std::vector<glm::vec2>(15);
    std::vector<float> scalar = std::vector<float>(15);

    // Moves everything west of column x to the east at `speed`.
    void move_west_of(int x, float speed) {
        for (int v = 0; v < 15; ++v) velocity[v] = {v % 5 < x ? speed : 0, 0};
    }
    // Edges between columns x-1 and x.
    std::vector<int> edges_west_of(int x) const {
        std::vector<int> edges;
        for (int e = 0; e < mesh.edges(); ++e) {
            const int a = mesh.edge[e].a % 5, b = mesh.edge[e].b % 5;
            if (std::min(a, b) == x - 1 && std::max(a, b) == x) edges.push_back(e);
        }
        return edges;
    }
    static std::vector<int> list(std::span<const int> of) { return {of.begin(), of.end()}; }
    static std::vector<int> edges_of(std::span<const Detector::Gone> gone) {
        std::vector<int> edges;
        for (const auto& one : gone) edges.push_back(one.edge);
        return edges;
    }
};

TEST_F(FrontDetector, lists_cut_edges_and_their_changes) {
    Detector detector(mesh, sim::front::gradient_rule(0.5f, 1));
    move_west_of(2, 1);
    detector.update({velocity, {}});
    EXPECT_EQ(list(detector.cut()), edges_west_of(2));
    EXPECT_EQ(list(detector.before()), std::vector<int>(5, -1));
    EXPECT_TRUE(detector.flipped().empty());  // no previous step

    detector.update({velocity, {}});
    EXPECT_EQ(list(detector.before()), (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_TRUE(detector.vanished().empty());

    const std::vector<int> were = list(detector.cut());
    move_west_of(3, 1);
    detector.update({velocity, {}});
    EXPECT_EQ(list(detector.cut()), edges_west_of(3));
    EXPECT_EQ(edges_of(detector.vanished()), were);
    for (const auto& gone : detector.vanished()) EXPECT_EQ(were[gone.before], gone.edge);
    EXPECT_EQ(list(detector.flipped()), (std::vector<int>{2, 7, 12}));
    for (int i = 0; i < 5; ++i) EXPECT_EQ(detector.slot(detector.cut()[i]), i);
    EXPECT_FALSE(detector.is_cut(were[0]));
}

// Equation (1): the jump that an edge needs grows with its length.
TEST_F(FrontDetector, needs_a_larger_jump_on_a_longer_edge) {
    Detector detector(mesh, {.threshold = 1});
    move_west_of(2, 1.2f);  // below √2, above 1
    detector.update({velocity, {}});
    EXPECT_EQ(detector.cut().size(), 3u);
    for (const int e : detector.cut()) EXPECT_EQ(mesh.length[e], 1);
    move_west_of(2, 1.5f);
    detector.update({velocity, {}});
    EXPECT_EQ(detector.cut().size(), 5u);
}

TEST_F(FrontDetector, holds_a_cut_edge_until_the_jump_falls_below_its_share) {
    Detector detector(mesh, {.jump = 1, .hold = 0.7f});
    const auto cut_at = [&](float speed) {
        move_west_of(2, speed);
        detector.update({velocity, {}});
        return detector.cut().size();
    };
    EXPECT_EQ(cut_at(0.99f), 0u);
    EXPECT_EQ(cut_at(1.01f), 5u);
    EXPECT_EQ(cut_at(0.71f), 5u);
    EXPECT_EQ(cut_at(0.69f), 0u);
    EXPECT_EQ(cut_at(0.99f), 0u);
}

// Beside ground at rest a jump equals the velocity itself; within a flow it is a small part of it.
TEST_F(FrontDetector, for_avalanches_cuts_only_beside_ground_at_rest) {
    Detector detector(mesh, sim::front::avalanche_rule());
    for (int v = 0; v < 15; ++v) velocity[v] = {v % 5 < 3 ? 10.f - 3.f * static_cast<float>(v % 5) : 0, 0};
    detector.update({velocity, {}});  // 10, 7, 4, 0, 0
    EXPECT_EQ(list(detector.cut()), edges_west_of(3));
    move_west_of(3, 0.29f);
    detector.update({velocity, {}});
    EXPECT_EQ(detector.cut().size(), 5u) << "held";
    move_west_of(3, 0.2f);
    detector.update({velocity, {}});
    EXPECT_EQ(detector.cut().size(), 0u);
}

TEST_F(FrontDetector, by_a_level_cuts_where_the_scalar_crosses_it) {
    Detector detector(mesh, {.kind = Rule::Kind::kLevel, .level = 0.5f});
    for (int v = 0; v < 15; ++v) scalar[v] = v % 5 < 2 ? 1.f : 0.5f;
    detector.update({velocity, scalar});
    EXPECT_EQ(list(detector.cut()), edges_west_of(2));
    for (int v = 0; v < 15; ++v) scalar[v] = v % 5 < 3 ? 0.51f : 0.f;
    detector.update({velocity, scalar});
    EXPECT_EQ(list(detector.cut()), edges_west_of(3));
    EXPECT_EQ(list(detector.flipped()), (std::vector<int>{2, 7, 12}));
}

// The row-by-row scan of a heightfield gives the same result as checking edges one by one.
TEST(DetectorOnAHeightfield, finds_the_same_edges_as_on_an_irregular_mesh) {
    const Mesh field = mesh_of(sim::Grid{37, 21, 2});
    const Mesh any = std::get<Mesh>(mesh_of(field.position, field.triangle));
    std::mt19937 random(5);
    std::uniform_real_distribution<float> component(-1, 1);
    for (const Rule& rule : {sim::front::gradient_rule(1.2f, 2), Rule{.threshold = 0.5f},
                             Rule{.kind = Rule::Kind::kRelative, .jump = 0.4f, .ratio = 0.8f}}) {
        Detector on_field(field, rule), on_any(any, rule);
        std::vector<glm::vec2> velocity(field.position.size());
        for (int step = 0; step < 10; ++step) {
            for (glm::vec2& v : velocity)
                if (step == 0 || component(random) > 0.5f) v = {component(random), component(random)};
            on_field.update({velocity, {}}), on_any.update({velocity, {}});
            const auto edges = [](const Detector& of) {
                std::set<std::pair<int, int>> cut;
                for (const int e : of.cut()) cut.emplace(of.mesh().edge[e].a, of.mesh().edge[e].b);
                return cut;
            };
            EXPECT_GT(edges(on_field).size(), 100u);
            EXPECT_EQ(edges(on_field), edges(on_any));
            EXPECT_EQ(std::vector<int>(on_field.flipped().begin(), on_field.flipped().end()),
                      std::vector<int>(on_any.flipped().begin(), on_any.flipped().end()));
        }
    }
}

// Compares every instruction set of the machine with the rule as written. Rows end before, at and after the
// end of a word, and few velocities change between steps.
TEST(DetectorOnAHeightfield, follows_the_rule_with_every_instruction_set) {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> component(-1, 1);
    for (const int columns : {2, 17, 63, 64, 65, 66, 129, 130}) {
        const Mesh mesh = mesh_of(sim::Grid{columns, 7, 1});
        const auto vertices = mesh.position.size();
        const Rule rule{.threshold = 0.4f, .jump = 0.3f};
        for (const sim::InstructionSet set : sim::kInstructionSets) {
            if (!sim::has(set)) continue;
            Detector detector(mesh, rule, set);
            std::vector<glm::vec2> velocity(vertices), before;
            std::vector<bool> was_cut(mesh.edge.size());
            for (int step = 0; step < 30; ++step) {
                before = velocity;
                for (int changes = step % 10 == 0 ? columns : 3; changes > 0; --changes)
                    velocity[random() % vertices] = {component(random), component(random)};
                detector.update({velocity, {}});
                std::vector<int> cut, flipped;
                for (int e = 0; e < mesh.edges(); ++e) {
                    const glm::vec2 jump = velocity[mesh.edge[e].b] - velocity[mesh.edge[e].a];
                    const float limit = std::max(0.4f * mesh.length[e], 0.3f);
                    const float share = was_cut[e] ? 0.7f * 0.7f : 1;
                    was_cut[e] = jump.x * jump.x + jump.y * jump.y >= limit * limit * share;
                    if (was_cut[e]) cut.push_back(e);
                }
                for (std::size_t v = 0; step > 0 && v < vertices; ++v) {
                    const glm::vec2 jump = velocity[v] - before[v];
                    const float limit = std::max(0.2f, 0.3f);
                    if (jump.x * jump.x + jump.y * jump.y >= limit * limit)
                        flipped.push_back(static_cast<int>(v));
                }
                ASSERT_EQ(std::vector<int>(detector.cut().begin(), detector.cut().end()), cut)
                    << columns << " columns, " << to_string(set) << ", step " << step;
                ASSERT_EQ(std::vector<int>(detector.flipped().begin(), detector.flipped().end()), flipped);
            }
        }
    }
}

TEST(DetectorOnAHeightfield, finds_level_crossings_with_every_instruction_set) {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> height(-1, 1);
    for (const int columns : {2, 17, 63, 64, 65, 66, 129, 130}) {
        const Mesh mesh = mesh_of(sim::Grid{columns, 5, 1});
        std::vector<float> scalar(mesh.position.size()), before;
        const std::vector<glm::vec2> rest(mesh.position.size());
        for (const sim::InstructionSet set : sim::kInstructionSets) {
            if (!sim::has(set)) continue;
            Detector detector(mesh, Rule{.kind = Rule::Kind::kLevel, .level = 0.3f}, set);
            for (int step = 0; step < 5; ++step) {
                before = scalar;
                for (float& s : scalar) s = height(random);
                detector.update({rest, scalar});
                std::vector<int> cut, flipped;
                for (int e = 0; e < mesh.edges(); ++e)
                    if ((scalar[mesh.edge[e].a] > 0.3f) != (scalar[mesh.edge[e].b] > 0.3f)) cut.push_back(e);
                for (std::size_t v = 0; step > 0 && v < scalar.size(); ++v)
                    if ((scalar[v] > 0.3f) != (before[v] > 0.3f)) flipped.push_back(static_cast<int>(v));
                ASSERT_EQ(std::vector<int>(detector.cut().begin(), detector.cut().end()), cut) << columns;
                ASSERT_EQ(std::vector<int>(detector.flipped().begin(), detector.flipped().end()), flipped);
            }
        }
    }
}

}  // namespace
