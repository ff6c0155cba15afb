#pragma once

#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/scene/scene.h"
#include "game/session/sandbox.h"
#include "render/frame.h"
#include "render/gl/context.h"
#include "tests/support/renderer.h"

namespace game::test {

using Bytes = std::vector<std::uint8_t>;

// Draws without a window.
class OffScreen : public testing::Test {
  protected:
    void SetUp() override {
        auto context = render::HeadlessContext::create("auto");
        ASSERT_TRUE(context) << context.error();
        context_.emplace(std::move(*context));
    }

    std::optional<render::HeadlessContext> context_;  // first, because the renderers' GL names live in it
};

// winter-avalanche on a coarse grid, without textures that travel with the flow, and what draws it.
class DrawnScene : public OffScreen {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(OffScreen::SetUp());
        ASSERT_NO_FATAL_FAILURE(support::make_renderer(renderer_, render::Quality::kFast));
        Overrides overrides;
        overrides.squares = 48;
        scene_ = load_scene("winter-avalanche", overrides).value();
        scene_.scenario.look.flow.reset();
    }

    Sandbox sandbox() const {
        LoadedWorld loaded;
        loaded.scene = scene_;
        return Sandbox::begin(std::move(loaded), {}, std::nullopt).value();
    }

    // A small frame of the scene, to which a test adds what it is about.
    render::FrameInput seen(const Session& session, const render::Camera& camera) const {
        return {.world = session.view(),
                .camera = camera,
                .light = scene_.scenario.light,
                .look = scene_.scenario.look,
                .width = 80,
                .height = 45,
                .first_depth = scene_.scenario.depth};
    }
    Bytes drawn(const render::FrameInput& input) {
        renderer_->draw(input);
        return renderer_->read_back().pixels;
    }

    // Plays up to a tick. What `frame(session)` gives every so many ticks.
    template <class Frame>
    static std::map<std::int64_t, Bytes> played(Sandbox& sandbox, std::int64_t last, std::int64_t every,
                                                const Frame& frame) {
        std::map<std::int64_t, Bytes> frames;
        while (sandbox.session().state().tick < last) {
            EXPECT_TRUE(sandbox.tick({}));
            const std::int64_t tick = sandbox.session().state().tick;
            if (tick % every == 0) frames[tick] = frame(sandbox.session());
        }
        return frames;
    }

    // Goes to 100 of these ticks in random order. `frame(session)` must give the same bytes.
    template <class Frame>
    static void expect_the_same_after_100_seeks(Sandbox& sandbox, const std::map<std::int64_t, Bytes>& frames,
                                                const Frame& frame) {
        std::mt19937 random(34);
        for (int i = 0; i < 100; ++i) {
            const auto& [tick, before] = *std::next(frames.begin(), random() % frames.size());
            ASSERT_TRUE(sandbox.go_toward(tick, [] { return true; }).value());
            ASSERT_TRUE(frame(sandbox.session()) == before) << tick;
        }
    }

    std::optional<render::Renderer> renderer_;
    Scene scene_;
};

}  // namespace game::test
