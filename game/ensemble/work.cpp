#include "game/ensemble/work.h"

#include <chrono>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "game/base/process.h"
#include "game/base/progress.h"
#include "game/ensemble/other_ranks.h"
#include "game/files/text_file.h"

namespace game {
namespace {

std::string time_left(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s left", seconds);
    if (seconds < 6000) return fmt::format("{:.0f} min left", seconds / 60);
    return fmt::format("{:.1f} h left", seconds / 3600);
}

}  // namespace

Work::Work(const EnsembleSpec& spec, Journal& journal, VertexCounts& counts)
    : spec_(spec), journal_(journal), counts_(counts) {
    for (std::int64_t number = 1; number <= spec.members; ++number) {
        const auto found = journal.members().find(number);
        const bool is_done =
            found != journal.members().end() && (!found->second.fault.empty() || counts.has(number));
        if (!is_done) todo_.push_back(number);
    }
}

std::optional<std::int64_t> Work::next() {
    const std::lock_guard lock(mutex_);
    if (stop_ || handed_ == todo_.size()) return std::nullopt;
    return todo_[handed_++];
}

void Work::finish(const PlayedMember& played) {
    const std::lock_guard lock(mutex_);
    if (failure_) return;
    if (auto added = journal_.add(played.member); !added) return fail_locked(added.error());
    if (played.member.fault.empty()) counts_.add(played.member.number, played.marks);
    ++done_;
    changed_.notify_one();
}

void Work::fail(Failure failure) {
    const std::lock_guard lock(mutex_);
    if (!stop_) fail_locked(std::move(failure));  // else it was told to end
}

void Work::fail_locked(Failure failure) {
    if (!failure_) failure_ = std::move(failure);
    stop_ = true;
}

void Work::play() {
    try {
        while (const std::optional<std::int64_t> number = next())
            if (auto played = play_member(spec_, *number, counts_, [this] { return is_stopped(); }); !played)
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

// Writes the counts as they are now, while others go on.
Outcome<void> Work::keep(const std::filesystem::path& file, std::unique_lock<std::mutex>& lock) {
    const std::string bytes = counts_.bytes(spec_.identity);
    lock.unlock();
    auto written = write_text(file, bytes);
    lock.lock();
    return written;
}

Outcome<void> Work::watch(std::size_t threads, OtherRanks* others, const std::filesystem::path& counts_file) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    };
    const std::chrono::milliseconds look(others == nullptr ? 200 : 2);
    constexpr double kKeepEvery = 10, kShowEvery = 0.2;  // s
    Progress progress("members");
    const auto begun = Clock::now();
    auto kept = begun, shown = begun;
    std::unique_lock lock(mutex_);
    while (ended_threads_ < threads || (others != nullptr && others->are_playing() && !stop_)) {
        changed_.wait_for(lock, look);
        if (interrupted()) stop_ = true;
        if (others != nullptr) {
            lock.unlock();
            others->look();
            lock.lock();
        }
        if (seconds_since(shown) >= kShowEvery) {
            shown = Clock::now();
            const double share = static_cast<double>(done_) / static_cast<double>(todo_.size());
            const double left = done_ == 0 ? 0 : seconds_since(begun) * (1 / share - 1);
            progress.show(share, fmt::format("{} of {}, {}", done_, todo_.size(),
                                             done_ == 0 ? "the first one runs" : time_left(left)));
        }
        if (seconds_since(kept) < kKeepEvery) continue;
        kept = Clock::now();
        if (auto written = keep(counts_file, lock); !written) fail_locked(written.error());
    }
    if (failure_) return tl::unexpected(*failure_);
    return keep(counts_file, lock);
}

}  // namespace game
