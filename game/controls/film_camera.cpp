#include "game/controls/film_camera.h"

#include <array>
#include <utility>

namespace game {

std::optional<FilmView> film_view_from(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, FilmView>, 4> kViews{{{"scene", FilmView::kScene},
                                                                           {"chase", FilmView::kChase},
                                                                           {"front", FilmView::kFront},
                                                                           {"top", FilmView::kTop}}};
    for (const auto& [each, view] : kViews)
        if (each == name) return view;
    return std::nullopt;
}

FilmCamera::FilmCamera(FilmView view, const render::Camera& home, const sim::View& world,
                       const render::Surroundings& around)
    : view_(view), camera_(home), control_(home, world, around) {
    if (view != FilmView::kChase) return;
    control_.chase(true);
    camera_ = control_.camera();
}

void FilmCamera::move(const sim::View& world, const render::Surroundings& around, double aspect,
                      double elapsed_s) {
    if (view_ != FilmView::kChase) return;
    front_.see(world);
    CameraWish wish;
    wish.followed = front_.front();
    control_.move(wish, world, around, aspect, elapsed_s);
    camera_ = control_.camera();
}

}  // namespace game
