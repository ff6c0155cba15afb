// Frames with powder after seeking: tests/game/powder.cpp has the powder itself.

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/scene/scene.h"
#include "game/session/sandbox.h"
#include "render/context.h"
#include "render/frame.h"

namespace game::test {
namespace {

class DrawnPowder : public testing::Test {
  protected:
    void SetUp() override {
        auto context = render::HeadlessContext::create("auto");
        ASSERT_TRUE(context) << context.error();
        context_.emplace(std::move(*context));
        auto renderer = render::Renderer::create(assets_folder().value(), render::Quality::kFast);
        ASSERT_TRUE(renderer) << renderer.error();
        renderer_.emplace(std::move(*renderer));
        Overrides overrides;
        overrides.squares = 48;
        scene_ = load_scene("winter-avalanche", overrides).value();
        scene_.scenario.look.flow.reset();  // the powder alone has a history
        scene_.scenario.camera = render::Camera{{1000, 1350, 1550}, 205, 10, 500, 50};
    }

    std::vector<std::uint8_t> frame(const Session& session, float strength = 1) {
        renderer_->draw({.world = session.view(),
                         .camera = *scene_.scenario.camera,
                         .light = scene_.scenario.light,
                         .look = scene_.scenario.look,
                         .width = 80,
                         .height = 45,
                         .first_depth = scene_.scenario.depth,
                         .powder = session.powder(),
                         .powder_strength = strength});
        return renderer_->read_back().pixels;
    }

    std::optional<render::HeadlessContext> context_;  // first, because the renderer's GL names live in it
    std::optional<render::Renderer> renderer_;
    Scene scene_;
};

TEST_F(DrawnPowder, is_the_same_bytes_after_100_random_seeks) {
    constexpr std::int64_t kLast = 1500, kEvery = 15;
    LoadedWorld loaded;
    loaded.scene = scene_;
    Sandbox sandbox = Sandbox::begin(std::move(loaded), {}, std::nullopt).value();
    std::map<std::int64_t, std::vector<std::uint8_t>> played;
    std::size_t most = 0;
    while (sandbox.session().state().tick < kLast) {
        ASSERT_TRUE(sandbox.tick({}));
        most = std::max(most, sandbox.session().powder().size());
        const std::int64_t tick = sandbox.session().state().tick;
        if (tick % kEvery == 0) played[tick] = frame(sandbox.session());
    }
    ASSERT_GT(most, 50u);
    std::mt19937 random(34);
    int with_powder = 0;
    for (int i = 0; i < 100; ++i) {
        const std::int64_t tick = kEvery * (1 + static_cast<std::int64_t>(random() % (kLast / kEvery)));
        ASSERT_TRUE(sandbox.go_toward(tick, [] { return true; }).value());
        const auto now = frame(sandbox.session());
        ASSERT_TRUE(now == played.at(tick)) << tick;
        with_powder += now != frame(sandbox.session(), 0);
    }
    EXPECT_GT(with_powder, 30);
}

}  // namespace
}  // namespace game::test
