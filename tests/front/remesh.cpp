#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <glm/geometric.hpp>

#include "sim/core/workers.h"
#include "sim/fields/test_flows.h"
#include "sim/front/gradient.h"
#include "sim/front/remesh_reference.h"

namespace {

using sim::front::cut_triangle;
using sim::front::CutTriangle;
using sim::front::CutTriangles;
using sim::front::CutVertex;
using sim::front::Mesh;

float area(const glm::vec2& p, const glm::vec2& q, const glm::vec2& r) {
    return 0.5f * ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}
float area(const CutTriangle& triangle) {
    return area(triangle[0].position, triangle[1].position, triangle[2].position);
}

// Every pattern of cuts, vertex order, orientation of the triangle, and position on the edges.
struct Cutting {
    std::array<int, 3> corner;
    std::array<glm::vec2, 3> at;
    std::array<std::optional<glm::vec2>, 3> crossing;
    std::array<float, 3> f;
    CutTriangles cut() const { return cut_triangle(corner, at, crossing); }
    int cuts() const {
        return static_cast<int>(
            std::count_if(crossing.begin(), crossing.end(), [](const auto& d) { return !!d; }));
    }
};
std::vector<Cutting> cuttings() {
    constexpr glm::vec2 kPlace[3] = {{0.2f, 0.1f}, {1.3f, 0.3f}, {0.5f, 1.1f}};
    std::vector<Cutting> all;
    std::array<int, 3> corner{0, 1, 2};
    do {
        for (int pattern = 0; pattern < 8; ++pattern)
            for (const float f0 : {0.01f, 0.5f, 0.99f})
                for (const float f1 : {0.01f, 0.5f, 0.99f})
                    for (const float f2 : {0.01f, 0.5f, 0.99f}) {
                        Cutting one{corner, {}, {}, {f0, f1, f2}};
                        for (int k = 0; k < 3; ++k) one.at[k] = kPlace[corner[k]];
                        for (int k = 0; k < 3; ++k)
                            if (pattern >> k & 1)
                                one.crossing[k] = one.at[k] + one.f[k] * (one.at[(k + 1) % 3] - one.at[k]);
                        all.push_back(one);
                    }
    } while (std::next_permutation(corner.begin(), corner.end()));
    return all;
}

TEST(Remesh, makes_as_many_triangles_as_the_scheme_requires) {
    const int count[] = {1, 3, 3, 6};
    for (const Cutting& one : cuttings()) EXPECT_EQ(one.cut().count, count[one.cuts()]);
}

TEST(Remesh, covers_the_triangle_once_and_keeps_its_orientation) {
    for (const Cutting& one : cuttings()) {
        const float whole = area(one.at[0], one.at[1], one.at[2]);
        float sum = 0;
        int without_area = 0;
        for (const CutTriangle& triangle : one.cut()) {
            EXPECT_GE(area(triangle) / whole, -1e-6f);
            sum += area(triangle);
            without_area += std::abs(area(triangle)) < 1e-6f;
        }
        EXPECT_NEAR(sum, whole, 1e-5f);
        EXPECT_EQ(without_area, one.cuts() == 1) << "only a tear that ends has a triangle without area";
    }
}

// All corners of a triangle that is not a tear are on one side, so its texture is the map of that side alone.
// A side is a set of corners joined by uncut edges.
std::array<int, 3> sides_of(const Cutting& one) {
    std::array<int, 3> side{0, 1, 2};
    for (int round = 0; round < 2; ++round)
        for (int k = 0; k < 3; ++k)
            if (!one.crossing[k]) side[k] = side[(k + 1) % 3] = std::min(side[k], side[(k + 1) % 3]);
    return side;
}

// Counts corners that are not on the side of their triangle.
int misplaced(const Cutting& one, const CutTriangles& cut) {
    const std::array<int, 3> side = sides_of(one);
    int wrong = 0;
    for (const CutTriangle& triangle : cut) {
        if (std::abs(area(triangle)) < 1e-6f) continue;  // the tear
        std::set<int> sides;
        for (const CutVertex& vertex : triangle)
            sides.insert(
                side[std::find(one.corner.begin(), one.corner.end(), vertex.side) - one.corner.begin()]);
        wrong += sides.size() != 1;
    }
    return wrong;
}

TEST(Remesh, gives_each_side_its_own_coordinates) {
    for (const Cutting& one : cuttings()) {
        if (one.cuts() == 1) continue;  // where a tear ends, both its sides are the same
        EXPECT_EQ(misplaced(one, one.cut()), 0);
        for (const CutTriangle& triangle : one.cut())
            for (const CutVertex& vertex : triangle) {
                // A mesh vertex keeps its position and belongs to itself.
                const auto k =
                    std::find(one.corner.begin(), one.corner.end(), vertex.side) - one.corner.begin();
                EXPECT_TRUE(vertex.on_front || vertex.position == one.at[k]);
            }
    }
}

// With one cut, the triangles on either side of it use the copy of their own end.
TEST(Remesh, tears_an_edge_between_its_ends) {
    for (const Cutting& one : cuttings()) {
        if (one.cuts() != 1) continue;
        const int k = one.crossing[0] ? 0 : one.crossing[1] ? 1 : 2;
        const CutTriangles cut = one.cut();
        const std::pair<int, int> ends[] = {{0, k}, {2, (k + 1) % 3}};
        for (const auto& [number, end] : ends) {
            bool has_end = false;
            for (const CutVertex& vertex : cut.triangle[number]) {
                has_end |= !vertex.on_front && vertex.side == one.corner[end];
                EXPECT_TRUE(!vertex.on_front || vertex.side == one.corner[end]);
            }
            EXPECT_TRUE(has_end);
        }
    }
}

// Negative control: with the copies of an edge swapped, the test above must fail.
TEST(Remesh, with_swapped_copies_is_detected) {
    for (const Cutting& one : cuttings()) {
        if (one.cuts() < 2) continue;
        CutTriangles cut = one.cut();
        for (CutTriangle& triangle : cut.triangle)
            for (CutVertex& vertex : triangle)
                if (vertex.on_front)
                    for (int k = 0; k < 3; ++k)
                        if (one.crossing[k] && vertex.position == *one.crossing[k]) {
                            const int a = one.corner[k], b = one.corner[(k + 1) % 3];
                            vertex.side = a + b - vertex.side;
                            break;
                        }
        EXPECT_GT(misplaced(one, cut), 0);
    }
}

// With constants 0 and 1 on the two sides, no intermediate value appears inside any triangle that has area.
TEST(Remesh, never_mixes_the_sides) {
    for (const Cutting& one : cuttings()) {
        if (one.cuts() != 2) continue;
        const std::array<int, 3> side = sides_of(one);
        for (const CutTriangle& triangle : one.cut()) {
            std::set<int> constants;
            for (const CutVertex& vertex : triangle)
                constants.insert(
                    side[std::find(one.corner.begin(), one.corner.end(), vertex.side) - one.corner.begin()] ==
                    0);
            EXPECT_EQ(constants.size(), 1u);
        }
    }
}

// A whole mesh, with a flow that cuts triangles once, twice and three times.
class RemeshOfAFlow : public testing::Test {
  protected:
    static constexpr int kSquares = 16;
    const Mesh mesh = sim::front::mesh_of(sim::Grid{kSquares + 1, kSquares + 1, 1.f / kSquares});
    sim::front::Tracker tracker{mesh, sim::front::gradient_rule(0.05f, 1.f / kSquares),
                                sim::front::PointSource::kFit};
    sim::Workers workers{1};

