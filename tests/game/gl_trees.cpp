// Frames with trees after seeking, and trees under an avalanche.

#include <map>
#include <random>

#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/scene/mountains.h"
#include "game/scene/scene.h"
#include "game/session/sandbox.h"
#include "render/context.h"
#include "render/frame.h"

namespace game::test {
namespace {

class TreesUnderAvalanche : public testing::Test {
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
        scene_.scenario.look.flow.reset();  // the trees alone have a history
        scene_.scenario.trees = {.density = 3000, .line_m = 2100, .seed = 1};
        mountains_ = mountains_around(scene_.scenario);
        woods_ = woods_on(scene_.scenario, mountains_);
    }

    std::vector<std::uint8_t> frame(const Session& session, const render::Woods* woods, bool after = true) {
        renderer_->draw({.world = session.view(),
                         .camera = {{1000, 1150, 1470}, 205, 25, 500, 50},
                         .light = scene_.scenario.light,
                         .look = scene_.scenario.look,
                         .width = 80,
                         .height = 45,
                         .first_depth = scene_.scenario.depth,
                         .surroundings = &mountains_,
                         .woods = woods,
                         .flow_so_far = after ? session.flow_so_far() : render::FlowSoFar{}});
        return renderer_->read_back().pixels;
    }

    std::optional<render::HeadlessContext> context_;  // first, because the renderer's GL names live in it
    std::optional<render::Renderer> renderer_;
    Scene scene_;
    render::Surroundings mountains_;
    render::Woods woods_;
};

TEST_F(TreesUnderAvalanche, lie_in_the_same_bytes_after_100_random_seeks) {
    constexpr std::int64_t kLast = 2400, kEvery = 25;
    LoadedWorld loaded;
    loaded.scene = scene_;
    Sandbox sandbox = Sandbox::begin(std::move(loaded), {}, std::nullopt).value();
    std::map<std::int64_t, std::vector<std::uint8_t>> played;
    while (sandbox.session().state().tick < kLast) {
        ASSERT_TRUE(sandbox.tick({}));
        const std::int64_t tick = sandbox.session().state().tick;
        if (tick % kEvery == 0) played[tick] = frame(sandbox.session(), &woods_);
    }
    EXPECT_NE(frame(sandbox.session(), &woods_), frame(sandbox.session(), nullptr));
    EXPECT_NE(frame(sandbox.session(), &woods_), frame(sandbox.session(), &woods_, false))
        << "no tree was hit";
    std::mt19937 random(34);
    for (int i = 0; i < 100; ++i) {
        const std::int64_t tick = kEvery * (1 + static_cast<std::int64_t>(random() % (kLast / kEvery)));
        ASSERT_TRUE(sandbox.go_toward(tick, [] { return true; }).value());
        ASSERT_TRUE(frame(sandbox.session(), &woods_) == played.at(tick)) << tick;
    }
}

}  // namespace
}  // namespace game::test
