#include "sim/front/one_sided_neighbourhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using sim::front::Detector;
using sim::front::Flips;
using sim::front::Mesh;
using sim::front::OneSidedNeighbourhood;
using sim::front::OneSidedNeighbourhoods;

// Seven vertices by seven, 1 m apart. West of column 3 the flow moves east at 1 m/s; in the rows from `end`
// on it gets slower, so that from the next row on no edge is cut.
class FrontShores : public testing::Test {
  protected:
    static constexpr int kSide = 7;
    const Mesh mesh = sim::front::mesh_of(sim::Grid{kSide, kSide, 1});
    Detector detector{mesh, sim::front::gradient_rule(0.5f, 1)};
    std::vector<Flips> flips = std::vector<Flips>(mesh.position.size());
    std::vector<int> cuts = std::vector<int>(mesh.position.size());
    OneSidedNeighbourhoods shores{mesh.position.size(),
                                  sim::front::fit::kernels_for(sim::best_instruction_set())};

    void part(int end) {
        std::vector<glm::vec2> velocity(mesh.position.size());
        for (int v = 0; v < mesh.vertices(); ++v)
            if (v % kSide < 3)
                velocity[v].x = std::clamp(1 - 0.4f * static_cast<float>(v / kSide - end + 1), 0.f, 1.f);
        detector.update({velocity, {}});
        for (const int e : detector.cut()) ++cuts[mesh.edge[e].a], ++cuts[mesh.edge[e].b];
    }
    OneSidedNeighbourhood shore_of(int vertex, double time = 0) {
        return shores[shores.find(detector, cuts, flips, time, vertex)];
    }
};

TEST_F(FrontShores, contain_vertices_of_one_side_only) {
    part(kSide);
    for (const int vertex : {3 * kSide + 2, 3 * kSide + 3}) {
        const OneSidedNeighbourhood shore = shore_of(vertex);
        EXPECT_EQ(shore.vertices[0], vertex);
        for (const int v : shore.vertices) EXPECT_EQ(v % kSide < 3, vertex % kSide < 3) << v;
        for (const auto& [here, beyond] : shore.crossings) EXPECT_NE(here % kSide < 3, beyond % kSide < 3);
        EXPECT_GT(shore.crossings.size(), 10u);
    }
}

TEST_F(FrontShores, extend_around_the_end_of_a_front) {
    part(3);
    const OneSidedNeighbourhood shore = shore_of(2 * kSide + 2);
    EXPECT_NE(std::find(shore.vertices.begin(), shore.vertices.end(), 4 * kSide + 3), shore.vertices.end());
}

TEST_F(FrontShores, list_flips_newest_first_and_reverse_every_second_one) {
    part(kSide);
    const int first = 3 * kSide + 2, second = 2 * kSide + 1, beyond = 3 * kSide + 3;
    flips[first].last[0] = {5, {1, 0}}, flips[first].last[1] = {2, {-1, 0}};
    flips[second].last[0] = {4, {1, 0}};
    flips[beyond].last[0] = {3, {1, 0}};
    const OneSidedNeighbourhood shore = shore_of(first, 6);
    ASSERT_EQ(shore.flipped.size(), 3u);
    const int vertex[] = {first, second, first};
    const double age[] = {1, 2, 4};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(shore.flipped[i], vertex[i]);
        EXPECT_EQ(shore.flips.age[i], age[i]);
        EXPECT_EQ(shore.flips.x[i], mesh.position[vertex[i]].x);
        EXPECT_EQ(shore.flips.east[i], 1);
    }
    EXPECT_EQ(shore.flips.east[3], 0);  // filler
}

TEST_F(FrontShores, are_recomputed_at_another_moment) {
    part(kSide);
    const int number = shores.find(detector, cuts, flips, 0, 16);
    EXPECT_EQ(shores.find(detector, cuts, flips, 0, 16), number);
    EXPECT_TRUE(shores[number].flipped.empty());
    flips[16].last[0] = {0, {1, 0}};
    shores.clear();
    EXPECT_EQ(shore_of(16, 1).flipped.size(), 1u);
}

}  // namespace
