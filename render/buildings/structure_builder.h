#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "render/base/noise.h"
#include "render/buildings/structure_mesh.h"

// What the meshes of structures are made with. Only they include it.
namespace render {

using glm::vec3;

// Axes of a body: right, front and up, and its origin in the world, m.
struct Pose {
    glm::mat3 axes{1};
    vec3 origin{0};

    vec3 at(vec3 local) const { return origin + axes * local; }
    // Turned about an axis of the world through its origin, by an angle in rad.
    Pose turned(vec3 axis, float angle) const {
        const float c = std::cos(angle), s = std::sin(angle);
        Pose turned{*this};
        for (int i = 0; i < 3; ++i) {
            const vec3 v = axes[i];
            turned.axes[i] = c * v + s * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
        }
        return turned;
    }
};

// The surface of the world at tick 0, on the triangles that are drawn.
class FirstSurface {
  public:
    explicit FirstSurface(const BuildingGround& ground) : ground_(ground) {}

    float bedrock(glm::vec2 at) const {
        return on_triangles(at, [&](int x, int y) { return ground_.world.bedrock(x, y); });
    }
    float height(glm::vec2 at) const {
        return on_triangles(at, [&](int x, int y) {
            const float depth =
                ground_.first_depth.empty() ? ground_.world.depth(x, y) : ground_.first_depth[index(x, y)];
            return ground_.world.bedrock(x, y) + depth;
        });
    }
    // Depths of the snow and of the soil that lie there, m.
    struct Cover {
        float snow = 0, soil = 0;
    };
    Cover cover(glm::vec2 at) const {
        if (ground_.first_cover.empty()) return {};
        const glm::vec2 cell = glm::clamp(at / ground_.world.grid.dx, glm::vec2(0), last());
        const glm::vec2 cover = ground_.first_cover[index(static_cast<int>(std::lround(cell.x)),
                                                          static_cast<int>(std::lround(cell.y)))];
        const float depth = std::max(cover.x, 0.f),
                    snowy = glm::mix(ground_.snowy.x, ground_.snowy.y, cover.y);
        return {depth * snowy, depth * (1 - snowy)};
    }
    // Unit vector; x when level.
    glm::vec2 downhill(glm::vec2 at) const {
        const float step = ground_.world.grid.dx;
        const glm::vec2 fall(height(at - glm::vec2(step, 0)) - height(at + glm::vec2(step, 0)),
                             height(at - glm::vec2(0, step)) - height(at + glm::vec2(0, step)));
        return glm::length(fall) > 0 ? glm::normalize(fall) : glm::vec2(1, 0);
    }
    float cell() const { return ground_.world.grid.dx; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(ground_.world.grid.nx) +
               static_cast<std::size_t>(x);
    }
    glm::vec2 last() const { return {ground_.world.grid.nx - 1, ground_.world.grid.ny - 1}; }
    // As triangle_height.glsl does.
    template <class Height>
    float on_triangles(glm::vec2 at, const Height& z) const {
        const glm::vec2 cell = glm::clamp(at / ground_.world.grid.dx, glm::vec2(0), last());
        const int x = std::min(static_cast<int>(cell.x), ground_.world.grid.nx - 2),
                  y = std::min(static_cast<int>(cell.y), ground_.world.grid.ny - 2);
        const float u = cell.x - static_cast<float>(x), v = cell.y - static_cast<float>(y);
        const float here = z(x, y), across = z(x + 1, y + 1);
        const float aside = u >= v ? z(x + 1, y) : z(x, y + 1);
        return u >= v ? here + u * (aside - here) + v * (across - aside)
                      : here + v * (aside - here) + u * (across - aside);
    }

    const BuildingGround& ground_;
};

// Puts triangles of one structure together, in its own axes.
class StructureBuilder {
  public:
    StructureBuilder(std::vector<StructureVertex>& into, const Pose& pose, float own)
        : into_(into), pose_(pose), own_(own) {}

    const Pose& pose() const { return pose_; }
    StructureBuilder in(const Pose& pose) const { return {into_, pose, own_}; }

    // Corners counterclockwise as seen from outside. `low` and `high`: light at the first edge and at the opposite. `before`: m
    // along the first edge, of what the face continues.
    void quad(const std::array<vec3, 4>& corners, int material, float low = 1, float high = 1,
              float before = 0) {
        const auto [a, b, c, d] = corners;
        const float end = before + glm::distance(a, b), tall = glm::distance(a, d);
        const glm::vec2 faces[] = {{before, 0}, {end, 0}, {end, tall}, {before, tall}};
        const float lights[] = {low, low, high, high};
        const vec3 normal = glm::normalize(pose_.axes * glm::cross(c - a, d - b));
        for (const int i : {0, 1, 2, 0, 2, 3})
            put(corners[static_cast<std::size_t>(i)], normal, material, faces[i], lights[i]);
    }
    void triangle(vec3 a, vec3 b, vec3 c, int material) {
        const vec3 normal = glm::normalize(pose_.axes * glm::cross(b - a, c - a));
        const vec3 along = glm::normalize(b - a);
        for (const vec3 corner : {a, b, c}) {
            const vec3 from = corner - a;
            const float across = glm::dot(from, along);
            put(corner, normal, material, {across, glm::length(from - across * along)}, 1);
        }
    }
    // A body between a lower face, counterclockwise as seen from above, and the same moved by `up`.
    void prism(const std::array<vec3, 4>& low, vec3 up, int top, int sides) {
        const auto [a, b, c, d] = low;
        quad({a + up, b + up, c + up, d + up}, top);
        quad({a, d, c, b}, sides, 0.5f, 0.5f);
        for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}})
            quad({p, q, q + up, p + up}, sides);
    }
    void box(vec3 middle, vec3 half, int material) {
        const auto corner = [&](float x, float y) { return middle + half * vec3(x, y, -1); };
        prism({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, {0, 0, 2 * half.z}, material,
              material);
    }
    // From now on what is added rests on the surface at a place.
    void rest_on(glm::vec2 at, const FirstSurface& surface) { rests_ = {at, surface.height(at), 1}; }
    // The same, but it does not rise with the surface.
    void lie_on(glm::vec2 at, const FirstSurface& surface) { rests_ = {at, surface.height(at), 2}; }
    // From now on faces have this number, 0 to 1.
    void set_number(float number) { number_ = number; }

  private:
    void put(vec3 local, vec3 normal, int material, glm::vec2 face, float light) {
        into_.push_back({{pose_.at(local), static_cast<float>(material)},
                         {normal, own_},
                         {face, light, number_},
                         rests_});
    }

    std::vector<StructureVertex>& into_;
    Pose pose_;
    float own_;
    glm::vec4 rests_{0};
    float number_ = 0;
};

