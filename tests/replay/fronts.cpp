// The fronts of the shipped avalanches, found from velocities and compared with the depth of the rolling
// layer. The rule for avalanches uses that depth only to decide what is visible.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "game/session/world_fronts.h"
#include "sim/core/workers.h"
#include "tests/replay/play.h"

namespace game::test {
namespace {

using sim::front::Detector;
using sim::front::Mesh;
using sim::front::PointSource;
using sim::front::Rule;
using sim::front::Tracker;

struct Avalanche {
    const char* recording;
    float visible;       // least visible depth of the rolling layer, m
    double found;        // least share of edges that must be found
    double false_cuts;   // share of cuts that may be false
    double thin;         // share of cuts that may be false where half the depth is less than that
    double fit;          // limit of the root mean square distance from the front, cells
    double half, paper;  // and as a share of that of the other sources of points
};

// Cohesion slows the rim of the snow before it stops, and its skirts are wider: what is cut there is less clear.
constexpr Avalanche kAvalanches[] = {{"landslide", 0.2f, 0.98, 0.05, 0.155, 0.21, 1.1, 0.85},
                                     {"snow-avalanche", 0.1f, 0.96, 0.02, 0.13, 0.345, 1.15, 0.93}};

// Plays a recording. `look(fronts, dt, tick)` is called with the visible fronts of each tick.
template <class Look>
void watch(const Avalanche& avalanche, const Look& look) {
    const Recording recording = open(avalanche.recording);
    std::optional<game::WorldFronts> fronts;
    sim::Workers workers(1);
    play(recording, 1, recording.last_tick(), [&](const Session& now) {
        if (!fronts) fronts.emplace(now.state().grid, avalanche.visible, sim::front::LayerRule{});
        const double dt = now.state().params.tick_s;
        fronts->track(now.view(), dt, workers);
        look(*fronts, dt, now.state().tick);
    });
}

bool moves(const glm::vec2& velocity) {
    return velocity != glm::vec2(0, 0);
}

// For each vertex, half the depth of the flow around it: the mean over moving cells within kAround cells, or
// `least` if that is more; infinite if nothing moves.
//
// Local, because an avalanche's tongue is ten times as deep as its skirts, and these are fronts too; the
// mean, because a front rises to its depth within a cell or two. Within three cells, so that what is behind
// the front counts, and not only the front.
constexpr int kAround = 3;
std::vector<float> half_depth(const sim::front::Flow& flow, int columns, float least) {
    const int rows = static_cast<int>(flow.velocity.size()) / columns;
    std::vector<float> half(flow.velocity.size(), std::numeric_limits<float>::infinity());
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            float sum = 0, count = 0;
            for (int j = std::max(y - kAround, 0); j <= std::min(y + kAround, rows - 1); ++j)
                for (int i = std::max(x - kAround, 0); i <= std::min(x + kAround, columns - 1); ++i) {
                    const int v = j * columns + i;
                    if (moves(flow.velocity[v])) sum += flow.scalar[v], ++count;
                }
            if (count > 0) half[y * columns + x] = std::max(sum / count / 2, least);
        }
    return half;
}

// The edges that the contour at half the depth crosses, where the deeper end moves.
std::vector<int> crossed_by_half_depth(const Mesh& mesh, const sim::front::Flow& flow, float least) {
    const auto half = half_depth(flow, mesh.columns, least);
    std::vector<int> crossed;
    for (int e = 0; e < mesh.edges(); ++e) {
        auto [deep, other] = mesh.edge[e];
        if (flow.scalar[deep] < flow.scalar[other]) std::swap(deep, other);
        if (!moves(flow.velocity[deep])) continue;
        const float level = std::min(half[deep], half[other]);  // one for the edge
        if (flow.scalar[deep] >= level && flow.scalar[other] < level) crossed.push_back(e);
    }
    return crossed;
}

// Number of `edges` with none of `others` within one ring: no end, and no neighbour of an end, belongs to one
// of them. The contour at half the depth is about a cell behind the visible edge, and a ring is a cell.
double count_far(const Mesh& mesh, std::span<const int> edges, std::span<const int> others) {
    std::vector<char> near(mesh.position.size());
    for (const int e : others)
        for (const int v : {mesh.edge[e].a, mesh.edge[e].b}) {
            near[v] = true;
            for (const auto& spoke : mesh.around(v)) near[spoke.vertex] = true;
        }
    return static_cast<double>(std::count_if(
        edges.begin(), edges.end(), [&](int e) { return !near[mesh.edge[e].a] && !near[mesh.edge[e].b]; }));
}

struct Verdict {
    double crossed = 0, missed = 0, cut = 0, wrong = 0;  // edges, over the whole avalanche

