#include <functional>
#include <string>
#include <vector>

#include "tests/render/gl_scene.h"
#include "tests/support/places.h"
#include "tests/support/renderer.h"

// Frames of which only what changed is drawn. tests/game/gl_redraw.cpp plays random sessions; here a renderer forgets one
// thing after the other on purpose, and each time the comparison must see it.
namespace render::test {
namespace {

constexpr int kAcrossFrame = 200, kUpFrame = 120;

// Marks as they are, so that one that is missing shows.
constexpr RedrawRules kTightestRules{.tile = 1, .most_rectangles = 64, .least_gain = 1, .block = 1};

// What changes from frame to frame before a camera that stands still.
struct Play {
    World world = make_world(64, 4, [](double, double) { return 0; });
    Camera camera{{128, 128, 5}, 180, 20, 150, 50};
    Light light{120, 25};
    std::vector<float> first_depth = std::vector<float>(world.grid.size(), 2.f);
    std::vector<sim::powder::Puff> puffs;
    Structures structures;

    Play() { world.depth.fill(2); }

    // A block of so many metres, on vertices from `low` to `high`.
    void set_tower(glm::ivec2 low, glm::ivec2 high, float height) {
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) world.depth(x, y) = 2 + height;
    }
    FrameInput input() const {
        return {.world = world.view(),
                .camera = camera,
                .light = light,
                .width = kAcrossFrame,
                .height = kUpFrame,
                .first_depth = first_depth,
                .powder = puffs,
                .structures = &structures};
    }
};

struct Mistake {
    const char* name;
    void (*make)(RedrawRules&);
    void (*begin)(Play&);
    void (*go_on)(Play&, int frame);
};

class Redraw : public Gl, public testing::WithParamInterface<Mistake> {
  protected:
    void SetUp() override {
        Gl::SetUp();
        ASSERT_NO_FATAL_FAILURE(support::make_renderer(whole_, Quality::kFast));
    }

    // Frames that differ from those that are drawn as a whole.
    int wrong_frames(const RedrawRules& rules) {
        const auto& [name, make, begin, go_on] = GetParam();
        Play play;
        begin(play);
        renderer_->set_redraw(rules);
        renderer_->forget();
        int wrong = 0;
        for (int frame = 0; frame < 12; ++frame) {
            if (frame > 0) go_on(play, frame);
            renderer_->draw(play.input());
            whole_->forget();
            whole_->draw(play.input());
            wrong += renderer_->read_back().pixels != whole_->read_back().pixels;
            EXPECT_TRUE(frame == 0 ? renderer_->redrawn() == 1 : renderer_->redrawn() < 0.9) << frame;
        }
        return wrong;
    }

    std::optional<Renderer> whole_;
};

TEST_P(Redraw, draws_the_same_bytes_and_shows_a_mistake) {
    EXPECT_EQ(wrong_frames(kTightestRules), 0);
    RedrawRules mistaken = kTightestRules;
    GetParam().make(mistaken);
    EXPECT_GT(wrong_frames(mistaken), 0);
}

TEST_F(Gl, redraws_only_around_an_outline_that_is_moved) {
    std::optional<Renderer> whole;
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(whole, Quality::kFast));
    Play play;
    renderer_->set_redraw(kTightestRules);
    for (int frame = 0; frame < 6; ++frame) {
        FrameInput input = play.input();
        if (frame < 5)
            input.marks.outline = outline_of({80 + 20 * frame, 120}, 25 * frame, 20, 10, {0, 1, 0});
        if (frame == 0) input.marks.outline->colour = {1, 0, 0};
        renderer_->draw(input);
        whole->forget();
        whole->draw(input);
        EXPECT_TRUE(alike(renderer_->read_back(), whole->read_back())) << frame;
        EXPECT_TRUE(frame == 0 || frame == 5 || renderer_->redrawn() < 0.6) << frame;
    }
}

TEST_F(Gl, redraws_only_around_the_outline_of_an_extent_that_grows) {
    std::optional<Renderer> whole;
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(whole, Quality::kFast));
    Play play;
    renderer_->set_redraw(kTightestRules);
    renderer_->draw(play.input());
    const auto plain = renderer_->read_back().pixels;
    std::vector<std::uint8_t> extent(play.world.grid.size());
    for (int frame = 0; frame < 7; ++frame) {
        FrameInput input = play.input();
        for (int y = 0; y < play.world.grid.ny; ++y)
            for (int x = 0; x < play.world.grid.nx; ++x)
                extent[static_cast<std::size_t>(y * play.world.grid.nx + x)] =
                    std::hypot(x - 30, y - 28) < 3 + frame % 6 ? 255 : 0;
        if (frame < 6) input.marks.extent = frame + 1, input.extent = extent;
        renderer_->draw(input);
        whole->forget();
        whole->draw(input);
        EXPECT_TRUE(alike(renderer_->read_back(), whole->read_back())) << frame;
        EXPECT_TRUE(frame == 0 || frame == 6 || renderer_->redrawn() < 0.6) << frame;
        EXPECT_EQ(renderer_->read_back().pixels == plain, frame == 6) << frame;
    }
}

