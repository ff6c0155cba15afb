// Records the cost of each test. With COULOIR_TEST_TIMES=FILE every test adds a line to that file: processor
// time in seconds of the test and of the child processes it waited for, wall time, name and result. Sorted,
// the lines show which tests belong in SLOW of a couloir_test.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

namespace {

double processor_seconds(int whose) {
    rusage used{};
    getrusage(whose, &used);
    return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

class TestTimes : public testing::EmptyTestEventListener {
  public:
    explicit TestTimes(const char* file) : file_(file) {}

  private:
    using Clock = std::chrono::steady_clock;

    static double processor_seconds_of_all() {
        return processor_seconds(RUSAGE_SELF) + processor_seconds(RUSAGE_CHILDREN);
    }

    void OnTestStart(const testing::TestInfo&) override {
        started_ = Clock::now();
        processor_ = processor_seconds_of_all();
    }

    void OnTestEnd(const testing::TestInfo& test) override {
        std::FILE* file = std::fopen(file_, "a");
        if (!file) return;
        const double processor = processor_seconds_of_all() - processor_;
        const double wall = std::chrono::duration<double>(Clock::now() - started_).count();
        const char* result = test.result()->Skipped() ? "skipped" : test.result()->Passed() ? "ok" : "failed";
        std::fprintf(file, "%9.3f %9.3f %s.%s %s\n", processor, wall, test.test_suite_name(), test.name(),
                     result);
        std::fclose(file);
    }

    const char* file_;
    Clock::time_point started_;
    double processor_ = 0;
};

// Before main(): GoogleTest takes listeners at any time.
[[maybe_unused]] const bool listening = [] {
    if (const char* file = std::getenv("COULOIR_TEST_TIMES"))
        testing::UnitTest::GetInstance()->listeners().Append(new TestTimes(file));
    return true;
}();

}  // namespace
