#include "sim/front/texture_layers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "sim/core/check.h"
#include "sim/core/workers.h"
#include "sim/front/gradient.h"

// Coordinates are stored as offsets o from the position x: material keeps its coordinates c = x + o while it
// travels. So a vertex gets the offset of the place from which the flow comes, less the displacement. There
// it is interpolated to second order: the mean of the triangle's corners, each extrapolated by half its
// slope,
//
//     o(p) = Σ w_k (o_k + ½ G_k (p − x_k)).
//
// This is exact if offsets are quadratic and slopes are one-sided. Along a row of vertices it is Fromm's
// scheme (A method for reducing dispersion in convective difference schemes, 1968). Where the flow gives no
// offset, the mean of the neighbours' offsets gives a texture without stretch.

namespace sim::front {
namespace {

// How a vertex whose flow comes out of a front follows its neighbours: e-folds while the flow moves by one
// cell, and the share of their slopes that counts. The full slope would stretch the texture ever more; none
// would let it lag by the neighbours' differences.
constexpr float kPull = 4, kOnward = 0.3f;
// Greatest rate of change of a phase's share, where ground begins to move.
constexpr float kFadeRate = 8;  // 1/s
// Stretch changes slowly, so each vertex is checked at this interval.
constexpr double kLookAgainAfter = 0.2;  // s
constexpr double kLatencyFollows = 0.3;  // s, e-fold
constexpr float kFromNeighbours = 0.5f;  // share of a latency taken from neighbours across uncut edges

using Offsets = TextureLayers::Offsets;
using Gradients = TextureLayers::Gradients;

// As plain numbers, which compilers vectorise.
void add(Offsets& sum, const Offsets& more, float weight) {
    float* to = glm::value_ptr(sum[0]);
    const float* from = glm::value_ptr(more[0]);
    for (int i = 0; i < 2 * TextureLayers::kSheets; ++i) to[i] += weight * from[i];
}

// Computes the mean of what `tell(neighbour, sum)` adds, over neighbours across uncut edges for which
// `counts` is true. Returns false if there are none.
template <class Counts, class Tell>
bool mean_around(const Detector& detector, int vertex, const Counts& counts, const Tell& tell,
                 Offsets& mean) {
    int count = 0;
    Offsets sum{};
    for (const auto& spoke : detector.mesh().around(vertex))
        if (!detector.is_cut(spoke.edge) && counts(spoke.vertex)) {
            tell(spoke.vertex, sum);
            ++count;
        }
    if (count == 0) return false;
    mean = {};
    add(mean, sum, 1 / static_cast<float>(count));
    return true;
}

// The matrix by which to multiply differences along spokes to get the least-squares slope, over the spokes
// that count.
template <class Counts>
glm::mat2 inverse_of_fan(const Mesh& mesh, int vertex, const Counts& counts) {
    LeastSquares rows;
    for (const auto& spoke : mesh.around(vertex))
        if (counts(spoke)) rows.add(glm::dvec2(mesh.position[spoke.vertex] - mesh.position[vertex]), 0);
    return glm::mat2(rows.inverse());
}

// Limits an offset to the range of the corners of a triangle.
void limit(Offsets& offset, const Offsets& a, const Offsets& b, const Offsets& c) {
    for (int s = 0; s < TextureLayers::kSheets; ++s)
        offset[s] =
            glm::clamp(offset[s], glm::min(glm::min(a[s], b[s]), c[s]), glm::max(glm::max(a[s], b[s]), c[s]));
}

// Stretch or compression by coordinates with this gradient, as a logarithm, ≥ 0.
float stretch_of(const glm::mat2& g) {
    constexpr float kLeast = 1e-3f;  // a texture squeezed flat or turned over
    const auto [greatest, least] = singular_values(g);
    return std::max(std::abs(std::log(greatest)), std::abs(std::log(std::max(least, kLeast))));
}

// Share of the second phase at an age in latencies. A phase is invisible when it is renewed and most visible
// halfway between.
float share_of_second(double age) {
    return static_cast<float>(1 - std::abs(1 - 2 * (age - std::floor(age))));
}

}  // namespace

TextureLayers::TextureLayers(const Mesh& mesh, const LayerRule& rule)
    : mesh_(mesh),
      rule_(rule),
      upstream_(mesh),
      touched_((mesh.position.size() + kGroup - 1) / kGroup),
      torn_(mesh.triangle.size()),
      at_tear_(mesh.position.size()),
      place_(mesh.position.size(), -1),
      slot_(mesh.position.size(), -1) {
    CHECK(rule.shortest_s >= 0.25f && rule.deformation >= 0);
    now_.offset.resize(mesh.position.size());
    now_.mix.resize(mesh.position.size());
    now_.deformation.resize(mesh.position.size());
    // Reserve the maximum, so that a growing flow allocates nothing; for vertices beside fronts, more than
    // any flow needs.
    const std::size_t vertices = mesh.position.size(), beside = vertices / 4;
    for (std::vector<int>* list : {&now_.moving, &came_to_rest_, &stranded_, &region_, &number_, &due_})
        list->reserve(vertices);
    carried_.reserve(vertices);
    is_stranded_.reserve(vertices);
    latency_.reserve(vertices);
    torn_list_.reserve(mesh.triangle.size());
    torn_vertices_.reserve(vertices);
    slope_.reserve(vertices);
    inverse_.reserve(vertices);
    for (int v = 0; v < mesh.vertices(); ++v)
        inverse_.push_back(inverse_of_fan(mesh, v, [](const Mesh::Spoke&) { return true; }));
    for (std::vector<int>* list : {&now_.beside, &beside_before_}) list->reserve(4 * beside);
    for (std::vector<Gradients>* list : {&now_.gradient, &gradient_before_}) list->reserve(beside);
}

void TextureLayers::carry(const Tracker& tracker, std::span<const glm::vec2> velocity, double dt,
                          Workers& workers) {
    CHECK(dt > 0 && velocity.size() == now_.offset.size());
    const Detector& detector = tracker.detector();
    const double before = now_.time;
    now_.time += dt;
    ++now_.steps;

    for (const int v : now_.moving) place_[v] = -1;
    came_to_rest_.swap(now_.moving);
    now_.moving.clear();
    for (int v = 0; v < mesh_.vertices(); ++v)
        if (velocity[v] != glm::vec2(0, 0)) {
            place_[v] = static_cast<int>(now_.moving.size());
            now_.moving.push_back(v);
        }
    std::erase_if(came_to_rest_, [this](int v) { return place_[v] >= 0; });
    for (const std::vector<int>* list : {&now_.moving, &came_to_rest_})  // nothing changes elsewhere
        for (const int v : *list) touched_[static_cast<std::size_t>(v) / kGroup] = true;

    // Advect with the flow first. Then complete, from neighbours already advected, the vertices whose flow
    // comes out of a front, and after them those that a front has passed.
    tear(detector);
    find_slopes(detector, workers);
    follow(velocity, dt, workers);
    if (rule_.reseed) {
        pull_stranded(detector, velocity, dt);
        reseed(detector);
        lay_down(detector);
    }

    // Renew a phase last, because it takes the mean of its region's final offsets.
    renew(detector, before);
}

void TextureLayers::settle(const Tracker& tracker, double dt, Workers& workers) {
    fade(dt);
    choose_latency(tracker.detector(), dt, workers);
    find_front_gradients(tracker.detector(), workers);
}

void TextureLayers::restore(const Memory& memory) {
    CHECK(memory.offset.size() == now_.offset.size());
    for (const int v : now_.beside) slot_[v] = -1;
    for (const int v : now_.moving) place_[v] = -1;
    now_ = memory;
    for (std::size_t i = 0; i < now_.moving.size(); ++i) place_[now_.moving[i]] = static_cast<int>(i);
    for (std::size_t i = 0; i < now_.beside.size(); ++i) slot_[now_.beside[i]] = static_cast<int>(i);
    find_touched();
}

void TextureLayers::find_touched() {
    const auto differ = [](const auto& a, const auto& b) {
        return !std::ranges::equal(std::as_bytes(std::span(&a, 1)), std::as_bytes(std::span(&b, 1)));
    };
    const Offsets no_offset{};
    const Mix no_mix;
    std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
    for (std::size_t v = 0; v < now_.offset.size(); ++v)
        if (differ(now_.offset[v], no_offset) || differ(now_.mix[v], no_mix)) touched_[v / kGroup] = true;
}

void TextureLayers::tear(const Detector& detector) {
    for (const int t : torn_list_) torn_[t] = false;
    for (const int v : torn_vertices_) at_tear_[v] = false;
    torn_list_.clear();
    torn_vertices_.clear();
    if (!rule_.reseed) return;  // as in the paper, coordinates are mixed across a front
    const auto tear_beside = [this](int edge) {
        for (const int t : mesh_.edge_triangle[edge])
            if (t >= 0 && !torn_[t]) {
                torn_[t] = true;
                torn_list_.push_back(t);
            }
        for (const int v : {mesh_.edge[edge].a, mesh_.edge[edge].b})
            if (!at_tear_[v]) {
                at_tear_[v] = true;
                torn_vertices_.push_back(v);
            }
    };
    for (const int edge : detector.cut()) tear_beside(edge);
    // Where a front has just left, a corner still has coordinates of the other side.
    for (const auto& gone : detector.vanished()) tear_beside(gone.edge);
}

// Computes the slope of the offsets at each moving vertex, on its own side.
void TextureLayers::find_slopes(const Detector& detector, Workers& workers) {
    slope_.resize(now_.moving.size());
    workers.each_band(static_cast<int>(now_.moving.size()), [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const int v = now_.moving[i];
            // A vertex that a front has just passed still has coordinates of the other side.
            const bool flipped = at_tear_[v] && detector.has_flipped(v);
            const auto counts = [&](const Mesh::Spoke& spoke) {
                return !at_tear_[v] ||
                       (!detector.is_cut(spoke.edge) && detector.has_flipped(spoke.vertex) == flipped);
            };
            const glm::mat2 inverse = at_tear_[v] ? inverse_of_fan(mesh_, v, counts) : inverse_[v];
            slope_[i] = {};
            for (const auto& spoke : mesh_.around(v)) {
                if (!counts(spoke)) continue;
                const glm::vec2 weight = inverse * (mesh_.position[spoke.vertex] - mesh_.position[v]);
                Offsets beyond = now_.offset[spoke.vertex];
                add(beyond, now_.offset[v], -1);
                add(slope_[i].x, beyond, weight.x);
                add(slope_[i].y, beyond, weight.y);
            }
        }
    });
}

