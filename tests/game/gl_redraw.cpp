// Frames of which only what changed was drawn, against the same frames drawn anew as a whole.

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "game/scene/mountains.h"
#include "render/mountain/overview.h"
#include "tests/game/drawn_scene.h"

namespace game::test {
namespace {

// A person who plays for a while: everything that a window can do to a frame, at random.
class Player {
  public:
    Player(const std::string& scene, unsigned seed) : random_(seed) {
        Overrides overrides;
        overrides.squares = chance(0.5) ? 48 : 80;
        scene_ = load_scene(scene, overrides).value();
        backdrop_ = backdrop_of(scene_.scenario);
        LoadedWorld loaded;
        loaded.scene = scene_;
        sandbox_.emplace(Sandbox::begin(std::move(loaded), {}, std::nullopt).value());
        camera_ = scene_.scenario.camera.value_or(render::overview(sandbox_->session().view()));
        light_ = scene_.scenario.light;
    }

    void begin_anywhere() {
        if (chance(0.5)) turn_somewhere();
        for (int i = from(0, 600); i > 0; --i) tick();
    }

    // Lets some time pass and does something, perhaps.
    void act() {
        for (int i = from(0, 4); i > 0; --i) tick();
        const sim::View world = sandbox_->session().view();
        const double side = (world.grid.nx - 1) * static_cast<double>(world.grid.dx);
        const auto place = [&] { return glm::dvec2(share() * side, share() * side); };
        if (chance(0.03)) camera_.azimuth_deg += 4 * share() - 2;
        if (chance(0.01)) turn_somewhere();
        if (chance(0.01)) width_ = from(0, 1) ? 320 : from(1, 330), height_ = from(0, 1) ? 180 : from(1, 190);
        if (chance(0.01)) fine_ = !fine_;
        if (chance(0.01)) overlay_ = static_cast<render::Overlay>(from(0, 6));
        if (chance(0.05)) overlay_ = render::Overlay::kNone;
        if (chance(0.01)) contours_ = !contours_;
        if (chance(0.01)) mesh_ = !mesh_;
        if (chance(0.3)) mesh_ = false;
        if (chance(0.01)) light_.elevation_deg = 60 * share() - 5, light_.azimuth_deg = 360 * share();
        if (chance(0.01)) with_trees_ = !with_trees_;
        if (chance(0.02)) powder_ = static_cast<float>(share());
        if (chance(0.01)) with_mountains_ = !with_mountains_;
        if (chance(0.02)) ring_.reset();
        if (chance(0.02)) ring_ = render::Ring{place(), 5 + 40 * share(), {0.1f, 0.4f, 0.9f}};
        if (ring_ && chance(0.7)) ring_->centre += glm::dvec2(6 * share() - 3, 6 * share() - 3);
        if (chance(0.06)) command(place());
        if (chance(0.02)) go_back();
    }

    void tick() {
        const auto done = sandbox_->tick({});
        EXPECT_TRUE(done) << done.error().sentence;
    }
    void command(glm::dvec2 at) {
        sim::Command command;
        constexpr sim::CommandKind kKinds[] = {sim::CommandKind::kPour, sim::CommandKind::kDig,
                                               sim::CommandKind::kBlast, sim::CommandKind::kSettle};
        command.kind = kKinds[from(0, 3)];
        command.x = at.x;
        command.y = at.y;
        command.radius = 10 + 40 * share();
        if (command.kind == sim::CommandKind::kPour) command.rate = 3000 * share();
        if (command.kind == sim::CommandKind::kDig) command.rate = 0.5 * share();
        if (command.kind == sim::CommandKind::kBlast) command.depth = 0.2 + 2 * share();
        EXPECT_TRUE(sandbox_->tick({&command, 1}));
    }
    void go_back() {
        const std::int64_t now = sandbox_->session().state().tick;
        static_cast<void>(sandbox_->go_toward(now * from(0, 100) / 100, [] { return true; }));
    }
    // Near the ground as often as far above it, so that crests are seen from beside them.
    void turn_somewhere() {
        const sim::Grid& grid = sandbox_->session().view().grid;
        look_at({from(0, grid.nx - 1), from(0, grid.ny - 1)}, chance(0.5) ? 3 + 10 * share() : 60 * share(),
                chance(0.5) ? 30 + 200 * share() : 200 + 2000 * share());
    }
    void look_at(glm::ivec2 v, double elevation_deg, double distance_m) {
        const sim::View world = sandbox_->session().view();
        camera_.target = {
            v.x * static_cast<double>(world.grid.dx), v.y * static_cast<double>(world.grid.dx),
            world.datum + static_cast<double>(world.bedrock(v.x, v.y) + world.depth(v.x, v.y)) + 3};
        camera_.azimuth_deg = 360 * share();
        camera_.elevation_deg = elevation_deg;
        camera_.distance_m = distance_m;
        camera_.field_of_view_deg = 25 + 50 * share();
    }

