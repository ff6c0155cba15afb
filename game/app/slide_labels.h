#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/analysis/slide_parts.h"
#include "game/session/sandbox.h"
#include "game/ui/facts.h"
#include "render/view/camera.h"

namespace game {

// Where the labels of a slide's parts, north and a scale are on the screen, of one open world. A view, which never affects
// the world. The parts are looked for every kStep ticks, and whenever the world is at another moment than its ticks led to.
class SlideLabels {
  public:
    static constexpr std::int64_t kStep = 6;  // ticks

    // What the labels depend on, beside the world.
    struct View {
        render::Camera camera;
        int width = 0, height = 0;  // px
        std::int64_t epoch = 0;     // as TimeControl::epoch()
        bool operator==(const View&) const = default;
    };
    // `seen`: where a place of the ground is on the screen, px, and nothing if it is hidden. `under`: the land under a
    // point of the image (Lookout), if there is any.
    void trace(const Sandbox& sandbox, const View& view,
               const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen,
               const std::function<std::optional<glm::dvec3>(glm::dvec2)>& under);

    std::span<const ui::SlideLabel> labels() const { return std::span(labels_).first(count_); }
    const std::optional<ui::Compass>& compass() const { return compass_; }

  private:
    void find_compass(const std::function<std::optional<glm::dvec3>(glm::dvec2)>& under);

    SlideParts parts_;
    std::optional<View> view_;
    std::int64_t changed_at_ = 0;  // tick, of the world in which the parts were found
    std::array<ui::SlideLabel, SlideParts::kParts> labels_;
    std::size_t count_ = 0;
    std::optional<ui::Compass> compass_;
};

}  // namespace game
