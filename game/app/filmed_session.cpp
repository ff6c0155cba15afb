#include "game/app/filmed_session.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "files/destination.h"
#include "game/analysis/measures.h"
#include "game/controls/front_view.h"
#include "game/scene/camera_keys.h"

namespace game {
namespace {

double aspect_of(PictureSize size) {
    return static_cast<double>(size.width) / size.height;
}

// How many images a film has of so many ticks.
std::int64_t images_until(std::int64_t ticks, const Session& session, int fps) {
    const double seconds = static_cast<double>(ticks) * static_cast<double>(session.state().params.tick_s);
    constexpr double kRounding = 1e-4;  // of an image: the length of a tick is a float
    return static_cast<std::int64_t>(std::floor(seconds * fps + kRounding));
}

}  // namespace

Outcome<std::vector<CameraKey>> path_of_film(const FilmOptions& options, const Scenario& scenario) {
    if (options.path_file) return load_camera_path(*options.path_file);
    if (scenario.camera_path.empty())
        return unusable(
            "--camera path: the scene has no camera path; give the file of one with --camera-path FILE.toml");
    return scenario.camera_path;
}

Outcome<render::Camera> front_camera(const Scenario& scenario, std::span<const TimedCommand> commands,
                                     const Until& until, const sim::StepOptions& options) {
    auto session = Session::begin(scenario, options, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    if (auto played = play_headless(*session, commands, until, {}, "finding the run-out"); !played)
        return tl::unexpected(played.error());
    const Measures measures = measure(scenario, *session, release_area(scenario, commands), {});
    if (measures.run_out <= 0)
        return unusable("--camera front: nothing flows until then; use another camera, or a later end");
    return view_from_front(session->view(), {measures.top.x, measures.top.y},
                           {measures.toe.x, measures.toe.y});
}

FilmedSession::FilmedSession(const FilmOptions& options, Film film, const Session& session,
                             std::optional<std::int64_t> ticks, const render::Camera& home, Gallery& gallery)
    : gallery_(&gallery),
      film_(std::move(film)),
      camera_(options.view, home, session.view(), gallery.surroundings(), options.path, session.seconds()),
      fps_(options.fps),
      begins_s_(session.seconds()),
      first_(session.state().tick),
      ticks_(ticks) {}

Outcome<FilmedSession> FilmedSession::open(const FilmOptions& options, const Session& session,
                                           std::optional<std::int64_t> ticks, const render::Camera& home,
                                           Gallery& gallery) {
    const std::filesystem::path& path = *options.file;
    if (ticks && *ticks < 1)
        return unusable(fmt::format("{}: no time passes, so there is nothing to film", path.string()));
    auto film = Film::open(path, {gallery.size().width, gallery.size().height, options.fps});
    if (!film) return tl::unexpected(film.error());
    const render::Camera camera =
        options.view == FilmView::kTop ? map_camera(session.view(), aspect_of(gallery.size())) : home;
    FilmedSession filmed(options, std::move(*film), session, ticks, camera, gallery);
    if (options.silent) return filmed;
    if (auto opened = filmed.open_sound(path, session); !opened) return tl::unexpected(opened.error());
    return filmed;
}

// The film is made without one if this machine has no sound.
Outcome<void> FilmedSession::open_sound(const std::filesystem::path& path, const Session& session) {
    auto wav = PartFile::beside(files::destination_of(path).path);
    if (!wav) return tl::unexpected(wav.error());
    try {
        auto sound = sound::SoundFile::open(wav->path(), session, ticks_, camera_.camera());
        if (sound)
            wav_.emplace(std::move(*wav)), sound_.emplace(std::move(*sound));
        else
            notice_ = "the film has no sound: " + sound.error().sentence;
    } catch (const std::exception& thrown) {  // the module for sound is missing
        notice_ = fmt::format("the film has no sound: {}", thrown.what());
    }
    return {};
}

Outcome<void> FilmedSession::see(const Session& session, std::span<const sim::Command> commands) {
    const std::int64_t passed = session.state().tick - first_;
    std::int64_t due = images_until(passed, session, fps_);
    if (passed == ticks_) due = std::max<std::int64_t>(due, 1);
    while (film_.frames() < due) {
        const double ends_s = static_cast<double>(film_.frames() + 1) / fps_;
        camera_.move(session.view(), gallery_->surroundings(), aspect_of(gallery_->size()),
                     {.elapsed_s = 1. / fps_, .world_s = begins_s_ + ends_s});
        if (auto added = film_.add(gallery_->image(session, camera_.camera())); !added) return added;
    }
    if (!sound_) return {};
    sound_->hear_at(camera_.camera());
    return sound_->see(session, commands);
}

Outcome<void> FilmedSession::close() {
    if (!sound_) return film_.close();
    if (auto closed = sound_->close(); !closed) return closed;
    return film_.close(wav_->path());
}

}  // namespace game
