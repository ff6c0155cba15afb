#include "sim/carried/carried.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/flow/rock_mesh.h"
#include "tests/render/world.h"

// What flows of soil carry, on a slope that falls to the east and is level in its second half.
namespace render::test {
namespace {

constexpr float kTick = 1 / 60.f;

class CarriedBodies : public testing::Test {
  protected:
    static constexpr int kSquares = 40;
    static constexpr float kCell = 10, kSoil = 2;

    CarriedBodies() { world_.depth.fill(kSoil); }

    // Lets what is west of a column flow east, as deep as it eroded.
    void erode(float speed, float by, int columns = 10) {
        for (int y = 5; y < 35; ++y)
            for (int x = 2; x < columns; ++x) {
                world_.depth(x, y) = kSoil - by;
                world_.rolling(x, y) = by;
                world_.velocity_x(x, y) = speed;
            }
    }
    void stop() {
        world_.rolling.fill(0);
        world_.velocity_x.fill(0);
    }
    void run(sim::carried::Carried& carried, int ticks) {
        for (int i = 0; i < ticks; ++i) carried.advance(world_.view(), kTick);
    }
    static std::vector<sim::carried::Body> copy(const sim::carried::Carried& carried) {
        return {carried.bodies().begin(), carried.bodies().end()};
    }