    render::FrameInput input() const {
        const Session& session = sandbox_->session();
        return {.world = session.view(),
                .camera = camera_,
                .light = light_,
                .look = scene_.scenario.look,
                .marks = {.overlay = overlay_, .contours = contours_, .flow_mesh = mesh_, .ring = ring_},
                .flow = session.fronts(),
                .width = width_,
                .height = height_,
                .first_depth = scene_.scenario.depth,
                .surroundings = with_mountains_ ? &backdrop_.mountains : nullptr,
                .land = &backdrop_.land,
                .powder = session.powder(),
                .powder_strength = powder_,
                .carried = session.carried(),
                .woods = with_trees_ ? &backdrop_.woods : nullptr,
                .flow_so_far = session.flow_so_far(),
                .structures = &session.structures(),
                .wind = scene_.scenario.wind,
                .seconds = session.seconds()};
    }
    bool fine() const { return fine_; }
    const Scenario& scenario() const { return scene_.scenario; }

  private:
    bool chance(double of) { return share() < of; }
    double share() { return static_cast<double>(random_()) / 4294967296.0; }
    int from(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }

    std::mt19937 random_;
    Scene scene_;
    Backdrop backdrop_;
    std::optional<Sandbox> sandbox_;
    render::Camera camera_;
    render::Light light_;
    render::Overlay overlay_ = render::Overlay::kNone;
    std::optional<render::Ring> ring_;
    bool contours_ = false, mesh_ = false, fine_ = false, with_trees_ = true, with_mountains_ = true;
    float powder_ = 1;
    int width_ = 320, height_ = 180;
};

class Redraw : public OffScreen {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(OffScreen::SetUp());
        for (std::optional<render::Renderer>* renderer : {&parts_, &whole_})
            ASSERT_NO_FATAL_FAILURE(support::make_renderer(*renderer, render::Quality::kFast));
    }

    // Bytes that differ between a frame of which what changed was drawn and the same one drawn as a whole.
    int differing(const Player& player) {
        const render::FrameInput input = player.input();
        for (render::Renderer* renderer : {&*parts_, &*whole_}) {
            EXPECT_TRUE(renderer->load(input.look, input.ground_kind().two_materials));
            renderer->set_quality(player.fine() ? render::Quality::kFine : render::Quality::kFast);
        }
        parts_->draw(input);
        whole_->forget();
        whole_->draw(input);
        const render::Picture changed = parts_->read_back(), all = whole_->read_back();
        redrawn_ += parts_->redrawn();
        ++frames_;
        if (parts_->redrawn() < 1) ++in_parts_;
        int bytes = 0;
        where_ = {};
        for (std::size_t i = 0; i < all.pixels.size(); ++i)
            if (changed.pixels[i] != all.pixels[i]) {
                ++bytes;
                const int pixel = static_cast<int>(i) / 3;
                const int x = pixel % all.width, y = all.height - 1 - pixel / all.width;
                where_ = around_both(where_, {x, y, x + 1, y + 1});
                most_ = std::max(most_, std::abs(changed.pixels[i] - all.pixels[i]));
            }
        return bytes;
    }

    static int sessions(int otherwise) {
        const char* asked = std::getenv("COULOIR_REDRAW_SESSIONS");
        return asked ? std::atoi(asked) : otherwise;
    }

    std::optional<render::Renderer> parts_, whole_;
    double redrawn_ = 0;
    int frames_ = 0, in_parts_ = 0;
    render::Rectangle where_;  // around bytes that differ
    int most_ = 0;             // by which they do
};

constexpr const char* kScenes[] = {"winter-avalanche", "snow-on-soil", "landslide", "alpine-valley",
                                   "snow-avalanche"};  // a bare run plays the first three

// The tightest parts: each mark as it is, so that one that is missing shows.
constexpr render::RedrawRules kTightest{.tile = 1, .most_rectangles = 64, .least_gain = 1, .block = 1};

// 200 sessions of 100 frames: COULOIR_REDRAW_SESSIONS=200.
class RandomSessions : public Redraw, public testing::WithParamInterface<bool> {};

TEST_P(RandomSessions, draw_the_same_bytes_in_parts_as_a_whole) {
    if (GetParam()) parts_->set_redraw(kTightest);
    const int sessions = this->sessions(3);
    for (int s = 0; s < sessions; ++s) {
        Player player(kScenes[static_cast<std::size_t>(s) % std::size(kScenes)], static_cast<unsigned>(s));
        player.begin_anywhere();
        for (int frame = 0; frame < 100; ++frame) {
            player.act();
            ASSERT_EQ(differing(player), 0)
                << "session " << s << ", frame " << frame << " of " << player.scenario().grid.nx
                << ", by up to " << most_ << " between " << where_.left << ", " << where_.bottom << " and "
                << where_.right << ", " << where_.top;
        }
    }
    std::printf("%d sessions, %d frames, %d of them in parts; %.1f %% drawn anew\n", sessions, frames_,
                in_parts_, 100 * redrawn_ / frames_);
    EXPECT_GT(in_parts_, frames_ / 3);
}
INSTANTIATE_TEST_SUITE_P(With, RandomSessions, testing::Bool(), [](const auto& tight) {
    return tight.param ? "the_tightest_parts" : "parts_as_shipped";
});

}  // namespace
}  // namespace game::test
