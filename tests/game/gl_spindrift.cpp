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
        render::FrameInput input = seen(session, {{720, 1840, 2100}, 172, -8, 420, 50});
        input.surroundings = &mountains_;
        input.wind = scene_.scenario.wind;
        input.seconds = session.seconds();
        return drawn(input);
    }

    render::Surroundings mountains_;
};

TEST_F(WindyScene, smokes_in_the_same_bytes_after_100_random_seeks) {
    scene_.commands.clear();  // only snow in the wind moves
    Sandbox sandbox = this->sandbox();
    const auto frames = played(sandbox, 600, 25, [&](const Session& session) { return frame(session); });
    EXPECT_NE(frames.begin()->second, frames.rbegin()->second);
    expect_the_same_after_100_seeks(sandbox, frames, [&](const Session& session) { return frame(session); });
}

}  // namespace
}  // namespace game::test
