#include "tests/bench/world.h"

#include <functional>

#include <benchmark/benchmark.h>

#include "sim/bcre/constants.h"
#include "sim/bcre/inertial.h"
#include "sim/bcre/plain.h"
#include "sim/borders.h"
#include "sim/quanta.h"

// Nanoseconds per cell of each stage of a step by itself, on one thread, where the step would call it: the
// world and the scratch are those of a step that was done before.

namespace bench {
namespace {

using sim::Model;
using sim::Scheme;

constexpr auto kLocal = Scheme::kLocalLaxFriedrichs;

struct Place {
    sim::State& s;
    sim::Scratch<float>& scratch;
    const sim::Params& params;
    sim::Substep<float> sub;
    sim::bcre::Constants<float> c;
    int rows;
};
using Stage = void (*)(const Place&);

void one_stage(benchmark::State& run, Model model, Scheme scheme, Stage stage) {
    support::Play play = world_of(static_cast<int>(run.range(0)), model, scheme, {.plain = true});
    play.ticks(1);
    const sim::Substep<float> sub{play.state.params.tick_s, 0.5f};
    const Place place{play.state,
                      *play.engine.scratch,
                      play.state.params,
                      sub,
                      sim::bcre::constants_of(play.state.params, play.state.grid.dx, sub),
                      play.state.grid.ny};
    for (auto _ : run) {
        stage(place);
        benchmark::ClobberMemory();
    }
    run.counters["per_cell"] = benchmark::Counter(
        static_cast<double>(play.state.grid.size()) * static_cast<double>(run.iterations()),
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);  // s
}

}  // namespace

void add_stages() {
    struct Entry {
        const char* name;
        Model model;
        Scheme scheme;
        Stage stage;
    };
    constexpr auto kBcre = Model::kBcre;
    constexpr auto kInertial = Model::kBcreInertial;
    const Entry entries[] = {
        {"fill_borders", kBcre, kLocal, [](const Place& p) { sim::fill_borders(p.s, p.params); }},
        {"find_slope", kBcre, kLocal,
         [](const Place& p) { sim::bcre::find_slope(p.s, p.scratch, kLocal, 0, p.rows); }},
        {"find_pace", kBcre, kLocal,
         [](const Place& p) { sim::bcre::find_pace(p.s, p.scratch, p.c, 0, p.rows); }},
        {"find_gives", kBcre, kLocal,
         [](const Place& p) { sim::bcre::find_gives(p.s, p.scratch, kLocal, p.c, 0, p.rows); }},
        {"book_gives", kBcre, kLocal,
         [](const Place& p) { sim::bcre::book_gives(p.s, p.scratch, kLocal, p.c, 0, p.rows); }},
        {"carry_gives", kBcre, kLocal,
         [](const Place& p) { sim::bcre::carry_gives(p.s, p.scratch, 0, p.rows); }},
        {"find_exchange", kBcre, kLocal,
         [](const Place& p) { sim::bcre::find_exchange(p.s, p.scratch, kLocal, p.c, 0, p.rows); }},
        {"settle", kBcre, kLocal, [](const Place& p) { sim::bcre::settle(p.s, p.scratch, p.c, 0, p.rows); }},
        {"find_velocity", kBcre, kLocal,
         [](const Place& p) { sim::bcre::find_velocity(p.s, p.c, 0, p.rows); }},
        {"inertial_relax", kInertial, kLocal,
         [](const Place& p) { sim::bcre::inertial_relax(p.s, p.params, p.sub, 0, p.rows); }},
        {"inertial_exchange", kInertial, kLocal,
         [](const Place& p) { sim::bcre::inertial_exchange(p.s, p.params, p.scratch, p.sub, 0, p.rows); }},
        {"inertial_fluxes", kInertial, kLocal,
         [](const Place& p) { sim::bcre::inertial_fluxes(p.s, p.s.rolling, p.scratch, p.sub, 0, p.rows); }},
        {"inertial_predict", kInertial, kLocal,
         [](const Place& p) { sim::bcre::inertial_predict(p.s, p.scratch, 0, p.rows); }},
        {"inertial_book", kInertial, kLocal,
         [](const Place& p) { sim::bcre::inertial_book(p.scratch, p.sub, 0, p.rows); }},
        {"inertial_finish", kInertial, kLocal,
         [](const Place& p) { sim::bcre::inertial_finish(p.s, p.params, p.scratch, p.sub, 0, p.rows); }},
        {"inertial_yield", kInertial, kLocal,
         [](const Place& p) { sim::bcre::inertial_yield(p.s, p.params, p.scratch, 0, p.rows); }},
        {"count_mass", kBcre, kLocal, [](const Place& p) { sim::count_mass(p.s); }},
    };
    for (const Entry& entry : entries)
        benchmark::RegisterBenchmark(entry.name, one_stage, entry.model, entry.scheme, entry.stage)
            ->Arg(160)
            ->Arg(512);
}

}  // namespace bench
