#include "game/ensemble/ensemble.h"

#include <chrono>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

#include <fmt/format.h>

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
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error && size > counts.most_bytes())
        return wrong(fmt::format("has {} bytes, which is too many for its grid and maps", size));
    const auto bytes = read_text(file);
    if (!bytes) return tl::unexpected(bytes.error());
    if (const auto taken = counts.take(*bytes, spec.identity); !taken) return wrong(taken.error());
    return {};
}

}  // namespace

Outcome<EnsembleResult> run_ensemble(const EnsembleSpec& spec, const fs::path& folder, int threads,
                                     Ranks* ranks) {
    const auto begun = std::chrono::steady_clock::now();
    auto journal = Journal::open(folder / kJournalName, spec);
    if (!journal) return tl::unexpected(journal.error());
    if (const auto& members = journal->members(); !members.empty() && members.rbegin()->first > spec.members)
        return unusable(fmt::format("{}: has member {}, and {} has only {} members",
                                    (folder / kJournalName).string(), members.rbegin()->first,
                                    spec.file.string(), spec.members));
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
