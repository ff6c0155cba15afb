#include "game/base/job.h"

#include <atomic>
#include <new>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

namespace game::test {
namespace {

template <class Result>
Outcome<Result> ended(Job<Result>& job) {
    while (true) {
        if (auto result = job.result()) return std::move(*result);
        std::this_thread::yield();
    }
}

TEST(Job, gives_its_result_once_and_may_begin_again) {
    Job<int> job;
    EXPECT_FALSE(job.is_busy());
    EXPECT_FALSE(job.result());
    for (const int answer : {1, 2}) {
        ASSERT_TRUE(job.begin([answer](const std::atomic<bool>&) -> Outcome<int> { return answer; }));
        EXPECT_TRUE(job.is_busy());
        EXPECT_EQ(ended(job).value(), answer);
        EXPECT_FALSE(job.is_busy());
        EXPECT_FALSE(job.result());
    }
}

TEST(Job, makes_an_error_of_an_exception) {
    Job<int> job;
    ASSERT_TRUE(job.begin([](const std::atomic<bool>&) -> Outcome<int> { throw std::bad_alloc(); }));
    const auto failed = ended(job);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().status, Failure::kMachine);
}

TEST(Job, ends_early_if_it_is_stopped_or_destroyed) {
    const auto until_stopped = [](std::atomic<int>& ends) {
        return [&ends](const std::atomic<bool>& stopped) -> Outcome<int> {
            while (!stopped) std::this_thread::yield();
            return ++ends;
        };
    };
    std::atomic<int> ends = 0;
    {
        Job<int> job;
        ASSERT_TRUE(job.begin(until_stopped(ends)));
        job.stop();
        EXPECT_EQ(ends, 1);
        EXPECT_FALSE(job.result());
        ASSERT_TRUE(job.begin(until_stopped(ends)));
        EXPECT_FALSE(job.result());
    }
    EXPECT_EQ(ends, 2);
}

}  // namespace
}  // namespace game::test
