#include <chrono>
#include <cstdio>
#include <string>

#include <benchmark/benchmark.h>

#include "sim/quanta.h"
#include "sim/state_hash.h"
#include "tests/bench/world.h"

// Nanoseconds per cell and sub-step of the whole step, in the worst case: material rolls in every cell. The
// state hash stands in the same line, because a fast wrong answer is wrong: it must be the same on every
// machine, and change only with the physics.

using sim::Model;
using sim::Scheme;

namespace bench {

support::Play world_of(int squares, Model model, Scheme scheme, const sim::How& how) {
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
    return {ground, params, how};
}

}  // namespace bench

namespace {

constexpr int kTicks = 4;             // of one sub-step each, between two copies of the first state
constexpr double kLeastTraffic = 20;  // bytes per cell that any step must move: 12 read, 8 written

void whole_step(benchmark::State& run, Model model, Scheme scheme, const sim::How& how) {
    const auto squares = static_cast<int>(run.range(0));
    support::Play play = bench::world_of(squares, model, scheme, how);
    const sim::State first = play.state;
    for (auto _ : run) {
        play.state = first;
        const auto before = std::chrono::steady_clock::now();
        play.ticks(kTicks);
        run.SetIterationTime(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
    }
    const double cells = static_cast<double>(first.grid.size()) * kTicks * sim::substeps_of(first).count *
                         static_cast<double>(run.iterations());
    using Counter = benchmark::Counter;
    run.counters["per_cell"] = Counter(cells, Counter::kIsRate | Counter::kInvert);  // s
    run.counters["bytes_per_s"] = Counter(cells * kLeastTraffic, Counter::kIsRate, Counter::kIs1024);
    char hash[32];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(sim::state_hash(play.state)));
    run.SetLabel(hash);
}

// What sleeps: a patch that rolls on a slope on which the rest lies still, so that a tenth of 1024² is awake.
void patch_active(benchmark::State& run, Model model, bool may_sleep) {
    const auto squares = static_cast<int>(run.range(0));
    support::Ground ground({squares + 1, squares + 1, 5});
    const double side = 5. * squares;
    ground.set(ground.bedrock, [](double, double y) { return -0.52 * y; });  // between stop and erosion slope
    ground.set(ground.depth, [](double, double) { return 1; });
    ground.set(ground.rolling, [&](double x, double y) {
        return std::fabs(x / side - 0.5) < 0.06 && std::fabs(y / side - 0.5) < 0.2 ? 0.5 : 0;
    });
    sim::Params params = support::lively(model);
    params.borders.fill(sim::Border::kWall);
    support::Play play(ground, params, {.tiles_may_sleep = may_sleep});
    play.ticks(3);  // what may sleep has fallen asleep
    for (auto _ : run) play.ticks(1);
    double awake = 0;
    for (const auto tile : play.state.tiles.awake) awake += tile;
    run.counters["awake"] = awake / static_cast<double>(play.state.tiles.awake.size());
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

void add(const std::string& name, Model model, Scheme scheme, const sim::How& how) {
    benchmark::RegisterBenchmark(name.c_str(), whole_step, model, scheme, how)
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
                add(name + ", " + std::string(sim::to_string(set)), model, scheme, {.instruction_set = set});
        add(name + ", two threads", model, scheme, {.threads = 2});
        add(name + ", plain", model, scheme, {.plain = true});
    };
    for (const Scheme scheme : {Scheme::kLaxFriedrichs, Scheme::kLocalLaxFriedrichs, Scheme::kMuscl})
        add_ways(std::string(sim::to_string(scheme)), Model::kBcre, scheme);
    add_ways("bcre-inertial", Model::kBcreInertial, Scheme::kLocalLaxFriedrichs);
    bench::add_stages();
    for (const Model model : {Model::kBcre, Model::kBcreInertial})
        for (const bool may_sleep : {false, true})
            benchmark::RegisterBenchmark((std::string(sim::to_string(model)) + ", a patch active, " +
                                          (may_sleep ? "the rest asleep" : "all awake"))
                                             .c_str(),
                                         patch_active, model, may_sleep)
                ->Arg(512)
                ->Arg(1024)
                ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("state hash", hash_of_state)->Arg(160)->Arg(1024);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
