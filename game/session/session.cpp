#include "game/session/session.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "game/recording/command_source.h"

namespace game {
namespace {

// Renewal rate of the textures advected with a rolling layer.
constexpr sim::front::LayerRule kTextures{.shortest_s = 0.5f, .deformation = 0.3f};

double ms_since(std::chrono::steady_clock::time_point before) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
}

template <class Stage>
double ms_of(const Stage& stage) {
    const auto before = std::chrono::steady_clock::now();
    stage();
    return ms_since(before);
}

}  // namespace

Session::Session(const Scenario& scenario, const sim::StepOptions& options)
    : state_(sim::make_state(initial_state_of(scenario), scenario.params)),
      engine_(std::make_unique<sim::Engine>(state_, options)),
      densities_(densities_of(scenario)),
      peaks_(state_, densities_),
      structures_(view()) {
    line_.before.reserve(kTicksPerState);
    undisturbed_.resize(state_.grid.size());
    find_undisturbed();
    if (scenario.goal) try_.emplace(*scenario.goal, state_);
    find_hash();
    peaks_.see(state_);
}

Outcome<Session> Session::begin(const Scenario& scenario, const sim::StepOptions& options,
                                std::optional<Recorder> recorder) {
    Session session(scenario, options);
    if (recorder)
        if (const auto written = session.record_from_start(std::move(*recorder)); !written)
            return tl::unexpected(written.error());
    return session;
}

Outcome<void> Session::advance(std::span<const sim::Command> commands) {
    const bool records = recorder_ && state_.tick >= recorded_until_;
    // In the first tick, ground may be too steep to stand; later only after a command.
    const bool rests = state_.tick > 0 && commands.empty() && sim::at_rest(state_);
    const bool is_hour = commands.empty() && sim::is_calm(state_);
    auto begun = std::chrono::steady_clock::now();
    const auto record = [&]() -> Outcome<void> {
        if (records)
            for (const sim::Command& command : commands)
                if (auto written = recorder_->command({state_.tick, command}); !written) return written;
        begun = std::chrono::steady_clock::now();
        return {};
    };
    if (auto advanced = advance_world(state_, commands, *engine_, record); !advanced) return advanced;
    times_ = {};
    times_.solve_ms = ms_since(begun);

    if (hashes_) {
        if (line_.tick % kTicksPerState == 0)
            line_.before.clear();
        else
            line_.before.push_back(line_.hash);
        find_hash();
    }
    if (!rests) changed_at_ = state_.tick;
    if (is_hour) find_undisturbed();
    // At rest the fronts do not change. A flow demo never rests.
    if ((fronts_ && !rests) || stage_) advance_fronts();
    std::int64_t error = state_.ledger.mass_error();
    if (error == 0 && state_.mixture) error = state_.mixture->ledger.mass_error();
    if (error != 0)
        return tl::unexpected(Failure{
            Failure::kBadAnswer,
            fmt::format("tick {}: mass not conserved: {} m3; layers deeper than {} m are not counted exactly",
                        state_.tick, cubic_metres(error), sim::kDeepest)});
    times_.peaks_ms = ms_of([&] {
        peaks_.see(state_);
        if (try_) try_->see(state_, !commands.empty());
        if (!rests) watch_structures();
        if (powder_) advance_powder(commands, rests);
        if (carried_ && carried_->advance(view(), state_.params.tick_s)) changed_at_ = state_.tick;
    });
    if (!records) return {};
    recorded_until_ = state_.tick;
    return state_.tick % kTicksPerState == 0 ? write_state() : Outcome<void>();
}

Outcome<void> Session::finish() {
    auto ended = end_recording();
    if (ended) delete_replaced();
    return ended;
}

void Session::delete_replaced() {
    if (recorder_) recorder_->delete_replaced();
}

Outcome<void> Session::end_recording() {
    if (!recorder_) return {};
    // Also writes the last state, so that the whole recording can be verified.
    if (auto written = write_state(); !written) return written;
    return recorder_->end(recorded_until_);
}

Outcome<std::string> Session::recorded_so_far() const {
    CHECK(recorder_);
    return recorder_->copy_ended_at(recorded_until_, lacks_state() ? &line_ : nullptr);
}

// Whether this is the last recorded tick, and its state has no line yet.
bool Session::lacks_state() const {
    return state_.tick == recorded_until_ && recorder_->last_state() != state_.tick;
}

Outcome<void> Session::write_state() {
    return lacks_state() ? recorder_->state(line_) : Outcome<void>();
}

Outcome<void> Session::claim(const ClaimLine& line) {
    if (!recorder_ || state_.tick != recorded_until_) return {};
    return recorder_->claim(line);
}

Session::Checkpoint Session::moment() const {
    Checkpoint moment{sim::take_snapshot(state_), std::nullopt, {}, {}, peaks(), try_, line_, std::nullopt};
    if (powder_) moment.powder.assign(powder_->puffs().begin(), powder_->puffs().end());
    if (carried_) moment.carried.assign(carried_->bodies().begin(), carried_->bodies().end());
    if (fronts_) moment.textures = fronts_->memory();
    if (recorder_) moment.mark = recorder_->mark();
    return moment;
}

