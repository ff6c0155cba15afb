#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <optional>
#include <system_error>
#include <utility>

#include "game/base/outcome.h"
#include "game/base/process.h"
#include "sim/core/check.h"

namespace game {

// Work in the background on a thread of low priority, one piece at a time. Use it from one thread. Declare it after what
// the work uses: the destructor stops the work and waits for it.
template <class Result>
class Job {
  public:
    Job() = default;
    ~Job() { stop(); }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    // Starts `work`, which returns an Outcome<Result> and ends soon after its argument, a const std::atomic<bool>&, is
    // true. None must be under way. Errors: the system cannot start a thread.
    template <class Work>
    Outcome<void> begin(Work work) {
        CHECK(!is_busy());
        try {
            future_ = std::async(std::launch::async, [this, work = std::move(work)]() -> Outcome<Result> {
                lower_priority_of_thread();
                try {
                    return work(std::as_const(stopped_));
                } catch (const std::exception& thrown) {  // such as out of memory; none may leave the thread
                    return tl::unexpected(failure_of(thrown));
                }
            });
        } catch (const std::system_error& thrown) {
            return tl::unexpected(failure_of(thrown));
        }
        return {};
    }

    bool is_busy() const { return future_.valid(); }

    // What the work returned, once; nothing while it is under way. An exception of the work is an error.
    std::optional<Outcome<Result>> result() {
        if (!is_busy() || future_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return std::nullopt;
        return future_.get();
    }

    // Ends the work early and forgets its result.
    void stop() {
        stopped_ = true;
        if (is_busy()) future_.wait();
        future_ = {};
        stopped_ = false;
    }

  private:
    std::atomic<bool> stopped_ = false;
    std::future<Outcome<Result>> future_;
};

}  // namespace game
