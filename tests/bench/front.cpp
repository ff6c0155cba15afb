#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "game/session/world_fronts.h"
#include "sim/core/workers.h"
#include "sim/fields/test_flows.h"
#include "sim/front/gradient.h"
#include "tests/bench/world.h"
#include "tests/replay/play.h"

// Time to track fronts and advect their textures, on one thread: the detector's check of every edge, a point
// on a front by each source, the gradient at a vertex beside it, a vertex that moves; and all of it for a
// tick of the snow avalanche. The scene is the disc, whose front is closed. The line includes a hash of the
// result.

namespace bench {
namespace {

using sim::front::Detector;
using sim::front::Mesh;
using sim::front::PointSource;
using sim::front::Rule;
using sim::front::TextureLayers;
using sim::front::Tracker;

constexpr double kStep = 1 / 60.0;
constexpr float kJump = 0.05f;  // m/s

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point before) {
    return std::chrono::duration<double>(Clock::now() - before).count();
}

// FNV-1a, of any type without padding.
template <class T>
void set_hash(benchmark::State& run, std::span<const T> of) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const std::byte byte : std::as_bytes(of))
        hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
    run.SetLabel(game::hex(hash));
}

void count(benchmark::State& run, const char* name, double things) {
    run.counters[name] =
        benchmark::Counter(things, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);  // s per item
}

// The disc on a mesh of the unit square, step by step.
struct Scene {
    Mesh mesh;
    Rule gradient, level;
    std::vector<std::vector<glm::vec2>> velocity;  // m/s, of each step
    std::vector<std::vector<float>> scalar;        // distance from the disc's rim, below 0 inside, m

    Scene(int squares, int steps)
        : mesh(sim::front::mesh_of(sim::Grid{squares + 1, squares + 1, 1 / static_cast<float>(squares)})),
          gradient(sim::front::gradient_rule(kJump, 1 / static_cast<float>(squares))) {
        level.kind = Rule::Kind::kLevel;
        const auto flow = sim::fields::disc();
        for (int step = 1; step <= steps; ++step) {
            auto& v = velocity.emplace_back();
            auto& s = scalar.emplace_back();
            for (const glm::vec2& at : mesh.position) {
                const glm::dvec2 x(at);
                v.push_back(flow.velocity(x, step * kStep));
                const double away = flow.distance(x, step * kStep);
                s.push_back(static_cast<float>(flow.region(x, step * kStep) ? away : -away));
            }
        }
    }
    sim::front::Flow flow(int step) const { return {velocity[step], scalar[step]}; }
    int steps() const { return static_cast<int>(velocity.size()); }
};

// Forward and back again, so that successive steps are neighbours.
void scan(benchmark::State& run, Rule::Kind kind) {
    const Scene scene(static_cast<int>(run.range(0)), 16);
    Rule rule = kind == Rule::Kind::kLevel ? scene.level : scene.gradient;
    rule.kind = kind;
    Detector detector(scene.mesh, rule);
    const int last = scene.steps() - 1;
    for (int i = 0; i <= last; ++i) detector.update(scene.flow(i));
    int step = last, way = -1;
    for (auto _ : run) {
        if (step + way < 0 || step + way > last) way = -way;
        step += way;
        detector.update(scene.flow(step));
    }
    count(run, "per_edge", scene.mesh.edges() * static_cast<double>(run.iterations()));
    detector.update(scene.flow(0));
    set_hash(run, detector.cut());
}

void track(benchmark::State& run, PointSource source) {
    const Scene scene(static_cast<int>(run.range(0)), 120);
    sim::Workers workers(1);
    double points = 0;
    for (auto _ : run) {
        Tracker tracker(scene.mesh, source == PointSource::kLevel ? scene.level : scene.gradient, source);
        double seconds = 0;
        for (int i = 0; i < scene.steps(); ++i) {
            const auto before = Clock::now();
            tracker.advance(scene.flow(i), kStep, workers);
            seconds += seconds_since(before);
            points += static_cast<double>(tracker.points().size());
        }
        run.SetIterationTime(seconds);
        set_hash(run, tracker.points());
    }
    count(run, "per_point", points);
}

// Textures after this long a run.
struct Travelled {
    Scene scene;
    sim::Workers workers{1};
    Tracker tracker;
    TextureLayers layers;

