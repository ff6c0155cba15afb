#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "game/base/outcome.h"

namespace game {

// Does one piece of work after another on a thread of its own. After a failure it does none.
class InOrder {
  public:
    using Work = std::function<Outcome<void>()>;

    // `most`: pieces that may wait, ≥ 1.
    explicit InOrder(std::size_t most);
    ~InOrder();  // drops what waits
    InOrder(const InOrder&) = delete;
    InOrder& operator=(const InOrder&) = delete;

    // Waits while too much waits. Errors: that of an earlier piece.
    Outcome<void> give(Work work);
    // Waits until all is done. Errors: the first one.
    Outcome<void> finish();

  private:
    void run();

    const std::size_t most_;
    std::mutex mutex_;  // guards the next four members
    std::condition_variable changed_;
    std::deque<Work> waiting_;
    bool works_ = false, closing_ = false;
    std::optional<Failure> failure_;
    std::thread thread_;
};

}  // namespace game
