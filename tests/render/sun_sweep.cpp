#include "render/mountain/sun_sweep.h"
#include "render/frame/make_frame_block.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "render/mountain/height_range.h"
#include "tests/render/mountains.h"
#include "tests/support/allocations.h"

namespace render::test {
namespace {

// A hilly world that is longer along x, with holes in its ground.
World hills(int nx, int ny, float cell) {
    World world = make_world(std::max(nx, ny) - 1, cell, [](double x, double y) {
        return 0.3 * x + 25 * std::sin(x / 31) * std::cos(y / 23) + 8 * std::sin((x + y) / 7);
    });
    const World square = world;
    world.grid = {nx, ny, cell};
    world.bedrock = world.depth = world.rolling = world.velocity_x = world.velocity_y =
        sim::Field<float>(world.grid);
    world.site = sim::Field<sim::Site>(world.grid);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            world.bedrock(x, y) = square.bedrock(x, y);
            world.depth(x, y) = 0.5f + 0.01f * static_cast<float>(x);
            if ((x / 5 + y / 7) % 6 == 0 && x % 3 != 0) world.site(x, y) = sim::Site::kDrain;
        }
    return world;
}

FrameBlock frame_of(const World& world, const Surroundings* around, const Light& light) {
    FrameInput input{.world = world.view(), .camera = {}, .light = light, .width = 64, .height = 64};
    input.surroundings = around;
    return make_frame_block(input, height_range(world.view()), 1, std::nullopt);
}

double bilinear(const Surroundings& around, glm::dvec2 at) {
    const glm::dvec2 p = glm::clamp((at - around.rough_origin()) / around.rough_cell(), 0.0,
                                    static_cast<double>(Surroundings::kRough - 1));
    const int x = std::min(static_cast<int>(p.x), Surroundings::kRough - 2);
    const int y = std::min(static_cast<int>(p.y), Surroundings::kRough - 2);
    const auto height = [&](int i, int j) {
        return static_cast<double>(
            around.rough_heights()[static_cast<std::size_t>(j * Surroundings::kRough + i)]);
    };
    return glm::mix(glm::mix(height(x, y), height(x + 1, y), p.x - x),
                    glm::mix(height(x, y + 1), height(x + 1, y + 1), p.x - x), p.y - y);
}

// Ray by ray and in double precision, as the sketch in the header says.
std::vector<double> reference(const World& world, const Surroundings* around, const FrameBlock& frame) {
    const bool turned = frame.sweep.w > 0.5f, backwards = frame.haze.z > 0.5f;
    const int rays = frame.size.z, rows = frame.size.w, columns = turned ? world.grid.ny : world.grid.nx;
    const double base = static_cast<double>(frame.ground.y), fall = static_cast<double>(frame.sweep.z);
    const auto beyond = [&](double column, double row) {
        const double cell = static_cast<double>(world.grid.dx);
        return around ? bilinear(*around, cell * (turned ? glm::dvec2(row, column) : glm::dvec2(column, row)))
                      : base;
    };
    const auto height = [&](int column, int row) {
        const int x = turned ? row : column, y = turned ? column : row;
        if (world.site(x, y) == sim::Site::kDrain) return beyond(column, row);
        return static_cast<double>(world.bedrock(x, y) + world.depth(x, y) + world.rolling(x, y));
    };
    std::vector<double> ceilings(static_cast<std::size_t>(rays) * static_cast<std::size_t>(rows));
    for (int ray = 0; ray < rays; ++ray) {
        double ceiling = base;
        const auto column = [&](double step) {
            return static_cast<double>(frame.sweep.y) + 0.5 * ray + static_cast<double>(frame.sweep.x) * step;
        };
        const double stride = 1.8 * std::max(rows, columns) / 48;
        for (int n = 48; around && n > 0; --n) {
            const double step = -n * stride, row = backwards ? rows - 1 - step : step;
            ceiling = std::max(std::max(ceiling, beyond(column(step), row)) - fall * stride, base);
        }
        for (int step = 0; step < rows; ++step) {
            ceilings[static_cast<std::size_t>(step) * static_cast<std::size_t>(rays) +
                     static_cast<std::size_t>(ray)] = ceiling;
            const double x = column(step);
            const int row = backwards ? rows - 1 - step : step,
                      left = std::min(static_cast<int>(x), columns - 2);
            const bool inside = x >= 0 && x <= columns - 1;
            const double z =
                inside ? glm::mix(height(left, row), height(left + 1, row), x - left) : beyond(x, row);
            ceiling = std::max(std::max(ceiling, z) - fall, base);
        }
    }
    return ceilings;
}

const std::vector<Light> kLights{{180, 14}, {0, 30},  {90, 14},  {270, 8},   {135, 20}, {225.5, 4},
                                 {314, 33}, {46, 61}, {101, 12}, {188.3, 7}, {350, 1},  {250, -12}};

TEST(SunSweep, equals_a_sweep_ray_by_ray) {
    for (const auto& [nx, ny] : {std::pair(41, 41), std::pair(57, 30), std::pair(22, 63)}) {
        const World world = hills(nx, ny, 5);
        const Surroundings mountains = mountains_around(world);
        SunSweep sweep;
        for (const Surroundings* around : {&mountains, static_cast<const Surroundings*>(nullptr)})
            for (const Light& light : kLights) {
                const FrameBlock frame = frame_of(world, around, light);
                sweep.run(world.view(), around, frame);
                const std::vector<double> expected = reference(world, around, frame);
                ASSERT_EQ(sweep.ceilings().size(), expected.size());
                double worst = 0;
                for (std::size_t i = 0; i < expected.size(); ++i)
                    worst = std::max(worst, std::abs(static_cast<double>(sweep.ceilings()[i]) - expected[i]));
                EXPECT_LT(worst, 2e-3) << nx << " x " << ny << ", sun at " << light.azimuth_deg;
            }
    }
}

TEST(SunSweep, tells_which_rows_changed) {
    World world = hills(48, 35, 4);
    const Surroundings around = mountains_around(world);
    std::mt19937 dice(7);
    SunSweep sweep;
    int partial = 0;
    for (const Light& light : kLights) {
        sweep.run(world.view(), &around, frame_of(world, &around, light));
        EXPECT_EQ(sweep.first_changed(), 0);
        EXPECT_EQ(sweep.last_changed(), sweep.rows() - 1);
        for (int round = 0; round < 12; ++round) {
            const std::vector<float> before(sweep.ceilings().begin(), sweep.ceilings().end());
            for (unsigned i = 0; i < dice() % 3; ++i)
                world.rolling(static_cast<int>(dice() % 48), static_cast<int>(dice() % 35)) =
                    static_cast<float>(dice() % 20);
            sweep.run(world.view(), &around, frame_of(world, &around, light));
            ASSERT_TRUE(std::ranges::equal(sweep.before(), before));
            int first = sweep.rows(), last = -1;
            for (int i = 0; i < static_cast<int>(before.size()); ++i)
                if (sweep.ceilings()[static_cast<std::size_t>(i)] != before[static_cast<std::size_t>(i)])
                    first = std::min(first, i / sweep.rays()), last = i / sweep.rays();
            if (last < 0)
                EXPECT_GT(sweep.first_changed(), sweep.last_changed());
            else
                EXPECT_EQ(std::pair(sweep.first_changed(), sweep.last_changed()), std::pair(first, last));
            partial += last >= 0 && first > 0;
        }
    }
    EXPECT_GT(partial, 20);
}

TEST(SunSweep, gives_equal_bits_whatever_was_swept_before) {
    World world = hills(48, 35, 4), other = hills(35, 48, 3);
    const Surroundings around = mountains_around(world), others = mountains_around(other);
    SunSweep busy;
    for (const Light& light : kLights) {
        busy.run(other.view(), &others, frame_of(other, &others, light));
        busy.run(world.view(), nullptr, frame_of(world, nullptr, light));
        world.site(9, 9) = world.site(9, 9) == sim::Site::kDrain ? sim::Site::kGround : sim::Site::kDrain;
        world.rolling(20, 20) += 7;
        busy.run(world.view(), &around, frame_of(world, &around, light));
        SunSweep fresh;
        fresh.run(world.view(), &around, frame_of(world, &around, light));
        EXPECT_TRUE(std::ranges::equal(busy.ceilings(), fresh.ceilings()));
        EXPECT_EQ(busy.last_changed(), busy.rows() - 1);
    }
}

TEST(SunSweep, allocates_nothing_while_world_and_sun_move) {
    World world = hills(48, 35, 4);
    const Surroundings around = mountains_around(world);
    std::vector<FrameBlock> frames;
    for (const Light& light : kLights) frames.push_back(frame_of(world, &around, light));
    SunSweep sweep;
    for (const FrameBlock& frame : frames) sweep.run(world.view(), &around, frame);
    const std::int64_t before = support::allocations();
    for (const FrameBlock& frame : frames)
        for (int i = 0; i < 3; ++i) {
            world.rolling(20, 20) += 1;
            sweep.run(world.view(), &around, frame);
        }
    EXPECT_EQ(support::allocations(), before);
}

}  // namespace
}  // namespace render::test
