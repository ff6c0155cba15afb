#include <cmath>
#include <vector>

#include "tests/render/gl_scene.h"

// Powder in the air.
namespace render::test {
namespace {

using sim::powder::Puff;

class DrawnCloud : public Gl {
  protected:
    static constexpr int kPixels = 96;

    // Snow with a ridge across the middle, 60 m high, seen from the south.
    DrawnCloud() {
        world_.depth.fill(1);
        look_ = plain_look();
        look_.powder = {1, 7, {0.9f, 0.9f, 0.9f}};
    }

    static std::vector<Puff> cloud(double y) {
        std::vector<Puff> puffs;
        for (int i = 0; i < 40; ++i)
            puffs.push_back({.at = {196 + 6 * (i % 5), y + 4 * (i / 20), 10 + 4 * (i % 7)},
                             .velocity = glm::vec3(0),
                             .first_radius = 6,
                             .age_s = 1,
                             .life_s = 6,
                             .density = 1,
                             .seed = static_cast<std::uint32_t>(i) * 2654435761u});
        return puffs;
    }

    Picture drawn(const std::vector<Puff>& puffs, float strength = 1, Light light = {180, 40}) {
        renderer_->draw({.world = world_.view(),
                         .camera = {{208, 208, 20}, 180, 4, 400, 40},
                         .light = light,
                         .look = look_,
                         .width = kPixels,
                         .height = kPixels,
                         .powder = puffs,
                         .powder_strength = strength});
        return renderer_->read_back();
    }

    World world_ = make_world(104, 4, [](double, double y) { return std::abs(y - 208) < 8 ? 60 : 0; });
    Look look_;
};

TEST_F(DrawnCloud, of_strength_0_leaves_every_byte) {
    const Picture without = drawn({});
    EXPECT_TRUE(alike(drawn(cloud(120), 0), without));
    EXPECT_GT(differing(drawn(cloud(120)), without), 200);
    EXPECT_TRUE(alike(drawn({}), without)) << "and nothing stays";
}

TEST_F(DrawnCloud, is_hidden_behind_a_ridge_and_seen_before_it) {
    const Picture without = drawn({});
    EXPECT_GT(differing(drawn(cloud(150)), without), 200);
    EXPECT_LT(differing(drawn(cloud(260)), without), 10);
}

TEST_F(DrawnCloud, is_fainter_at_less_strength) {
    look_.standing = {0.05f, 0.05f, 0.05f};
    const Picture none = drawn({});
    std::vector<Puff> few = cloud(120);
    few.resize(4);
    const auto change = [&](float strength) {
        const Picture with = drawn(few, strength);
        double sum = 0;
        for (std::size_t i = 0; i < with.pixels.size(); ++i) sum += std::abs(with.pixels[i] - none.pixels[i]);
        return sum;
    };
    EXPECT_LT(change(0.3f), 0.8 * change(1));
    EXPECT_GT(change(0.3f), 0.05 * change(1));
}

TEST_F(DrawnCloud, is_brighter_toward_the_sun) {
    const auto left_over_right = [&](double azimuth) {
        const Picture picture = drawn(cloud(120), 1, {azimuth, 12});
        return mean_colour(picture, 42, 44, 2)[1] - mean_colour(picture, 55, 44, 2)[1];
    };
    EXPECT_GT(left_over_right(270), left_over_right(90) + 5);
}

TEST_F(DrawnCloud, of_two_materials_has_the_colour_of_each_puff) {
    look_.lower_powder = {1, 2, {0.3f, 0.2f, 0.1f}};
    std::vector<Puff> puffs = cloud(120), right = cloud(121);
    for (Puff& puff : puffs) puff.at.x -= 40;
    for (Puff& puff : right) puff.at.x += 40, puff.lower = 1;
    puffs.insert(puffs.end(), right.begin(), right.end());
    const Picture picture = drawn(puffs);
    const Colour snow = mean_colour(picture, 35, 44, 2), soil = mean_colour(picture, 62, 44, 2);
    EXPECT_LT(std::abs(snow[0] - snow[2]), 25);
    EXPECT_GT(soil[0], soil[2] + 30);
}

// The eye is in the cloud.
TEST_F(DrawnCloud, parts_near_the_eye) {
    std::vector<Puff> puffs = cloud(-170);
    EXPECT_LT(differing(drawn(puffs), drawn({})), 10);
}

}  // namespace
}  // namespace render::test
