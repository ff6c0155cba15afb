#include "tests/render/gl_scene.h"
#include "tests/render/mountains.h"

// What people have built, in the image.
namespace render::test {
namespace {

class DrawnStructures : public Gl {
  protected:
    static constexpr int kPixels = 96;

    DrawnStructures() {
        structures_.all.push_back({StructureKind::kHouse, {150, 150}, 200, {}, 11, 9, 7.5});
        structures_.roads.push_back({{{20, 120}, {280, 120}}, 8});
    }
    Picture drawn(const Structures* structures, const Light& light = {240, 30}) {
        renderer_->draw({.world = world_.view(),
                         .camera = {{150, 140, 0}, 200, 25, 70, 40},
                         .light = light,
                         .look = plain_look(),
                         .width = kPixels,
                         .height = kPixels,
                         .first_depth = bare_,
                         .structures = structures});
        return renderer_->read_back();
    }

    World world_ = make_world(60, 5, [](double, double) { return 0; });
    Structures structures_;
    std::vector<float> bare_ = std::vector<float>(world_.grid.size());
};

TEST_F(DrawnStructures, change_the_frame_and_leave_nothing_behind) {
    const Picture without = drawn(nullptr);
    const Picture with = drawn(&structures_);
    EXPECT_GT(differing(with, without), 500);
    EXPECT_TRUE(alike(drawn(nullptr), without));
    const Structures none;
    EXPECT_TRUE(alike(drawn(&none), without));
    EXPECT_TRUE(alike(drawn(&structures_), with));
}

TEST_F(DrawnStructures, show_their_state_at_once) {
    const Picture whole = drawn(&structures_);
    structures_.all[0].state = StructureState::kDestroyed;
    const Picture destroyed = drawn(&structures_);
    EXPECT_GT(differing(destroyed, whole), 300);
    structures_.all[0].state = StructureState::kIntact;
    EXPECT_TRUE(alike(drawn(&structures_), whole));
}

TEST_F(DrawnStructures, vanish_under_what_is_deep_enough_but_for_the_debris_on_it) {
    world_.depth.fill(12);
    EXPECT_EQ(differing(drawn(&structures_), drawn(nullptr)), 0);
    structures_.all[0].state = StructureState::kDestroyed;
    EXPECT_GT(differing(drawn(&structures_), drawn(nullptr)), 20);
}

// A building that is a part of the bedrock is drawn by its mesh alone.
TEST_F(DrawnStructures, hide_no_block_of_bedrock) {
    const Picture flat = drawn(&structures_);
    world_.things.emplace(world_.grid);
    world_.things->natural = world_.bedrock;
    for (int y = 28; y < 33; ++y)
        for (int x = 27; x < 34; ++x) world_.bedrock(x, y) = world_.things->built(x, y) = 15;
    EXPECT_TRUE(alike(drawn(&structures_), flat));
    world_.things->built.fill(0);
    EXPECT_NE(drawn(&structures_).pixels, flat.pixels) << "a hill is drawn";
}

TEST_F(DrawnStructures, have_lamps_behind_their_windows_in_the_evening) {
    const auto warmest = [](const Picture& picture) {
        int most = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
            most =
                std::max(most, static_cast<int>(picture.pixels[i]) - static_cast<int>(picture.pixels[i + 2]));
        return most;
    };
    EXPECT_LT(warmest(drawn(&structures_, {240, 40})), 60);
    EXPECT_GT(warmest(drawn(&structures_, {240, -6})), 90);
}

TEST_F(DrawnStructures, light_the_ground_before_their_windows_in_the_evening) {
    structures_.roads.clear();
    const auto redder = [&](const Light& light) {
        const Picture with = drawn(&structures_, light), without = drawn(nullptr, light);
        int count = 0;
        for (std::size_t i = 0; i < with.pixels.size(); i += 3)
            count += with.pixels[i] > without.pixels[i] + 8 && with.pixels[i + 1] > without.pixels[i + 1];
        return count;
    };
    EXPECT_LT(redder({240, 40}), 100);
    EXPECT_GT(redder({240, -6}), 400);
}

}  // namespace
}  // namespace render::test
