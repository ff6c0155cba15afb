#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

// What bcre-inertial promises of avalanches on any cell size and any orientation of the hill on the grid: the
// ground that they entrain, the heap that triggers them, and their outlines.

namespace {

using sim::Model;
using support::Ground;
using support::Play;

// Runs until everything rests, for at most `seconds`. Returns the greatest R at each vertex, m.
std::vector<double> peaks_of(Play& play, int seconds, const std::vector<sim::Command>& first = {}) {
    const sim::Grid grid = play.state.grid;
    std::vector<double> peaks(grid.size());
    for (int tick = 0; tick < 60 * seconds && (tick == 0 || !sim::at_rest(play.state)); ++tick) {
        play.ticks(1, tick == 0 ? std::span<const sim::Command>(first) : std::span<const sim::Command>{});
        std::size_t i = 0;
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x, ++i)
                peaks[i] = std::max(peaks[i], static_cast<double>(play.state.rolling(x, y)));
    }
    return peaks;
}

// What a heap released into a snow-covered gully does, m³.
struct Taken {
    double eroded, poured, left_in_footprint;
};

Taken heap_in_a_gully(double dx) {
    constexpr double kWide = 240, kLong = 888, kHeapX = 120, kHeapY = 768, kRadius = 36;
    Ground ground(
        {static_cast<int>(kWide / dx) + 1, static_cast<int>(kLong / dx) + 1, static_cast<float>(dx)});
    ground.set(ground.depth, [](double, double) { return 1; });
    ground.set(ground.bedrock, [](double x, double y) {
        const double ease = 60, up = y - 380;  // 36° above, 5° below
        return 0.09 * y + 0.64 * (up + std::sqrt(up * up + ease * ease)) / 2 +
               0.0012 * (x - kHeapX) * (x - kHeapX);
    });
    Play play(ground, support::loose_dry_snow());
    const sim::Field<float> before = play.state.depth;
    sim::Command pour = support::pour_at(kHeapX, kHeapY, kRadius, 3000, 2);
    pour.layer = sim::Layer::kStanding;
    pour.profile = sim::Profile::kCone;
    peaks_of(play, 60, {pour});
    Taken taken{0, 6000, 0};
    for (int y = 0; y < ground.grid.ny; ++y)
        for (int x = 0; x < ground.grid.nx; ++x) {
            const double gained = static_cast<double>(play.state.depth(x, y) - before(x, y)) * dx * dx;
            taken.eroded += std::max(0., -gained);
            if (std::hypot(x * dx - kHeapX, y * dx - kHeapY) <= kRadius)
                taken.left_in_footprint += std::max(0., gained);
        }
    return taken;
}

TEST(Avalanche, entrains_the_same_snow_on_every_grid_within_a_third_and_leaves_no_heap) {
    double least = 1e30, most = 0;
    for (const double dx : {24., 12., 6.}) {
        const Taken taken = heap_in_a_gully(dx);
        EXPECT_LE(taken.left_in_footprint, taken.poured / 5) << dx;
        least = std::min(least, taken.eroded);
        most = std::max(most, taken.eroded);
    }
    EXPECT_GT(least, 1000);
    EXPECT_LE(most, 1.3 * least);
}

using Points = std::vector<std::array<double, 2>>;

// Points on the contour of a field, given at vertices, at `level`: where it crosses the grid's edges, and
// midway between two crossings of a square. Relative to (middle, middle), turned back by `turned` rad.
Points outline(const std::vector<double>& field, int side, double dx, double level, double turned) {
    const double middle = (side - 1) / 2. * dx, c = std::cos(turned), s = std::sin(turned);
    Points points;
    const auto at = [&](int x, int y) {
        return field[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                     static_cast<std::size_t>(x)];
    };
    const auto add = [&](double x, double y) {
        const double from_x = x * dx - middle, from_y = y * dx - middle;
        points.push_back({c * from_x + s * from_y, c * from_y - s * from_x});
    };
    for (int y = 0; y + 1 < side; ++y)
        for (int x = 0; x + 1 < side; ++x) {
            constexpr int kX[] = {0, 1, 1, 0}, kY[] = {0, 0, 1, 1};
            Points crossings;
            for (int k = 0; k < 4; ++k) {
                const int n = (k + 1) % 4;
                const double a = at(x + kX[k], y + kY[k]), b = at(x + kX[n], y + kY[n]);
                if ((a >= level) == (b >= level)) continue;
                const double way = (level - a) / (b - a);
                crossings.push_back({x + kX[k] + way * (kX[n] - kX[k]), y + kY[k] + way * (kY[n] - kY[k])});
            }
            for (const auto& [px, py] : crossings) add(px, py);
            if (crossings.size() == 2)
                add((crossings[0][0] + crossings[1][0]) / 2, (crossings[0][1] + crossings[1][1]) / 2);
        }
    return points;
}

// Distance of the points of either line from the other, m: mean and 95th percentile.
struct Apart {
    double mean, p95;
};

Apart apart(const Points& one, const Points& other) {
    std::vector<double> distances;
    const auto add = [&](const Points& from, const Points& to) {
        for (const auto& [x, y] : from) {
            double nearest = 1e30;
            for (const auto& [to_x, to_y] : to)
                nearest = std::min(nearest, (x - to_x) * (x - to_x) + (y - to_y) * (y - to_y));
            distances.push_back(std::sqrt(nearest));
        }
    };
    add(one, other);
    add(other, one);
    std::sort(distances.begin(), distances.end());
    double sum = 0;
    for (const double distance : distances) sum += distance;
    const auto count = static_cast<double>(distances.size());
    return {sum / count, distances[static_cast<std::size_t>(0.95 * (count - 1))]};
}

