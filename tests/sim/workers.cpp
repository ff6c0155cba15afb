#include "sim/core/workers.h"

#include <vector>

#include <gtest/gtest.h>

namespace {

TEST(Workers, give_every_row_to_exactly_one_thread_for_any_number_of_rows) {
    for (const int threads : {1, 2, 3, 8})
        for (const int rows : {1, 2, 7, 161}) {
            sim::Workers workers(threads);
            std::vector<int> visits(static_cast<std::size_t>(rows));
            for (int round = 0; round < 50; ++round)
                workers.each_band(rows, [&](int first, int last) {
                    for (int y = first; y < last; ++y) ++visits[static_cast<std::size_t>(y)];
                });
            for (const int count : visits) ASSERT_EQ(count, 50);
        }
}

}  // namespace
