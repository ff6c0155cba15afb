#include "game/controls/film_camera.h"

#include <array>
#include <utility>

namespace game {

std::optional<FilmView> film_view_from(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, FilmView>, 5> kViews{{{"scene", FilmView::kScene},
                                                                           {"chase", FilmView::kChase},
                                                                           {"front", FilmView::kFront},
                                                                           {"top", FilmView::kTop},
                                                                           {"path", FilmView::kPath}}};
    for (const auto& [each, view] : kViews)
        if (each == name) return view;
    return std::nullopt;
}

FilmCamera::FilmCamera(FilmView view, const render::Camera& home, const sim::View& world,
                       const render::Surroundings& around, std::span<const CameraKey> path, double begins_s)
    : view_(view), camera_(home), control_(home, world, around) {
    if (view == FilmView::kPath) {
        path_.emplace(path);
        follow_path(world, around, begins_s);
    }
    if (view != FilmView::kChase) return;
    control_.chase(true);
    camera_ = control_.camera();
}

void FilmCamera::move(const sim::View& world, const render::Surroundings& around, double aspect,
                      const Time& time) {
    if (path_) return follow_path(world, around, time.world_s);
    if (view_ != FilmView::kChase) return;
    front_.see(world);
    CameraWish wish;
    wish.followed = front_.front();
    control_.move(wish, world, around, aspect, time.elapsed_s);
    camera_ = control_.camera();
}

void FilmCamera::follow_path(const sim::View& world, const render::Surroundings& around, double world_s) {
    camera_ = CameraRoom(world, around).inside(path_->at(world_s));
}

}  // namespace game
