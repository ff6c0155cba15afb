#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "game/recording/format.h"
#include "sim/core/workers.h"
#include "sim/sweep/sweeper.h"
#include "sim/world/quanta.h"
#include "sim/world/state_hash.h"
#include "tests/bench/world.h"

// Time of a step per cell and sub-step, in the worst case: material rolls in every cell. `solver` is the
// sub-step alone, `tick` a whole tick of one sub-step, with the velocity for views and the ledger. `of_limit`
// is the share of it that moving the layers through memory would take. The line includes the state hash,
// because a fast wrong answer is wrong. The hash must be the same on every machine, and change only with the
// physics.

using sim::Model;
using sim::Scheme;

namespace bench {

support::Play world_of(int squares, Model model, Scheme scheme, const sim::StepOptions& options) {
    constexpr float kDx = 5;
    support::Ground ground({squares + 1, squares + 1, kDx});
    ground.set(ground.bedrock,
               [](double x, double y) { return -0.7 * y + 3 * std::sin(x / 37) * std::sin(y / 53); });
    ground.set(ground.depth, [](double x, double y) { return 1 + 0.3 * std::sin(x / 17 + y / 29); });
    ground.set(ground.rolling, [](double x, double y) { return 0.5 + 0.2 * std::sin(x / 23 - y / 19); });
    sim::Params params = support::lively(model, scheme);
    params.borders.fill(sim::Border::kWall);
    params.tick_s = 1.f / 60;
    params.max_speed = 45;
    params.speed_per_slope = 41;
    params.rolling_speed = 15;
    return {ground, params, options};
}

}  // namespace bench

namespace {

constexpr int kSteps = 4;  // between two copies of the first state
constexpr int kTicksOfPatch = 100;
constexpr double kLeastTraffic = 20;  // bytes per cell that any step must move: 12 read, 8 written

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point before) {
    return std::chrono::duration<double>(Clock::now() - before).count();
}

// The lower bound of a step on this machine: reading b, d and R and writing d and R in the step's layout.
// Seconds per cell, the median of many passes.
double least_per_cell(const sim::Grid& grid, int threads) {
    sim::Field<float> bedrock(grid), depth(grid), rolling(grid);
    sim::Workers workers(threads);
    const auto pass = [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const float* b = bedrock.row(y);
            float* __restrict d = depth.row(y), * __restrict r = rolling.row(y);
            for (int x = 0; x < grid.nx; ++x) d[x] += b[x], r[x] -= b[x];
        }
    };
    constexpr int kPasses = 101;
    std::vector<double> times(kPasses);
    for (double& time : times) {
        const auto before = Clock::now();
        workers.each_band(grid.ny, pass);
        benchmark::ClobberMemory();
        time = seconds_since(before);
    }
    std::nth_element(times.begin(), times.begin() + kPasses / 2, times.end());
    return times[kPasses / 2] / static_cast<double>(grid.size());
}

// Times kSteps of `step(play, number)`, repeatedly from the same state.
template <class Step>
void time_steps(benchmark::State& run, Model model, Scheme scheme, const sim::StepOptions& options,
                const Step& step) {
    support::Play play = bench::world_of(static_cast<int>(run.range(0)), model, scheme, options);
    const sim::State first = play.state;
    double seconds = 0;
    for (auto _ : run) {
        play.state = first;
        const auto before = Clock::now();
        for (int i = 0; i < kSteps; ++i) step(play, i);
        const double time = seconds_since(before);
        run.SetIterationTime(time);
        seconds += time;
    }
    const double cells = static_cast<double>(first.grid.size()) * kSteps * sim::substeps_of(first).count *
                         static_cast<double>(run.iterations());
    using Counter = benchmark::Counter;
    run.counters["per_cell"] = Counter(cells, Counter::kIsRate | Counter::kInvert);  // s
    run.counters["bytes_per_s"] = Counter(cells * kLeastTraffic, Counter::kIsRate, Counter::kIs1024);
    run.counters["of_limit"] = least_per_cell(first.grid, options.threads) / (seconds / cells);
    run.SetLabel(game::hex(sim::state_hash(play.state)));
}

