#include "tests/bench/world.h"

#include <functional>

#include <benchmark/benchmark.h>

#include "sim/bcre/plain.h"
#include "sim/bcre/stages.h"
#include "sim/sweep/count_mass.h"
#include "sim/world/quanta.h"

// Nanoseconds per cell of each stage of a step, on one thread, called in the order of the step. The world and
// the scratch are those of a preceding step.

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
    mutable sim::bcre::StageRows<float> w;
    int rows;
};
using Stage = void (*)(const Place&);

template <class Stage>
void each_row(const Place& p, Stage&& stage) {
    for (int y = 0; y < p.rows; ++y) sim::along<float>({0, p.w.nx}, stage(y));
}
template <class Stage>
void each_face(const Place& p, Stage&& stage) {
    for (int y = 0; y <= p.rows; ++y) sim::along<float>(sim::Span{0, p.w.nx}.faces(), stage(y));
}

void one_stage(benchmark::State& run, Model model, Scheme scheme, Stage stage) {
    support::Play play = world_of(static_cast<int>(run.range(0)), model, scheme, {.plain = true});
    play.ticks(1);
    const sim::Substep<float> sub{play.state.params.tick_s, 0.5f};
    const Place place{play.state,
                      *play.engine.scratch,
                      play.state.params,
                      sub,
                      sim::bcre::stage_rows(play.state, play.state.params, play.engine.scratch->bcre(), sub),
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
    const Entry entries[] = {
        {"fill_halo", kBcre, kLocal,
         [](const Place& p) {
             for (int y = 0; y < p.rows; ++y) sim::fill_halo<float>(p.w, p.w.u0, y, {0, p.w.nx});
         }},
        {"find_drops", kBcre, kLocal,
         [](const Place& p) {
             each_face(p, [&](int y) {
                 return sim::find_drops<float>(p.w, p.w.u0, p.w.u0.drop_x, p.w.u0.drop_y, y);
             });
         }},
        {"find_slope_dx", kBcre, kLocal,
         [](const Place& p) {
             each_row(p, [&](int y) { return sim::bcre::find_slope_dx<float>(p.w.u0, p.w.u0.slope_dx, y); });
         }},
        {"find_outflow", kBcre, kLocal,
         [](const Place& p) {
             each_row(p, [&](int y) { return sim::bcre::find_outflow<float>(p.w, p.w.outflow, y); });
         }},
        {"find_split_fluxes", kBcre, kLocal,
         [](const Place& p) {
             each_face(p, [&](int y) {
                 return sim::bcre::find_split_fluxes<float>(p.w, p.w.flux_x, p.w.flux_y, y);
             });
         }},
        {"settle", kBcre, kLocal,
         [](const Place& p) {
             each_row(p, [&](int y) { return sim::bcre::settle<float, kLocal>(p.w, p.w.u0, y, p.w.nx); });
         }},
        {"count_mass", kBcre, kLocal, [](const Place& p) { sim::count_mass(p.s); }},
    };
    for (const Entry& entry : entries)
        benchmark::RegisterBenchmark(entry.name, one_stage, entry.model, entry.scheme, entry.stage)
            ->Arg(160)
            ->Arg(512);
}

}  // namespace bench