struct Outlines {
    Points extent, deposit;
};

// Releases 2 m of snow on a disc on a hill of 36° that eases to 5°, under `cover` metres of snow. The disc is
// on the flank that faces `azimuth_deg` north of east.
Outlines release_on_a_hill(double azimuth_deg, double cover) {
    constexpr int kSide = 95;
    constexpr double kDx = 10, kMiddle = (kSide - 1) / 2. * kDx, kFoot = 230, kEase = 50, kOut = 100,
                     kRadius = 36;
    const double azimuth = azimuth_deg * std::numbers::pi / 180;
    const auto from_top = [&](double x, double y) { return std::hypot(x - kMiddle, y - kMiddle); };
    Ground ground({kSide, kSide, static_cast<float>(kDx)});
    ground.set(ground.depth, [&](double x, double y) {
        return cover * (1 - std::tanh((from_top(x, y) - kFoot) / 30)) / 2;
    });
    ground.set(ground.bedrock, [&](double x, double y) {
        const double r = std::hypot(from_top(x, y), 20), steep = std::tan(36 * std::numbers::pi / 180),
                     flat = std::tan(5 * std::numbers::pi / 180);
        const double slope_dx =
            flat * r + (steep - flat) / 2 * (r - kEase * std::log(std::cosh((r - kFoot) / kEase)));
        return 300 - slope_dx -
               static_cast<double>(ground.depth[ground.at(static_cast<int>(std::lrint(x / kDx)),
                                                          static_cast<int>(std::lrint(y / kDx)))]);
    });
    const double at_x = kMiddle + kOut * std::cos(azimuth), at_y = kMiddle + kOut * std::sin(azimuth);
    ground.set(ground.rolling, [&](double x, double y) {  // vertices on the rim get the covered share
        constexpr int kFine = 16;
        int in = 0;
        for (int i = 0; i < kFine * kFine; ++i) {
            const double off_x = ((i % kFine + 0.5) / kFine - 0.5) * kDx,
                         off_y = ((i / kFine + 0.5) / kFine - 0.5) * kDx;
            in += std::hypot(x + off_x - at_x, y + off_y - at_y) <= kRadius;
        }
        return 2. * in / (kFine * kFine);
    });
    Play play(ground, support::loose_dry_snow());
    const sim::Field<float> before = play.state.depth;
    const std::vector<double> peaks = peaks_of(play, 90);
    EXPECT_TRUE(sim::at_rest(play.state));
    std::vector<double> gained;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            gained.push_back(static_cast<double>(play.state.depth(x, y) - before(x, y)));
    constexpr double kLevel = 0.1;  // m
    return {outline(peaks, kSide, kDx, kLevel, azimuth), outline(gained, kSide, kDx, kLevel, azimuth)};
}

// A cell is 10 m. Nineteen of twenty points lie within one and a half, on average within half of one.
void expect_same_outlines(double cover) {
    const Outlines along = release_on_a_hill(0, cover), oblique = release_on_a_hill(22.5, cover);
    const Apart extent = apart(along.extent, oblique.extent), deposit = apart(along.deposit, oblique.deposit);
    std::printf("cover %.1f m: extent mean %.1f, p95 %.1f m; deposit mean %.1f, p95 %.1f m\n", cover,
                extent.mean, extent.p95, deposit.mean, deposit.p95);
    EXPECT_LE(extent.p95, 15);
    EXPECT_LE(extent.mean, 5);
    EXPECT_LE(deposit.p95, 15);
    EXPECT_LE(deposit.mean, 5);
}

TEST(Avalanche, has_the_same_outline_for_any_orientation_of_the_hill) {
    expect_same_outlines(0);
}

TEST(Avalanche, with_entrainment_has_the_same_outline_for_any_orientation_of_the_hill) {
    expect_same_outlines(0.5);
}

// Random rolling material with random velocities, dense and patchy, over random ground, at speeds that the
// sub-steps are just made for.
TEST(Avalanche, stays_positive_and_conserves_mass_at_its_greatest_speed) {
    std::mt19937 random(11);
    const auto within = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
    for (int round = 0; round < 60; ++round) {
        Ground ground({17, 17, 4});
        ground.set(ground.bedrock, [&](double x, double) { return -0.5 * x + within(6); });
        ground.set(ground.depth, [&](double, double) { return within(0.3); });
        ground.set(ground.rolling,
                   [&](double, double) { return random() % 3 ? within(random() % 2 ? 0.5 : 3e-4) : 0; });
        sim::Params params = support::lively(Model::kBcreInertial);
        params.erosion_rate = static_cast<float>(within(10));
        params.deposit_rate = static_cast<float>(within(100));
        Play play(ground, params);
        const float most = params.greatest_speed;
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 17; ++x) {
                play.state.velocity_x(x, y) = static_cast<float>(within(2) - 1) * most;
                play.state.velocity_y(x, y) = static_cast<float>(within(2) - 1) * most;
            }
        for (int tick = 0; tick < 60; ++tick) {
            play.ticks(1);
            for (int y = 0; y < 17; ++y)
                for (int x = 0; x < 17; ++x) {
                    ASSERT_GE(play.state.rolling(x, y), 0);
                    ASSERT_GE(play.state.depth(x, y), 0);
                    ASSERT_LE(std::hypot(play.state.velocity_x(x, y), play.state.velocity_y(x, y)),
                              1.001f * most);
                }
            ASSERT_EQ(play.state.ledger.mass_error(), 0);
        }
    }
}

}  // namespace
