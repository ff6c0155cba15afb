#include "render/mountain/surroundings_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace render {
namespace {

constexpr double kSegments = 80;     // along the longer side of a ring
constexpr double kFewest = 16;       // along the shorter one
constexpr double kFirstRing = 0.01;  // distance from the border, sides
constexpr double kGrowth = 1.115;    // from one ring to the next
constexpr int kRingsInPatch = 4;
constexpr int kPatchesAround = 12;
constexpr int kHolesInPatch = 32;  // squares along a side

// A ring: its vertices in order, with the way along it. Side 0 is the south one, from 0 to 1; it goes
// counter-clockwise on to 4, where the first vertex comes again.
struct VertexRing {
    std::vector<double> way;
    std::vector<std::uint32_t> vertex;
};

class Builder {
  public:
    explicit Builder(const Surroundings& around)
        : around_(around),
          nx_(static_cast<int>(std::lround(around.size().x / around.cell())) + 1),
          ny_(static_cast<int>(std::lround(around.size().y / around.cell())) + 1) {}

    SurroundingsMesh build() {
        VertexRing inner = border();
        int number = 0;
        double step = kFirstRing * around_.side(), away = std::max(step, around_.cell());
        while (away < Surroundings::kReach * around_.side()) {
            VertexRing outer = ring(away);
            stitch(inner, outer, number++);
            inner = std::move(outer);
            step *= kGrowth;
            away += step;
        }
        stitch(inner, ring(Surroundings::kReach * around_.side()), number);
        cover_holes();
        for (auto& [key, indices] : parts_) add_patch(indices);
        return std::move(mesh_);
    }

