#include "sim/core/workers.h"

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "sim/core/check.h"

namespace sim {

// The threads beside the caller.
class Workers::Crew {
  public:
    explicit Crew(int threads) : members_(threads) {
        crew_.reserve(static_cast<std::size_t>(threads - 1));
        try {
            for (int member = 1; member < threads; ++member)
                crew_.emplace_back([this, member] { serve(member); });
        } catch (...) {  // the system has no more threads
            leave();
            throw;
        }
    }
    ~Crew() { leave(); }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    void run(int rows, Call call, void* callable) {
        call_ = call;
        callable_ = callable;
        rows_ = rows;
        busy_.store(members_ - 1, std::memory_order_relaxed);
        round_.fetch_add(1, std::memory_order_release);
        round_.notify_all();
        do_band(0);
        for (int left = busy_.load(std::memory_order_acquire); left != 0;
             left = busy_.load(std::memory_order_acquire))
            busy_.wait(left, std::memory_order_acquire);
    }

  private:
    void leave() {
        leaving_ = true;
        round_.fetch_add(1, std::memory_order_release);
        round_.notify_all();
        for (std::thread& thread : crew_) thread.join();
        crew_.clear();
    }

    void serve(int member) {
        for (std::uint32_t seen = 0;;) {
            round_.wait(seen, std::memory_order_acquire);
            seen = round_.load(std::memory_order_acquire);
            if (leaving_) return;
            do_band(member);
            if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
        }
    }

    void do_band(int member) const {
        const int first = rows_ * member / members_, last = rows_ * (member + 1) / members_;
        if (first < last) call_(callable_, member, first, last);
    }

    const int members_;
    std::vector<std::thread> crew_;
    Call call_ = nullptr;
    void* callable_ = nullptr;
    int rows_ = 0;
    bool leaving_ = false;
    std::atomic<std::uint32_t> round_{0};
    std::atomic<int> busy_{0};
};

Workers::Workers(int threads) : threads_(threads) {
    CHECK(threads >= 1);
    if (threads > 1) crew_ = std::make_unique<Crew>(threads);
}

Workers::~Workers() = default;

void Workers::run(int rows, Call call, void* callable) {
    // A single row is done by the caller: waking the other threads would take longer than most stages.
    if (crew_ && rows > 1)
        crew_->run(rows, call, callable);
    else if (rows > 0)
        call(callable, 0, 0, rows);
}

}  // namespace sim
