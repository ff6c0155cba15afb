#include "render/flow/rock_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <glm/geometric.hpp>

#include "render/base/chance.h"

namespace render {
namespace {

struct Plane {
    glm::vec3 normal;
    float away;  // from the middle
};

struct Triangle {
    glm::vec3 a, b, c;  // counterclockwise from outside, unit vectors
};

std::vector<Triangle> icosahedron() {
    const float g = 0.5f * (1 + std::sqrt(5.f));
    const std::array<glm::vec3, 12> v{{{-1, g, 0},
                                       {1, g, 0},
                                       {-1, -g, 0},
                                       {1, -g, 0},
                                       {0, -1, g},
                                       {0, 1, g},
                                       {0, -1, -g},
                                       {0, 1, -g},
                                       {g, 0, -1},
                                       {g, 0, 1},
                                       {-g, 0, -1},
                                       {-g, 0, 1}}};
    constexpr std::array<std::array<std::size_t, 3>, 20> kFaces{
        {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    std::vector<Triangle> triangles;
    triangles.reserve(kFaces.size());
    for (const auto& f : kFaces)
        triangles.push_back({glm::normalize(v[f[0]]), glm::normalize(v[f[1]]), glm::normalize(v[f[2]])});
    return triangles;
}

std::vector<Triangle> divided(const std::vector<Triangle>& of) {
    std::vector<Triangle> finer;
    finer.reserve(4 * of.size());
    for (const Triangle& t : of) {
        const glm::vec3 ab = glm::normalize(t.a + t.b), bc = glm::normalize(t.b + t.c),
                        ca = glm::normalize(t.c + t.a);
        for (const Triangle& each : {Triangle{t.a, ab, ca}, {ab, t.b, bc}, {ca, bc, t.c}, {ab, bc, ca}})
            finer.push_back(each);
    }
    return finer;
}

std::vector<Plane> planes_of(Chance& chance) {
    constexpr int kPlanes = 13;
    std::vector<Plane> planes;
    planes.reserve(kPlanes);
    for (int i = 0; i < kPlanes; ++i) {
        const float z = chance(-1, 1);
        const glm::vec3 around = direction(chance());
        planes.push_back({glm::vec3(std::sqrt(1 - z * z) * glm::vec2(around), z), chance(0.56f, 0.86f)});
    }
    return planes;
}

glm::vec3 cut(const glm::vec3& way, std::span<const Plane> planes, const glm::vec3& stretch) {
    float away = 1;
    for (const Plane& plane : planes)
        if (const float toward = glm::dot(way, plane.normal); toward > 0.1f)
            away = std::min(away, plane.away / toward);
    // Its sides are uneven.
    const float rough = 1 + 0.05f * std::sin(9 * way.x + 5 * way.y) * std::sin(8 * way.y - 6 * way.z) +
                        0.03f * std::sin(21 * way.z + 17 * way.x);
    return rough * away * way * stretch;
}

std::vector<RockCorner> corners_of(const std::vector<Triangle>& ball, std::span<const Plane> planes,
                                   const glm::vec3& stretch) {
    std::vector<RockCorner> corners;
    corners.reserve(3 * ball.size());
    for (const Triangle& t : ball) {
        const std::array<glm::vec3, 3> at{cut(t.a, planes, stretch), cut(t.b, planes, stretch),
                                          cut(t.c, planes, stretch)};
        const glm::vec3 facing = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
        for (const glm::vec3& each : at) corners.push_back({each, facing});
    }
    return corners;
}

double volume_of(std::span<const RockCorner> corners) {
    double volume = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        volume +=
            static_cast<double>(glm::dot(corners[i].at, glm::cross(corners[i + 1].at, corners[i + 2].at))) /
            6;
    return volume;
}

}  // namespace

std::array<RockMesh, kRocks> rock_meshes() {
    const std::vector<Triangle> coarse = icosahedron(), middle = divided(coarse), fine = divided(middle);
    std::array<RockMesh, kRocks> rocks;
    for (std::uint32_t i = 0; i < kRocks; ++i) {
        Chance chance(71 + i);
        const std::vector<Plane> planes = planes_of(chance);
        const glm::vec3 stretch(chance(1.05f, 1.3f), chance(0.85f, 1.05f), chance(0.62f, 0.88f));
        constexpr double kBall = 3.14159265 / 6;
        const double volume = volume_of(corners_of(fine, planes, stretch));
        const glm::vec3 size = static_cast<float>(std::cbrt(kBall / volume)) * stretch;
        rocks[i] = {corners_of(fine, planes, size), corners_of(middle, planes, size),
                    corners_of(coarse, planes, size)};
    }
    return rocks;
}

}  // namespace render
