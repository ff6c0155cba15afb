// Frames with spindrift after seeking.

#include "game/scene/mountains.h"
#include "tests/game/drawn_scene.h"

namespace game::test {
namespace {

class WindyScene : public DrawnScene {
  protected:
    void SetUp() override {
        DrawnScene::SetUp();
        mountains_ = mountains_around(scene_.scenario);
    }

    Bytes frame(const Session& session) {
        renderer_->draw({.world = session.view(),
                         .camera = {{720, 1840, 2100}, 172, -8, 420, 50},
                         .light = scene_.scenario.light,
                         .look = scene_.scenario.look,
                         .width = 80,
                         .height = 45,
                         .first_depth = scene_.scenario.depth,
                         .surroundings = &mountains_,
                         .wind = scene_.scenario.wind,
                         .seconds = session.seconds()});
        return renderer_->read_back().pixels;
    }

    render::Surroundings mountains_;
};

TEST_F(WindyScene, smokes_in_the_same_bytes_after_100_random_seeks) {
    scene_.commands.clear();  // only snow in the wind moves
    Sandbox sandbox = this->sandbox();
    const auto frames = played(sandbox, 600, 25, [&](const Session& session) {
        Bytes now = frame(session);
        EXPECT_TRUE(renderer_->stirs());
        return now;
    });
    EXPECT_NE(frames.begin()->second, frames.rbegin()->second);
    expect_the_same_after_100_seeks(sandbox, frames, [&](const Session& session) { return frame(session); });
}

}  // namespace
}  // namespace game::test