void TextureLayers::add_slope(int vertex, const glm::vec2& way, Offsets& sum) const {
    const Slope& slope = slope_[place_[vertex]];
    add(sum, slope.x, way.x);
    add(sum, slope.y, way.y);
}

void TextureLayers::follow(std::span<const glm::vec2> velocity, double dt, Workers& workers) {
    carried_.resize(now_.moving.size());
    is_stranded_.assign(now_.moving.size(), false);
    workers.each_band(static_cast<int>(now_.moving.size()), [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const int v = now_.moving[i];
            const glm::vec2 way = static_cast<float>(-dt) * velocity[v];
            const auto from = upstream_.find(v, way, torn_);
            is_stranded_[i] = !from;
            Offsets& offset = carried_[i];
            if (from) {
                const auto& corner = mesh_.triangle[from->triangle];
                const glm::vec2 at = mesh_.position[v] + way;
                offset = {};
                for (int k = 0; k < 3; ++k) {
                    add(offset, now_.offset[corner[k]], from->weight[k]);
                    // Ground at rest has no slope of its own.
                    add_slope(place_[corner[k]] >= 0 ? corner[k] : v,
                              from->weight[k] / 2 * (at - mesh_.position[corner[k]]), offset);
                }
                limit(offset, now_.offset[corner[0]], now_.offset[corner[1]], now_.offset[corner[2]]);
            } else {
                offset = now_.offset[v];  // keeps its offset relative to rigid surroundings
            }
            for (glm::vec2& o : offset) o += way;
        }
    });
    stranded_.clear();
    for (std::size_t i = 0; i < now_.moving.size(); ++i) {
        now_.offset[now_.moving[i]] = carried_[i];
        if (is_stranded_[i]) stranded_.push_back(now_.moving[i]);
    }
}

