// What is drawn of the advected textures on the deposits of the shipped avalanches at rest.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include "game/analysis/headless.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "render/flow/flow_vertices.h"
#include "sim/front/gradient.h"

namespace game::test {
namespace {

using render::FlowVertex;
using sim::front::FlowView;
using sim::front::Mesh;
using sim::front::TextureLayers;

constexpr int kSheets = TextureLayers::kSheets;

// How a triangle of a deposit is drawn, in its middle.
struct Drawn {
    double area = 0;  // m², times the visible share of the deposit
    // Of each sheet, the one that lies still last: weight, and ratio of greatest to least stretch.
    std::array<double, kSheets + 1> weight{}, distortion{};
    double relief = 1;  // root mean square slope; of an unstretched texture 1
    double faded = 1;   // relief of the advected sheets alone, if the triangle fades as its own stretch says
};

// Contrast and slopes of a blend of independent sheets, as in paint_blended.glsl.
struct Blend {
    double variance = 0, slopes = 0;
    void add(double weight, double greatest, double least) {
        variance += weight * weight;
        slopes += weight * weight * (greatest * greatest + least * least) / 2;
    }
    double relief() const { return variance > 0 ? std::sqrt(slopes / variance) : 0; }
};

double smoothed(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Drawn drawn_at(const FlowView& flow, const std::vector<FlowVertex>& vertices, double visible, int triangle) {
    const Mesh& mesh = flow.mesh();
    const auto& corners = mesh.triangle[triangle];
    double lies = 0;
    float stretch = 0;
    for (const int v : corners) {
        lies += std::min(0.5 * static_cast<double>(vertices[v].deposit) / visible, 1.0) / 3;
        stretch += vertices[v].stretch / 3;
    }
    Drawn drawn;
    const glm::dvec2 u(mesh.position[corners[1]] - mesh.position[corners[0]]);
    const glm::dvec2 w(mesh.position[corners[2]] - mesh.position[corners[0]]);
    drawn.area = std::abs(u.x * w.y - u.y * w.x) / 2 * smoothed((lies - 0.1) / 0.4);
    if (drawn.area == 0) return drawn;

    const auto keep = static_cast<double>(render::kept_share(stretch));
    const glm::dmat2 inverse = glm::inverse(glm::dmat2(u, w));
    Blend all, advected;
    double drawn_out = 0;
    for (int s = 0; s < kSheets; ++s) {
        const auto offset = [&](int k) {
            return glm::dvec2(flow.layers().offsets()[vertices[corners[k]].shows][s]);
        };
        double share = 0;
        for (const int v : corners)
            share += static_cast<double>(flow.layers().weight(vertices[v].shows, s)) / 3;
        const glm::dmat2 apart = glm::dmat2(offset(1) - offset(0), offset(2) - offset(0)) * inverse;
        drawn_out += share * std::sqrt(glm::dot(apart[0], apart[0]) + glm::dot(apart[1], apart[1]));
        const auto [greatest, least] = sim::front::singular_values(glm::dmat2(1) + apart);
        drawn.weight[s] = keep * share;
        drawn.distortion[s] = greatest / std::max(std::abs(least), 1e-9);
        all.add(keep * share, greatest, least);
        advected.add(share, greatest, least);
    }
    drawn.weight[kSheets] = 1 - keep, drawn.distortion[kSheets] = 1;
    all.add(1 - keep, 1, 1);
    drawn.relief = all.relief();
    drawn.faded = advected.relief() * smoothed(2 - drawn_out);
    return drawn;
}

double percentile_95(std::vector<std::pair<double, double>> weighted) {
    std::sort(weighted.begin(), weighted.end());
    double all = 0, sum = 0;
    for (const auto& [value, weight] : weighted) all += weight;
    for (const auto& [value, weight] : weighted)
        if ((sum += weight) >= 0.95 * all) return value;
    return 1;
}

struct Score {
    double distortion_p95 = 1, advected_p95 = 1;  // with the sheet that lies still, and without
    double kept = 0;                              // share of the advected sheets, by area
    double least_relief = 1, least_faded = 1;     // of a triangle, over that of a neighbour
};

Score score(const FlowView& flow, double visible) {
    const Mesh& mesh = flow.mesh();
    std::vector<FlowVertex> vertices(mesh.position.size());
    render::describe(flow, vertices);
    std::vector<Drawn> drawn;
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
        drawn.push_back(drawn_at(flow, vertices, visible, static_cast<int>(t)));

    Score got;
    std::vector<std::pair<double, double>> shown, advected;
    double area = 0, kept = 0;
    for (const Drawn& d : drawn) {
        const double keep = 1 - d.weight[kSheets];
        area += d.area, kept += d.area * keep;
        for (int s = 0; s <= kSheets; ++s) {
            shown.emplace_back(d.distortion[s], d.area * d.weight[s]);
            if (s < kSheets && keep > 0) advected.emplace_back(d.distortion[s], d.area * d.weight[s] / keep);
        }
    }
    got.kept = kept / area;
    got.distortion_p95 = percentile_95(shown), got.advected_p95 = percentile_95(advected);
    for (const auto& [a, b] : mesh.edge_triangle) {
        if (a < 0 || b < 0 || drawn[a].area == 0 || drawn[b].area == 0) continue;
        const auto ratio = [](double one, double other) {
            return std::min(one, other) / std::max({one, other, 1.0});
        };
        got.least_relief = std::min(got.least_relief, ratio(drawn[a].relief, drawn[b].relief));
        got.least_faded = std::min(got.least_faded, ratio(drawn[a].faded, drawn[b].faded));
    }
    return got;
}

struct Deposit {
    const char* scene;
    int squares;  // along the longer side
    double kept;  // least share of the advected sheets; a coarse grid keeps less of them
};

class Deposits : public testing::TestWithParam<Deposit> {
  protected:
    // Plays the scene on the grid until nothing moves.
    static Score score_at_rest(const Deposit& deposit) {
        Overrides overrides;
        overrides.squares = deposit.squares;
        const Scene scene = load_scene(deposit.scene, overrides).value();
        auto session = Session::begin(scene.scenario, sim::StepOptions{.threads = 1}, std::nullopt).value();
        session.follow_fronts(scene.scenario);
        const Until until = Until::still(scene.commands.back().tick);
        EXPECT_EQ(play_headless(session, scene.commands, until, {}, deposit.scene).value(), Ended::kStill);
        return score(*session.fronts(), static_cast<double>(scene.scenario.look.rolling_visible_m));
    }
};

TEST_P(Deposits, have_relief_in_each_triangle_and_little_distortion) {
    const Score got = score_at_rest(GetParam());
    for (const auto& [name, value] : {std::pair{"distortion_p95", got.distortion_p95},
                                      {"advected_p95", got.advected_p95},
                                      {"kept", got.kept},
                                      {"least_relief", got.least_relief},
                                      {"least_faded", got.least_faded}})
        RecordProperty(name, std::to_string(value));
    EXPECT_LE(got.distortion_p95, 2);
    EXPECT_GT(got.least_relief, 0.5);
    EXPECT_GT(got.kept, GetParam().kept);
    // The measures notice textures that are drawn out, and triangles that fade one by one.
    EXPECT_GT(got.advected_p95, 1.5);
    EXPECT_LT(got.least_faded, 0.2);
}

constexpr Deposit kDeposits[] = {
    {"landslide", 80, 0.2},         {"snow-avalanche", 80, 0.13},   {"snow-avalanche", 160, 0.19},
    {"snow-avalanche", 320, 0.14},  {"winter-avalanche", 80, 0.13}, {"winter-avalanche", 160, 0.2},
    {"winter-avalanche", 320, 0.2},
};

INSTANTIATE_TEST_SUITE_P(Scenes, Deposits, testing::ValuesIn(kDeposits), [](const auto& deposit) {
    std::string name = deposit.param.scene;
    std::replace(name.begin(), name.end(), '-', '_');
    return name + "_on_" + std::to_string(deposit.param.squares) + "_squares";
});

}  // namespace
}  // namespace game::test
