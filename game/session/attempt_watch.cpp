#include "game/session/attempt_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace game {

AttemptWatch::AttemptWatch(const Goal& goal, const sim::State& start) {
    const auto ticks = [&](double seconds) {
        return std::llrint(seconds / static_cast<double>(start.params.tick_s));
    };
    calm_ = ticks(kCalm);
    earliest_ = ticks(goal.earliest_s);
    if (!goal.events.empty()) last_event_ = goal.events.back().tick;
    if (goal.latest_s) latest_ = ticks(*goal.latest_s);
    for (const TimedCommand& event : goal.events)
        if (event.command.kind == sim::CommandKind::kBlast) blast_ = event;
    if (blast_) first_ = mass_under_blast(start);
}

void AttemptWatch::see(const sim::State& state, bool acted) {
    if (ended_at_) return;
    if (blast_ && state.tick == blast_->tick && first_.depth > 0) {
        const Mass now = mass_under_blast(state);
        slab_ = {now.depth / first_.depth, now.depth > 0 ? now.moment / now.depth : glm::dvec2(0), 0};
        if (state.things)
            for (const sim::Thing& thing : state.things->list)
                if (thing.kind == sim::ThingKind::kHouse) slab_->load = std::max(slab_->load, thing.load);
    }
    if (acted) {
        acted_at_ = state.tick - 1;
        if (!begun_at_) begun_at_ = acted_at_;
        reach_.fill(std::numeric_limits<int>::min());
        greatest_energy_ = 0;
    }
    if (!begun_at_) return;
    const Reach before = reach_;
    const double energy = see_flow(state);
    greatest_energy_ = std::max(greatest_energy_, energy);
    if (acted || reach_ != before || !state.running_commands.empty()) farther_at_ = state.tick;
    const bool calm = state.tick - farther_at_ >= calm_ && energy <= kCalmShare * greatest_energy_;
    const bool may_end = state.tick > last_event_ && state.tick - acted_at_ >= earliest_;
    const bool is_late = latest_ && state.tick - *begun_at_ >= *latest_;
    if ((calm && may_end) || is_late) ended_at_ = state.tick;
}

AttemptWatch::Mass AttemptWatch::mass_under_blast(const sim::State& state) const {
    const sim::Command& blast = blast_->command;
    const auto dx = static_cast<double>(state.grid.dx);
    const auto cells = [&](double metres, int most) {
        return static_cast<int>(std::clamp(metres / dx, 0.0, static_cast<double>(most - 1)));
    };
    Mass mass;
    for (int y = cells(blast.y - blast.radius, state.grid.ny);
         y <= cells(blast.y + blast.radius, state.grid.ny); ++y)
        for (int x = cells(blast.x - blast.radius, state.grid.nx);
             x <= cells(blast.x + blast.radius, state.grid.nx); ++x) {
            const glm::dvec2 at = glm::dvec2(x * dx - blast.x, y * dx - blast.y) / blast.radius;
            if (!(at.x * at.x + at.y * at.y <= 1)) continue;
            const auto depth = static_cast<double>(state.depth(x, y));
            mass.depth += depth, mass.moment += depth * at;
        }
    return mass;
}

double AttemptWatch::see_flow(const sim::State& state) {
    double energy = 0;
    for (int y = 0; y < state.grid.ny; ++y) {
        const float* const rolling = state.rolling.row(y);
        const float *const u = state.velocity_x.row(y), *const v = state.velocity_y.row(y);
        for (int x = 0; x < state.grid.nx; ++x) {
            if (rolling[x] == 0) continue;
            const auto depth = static_cast<double>(rolling[x]);
            const auto east = static_cast<double>(u[x]), north = static_cast<double>(v[x]);
            energy += depth * (east * east + north * north);
            if (depth < kFlowDepth) continue;
            const Reach here{-x, x, -y, y, -x - y, x + y, x - y, y - x};
            for (std::size_t i = 0; i < here.size(); ++i) reach_[i] = std::max(reach_[i], here[i]);
        }
    }
    return energy;
}

}  // namespace game
