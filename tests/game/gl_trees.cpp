// Frames with a house and with trees for the eye alone, as snow-avalanche has them: after seeking, and both under an
// avalanche.

#include "game/scene/mountains.h"
#include "tests/game/drawn_scene.h"

namespace game::test {
namespace {

class TreesUnderAvalanche : public DrawnScene {
  protected:
    void SetUp() override {
        DrawnScene::SetUp();
        sim::Command house;
        house.kind = sim::CommandKind::kHouse;
        house.x = 1040, house.y = 1130;
        house.length = 11, house.width = 9, house.height = 7.5, house.strength = 5;
        scene_.scenario.standing = {};
        scene_.scenario.standing.placed = {house};
        scene_.scenario.trees = {.density = 3000, .line_m = 2100, .seed = 1};
        mountains_ = mountains_around(scene_.scenario);
        woods_ = woods_on(scene_.scenario, mountains_);
    }

    Bytes frame(const Session& session, const render::Woods* woods, bool after = true) {
        render::FrameInput input = seen(session, {{1000, 1150, 1470}, 205, 25, 500, 50});
        input.surroundings = &mountains_;
        input.woods = woods;
        input.flow_so_far = after ? session.flow_so_far() : render::FlowSoFar{};
        input.structures = &session.structures();
        return drawn(input);
    }

    render::Surroundings mountains_;
    render::Woods woods_;
};

TEST_F(TreesUnderAvalanche, lie_in_the_same_bytes_after_100_random_seeks) {
    Sandbox sandbox = this->sandbox();
    const auto with_trees = [&](const Session& session) { return frame(session, &woods_); };
    const auto frames = played(sandbox, 2400, 25, with_trees);
    EXPECT_NE(frame(sandbox.session(), &woods_), frame(sandbox.session(), nullptr));
    EXPECT_NE(frame(sandbox.session(), &woods_), frame(sandbox.session(), &woods_, false))
        << "no tree was hit";
    EXPECT_EQ(sandbox.session().structures().all.back().state, render::StructureState::kDestroyed);
    expect_the_same_after_100_seeks(sandbox, frames, with_trees);
}

}  // namespace
}  // namespace game::test
