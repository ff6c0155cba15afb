#include "sim/front/upstream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace {

using sim::front::Mesh;
using sim::front::mesh_of;
using sim::front::PlaceIn;
using sim::front::Upstream;

constexpr int kSquares = 9;
constexpr float kCell = 0.5f;

Mesh heightfield() {
    return mesh_of(sim::Grid{kSquares + 1, kSquares + 1, kCell});
}

// The same triangles with shuffled corners and moved inner vertices, and without known rows.
Mesh irregular(std::mt19937& random) {
    const Mesh regular = heightfield();
    std::vector<glm::vec2> position = regular.position;
    std::uniform_real_distribution<float> aside(-0.2f * kCell, 0.2f * kCell);
    for (glm::vec2& x : position)
        if (std::min(x.x, x.y) > 0 && std::max(x.x, x.y) < kSquares * kCell)
            x += glm::vec2(aside(random), aside(random));
    auto triangle = regular.triangle;
    for (auto& corner : triangle) std::shuffle(corner.begin(), corner.end(), random);
    return std::get<Mesh>(mesh_of(position, triangle));
}

glm::vec2 position_of(const Mesh& mesh, const PlaceIn& place) {
    glm::vec2 at(0, 0);
    for (int k = 0; k < 3; ++k) at += place.weight[k] * mesh.position[mesh.triangle[place.triangle][k]];
    return at;
}

bool is_inside(const glm::vec2& x) {
    return std::min(x.x, x.y) >= 0 && std::max(x.x, x.y) <= kSquares * kCell;
}

void expect_found(const Mesh& mesh, float longest, std::mt19937& random) {
    const Upstream upstream(mesh);
    const std::vector<std::uint8_t> whole(mesh.triangle.size(), 0);
    std::uniform_real_distribution<float> any(-longest, longest);
    int found = 0, left = 0;
    for (int round = 0; round < 200; ++round)
        for (int v = 0; v < mesh.vertices(); ++v) {
            const glm::vec2 way(any(random), any(random)), to = mesh.position[v] + way;
            const auto place = upstream.find(v, way, whole);
            // On the border rounding decides.
            if (!is_inside(to + 1e-4f) || !is_inside(to - 1e-4f)) {
                left += !place;
                continue;
            }
            ASSERT_TRUE(place) << v << ": " << way.x << ", " << way.y;
            ++found;
            for (const float w : place->weight) EXPECT_GE(w, -1e-5f);
            EXPECT_LT(glm::length(position_of(mesh, *place) - to), 1e-5f);
        }
    EXPECT_GT(found, 1000);
    EXPECT_GT(left, 100);
}

TEST(Upstream, finds_the_end_of_any_short_way_on_a_heightfield) {
    std::mt19937 random(1);
    expect_found(heightfield(), 0.9f * kCell, random);
}

TEST(Upstream, finds_the_end_of_a_way_of_several_cells) {
    std::mt19937 random(2);
    expect_found(heightfield(), 4 * kCell, random);
}

TEST(Upstream, finds_the_end_on_any_triangles) {
    std::mt19937 random(3);
    expect_found(irregular(random), 0.5f * kCell, random);
    expect_found(irregular(random), 3 * kCell, random);
}

TEST(Upstream, finds_the_vertex_itself_and_places_on_its_edges) {
    const Mesh mesh = heightfield();
    const Upstream upstream(mesh);
    const std::vector<std::uint8_t> whole(mesh.triangle.size(), 0);
    for (int v = 0; v < mesh.vertices(); ++v) {
        const auto here = upstream.find(v, {0, 0}, whole);
        ASSERT_TRUE(here);
        EXPECT_LT(glm::length(position_of(mesh, *here) - mesh.position[v]), 1e-6f);
        for (const auto& spoke : mesh.around(v)) {
            const glm::vec2 half = (mesh.position[spoke.vertex] - mesh.position[v]) / 2.f;
            const auto there = upstream.find(v, half, whole);
            ASSERT_TRUE(there);
            EXPECT_LT(glm::length(position_of(mesh, *there) - mesh.position[v] - half), 1e-6f);
        }
    }
}

TEST(Upstream, finds_nothing_in_or_beyond_a_torn_triangle) {
    std::mt19937 random(4);
    for (const Mesh& mesh : {heightfield(), irregular(random)}) {
        const Upstream upstream(mesh);
        const int v = kSquares / 2 * (kSquares + 2);
        const glm::vec2 way(0.3f * kCell, 0.1f * kCell);
        std::vector<std::uint8_t> torn(mesh.triangle.size(), 0);
        const auto place = upstream.find(v, way, torn);
        ASSERT_TRUE(place);
        torn[place->triangle] = 1;
        EXPECT_FALSE(upstream.find(v, way, torn));
        EXPECT_FALSE(upstream.find(v, 8.f * way, torn));
        EXPECT_TRUE(upstream.find(v, -way, torn));
    }
}

// A heightfield's square is found by its number; the way there may lead through the other triangle of the
// square.
TEST(Upstream, agrees_on_a_heightfield_and_the_same_irregular_mesh) {
    std::mt19937 random(6);
    const Mesh mesh = heightfield();
    Mesh loose = mesh;
    loose.columns = 0;
    const Upstream in_rows(mesh), anyhow(loose);
    std::uniform_real_distribution<float> any(-kCell, kCell);
    std::bernoulli_distribution is_torn(0.2);
    int told = 0, kept = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<std::uint8_t> torn(mesh.triangle.size());
        for (auto& each : torn) each = is_torn(random);
        for (int v = 0; v < mesh.vertices(); ++v) {
            const glm::vec2 way = round == 0 ? glm::vec2(0, 0) : glm::vec2(any(random), any(random));
            const auto one = in_rows.find(v, way, torn), other = anyhow.find(v, way, torn);
            if (round > 0) {
                ASSERT_EQ(one.has_value(), other.has_value()) << v << ": " << way.x << ", " << way.y;
            }
            ++(one ? told : kept);
        }
    }
    EXPECT_GT(told, 1000);
    EXPECT_GT(kept, 1000);
}

}  // namespace
