#include "sim/carried/carried.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "sim/carried/boulder.h"
#include "sim/carried/ground_at.h"
#include "sim/carried/trunk.h"
#include "sim/core/chance.h"
#include "sim/core/check.h"
#include "sim/core/ramp.h"

namespace sim::carried {
namespace {

constexpr double kHectare = 10'000;                      // m²
constexpr int kMostOfVertex = 8;                         // boulders, and trunks
constexpr float kShortestTrunk = 3, kLongestTrunk = 15;  // m, trunks; the rest broke off
constexpr float kTooThin = 0.1f;                         // m; a thinner flow lays none bare
constexpr float kTooSlow = 0.8f;                         // m/s; nor does a slower one

// The diameter that a share of all boulders exceeds: u^(−1/2.5), by Newton's method for the fifth root.
float size_of(float u) {
    float root = 1;
    for (int i = 0; i < 12; ++i) {
        const float squared = root * root;
        root = 0.8f * root + 0.2f * std::max(u, 1e-4f) / (squared * squared);
    }
    return std::min(Carried::kSmallest / (root * root), Carried::kLargest);
}

float chance_of_tree(std::size_t vertex, std::uint32_t which) {
    return share_of(mixed(static_cast<std::uint64_t>(vertex) << 20 | 0x80000u | which));
}

// A trunk as it falls: along the flow, more or less.
Body trunk_of(const View& world, std::span<const float> first_depth, glm::ivec2 at_vertex, int number,
              const Stems& stems) {
    const std::size_t vertex =
        static_cast<std::size_t>(at_vertex.y) * static_cast<std::size_t>(world.grid.nx) +
        static_cast<std::size_t>(at_vertex.x);
    const auto chance = [&](std::uint32_t which) {
        return chance_of_tree(vertex, static_cast<std::uint32_t>(16 * (number + 1)) + which);
    };
    Body trunk;
    trunk.kind = Kind::kTrunk;
    trunk.seed = (mixed(vertex << 20 | 0x80000u | static_cast<std::uint32_t>(16 * (number + 1) + 1)) & ~7u) |
                 static_cast<std::uint32_t>(number);
    trunk.vertex = static_cast<std::int32_t>(vertex);
    trunk.size = std::clamp(static_cast<float>(stems.height_m) * (0.3f + 0.45f * chance(2)), kShortestTrunk,
                            kLongestTrunk);
    const glm::vec2 at = world.grid.dx * (glm::vec2(at_vertex) + glm::vec2(chance(3), chance(4)) - 0.5f);
    const GroundAt here = ground_at(world, first_depth, at);
    const glm::vec2 aside = 0.8f * glm::vec2(chance(5), chance(6)) - 0.4f;
    const glm::vec2 way =
        glm::normalize(here.velocity / std::max(glm::length(here.velocity), 0.1f) + aside + 1e-3f);
    trunk.turn = glm::vec4(glm::normalize(glm::vec3(way, glm::dot(way, here.slope))), 0);
    trunk.velocity = glm::vec3(here.velocity, 0);
    trunk.at = glm::vec3(at, here.surface);
    return trunk;
}

}  // namespace

float own(const Body& body, std::uint32_t which) {
    return share_of(mixed(static_cast<std::uint64_t>(body.seed) << 32 | which));
}

Carried::Carried(std::span<const float> first_depth, bool upper, bool lower)
    : first_depth_(first_depth.begin(), first_depth.end()),
      upper_(upper),
      lower_(lower),
      bare_(first_depth.size()),
      felled_(first_depth.size()) {
    bodies_.reserve(kMost);
}

void Carried::restore(std::span<const Body> bodies) {
    CHECK(bodies.size() <= kMost);
    bodies_.assign(bodies.begin(), bodies.end());
    std::ranges::fill(bare_, std::uint8_t{0});
    std::ranges::fill(felled_, std::uint8_t{0});
    trunks_ = 0;
    for (const Body& body : bodies_) {
        const bool is_trunk = body.kind == Kind::kTrunk;
        trunks_ += is_trunk;
        (is_trunk ? felled_ : bare_)[static_cast<std::size_t>(body.vertex)] |=
            static_cast<std::uint8_t>(1u << (body.seed & 7u));
    }
}

bool Carried::advance(const View& world, float dt_s) {
    CHECK(dt_s > 0 && world.grid.size() == first_depth_.size());
    const std::size_t before = bodies_.size();
    const bool moved = move(world, dt_s);
    take_up(world);
    return moved || bodies_.size() != before;
}

bool Carried::move(const View& world, float dt_s) {
    bool any = false;
    for (Body& body : bodies_) {
        const Body was = body;
        (body.kind == Kind::kTrunk ? move_trunk : move_boulder)(world, first_depth_, dt_s, body);
        any |= body != was;
    }
    return any;
}

bool Carried::is_of_soil(const View& world, int x, int y) const {
    if (!world.mixture) return upper_;
    return share_in_rolling(world, x, y) > 0.5f ? lower_ : upper_;
}

// Nothing is eroded in a tile that sleeps. A world without an engine has no tiles.
void Carried::take_up(const View& world) {
    const Tiles& tiles = world.tiles;
    for (int y = 0; y < world.grid.ny; ++y) {
        if (tiles.awake.empty()) {
            take_up_in(world, y, 0, world.grid.nx);
            continue;
        }
        for (int column = 0; column < tiles.columns; ++column)
            if (tiles.awake[tiles.number(column, y / tiles.height)])
                take_up_in(world, y, column * tiles.width,
                           std::min((column + 1) * tiles.width, world.grid.nx));
    }
}

// Of the vertices of a row from `first` to before `last`.
void Carried::take_up_in(const View& world, int y, int first, int last) {
    const float *rolling = world.rolling.row(y), *depth = world.depth.row(y);
    const float *u = world.velocity_x.row(y), *v = world.velocity_y.row(y);
    const float* before =
        &first_depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx)];
    for (int x = first; x < last; ++x) {
        if (rolling[x] < kTooThin || u[x] * u[x] + v[x] * v[x] < kTooSlow * kTooSlow) continue;
        if (!is_of_soil(world, x, y)) continue;
        if (depth[x] < before[x]) lay_bare(world, x, y, before[x] - depth[x]);
        if (world.things && world.things->forest(x, y).lying > 0)
            fell(world, x, y, world.things->forest(x, y));
    }
}

