#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/front/mesh.h"

namespace sim::front {

// A place in a triangle, by its barycentric coordinates, each 0 … 1.
struct PlaceIn {
    int triangle;
    std::array<float, 3> weight;
};

// Finds where on a mesh the flow at a vertex comes from.
class Upstream {
  public:
    // The mesh must outlive this object.
    explicit Upstream(const Mesh& mesh);

    // Finds the end of a straight way, in m, from a vertex. Returns nothing if the way leaves the mesh or
    // meets a `torn` triangle (one flag for each), because that one has two sides.
    std::optional<PlaceIn> find(int vertex, const glm::vec2& way, std::span<const std::uint8_t> torn) const;

  private:
    std::optional<PlaceIn> find_in_square(int vertex, const glm::vec2& way,
                                          std::span<const std::uint8_t> torn) const;
    std::optional<PlaceIn> walk(int vertex, const glm::vec2& way, std::span<const std::uint8_t> torn) const;
    std::span<const int> fan(int vertex) const {
        return {fans_.data() + first_[vertex], fans_.data() + first_[vertex + 1]};
    }

    const Mesh& mesh_;
    float cell_ = 0;                 // of a heightfield, m
    std::vector<int> fans_, first_;  // triangles around each vertex
};

}  // namespace sim::front