void TextureLayers::pull_stranded(const Detector& detector, std::span<const glm::vec2> velocity, double dt) {
    // Compute all new offsets before storing any, so that the order of vertices does not matter.
    carried_.resize(stranded_.size());
    const auto settled = [&](int v) { return !detector.has_flipped(v); };
    for (std::size_t i = 0; i < stranded_.size(); ++i) {
        const int v = stranded_[i];
        const auto tell = [&](int neighbour, Offsets& sum) {
            add(sum, now_.offset[neighbour], 1);
            if (place_[neighbour] >= 0)
                add_slope(neighbour, kOnward * (mesh_.position[v] - mesh_.position[neighbour]), sum);
        };
        Offsets mean = now_.offset[v];
        mean_around(detector, v, settled, tell, mean);
        const float cells = static_cast<float>(dt) * glm::length(velocity[v]) / mesh_.cell[v];
        const float share = 1 - std::exp(-kPull * cells);
        for (int s = 0; s < kSheets; ++s)
            carried_[i][s] = now_.offset[v][s] + share * (mean[s] - now_.offset[v][s]);
    }
    for (std::size_t i = 0; i < stranded_.size(); ++i) now_.offset[stranded_[i]] = carried_[i];
}

void TextureLayers::reseed(const Detector& detector) {
    const auto settled = [&](int v) { return !detector.has_flipped(v); };
    const auto tell = [&](int neighbour, Offsets& sum) { add(sum, now_.offset[neighbour], 1); };
    for (const int v : detector.flipped())
        if (place_[v] >= 0) mean_around(detector, v, settled, tell, now_.offset[v]);
}

