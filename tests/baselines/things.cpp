#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "render/frame.h"
#include "tests/baselines/image_baseline.h"
#include "tests/render/world.h"
#include "tests/support/places.h"
#include "tests/support/renderer.h"

// Contact sheets: each thing intact, damaged, destroyed and buried, from left to right.

namespace baselines {
namespace {

using render::HouseMaterial;
using render::StructureKind;
using render::Structures;
using render::StructureState;
using render::test::make_world;
using render::test::World;

constexpr StructureState kStates[] = {StructureState::kIntact, StructureState::kDamaged,
                                      StructureState::kDestroyed, StructureState::kBuried};
constexpr double kApart = 45, kFirst = 60;  // m, from column to column

class ThingsSheet : public testing::Test {
  protected:
    void SetUp() override {
        static const auto context = render::HeadlessContext::create("auto");
        ASSERT_TRUE(context) << context.error();
        ASSERT_NO_FATAL_FAILURE(support::make_renderer(renderer_, render::Quality::kFine));
        world_.depth.fill(kSnow);
        world_.things.emplace(world_.grid);
        world_.things->natural = world_.bedrock;
    }

    // A deposit as deep as that in the middle.
    void heap(glm::dvec2 at, double radius, float deep) {
        for (int y = 0; y <= kSquares; ++y)
            for (int x = 0; x <= kSquares; ++x) {
                const double away = std::hypot(kCell * x - at.x, kCell * y - at.y) / radius;
                if (away < 1) world_.depth(x, y) += deep * static_cast<float>(1 - away * away);
            }
    }
    render::Picture draw(const render::Camera& camera) {
        const std::vector<float> first(world_.grid.size(), kSnow);
        renderer_->draw({.world = world_.view(),
                         .camera = camera,
                         .light = {235, 32},
                         .width = 480,
                         .height = 300,
                         .first_depth = first,
                         .structures = &structures_});
        return renderer_->read_back();
    }

    static constexpr int kSquares = 64;
    static constexpr float kCell = 4, kSnow = 0.6f;
    World world_ = make_world(kSquares, kCell, [](double, double y) { return 0.15 * y; });
    Structures structures_;
    std::optional<render::Renderer> renderer_;
};

TEST_F(ThingsSheet, houses_of_four_materials) {
    const glm::dvec3 sizes[] = {{8, 6, 4}, {12, 9, 8}, {18, 12, 11}, {24, 13, 13}};
    for (int material = 0; material < 4; ++material)
        for (int state = 0; state < 4; ++state) {
            const glm::dvec2 at(kFirst + kApart * state, 190 - 36 * material);
            const glm::dvec3& size = sizes[material];
            structures_.all.push_back({StructureKind::kHouse, at, 195, kStates[state], size.x, size.y, size.z,
                                       static_cast<HouseMaterial>(material)});
            if (kStates[state] == StructureState::kBuried) heap(at, 24, static_cast<float>(size.z) + 2);
        }
    EXPECT_TRUE(matches_baseline(draw({{126, 130, 20}, 180, 28, 230, 40}), "things_houses"));
}

TEST_F(ThingsSheet, nets_pylons_and_a_road) {
    for (int state = 0; state < 4; ++state) {
        const glm::dvec2 at(kFirst + kApart * state, 150);
        for (int piece = 0; piece < 3; ++piece)
            structures_.nets.push_back(
                {at + glm::dvec2(8 * piece - 12, 0), at + glm::dvec2(8 * piece - 4, 0), 3, kStates[state]});
        structures_.all.push_back({StructureKind::kPylon, at - glm::dvec2(0, 40), 0, kStates[state]});
        if (kStates[state] != StructureState::kBuried) continue;
        heap(at, 20, 5);
        heap(at - glm::dvec2(0, 40), 24, 16);
    }
    structures_.roads.push_back({{{10, 90}, {130, 82}, {250, 95}}, 7});
    EXPECT_TRUE(matches_baseline(draw({{126, 115, 15}, 180, 24, 180, 45}), "things_lines"));
}

// Intact; damaged; destroyed, but for the mountain station, from which torn ropes hang; with its valley station buried.
TEST_F(ThingsSheet, chairlifts) {
    constexpr StructureState kValleyAndPylon[][2] = {
        {StructureState::kIntact, StructureState::kIntact},
        {StructureState::kDamaged, StructureState::kDamaged},
        {StructureState::kDestroyed, StructureState::kDestroyed},
        {StructureState::kBuried, StructureState::kIntact},
    };
    for (int column = 0; column < 4; ++column) {
        const auto [valley, pylon] = kValleyAndPylon[column];
        const glm::dvec2 at(81 + 30 * column, 90), up(0, 38);
        structures_.lifts.push_back({structures_.all.size(), 3});
        structures_.all.push_back({StructureKind::kStation, at, 0, valley});
        structures_.all.push_back({StructureKind::kPylon, at + up, 0, pylon});
        structures_.all.push_back({StructureKind::kStation, at + 2.0 * up, 180, StructureState::kIntact});
        if (valley == StructureState::kBuried) heap(at, 16, 10);
    }
    EXPECT_TRUE(matches_baseline(draw({{126, 122, 22}, 180, 26, 118, 48}), "things_lifts"));
}

// Clear; with a tongue of snow across it; under a deposit that just blocks it; buried.
TEST_F(ThingsSheet, roads) {
    for (int column = 0; column < 4; ++column) {
        const glm::dvec2 at(84 + 28 * column, 125), up(0, 16);
        structures_.roads.push_back({{at - 2.0 * up, at + 2.0 * up}, 8});
        if (column == 1) heap(at, 11, 1.5f);
        for (const int along : {-2, -1, 0, 1, 2})
            if (column >= 2) heap(at + static_cast<double>(along) * up, 12, column == 2 ? 0.35f : 4);
    }
    EXPECT_TRUE(matches_baseline(draw({{126, 122, 18}, 180, 38, 100, 52}), "things_roads"));
}

TEST_F(ThingsSheet, forest_and_a_dam) {
    sim::Field<sim::Stems>& forest = world_.things->forest;
    for (int y = 0; y <= kSquares; ++y)
        for (int x = 0; x <= kSquares; ++x) {
            if (y > 30 && y < 46 && x > 8 && x < 56)
                forest(x, y) = x < 24   ? sim::Stems{500, 0, 30, 20}
                               : x < 40 ? sim::Stems{0, 500, 30, 20}
                                        : sim::Stems{};
            const double from_crest = std::abs(kCell * y - 70 + 0.002 * std::pow(kCell * x - 126, 2));
            const double height = std::abs(kCell * x - 126) < 80 ? 7 - 0.8 * from_crest : 0;
            if (height <= 0) continue;
            world_.things->earth(x, y) = static_cast<float>(height);
            world_.bedrock(x, y) += static_cast<float>(height);
            world_.depth(x, y) = 0;
        }
    EXPECT_TRUE(matches_baseline(draw({{126, 120, 20}, 180, 24, 210, 45}), "things_forest_and_dam"));
}

}  // namespace
}  // namespace baselines
