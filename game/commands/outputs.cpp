#include "game/commands/outputs.h"

#include <utility>

#include <fmt/format.h>

#include "game/analysis/export_results.h"
#include "game/base/print.h"
#include "game/base/process.h"
#include "game/files/assets.h"
#include "game/files/film.h"
#include "game/files/text_file.h"
#include "render/mountain/overview.h"

namespace game {
namespace {

bool draws(const OutputOptions& options) {
    return options.pictures.folder || options.film.file;
}
bool shows_fronts(const OutputOptions& options) {
    return draws(options) || options.results.perf || options.results.trace;
}

}  // namespace

void Outputs::add_to(WorldUse& use, const OutputOptions& options) {
    use.draws = shows_fronts(options);
    use.page = options.web.file.has_value();
    if (draws(options)) use.frames = {options.pictures.size.width, options.pictures.size.height};
}

void Outputs::add_to(FileUse& use, const OutputOptions& options) {
    if (draws(options)) use.reads(drawing_assets());
    if (options.web.file) use.reads(page_assets());
    use.writes("--web", options.web.file);
    use.writes("--video", options.film.file);
    use.reads(options.film.path_file);
    add_outputs(options.results, use);
}

Outcome<Outputs> Outputs::begin(const OutputOptions& options, const Scenario& scenario, Session& session,
                                std::string proof) {
    Outputs outputs(options);
    if (draws(options) || options.web.file) session.follow_powder(scenario);
    if (draws(options)) session.follow_carried(scenario);
    if (!options.web.file) return outputs;
    auto page =
        SlidePage::begin(scenario, session, std::move(proof), page_options(options.web, options.pictures));
    if (!page) return tl::unexpected(page.error());
    outputs.page_ = std::move(*page);
    return outputs;
}

Outcome<void> Outputs::open(const Scenario& scenario) {
    if (auto placed = make_places_for(options_->results); !placed) return placed;
    if (options_->web.file)
        if (auto placed = make_place_for(*options_->web.file); !placed) return placed;
    const PictureOptions& pictures = options_->pictures;
    if (!draws(*options_)) return {};
    auto gallery = Gallery::open(pictures.folder, pictures.size, pictures.gl, scenario);
    if (!gallery) return tl::unexpected(gallery.error());
    gallery_ = std::move(*gallery);
    return {};
}

Outcome<void> Outputs::check(const OutputOptions& options) {
    const PictureSize& size = options.pictures.size;
    if (!options.film.file) return {};
    return Film::check(*options.film.file, {size.width, size.height, options.film.fps});
}

Outcome<void> Outputs::open_film(const Scenario& scenario, const Session& session,
                                 std::span<const TimedCommand> commands, const Until& until,
                                 const sim::StepOptions& step) {
    if (!options_->film.file) return {};
    FilmOptions options = options_->film;
    render::Camera camera = scenario.camera.value_or(render::overview(session.view()));
    if (options.view == FilmView::kPath) {
        auto path = path_of_film(options, scenario);
        if (!path) return tl::unexpected(path.error());
        options.path = std::move(*path);
    }
    if (options.view == FilmView::kFront) {
        const auto front = front_camera(scenario, commands, until, step);
        if (!front) return tl::unexpected(front.error());
        camera = *front;
    }
    auto film = FilmedSession::open(options, session, until.tick, camera, *gallery_);
    if (!film) return tl::unexpected(film.error());
    film_.emplace(std::move(*film));
    filmed_ = commands;
    note_interrupts();  // so that Ctrl+C leaves no part of the film
    if (!film_->notice().empty()) print_line(stderr, "couloir: {}", film_->notice());
    return {};
}

Watchers Outputs::watch(const Scenario& scenario, Session& session, PerfSurroundings surroundings) {
    if (shows_fronts(*options_)) {
        session.follow_fronts(scenario);
        if (scenario.look.flow && !session.fronts()) print_line(stderr, "couloir: {}", Session::kTooFine);
    }
    if (gallery_ && !gallery_->notice().empty()) print_line(stderr, "couloir: {}", gallery_->notice());
    if (gallery_) surroundings.drawn = gallery_->drawn_by();
    perf_.emplace(surroundings, options_->results.log_keeps());
    Watchers watchers;
    watchers.gallery = options_->pictures.folder ? &*gallery_ : nullptr;
    watchers.ticks_per_picture = options_->pictures.every.value_or(kTicksPerPicture);
    watchers.perf = &*perf_;
    if (page_ || film_)
        watchers.keep = [this](const Session& now) -> Outcome<void> {
            if (page_)
                if (auto kept = page_->see(now); !kept) return kept;
            if (film_ && interrupted())
                return machine_fails(
                    fmt::format("{}: stopped; nothing of the film is kept", options_->film.file->string()));
            return film_ ? film_->see(now, commands_of_tick(filmed_, now.state().tick - 1)) : Outcome<void>();
        };
    return watchers;
}

void Outputs::draw_results(const Session& session) {
    if (options_->pictures.folder) game::draw_results(*gallery_, session);
}

Outcome<void> Outputs::close(const Session& session, std::span<const TimedCommand> commands) {
    if (film_)
        if (auto closed = film_->close(); !closed) return closed;
    if (gallery_)
        if (auto closed = gallery_->close(); !closed) return closed;
    if (page_)
        if (auto written = page_->write(*options_->web.file, session, commands); !written)
            return tl::unexpected(written.error());
    return {};
}

}  // namespace game
