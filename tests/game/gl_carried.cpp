// What a landslide carries: seen, and never felt; after seeking, and in frames of which a part is drawn.

#include "game/analysis/headless.h"
#include "game/scene/mountains.h"
#include "tests/game/drawn_scene.h"

namespace game::test {
namespace {

class CarriedBySlide : public DrawnScene {
  protected:
    void SetUp() override {
        DrawnScene::SetUp();
        Overrides overrides;
        overrides.squares = 56;
        scene_ = load_scene("hillside", overrides).value();
        scene_.scenario.look.flow.reset();
        ASSERT_TRUE(renderer_->load(scene_.scenario.look, false));
        mountains_ = mountains_around(scene_.scenario);
    }

    render::FrameInput input(const Session& session, bool with = true) const {
        render::FrameInput input = seen(session, {{985, 480, 960}, 185, 25, 120, 50});
        input.surroundings = &mountains_;
        if (with) input.carried = session.carried();
        return input;
    }

    render::Surroundings mountains_;
};

TEST_F(CarriedBySlide, is_the_same_bytes_after_100_random_seeks) {
    Sandbox sandbox = this->sandbox();
    const auto frames =
        played(sandbox, 2100, 25, [&](const Session& session) { return drawn(input(session)); });
    EXPECT_GT(sandbox.session().carried().size(), 50u);
    EXPECT_NE(drawn(input(sandbox.session())), drawn(input(sandbox.session(), false)));
    expect_the_same_after_100_seeks(sandbox, frames,
                                    [&](const Session& session) { return drawn(input(session)); });
}

// Which shader a part of the frame needs is found from the world: none may miss what another one draws.
TEST_F(CarriedBySlide, lies_on_ground_that_is_shaded_alike_in_every_part) {
    std::optional<render::Renderer> alike;
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(alike, render::Quality::kFast));
    ASSERT_TRUE(alike->load(scene_.scenario.look, false));
    alike->set_redraw({.parts_by_kind = false});
    auto session = Session::begin(scene_.scenario, {}, std::nullopt).value();
    for (const int until : {1000, 1440, 1900, 2600}) {
        ASSERT_TRUE(play_headless(session, scene_.commands, Until::after(until), {}, scene_.scenario.title));
        for (const double azimuth : {185.0, 95.0}) {
            render::FrameInput input = this->input(session);
            input.camera = {{985, 440, 950}, azimuth, 14, 240, 50};
            input.width = 640, input.height = 360;
            const Bytes parts = drawn(input);
            alike->draw(input);
            const Bytes whole = alike->read_back().pixels;
            int differ = 0;
            for (std::size_t i = 0; i < parts.size(); ++i) differ += std::abs(parts[i] - whole[i]) > 3;
            EXPECT_EQ(differ, 0) << "tick " << until << ", from " << azimuth;
        }
    }
}

TEST_F(CarriedBySlide, changes_nothing_of_the_world) {
    std::vector<std::uint64_t> hashes;
    for (const bool followed : {true, false}) {
        auto session = Session::begin(scene_.scenario, {}, std::nullopt).value();
        if (followed) session.follow_carried(scene_.scenario);
        ASSERT_TRUE(play_headless(session, scene_.commands, Until::after(1500), {}, scene_.scenario.title));
        EXPECT_EQ(session.carried().empty(), !followed);
        hashes.push_back(session.state_line().hash);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_F(CarriedBySlide, is_drawn_in_parts_as_in_whole_frames) {
    std::optional<render::Renderer> whole;
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(whole, render::Quality::kFast));
    ASSERT_TRUE(whole->load(scene_.scenario.look, false));
    Sandbox sandbox = this->sandbox();
    int in_parts = 0;
    static_cast<void>(played(sandbox, 1900, 20, [&](const Session& session) {
        const Bytes parts = drawn(input(session));
        in_parts += renderer_->redrawn() < 1;
        whole->forget();
        whole->draw(input(session));
        EXPECT_EQ(parts, whole->read_back().pixels) << "tick " << session.state().tick;
        return parts;
    }));
    EXPECT_GT(in_parts, 20);
}

TEST_F(CarriedBySlide, is_not_drawn_without_a_date_and_under_an_overlay) {
    Sandbox sandbox = this->sandbox();
    static_cast<void>(played(sandbox, 1500, 1500, [](const Session&) { return Bytes(); }));
    const auto drawn_as = [&](bool dated, render::Overlay overlay, bool with) {
        render::FrameInput frame = input(sandbox.session(), with);
        if (!dated) frame.look.date.reset();
        frame.marks.overlay = overlay;
        return drawn(frame);
    };
    EXPECT_NE(drawn_as(true, {}, true), drawn_as(true, {}, false));
    EXPECT_EQ(drawn_as(false, {}, true), drawn_as(false, {}, false));
    EXPECT_EQ(drawn_as(true, render::Overlay::kSlope, true), drawn_as(true, render::Overlay::kSlope, false));
}

}  // namespace
}  // namespace game::test