  private:
    std::uint32_t add(glm::dvec2 at, double spacing) {
        const double reach = std::max(around_.cell(), 0.5 * spacing);
        const glm::dvec2 east(reach, 0), north(0, reach);
        const double z = around_.height(at);
        SurroundingsVertex v;
        v.at = glm::dvec3(at, z);
        v.slope = glm::dvec2(around_.height(at + east) - around_.height(at - east),
                             around_.height(at + north) - around_.height(at - north)) /
                  (2 * reach);
        v.source = around_.source(at) / around_.cell();
        v.cover = around_.cover_by_height(at);
        v.open = openness(at, z);
        mesh_.vertices.push_back(v);
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    // As in openness.comp.
    float openness(glm::dvec2 at, double z) const {
        double open = 0;
        for (int i = 0; i < 12; ++i) {
            const double angle = 0.5236 * (i + 0.5);
            const glm::dvec2 direction(std::cos(angle), std::sin(angle));
            double horizon = 0;  // tangent
            for (const double sides : {0.02, 0.045, 0.1, 0.2}) {
                const double reach = sides * around_.side();
                horizon = std::max(horizon, (around_.rough_height(at + reach * direction) - z) / reach);
            }
            open += 1 / (1 + horizon * horizon) / 12;
        }
        return static_cast<float>(open);
    }

    std::uint32_t add_on_grid(int x, int y) {
        const std::uint32_t vertex = add(around_.cell() * glm::dvec2(x, y), 0);
        mesh_.vertices[vertex].on_grid = around_.is_hole(x, y) ? 0.f : 1.f;
        return vertex;
    }

    VertexRing border() {
        VertexRing ring;
        const int length[4] = {nx_ - 1, ny_ - 1, nx_ - 1, ny_ - 1};
        for (int side = 0; side < 4; ++side)
            for (int i = 0; i < length[side]; ++i) {
                const int back = length[side] - i;
                const glm::ivec2 at[4] = {{i, 0}, {nx_ - 1, i}, {back, ny_ - 1}, {0, back}};
                ring.way.push_back(side + static_cast<double>(i) / length[side]);
                ring.vertex.push_back(grid_vertex(at[side].x, at[side].y));
            }
        return ring;
    }

    VertexRing ring(double away) {
        VertexRing ring;
        const glm::dvec2 low(-away), high = around_.size() + away;
        const glm::dvec2 corner[5] = {low, {high.x, low.y}, high, {low.x, high.y}, low};
        for (int side = 0; side < 4; ++side) {
            const double length = around_.size()[side % 2] / around_.side();
            const int segments = static_cast<int>(std::lround(std::max(kFewest, kSegments * length)));
            for (int i = 0; i < segments; ++i) {
                const double share = static_cast<double>(i) / segments;
                ring.way.push_back(side + share);
                ring.vertex.push_back(add(glm::mix(corner[side], corner[side + 1], share),
                                          glm::distance(corner[side], corner[side + 1]) / segments));
            }
        }
        return ring;
    }

    // Whether an edge is nearer to the ground in its middle than another one. A crest or a gully between two
    // rings lies on the ground with one diagonal of a square and is cut into needles with the other.
    bool is_closer(std::pair<std::uint32_t, std::uint32_t> edge,
                   std::pair<std::uint32_t, std::uint32_t> other) const {
        const auto off = [&](std::pair<std::uint32_t, std::uint32_t> ends) {
            const glm::dvec3 middle = 0.5 * (glm::dvec3(mesh_.vertices[ends.first].at) +
                                             glm::dvec3(mesh_.vertices[ends.second].at));
            return std::abs(middle.z - around_.height(middle));
        };
        return off(edge) < off(other);
    }

    // Triangles between two rings; the one that is behind advances, and at a square the one whose advance makes
    // the better diagonal.
    void stitch(const VertexRing& inner, const VertexRing& outer, int number) {
        std::size_t i = 0, o = 0;
        const auto way = [](const VertexRing& ring, std::size_t k) {
            return k < ring.way.size() ? ring.way[k] : 4.0;
        };
        const auto vertex = [](const VertexRing& ring, std::size_t k) {
            return ring.vertex[k % ring.vertex.size()];
        };
        while (i < inner.way.size() || o < outer.way.size()) {
            const bool square =
                o < outer.way.size() && i < inner.way.size() && way(outer, o + 1) == way(inner, i + 1);
            const bool outside = square ? is_closer({vertex(inner, i), vertex(outer, o + 1)},
                                                    {vertex(inner, i + 1), vertex(outer, o)})
                                        : o < outer.way.size() && (i == inner.way.size() ||
                                                                   way(outer, o + 1) < way(inner, i + 1));
            const double middle = std::min(way(outer, o), way(inner, i));
            const std::pair key{number / kRingsInPatch, static_cast<int>(middle / 4 * kPatchesAround)};
            if (outside) {
                triangle(key, vertex(outer, o), vertex(outer, o + 1), vertex(inner, i));
                ++o;
            } else {
                triangle(key, vertex(inner, i), vertex(outer, o), vertex(inner, i + 1));
                ++i;
            }
        }
    }

    // What the block's own mesh leaves out, see ground_mesh.h.
    void cover_holes() {
        for (int y = 0; y + 1 < ny_; ++y)
            for (int x = 0; x + 1 < nx_; ++x) {
                const bool across = around_.is_hole(x, y) || around_.is_hole(x + 1, y + 1);
                const bool lower = across || around_.is_hole(x + 1, y),
                           upper = across || around_.is_hole(x, y + 1);
                if (!lower && !upper) continue;
                const std::pair key{-1 - y / kHolesInPatch, x / kHolesInPatch};
                const std::uint32_t a = grid_vertex(x, y), c = grid_vertex(x + 1, y + 1);
                if (lower) triangle(key, a, grid_vertex(x + 1, y), c);
                if (upper) triangle(key, a, c, grid_vertex(x, y + 1));
            }
    }

    std::uint32_t grid_vertex(int x, int y) {
        const auto [found, is_new] = on_grid_.try_emplace({y, x}, 0);
        if (is_new) found->second = add_on_grid(x, y);
        return found->second;
    }

    void triangle(std::pair<int, int> key, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        auto& part = parts_[key];
        part.insert(part.end(), {a, b, c});
    }

    void add_patch(const std::vector<std::uint32_t>& indices) {
        SurroundingsPatch patch{static_cast<std::uint32_t>(mesh_.indices.size()),
                                static_cast<std::uint32_t>(indices.size())};
        patch.lowest = patch.highest = mesh_.vertices[indices.front()].at;
        for (const std::uint32_t i : indices) {
            patch.lowest = glm::min(patch.lowest, mesh_.vertices[i].at);
            patch.highest = glm::max(patch.highest, mesh_.vertices[i].at);
        }
        mesh_.indices.insert(mesh_.indices.end(), indices.begin(), indices.end());
        mesh_.patches.push_back(patch);
    }

    const Surroundings& around_;
    int nx_, ny_;
    SurroundingsMesh mesh_;
    std::map<std::pair<int, int>, std::uint32_t> on_grid_;
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> parts_;
};

}  // namespace

SurroundingsMesh surroundings_mesh(const Surroundings& around) {
    return around.empty() ? SurroundingsMesh() : Builder(around).build();
}

void sunlit(const Surroundings& around, const std::vector<SurroundingsVertex>& vertices, glm::dvec3 sun,
            std::vector<float>& into) {
    const double flat = std::max(std::hypot(sun.x, sun.y), 1e-3),
                 reach = Surroundings::kRoughReach * around.side();
    into.clear();
    for (const SurroundingsVertex& v : vertices) {
        const glm::dvec3 from(v.at);
        double light = 1;
        for (double t = 1.5 * around.cell(); t < reach && light > 0; t *= 1.22) {
            const glm::dvec3 p = from + sun * (t / flat);
            if (p.z > around.highest()) break;
            // A mountain edge that is far away has a wide half-shadow.
            light = std::min(light, 0.5 + (p.z - around.rough_height(p)) / (0.05 * t + 0.2 * around.cell()));
        }
        into.push_back(static_cast<float>(std::max(light, 0.0)));
    }
}

void visible_patches(const std::vector<SurroundingsPatch>& patches, const OnScreen& screen, glm::vec3 eye,
                     std::vector<const SurroundingsPatch*>& into) {
    into.clear();
    for (const SurroundingsPatch& patch : patches)
        if (!screen.box(patch.lowest, patch.highest).empty()) into.push_back(&patch);
    const auto distance = [&](const SurroundingsPatch* patch) {
        return glm::distance(eye, glm::clamp(eye, patch->lowest, patch->highest));
    };
    std::sort(into.begin(), into.end(), [&](const auto* a, const auto* b) {
        return std::pair(distance(a), a) < std::pair(distance(b), b);
    });
}

}  // namespace render
