// A photo put together from parts, against the same drawn at once.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "game/controls/photo_parts.h"
#include "game/scene/mountains.h"
#include "render/mountain/pick.h"
#include "tests/game/drawn_scene.h"

namespace game::test {
namespace {

class GlPhoto : public OffScreen {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(OffScreen::SetUp());
        ASSERT_NO_FATAL_FAILURE(support::make_renderer(renderer_, render::Quality::kFast));
        renderer_->set_quality(render::Quality::kFine);
        Overrides overrides;
        overrides.squares = 48;
        LoadedWorld loaded;
        loaded.scene = load_scene("winter-avalanche", overrides).value();
        mountains_ = mountains_around(loaded.scene.scenario);
        woods_ = woods_on(loaded.scene.scenario, mountains_);
        sandbox_.emplace(Sandbox::begin(std::move(loaded), {}, std::nullopt).value());
        for (int i = 0; i < 500; ++i) ASSERT_TRUE(sandbox_->tick({}));
        ASSERT_FALSE(sandbox_->session().powder().empty());
    }

    // Everything that stands and flies there, with trees, powder and spindrift.
    render::FrameInput seen(const ImageSize& frame, const render::WholeImage& whole) const {
        const Scenario& scenario = sandbox_->scenario();
        const Session& session = sandbox_->session();
        return {.world = session.view(),
                .camera = *scenario.camera,
                .light = scenario.light,
                .look = scenario.look,
                .width = frame.width,
                .height = frame.height,
                .whole = whole,
                .lens = lens_,
                .first_depth = scenario.depth,
                .surroundings = &mountains_,
                .powder = session.powder(),
                .woods = &woods_,
                .flow_so_far = session.flow_so_far(),
                .structures = &session.structures(),
                .wind = scenario.wind,
                .seconds = session.seconds()};
    }
    render::Picture in_parts(const PhotoParts& plan) {
        render::Picture photo{plan.width(), plan.height(),
                              Bytes(static_cast<std::size_t>(3 * plan.width() * plan.height()))};
        for (int part = 0; part < plan.parts(); ++part) {
            renderer_->draw(seen(plan.frame(), plan.place(part)));
            plan.put(part, renderer_->read_back(), photo);
        }
        return photo;
    }
    render::Picture at_once(int width, int height) {
        renderer_->draw(seen({width, height, true}, {width, height}));
        return renderer_->read_back();
    }

    // Distance along the view to what the middle of the image shows.
    double in_the_middle() const {
        const render::Camera& camera = *sandbox_->scenario().camera;
        const auto at =
            render::pick(sandbox_->session().view(), render::ray_through(camera, 16.0 / 9, {0, 0}));
        EXPECT_TRUE(at);
        return at ? glm::distance(*at, render::eye(camera)) : 1;
    }

    std::optional<render::Renderer> renderer_;
    std::optional<Sandbox> sandbox_;
    render::Surroundings mountains_;
    render::Woods woods_;
    std::optional<render::Lens> lens_;
};

// Pixels inside a border whose difference is seen: dither and rounding change a colour by 2 at most.
int different(const render::Picture& a, const render::Picture& b, int border) {
    constexpr int kUnseen = 3;
    int pixels = 0;
    for (int y = border; y < a.height - border; ++y)
        for (int x = border; x < a.width - border; ++x) {
            const auto at = static_cast<std::size_t>(3 * (y * a.width + x));
            int largest = 0;
            for (std::size_t c = at; c < at + 3; ++c)
                largest = std::max(largest, std::abs(int{a.pixels[c]} - int{b.pixels[c]}));
            pixels += largest > kUnseen;
        }
    return pixels;
}

TEST_F(GlPhoto, meets_without_a_seam_where_its_parts_do) {
    for (const double blur : {0.0, 0.02}) {
        lens_ = render::Lens{.blur = blur, .focus_m = in_the_middle()};
        const auto plan = PhotoParts::plan({200, 112, 1}, 2, PhotoParts::rim_of(lens_, 224), {});
        ASSERT_TRUE(plan);
        ASSERT_EQ(plan->parts(), 4);
        const render::Picture parts = in_parts(*plan), once = at_once(plan->width(), plan->height());
        ASSERT_EQ(parts.width, once.width);
        ASSERT_EQ(parts.height, once.height);
        // At the border of the photo a lens sees more in parts than at once.
        EXPECT_LE(different(parts, once, blur > 0 ? 7 : 0), 400 * 224 / 2000) << blur;
    }
}

TEST_F(GlPhoto, is_sharp_where_its_lens_is_focused_and_blurred_elsewhere) {
    const auto contrast = [](const render::Picture& photo, int x0, int x1, int y0, int y1) {
        int sum = 0;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const auto at = static_cast<std::size_t>(3 * (y * photo.width + x));
                sum += std::abs(int{photo.pixels[at]} - int{photo.pixels[at + 3]});
            }
        return sum;
    };
    const render::Picture sharp = at_once(320, 180);
    lens_ = render::Lens{.blur = 0.02, .focus_m = in_the_middle()};
    const render::Picture focused = at_once(320, 180);
    lens_->focus_m = 10;
    const render::Picture near = at_once(320, 180);
    const auto middle = [&](const render::Picture& photo) { return contrast(photo, 156, 164, 87, 93); };
    const auto all = [&](const render::Picture& photo) { return contrast(photo, 0, 319, 0, 180); };
    EXPECT_GE(middle(focused), 0.7 * middle(sharp));
    EXPECT_LE(middle(near), 0.6 * middle(sharp));
    EXPECT_LE(all(near), 0.6 * all(sharp));
    EXPECT_LE(all(near), all(focused));
    EXPECT_LE(all(focused), all(sharp));
}

TEST_F(GlPhoto, takes_twice_the_light_with_each_step_of_exposure) {
    const render::Picture before = at_once(80, 45);
    lens_ = render::Lens{.exposure = 0.5};
    const render::Picture after = at_once(80, 45);
    const auto light = [](std::uint8_t code) { return std::pow((code / 255.0 + 0.055) / 1.055, 2.4); };
    int dark = 0;
    for (std::size_t i = 0; i < before.pixels.size(); ++i) {
        if (before.pixels[i] < 80 || before.pixels[i] > 180) continue;  // below the knee of the tone curve
        EXPECT_NEAR(light(after.pixels[i]), light(before.pixels[i]) / 2, 0.02);
        ++dark;
    }
    EXPECT_GT(dark, 100);
    lens_.reset();
    EXPECT_TRUE(at_once(80, 45).pixels == before.pixels) << "without a lens all is as before";
}

}  // namespace
}  // namespace game::test
