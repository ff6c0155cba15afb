#include "game/analysis/summary.h"

#include <algorithm>

#include <fmt/format.h>

#include "game/analysis/release_report.h"
#include "game/analysis/thing_report.h"
#include "game/analysis/trace.h"
#include "game/base/print.h"
#include "game/base/version.h"
#include "game/files/text_file.h"
#include "game/recording/divergence_report.h"

namespace game {
namespace {

Json mass_json(const Session& session, const sim::Ledger& mass) {
    const auto m3 = [&](std::int64_t quanta) { return session.cubic_metres(quanta); };
    Json json{{"initial_m3", m3(mass.initial)}, {"standing_m3", m3(mass.standing)},
              {"rolling_m3", m3(mass.rolling)}, {"out_m3", m3(mass.out)},
              {"poured_m3", m3(mass.poured)},   {"dug_m3", m3(mass.dug)}};
    if (session.state().weather) {
        json["fallen_m3"] = m3(mass.fallen);
        json["melted_m3"] = m3(mass.melted);
    }
    json["error_quanta"] = mass.mass_error();
    return json;
}

Json place_json(const Scenario& scenario, terrains::LocalPoint point) {
    Json json{{"x_m", point.x}, {"y_m", point.y}};
    if (const auto place = scenario.georeference.to_lat_lon(point)) {
        json["latitude"] = place->latitude;
        json["longitude"] = place->longitude;
    }
    return json;
}

Json measures_json(const Summary& summary) {
    const Measures& m = summary.measures;
    Json json{{"run_out_m", m.run_out},
              {"fall_m", m.fall},
              {"reach_deg", m.reach_deg},
              {"extent_ha", m.extent_area / 1e4},
              {"peak_depth_m", m.peak_depth},
              {"peak_thickness_m", m.peak_thickness},
              {"peak_speed_slope_m_s", m.peak_speed_slope},
              {"peak_speed_plan_m_s", m.peak_speed_plan},
              {"eroded_m3", m.eroded},
              {"deposited_m3", m.deposited},
              {"top", place_json(summary.scenario, m.top)},
              {"toe", place_json(summary.scenario, m.toe)}};
    if (m.peak_pressure) json["peak_pressure_kpa"] = *m.peak_pressure;
    json["narrow"] = {{"release", m.narrow_release}, {"flow", m.narrow_flow}};
    if (m.overlap) json["overlap"] = *m.overlap;
    if (m.changes) {
        const auto of = [&](const Measures::Change& change) {
            return Json{{"raised_m3", change.raised},
                        {"from", place_json(summary.scenario, change.from)},
                        {"to", place_json(summary.scenario, change.to)},
                        {"carried_m", change.carried}};
        };
        json["change"] = {{"here", of(m.changes->here)},
                          {"observed", of(m.changes->observed)},
                          {"apart_m", m.changes->apart}};
    }
    return json;
}

Json verdict_json(const Verdict& verdict) {
    Json json{{"outcome", to_string(verdict.kind())},
              {"comparable", verdict.comparable},
              {"states_compared", verdict.compared},
              {"proven_tick", verdict.proven_tick}};
    json["exact"] = verdict.kind() == Verdict::Kind::kExact;
    if (verdict.parted) json["parted"] = *verdict.parted;
    return json;
}

std::string placed(const Scenario& scenario, terrains::LocalPoint point) {
    const std::string where = scenario.georeference.describe(point);
    return where.empty() ? fmt::format("{:.0f} m east, {:.0f} m north", point.x, point.y) : where;
}

std::string paranoid_text(const SelfCheck& self_check, const Scenario& scenario) {
    const std::string compared = fmt::format("{}, and {}", self_check.names[0], self_check.names[1]);
    if (self_check.parted)
        return fmt::format("NOT the same: {}\n{}", compared,
                           to_text(*self_check.parted, scenario, self_check.names));
    return fmt::format("every tick done twice, all {} bit-identical: {}\n", self_check.ticks, compared);
}

Json paranoid_json(const SelfCheck& self_check, const Scenario& scenario) {
    Json json{{"ticks", self_check.ticks}, {"ways", self_check.names}, {"same", !self_check.parted}};
    if (self_check.parted) json["parted"] = to_json(*self_check.parted, scenario);
    return json;
}

std::string density_text(const Densities& densities) {
    if (densities.upper == densities.lower) return fmt::format("{:g} kg/m3", densities.upper);
    return fmt::format("{:g} to {:g} kg/m3", std::min(densities.upper, densities.lower),
                       std::max(densities.upper, densities.lower));
}

std::string size_text(const Scene::Size& size) {
    if (!size.released) return fmt::format("friction of size class {}, as asked for\n", one_line(size.name));
    return fmt::format("friction of size class {}, by {:.0f} m3 of release; --size-class overrides it\n",
                       one_line(size.name), *size.released);
}

std::string end_text(Ended ended, const Session& session) {
    switch (ended) {
        case Ended::kTick:
            return "";
        case Ended::kEnergy:
            return fmt::format(", at 1 % of its greatest kinetic energy; {:.0f} m3 still creep",
                               session.cubic_metres(session.state().ledger.rolling));
        case Ended::kStill:
            return ", at rest";
        case Ended::kLimit:
            break;
    }
    return ", NOT yet at rest";
}

std::string mass_text(const Session& session, const std::string& what, const sim::Ledger& mass) {
    const auto m3 = [&](std::int64_t quanta) { return session.cubic_metres(quanta); };
    const std::string weather = session.state().weather ? fmt::format("- fallen {:.1f} + melted {:.1f} ",
                                                                      m3(mass.fallen), m3(mass.melted))
                                                        : "";
    return fmt::format(
        "{}: standing {:.1f} + rolling {:.1f} + out {:.1f} - poured {:.1f} + dug {:.1f} {}= initial {:.1f} "
        "m3, "
        "error {} quanta\n",
        what, m3(mass.standing), m3(mass.rolling), m3(mass.out), m3(mass.poured), m3(mass.dug), weather,
        m3(mass.initial), mass.mass_error());
}

}  // namespace

std::string to_text(const Verdict& verdict) {
    switch (verdict.kind()) {
        case Verdict::Kind::kNotComparable:
            return "not comparable: recorded with another version of the physics, or in a newer format; "
                   "nothing is "
                   "verified\n";
        case Verdict::Kind::kDiffers:
            return fmt::format("NOT the same: {}\n", *verdict.parted);
        case Verdict::Kind::kNothingProven:
            return "nothing is verified: no state was recorded up to here\n";
        case Verdict::Kind::kExact:
            break;
    }
    return fmt::format("exact: all {} recorded states met, bit for bit; proven up to tick {}\n",
                       verdict.compared, verdict.proven_tick);
}

Json to_json(const Summary& summary) {
    const Scenario& scenario = summary.scenario;
    const sim::State& state = summary.session.state();
    Json json{{"program", kProgram},
              {"scene", scenario.scene},
              {"terrain", scenario.terrain},
              {"licence", scenario.licence},
              {"material", scenario.material},
              {"model", sim::to_string(scenario.params.model)},
              {"squares", {scenario.grid.nx - 1, scenario.grid.ny - 1}},
              {"cell_m", static_cast<double>(scenario.grid.dx)},
              {"ticks", state.tick},
              {"seconds", summary.session.seconds()},
              {"state_hash", hex(summary.session.state_line().hash)},
              {"mass", mass_json(summary.session, state.ledger)},
              {"measures", measures_json(summary)}};
    if (scenario.params.model == sim::Model::kBcre) {
        json["scheme"] = sim::to_string(scenario.params.scheme);
        json["law"] = sim::to_string(scenario.params.law);
    }
    if (state.limited > 0) json["speed_limited"] = state.limited;
    if (scenario.lower)
        json["lower"] = {{"material", scenario.lower->material},
                         {"mass", mass_json(summary.session, state.mixture->ledger)}};
    if (scenario.density) json["density_kg_m3"] = *scenario.density;
    if (scenario.lower && scenario.lower->density) json["lower"]["density_kg_m3"] = *scenario.lower->density;
    if (state.things) json["things"] = things_to_json(scenario, summary.session);
    if (summary.score) json["challenge"] = to_json(*scenario.goal, *summary.score);
    if (summary.release) json["release"] = to_json(*summary.release);
    if (summary.size) {
        json["size_class"] = {{"name", summary.size->name}};
        if (summary.size->released) json["size_class"]["released_m3"] = *summary.size->released;
    }
    if (summary.reference) json["reference"] = to_json(*summary.reference);
    if (summary.ended) json["ended"] = to_string(*summary.ended);
    if (summary.verdict) json["verified"] = verdict_json(*summary.verdict);
    if (summary.paranoid) json["paranoid"] = paranoid_json(*summary.paranoid, scenario);
    if (summary.perf) json["performance"] = summary.perf->to_json();
    return json;
}

std::string to_text(const Summary& summary) {
    const Scenario& scenario = summary.scenario;
    const Measures& m = summary.measures;
    const std::string materials = scenario.lower
                                      ? fmt::format("{} on {}", scenario.material, scenario.lower->material)
                                      : scenario.material;
    const Session& session = summary.session;
    std::string text =
        fmt::format("{}: {} on {}, {}x{} squares of {:.4g} m, {}\n", one_line(scenario.title),
                    one_line(materials), one_line(scenario.terrain), scenario.grid.nx - 1,
                    scenario.grid.ny - 1, scenario.grid.dx, sim::to_string(scenario.params.model));
    if (!scenario.licence.empty()) text += fmt::format("terrain: {}\n", one_line(scenario.licence));
    if (summary.release) text += to_text(*summary.release);
    if (summary.reference) text += to_text(*summary.reference);
    if (summary.size) text += size_text(*summary.size);
    text += fmt::format("{} ticks, {:.1f} s{}\n", session.state().tick, session.seconds(),
                        summary.ended ? end_text(*summary.ended, session) : "");
    if (m.run_out > 0) {
        text += fmt::format(
            "run-out {:.0f} m, fall {:.0f} m, reach {:.1f} deg; extent {:.2f} ha\n"
            "up to {:.1f} m deep, {:.1f} m thick normal to the slope\n",
            m.run_out, m.fall, m.reach_deg, m.extent_area / 1e4, m.peak_depth, m.peak_thickness);
        text += fmt::format("peak speed {:.1f} m/s along the slope, {:.1f} m/s in plan\n", m.peak_speed_slope,
                            m.peak_speed_plan);
        if (m.peak_pressure)
            text +=
                fmt::format("peak pressure {:.1f} kPa: {} times the square of the speed along the slope\n",
                            *m.peak_pressure, density_text(*session.densities()));
        if (m.peak_pressure && sim::has_momentum(scenario.params.model))
            text +=
                "near the toe, com1DFA was a fifth faster on seven paths, so pressure may be a third too low "
                "there: docs/validity.md\n";
        text += fmt::format("from {}\n  to {}\n", placed(scenario, m.top), placed(scenario, m.toe));
    }
    if (m.narrow_release)
        text +=
            fmt::format("NARROW: the release is nowhere {} cells wide, so its shape depends on the grid\n",
                        Measures::kLeastWidth);
    if (m.narrow_flow)
        text += fmt::format(
            "NARROW: where it was deepest, the flow was less than {} cells wide; on smaller cells it is "
            "deeper "
            "there\n",
            Measures::kLeastWidth);
    if (m.overlap)
        text += fmt::format("overlap with the reference {} {:.2f} (intersection over union)\n",
                            m.changes ? "change of 0.3 m and more" : "extent", *m.overlap);
    if (m.changes)
        text += fmt::format(
            "carried {:.0f} m, observed {:.0f} m, from the middle of the lowered volume to that of "
            "the raised one; "
            "{:.0f} m apart; raised {:.0f} m3, observed {:.0f} m3\n",
            m.changes->here.carried, m.changes->observed.carried, m.changes->apart, m.changes->here.raised,
            m.changes->observed.raised);
    text += mass_text(session, "mass", session.state().ledger);
    if (scenario.lower)
        text += mass_text(session, fmt::format("mass of {}", one_line(scenario.lower->material)),
                          session.state().mixture->ledger);
    text += fmt::format("eroded {:.0f} m3, deposited {:.0f} m3 (entrainment has no reference)\n", m.eroded,
                        m.deposited);
    if (session.state().limited > 0)
        text += fmt::format(
            "LIMITED: the speed passed {} m/s and was cut {} times, each at one vertex in one sub-step\n",
            scenario.params.greatest_speed, session.state().limited);
    if (session.state().things) text += things_to_text(scenario, session);
    if (summary.score) text += to_text(*scenario.goal, *summary.score);
    text += fmt::format("state hash {}\n", hex(session.state_line().hash));
    if (summary.verdict) text += to_text(*summary.verdict);
    if (summary.paranoid) text += paranoid_text(*summary.paranoid, scenario);
    if (summary.perf)
        for (const StageFigures& stage : summary.perf->figures())
            if (stage.count > 0)
                text +=
                    fmt::format("{:>6}: median {:.3f} ms, p95 {:.3f}, p99 {:.3f}, max {:.3f} over {} ticks\n",
                                stage.stage, stage.median, stage.p95, stage.p99, stage.most, stage.count);
    return text;
}

void add_outputs(const ResultOptions& options, FileUse& use) {
    use.writes("--perf", options.perf);
    use.writes("--trace", options.trace);
    use.writes("--summary", options.summary);
}

Outcome<void> make_places_for(const ResultOptions& options) {
    for (const auto& file : {options.perf, options.summary, options.trace})
        if (file)
            if (auto placed = make_place_for(*file); !placed) return placed;
    return {};
}

Outcome<void> tell(const Summary& summary, const ResultOptions& options) {
    if (options.perf)
        if (auto written = summary.perf->write_csv(*options.perf); !written) return written;
    if (options.summary)
        if (auto written = write_text(*options.summary, printed(to_json(summary))); !written) return written;
    if (options.trace) {
        const TracedRun run{summary.scenario.scene, summary.perf->rows()};
        if (auto written = write_text(*options.trace, trace_of(std::span(&run, 1))); !written) return written;
    }
    print_text(options.json ? printed(to_json(summary)) : to_text(summary));
    return {};
}

}  // namespace game