void Carried::lay_bare(const View& world, int x, int y, float eroded) {
    const std::size_t vertex =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) + static_cast<std::size_t>(x);
    const float dx = world.grid.dx, depth = first_depth_[vertex];
    const auto chance = [&](std::uint32_t which) {
        return share_of(mixed(static_cast<std::uint64_t>(vertex) << 20 | which));
    };
    const float expected = kPerCubicMetre * dx * dx * depth;
    const int count = std::min(static_cast<int>(expected + chance(0)), kMostOfVertex);
    for (int i = 0; i < count && bodies_.size() - trunks_ < kMostBoulders; ++i) {
        const auto which = static_cast<std::uint32_t>(16 * (i + 1));
        const auto bit = static_cast<std::uint8_t>(1u << static_cast<unsigned>(i));
        if ((bare_[vertex] & bit) != 0 || chance(which) * depth > eroded) continue;
        bare_[vertex] |= bit;
        Body body;
        body.seed = (mixed(vertex << 20 | (which + 1)) & ~7u) | static_cast<std::uint32_t>(i);
        body.vertex = static_cast<std::int32_t>(vertex);
        body.size = size_of(chance(which + 2));
        body.sunk = 1;
        const glm::vec2 at = dx * (glm::vec2(x, y) + glm::vec2(chance(which + 3), chance(which + 4)) - 0.5f);
        const GroundAt here = ground_at(world, first_depth_, at);
        body.at = glm::vec3(at, here.surface - 0.5f * body.size);
        body.velocity = glm::vec3(here.velocity, 0);
        body.turn = glm::normalize(
            glm::vec4(chance(which + 5), chance(which + 6), chance(which + 7), chance(which + 8)) - 0.5f +
            glm::vec4(0, 0, 0, 1e-3f));
        bodies_.push_back(body);
    }
}

// The trees that lie at a vertex, which stood around it: each falls where the flow goes.
void Carried::fell(const View& world, int x, int y, const Stems& stems) {
    const std::size_t vertex =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) + static_cast<std::size_t>(x);
    const double expected = stems.lying * world.grid.cell_area() / kHectare;
    const int count =
        std::min(static_cast<int>(expected + static_cast<double>(chance_of_tree(vertex, 0))), kMostOfVertex);
    for (int i = 0; i < count && trunks_ < kMostTrunks; ++i) {
        const auto bit = static_cast<std::uint8_t>(1u << static_cast<unsigned>(i));
        if ((felled_[vertex] & bit) != 0) continue;
        felled_[vertex] |= bit;
        ++trunks_;
        bodies_.push_back(trunk_of(world, first_depth_, {x, y}, i, stems));
    }
}

}  // namespace sim::carried