Outcome<void> Session::rewind(const Checkpoint& moment) {
    put(moment);
    recorded_until_ = state_.tick;
    if (recorder_ && moment.mark) return recorder_->rewind(*moment.mark);
    return {};
}

Outcome<void> Session::go_to(const Checkpoint& moment) {
    if (recorder_)
        if (auto written = write_state(); !written) return written;
    put(moment);
    return {};
}

void Session::put(const Checkpoint& moment) {
    sim::restore(moment.world, state_);
    if (state_.weather) find_undisturbed();
    if (fronts_ && moment.textures) fronts_->restore(view(), *moment.textures, engine_->workers);
    if (fronts_ && !moment.textures) fronts_->begin_anew(view(), engine_->workers);
    if (powder_) powder_->restore(moment.powder);
    if (carried_) carried_->restore(moment.carried);
    peaks_.go_on(moment.peaks);
    peaks_.see(state_);
    watch_structures();
    try_ = moment.challenge;
    line_ = moment.line;
    changed_at_ = state_.tick;
}

void Session::record_in(Recorder recorder) {
    recorder_ = std::move(recorder);
    recorded_until_ = state_.tick;
}

Outcome<void> Session::record_from_start(Recorder recorder) {
    CHECK(state_.tick == 0);
    record_in(std::move(recorder));
    return write_state();
}

void Session::hash_when_asked() {
    CHECK(!recorder_);
    hashes_ = false;
}

std::uint64_t Session::hash_now() {
    find_hash();
    return line_.hash;
}

void Session::find_undisturbed() {
    const sim::Field<float>& from = state_.weather ? state_.weather->undisturbed : state_.depth;
    for (int y = 0; y < state_.grid.ny; ++y)
        std::copy_n(from.row(y), state_.grid.nx,
                    undisturbed_.begin() + std::ptrdiff_t{y} * std::ptrdiff_t{state_.grid.nx});
}

void Session::find_hash() {
    times_.hash_ms = ms_of([&] {
        line_.tick = state_.tick;
        line_.hash = sim::update_state_hash(state_, engine_->workers);
        line_.ledger = state_.ledger;
    });
    CHECK(line_.hash == sim::state_hash(state_));
}

double Session::cubic_metres(std::int64_t quanta) const {
    return static_cast<double>(quanta) * static_cast<double>(sim::kQuantum) * state_.grid.cell_area();
}

void Session::follow_fronts(const Scenario& scenario, std::size_t most_vertices) {
    if (state_.grid.size() > most_vertices) return;
    if (scenario.flow)
        stage_ = std::make_unique<sim::fields::FlowStage>(state_.grid, scenario.flow->flow,
                                                          scenario.flow->numbers);
    else if (scenario.look.flow)
        fronts_ = std::make_unique<WorldFronts>(state_.grid, scenario.look.rolling_visible_m, kTextures,
                                                undisturbed_);
    else
        return;
    advance_fronts();
}

void Session::follow_powder(const Scenario& scenario) {
    const auto rule = [](const render::PowderLook& look) {
        return sim::powder::Rule{look.strength, look.speed};
    };
    const sim::powder::Rule upper = rule(scenario.look.powder);
    const sim::powder::Rule lower = scenario.lower ? rule(scenario.look.lower_powder) : sim::powder::Rule{};
    if (scenario.model || scenario.flow || (upper.strength <= 0 && lower.strength <= 0)) return;
    powder_.emplace(upper, lower, velocity(scenario.wind));
}

void Session::follow_carried(const Scenario& scenario) {
    const render::Look& look = scenario.look;
    if (scenario.model || scenario.flow || !look.date) return;
    const auto is_soil = [](const glm::vec3& standing) { return standing.g < 0.4f; };  // dark, unlike snow
    const bool upper = is_soil(look.standing), lower = scenario.lower && is_soil(look.lower_standing);
    if (upper || lower) carried_.emplace(scenario.depth, upper, lower);
}

// While nothing moves, the cloud settles; after that nothing is left to do.
void Session::advance_powder(std::span<const sim::Command> commands, bool rests) {
    if (rests && powder_->puffs().empty()) return;
    powder_->advance(view(), state_.params.tick_s);
    for (const sim::Command& command : commands)
        if (command.kind == sim::CommandKind::kBlast)
            powder_->blast(view(), glm::vec2(command.x, command.y), static_cast<float>(command.radius));
    changed_at_ = state_.tick;
}

void Session::advance_fronts() {
    const auto tick_s = static_cast<double>(state_.params.tick_s);
    if (stage_) {
        times_.track_ms = ms_of([&] { stage_->advance(tick_s, engine_->workers); });
        changed_at_ = state_.tick;
        return;
    }
    times_.track_ms = ms_of([&] { fronts_->track(view(), tick_s, engine_->workers); });
    times_.advect_ms = ms_of([&] { fronts_->carry(tick_s, engine_->workers); });
    times_.gradient_ms = ms_of([&] { fronts_->settle(tick_s, engine_->workers); });
}

}  // namespace game