    double found() const { return 1 - missed / crossed; }
    double false_cuts() const { return wrong / cut; }
};

// Rules scored by the contour at half the depth, or at `least` if that is more, twice a second.
std::vector<Verdict> judged(const Avalanche& avalanche, const std::vector<Rule>& rules, float least) {
    constexpr int kTicksBetween = 30;
    std::vector<Detector> detectors;
    std::vector<Verdict> verdicts(rules.size());
    watch(avalanche, [&](const game::WorldFronts& fronts, double, std::int64_t tick) {
        const Mesh& mesh = fronts.view().mesh();
        if (detectors.empty())
            for (const Rule& rule : rules) detectors.emplace_back(mesh, rule);
        for (Detector& detector : detectors) detector.update(fronts.flow());
        if (tick % kTicksBetween != 0) return;
        const auto crossed = crossed_by_half_depth(mesh, fronts.flow(), least);
        for (std::size_t i = 0; i < rules.size(); ++i) {
            const auto cut = detectors[i].cut();
            verdicts[i].crossed += static_cast<double>(crossed.size());
            verdicts[i].missed += count_far(mesh, crossed, cut);
            verdicts[i].cut += static_cast<double>(cut.size());
            verdicts[i].wrong += count_far(mesh, cut, crossed);
        }
    });
    return verdicts;
}

class AvalancheFronts : public testing::TestWithParam<Avalanche> {};

TEST_P(AvalancheFronts, are_found_at_half_the_depth_of_the_flow_around) {
    const Verdict got = judged(GetParam(), {sim::front::avalanche_rule()}, GetParam().visible).front();
    EXPECT_GT(got.crossed, 5000);
    EXPECT_GE(got.found(), GetParam().found);
    EXPECT_LE(got.false_cuts(), GetParam().false_cuts);
}

// Where the flow is less than twice the visible depth, half its depth is invisible and may be anywhere
// outside. Nothing is missed there, but more is cut.
TEST_P(AvalancheFronts, are_found_where_half_the_depth_is_invisible) {
    const Verdict got = judged(GetParam(), {sim::front::avalanche_rule()}, 0).front();
    EXPECT_GE(got.found(), GetParam().found);
    EXPECT_LE(got.false_cuts(), GetParam().thin);
}

// The rule without its ratio: velocities inside the flow differ between vertices by far more than the speed
// of its edge where the flow stops. A threshold that accepts the first misses edges.
TEST_P(AvalancheFronts, are_not_found_by_a_small_or_a_large_jump_alone) {
    const auto got = judged(GetParam(), {{.jump = 0.3f}, {.jump = 6}}, GetParam().visible);
    EXPECT_GT(got[0].false_cuts(), 0.03);
    EXPECT_LT(got[1].found(), 0.975);
}

double distance(const glm::vec2& from, const std::array<glm::vec2, 2>& segment) {
    const glm::vec2 along = segment[1] - segment[0], way = from - segment[0];
    const float length2 = glm::dot(along, along);
    const float share = length2 > 0 ? std::clamp(glm::dot(way, along) / length2, 0.f, 1.f) : 0;
    return glm::length(way - share * along);
}

// Distance from a point on an edge that the level's contour crosses to the nearest point of that contour, in
// the triangles around either end.
double distance_to_level(const Tracker& level, int edge, const glm::vec2& from) {
    const Mesh& mesh = level.mesh();
    double nearest = std::numeric_limits<double>::infinity();
    for (const int end : {mesh.edge[edge].a, mesh.edge[edge].b})
        for (const auto& spoke : mesh.around(end))
            for (const int triangle : mesh.edge_triangle[spoke.edge]) {
                if (triangle < 0) continue;
                std::array<glm::vec2, 2> crossing;
                int count = 0;
                for (const int e : mesh.triangle_edge[triangle])
                    if (level.detector().is_cut(e))
                        crossing[count++] = level.position(level.points()[level.detector().slot(e)]);
                if (count == 2) nearest = std::min(nearest, distance(from, crossing));
            }
    return nearest;
}

// Root mean square distances from the contour at the visible depth, in cells.
struct Distances {
    double half = 0, paper = 0, fit = 0;
};

Distances distances_from_level(const Avalanche& avalanche) {
    constexpr int kTicksBetween = 6;
    constexpr std::array kSources{PointSource::kHalf, PointSource::kPaper, PointSource::kFit};
    std::array<std::unique_ptr<Tracker>, 3> trackers;
    std::array<double, 3> squares{}, counts{};
    sim::Workers workers(1);
    watch(avalanche, [&](const game::WorldFronts& fronts, double dt, std::int64_t tick) {
        const Mesh& mesh = fronts.view().mesh();
        const Tracker& level = fronts.view().tracker();
        for (std::size_t i = 0; i < trackers.size(); ++i) {
            if (!trackers[i])
                trackers[i] = std::make_unique<Tracker>(mesh, sim::front::avalanche_rule(), kSources[i]);
            trackers[i]->advance(fronts.flow(), dt, workers);
            if (tick % kTicksBetween != 0) continue;
            for (const auto& point : trackers[i]->points()) {
                if (!level.detector().is_cut(point.edge)) continue;
                const glm::vec2 at = trackers[i]->position(point);
                const double cells = distance_to_level(level, point.edge, at) / double{mesh.length[0]};
                squares[i] += cells * cells, ++counts[i];
            }
        }
    });
    const auto rms = [&](int i) { return std::sqrt(squares[i] / counts[i]); };
    return {rms(0), rms(1), rms(2)};
}

// The accuracy that velocities allow for an unsteady front, frayed and a cell or two wide.
TEST_P(AvalancheFronts, are_located_from_velocities_alone) {
    const Distances got = distances_from_level(GetParam());
    EXPECT_LE(got.fit, GetParam().fit);
    EXPECT_LE(got.fit, GetParam().half * got.half);
    EXPECT_LE(got.fit, GetParam().paper * got.paper);
}

INSTANTIATE_TEST_SUITE_P(Recordings, AvalancheFronts, testing::ValuesIn(kAvalanches),
                         [](const auto& avalanche) {
                             std::string name = avalanche.param.recording;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace game::test
