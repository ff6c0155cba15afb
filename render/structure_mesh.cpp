#include "render/structure_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/noise.h"
#include "render/ramp.h"

namespace render {
namespace {

using glm::vec3;
constexpr int kOwnPeriod = 1 << 20;
constexpr float kLongestBuiltShadow = 60;  // m

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
    // Depth of the snow that lies there, m.
    float snow(glm::vec2 at) const {
        if (ground_.first_cover.empty()) return 0;
        const glm::vec2 cell = glm::clamp(at / ground_.world.grid.dx, glm::vec2(0), last());
        const glm::vec2 cover = ground_.first_cover[index(static_cast<int>(std::lround(cell.x)),
                                                          static_cast<int>(std::lround(cell.y)))];
        return std::max(cover.x, 0.f) * glm::mix(ground_.snowy.x, ground_.snowy.y, cover.y);
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

    // Corners counterclockwise as seen from outside. `low` and `high`: light at the first edge and at the opposite.
    void quad(const std::array<vec3, 4>& corners, int material, float low = 1, float high = 1) {
        const auto [a, b, c, d] = corners;
        const float wide = glm::distance(a, b), tall = glm::distance(a, d);
        const glm::vec2 faces[] = {{0, 0}, {wide, 0}, {wide, tall}, {0, tall}};
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
        snow_ = surface.snow(at);
        // Those who build in snow build a little higher.
        pose_.origin = vec3(at, surface.bedrock(at) + std::min(0.5f * snow_, 0.8f));
    }

    const Pose& pose() const { return pose_; }
    StructureState state() const { return structure_.state; }
    glm::vec2 at() const { return glm::vec2(structure_.at); }
    float snow() const { return snow_; }
    const FirstSurface& surface() const { return surface_; }
    float own(int kind) const { return hash(number_, kind, kOwnPeriod, 34); }
    float between(float least, float most, int kind) const { return std::lerp(least, most, own(kind)); }
    vec3 downhill() const { return {surface_.downhill(at()), 0}; }

  private:
    const Structure& structure_;
    const FirstSurface& surface_;
    int number_;
    Pose pose_;
    float snow_ = 0;
};

// A heap of beams and boards that drift downhill and rest on whatever lies there now.
void add_debris(const BuildingSite& site, StructureBuilder& into, int beams, float reach, float longest) {
    for (int i = 0; i < beams; ++i) {
        const int kind = 100 + 8 * i;
        const float away = reach * std::sqrt(site.own(kind)), angle = 6.2832f * site.own(kind + 1);
        const vec3 middle = site.pose().origin + away * vec3(std::cos(angle), std::sin(angle), 0) +
                            site.downhill() * (0.8f * reach * site.own(kind + 2));
        Pose pose{glm::mat3(1), vec3(glm::vec2(middle), 0)};
        pose = pose.turned({0, 0, 1}, 6.2832f * site.own(kind + 3));
        pose = pose.turned(pose.axes[0], site.between(-0.5f, 0.5f, kind + 4));
        pose.origin.z = site.surface().height(glm::vec2(middle)) + site.between(-0.1f, 0.5f, kind + 5);
        StructureBuilder beam = into.in(pose);
        beam.rest_on(glm::vec2(middle), site.surface());
        const bool board = site.own(kind + 6) < 0.35f;
        const float half = 0.5f * longest * site.between(0.4f, 1, kind + 7);
        beam.box({0, 0, 0}, board ? vec3(0.7f, half, 0.06f) : vec3(0.14f, half, 0.14f),
                 board ? BUILT_ROOF : BUILT_WOOD);
    }
}

// Windows in a row on a wall.
struct Windows {
    vec3 middle, right;  // of the row; unit vector along it
    int count;
    float apart;  // m
};

constexpr float kHalfWindow = 0.55f, kHalfTall = 0.6f;  // m

template <class Add>
void for_each_window(const Windows& row, const Add& add) {
    const vec3 out = 0.04f * glm::cross(row.right, vec3(0, 0, 1));
    for (int i = 0; i < row.count; ++i)
        add(row.middle + out +
            row.right * (row.apart * (static_cast<float>(i) - 0.5f * static_cast<float>(row.count - 1))));
}

void add_pane(StructureBuilder& into, vec3 middle, vec3 wide, int material) {
    const vec3 tall(0, 0, kHalfTall);
    into.quad({middle - wide - tall, middle + wide - tall, middle + wide + tall, middle - wide + tall},
              material);
}

void add_windows(const BuildingSite& site, StructureBuilder& into, const Windows& row, int material) {
    for_each_window(row, [&](vec3 middle) {
        into.set_number(
            site.own(500 + static_cast<int>(std::lround(8 * (middle.x + 31 * middle.y + 7 * middle.z)))));
        add_pane(into, middle, kHalfWindow * row.right, material);
    });
}

void add_shutters(StructureBuilder& into, const Windows& row) {
    const vec3 out = 0.02f * glm::cross(row.right, vec3(0, 0, 1));
    for_each_window(row, [&](vec3 middle) {
        for (const float side : {-0.85f, 0.85f})
            add_pane(into, middle + side * row.right + out, 0.27f * row.right, BUILT_DARK);
    });
}

// One side of a roof, from a share of its length to another, with the snow on it. `side`: −1 left, 1 right.
void add_roof(const BuildingSite& site, StructureBuilder& into, float side, float from, float to, float wide,
              float long_, float eave, float ridge) {
    constexpr float kOver = 0.9f, kOverEnd = 1.1f, kThick = 0.22f;
    const float slope = (ridge - eave) / wide;
    const auto low = [&](float share, float in) {
        const float y = std::lerp(-long_ - kOverEnd, long_ + kOverEnd, share);
        const float x = std::lerp(wide + kOver, 0.f, in);
        return vec3(side * x, y, ridge - slope * x);
    };
    const auto slab = [&](float first, float last, float rise, float thick, int material) {
        const vec3 up(0, 0, rise);
        // Counterclockwise on either side.
        const float one = side > 0 ? first : last, other = side > 0 ? last : first;
        into.prism({low(one, 0) + up, low(other, 0) + up, low(other, 1) + up, low(one, 1) + up},
                   {0, 0, thick}, material, material == BUILT_ROOF ? BUILT_WOOD : material);
    };
    slab(from, to, 0, kThick, BUILT_ROOF);
    const float snow = std::min(0.15f + 0.4f * site.snow(), 0.75f);
    const float margin = 0.012f;
    if (site.snow() > 0.1f) slab(std::max(from, margin), std::min(to, 1 - margin), kThick, snow, BUILT_SNOW);
}

void add_hut(const BuildingSite& site, std::vector<StructureVertex>& faces, OpenPart& part) {
    StructureBuilder hut(faces, site.pose(), site.own(0));
    const float long_ = static_cast<float>(kHutLength) / 2 - 0.6f * site.own(1);
    const float wide = static_cast<float>(kHutWidth) / 2 - 0.7f * site.own(2);
    const float eave = 4.9f - 0.8f * site.own(3), ridge = eave + 0.47f * wide, base = 0.9f, deep = 6;
    if (site.state() == StructureState::kDestroyed) {
        hut.box({0, 0, (base - deep) / 2}, {wide + 0.1f, long_ + 0.1f, (base + deep) / 2}, BUILT_STONE);
        add_debris(site, hut, 34, 10, 7);
        return;
    }
    const bool whole = site.state() == StructureState::kIntact;

    hut.box({0, 0, (base - deep) / 2}, {wide + 0.12f, long_ + 0.12f, (base + deep) / 2}, BUILT_STONE);
    const auto wall = [&](vec3 a, vec3 b) {
        hut.quad({a, b, b + vec3(0, 0, eave - base), a + vec3(0, 0, eave - base)}, BUILT_WOOD, 1, 0.62f);
    };
    const vec3 back_left(-wide, -long_, base), back_right(wide, -long_, base), front_right(wide, long_, base),
        front_left(-wide, long_, base);
    wall(back_left, back_right), wall(back_right, front_right), wall(front_right, front_left),
        wall(front_left, back_left);
    const vec3 up(0, 0, eave - base);
    hut.triangle(back_left + up, back_right + up, {0, -long_, ridge}, BUILT_WOOD);
    hut.triangle(front_right + up, front_left + up, {0, long_, ridge}, BUILT_WOOD);

    // Behind a broken window there is no light.
    const int glass = whole ? BUILT_WINDOW : BUILT_DARK;
    const vec3 right(1, 0, 0), front(0, 1, 0);
    const Windows rows[] = {{{0, long_, base + 3.1f}, -right, 3, 2.3f},
                            {{-1.4f, long_, base + 1.1f}, -right, 2, 2.3f},
                            {{wide, 0, base + 1.5f}, front, 3, 2.8f},
                            {{-wide, 0, base + 1.5f}, -front, 3, 2.8f},
                            {{0, -long_, base + 1.5f}, right, 2, 2.8f}};
    for (const Windows& row : rows) add_windows(site, hut, row, glass);

    add_roof(site, hut, -1, 0, 1, wide, long_, eave, ridge);
    if (whole) {
        add_roof(site, hut, 1, 0, 1, wide, long_, eave, ridge);
    } else {
        // Half of the other side is gone: rafters stand bare, and boards lie around.
        add_roof(site, hut, 1, 0, 0.45f, wide, long_, eave, ridge);
        for (int i = 0; i < 4; ++i) {
            const float y = long_ * (0.05f + 0.3f * static_cast<float>(i));
            StructureBuilder rafter = hut;
            const vec3 low(wide + 0.5f, y, eave - 0.25f), high(0, y, ridge - 0.05f), thick(0, 0.16f, 0);
            rafter.prism({low, low + thick, high + thick, high}, {0, 0, 0.2f}, BUILT_WOOD, BUILT_WOOD);
        }
        add_debris(site, hut, 12, 8, 5);
    }
    hut.box({-0.4f * wide, -0.35f * long_, ridge - 0.3f}, {0.45f, 0.45f, 1.1f}, BUILT_STONE);

    part.begin_details();
    for (const Windows& row : rows) add_shutters(hut, row);
    hut.quad({vec3(3, long_ + 0.04f, base), vec3(2, long_ + 0.04f, base), vec3(2, long_ + 0.04f, base + 2.1f),
              vec3(3, long_ + 0.04f, base + 2.1f)},
             BUILT_DARK);
    // A balcony under the gable.
    hut.box({0, long_ + 0.6f, base + 2.2f}, {wide, 0.6f, 0.08f}, BUILT_WOOD);
    hut.box({0, long_ + 1.15f, base + 2.7f}, {wide, 0.05f, 0.35f}, BUILT_WOOD);
}

void add_station(const BuildingSite& site, std::vector<StructureVertex>& faces) {
    StructureBuilder station(faces, site.pose(), site.own(0));
    const float long_ = static_cast<float>(kStationLength) / 2, wide = static_cast<float>(kStationWidth) / 2;
    const float high = static_cast<float>(kStationHeight), deep = 6;
    station.box({0, 0, (0.3f - deep) / 2}, {wide, long_, (0.3f + deep) / 2}, BUILT_STONE);
    if (site.state() == StructureState::kDestroyed) {
        add_debris(site, station, 22, 9, 6);
        return;
    }
    for (const float side : {-1.f, 1.f})
        station.box({0, side * 0.6f * long_, 1.8f}, {0.5f, 0.5f, 1.8f}, BUILT_STEEL);
    // The wheel under its roof.
    station.box({0, 0, high - 3.1f}, {wide - 0.3f, 0.8f * long_, 0.2f}, BUILT_STEEL);
    station.box({0, 0, high - 1.4f}, {wide, long_, 1.1f},
                site.state() == StructureState::kIntact ? BUILT_ROOF : BUILT_DARK);
    add_windows(site, station, {{wide, 0, high - 1.4f}, {0, 1, 0}, 2, 3}, BUILT_WINDOW);
    add_windows(site, station, {{-wide, 0, high - 1.4f}, {0, -1, 0}, 2, 3}, BUILT_WINDOW);
    if (site.snow() > 0.1f) station.box({0, 0, high + 0.05f}, {wide - 0.1f, long_ - 0.1f, 0.35f}, BUILT_SNOW);
    if (site.state() == StructureState::kDamaged) add_debris(site, station, 10, 7, 5);
}

// The head of a pylon or station: where the ropes run, left and right of its middle.
struct RopeHead {
    vec3 left, right;
    bool holds;  // the rope hangs between two that hold; else it lies where it fell
};

constexpr float kRopesApart = 4.6f;

// A pylon as it stands, leans or lies.
Pose leaning(const BuildingSite& site) {
    const float angle = site.state() == StructureState::kDamaged     ? 0.35f
                        : site.state() == StructureState::kDestroyed ? 1.5f
                                                                     : 0.f;
    Pose pose = site.pose();
    if (angle > 0) pose = pose.turned(glm::cross(vec3(0, 0, 1), site.downhill()), angle);
    return pose;
}

void add_pylon(const BuildingSite& site, std::vector<StructureVertex>& faces) {
    const float high = static_cast<float>(kPylonHeight);
    StructureBuilder foot(faces, site.pose(), site.own(0));
    foot.box({0, 0, -2.2f}, {0.9f, 0.9f, 2.6f}, BUILT_STONE);
    StructureBuilder mast = foot.in(leaning(site));
    if (site.state() == StructureState::kDestroyed) mast.rest_on(site.at(), site.surface());
    constexpr int kSides = 6;
    const auto rim = [&](int i, float radius, float z) {
        const float angle = 6.2832f * static_cast<float>(i) / kSides;
        return vec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    for (int i = 0; i < kSides; ++i)
        mast.quad({rim(i, 0.5f, -1), rim(i + 1, 0.5f, -1), rim(i + 1, 0.32f, high), rim(i, 0.32f, high)},
                  BUILT_STEEL);
    mast.box({0, 0, high - 0.2f}, {kRopesApart / 2 + 0.3f, 0.22f, 0.25f}, BUILT_STEEL);
    for (const float side : {-1.f, 1.f}) {
        mast.box({side * kRopesApart / 2, 0, high - 0.55f}, {0.18f, 1.7f, 0.2f}, BUILT_STEEL);
        mast.box({side * kRopesApart / 2, 0, high + 0.35f}, {0.5f, 1.5f, 0.05f}, BUILT_STEEL);  // a catwalk
    }
}

RopeHead rope_head(const BuildingSite& site, StructureKind kind) {
    const bool pylon = kind == StructureKind::kPylon;
    const float z = static_cast<float>(pylon ? kPylonHeight - 0.4 : kStationHeight - 3.1);
    const Pose pose = pylon ? leaning(site) : site.pose();
    const bool holds = site.state() != StructureState::kDestroyed;
    return {pose.at({-kRopesApart / 2, 0, z}), pose.at({kRopesApart / 2, 0, z}), holds};
}

// A piece of rope as a ribbon that is turned to the eye.
void add_rope(vec3 from, vec3 to, float half, std::vector<RopeVertex>& ropes) {
    const glm::vec4 along(glm::normalize(to - from), half);
    for (const auto& [at, side] :
         {std::pair{from, -1.f}, {from, 1.f}, {to, 1.f}, {from, -1.f}, {to, 1.f}, {to, -1.f}})
        ropes.push_back({{at, side}, along});
}

// A rope between two heads, with the chairs that hang from it.
void add_span(vec3 from, vec3 to, bool holds, float first_chair, StructureMesh& mesh) {
    constexpr int kPieces = 8;
    constexpr float kRopeHalf = 0.035f, kChairsApart = 24;
    const float length = glm::distance(from, to), sag = (holds ? 0.02f : 0.07f) * length;
    const auto at = [&](float t) { return glm::mix(from, to, t) - vec3(0, 0, 4 * sag * t * (1 - t)); };
    for (int i = 0; i < kPieces; ++i)
        add_rope(at(static_cast<float>(i) / kPieces), at(static_cast<float>(i + 1) / kPieces), kRopeHalf,
                 mesh.ropes);
    if (!holds) return;
    const vec3 flat = glm::normalize(vec3(glm::vec2(to - from), 0));
    OpenPart chairs(mesh);
    chairs.begin_details();
    const int chairs_here = static_cast<int>(std::max((length - 4 - first_chair) / kChairsApart + 1, 0.f));
    for (int i = 0; i < chairs_here; ++i) {
        const vec3 grip = at((first_chair + kChairsApart * static_cast<float>(i)) / length);
        Pose pose{glm::mat3(vec3(flat.y, -flat.x, 0), flat, vec3(0, 0, 1)), grip};
        StructureBuilder chair(mesh.faces, pose, 0.5f);
        add_rope(grip, grip - vec3(0, 0, 2.3f), 0.05f, mesh.ropes);
        chair.box({0, 0.1f, -2.6f}, {1.1f, 0.3f, 0.06f}, BUILT_DARK);
        chair.box({0, -0.2f, -2.2f}, {1.1f, 0.05f, 0.35f}, BUILT_DARK);
    }
}

void add_lift(const Structures& structures, const Lift& lift, const FirstSurface& surface,
              StructureMesh& mesh) {
    for (std::size_t i = lift.first; i + 1 < lift.first + lift.count; ++i) {
        const Structure &lower = structures.all[i], &upper = structures.all[i + 1];
        const RopeHead a = rope_head(BuildingSite(lower, surface, i), lower.kind),
                       b = rope_head(BuildingSite(upper, surface, i + 1), upper.kind);
        const bool holds = a.holds && b.holds;
        add_span(a.left, b.left, holds, 8, mesh);
        add_span(b.right, a.right, holds, 16, mesh);
    }
}

// A line across a road, where it is built.
struct RoadSection {
    glm::vec2 middle, across;  // m; unit vector to the right
    float way;                 // m, from the beginning of the road
    bool snowy;
};

// Points of a section: outward from the middle by half widths and metres, and a rise, m.
struct RoadEdge {
    float half_widths, beyond, rise;
};
constexpr RoadEdge kNearEdges[] = {{-1, -1.8f, -0.15f}, {-1, -0.8f, 0.7f}, {-1, 0, 0.12f},
                                   {1, 0, 0.12f},       {1, 0.8f, 0.7f},   {1, 1.8f, -0.15f}};
constexpr RoadEdge kFarEdges[] = {{-1, -1.6f, 0.3f}, {-1, 0, 0.3f}, {1, 0, 0.3f}, {1, 1.6f, 0.3f}};

// Sections from one end to the other, at most `step` apart.
std::vector<RoadSection> sections_of(const Road& road, const FirstSurface& surface, float step) {
    std::vector<RoadSection> sections;
    float way = 0;
    for (std::size_t i = 0; i + 1 < road.points.size(); ++i) {
        const glm::vec2 from(road.points[i]), to(road.points[i + 1]);
        const auto along_at = [&](std::size_t k) {
            return glm::normalize(glm::vec2(road.points[k + 1] - road.points[k]));
        };
        const glm::vec2 own = along_at(i), before = i > 0 ? along_at(i - 1) : own,
                        after = i + 2 < road.points.size() ? along_at(i + 1) : own;
        const float length = glm::distance(from, to);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
        for (int k = i == 0 ? 0 : 1; k <= pieces; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(pieces);
            const glm::vec2 along = glm::normalize(t < 0.5f ? glm::mix(before + own, 2.f * own, 2 * t)
                                                            : glm::mix(2.f * own, own + after, 2 * t - 1));
            const glm::vec2 at = glm::mix(from, to, t);
            sections.push_back({at, {along.y, -along.x}, way + t * length, surface.snow(at) > 0.1f});
        }
        way += length;
    }
    return sections;
}

// What a road is made of between two sections. The banks are cleared snow.
void add_road_piece(const RoadSection& from, const RoadSection& to, std::span<const RoadEdge> edges,
                    float half, const FirstSurface& surface, StructureBuilder& into) {
    const auto point = [&](const RoadSection& section, std::size_t i) {
        const RoadEdge& edge = edges[i];
        const glm::vec2 place = section.middle + section.across * (edge.half_widths * half + edge.beyond);
        const float ragged = value_noise(section.way / 7, static_cast<float>(i), 4096, 7);
        const bool bank = edge.rise > 0.5f;
        const float rise = bank ? (section.snowy ? edge.rise * (0.6f + 0.8f * ragged) : 0.05f) : edge.rise;
        return vec3(place, surface.height(place) + rise);
    };
    into.lie_on(to.middle, surface);
    into.set_number(to.snowy ? 1.f : 0.f);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const bool middle = 2 * (i + 1) == edges.size();
        into.quad({point(from, i + 1), point(to, i + 1), point(to, i), point(from, i)},
                  to.snowy && !middle ? BUILT_BANK : BUILT_ROAD);
    }
}

void add_road(const Road& road, const FirstSurface& surface, StructureMesh& mesh) {
    constexpr double kMostPieces = 2000;
    constexpr std::size_t kPiecesPerPart = 16;
    double length = 0;
    for (std::size_t i = 1; i < road.points.size(); ++i)
        length += glm::distance(road.points[i - 1], road.points[i]);
    const float step =
        std::max(std::clamp(0.3f * surface.cell(), 0.5f, 4.f), static_cast<float>(length / kMostPieces));
    const auto half = static_cast<float>(road.width_m / 2);
    const std::vector<RoadSection> sections = sections_of(road, surface, step);
    StructureBuilder into(mesh.faces, {}, 0.5f);
    for (std::size_t first = 0; first + 1 < sections.size(); first += kPiecesPerPart) {
        const std::size_t last = std::min(first + kPiecesPerPart, sections.size() - 1);
        OpenPart part(mesh);
        for (std::size_t i = first; i < last; i += 2)
            add_road_piece(sections[i], sections[std::min(i + 2, last)], kFarEdges, half, surface, into);
        part.begin_near();
        for (std::size_t i = first; i < last; ++i)
            add_road_piece(sections[i], sections[i + 1], kNearEdges, half, surface, into);
    }
}

// Where the shadow of a point meets the ground.
vec3 shadow_of(vec3 point, const FirstSurface& surface, const vec3& sun) {
    const glm::vec2 flat(sun);
    const float length = std::max(glm::length(flat), 1e-4f), fall = std::max(sun.z, 0.01f) / length;
    const glm::vec2 away = -flat / length;
    float way = 0;
    for (int i = 0; i < 4; ++i) {
        const float above = point.z - surface.height(glm::vec2(point) + way * away);
        way = std::clamp(above / fall, 0.f, kLongestBuiltShadow);
    }
    const glm::vec2 at = glm::vec2(point) + way * away;
    return {at, surface.height(at)};
}

float turn(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The convex hull in plan, counterclockwise (Andrew 1979).
std::vector<vec3> hull(std::vector<vec3> points) {
    std::sort(points.begin(), points.end(),
              [](vec3 a, vec3 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
    std::vector<vec3> around;
    const auto add = [&](vec3 next, std::size_t least) {
        while (around.size() > least &&
               turn(glm::vec2(around[around.size() - 2]), glm::vec2(around.back()), glm::vec2(next)) <= 0)
            around.pop_back();
        around.push_back(next);
    };
    for (const vec3& next : points) add(next, 1);
    const std::size_t lower = around.size();
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    around.pop_back();
    return around;
}

void add_shadow(const BuildingSite& site, const std::vector<vec3>& corners, const vec3& sun,
                std::vector<StructureShadowVertex>& shadows) {
    std::vector<vec3> points;
    points.reserve(corners.size());
    for (const vec3& corner : corners) points.push_back(shadow_of(corner, site.surface(), sun));
    const std::vector<vec3> around = hull(std::move(points));
    const glm::vec4 foot(site.pose().origin, 0);
    for (std::size_t i = 1; i + 1 < around.size(); ++i)
        for (const std::size_t corner : {std::size_t{0}, i, i + 1})
            shadows.push_back({{around[corner], 0.9f}, foot});
}

void add_shadows(const BuildingSite& site, StructureKind kind, const vec3& sun,
                 std::vector<StructureShadowVertex>& shadows) {
    if (site.state() == StructureState::kDestroyed) return;
    const glm::vec2 half = glm::vec2(half_footprint(kind));
    const auto high = static_cast<float>(height_of(kind));
    const Pose pose = kind == StructureKind::kPylon ? leaning(site) : site.pose();
    const auto block = [&](vec3 low, vec3 top) {
        std::vector<vec3> corners;
        for (const float x : {low.x, top.x})
            for (const float y : {low.y, top.y})
                for (const float z : {low.z, top.z}) corners.push_back(pose.at({x, y, z}));
        return corners;
    };
    if (kind == StructureKind::kPylon) {
        add_shadow(site, block({-0.4f, -0.4f, 0}, {0.4f, 0.4f, high}), sun, shadows);
        add_shadow(site, block({-2.8f, -0.5f, high - 0.6f}, {2.8f, 0.5f, high}), sun, shadows);
        return;
    }
    const bool hut = kind == StructureKind::kHut;
    const float over = hut ? 0.7f : 0.f, eave = hut ? high - 2.6f : high;
    std::vector<vec3> corners =
        block({-half.y - over, -half.x - over, 0}, {half.y + over, half.x + over, eave});
    if (hut)
        for (const float end : {-1.f, 1.f}) corners.push_back(pose.at({0, end * (half.x + over), high}));
    add_shadow(site, corners, sun, shadows);
}

}  // namespace

glm::vec2 snowy(const Look& look) {
    return {ramp(0.55f, 0.75f, look.standing.g), ramp(0.55f, 0.75f, look.lower_standing.g)};
}

StructureMesh structure_mesh(const Structures& structures, const BuildingGround& ground,
                             const glm::vec3& sun) {
    const FirstSurface surface(ground);
    StructureMesh mesh;
    for (const Road& road : structures.roads) add_road(road, surface, mesh);
    for (std::size_t i = 0; i < structures.all.size(); ++i) {
        const Structure& structure = structures.all[i];
        if (structure.state == StructureState::kBuried) continue;
        const BuildingSite site(structure, surface, i);
        OpenPart part(mesh);
        switch (structure.kind) {
            case StructureKind::kHut:
                add_hut(site, mesh.faces, part);
                break;
            case StructureKind::kStation:
                add_station(site, mesh.faces);
                break;
            case StructureKind::kPylon:
                add_pylon(site, mesh.faces);
                break;
        }
        add_shadows(site, structure.kind, sun, mesh.shadows);
    }
    for (const Lift& lift : structures.lifts) add_lift(structures, lift, surface, mesh);
    return mesh;
}

}  // namespace render
