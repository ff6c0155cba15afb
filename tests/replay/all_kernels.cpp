#include "tests/replay/all_kernels.h"

#include <vector>

#include <fmt/format.h>

#include "game/analysis/score.h"
#include "game/recording/command_source.h"
#include "game/recording/recording_file.h"
#include "game/session/session.h"
#include "game/session/verifier.h"

namespace game::test {
namespace {

// The newest kernel with every number of threads, the others with one.
std::vector<sim::StepOptions> all_kernels() {
    std::vector<sim::StepOptions> all;
    for (const int threads : {1, 2, 3, 8}) all.push_back({.threads = threads});
    all.push_back({.plain = true});
    for (const auto set : sim::kInstructionSets)
        if (sim::has(set) && set != sim::best_instruction_set()) all.push_back({.instruction_set = set});
    return all;
}

std::string kernel_name(const sim::StepOptions& options) {
    return fmt::format("{}, threads {}", options.plain ? "plain" : sim::to_string(options.instruction_set),
                       options.threads);
}

std::optional<std::string> fault_by(const sim::StepOptions& options, const Recording& recording,
                                    Replays& tally) {
    auto session = Session::begin(recording.header.scenario, options, std::nullopt);
    if (!session) return session.error().sentence;
    Verifier verifier(recording);
    Referee referee(recording.header.scenario, recording.commands);
    verifier.look_at(*session);
    CommandSource source;
    while (session->state().tick < recording.last_tick()) {
        const auto due = source.due(session->state(), recording.commands);
        if (const auto done = session->advance(due); !done) return done.error().sentence;
        verifier.look_at(*session);
        if (recording.header.scenario.goal) referee.see(*session);
    }
    const Verdict& verdict = verifier.verdict();
    if (verdict.parted) return verdict.parted;
    if (verdict.proven_tick != recording.last_tick())
        return fmt::format("proven up to tick {} of {}", verdict.proven_tick, recording.last_tick());
    if (recording.claim) {
        const auto score = referee.decide();
        if (!score) return score.error().sentence;
        if (!(score->claim() == *recording.claim)) return "another score than it claims";
    }
    ++tally.count;
    tally.states += verdict.compared;
    return std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of_recording(const std::filesystem::path& file, Replays& tally) {
    const auto recording = read_recording(file);
    if (!recording) return recording.error().sentence;
    if (recording->warning) return recording->warning;
    for (const sim::StepOptions& options : all_kernels())
        if (const auto fault = fault_by(options, *recording, tally))
            return fmt::format("{} by {}: {}", file.filename().string(), kernel_name(options), *fault);
    return std::nullopt;
}

}  // namespace game::test
