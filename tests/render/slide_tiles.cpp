#include "render/frame/slide_tiles.h"

#include <gtest/gtest.h>

#include "tests/render/world.h"

namespace render::test {
namespace {

constexpr int kWidth = 200, kHeight = 130;

// How often each sample of the frame is covered.
std::vector<int> coverage(std::span<const Rectangle> rectangles) {
    std::vector<int> covered(kWidth * kHeight);
    for (const Rectangle& r : rectangles)
        for (int y = r.bottom; y < r.top; ++y)
            for (int x = r.left; x < r.right; ++x) ++covered[static_cast<std::size_t>(y * kWidth + x)];
    return covered;
}

struct Tiles {
    World world = make_world(64, 5, [](double x, double) { return 0.2 * x; });
    Camera camera = from_above({160, 160, 30}, 400);
    std::vector<float> first_depth = std::vector<float>(world.grid.size());
    Look look;
    SlideTiles tiles;

    void find() {
        const FrameInput input{.world = world.view(),
                               .camera = camera,
                               .look = look,
                               .width = kWidth,
                               .height = kHeight,
                               .first_depth = first_depth};
        const glm::mat4 clip =
            projection_matrix(camera, static_cast<double>(kWidth) / kHeight) * view_matrix(camera);
        tiles.find(input, OnScreen(clip, kWidth, kHeight));
        const std::vector<int> earth = coverage(tiles.with_earth()), walls = coverage(tiles.with_walls()),
                               with = coverage(tiles.with_slides()), without = coverage(tiles.without());
        for (std::size_t i = 0; i < with.size(); ++i)
            ASSERT_EQ(earth[i] + walls[i] + with[i] + without[i], 1) << "sample " << i;
    }
    std::size_t samples_with_slides() const {
        std::size_t sum = 0;
        for (const int each : coverage(tiles.with_slides())) sum += static_cast<std::size_t>(each);
        return sum;
    }
};

TEST(SlideTiles, are_none_where_nothing_moved) {
    Tiles t;
    t.world.depth.fill(2);
    t.first_depth.assign(t.first_depth.size(), 2.f);
    t.find();
    EXPECT_EQ(t.samples_with_slides(), 0u);
}

TEST(SlideTiles, hold_earth_whatever_slides_over_it) {
    for (const bool slides : {false, true}) {
        Tiles t;
        t.world.things.emplace(t.world.grid);
        t.find();
        EXPECT_TRUE(t.tiles.with_earth().empty());
        t.world.things->earth(32, 32) = -0.5f;  // in the middle of the frame
        if (slides) t.world.rolling.fill(1);
        t.find();
        EXPECT_EQ(coverage(t.tiles.with_earth())[kHeight / 2 * kWidth + kWidth / 2], 1);
        EXPECT_EQ(t.samples_with_slides() > 0, slides);
    }
}

TEST(SlideTiles, hold_wet_soil_where_a_look_has_a_date) {
    for (const bool dated : {false, true}) {
        Tiles t;
        t.world.things.emplace(t.world.grid);
        t.world.things->water(32, 32) = 0.3f;
        if (dated) t.look.date = Date{7, 15};
        t.find();
        EXPECT_EQ(t.tiles.with_earth().empty(), !dated);
    }
}

TEST(SlideTiles, hold_what_rolls_and_what_changed) {
    for (const bool rolls : {true, false}) {
        Tiles t;
        (rolls ? t.world.rolling : t.world.depth)(32, 32) = 0.01f;  // in the middle of the frame
        t.find();
        EXPECT_GT(t.samples_with_slides(), 0u);
        EXPECT_LT(t.samples_with_slides(), static_cast<std::size_t>(kWidth * kHeight / 2));
        EXPECT_EQ(
            coverage(t.tiles.with_slides())[static_cast<std::size_t>(kHeight / 2 * kWidth + kWidth / 2)], 1);
    }
}

TEST(SlideTiles, hold_a_wall_where_the_standing_layer_has_a_new_step) {
    const auto walls = [](float gone) {  // round a scar in the middle of the frame
        Tiles t;
        t.world.depth.fill(2);
        t.first_depth.assign(t.first_depth.size(), 2.f);
        for (int y = 20; y < 44; ++y) t.world.depth(32, y) = 2 - gone;
        t.find();
        return coverage(t.tiles.with_walls())[static_cast<std::size_t>(kHeight / 2 * kWidth + kWidth / 2)];
    };
    EXPECT_EQ(walls(1), 1);
    EXPECT_EQ(walls(0.05f), 0) << "hardly anything is gone";
    EXPECT_EQ(walls(-1), 0) << "a heap";
}

TEST(SlideTiles, are_all_where_a_slide_reaches_behind_the_eye) {
    Tiles t;
    t.world.rolling(32, 32) = 1;
    t.camera.target = {162, 162, 33};
    t.camera.elevation_deg = 10;
    t.camera.distance_m = 3;
    t.find();
    EXPECT_EQ(t.samples_with_slides(), static_cast<std::size_t>(kWidth * kHeight));
}

}  // namespace
}  // namespace render::test