// A vertex that comes to rest takes the mean of deposited neighbours; the first to stop keeps its own offset.
void TextureLayers::lay_down(const Detector& detector) {
    const auto lies = [&](int v) {
        return place_[v] < 0 && has_moved(v) &&
               !std::binary_search(came_to_rest_.begin(), came_to_rest_.end(), v);
    };
    const auto tell = [&](int neighbour, Offsets& sum) { add(sum, now_.offset[neighbour], 1); };
    for (const int v : came_to_rest_) mean_around(detector, v, lies, tell, now_.offset[v]);
}

bool TextureLayers::is_renewed(int sheet, double before) const {
    const double latency = latency_s(sheet / 2), lead = sheet % 2 ? 0 : 0.5;
    return std::floor(now_.time / latency + lead) > std::floor(before / latency + lead);
}

double TextureLayers::age_s(int sheet) const {
    const double latency = latency_s(sheet / 2), age = now_.time / latency + (sheet % 2 ? 0 : 0.5);
    return (age - std::floor(age)) * latency;
}

void TextureLayers::renew(const Detector& detector, double before) {
    bool any = false;
    for (int s = 0; s < kSheets; ++s) any = any || is_renewed(s, before);
    if (!any) return;
    find_regions(detector);
    sum_.assign(static_cast<std::size_t>(regions_), {});
    for (std::size_t i = 0; i < now_.moving.size(); ++i) {
        Sum& of_region = sum_[number_[i]];
        ++of_region.count;
        for (int s = 0; s < kSheets; ++s) of_region.offset[s] += glm::dvec2(now_.offset[now_.moving[i]][s]);
    }
    for (std::size_t i = 0; i < now_.moving.size(); ++i) {
        const Sum& of_region = sum_[number_[i]];
        for (int s = 0; s < kSheets; ++s)
            if (is_renewed(s, before))
                now_.offset[now_.moving[i]][s] = glm::vec2(of_region.offset[s] / of_region.count);
    }
    for (std::size_t i = 0; i < now_.beside.size(); ++i)
        for (int s = 0; s < kSheets; ++s)
            if (place_[now_.beside[i]] >= 0 && is_renewed(s, before)) now_.gradient[i][s] = glm::mat2(0);
}

// Labels regions: moving vertices joined by uncut edges.
void TextureLayers::find_regions(const Detector& detector) {
    region_.resize(now_.moving.size());
    number_.resize(now_.moving.size());
    std::iota(region_.begin(), region_.end(), 0);
    const auto root = [&](int i) {
        while (region_[i] != i) i = region_[i] = region_[region_[i]];
        return i;
    };
    for (std::size_t i = 0; i < now_.moving.size(); ++i)
        for (const auto& spoke : mesh_.around(now_.moving[i])) {
            const int other = place_[spoke.vertex];
            if (other < 0 || other > static_cast<int>(i) || detector.is_cut(spoke.edge)) continue;
            const int a = root(static_cast<int>(i)), b = root(other);
            region_[std::max(a, b)] = std::min(a, b);
        }
    // Each root is the first of its region, so it has a number before the others need it.
    regions_ = 0;
    for (std::size_t i = 0; i < now_.moving.size(); ++i) {
        const int first = root(static_cast<int>(i));
        number_[i] = first == static_cast<int>(i) ? regions_++ : number_[static_cast<std::size_t>(first)];
    }
}

