// Frames with powder after seeking: tests/game/powder.cpp has the powder itself.

#include <algorithm>

#include "tests/game/drawn_scene.h"

namespace game::test {
namespace {

class DrawnPowder : public DrawnScene {
  protected:
    void SetUp() override {
        DrawnScene::SetUp();
        scene_.scenario.camera = render::Camera{{1000, 1350, 1550}, 205, 10, 500, 50};
    }

    Bytes frame(const Session& session, float strength = 1) {
        render::FrameInput input = seen(session, *scene_.scenario.camera);
        input.powder = session.powder();
        input.powder_strength = strength;
        return drawn(input);
    }
};

TEST_F(DrawnPowder, is_the_same_bytes_after_100_random_seeks) {
    Sandbox sandbox = this->sandbox();
    std::size_t most = 0;
    const auto frames = played(sandbox, 1500, 15, [&](const Session& session) {
        most = std::max(most, session.powder().size());
        return frame(session);
    });
    ASSERT_GT(most, 50u);
    int with_powder = 0;
    expect_the_same_after_100_seeks(sandbox, frames, [&](const Session& session) {
        Bytes now = frame(session);
        with_powder += now != frame(session, 0);
        return now;
    });
    EXPECT_GT(with_powder, 30);
}

}  // namespace
}  // namespace game::test