    void run(const sim::fields::TestFlow& flow, int steps) {
        std::vector<glm::vec2> velocity(mesh.position.size());
        for (int i = 1; i <= steps; ++i) {
            for (std::size_t v = 0; v < velocity.size(); ++v)
                velocity[v] = flow.velocity(glm::dvec2(mesh.position[v]), i / 60.0);
            tracker.advance({velocity, {}}, 1 / 60.0, workers);
        }
    }
};

// Both triangles at an edge have bit-identical positions on it: no crack, and no vertex on the other's side.
TEST_F(RemeshOfAFlow, has_no_cracks) {
    run(sim::fields::pinwheel(), 120);
    for (int e = 0; e < mesh.edges(); ++e) {
        const auto [first, second] = mesh.edge_triangle[e];
        if (second < 0) continue;
        const glm::vec2 from = mesh.position[mesh.edge[e].a], to = mesh.position[mesh.edge[e].b];
        const auto on_edge = [&](int triangle) {
            std::set<std::pair<float, float>> positions;
            for (const CutTriangle& part : cut_triangle(tracker, triangle))
                for (const CutVertex& vertex : part) {
                    const glm::vec2 p = vertex.position;
                    const float off = std::abs(area(from, to, p)) / mesh.length[e];
                    if (off < 1e-6f) positions.emplace(p.x, p.y);
                }
            return positions;
        };
        EXPECT_EQ(on_edge(first), on_edge(second));
    }
}

TEST_F(RemeshOfAFlow, reproduces_an_affine_map_on_each_side) {
    const auto flow = sim::fields::swinging(30);
    run(flow, 120);
    // Each side has its own affine map of coordinates. Gradients come from neighbours on the same side.
    const auto map = [](int region, const glm::vec2& x) {
        return region ? glm::vec2(3 * x.x - x.y + 0.5f, x.x + 2 * x.y)
                      : glm::vec2(-x.x + 4, 2 * x.x + 5 * x.y - 1);
    };
    std::vector<std::array<glm::vec2, 1>> coordinates;
    std::vector<int> region;
    for (const glm::vec2& x : mesh.position) {
        region.push_back(flow.region(glm::dvec2(x), 2));
        coordinates.push_back({map(region.back(), x)});
    }
    // The previous gradient of a vertex whose neighbours on its side lie on one line, which determine half of
    // it.
    const auto last_at = [&](int v) {
        const auto around = mesh.around(v);
        std::vector<glm::vec2> ways;
        for (const auto& spoke : around)
            if (!tracker.detector().is_cut(spoke.edge))
                ways.push_back(mesh.position[spoke.vertex] - mesh.position[v]);
        for (const glm::vec2& way : ways)
            if (std::abs(area({0, 0}, ways[0], way)) > 1e-6f) return glm::mat2(0);
        return region[v] ? glm::mat2(3, 1, -1, 2) : glm::mat2(-1, 2, 0, 5);
    };
    int copies = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangle.size()); ++t)
        for (const CutTriangle& part : cut_triangle(tracker, t))
            for (const CutVertex& vertex : part) {
                std::array gradient{last_at(vertex.side)};
                sim::front::find_gradients<1>(tracker.detector(), vertex.side, coordinates, gradient);
                const glm::vec2 got = sim::front::carried_on(coordinates[vertex.side][0], gradient[0],
                                                             vertex.position - mesh.position[vertex.side]);
                const glm::vec2 right = map(region[vertex.side], vertex.position);
                EXPECT_NEAR(got.x, right.x, 3e-6);
                EXPECT_NEAR(got.y, right.y, 3e-6);
                copies += vertex.on_front;
            }
    EXPECT_GT(copies, 100);
}

TEST_F(RemeshOfAFlow, keeps_the_last_gradient_of_a_vertex_isolated_by_fronts) {
    std::vector<glm::vec2> velocity(mesh.position.size(), glm::vec2(0, 0));
    std::vector<std::array<glm::vec2, 1>> coordinates;
    for (const glm::vec2& x : mesh.position) coordinates.push_back({x});
    const int alone = kSquares / 2 * (kSquares + 2);
    velocity[alone] = {1, 0};
    tracker.advance({velocity, {}}, 1 / 60.0, workers);
    const auto gradient_at = [&](int vertex) {
        std::array gradient{glm::mat2(1, 2, 3, 4)};
        sim::front::find_gradients<1>(tracker.detector(), vertex, coordinates, gradient);
        return gradient[0];
    };
    EXPECT_EQ(gradient_at(alone), glm::mat2(1, 2, 3, 4));
    EXPECT_NEAR(glm::length(gradient_at(0)[0] - glm::vec2(1, 0)), 0, 1e-6);
}

}  // namespace