void TextureLayers::fade(double dt) {
    const float most = kFadeRate * static_cast<float>(dt);
    for (int k = 0; k < kLatencies; ++k) {
        const float share = share_of_second(now_.time / latency_s(k));
        for (const int v : now_.moving) {
            float& second = now_.mix[v].second[k];
            second += std::clamp(share - second, -most, most);
        }
    }
}

void TextureLayers::choose_latency(const Detector& detector, double dt, Workers& workers) {
    const auto period = std::max<std::int64_t>(1, std::llround(kLookAgainAfter / dt));
    const auto elapsed = static_cast<double>(period) * dt;
    due_.clear();
    for (const int v : now_.moving)
        if ((v + now_.steps) % period == 0) due_.push_back(v);
    latency_.resize(due_.size());
    const auto follow = static_cast<float>(1 - std::exp(-elapsed / kLatencyFollows));
    workers.each_band(static_cast<int>(due_.size()), [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const int v = due_[i];
            Gradients gradient{};
            find_gradients<kSheets>(detector, v, now_.offset, gradient);
            std::array<float, kLatencies>& worst = now_.deformation[v];
            for (int k = 0; k < kLatencies; ++k) {
                worst[k] *= static_cast<float>(std::exp(-elapsed / latency_s(k)));
                // A hardly visible phase may be stretched.
                const float second = now_.mix[v].second[k];
                for (int phase = 0; phase < 2; ++phase)
                    worst[k] = std::max(worst[k], std::min(1.f, 2 * (phase ? second : 1 - second)) *
                                                      stretch_of(glm::mat2(1) + gradient[2 * k + phase]));
            }
            // Take the longest latency that is within the limit, and blend toward the next by the remaining
            // margin.
            float latency = 0;
            for (int k = kLatencies - 1; k >= 0 && latency == 0; --k) {
                if (worst[k] > rule_.deformation) continue;
                latency = static_cast<float>(k);
                if (k + 1 < kLatencies) latency += (rule_.deformation - worst[k]) / (worst[k + 1] - worst[k]);
            }
            float around = 0;
            int count = 0;
            for (const auto& spoke : mesh_.around(v))
                if (!detector.is_cut(spoke.edge)) around += now_.mix[spoke.vertex].latency, ++count;
            if (count > 0) latency += kFromNeighbours * (around / static_cast<float>(count) - latency);
            latency_[i] = now_.mix[v].latency + follow * (latency - now_.mix[v].latency);
        }
    });
    for (std::size_t i = 0; i < due_.size(); ++i) now_.mix[due_[i]].latency = latency_[i];
}

void TextureLayers::find_front_gradients(const Detector& detector, Workers& workers) {
    beside_before_.swap(now_.beside);
    gradient_before_.swap(now_.gradient);
    now_.beside.clear();
    for (const int edge : detector.cut())
        for (const int v : {mesh_.edge[edge].a, mesh_.edge[edge].b}) now_.beside.push_back(v);
    std::sort(now_.beside.begin(), now_.beside.end());
    now_.beside.erase(std::unique(now_.beside.begin(), now_.beside.end()), now_.beside.end());

    now_.gradient.assign(now_.beside.size(), {});
    for (std::size_t i = 0; i < now_.beside.size(); ++i)
        if (slot_[now_.beside[i]] >= 0 && !detector.has_flipped(now_.beside[i]))
            now_.gradient[i] = gradient_before_[slot_[now_.beside[i]]];
    for (const int v : beside_before_) slot_[v] = -1;
    for (std::size_t i = 0; i < now_.beside.size(); ++i) slot_[now_.beside[i]] = static_cast<int>(i);
    workers.each_band(static_cast<int>(now_.beside.size()), [&](int first, int end) {
        for (int i = first; i < end; ++i)
            find_gradients<kSheets>(detector, now_.beside[i], now_.offset, now_.gradient[i]);
    });
}

glm::vec2 TextureLayers::offset(const CutVertex& vertex, int sheet) const {
    const glm::vec2 own = now_.offset[vertex.side][sheet];
    if (!vertex.on_front) return own;
    return carried_on(own, now_.gradient[slot_[vertex.side]][sheet],
                      vertex.position - mesh_.position[vertex.side]);
}

float TextureLayers::weight(int vertex, int sheet) const {
    const int k = sheet / 2;
    const Mix& mix = now_.mix[vertex];
    const float layer = std::max(0.f, 1 - std::abs(mix.latency - static_cast<float>(k)));
    return layer * (sheet % 2 ? mix.second[k] : 1 - mix.second[k]);
}

}  // namespace sim::front
