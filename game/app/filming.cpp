#include "game/app/filming.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/analysis/gallery.h"
#include "game/analysis/headless.h"
#include "game/app/filmed_session.h"
#include "game/files/user_folders.h"
#include "game/recording/reader.h"

namespace game {
namespace {

constexpr double kLead = 1;  // s before the first command

// A name in a folder that no file has yet. It is free until the film is done, unless another program takes it.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& name,
                                const char* ending) {
    std::filesystem::path file = folder / (name + ending);
    std::error_code error;
    for (int i = 2; std::filesystem::exists(file, error); ++i)
        file = folder / fmt::format("{}-{}{}", name, i, ending);
    return file;
}

}  // namespace

Outcome<void> Filming::begin(Subject subject, const FilmWish& wish) {
    progress_ = 0;
    return job_.begin([this, subject = std::move(subject), wish](const std::atomic<bool>& stopped) {
        return film(subject, wish, stopped);
    });
}

std::optional<double> Filming::progress() const {
    if (!job_.is_busy()) return std::nullopt;
    return static_cast<double>(progress_);
}

Outcome<Filming::Made> Filming::film(const Subject& subject, const FilmWish& wish,
                                     const std::atomic<bool>& stopped) {
    const auto folder = data_folder("films");
    if (!folder) return tl::unexpected(folder.error());
    Made made{free_name(*folder, subject.name, ending_of(wish.kind)), 0, {}};
    std::istringstream text(subject.recording);
    auto recording = read_recording(text, subject.name);
    if (!recording) return tl::unexpected(recording.error());
    Scenario& scenario = recording->header.scenario;
    scenario.light = subject.light;
    scenario.look.date = subject.date;
    render::Camera camera = subject.camera;
    if (wish.view == FilmView::kFront) {
        const auto front = front_camera(scenario, recording->commands, Until::after(subject.last), {});
        if (!front) return tl::unexpected(front.error());
        camera = *front;
    }
    auto session = Session::begin(scenario, {}, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    session->follow_fronts(scenario);
    session->follow_powder(scenario);
    session->follow_carried(scenario);
    const auto lead = std::llround(kLead / static_cast<double>(scenario.params.tick_s));
    const std::int64_t begins = recording->commands.empty() ? 0 : recording->commands.front().tick - lead,
                       first =
                           std::clamp<std::int64_t>(begins, 0, std::max<std::int64_t>(subject.last - 1, 0));
    const auto is_stopped = [&]() -> Outcome<void> {
        return stopped ? Outcome<void>(machine_fails("it was stopped")) : Outcome<void>();
    };
    Watchers watchers;
    watchers.keep = [&](const Session& /*now*/) { return is_stopped(); };
    const auto play = [&](std::int64_t until) {
        return play_headless(*session, recording->commands, Until::after(until), watchers, "");
    };
    if (const auto before = play(first); !before) return tl::unexpected(before.error());

    auto gallery = Gallery::open(std::nullopt, {wish.width, wish.height}, "auto", scenario);
    if (!gallery) return tl::unexpected(gallery.error());
    auto film = FilmedSession::open(
        {.file = made.file, .fps = wish.fps, .view = wish.view, .silent = wish.silent, .path = subject.path},
        *session, subject.last - first, camera, *gallery);
    if (!film) return tl::unexpected(film.error());
    made.notice = film->notice();
    const auto length = static_cast<float>(subject.last - first);
    watchers.keep = [&](const Session& now) -> Outcome<void> {
        if (auto goes_on = is_stopped(); !goes_on) return goes_on;
        progress_ = static_cast<float>(now.state().tick - first) / length;
        const auto due = commands_of_tick(recording->commands, now.state().tick - 1);
        return film->see(now, due);
    };
    if (const auto ended = play(subject.last); !ended) return tl::unexpected(ended.error());
    if (auto closed = film->close(); !closed) return tl::unexpected(closed.error());
    made.seconds =
        static_cast<double>(subject.last - first) * static_cast<double>(session->state().params.tick_s);
    return made;
}

}  // namespace game
