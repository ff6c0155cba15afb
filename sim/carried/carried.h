#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sim/carried/body.h"
#include "sim/world/state.h"

namespace sim::carried {

// A number of the body's own, 0 to 1, excluding 1; `which` tells its numbers apart.
float own(const Body& body, std::uint32_t which);

// What a flow of soil carries. Boulders lie in the soil of tick 0, at places and depths that only depend on the vertex. A flow
// that erodes so far lays them bare. They ride high in it, a little faster than its mean, so that they gather at its front
// and roll out ahead of it; they bounce over the ground, and come to rest half sunk in the deposit or a little beyond.
// The number of boulders of a size or more falls with its power 2.5, that of fragmented rock [turcotte1986].
//
// Trees that it breaks are carried too, as bare trunks with the plates of their roots: a flow takes hold of both halves
// of one, so that it turns with the shear, as a long thin body does [jeffery1922].
//
// A view: it never affects the world. It depends on its past, so a checkpoint keeps the bodies. They are bit-identical on
// every machine: only + − × ÷, square roots and hashes.
class Carried {
  public:
    static constexpr std::size_t kMostBoulders = 600, kMostTrunks = 300;  // later ones are not seen
    static constexpr std::size_t kMost = kMostBoulders + kMostTrunks;
    static constexpr float kSmallest = 0.3f, kLargest = 3;  // m, diameter of a boulder
    static constexpr float kPerCubicMetre = 0.02f;          // boulders in soil

    // `first_depth`: of the standing layer at tick 0, m, one value per vertex, row 0 the south. `upper` and `lower`: whether
    // that material is soil.
    Carried(std::span<const float> first_depth, bool upper, bool lower);

    // Advances to `world`, `dt_s` later, > 0. Returns whether anything changed.
    bool advance(const View& world, float dt_s);

    std::span<const Body> bodies() const { return bodies_; }
    void restore(std::span<const Body> bodies);

  private:
    bool move(const View& world, float dt_s);
    void take_up(const View& world);
    void take_up_in(const View& world, int y, int first, int last);
    void lay_bare(const View& world, int x, int y, float eroded);
    void fell(const View& world, int x, int y, const Stems& stems);
    bool is_of_soil(const View& world, int x, int y) const;

    std::vector<float> first_depth_;  // m
    bool upper_, lower_;
    std::vector<Body> bodies_;  // in the order in which they were taken up
    std::size_t trunks_ = 0;    // of these
    std::vector<std::uint8_t> bare_,
        felled_;  // of each vertex: bit i, its boulder or its tree i was taken up
};

}  // namespace sim::carried
