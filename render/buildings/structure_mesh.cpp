#include "render/buildings/structure_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/noise.h"
#include "render/base/ramp.h"
#include "render/buildings/house_mesh.h"
#include "render/buildings/structure_builder.h"

namespace render {
namespace {

constexpr float kLongestBuiltShadow = 60;  // m

void add_station(const BuildingSite& site, std::vector<StructureVertex>& faces) {
    StructureBuilder station(faces, site.pose(), site.own(0));
    const float long_ = static_cast<float>(sim::kStationLength) / 2,
                wide = static_cast<float>(sim::kStationWidth) / 2;
    const float high = static_cast<float>(sim::kStationHeight), deep = 6;
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
    add_station_windows(site, station, {wide, 0, high - 1.4f}, {0, 1, 0});
    add_station_windows(site, station, {-wide, 0, high - 1.4f}, {0, -1, 0});
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
    const float high = static_cast<float>(sim::kPylonHeight);
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
    const float z = static_cast<float>(pylon ? sim::kPylonHeight - 0.4 : sim::kStationHeight - 3.1);
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
void add_span(vec3 from, vec3 to, float first_chair, StructureMesh& mesh) {
    constexpr int kPieces = 8;
    constexpr float kRopeHalf = 0.035f, kChairsApart = 24;
    const float length = glm::distance(from, to), sag = 0.02f * length;
    const auto at = [&](float t) { return glm::mix(from, to, t) - vec3(0, 0, 4 * sag * t * (1 - t)); };
    for (int i = 0; i < kPieces; ++i)
        add_rope(at(static_cast<float>(i) / kPieces), at(static_cast<float>(i + 1) / kPieces), kRopeHalf,
                 mesh.ropes);
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

// What hangs from a head after the ropes to another one have torn.
void add_torn_ropes(const RopeHead& head, const RopeHead& other, const FirstSurface& surface,
                    std::vector<RopeVertex>& ropes) {
    for (const vec3& from : {head.left, head.right}) {
        const glm::vec2 toward = glm::normalize(glm::vec2(other.left - head.left));
        const glm::vec2 reaches = glm::vec2(from) + 3.f * toward, ends = glm::vec2(from) + 11.f * toward;
        const vec3 down(reaches, surface.height(reaches) + 0.3f), end(ends, surface.height(ends) + 0.1f);
        add_rope(from, glm::mix(from, down, 0.5f) - vec3(0.6f * toward, 0), 0.04f, ropes);
        add_rope(glm::mix(from, down, 0.5f) - vec3(0.6f * toward, 0), down, 0.04f, ropes);
        add_rope(down, end, 0.04f, ropes);
    }
}

void add_lift(const Structures& structures, const Lift& lift, const FirstSurface& surface,
              StructureMesh& mesh) {
    for (std::size_t i = lift.first; i + 1 < lift.first + lift.count; ++i) {
        const Structure &lower = structures.all[i], &upper = structures.all[i + 1];
        const RopeHead a = rope_head(BuildingSite(lower, surface, i), lower.kind),
                       b = rope_head(BuildingSite(upper, surface, i + 1), upper.kind);
        if (!a.holds || !b.holds) {
            if (a.holds) add_torn_ropes(a, b, surface, mesh.ropes);
            if (b.holds) add_torn_ropes(b, a, surface, mesh.ropes);
            continue;
        }
        add_span(a.left, b.left, 8, mesh);
        add_span(b.right, a.right, 16, mesh);
    }
}

// A post of a net: where it stands and where its top is, m.
struct NetPost {
    vec3 foot, top;
};

NetPost net_post(const Net& net, const FirstSurface& surface, float share, float chance) {
    const glm::vec2 at = glm::mix(glm::vec2(net.from), glm::vec2(net.to), share);
    const glm::vec2 down = surface.downhill(at);
    constexpr float kStep = 2;
    const float fall =
        (surface.bedrock(at - kStep * down) - surface.bedrock(at + kStep * down)) / (2 * kStep);
    const vec3 along = glm::normalize(vec3(down, -fall)), up = glm::normalize(vec3(fall * down, 1));
    const bool lies = net.state == StructureState::kDestroyed;
    // It leans downhill a little, as it is built; bent or thrown it leans more.
    const float lean = lies ? 1.45f : net.state == StructureState::kDamaged ? 0.35f + 0.7f * chance : 0.1f;
    const vec3 foot(at, lies ? surface.height(at) + 0.15f : surface.bedrock(at) - 0.1f);
    return {foot, foot + static_cast<float>(net.height_m) * (std::cos(lean) * up + std::sin(lean) * along)};
}

// A net between two posts: a rope along each edge, and meshes.
void add_net_bay(const NetPost& a, const NetPost& b, float sag, std::vector<RopeVertex>& ropes) {
    constexpr int kMeshes = 4;
    constexpr float kCable = 0.035f, kThread = 0.018f, kAside = 0.75f;
    const auto at = [&](float u, float v) {
        const vec3 low = glm::mix(a.foot, b.foot, u) + vec3(0, 0, 0.3f), high = glm::mix(a.top, b.top, u);
        return glm::mix(low, high, v) - vec3(0, 0, 4 * sag * u * (1 - u) * v);
    };
    for (const float v : {0.f, 1.f}) {
        add_rope(at(0, v), at(0.5f, v), kCable, ropes);
        add_rope(at(0.5f, v), at(1, v), kCable, ropes);
    }
    for (const float side : {-1.f, 1.f})
        for (int i = -kMeshes; i <= 2 * kMeshes; ++i) {
            // From `u` at the lower edge; the part between the posts.
            const float u = static_cast<float>(i) / kMeshes, aside = side * kAside;
            const float first = std::clamp((side > 0 ? -u : 1 - u) / aside, 0.f, 1.f),
                        last = std::clamp((side > 0 ? 1 - u : -u) / aside, 0.f, 1.f);
            if (last - first > 0.05f)
                add_rope(at(u + aside * first, first), at(u + aside * last, last), kThread, ropes);
        }
}

void add_net(const Net& net, std::size_t number, const FirstSurface& surface, StructureMesh& mesh) {
    constexpr float kPostsApart = 3.5f, kHalfPost = 0.13f;
    const auto high = static_cast<float>(net.height_m);
    const int bays = std::max(
        1, static_cast<int>(std::lround(glm::distance(net.from, net.to) / static_cast<double>(kPostsApart))));
    OpenPart part(mesh);
    part.begin_details();
    StructureBuilder steel(mesh.faces, {}, 0.5f);
    const auto post_at = [&](int i) {
        return net_post(net, surface, static_cast<float>(i) / static_cast<float>(bays),
                        hash(static_cast<int>(number), i, 4096, 35));
    };
    NetPost before = post_at(0);
    const vec3 across = glm::normalize(vec3(glm::vec2(net.to - net.from), 0));
    for (int i = 0; i <= bays; ++i) {
        const NetPost post = post_at(i);
        const vec3 up = glm::normalize(post.top - post.foot),
                   right = glm::normalize(across - glm::dot(across, up) * up);
        StructureBuilder body = steel.in({glm::mat3(right, glm::cross(up, right), up), post.foot});
        if (net.state == StructureState::kDestroyed) body.rest_on(glm::vec2(post.foot), surface);
        body.box({0, 0, 0.5f * high}, {kHalfPost, kHalfPost, 0.5f * high}, BUILT_STEEL);
        if (net.state != StructureState::kDestroyed) {
            const glm::vec2 anchor =
                glm::vec2(post.foot) - 1.3f * high * surface.downhill(glm::vec2(post.foot));
            add_rope(post.top, {anchor, surface.bedrock(anchor)}, 0.015f, mesh.ropes);
        }
        if (i > 0) add_net_bay(before, post, net.state == StructureState::kIntact ? 0.1f : 0.5f, mesh.ropes);
        before = post;
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
constexpr RoadEdge kNearEdges[] = {{-1, -2.6f, -0.15f}, {-1, -0.9f, 0.6f}, {-1, 0, 0.12f},
                                   {1, 0, 0.12f},       {1, 0.9f, 0.6f},   {1, 2.6f, -0.15f}};
constexpr RoadEdge kFarEdges[] = {{-1, -1.6f, 0.3f}, {-1, 0, 0.3f}, {1, 0, 0.3f}, {1, 1.6f, 0.3f}};
// Without snow to be cleared.
constexpr RoadEdge kNearBareEdges[] = {{-1, -0.5f, -0.15f}, {-1, 0, 0.12f}, {1, 0, 0.12f}, {1, 0.5f, -0.15f}};
constexpr RoadEdge kFarBareEdges[] = {{-1, 0, 0.3f}, {1, 0, 0.3f}};

// The middle of a road from point to point, its corners rounded.
std::vector<glm::vec2> rounded(const std::vector<glm::dvec2>& points) {
    constexpr double kRounded = 30;  // m before and after a corner, and at most half the way to the next
    constexpr int kPieces = 8;
    std::vector<glm::vec2> middle{points.front()};
    const auto add = [&middle](glm::vec2 at) {
        if (glm::distance(middle.back(), at) > 0.01f) middle.push_back(at);  // else it has no direction
    };
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const auto toward = [&](glm::dvec2 other) {
            const double away = glm::distance(points[i], other);
            return glm::mix(points[i], other, std::min(0.5, kRounded / away));
        };
        const glm::dvec2 from = toward(points[i - 1]), to = toward(points[i + 1]);
        for (int k = 0; k <= kPieces; ++k) {
            const double t = static_cast<double>(k) / kPieces;
            add(glm::mix(glm::mix(from, points[i], t), glm::mix(points[i], to, t), t));
        }
    }
    add(points.back());
    return middle;
}

// Sections from one end to the other, at most `step` apart.
std::vector<RoadSection> sections_of(const std::vector<glm::vec2>& middle, const FirstSurface& surface,
                                     float step) {
    std::vector<RoadSection> sections;
    float way = 0;
    for (std::size_t i = 0; i + 1 < middle.size(); ++i) {
        const glm::vec2 from = middle[i], to = middle[i + 1];
        const auto along_at = [&](std::size_t k) { return glm::normalize(middle[k + 1] - middle[k]); };
        const glm::vec2 own = along_at(i), before = i > 0 ? along_at(i - 1) : own,
                        after = i + 2 < middle.size() ? along_at(i + 1) : own;
        const float length = glm::distance(from, to);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
        for (int k = i == 0 ? 0 : 1; k <= pieces; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(pieces);
            const glm::vec2 along = glm::normalize(t < 0.5f ? glm::mix(before + own, 2.f * own, 2 * t)
                                                            : glm::mix(2.f * own, own + after, 2 * t - 1));
            const glm::vec2 at = glm::mix(from, to, t);
            sections.push_back({at, {along.y, -along.x}, way + t * length, surface.cover(at).snow > 0.1f});
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
        const float ragged = 0.6f * value_noise(section.way / 19, static_cast<float>(i), 4096, 7) +
                             0.4f * value_noise(section.way / 5, static_cast<float>(i), 4096, 8);
        const glm::vec2 place = section.middle + section.across * (edge.half_widths * half +
                                                                   edge.beyond * (0.6f + 0.8f * ragged));
        const bool bank = edge.rise > 0.5f;
        const float rise = bank ? (section.snowy ? edge.rise * (0.3f + 1.4f * ragged) : 0.05f) : edge.rise;
        return vec3(place, surface.height(place) + rise);
    };
    into.lie_on(to.middle, surface);
    into.set_number(to.snowy ? 1.f : 0.f);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const bool middle = 2 * (i + 1) == edges.size();
        into.quad({point(from, i + 1), point(to, i + 1), point(to, i), point(from, i)},
                  to.snowy && !middle ? BUILT_BANK : BUILT_ROAD, 1, 1, from.way);
    }
}

void add_road(const Road& road, const FirstSurface& surface, StructureMesh& mesh) {
    constexpr float kMostPieces = 2000;
    constexpr std::size_t kPiecesPerPart = 16;
    const std::vector<glm::vec2> middle = rounded(road.points);
    float length = 0;
    for (std::size_t i = 1; i < middle.size(); ++i) length += glm::distance(middle[i - 1], middle[i]);
    const float step = std::max(std::clamp(0.3f * surface.cell(), 0.5f, 4.f), length / kMostPieces);
    const auto half = static_cast<float>(road.width_m / 2);
    const std::vector<RoadSection> sections = sections_of(middle, surface, step);
    StructureBuilder into(mesh.faces, {}, static_cast<float>(std::min(road.width_m / ROAD_WIDEST, 1.0)));
    using Edges = std::span<const RoadEdge>;
    for (std::size_t first = 0; first + 1 < sections.size(); first += kPiecesPerPart) {
        const std::size_t last = std::min(first + kPiecesPerPart, sections.size() - 1);
        OpenPart part(mesh);
        for (std::size_t i = first; i < last; i += 2) {
            const RoadSection& to = sections[std::min(i + 2, last)];
            add_road_piece(sections[i], to, to.snowy ? Edges(kFarEdges) : kFarBareEdges, half, surface, into);
        }
        part.begin_near();
        for (std::size_t i = first; i < last; ++i) {
            const RoadSection& to = sections[i + 1];
            add_road_piece(sections[i], to, to.snowy ? Edges(kNearEdges) : kNearBareEdges, half, surface,
                           into);
        }
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

// A triangle on the ground, in pieces so small that they follow it.
void add_shadow_pieces(const std::array<vec3, 3>& corners, float longest, const glm::vec4& foot,
                       const FirstSurface& surface, std::vector<StructureShadowVertex>& shadows) {
    std::size_t from = 0;  // of its longest side
    const auto length = [&](std::size_t i) {
        return glm::distance(glm::vec2(corners[i]), glm::vec2(corners[(i + 1) % 3]));
    };
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
        if (length(i) > length(from)) from = i;
    if (length(from) <= longest) {
        for (const vec3& corner : corners) shadows.push_back({{corner, 0.9f}, foot});
        return;
    }
    const vec3 a = corners[from], b = corners[(from + 1) % 3], c = corners[(from + 2) % 3];
    const glm::vec2 middle = 0.5f * (glm::vec2(a) + glm::vec2(b));
    const vec3 between(middle, surface.height(middle));
    add_shadow_pieces({a, between, c}, longest, foot, surface, shadows);
    add_shadow_pieces({between, b, c}, longest, foot, surface, shadows);
}

// `longest`: of the sides of its triangles, m.
void add_shadow(const BuildingSite& site, const std::vector<vec3>& corners, const vec3& sun, float longest,
                std::vector<StructureShadowVertex>& shadows) {
    std::vector<vec3> points;
    points.reserve(corners.size());
    for (const vec3& corner : corners) points.push_back(shadow_of(corner, site.surface(), sun));
    const std::vector<vec3> around = hull(std::move(points));
    const glm::vec4 foot(site.pose().origin, 0);
    for (std::size_t i = 1; i + 1 < around.size(); ++i)
        add_shadow_pieces({around[0], around[i], around[i + 1]}, longest, foot, site.surface(), shadows);
}

// Of more, houses are simple, so that meshes stay below about 100 MB.
bool are_detailed(const Structures& structures) {
    constexpr std::size_t kMostInDetail = 100;
    return structures.all.size() <= kMostInDetail;
}

void add_shadows(const BuildingSite& site, const vec3& sun, bool detailed,
                 std::vector<StructureShadowVertex>& shadows) {
    constexpr float kAsItIs = 1e6f, kPiece = 8, kSimplePiece = 20;  // m
    if (site.state() == StructureState::kDestroyed) return;
    const StructureKind kind = site.structure().kind;
    const glm::vec2 half = glm::vec2(half_footprint(site.structure()));
    const auto high = static_cast<float>(height_of(site.structure()));
    const Pose pose = kind == StructureKind::kPylon ? leaning(site) : site.pose();
    const auto block = [&](vec3 low, vec3 top) {
        std::vector<vec3> corners;
        for (const float x : {low.x, top.x})
            for (const float y : {low.y, top.y})
                for (const float z : {low.z, top.z}) corners.push_back(pose.at({x, y, z}));
        return corners;
    };
    if (kind == StructureKind::kPylon) {
        add_shadow(site, block({-0.4f, -0.4f, 0}, {0.4f, 0.4f, high}), sun, kAsItIs, shadows);
        add_shadow(site, block({-2.8f, -0.5f, high - 0.6f}, {2.8f, 0.5f, high}), sun, kAsItIs, shadows);
        return;
    }
    const bool house = kind == StructureKind::kHouse;
    const bool gable = house && site.structure().material != HouseMaterial::kConcrete;
    const float shorter = std::min(half.x, half.y);
    const float over = gable ? std::min(0.7f, 0.2f * shorter) : 0.f;
    const float eave = gable ? high - std::min(0.5f * shorter, 0.42f * high) : high;
    std::vector<vec3> corners =
        block({-half.y - over, -half.x - over, 0}, {half.y + over, half.x + over, eave});
    if (gable)
        for (const float end : {-1.f, 1.f})
            corners.push_back(pose.at(half.y > half.x ? vec3(end * (half.y + over), 0, high)
                                                      : vec3(0, end * (half.x + over), high)));
    add_shadow(site, corners, sun, !house ? kAsItIs : detailed ? kPiece : kSimplePiece, shadows);
}

// Light from the windows of a house on the ground around it, in rings that fade outward. It shows when lamps are lit.
void add_window_light(const BuildingSite& site, std::vector<StructureShadowVertex>& shadows) {
    if (site.structure().kind != StructureKind::kHouse || site.state() != StructureState::kIntact) return;
    struct Ring {
        float beyond, strength;  // m from the walls
    };
    constexpr std::array<Ring, 4> kRings{{{0, 0.9f}, {2, 0.55f}, {5.5f, 0.16f}, {11, 0}}};
    constexpr int kAround = 12;
    const glm::vec2 half(half_footprint(site.structure()).y, half_footprint(site.structure()).x);
    const glm::vec4 foot(site.pose().origin, 1);
    const float bright = site.between(0.92f, 1.1f, 80);
    const auto corner = [&](const Ring& ring, int i) {
        const float angle = glm::radians(360.f) * static_cast<float>(i) / kAround;
        const glm::vec2 toward(std::cos(angle), std::sin(angle));
        // From the wall in this direction.
        const glm::vec2 wall = glm::clamp(1.5f * glm::max(half.x, half.y) * toward, -half, half);
        // Each side has its own windows.
        const float far =
            ring.beyond * (0.6f + 0.4f * bright) * site.between(0.5f, 1.05f, 90 + i % kAround / 3);
        const vec3 at = site.pose().at({wall + far * toward, 0});
        return StructureShadowVertex{
            {at.x, at.y, site.surface().height(glm::vec2(at)), bright * ring.strength}, foot};
    };
    for (std::size_t k = 0; k + 1 < kRings.size(); ++k)
        for (int i = 0; i < kAround; ++i) {
            const StructureShadowVertex a = corner(kRings[k], i), b = corner(kRings[k], i + 1),
                                        c = corner(kRings[k + 1], i), d = corner(kRings[k + 1], i + 1);
            for (const StructureShadowVertex& each : {a, c, d, a, d, b}) shadows.push_back(each);
        }
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
            case StructureKind::kHouse:
                add_house(site, mesh.faces, part, !are_detailed(structures));
                break;
            case StructureKind::kStation:
                add_station(site, mesh.faces);
                break;
            case StructureKind::kPylon:
                add_pylon(site, mesh.faces);
                break;
        }
        add_shadows(site, sun, are_detailed(structures), mesh.shadows);
        if (are_detailed(structures)) add_window_light(site, mesh.shadows);
    }
    for (const Lift& lift : structures.lifts) add_lift(structures, lift, surface, mesh);
    for (std::size_t i = 0; i < structures.nets.size(); ++i)
        if (structures.nets[i].state != StructureState::kBuried)
            add_net(structures.nets[i], i, surface, mesh);
    return mesh;
}

}  // namespace render
