#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <vector>

#include "game/ensemble/journal.h"
#include "game/ensemble/vertex_counts.h"

namespace game {

class OtherRanks;

// The members that are still to be played, handed out one by one to threads and to other processes, and what came of them.
class Work {
  public:
    // To do are the members that the journal lacks, or that ran and the counts lack.
    Work(const EnsembleSpec& spec, Journal& journal, VertexCounts& counts);

    std::size_t size() const { return todo_.size(); }

    // The next member, if one is left and nothing has failed.
    std::optional<std::int64_t> next();
    void finish(const PlayedMember& played);
    void fail(Failure failure);
    bool is_stopped() const { return stop_; }
    const VertexCounts& counts() const { return counts_; }

    // One thread's share of the work: until none is left, one failed, or the user stops it.
    void play();
    // Waits until all `threads` have ended, and the other processes if there are any; keeps the counts in their file, and shows
    // progress. Errors: of a member or a file.
    Outcome<void> watch(std::size_t threads, OtherRanks* others, const std::filesystem::path& counts_file);

  private:
    void fail_locked(Failure failure);
    Outcome<void> keep(const std::filesystem::path& file, std::unique_lock<std::mutex>& lock);

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

}  // namespace game
