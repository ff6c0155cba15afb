#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/world/state.h"

namespace sim::powder {

// How easily a flow of a material throws up powder or dust.
struct Rule {
    float strength = 0;  // 0 to 1; 0: none
    float speed = 7;     // m/s, > 0: a slower flow throws up nothing; at three times as much it throws up all
};

// A soft ball of air full of powder. A plain value.
struct Puff {
    glm::vec3 at;            // its middle, m; z above the datum
    glm::vec3 velocity;      // m/s
    float first_radius = 0;  // at birth, m
    float age_s = 0;
    float life_s = 1;
    float density = 0;       // greatest opacity through its middle, 0 to 1
    float lower = 0;         // share of the lower material, 0 to 1
    std::uint32_t seed = 0;  // of its looks
    bool operator==(const Puff&) const = default;
};

// Both are smooth over its life, and opacity is 0 at its ends, so that no puff pops.
float radius(const Puff& puff);   // m
float opacity(const Puff& puff);  // 0 to 1

// Powder thrown up by a fast flow: puffs that are born over it, most of all at its front and over steep ground,
// travel with it, rise, grow, fall behind and settle within seconds. Wind carries them off: the more, the higher
// and older they are.
//
// A view: it never affects the world. It depends on its past, so a checkpoint keeps the puffs. They are
// bit-identical on every machine: only + − × ÷ and hashes of cell and tick.
class Cloud {
  public:
    static constexpr std::size_t kMost = 2000;  // puffs; fewer are born as their number comes near

    // `lower`: of the lower material, in a world of two. `wind`: velocity of the air high above ground, m/s.
    explicit Cloud(const Rule& upper, const Rule& lower = {}, glm::vec2 wind = {0, 0});

    // Advances to `world`, `dt_s` later, > 0.
    void advance(const View& world, float dt_s);
    // Throws up what an explosion at a place in metres releases. Nothing where no layer lies.
    void blast(const View& world, glm::vec2 at, float radius);

    std::span<const Puff> puffs() const { return puffs_; }
    void restore(std::span<const Puff> puffs) { puffs_.assign(puffs.begin(), puffs.end()); }

  private:
    void move(const View& world, float dt_s);
    void give_birth(const View& world, float dt_s);
    void give_birth_in(const View& world, float dt_s, int y, int first, int last);
    Rule rule_of(const View& world, int x, int y) const;

    Rule upper_, lower_;
    glm::vec2 wind_;           // m/s
    std::vector<Puff> puffs_;  // in order of birth
};

}  // namespace sim::powder
