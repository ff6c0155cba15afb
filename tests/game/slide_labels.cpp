#include "game/app/slide_labels.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/worlds.h"

namespace game::test {
namespace {

// A slope down to the north on which a slab is released at once.
LoadedWorld labelled_slope() {
    LoadedWorld loaded;
    Scenario& scenario = loaded.scene.scenario;
    const support::Ground ground = support::plane(60, 5, 0.7, 1);
    scenario.grid = ground.grid;
    scenario.bedrock = ground.bedrock;
    scenario.depth = ground.depth;
    scenario.rolling = ground.rolling;
    scenario.has_data = ground.has_data;
    scenario.params = support::loose_dry_snow();
    TimedCommand blast;
    blast.command.kind = sim::CommandKind::kBlast;
    blast.command.x = 150, blast.command.y = 60, blast.command.radius = 30, blast.command.depth = 1;
    loaded.scene.commands = {blast};
    return loaded;
}

class LabelsOfASlide : public testing::Test {
  protected:
    void trace(SlideLabels& labels) {
        labels.trace(
            sandbox_, view_,
            [&](glm::dvec2 place) -> std::optional<glm::dvec2> {
                ++looked_;
                if (place.y > hidden_beyond_) return std::nullopt;
                return place;
            },
            [&](glm::dvec2 point) -> std::optional<glm::dvec3> {
                if (point.y > sky_above_) return std::nullopt;
                return glm::dvec3(150, 150, 0);
            });
    }
    void tick(int count) {
        for (; count > 0; --count) ASSERT_TRUE(sandbox_.tick({}));
    }

    Sandbox sandbox_ = Sandbox::begin(labelled_slope(), {}, std::nullopt).value();
    SlideLabels::View view_{{{150, 150, 0}, 180, 30, 400, 35}, 800, 600, 0};
    int looked_ = 0;
    double hidden_beyond_ = 1e9, sky_above_ = 1;
};

TEST_F(LabelsOfASlide, name_what_can_be_seen_of_it) {
    SlideLabels labels;
    trace(labels);
    EXPECT_TRUE(labels.labels().empty()) << "nothing has moved";
    EXPECT_TRUE(labels.compass());
    tick(60);
    trace(labels);
    ASSERT_EQ(labels.labels().size(), 3u) << "crown, stauchwall, front";
    EXPECT_LT(labels.labels()[0].at.y, labels.labels()[1].at.y);
    hidden_beyond_ = labels.labels()[1].at.y;
    ++view_.width;
    trace(labels);
    ASSERT_EQ(labels.labels().size(), 2u);
    EXPECT_EQ(labels.labels()[1].part, SlideParts::Part::kStauchwall);
}

TEST_F(LabelsOfASlide, are_looked_for_every_few_ticks_and_at_once_after_a_jump) {
    SlideLabels labels;
    tick(60);
    trace(labels);
    const int once = looked_;
    trace(labels);
    tick(SlideLabels::kStep - 1);
    trace(labels);
    EXPECT_EQ(looked_, once);
    tick(1);
    trace(labels);
    EXPECT_GT(looked_, once);

    ASSERT_TRUE(sandbox_.go_toward(0, [] { return true; }).value());
    ++view_.epoch;
    trace(labels);
    EXPECT_TRUE(labels.labels().empty());
    ASSERT_TRUE(sandbox_.go_toward(60, [] { return true; }).value());
    ++view_.epoch;
    trace(labels);
    EXPECT_EQ(labels.labels().size(), 3u);
}

// Against the projection of two places a metre apart.
TEST_F(LabelsOfASlide, have_the_scale_of_the_ground_in_the_middle_of_the_view) {
    SlideLabels labels;
    trace(labels);
    const render::Camera& camera = view_.camera;
    const glm::dmat4 to_clip = render::projection_matrix(camera, 800. / 600) * render::view_matrix(camera);
    const auto px = [&](glm::dvec3 place) {
        const glm::dvec4 clip = to_clip * glm::dvec4(place, 1);
        return clip.x / clip.w / 2 * 800;
    };
    ASSERT_TRUE(labels.compass() && labels.compass()->metre_px);
    EXPECT_NEAR(*labels.compass()->metre_px, px({151, 150, 0}) - px({150, 150, 0}), 1e-6);
    sky_above_ = -0.35;  // then that of the nearest ground below
    ++view_.width;
    trace(labels);
    EXPECT_TRUE(labels.compass()->metre_px);
    sky_above_ = -2;
    ++view_.width;
    trace(labels);
    EXPECT_FALSE(labels.compass()->metre_px);
}

TEST_F(LabelsOfASlide, point_north_as_the_camera_sees_it) {
    const auto arrows = [&](double azimuth_deg) {
        SlideLabels labels;
        view_.camera.azimuth_deg = azimuth_deg;
        trace(labels);
        return labels.compass().value_or(ui::Compass{});
    };
    const ui::Compass from_south = arrows(180), from_west = arrows(270), from_north = arrows(0);
    EXPECT_LT(from_south.north.y, 0) << "up";
    EXPECT_NEAR(from_south.north.x, 0, 1e-9);
    EXPECT_NEAR(from_south.east.x, 1, 1e-9);
    EXPECT_NEAR(from_west.north.x, -1, 1e-9) << "to the left";
    EXPECT_LT(from_west.east.y, 0);
    EXPECT_GT(from_north.north.y, 0);
    EXPECT_NEAR(from_north.east.x, -1, 1e-9);
}

}  // namespace
}  // namespace game::test