    explicit Travelled(int squares)
        : scene(squares, 60),
          tracker(scene.mesh, scene.gradient, PointSource::kFit),
          layers(scene.mesh, sim::front::LayerRule{}) {
        for (int i = 0; i < scene.steps(); ++i) {
            tracker.advance(scene.flow(i), kStep, workers);
            layers.advance(tracker, scene.velocity[i], kStep, workers);
        }
    }
};

void gradients(benchmark::State& run) {
    const Travelled at(static_cast<int>(run.range(0)));
    std::vector<TextureLayers::Gradients> gradient(at.layers.beside_front().size());
    for (auto _ : run) {
        for (std::size_t i = 0; i < gradient.size(); ++i) {
            gradient[i] = {};
            sim::front::find_gradients<TextureLayers::kSheets>(
                at.tracker.detector(), at.layers.beside_front()[i], at.layers.offsets(), gradient[i]);
        }
        benchmark::ClobberMemory();
    }
    count(run, "per_vertex", static_cast<double>(gradient.size() * run.iterations()));
    set_hash(run, std::span<const TextureLayers::Gradients>(gradient));
}

// All moving parts, repeatedly from the same state.
void carry(benchmark::State& run) {
    Travelled at(static_cast<int>(run.range(0)));
    const auto& velocity = at.scene.velocity.back();
    const auto memory = at.layers.memory();
    for (auto _ : run) {
        at.layers.restore(memory);
        const auto before = Clock::now();
        at.layers.carry(at.tracker, velocity, kStep, at.workers);
        run.SetIterationTime(seconds_since(before));
    }
    const auto moving =
        std::count_if(velocity.begin(), velocity.end(), [](const glm::vec2& v) { return v != glm::vec2(0); });
    count(run, "per_vertex", static_cast<double>(moving) * static_cast<double>(run.iterations()));
    set_hash(run, at.layers.offsets());
}

// A whole tick of the shipped avalanche, on its 160² squares, without the avalanche simulation itself.
void snow_avalanche(benchmark::State& run) {
    if (const auto there = game::find_asset(game::AssetKind::kRecording, "snow-avalanche"); !there)
        return run.SkipWithError(there.error().sentence.c_str());
    const game::Recording recording = game::test::open("snow-avalanche");
    sim::Workers workers(1);
    std::vector<double> times;
    double points = 0;
    for (auto _ : run) {
        std::optional<game::WorldFronts> fronts;
        double seconds = 0;
        game::test::play(recording, 1, recording.last_tick(), [&](const game::Session& now) {
            if (!fronts) fronts.emplace(now.state().grid, 0.1f, sim::front::LayerRule{});
            const double dt = now.state().params.tick_s;
            const auto before = Clock::now();
            fronts->track(now.view(), dt, workers);
            fronts->carry(dt, workers);
            fronts->settle(dt, workers);
            times.push_back(seconds_since(before));
            seconds += times.back();
            points += static_cast<double>(fronts->view().tracker().points().size());
        });
        run.SetIterationTime(seconds);
        set_hash(run, fronts->view().layers().offsets());
    }
    std::sort(times.begin(), times.end());
    run.counters["median"] = times[times.size() / 2];  // s per tick
    run.counters["p95"] = times[times.size() * 95 / 100];
    run.counters["worst"] = times.back();
    run.counters["points"] = points / static_cast<double>(times.size());
}

void sized(benchmark::internal::Benchmark* one) {
    one->Arg(80)->Arg(160)->Arg(512)->Unit(benchmark::kMicrosecond);
}

}  // namespace

void add_fronts() {
    for (const auto& [name, kind] :
         {std::pair("gradient", Rule::Kind::kGradient), std::pair("relative", Rule::Kind::kRelative),
          std::pair("level", Rule::Kind::kLevel)})
        benchmark::RegisterBenchmark((std::string("fronts, scan, ") + name).c_str(), scan, kind)
            ->Apply(sized);
    for (const PointSource source :
         {PointSource::kHalf, PointSource::kPaper, PointSource::kFit, PointSource::kLevel})
        benchmark::RegisterBenchmark(("fronts, track, " + std::string(to_string(source))).c_str(), track,
                                     source)
            ->Arg(80)
            ->Arg(160)
            ->UseManualTime()
            ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("fronts, gradients", gradients)->Apply(sized);
    benchmark::RegisterBenchmark("fronts, carry", carry)->Apply(sized)->UseManualTime();
    benchmark::RegisterBenchmark("fronts, snow avalanche, all ticks", snow_avalanche)
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

}  // namespace bench
