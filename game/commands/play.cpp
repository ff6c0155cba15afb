#include <fmt/format.h>

#include "game/app/app.h"
#include "game/app/guide_memory.h"
#include "game/app/window.h"
#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/commands/runs_of_ensemble.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/ui_font.h"
#include "game/recording/reader.h"
#include "game/scene/week.h"

namespace game {
namespace {

// Prints the frame rate and the time per stage in the last second, as in the performance panel.
void tell_times(const FrameTimes& times, const ImageSize& image) {
    if (times.frames_per_second() == 0) return;  // too few to measure
    std::string text = fmt::format(
        "{:.1f} frames/s at the end, the last image {}x{} with {} per pixel; median ms per frame:",
        times.frames_per_second(), image.width, image.height, image.fine ? "four samples" : "one sample");
    for (std::size_t i = 0; i < kStages; ++i)
        text += fmt::format(" {} {:.2f}", kStageNames[i], times.median_ms(static_cast<Stage>(i)));
    print_line(stdout, "{}, worst tick {:.2f}", text, times.worst_tick_ms());
}

// Says where a session is that ends because the window cannot draw.
std::string with_recording(const std::string& sentence, const App& app, const PlayOptions& options) {
    if (!app.recording()) return sentence;
    return fmt::format("{}; the session is kept, to continue it: {} play {}", sentence, options.program,
                       app.recording()->string());
}

// Of the window, as it was left.
PictureSize size_of(const Settings& kept) {
    if (kept.width == 0 || kept.height == 0) return {};
    return {kept.width, kept.height};
}

// Until the world is ready, which takes a second.
void show_title(Window& window) {
    ui::Ui ui(ui_font());
    ui.begin({}, window, 1, 0);
    ui.build_title();
    ui.draw();
    window.present();
}

}  // namespace

Outcome<int> play(const PlayOptions& options) {
    SettingsFile settings = options.safe ? SettingsFile() : SettingsFile::of_user();
    const PictureSize size = options.size.value_or(size_of(settings.begun()));
    // Checked before the window opens, so that a mistake on the command line does not flash one.
    Overrides overrides = options.overrides;
    overrides.week = this_week();
    overrides.memory.use = {.draws = true, .frames = {size.width, size.height}, .goes_back = true};
    if (options.lesson && (!options.what.empty() || options.until))
        return unusable("--lesson goes with neither a scene nor --until: a lesson has its own recording");
    std::optional<Remembered> led;
    if (options.what.empty() && !options.lesson) led = remembered_guide();
    const bool watches = led && led->guide.step() == Guide::Step::kWatch && !options.record;
    std::optional<Runs> runs;
    if (options.ensemble && options.what.empty())
        return unusable("--ensemble needs the file of the ensemble: couloir play SPEC.toml --ensemble DIR");
    if (options.ensemble) {
        auto read = runs_of_ensemble(options.what, *options.ensemble, overrides);
        if (!read) return tl::unexpected(read.error());
        runs = std::move(*read);
    }
    auto loaded = runs             ? Outcome<LoadedWorld>(runs->world)
                  : options.lesson ? open_lesson(*options.lesson, overrides)
                                   : open_anything(!options.what.empty() ? options.what
                                                   : watches             ? Guide::kSlide
                                                                         : Guide::kMountain,
                                                   overrides);
    if (!loaded) return tl::unexpected(loaded.error());
    FileUse use;
    if (auto sound =
            use.reads(loaded->scene.files).reads(drawing_assets()).writes("--record", options.record).check();
        !sound)
        return tl::unexpected(sound.error());
    if (options.until && !loaded->watched)
        return unusable(
            fmt::format("{}: is no recording, so --until {} cannot be used", options.what, *options.until));
    if (options.until && loaded->scene.scenario.flow)
        return unusable(
            fmt::format("{}: shows a flow, which has no commands, so --until cannot be used", options.what));
    if (options.until)
        if (auto has = check_tick(*loaded->watched, *options.until, options.what); !has)
            return tl::unexpected(has.error());
    auto window = Window::open("Couloir", size.width, size.height);
    if (!window) return tl::unexpected(window.error());
    if (settings.begun().fullscreen && !options.size) (*window)->set_fullscreen(true);
    show_title(**window);
    auto app = App::begin(**window, std::move(*loaded), options.step_options, options.record, options.tier,
                          led, std::move(settings), options.safe ? Languages() : Languages::of_user());
    if (!app) return tl::unexpected(app.error());
    if (runs) (*app)->show_runs(std::move(*runs));
    if (led && !watches && !options.record) (*app)->begin_menu();
    if (options.until) (*app)->take_over_at(*options.until);
    while ((*app)->frame()) {
    }
    if (auto finished = (*app)->finish(); !finished) return tl::unexpected(finished.error());
    tell_times((*app)->times(), (*app)->image().size());
    if (const auto& failure = (*app)->image().failure())
        return tl::unexpected(Failure{failure->status, with_recording(failure->sentence, **app, options)});
    if (const auto& failure = (*app)->recording_failure()) return tl::unexpected(*failure);
    if (const auto& recording = (*app)->recording())
        print_line(stdout, "{:.1f} s played. To watch and continue it: {} play {}",
                   (*app)->sandbox().session().seconds(), options.program, recording->string());
    return 0;
}

}  // namespace game
