#include "game/ensemble/ensemble.h"

#include <chrono>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/base/process.h"
#include "game/ensemble/other_ranks.h"
#include "game/ensemble/work.h"
#include "game/files/text_file.h"

namespace game {
namespace {

namespace fs = std::filesystem;

// What is left of an earlier call.
Outcome<void> take_counts(const fs::path& file, const EnsembleSpec& spec, VertexCounts& counts) {
    std::error_code error;
    if (!fs::exists(file, error)) return {};
    const auto wrong = [&](const std::string& fact) {
        return unusable(
            fmt::format("{}: {}; delete it, and its members are played again", file.string(), fact));
    };
    if (const std::uintmax_t size = fs::file_size(file, error); !error && size > counts.most_bytes())
        return wrong(fmt::format("has {} bytes, which is too many for its grid and maps", size));
    const auto bytes = read_text(file);
    if (!bytes) return tl::unexpected(bytes.error());
    if (const auto taken = counts.take(*bytes, spec.identity); !taken) return wrong(taken.error());
    return {};
}

// Members that the spec does not have are of a larger one.
Outcome<void> check_members(const std::map<std::int64_t, Member>& members, const fs::path& journal,
                            const EnsembleSpec& spec) {
    if (members.empty() || members.rbegin()->first <= spec.members) return {};
    return unusable(fmt::format("{}: has member {}, and {} has only {} members", journal.string(),
                                members.rbegin()->first, spec.file.string(), spec.members));
}

}  // namespace

Outcome<EnsembleResult> read_ensemble(const EnsembleSpec& spec, const fs::path& folder) {
    const fs::path journal = folder / kJournalName;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(journal, error);
    if (error || !fs::exists(folder / kCountsName, error))
        return unusable(
            fmt::format("{}: has no results of an ensemble; couloir ensemble {} --out {} makes them",
                        folder.string(), spec.file.string(), folder.string()));
    if (size > kMostJournalBytes)
        return unusable(fmt::format("{}: has {} bytes, and at most {} are read", journal.string(), size,
                                    kMostJournalBytes));
    const auto text = read_text(journal);
    if (!text) return tl::unexpected(text.error());
    auto read = read_journal(*text, journal.string(), spec);
    if (!read) return tl::unexpected(read.error());
    if (auto sound = check_members(read->members, journal, spec); !sound)
        return tl::unexpected(sound.error());
    EnsembleResult result{std::move(read->members), VertexCounts(spec.scene.scenario, spec.maps)};
    if (auto taken = take_counts(folder / kCountsName, spec, result.counts); !taken)
        return tl::unexpected(taken.error());
    return result;
}

Outcome<EnsembleResult> run_ensemble(const EnsembleSpec& spec, const fs::path& folder, int threads,
                                     Ranks* ranks) {
    const auto begun = std::chrono::steady_clock::now();
    auto journal = Journal::open(folder / kJournalName, spec);
    if (!journal) return tl::unexpected(journal.error());
    if (auto sound = check_members(journal->members(), folder / kJournalName, spec); !sound)
        return tl::unexpected(sound.error());
    EnsembleResult result{{}, VertexCounts(spec.scene.scenario, spec.maps)};
    if (auto taken = take_counts(folder / kCountsName, spec, result.counts); !taken)
        return tl::unexpected(taken.error());
    result.dropped = journal->dropped();

    note_interrupts();
    Work work(spec, *journal, result.counts);
    result.before = spec.members - static_cast<std::int64_t>(work.size());
    std::optional<OtherRanks> others;
    if (ranks != nullptr) others.emplace(*ranks, spec, work);
    {
        std::vector<std::jthread> team;
        try {
            for (int i = 0; i < threads; ++i) team.emplace_back([&work] { work.play(); });
        } catch (const std::system_error& thrown) {  // fewer threads come to the same, later
            if (team.empty()) return tl::unexpected(failure_of(thrown));
        }
        if (auto done = work.watch(team.size(), others ? &*others : nullptr, folder / kCountsName); !done)
            return tl::unexpected(done.error());
    }
    result.members = journal->members();
    result.interrupted = static_cast<std::int64_t>(result.members.size()) < spec.members;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return result;
}

}  // namespace game
