#include "game/controls/lookout.h"

#include <glm/geometric.hpp>

#include "game/scene/surface.h"

namespace game {

const render::Surroundings& Lookout::surroundings() const {
    static const render::Surroundings none;
    return display_.surroundings ? backdrop_.mountains : none;
}

double Lookout::aspect() const {
    const ScreenSize size = screen_.size();
    return static_cast<double>(size.width) / size.height;
}

void Lookout::move(const Input& input, const std::optional<SlideFront::Front>& followed,
                   const sim::View& world, double elapsed_s) {
    CameraWish wish;
    const auto cursor = input.cursor();
    if (input.camera_drag_began()) pivot_ = ground_under(input.drag_from(), world);
    if (const auto drag = input.camera_drag(); drag && cursor) {
        wish.drag = drag == Gesture::kTurn ? CameraWish::Drag::kTurn : CameraWish::Drag::kPan;
        wish.from = input.drag_from();
        wish.to = *cursor;
        wish.pivot = pivot_;
    }
    // About what is in the middle of the image, for as long as it goes on.
    const bool turns = input.turn() != glm::dvec2(0, 0) && wish.drag == CameraWish::Drag::kNone;
    if (turns) {
        if (!turns_) pivot_ = ground_under({0, 0}, world);
        wish.drag = CameraWish::Drag::kTurn;
        wish.to = input.turn();
        wish.pivot = pivot_;
    }
    turns_ = turns;
    if (input.zoom_steps() != 0 && cursor) {
        wish.zoom_steps = input.zoom_steps();
        if (!wish.pivot) wish.pivot = ground_under(*cursor, world);
    }
    wish.walk = {input.held(Held::kRight, Held::kLeft), input.held(Held::kForward, Held::kBack),
                 input.held(Held::kUp, Held::kDown)};
    wish.fast = input.fast();
    wish.followed = followed;
    control_->move(wish, world, surroundings(), aspect(), elapsed_s);

    ground_ = cursor ? ground_under(*cursor, world) : std::nullopt;
}

render::Ray Lookout::ray_under(glm::dvec2 point) const {
    return render::ray_through(camera(), aspect(), point);
}

std::optional<double> Lookout::mountain_along(render::Ray ray, const sim::View& world) const {
    ray.from.z -= world.datum;
    return surroundings().meet(ray.from, ray.along);
}

std::optional<glm::dvec3> Lookout::ground_under(glm::dvec2 point, const sim::View& world) const {
    const render::Ray ray = ray_under(point);
    const auto ground = render::pick(world, ray);
    if (!ground) return std::nullopt;
    const auto mountain = mountain_along(ray, world);
    return mountain && *mountain < glm::distance(ray.from, *ground) ? std::nullopt : ground;
}

std::optional<glm::dvec3> Lookout::land_under(glm::dvec2 point, const sim::View& world) const {
    if (const auto ground = ground_under(point, world)) return ground;
    const render::Ray ray = ray_under(point);
    const auto mountain = mountain_along(ray, world);
    if (!mountain) return std::nullopt;
    return ray.from + *mountain * ray.along;
}

bool Lookout::mountain_under(glm::dvec2 point, const sim::View& world) const {
    return mountain_along(ray_under(point), world).has_value();
}

std::optional<glm::dvec2> Lookout::on_screen(glm::dvec3 place) const {
    const ScreenSize size = screen_.size();
    const glm::dvec4 clip = render::projection_matrix(camera(), aspect()) *
                            (render::view_matrix(camera()) * glm::dvec4(place, 1));
    if (clip.w <= 0) return std::nullopt;
    return glm::dvec2((clip.x / clip.w + 1) / 2 * size.width, (1 - clip.y / clip.w) / 2 * size.height);
}

std::optional<glm::dvec2> Lookout::seen_on_screen(glm::dvec2 place, const sim::View& world) const {
    const glm::dvec3 at(place, surface_height(world, place));
    const auto on = on_screen(at);
    return on && !render::is_hidden(world, surroundings(), at, render::eye(camera())) ? on : std::nullopt;
}

}  // namespace game