    World world_ = make_world(kSquares, kCell, [](double x, double) { return std::max(60 - 0.3 * x, 0.0); });
    std::vector<float> first_depth_ = std::vector<float>(world_.grid.size(), kSoil);
};

TEST_F(CarriedBodies, are_laid_bare_by_what_erodes_their_soil_and_flows) {
    sim::carried::Carried carried(first_depth_, true, false);
    run(carried, 60);
    EXPECT_TRUE(carried.bodies().empty());
    erode(3, 1, 6);
    run(carried, 1);
    const std::size_t half = carried.bodies().size();
    EXPECT_GT(half, 50u);
    run(carried, 1);
    EXPECT_EQ(carried.bodies().size(), half) << "each once";
    erode(3, 2, 6);
    run(carried, 1);
    EXPECT_NEAR(static_cast<double>(carried.bodies().size()), 2.0 * static_cast<double>(half),
                0.5 * static_cast<double>(half));
}

TEST_F(CarriedBodies, are_none_in_a_material_without_any) {
    sim::carried::Carried carried(first_depth_, false, true);
    erode(3, 2);
    run(carried, 60);
    EXPECT_TRUE(carried.bodies().empty());
}

TEST_F(CarriedBodies, are_fewer_the_larger_they_are) {
    sim::carried::Carried carried(first_depth_, true, false);
    erode(3, 2, 30);
    run(carried, 1);
    const auto larger = [&](float size) {
        return static_cast<double>(std::ranges::count_if(
            carried.bodies(), [&](const sim::carried::Body& body) { return body.size > size; }));
    };
    const double all = larger(0);
    EXPECT_EQ(larger(sim::carried::Carried::kLargest), 0);
    EXPECT_NEAR(larger(0.6f) / all, std::pow(0.5, 2.5), 0.05);
    EXPECT_NEAR(larger(1.2f) / all, std::pow(0.25, 2.5), 0.02);
}

TEST_F(CarriedBodies, travel_with_the_flow_and_come_to_rest_half_sunk) {
    sim::carried::Carried carried(first_depth_, true, false);
    erode(4, 2);
    run(carried, 1);
    const std::vector<sim::carried::Body> begin = copy(carried);
    run(carried, 120);
    double mean = 0;
    for (std::size_t i = 0; i < begin.size(); ++i)
        mean +=
            static_cast<double>(carried.bodies()[i].at.x - begin[i].at.x) / static_cast<double>(begin.size());
    EXPECT_GT(mean, 4);
    EXPECT_LT(mean, 14);
    stop();
    run(carried, 3600);
    EXPECT_FALSE(carried.advance(world_.view(), kTick)) << "all rest";
    for (const sim::carried::Body& body : carried.bodies()) EXPECT_LT(body.sunk, 0.7f);
}

TEST_F(CarriedBodies, continue_to_the_bit_after_they_were_put_back) {
    sim::carried::Carried carried(first_depth_, true, false);
    erode(4, 1);
    run(carried, 40);
    const std::vector<sim::carried::Body> then = copy(carried);
    erode(4, 2, 14);
    run(carried, 80);
    const std::vector<sim::carried::Body> later = copy(carried);
    EXPECT_NE(then, later);
    sim::carried::Carried other(first_depth_, true, false);
    for (sim::carried::Carried* each : {&carried, &other}) {
        each->restore(then);
        run(*each, 80);
        EXPECT_EQ(copy(*each), later);
    }
}

TEST_F(CarriedBodies, stop_at_the_walls_of_a_house) {
    world_.things.emplace(world_.grid);
    sim::Thing house;
    house.x = 150, house.y = 200;
    house.length = 400, house.width = 12, house.height = 8, house.strength = 30;
    world_.things->list.push_back(house);
    sim::carried::Carried carried(first_depth_, true, false);
    erode(6, 1, 14);
    run(carried, 1200);
    const bool any_passed = std::ranges::any_of(carried.bodies(), [](const sim::carried::Body& body) {
        return body.at.x > 150 && body.velocity.x > 1;
    });
    EXPECT_FALSE(any_passed);
}

// Trees that lie where a flow runs faster in the north than in the south.
class CarriedTrunks : public CarriedBodies {
  protected:
    CarriedTrunks() {
        world_.things.emplace(world_.grid);
        for (int y = 5; y < 35; ++y)
            for (int x = 4; x < 8; ++x)
                world_.things->forest(x, y) = {
                    .standing = 0, .lying = 200, .diameter_cm = 30, .height_m = 20};
    }
};

TEST_F(CarriedTrunks, are_as_many_as_trees_lie_where_soil_flows) {
    sim::carried::Carried carried(first_depth_, true, false);
    run(carried, 60);
    EXPECT_TRUE(carried.bodies().empty());
    world_.depth.fill(0);
    erode(3, 1);
    world_.depth.fill(kSoil);  // nothing is eroded
    run(carried, 3);
    EXPECT_NEAR(static_cast<double>(carried.bodies().size()), 30 * 4 * 200 * 100 / 1e4, 2);
    for (const sim::carried::Body& body : carried.bodies()) EXPECT_EQ(body.kind, sim::carried::Kind::kTrunk);
}

TEST_F(CarriedTrunks, turn_with_the_shear_of_the_flow_and_stop_with_it) {
    sim::carried::Carried carried(first_depth_, true, false);
    erode(3, 1, 30);
    world_.depth.fill(kSoil);
    for (int y = 0; y <= kSquares; ++y)
        for (int x = 0; x <= kSquares; ++x) world_.velocity_x(x, y) = 0.5f + 0.15f * static_cast<float>(y);
    run(carried, 1);
    std::vector<sim::carried::Body> begin = copy(carried);
    run(carried, 60);
    int clockwise = 0, turned = 0;
    for (std::size_t i = 0; i < begin.size(); ++i) {
        const glm::vec3 was(begin[i].turn), now(carried.bodies()[i].turn);
        EXPECT_NEAR(glm::length(now), 1, 1e-3);
        EXPECT_GT(carried.bodies()[i].at.x, begin[i].at.x);
        if (std::abs(was.y) < 0.1f) continue;  // along the flow it hardly turns
        ++turned;
        clockwise += was.x * now.y - was.y * now.x < 0;
    }
    EXPECT_GT(turned, 10);
    EXPECT_EQ(clockwise, turned);
    stop();
    run(carried, 1200);
    EXPECT_FALSE(carried.advance(world_.view(), kTick)) << "all rest";
}

TEST(Rocks, are_closed_and_about_as_large_as_a_ball) {
    for (const RockMesh& rock : rock_meshes())
        for (const auto& corners : rock) {
            double volume = 0;
            for (std::size_t i = 0; i < corners.size(); i += 3)
                volume += static_cast<double>(
                              glm::dot(corners[i].at, glm::cross(corners[i + 1].at, corners[i + 2].at))) /
                          6;
            EXPECT_NEAR(volume, 3.14159 / 6, 0.24);
        }
}

}  // namespace
}  // namespace render::test
