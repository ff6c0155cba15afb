#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/baselines/image_baseline.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

// Whole frames as the program exports them: fine quality, the scene's own camera, light and textures.

namespace baselines {
namespace {

// The last frame of `couloir ARGUMENT… --frames`.
render::Picture last_frame_of(std::vector<std::string> arguments, const std::string& name) {
    const support::TemporaryFolder folder;
    arguments.insert(arguments.end(),
                     {"--size", "480x270", "--every", "1000000", "--frames", folder.path().string()});
    const auto finished = game::test::couloir(arguments);
    EXPECT_EQ(finished.status, 0) << finished.err;
    return read_image(folder.path() / name);
}

TEST(Frame, shows_the_snow_avalanche_under_way) {
    EXPECT_TRUE(
        matches_baseline(last_frame_of({"replay", "snow-avalanche", "--until", "900"}, "tick_000900.png"),
                         "frame_snow_avalanche_under_way"));
}

TEST(Frame, shows_the_snow_avalanche_at_rest) {
    EXPECT_TRUE(matches_baseline(last_frame_of({"replay", "snow-avalanche"}, "tick_006446.png"),
                                 "frame_snow_avalanche_at_rest"));
}

TEST(Frame, shows_the_landslide_under_way) {
    EXPECT_TRUE(matches_baseline(last_frame_of({"replay", "landslide", "--until", "700"}, "tick_000700.png"),
                                 "frame_landslide_under_way"));
}

TEST(Frame, shows_the_landslide_by_bcre) {
    EXPECT_TRUE(
        matches_baseline(last_frame_of({"replay", "landslide-bcre", "--until", "1500"}, "tick_001500.png"),
                         "frame_landslide_bcre"));
}

TEST(Frame, shows_two_materials) {
    EXPECT_TRUE(matches_baseline(last_frame_of({"run", "snow-on-soil", "--seconds", "15"}, "tick_000900.png"),
                                 "frame_snow_on_soil"));
}

TEST(Frame, shows_a_flow_demo) {
    EXPECT_TRUE(matches_baseline(last_frame_of({"run", "flow-pinwheel", "--seconds", "3"}, "tick_000180.png"),
                                 "frame_flow_pinwheel"));
}

}  // namespace
}  // namespace baselines