void solver(benchmark::State& run, Model model, Scheme scheme, const sim::StepOptions& options) {
    time_steps(run, model, scheme, options, [&](support::Play& play, int i) {
        play.engine.sweeper->substep(play.state, play.engine.workers, options.instruction_set,
                                     {play.state.params.tick_s, sim::dither_of(i)});
    });
}

void tick(benchmark::State& run, Model model, Scheme scheme, const sim::StepOptions& options) {
    time_steps(run, model, scheme, options, [](support::Play& play, int) { play.ticks(1); });
}

// The gain of tile sleep: a patch rolls on a slope whose rest lies still, so that a tenth of 1024² is awake,
// or all of it. Both run equally many ticks, so that the hash must be the same.
void patch_active(benchmark::State& run, Model model, Scheme scheme, bool may_sleep) {
    const auto squares = static_cast<int>(run.range(0));
    support::Ground ground({squares + 1, squares + 1, 5});
    const double side = 5. * squares;
    ground.set(ground.bedrock, [](double, double y) { return -0.52 * y; });  // between stop and erosion slope
    ground.set(ground.depth, [](double, double) { return 1; });
    ground.set(ground.rolling, [&](double x, double y) {
        return std::fabs(x / side - 0.5) < 0.06 && std::fabs(y / side - 0.5) < 0.2 ? 0.5 : 0;
    });
    sim::Params params = support::lively(model, scheme);
    params.borders.fill(sim::Border::kWall);
    support::Play play(ground, params, {.tiles_may_sleep = may_sleep});
    play.ticks(3);  // all tiles that may sleep are asleep
    for (auto _ : run) play.ticks(1);
    double awake = 0;
    for (const auto tile : play.state.tiles.awake) awake += tile;
    run.counters["awake"] = awake / static_cast<double>(play.state.tiles.awake.size());
    run.SetLabel(game::hex(sim::state_hash(play.state)));
}

void hash_of_state(benchmark::State& run) {
    const support::Play play =
        bench::world_of(static_cast<int>(run.range(0)), Model::kBcreInertial, Scheme::kLocalLaxFriedrichs);
    for (auto _ : run) benchmark::DoNotOptimize(sim::state_hash(play.state));
    const double bytes = 5 * sizeof(float) * static_cast<double>(play.state.grid.size());
    run.counters["bytes_per_s"] =
        benchmark::Counter(bytes * static_cast<double>(run.iterations()), benchmark::Counter::kIsRate,
                           benchmark::Counter::kIs1024);
}

using Timed = void (*)(benchmark::State&, Model, Scheme, const sim::StepOptions&);

void add(const std::string& name, Timed timed, Model model, Scheme scheme, const sim::StepOptions& options) {
    benchmark::RegisterBenchmark(name.c_str(), timed, model, scheme, options)
        ->Arg(80)
        ->Arg(160)
        ->Arg(512)
        ->Arg(1024)
        ->Arg(2048)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
    const auto add_ways = [](const std::string& name, Model model, Scheme scheme) {
        for (const auto set : sim::kInstructionSets)
            if (sim::has(set))
                add(name + ", solver, " + std::string(sim::to_string(set)), solver, model, scheme,
                    {.instruction_set = set});
        add(name + ", solver, two threads", solver, model, scheme, {.threads = 2});
        add(name + ", tick", tick, model, scheme, {});
        add(name + ", tick, plain", tick, model, scheme, {.plain = true});
        for (const bool may_sleep : {false, true})
            benchmark::RegisterBenchmark(
                (name + ", a patch active, " + (may_sleep ? "the rest asleep" : "all awake")).c_str(),
                patch_active, model, scheme, may_sleep)
                ->Arg(512)
                ->Arg(1024)
                ->Iterations(kTicksOfPatch)
                ->Unit(benchmark::kMillisecond);
    };
    for (const Scheme scheme : {Scheme::kLaxFriedrichs, Scheme::kLocalLaxFriedrichs, Scheme::kMuscl})
        add_ways(std::string(sim::to_string(scheme)), Model::kBcre, scheme);
    add_ways("bcre-inertial", Model::kBcreInertial, Scheme::kLocalLaxFriedrichs);
    add_ways("voellmy", Model::kVoellmy, Scheme::kLocalLaxFriedrichs);
    bench::add_stages();
    bench::add_fronts();
    benchmark::RegisterBenchmark("state hash", hash_of_state)->Arg(160)->Arg(1024);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
