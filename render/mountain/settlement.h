#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace render {

// What people have built on a world's ground at tick 0, as far as fields, gardens and paths depend on it. Places are metres
// from vertex (0, 0).
struct Settlement {
    struct House {
        glm::dvec2 at, front;  // its middle; unit vector out of its front
        double length, width;  // along `front` and across it, m
    };
    struct Road {
        glm::dvec2 from, to;
        double width;  // m
    };
    std::vector<House> houses = {};
    std::vector<Road> roads = {};
};

}  // namespace render