// A part of the mesh while its faces are added.
class OpenPart {
  public:
    explicit OpenPart(StructureMesh& mesh) : mesh_(mesh), first_(size()), far_end_(first_), near_(first_) {}
    ~OpenPart() {
        StructurePart part;
        part.near = {near_, size() - near_};
        part.far = {first_, (has_details_ ? far_end_ : size()) - first_};
        if (size() == first_) return;
        glm::vec3 lowest(1e30f), highest(-1e30f);
        for (std::size_t i = first_; i < mesh_.faces.size(); ++i) {
            lowest = glm::min(lowest, glm::vec3(mesh_.faces[i].at));
            highest = glm::max(highest, glm::vec3(mesh_.faces[i].at));
        }
        part.middle = 0.5f * (lowest + highest);
        constexpr float kMostRise = 30;  // m, of a deposit on which debris rests
        const bool rests = std::any_of(mesh_.faces.begin() + first_, mesh_.faces.end(),
                                       [](const StructureVertex& vertex) { return vertex.rests.w == 1; });
        part.radius = 0.5f * glm::distance(lowest, highest) + (rests ? kMostRise : 0.f);
        mesh_.parts.push_back(part);
    }
    OpenPart(const OpenPart&) = delete;
    OpenPart& operator=(const OpenPart&) = delete;

    // What is added from now on is seen from near only.
    void begin_details() { far_end_ = size(), has_details_ = true; }
    // The same, and what was added before is seen from afar only.
    void begin_near() { begin_details(), near_ = size(); }

  private:
    std::uint32_t size() const { return static_cast<std::uint32_t>(mesh_.faces.size()); }

    StructureMesh& mesh_;
    std::uint32_t first_, far_end_, near_;
    bool has_details_ = false;
};

// One structure while it is built: where it stands, and random numbers of its own.
class BuildingSite {
  public:
    BuildingSite(const Structure& structure, const FirstSurface& surface, std::size_t number)
        : structure_(structure), surface_(surface), number_(static_cast<int>(number)) {
        const auto heading = static_cast<float>(glm::radians(structure.heading_deg));
        const glm::vec2 front(std::sin(heading), std::cos(heading));
        const glm::vec2 at(structure.at);
        pose_.axes = glm::mat3(vec3(front.y, -front.x, 0), vec3(front, 0), vec3(0, 0, 1));
        const FirstSurface::Cover cover = surface.cover(at);
        snow_ = cover.snow;
        // Those who build in snow build a little higher, and on soil not down to the bedrock.
        pose_.origin =
            vec3(at, surface.bedrock(at) + std::min(0.5f * snow_, 0.8f) + std::min(cover.soil, 1.2f));
        if (structure.kind == StructureKind::kHouse) settle();
    }

    const Pose& pose() const { return pose_; }
    const Structure& structure() const { return structure_; }
    StructureState state() const { return structure_.state; }
    // Of a house: the lowest ground under it, m above its origin.
    float lowest() const { return lowest_; }
    glm::vec2 at() const { return glm::vec2(structure_.at); }
    float snow() const { return snow_; }
    const FirstSurface& surface() const { return surface_; }
    float own(int kind) const { return hash(number_, kind, kPeriod, 34); }
    float between(float least, float most, int kind) const { return std::lerp(least, most, own(kind)); }
    vec3 downhill() const { return {surface_.downhill(at()), 0}; }

  private:
    static constexpr int kPeriod = 1 << 20;

    // A house may be as large as a slope. Its floor is so high that uphill a good part of it looks out. It is known by
    // its place, so that it looks the same whatever else is built.
    void settle() {
        const glm::dvec2 half = half_footprint(structure_);
        float low = pose_.origin.z, high = low;
        constexpr int kSamples = 4;
        for (int i = -kSamples; i <= kSamples; ++i)
            for (int j = -kSamples; j <= kSamples; ++j) {
                const vec3 at = pose_.at({half.y * i / kSamples, half.x * j / kSamples, 0});
                const float z = surface_.bedrock(glm::vec2(at));
                low = std::min(low, z), high = std::max(high, z);
            }
        pose_.origin.z = std::max(pose_.origin.z, high - 0.4f * static_cast<float>(structure_.height_m));
        lowest_ = low - pose_.origin.z;
        number_ =
            static_cast<int>(std::llround(10 * structure_.at.x + 7919 * structure_.at.y) & (kPeriod - 1));
    }

    const Structure& structure_;
    const FirstSurface& surface_;
    int number_;
    Pose pose_;
    float snow_ = 0, lowest_ = 0;
};

// A heap of beams and boards that drift downhill and rest on whatever lies there now.
void add_debris(const BuildingSite& site, StructureBuilder& into, int beams, float reach, float longest);

}  // namespace render
