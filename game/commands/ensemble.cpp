#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "game/base/print.h"
#include "game/base/process.h"
#include "game/commands/commands.h"
#include "game/ensemble/other_ranks.h"
#include "game/ensemble/results.h"
#include "game/files/file_use.h"
#include "game/pages/table.h"
#include "game/recording/format.h"

namespace game {
namespace {

// Under mpirun one for each process, of which it starts as many as are wanted.
int threads_of(const EnsembleOptions& options, const Ranks* ranks) {
    if (options.threads > 0) return options.threads;
    return ranks != nullptr ? 1 : processors();
}

std::string report_of(const EnsembleSpec& spec, const EnsembleResult& result) {
    std::string text = fmt::format("{}: {} of {} members", spec.title, result.members.size(), spec.members);
    const auto now = static_cast<double>(static_cast<std::int64_t>(result.members.size()) - result.before);
    if (now > 0)
        text += fmt::format(", {:.0f} of them now, in {:.1f} s ({:.2f} s each)", now, result.seconds,
                            result.seconds / now);
    text += "\n";
    if (result.dropped > 0)
        text += fmt::format("dropped {} bytes of a line of the journal that an earlier call had begun\n",
                            result.dropped);
    if (const std::int64_t faults = faults_in(result); faults > 0) {
        const auto first =
            std::ranges::find_if(result.members, [](const auto& each) { return !each.second.fault.empty(); });
        text += fmt::format("{} members could not run, the first one: member {}: {}\n", faults, first->first,
                            first->second.fault);
    }
    if (const std::int64_t moving = unfinished_in(result); moving > 0)
        text += fmt::format("{} members were still moving after {} s\n", moving, spec.seconds);
    text += as_text(spread_table(result));
    const Table variance = variance_table(spec, result);
    return variance.rows.empty() ? text : text + as_text(variance);
}

// Plays one member alone, for a recording.
Outcome<int> play_one(const EnsembleOptions& options, const EnsembleSpec& spec) {
    if (*options.member > spec.members)
        return unusable(
            fmt::format("--member {}: {} has {} members", *options.member, spec.file.string(), spec.members));
    const VertexCounts counts(spec.scene.scenario, spec.maps);
    const auto played = play_member(
        spec, *options.member, counts, [] { return false; }, options.record);
    if (!played) return tl::unexpected(played.error());
    const Member& member = played->member;
    if (!member.fault.empty())
        return unusable(fmt::format("member {} cannot run: {}", member.number, member.fault));
    std::string numbers;
    for (std::size_t i = 0; i < spec.variables.size(); ++i)
        numbers += fmt::format("{}{} {}", i > 0 ? ", " : "", spec.variables[i].name(), member.sample[i]);
    print_text(fmt::format(
        "member {}: {}\nrun-out {:.0f} m, top speed {:.1f} m/s, {:.1f} s, ended by {}\nstate hash {}\n",
        member.number, numbers, member.run_out, member.top_speed, member.seconds, member.ended, member.hash));
    return 0;
}

}  // namespace

Outcome<int> ensemble(const EnsembleOptions& options) {
    const auto joined = join_ranks();
    if (!joined) return tl::unexpected(joined.error());
    Ranks* const ranks = joined->get();
    Overrides overrides = options.overrides;
    overrides.memory.use.sessions = options.member ? 1 : threads_of(options, ranks);
    if (ranks != nullptr && ranks->rank() > 0) {
        if (!options.member)
            play_for_rank_0(*ranks, read_ensemble_spec(options.spec, overrides), threads_of(options, ranks));
        return 0;
    }
    std::optional<Dismissal> dismissal;
    if (ranks != nullptr && !options.member) dismissal.emplace(*ranks);

    const auto spec = read_ensemble_spec(options.spec, overrides);
    if (!spec) return tl::unexpected(spec.error());
    FileUse use;
    use.reads(options.spec).reads(spec->scene.files);
    use.writes("--record", options.record).writes_into("--out", options.folder, kEnsembleNames);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    for (const std::string& warning : spec->scene.warnings) print_line(stderr, "couloir: {}", warning);
    if (options.member) return play_one(options, *spec);

    const auto result = run_ensemble(*spec, *options.folder, threads_of(options, ranks), ranks);
    if (!result) return tl::unexpected(result.error());
    // At once: what ended this process may soon end it for good.
    if (result->interrupted)
        print_line(stderr, "couloir: interrupted; the same command goes on with the members that are left");
    if (auto written = write_results(*options.folder, *spec, *result); !written)
        return tl::unexpected(written.error());
    print_text(options.json ? printed(to_json(*spec, *result)) : report_of(*spec, *result));
    return !result->interrupted && faults_in(*result) == 0 ? 0 : Failure::kBadAnswer;
}

}  // namespace game
