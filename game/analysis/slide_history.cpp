#include "game/analysis/slide_history.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "game/scene/surface.h"
#include "sim/world/mixture.h"
#include "sim/world/things.h"

namespace game {
namespace {

using Sample = SlideHistory::Sample;

// Calls `see` for each vertex of tiles in which anything rolls; of all without an engine.
template <class See>
void each_rolling(const sim::View& world, const See& see) {
    const sim::Tiles& tiles = world.tiles;
    const auto over = [&](int x0, int x1, int y0, int y1) {
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                if (world.rolling(x, y) >= Peaks::kVisible) see(x, y);
    };
    if (tiles.columns == 0) return over(0, world.grid.nx, 0, world.grid.ny);
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            const std::size_t tile = tiles.number(column, row);
            if (!tiles.uncounted[tile] && tiles.mass[tile].rolling == 0) continue;
            const int x0 = column * tiles.width, y0 = row * tiles.height;
            over(x0, std::min(x0 + tiles.width, world.grid.nx), y0,
                 std::min(y0 + tiles.height, world.grid.ny));
        }
}

template <class See>
void each_moving(const sim::View& world, const See& see) {
    each_rolling(world, [&](int x, int y) {
        const glm::dvec2 velocity(world.velocity_x(x, y), world.velocity_y(x, y));
        if (glm::dot(velocity, velocity) >= SlideHistory::kMoves * SlideHistory::kMoves) see(x, y, velocity);
    });
}

// The highest of some vertices.
struct Highest {
    double height = -1e30;  // m
    glm::dvec2 at{0};

    void see(const sim::View& world, int x, int y) {
        const double here = static_cast<double>(world.bedrock(x, y)) + world.depth(x, y);
        if (here <= height) return;
        height = here;
        at = static_cast<double>(world.grid.dx) * glm::dvec2(x, y);
    }
};

double distance_to(const sim::View& world, glm::dvec2 from, int x, int y) {
    return glm::distance(from, static_cast<double>(world.grid.dx) * glm::dvec2(x, y));
}

// Run-out of all that has flowed before there were samples.
void take_run_out(Sample& sample, const sim::View& world, const std::vector<float>& deepest) {
    const auto each = [&](const auto& see) {
        auto depth = deepest.begin();
        for (int y = 0; y < world.grid.ny; ++y)
            for (int x = 0; x < world.grid.nx && depth != deepest.end(); ++x, ++depth)
                if (*depth >= SlideHistory::kReached) see(x, y);
    };
    Highest top;
    each([&](int x, int y) { top.see(world, x, y), sample.moved_at = world.tick; });
    sample.top = top.at;
    each([&](int x, int y) {
        sample.run_out = std::max(sample.run_out, distance_to(world, sample.top, x, y));
    });
}

// Adds what moves to the run-out of the sample before.
void add_run_out(Sample& sample, const sim::View& world, glm::dvec2 highest, double tick_s) {
    const bool begins = !sample.moved_at ||
                        static_cast<double>(world.tick - *sample.moved_at) * tick_s > SlideHistory::kPause;
    if (begins) sample.top = highest, sample.run_out = 0;
    sample.moved_at = world.tick;
    each_moving(world, [&](int x, int y, glm::dvec2) {
        if (world.rolling(x, y) >= SlideHistory::kReached)
            sample.run_out = std::max(sample.run_out, distance_to(world, sample.top, x, y));
    });
}

// p = ρ |v|², the largest at the vertices that load an object, kPa. On the ground without buildings, which have no slope.
double pressure_at(const sim::View& world, std::size_t thing, const Densities& densities) {
    const sim::Things& things = *world.things;
    const sim::View natural = sim::on_bedrock(world, things.natural);
    const sim::Things::Range& range = things.loaded_of[thing];
    double most = 0;
    for (std::uint32_t k = range.first; k < range.first + range.count; ++k) {
        const int x = things.loaded[k].vertex % world.grid.nx, y = things.loaded[k].vertex / world.grid.nx;
        if (world.rolling(x, y) < Peaks::kVisible) continue;
        const double share = world.mixture ? static_cast<double>(sim::share_in_rolling(world, x, y)) : 0,
                     speed = speed_along_slope({world.velocity_x(x, y), world.velocity_y(x, y)},
                                               ground_slope(natural, x, y));
        most = std::max(most, impact_pressure(densities.of(share), speed));
    }
    return most;
}

}  // namespace

void SlideHistory::begin(const sim::View& world) {
    if (since_) return;
    since_ = world.tick;
    samples_.reserve(kMostSamples);
    houses_.reserve(kMostHouses);
    find_houses(world);
}

void SlideHistory::see(const sim::View& world, const Peaks& peaks, const std::optional<Densities>& densities,
                       double tick_s, std::int64_t known_until) {
    begin(world);
    forget_after(world.tick == known_until ? world.tick - 1 : known_until);
    if (world.tick % step_ != 0) return;
    const auto next = std::ranges::lower_bound(samples_, world.tick, {}, &Sample::tick);
    if (next != samples_.end() && next->tick == world.tick) return;
    if (samples_.size() == kMostSamples) {
        drop_every_second();
        return see(world, peaks, densities, tick_s, known_until);  // where there is room now
    }

    samples_.insert(
        next, sample_of(world, peaks, densities, tick_s, next == samples_.begin() ? nullptr : &next[-1]));
}

// `before`: the sample before it; null if there is none.
Sample SlideHistory::sample_of(const sim::View& world, const Peaks& peaks,
                               const std::optional<Densities>& densities, double tick_s,
                               const Sample* before) {
    Sample sample;
    if (!before)
        take_run_out(sample, world, peaks.depth);
    else
        sample = {.run_out = before->run_out, .top = before->top, .moved_at = before->moved_at};
    sample.tick = world.tick;
    const double cell = static_cast<double>(world.grid.dx) * static_cast<double>(world.grid.dx);
    Highest highest;
    each_moving(world, [&](int x, int y, glm::dvec2 velocity) {
        sample.volume += static_cast<double>(world.rolling(x, y)) * cell;
        sample.speed = std::max(sample.speed, speed_along_slope(velocity, ground_slope(world, x, y)));
        highest.see(world, x, y);
    });
    if (sample.volume > 0) add_run_out(sample, world, highest.at, tick_s);
    find_houses(world);
    for (std::size_t i = 0; densities && i < houses_.size(); ++i)
        if (houses_[i].thing)
            sample.pressure[i] = static_cast<float>(pressure_at(world, *houses_[i].thing, *densities));
    return sample;
}

void SlideHistory::forget_after(std::int64_t tick) {
    samples_.erase(std::ranges::upper_bound(samples_, tick, {}, &Sample::tick), samples_.end());
}

void SlideHistory::drop_every_second() {
    step_ *= 2;
    std::erase_if(samples_, [&](const Sample& sample) { return sample.tick % step_ != 0; });
}

void SlideHistory::find_houses(const sim::View& world) {
    for (House& house : houses_) house.thing.reset();
    lacks_houses_ = false;
    for (std::size_t i = 0; world.things && i < world.things->list.size(); ++i) {
        const sim::Thing& thing = world.things->list[i];
        if (thing.kind != sim::ThingKind::kHouse) continue;
        const glm::dvec2 at(thing.x, thing.y);
        const auto known = std::ranges::find(houses_, at, &House::at);
        if (known != houses_.end())
            known->thing = i;
        else if (houses_.size() < kMostHouses)
            houses_.push_back({at, i});
        else
            lacks_houses_ = true;
    }
}

}  // namespace game
