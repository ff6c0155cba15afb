#include "game/share/in_order.h"

#include <exception>
#include <utility>

#include "game/base/process.h"

namespace game {
namespace {

// No exception, such as out of memory, may leave the thread.
Outcome<void> result_of(const InOrder::Work& work) {
    try {
        return work();
    } catch (const std::exception& thrown) {
        return tl::unexpected(failure_of(thrown));
    }
}

}  // namespace

InOrder::InOrder(std::size_t most) : most_(most), thread_([this] { run(); }) {}

InOrder::~InOrder() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
        waiting_.clear();
    }
    changed_.notify_all();
    thread_.join();
}

Outcome<void> InOrder::give(Work work) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < most_ || failure_; });
    if (failure_) return tl::unexpected(*failure_);
    waiting_.push_back(std::move(work));
    changed_.notify_all();
    return {};
}

Outcome<void> InOrder::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return (waiting_.empty() && !works_) || failure_; });
    if (failure_) return tl::unexpected(*failure_);
    return {};
}

void InOrder::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return closing_ || !waiting_.empty(); });
        if (closing_) return;
        const Work work = std::move(waiting_.front());
        waiting_.pop_front();
        works_ = true;
        changed_.notify_all();
        lock.unlock();
        auto done = result_of(work);
        lock.lock();
        works_ = false;
        if (!done) {
            failure_ = std::move(done.error());
            waiting_.clear();
        }
        changed_.notify_all();
    }
}

}  // namespace game
