#include "game/ensemble/ensemble.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/base/process.h"
#include "game/base/progress.h"
#include "game/files/text_file.h"

namespace game {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

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

std::string time_left(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s left", seconds);
    if (seconds < 6000) return fmt::format("{:.0f} min left", seconds / 60);
    return fmt::format("{:.1f} h left", seconds / 3600);
}

// The members that are still to be played, handed out one by one, and what came of them.
class Work {
  public:
    Work(const EnsembleSpec& spec, Journal& journal, VertexCounts& counts)
        : spec_(spec), journal_(journal), counts_(counts) {
        for (std::int64_t number = 1; number <= spec.members; ++number) {
            const auto found = journal.members().find(number);
            const bool is_done =
                found != journal.members().end() && (!found->second.fault.empty() || counts.has(number));
            if (!is_done) todo_.push_back(number);
        }
    }

    std::size_t size() const { return todo_.size(); }

    // One thread's share of the work: until none is left, one failed, or the user stops it.
    void play() {
        try {
            while (const std::optional<std::int64_t> number = next())
                if (auto played = play_member(spec_, *number, counts_, [this] { return stopped(); }); !played)
                    fail(std::move(played.error()));
                else
                    finish(*played);
        } catch (const std::exception& thrown) {  // such as out of memory; none may leave the thread
            fail(failure_of(thrown));
        }
        const std::lock_guard lock(mutex_);
        ++ended_threads_;
        changed_.notify_one();
    }

    // Waits until all `threads` have ended, keeps the counts in their file, and shows progress. Errors: of a member or a file.
    Outcome<void> watch(std::size_t threads, const fs::path& counts_file) {
        constexpr std::chrono::milliseconds kLook{200};
        constexpr double kKeepEvery = 10;  // s
        Progress progress("members");
        const auto begun = Clock::now();
        auto kept = begun;
        std::unique_lock lock(mutex_);
        while (ended_threads_ < threads) {
            changed_.wait_for(lock, kLook);
            if (interrupted()) stop_ = true;
            const double share = static_cast<double>(done_) / static_cast<double>(todo_.size());
            const double left = done_ == 0 ? 0 : seconds_since(begun) * (1 / share - 1);
            progress.show(share, fmt::format("{} of {}, {}", done_, todo_.size(),
                                             done_ == 0 ? "the first one runs" : time_left(left)));
            if (seconds_since(kept) < kKeepEvery) continue;
            kept = Clock::now();
            const std::string bytes = counts_.bytes(spec_.identity);
            lock.unlock();
            const auto written = write_text(counts_file, bytes);
            lock.lock();
            if (!written) fail_locked(written.error());
        }
        if (failure_) return tl::unexpected(*failure_);
        return write_text(counts_file, counts_.bytes(spec_.identity));
    }

    bool stopped() const { return stop_; }

  private:
    std::optional<std::int64_t> next() {
        const std::lock_guard lock(mutex_);
        if (stop_ || handed_ == todo_.size()) return std::nullopt;
        return todo_[handed_++];
    }
    void finish(const PlayedMember& played) {
        const std::lock_guard lock(mutex_);
        if (failure_) return;
        if (auto added = journal_.add(played.member); !added) return fail_locked(added.error());
        if (played.member.fault.empty()) counts_.add(played.member.number, played.marks);
        ++done_;
        changed_.notify_one();
    }
    void fail(Failure failure) {
        const std::lock_guard lock(mutex_);
        if (!stop_) fail_locked(std::move(failure));  // else it was told to end
    }
    void fail_locked(Failure failure) {
        if (!failure_) failure_ = std::move(failure);
        stop_ = true;
    }

    const EnsembleSpec& spec_;
    Journal& journal_;
    VertexCounts& counts_;
    std::vector<std::int64_t> todo_;
    std::mutex mutex_;  // of all that follows, of journal and counts
    std::condition_variable changed_;
    std::size_t handed_ = 0, done_ = 0;
    std::size_t ended_threads_ = 0;
    std::optional<Failure> failure_;
    std::atomic<bool> stop_ = false;
};

}  // namespace

Outcome<EnsembleResult> run_ensemble(const EnsembleSpec& spec, const fs::path& folder, int threads) {
    const auto begun = Clock::now();
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
    {
        std::vector<std::jthread> team;
        try {
            for (int i = 0; i < threads; ++i) team.emplace_back([&work] { work.play(); });
        } catch (const std::system_error& thrown) {  // fewer threads come to the same, later
            if (team.empty()) return tl::unexpected(failure_of(thrown));
        }
        if (auto done = work.watch(team.size(), folder / kCountsName); !done)
            return tl::unexpected(done.error());
    }
    result.members = journal->members();
    result.interrupted = static_cast<std::int64_t>(result.members.size()) < spec.members;
    result.seconds = seconds_since(begun);
    return result;
}

}  // namespace game
