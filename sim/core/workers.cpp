#include "sim/core/workers.h"

#include "sim/core/check.h"

namespace sim {

Workers::Workers(int threads) {
    CHECK(threads >= 1);
    crew_.reserve(static_cast<std::size_t>(threads - 1));
    try {
        for (int member = 1; member < threads; ++member)
            crew_.emplace_back([this, member] { serve(member); });
    } catch (...) {  // the system has no more threads
        leave();
        throw;
    }
}

Workers::~Workers() {
    leave();
}

void Workers::leave() {
    leaving_ = true;
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
    for (std::thread& thread : crew_) thread.join();
}

void Workers::run(int rows, Call call, void* callable) {
    // A single row is done by the caller: waking the other threads would take longer than most stages.
    if (rows <= 1) {
        if (rows == 1) call(callable, 0, 0, 1);
        return;
    }
    call_ = call;
    callable_ = callable;
    rows_ = rows;
    if (crew_.empty()) return do_band(0);

    busy_.store(static_cast<int>(crew_.size()), std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
    do_band(0);
    for (int left = busy_.load(std::memory_order_acquire); left != 0;
         left = busy_.load(std::memory_order_acquire))
        busy_.wait(left, std::memory_order_acquire);
}

void Workers::serve(int member) {
    for (std::uint32_t seen = 0;;) {
        round_.wait(seen, std::memory_order_acquire);
        seen = round_.load(std::memory_order_acquire);
        if (leaving_) return;
        do_band(member);
        if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
    }
}

void Workers::do_band(int member) const {
    const int crew = threads();
    const int first = rows_ * member / crew, last = rows_ * (member + 1) / crew;
    if (first < last) call_(callable_, member, first, last);
}

}  // namespace sim
