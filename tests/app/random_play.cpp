// A restless user: random keys, strokes, clicks and sizes of the window, in every scene that ships. Whatever that does, the
// program goes on, no mass is lost, and each recording that is left replays bit for bit by every kernel.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/app/app.h"
#include "game/controls/key_map.h"
#include "tests/app/gl_screen.h"
#include "tests/replay/all_kernels.h"
#include "tests/replay/environment.h"
#include "tests/support/places.h"

namespace game {
namespace {

constexpr int kSquares = 48, kSteps = 70;  // of a scene's longer side; things done in a world

class Restless {
  public:
    Restless(std::uint64_t seed, const std::filesystem::path& folder) : random_(seed), folder_(folder) {}

    // Plays one scene, or what it comes to from there. Returns what went wrong.
    std::optional<std::string> play(const std::string& scene) {
        Overrides coarse;
        coarse.squares = kSquares;
        auto loaded = open_anything(scene, coarse);
        if (!loaded) loaded = open_anything(scene, {});  // its houses need finer cells
        if (!loaded) return loaded.error().sentence;
        auto begun = App::begin(screen_, std::move(*loaded), {.threads = one_of({1, 2, 3})}, std::nullopt,
                                Tier::kFast);
        if (!begun) return begun.error().sentence;
        app_ = std::move(*begun);
        goes_on_ = true;
        for (int i = 0; i < kSteps && goes_on_; ++i) {
            act();
            if (const sim::Ledger& mass = app_->sandbox().session().state().ledger; mass.mass_error() != 0)
                return scene + ": " + done_ + "lost mass";
        }
        if (const auto& failure = app_->image().failure()) return scene + ": " + done_ + failure->sentence;
        if (const auto& failure = app_->recording_failure()) return scene + ": " + done_ + failure->sentence;
        if (const auto finished = app_->finish(); !finished)
            return scene + ": " + done_ + finished.error().sentence;
        app_.reset();
        return std::nullopt;
    }

    std::int64_t frames() const { return frames_; }

  private:
    int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    template <class Value>
    Value one_of(std::initializer_list<Value> values) {
        return *(values.begin() + below(static_cast<int>(values.size())));
    }

    void frames(int count) {
        for (int i = 0; i < count && goes_on_; ++i) goes_on_ = app_->frame(), ++frames_;
    }
    void move() { screen_.move(below(screen_.size().width + 1), below(screen_.size().height + 1)); }
    Modifiers modifiers() { return {one_in(5), one_in(5), one_in(20)}; }

    // Something that a person might do, and a few frames.
    void act() {
        if (screen_.size().width == 0) screen_.resize_to(480, 270);
        switch (below(12)) {
            case 0:
            case 1:
            case 2:
                return drag(Button::kLeft);
            case 3:
                return drag(one_of({Button::kRight, Button::kMiddle}));
            case 4:
            case 5:
            case 6:
                return press_key();
            case 7:
                return choose_tool();
            case 8:
                return wait();
            case 9:
                move();
                screen_.happen({WheelEvent{one_of({-2.0, -1.0, 1.0, 3.0}), modifiers()}});
                return frames(2);
            case 10:
                return resize();
            default:
                return drop();
        }
    }

    void drag(Button button) {
        done_ += "drag ";
        move();
        frames(1);
        const Modifiers with = modifiers();
        screen_.press(button, with);
        for (int steps = below(4); steps >= 0; --steps) {
            frames(1 + below(4));
            if (!one_in(3)) move();
        }
        if (one_in(12)) screen_.happen({FocusEvent{false}});
        screen_.release(button, with);
        frames(1);
    }

    void press_key() {
        const KeyMap map;
        const auto bindings = map.presses();
        const KeyBinding& binding =
            bindings[static_cast<std::size_t>(below(static_cast<int>(bindings.size())))];
        const Verb* const verb = std::get_if<Verb>(&binding.does);
        if (verb && *verb == Verb::kQuit && !one_in(10)) return;
        if (verb && *verb == Verb::kShare && !one_in(10)) return;  // takes as long as all else
        done_ += name_of({}, binding.key, binding.with) + " ";
        screen_.tap(binding.key, binding.with);
        frames(1 + below(10));
    }

    void choose_tool() {
        const ToolInfo& info = tool_infos()[static_cast<std::size_t>(below(kTools))];
        done_ += name_of({}, info.key) + " ";
        screen_.tap(info.key);
        frames(1);
        drag(Button::kLeft);
    }

    void wait() {
        done_ += "wait ";
        if (one_in(2)) screen_.tap(Key::kEqual), screen_.tap(Key::kEqual), screen_.tap(Key::kEqual);
        frames(5 + below(60));
    }

    void resize() {
        if (!one_in(3)) return screen_.type(one_of({"12", "-3.5", "abc", "1e9"}));
        done_ += "resize ";
        const int width = one_of({0, 200, 320, 480, 640});
        screen_.resize_to(width, width * 9 / 16);
        frames(3);
    }

    // One of the recordings that were made before, or another scene.
    void drop() {
        if (!one_in(4)) return wait();
        done_ += "drop ";
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
            if (entry.path().extension() == ".couloir") files.push_back(entry.path());
        std::ranges::sort(files);
        if (files.empty()) return;
        screen_.drop({files[static_cast<std::size_t>(below(static_cast<int>(files.size())))]});
        frames(20);
    }

    std::mt19937_64 random_;
    std::filesystem::path folder_;
    app_test::GlScreen screen_{480, 270};
    std::unique_ptr<App> app_;
    bool goes_on_ = true;
    std::string done_;
    std::int64_t frames_ = 0;
};

// COULOIR_PLAYS=N plays N worlds, COULOIR_SEED=S starts with seed S.
TEST(RandomPlay, loses_nothing_in_any_scene_and_leaves_recordings_that_replay_by_every_kernel) {
    std::vector<std::string> scenes;
    const Catalogue catalogue = read_catalogue().value();
    for (const Catalogue::Entry& entry : catalogue.scenes) scenes.push_back(entry.name);
    const std::uint64_t plays = test::number_of("COULOIR_PLAYS", 2),
                        first = test::number_of("COULOIR_SEED", 1);
    test::Replays replays;
    std::int64_t frames = 0;
    for (std::uint64_t seed = first; seed < first + plays; ++seed) {
        const support::TemporaryFolder folder;
        setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
        setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
        Restless restless(seed, folder.path());
        const std::string& scene = scenes[seed * 7 % scenes.size()];
        for (int again = 0; again < 2; ++again)
            if (const auto fault = restless.play(scene)) ADD_FAILURE() << "seed " << seed << ", " << *fault;
        frames += restless.frames();
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
            if (entry.path().extension() == ".couloir")
                if (const auto fault = test::fault_of_recording(entry.path(), replays))
                    ADD_FAILURE() << "seed " << seed << ", " << scene << ": " << *fault;
    }
    std::printf("%lld worlds, %lld frames, %lld replays of %lld states\n", static_cast<long long>(2 * plays),
                static_cast<long long>(frames), static_cast<long long>(replays.count),
                static_cast<long long>(replays.states));
    EXPECT_GT(replays.count, 0);
}

}  // namespace
}  // namespace game
