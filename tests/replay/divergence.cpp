// Shipped recordings, played twice. Other threads and tiles give
// the same result, and a fault planted in one run is located.
#include <bit>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "game/compare/desync_picture.h"
#include "game/recording/divergence.h"
#include "game/recording/divergence_report.h"
#include "render/pictures/picture.h"
#include "sim/scratch.h"
#include "tests/replay/play.h"

namespace game::test {
namespace {

class Paranoid : public testing::TestWithParam<const char*> {};

TEST_P(Paranoid, first_200_ticks_are_the_same_with_other_threads_tiles_and_order) {
    const Recording recording = open(GetParam());
    const Scenario& scenario = recording.header.scenario;
    const sim::StepOptions other{.threads = 3, .tile_width = 32, .tile_height = 8, .last_tile_first = true};
    const auto parted = first_divergence({scenario, recording.commands, {}, nullptr},
                                         {scenario, recording.commands, other, nullptr}, 200);
    EXPECT_FALSE(parted) << to_text(*parted, scenario, {"one", "other"});
}

INSTANTIATE_TEST_SUITE_P(Recordings, Paranoid,
                         testing::Values("landslide", "landslide-bcre", "snow-avalanche"),
                         [](const auto& name) {
                             std::string text = name.param;
                             std::replace(text.begin(), text.end(), '-', '_');
                             return text;
                         });

// COULOIR_DESYNC names a file for the image.
TEST(PlantedFault, in_the_snow_avalanche_is_found_at_its_stage_and_cell) {
    constexpr std::int64_t kTick = 420;
    const Recording recording = open("snow-avalanche");
    const Scenario& scenario = recording.header.scenario;
    int x = 0, y = 0;
    float most = 0;
    const auto fault = [&](const Side::Moment& at) {
        if (at.tick != kTick || at.substep != 0 || at.stage != "drive") return;
        // A tick when much is moving, so that the fault shows.
        if (most == 0)
            for (int j = 0; j < scenario.grid.ny; ++j)
                for (int i = 0; i < scenario.grid.nx; ++i)
                    if (const float flow = at.state.rolling(i, j) * std::fabs(at.state.velocity_y(i, j));
                        flow > most)
                        most = flow, x = i, y = j;
        float& value = at.scratch->momentum().driven_u(x, y);
        value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + 4096);
    };
    const sim::StepOptions plainly{.plain = true};
    const auto parted = first_divergence({scenario, recording.commands, plainly, nullptr},
                                         {scenario, recording.commands, plainly, fault}, kTick + 1);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->where, Divergence::Where::kStage);
    EXPECT_EQ(parted->tick, kTick);
    EXPECT_EQ(parted->substep, 0);
    EXPECT_EQ(parted->name, "drive");
    ASSERT_EQ(parted->fields.size(), 1u);
    EXPECT_EQ(parted->fields[0].field, "driven_u");
    EXPECT_EQ(parted->fields[0].x, x);
    EXPECT_EQ(parted->fields[0].y, y);
    EXPECT_EQ(parted->fields[0].ulps, 4096u);

    const std::array<std::string, 2> names{"sound", "planted"};
    if (const char* file = std::getenv("COULOIR_DESYNC")) {
        std::cout << to_text(*parted, scenario, names);
        ASSERT_TRUE(render::write_png(desync_picture(*parted, scenario, names), file,
                                      render::kSmallestPngCompression));
    }
}

}  // namespace
}  // namespace game::test