// A forest is planted, broken and felled, and houses are built, damaged and removed.
TEST_F(Gl, redraws_only_around_a_forest_and_houses_that_change) {
    std::optional<Renderer> whole;
    ASSERT_NO_FATAL_FAILURE(support::make_renderer(whole, Quality::kFast));
    Play play;
    play.world.things.emplace(play.world.grid);
    play.world.things->natural = play.world.bedrock;
    sim::Field<sim::Stems>& forest = play.world.things->forest;
    const auto plant = [&](glm::ivec2 low, glm::ivec2 high, const sim::Stems& stems) {
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) forest(x, y) = stems;
    };
    plant({40, 40}, {48, 48}, {500, 0, 30, 18});
    renderer_->set_redraw(kTightestRules);
    std::vector<std::uint8_t> before;
    for (int frame = 0; frame < 9; ++frame) {
        if (frame == 1) plant({20, 20}, {24, 24}, {400, 0, 30, 22});
        if (frame == 2) plant({20, 20}, {22, 24}, {0, 400, 30, 22});
        if (frame == 3) plant({20, 20}, {24, 24}, {});
        if (frame == 4) play.structures.all.push_back({StructureKind::kHouse, {150, 100}, 30, {}, 14, 10, 9});
        if (frame == 5) play.structures.all[0].state = StructureState::kDestroyed;
        if (frame == 6) play.structures.nets.push_back({{90, 90}, {110, 92}});
        if (frame == 7) play.structures = {};
        if (frame == 8) play.world.rolling(32, 30) = 1;
        renderer_->draw(play.input());
        whole->forget();
        whole->draw(play.input());
        const Picture picture = renderer_->read_back();
        EXPECT_TRUE(alike(picture, whole->read_back())) << frame;
        EXPECT_NE(picture.pixels, before) << frame;
        EXPECT_TRUE(frame == 0 || renderer_->redrawn() < 0.9) << frame;
        before = picture.pixels;
    }
}

// Earth is heaped up and dug out, with its shadow, on ground without a standing layer.
TEST_F(Gl, redraws_ground_that_changes_as_if_it_had_always_been_so) {
    Play play;
    play.world.depth.fill(0);
    play.first_depth.clear();
    play.world.things.emplace(play.world.grid);
    play.world.things->natural = play.world.bedrock;
    renderer_->set_redraw(kTightestRules);
    Picture flat;
    for (int frame = 0; frame < 5; ++frame) {
        const float height = frame == 4 ? 0.f : 3.f * static_cast<float>(frame) * (frame == 3 ? -1.f : 1.f);
        for (int y = 20; y < 27; ++y)
            for (int x = 30; x < 36; ++x) play.world.bedrock(x, y) = play.world.things->earth(x, y) = height;
        renderer_->draw(play.input());
        EXPECT_TRUE(frame == 0 || renderer_->redrawn() < 1) << frame;
        const Picture picture = renderer_->read_back();
        std::optional<Renderer> fresh;
        ASSERT_NO_FATAL_FAILURE(support::make_renderer(fresh, Quality::kFast));
        fresh->draw(play.input());
        EXPECT_TRUE(alike(picture, fresh->read_back())) << frame;
        if (frame == 0) flat = picture;
        EXPECT_EQ(picture.pixels == flat.pixels, frame == 0 || frame == 4) << frame;
    }
    // A world that never had things looks the same as one that has none any more.
    play.world.things.reset();
    renderer_->draw(play.input());
    EXPECT_TRUE(alike(renderer_->read_back(), flat));
}

