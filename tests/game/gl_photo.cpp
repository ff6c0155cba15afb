// A photo put together from parts, against the same drawn at once.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "game/controls/photo_parts.h"
#include "game/scene/mountains.h"
#include "tests/game/drawn_scene.h"

namespace game::test {
namespace {

class GlPhoto : public OffScreen {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(OffScreen::SetUp());
        ASSERT_NO_FATAL_FAILURE(make(renderer_));
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

    std::optional<render::Renderer> renderer_;
    std::optional<Sandbox> sandbox_;
    render::Surroundings mountains_;
    render::Woods woods_;
    render::Lens lens_;
};

// Pixels whose difference is seen: dither and rounding change a colour by 2 at most.
int different(const render::Picture& a, const render::Picture& b, int most) {
    int pixels = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        int largest = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            largest = std::max(largest, std::abs(int{a.pixels[c]} - int{b.pixels[c]}));
        pixels += largest > most;
    }
    return pixels;
}

TEST_F(GlPhoto, meets_without_a_seam_where_its_parts_do) {
    const auto plan = PhotoParts::plan({200, 112, 1}, 2, render::kPartOverlap, {});
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->parts(), 4);
    const render::Picture parts = in_parts(*plan), once = at_once(plan->width(), plan->height());
    ASSERT_EQ(parts.width, once.width);
    ASSERT_EQ(parts.height, once.height);
    EXPECT_LE(different(parts, once, 3), 400 * 224 / 2000);
}

TEST_F(GlPhoto, takes_twice_the_light_with_each_step_of_exposure) {
    const render::Picture before = at_once(80, 45);
    lens_.exposure = 0.5;
    const render::Picture after = at_once(80, 45);
    const auto light = [](std::uint8_t code) { return std::pow((code / 255.0 + 0.055) / 1.055, 2.4); };
    int dark = 0;
    for (std::size_t i = 0; i < before.pixels.size(); ++i) {
        if (before.pixels[i] < 80 || before.pixels[i] > 180) continue;  // below the knee of the tone curve
        EXPECT_NEAR(light(after.pixels[i]), light(before.pixels[i]) / 2, 0.02);
        ++dark;
    }
    EXPECT_GT(dark, 100);
}

}  // namespace
}  // namespace game::test
