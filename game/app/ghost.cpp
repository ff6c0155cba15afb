#include "game/app/ghost.h"

#include <algorithm>
#include <utility>

#include "game/analysis/score.h"

namespace game {

void Ghost::follow(const Scenario& scenario, const std::vector<BestRun>& runs, const Memory& memory) {
    inside_.clear();
    step_ = -1;
    const std::filesystem::path best = runs.empty() ? std::filesystem::path() : runs.front().file;
    if (best == followed_) return;
    job_.stop();
    followed_ = best;
    found_ = {};
    if (runs.empty() || !memory.allows(scenario.grid, scenario.lower.has_value())) return;
    // Without a thread there is no ghost.
    (void)job_.begin([runs, challenge = challenge_id(scenario),
                      memory](const std::atomic<bool>& stopped) -> Outcome<PlayedRuns> {
        return play_best_run(runs, challenge, memory, stopped);
    });
}

void Ghost::see(std::int64_t ticks) {
    if (auto found = job_.result()) found_ = std::move(*found).value_or(PlayedRuns());
    if (!found_.best || ticks < 0) return inside_.clear();
    const std::int64_t step = ticks / RunExtent::kStep;
    if (!inside_.empty() && step == step_) return;
    step_ = step;
    found_.best->extent.at(ticks, next_);
    if (next_ == inside_) return;
    inside_.swap(next_);
    ++version_;
}

std::optional<std::string> Ghost::fault() {
    if (found_.faults.empty()) return std::nullopt;
    std::string fault = std::move(found_.faults.back());
    found_.faults.pop_back();
    return fault;
}

}  // namespace game