// Snow that has fallen looks as if it had always lain there; a deposit on it does not.
TEST_F(Gl, draws_fresh_snow_as_cover_and_not_as_a_deposit) {
    Play play;
    renderer_->set_redraw(kTightestRules);
    std::vector<float> undisturbed;
    Picture before;
    for (int hour = 0; hour < 4; ++hour) {
        const float fell = 0.5f * static_cast<float>(hour);
        play.world.depth.fill(2 + fell);
        play.set_tower({20, 20}, {26, 26}, fell + 0.4f);  // brought there
        undisturbed.assign(play.world.grid.size(), 2 + fell);
        FrameInput input = play.input();
        input.undisturbed = undisturbed;
        renderer_->draw(input);
        const Picture picture = renderer_->read_back();
        std::optional<Renderer> fresh;
        ASSERT_NO_FATAL_FAILURE(support::make_renderer(fresh, Quality::kFast));
        input.first_depth = undisturbed;
        fresh->draw(input);
        EXPECT_TRUE(alike(picture, fresh->read_back())) << hour;
        input.undisturbed = input.first_depth = play.first_depth;
        fresh->draw(input);
        EXPECT_EQ(picture.pixels == fresh->read_back().pixels, hour == 0);
        EXPECT_NE(picture.pixels, before.pixels) << hour;
        before = picture;
    }
}

void roll(Play& play, int x, int frame) {
    for (int i = 0; i < 3; ++i)
        play.world.rolling(x + i, 32 + (frame + i) % 3) = 0.1f * static_cast<float>(1 + (frame + i) % 4);
}

const Mistake kMistakes[] = {
    {"reach", [](RedrawRules& rules) { rules.reach = 1; },
     [](Play& play) {
         play.light = {120, 80};  // shadows are shorter than slopes reach
         play.camera = from_above({128, 128, 0}, 80);
     },
     [](Play& play, int frame) { play.world.rolling(32, 32) = static_cast<float>(frame % 4); }},
    {"a_rectangle", [](RedrawRules& rules) { rules.last_rectangle = false; },
     [](Play& play) {
         play.camera = from_above({128, 128, 0}, 250);
     },
     [](Play& play, int frame) { roll(play, 15, frame), roll(play, 50, frame); }},
    // Its shadow reaches farther than anything else that a tower changes.
    {"shadows", [](RedrawRules& rules) { rules.sun = false; },
     [](Play& play) {
         play.light = {120, 12};
         play.camera = from_above({128, 128, 0}, 250);
         play.set_tower({38, 30}, {42, 34}, 30);
     },
     [](Play& play, int frame) {
         play.set_tower({38, 30}, {42, 34}, 30 - 2 * static_cast<float>(frame));
     }},
    // A tower sinks before the sky.
    {"what_was_there", [](RedrawRules& rules) { rules.old_heights = false; },
     [](Play& play) {
         play.camera = {{128, 128, 20}, 180, 2, 150, 50};
         play.set_tower({26, 30}, {38, 34}, 60);
     },
     [](Play& play, int frame) {
         play.set_tower({26, 30}, {38, 34}, 60 - 4 * static_cast<float>(frame));
     }},
    // The upper edge of a long wall slopes a little, so that its stairs are long; somewhere on it a tower rises.
    {"edges", [](RedrawRules& rules) { rules.edge_reach = 0; },
     [](Play& play) {
         play.light = {0, 12};  // the wall is dark before the sky
         play.camera = {{128, 128, 20}, 180, 2, 900, 25};
         for (int x = 12; x < 60; ++x) play.set_tower({x, 31}, {x, 33}, 10 + 0.3f * static_cast<float>(x));
     },
     [](Play& play, int frame) {
         for (int x = 14; x < 58; x += 4)
             play.set_tower({x, 31}, {x, 33},
                            10 + 0.3f * static_cast<float>(x) + (x % 12 == 2 * (frame % 6) ? 2.f : 0.f));
     }},
    // The shadow of a tower that rises comes over a house, which is seen before ground far behind it.
    {"things", [](RedrawRules& rules) { rules.things = false; },
     [](Play& play) {
         play.light = {90, 12};
         play.camera = {{128, 128, 5}, 180, 6, 60, 50};
         play.structures.all.push_back({StructureKind::kHouse, {128, 128}, 0, {}, 11, 9, 7.5});
     },
     [](Play& play, int frame) {
         play.set_tower({44, 29}, {46, 35}, 2 * static_cast<float>(frame));
     }},
    // A puff goes by.
    {"air", [](RedrawRules& rules) { rules.air = false; },
     [](Play& play) {
         play.camera = {{128, 128, 5}, 180, 10, 300, 50};
     },
     [](Play& play, int frame) {
         sim::powder::Puff puff{};
         puff.at = {40.f + 17.f * static_cast<float>(frame), 128.f, 12.f};
         puff.first_radius = 6, puff.density = 0.8f;
         puff.age_s = 1, puff.life_s = 4;
         play.puffs = {puff};
     }},
};

INSTANTIATE_TEST_SUITE_P(Without, Redraw, testing::ValuesIn(kMistakes),
                         [](const auto& mistake) { return mistake.param.name; });

}  // namespace
}  // namespace render::test
