// The memory that drawing takes; tests/readers/memory.cpp has the rest.

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/scene/memory.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TEST(DrawingMemory, estimate_is_at_least_the_measured_peak) {
    struct Case {
        std::vector<std::string> arguments;
        int side, samples;  // of the grid, vertices; of a pixel
    };
    const support::TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const std::vector<Case> cases{
        {{"run", "landslide", "--grid", "64", "--seconds", "0.05", "--every", "1", "--frames", out}, 65, 2},
        {{"run", "flow-disc", "--grid", "64", "--seconds", "0.05", "--every", "1", "--frames", out}, 65, 2},
        {{"replay", "landslide", "--until", "4", "--every", "1", "--frames", out}, 81, 2},
        {{"bench", "landslide", "--grid", "64", "--ticks", "4", "--every", "1", "--repeats", "1", "--physics",
          "local-lax-friedrichs"},
         65,
         1},
        {{"run", "hillside", "--grid", "64", "--seconds", "0.05", "--every", "1", "--frames", out}, 65, 2},
    };
    // Larger ones take a processor half a minute each.
    for (const auto& [width, height] : {std::pair{16, 16}, {1280, 720}, {2500, 2000}})
        for (const Case& each : cases) {
            if (width == 2500 && &each != &cases[2]) continue;
            std::vector<std::string> arguments = each.arguments;
            arguments.insert(arguments.end(), {"--size", fmt::format("{}x{}", width, height)});
            Memory memory;
            memory.use = {.draws = true, .frames = {width, height, each.samples}};
            const std::uint64_t expected = expected_bytes({each.side, each.side, 2.f}, false, memory);
            const auto [status, taken] = peak_of(arguments);
            const std::string name = fmt::format("{} {} {}x{}", arguments[0], arguments[1], width, height);
            EXPECT_EQ(status, 0) << name;
            EXPECT_LE(taken, expected) << name << ": " << bytes_text(taken) << " of " << bytes_text(expected);
            EXPECT_LE(expected, 3 * taken)
                << name << ": " << bytes_text(taken) << " of " << bytes_text(expected);
        }
}

}  // namespace
}  // namespace game::test
