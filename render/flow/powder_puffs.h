#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/base/rectangle.h"
#include "render/flow/powder_tiles.h"
#include "render/view/frame_block.h"
#include "render/view/look.h"
#include "sim/powder/cloud.h"

namespace render {

// What a light coming from far away meets on its way: a map across its direction.
//
//        direction to the light
//              ▲    ●  ●        Puffs are met from the light on. Each gets what those before it leave, and
//              │  ●  ●          adds its own thickness to the cells under it.
//     ─────────┴──────────▶ across, up: cells of the map
class ShadeMap {
  public:
    static constexpr int kSide = 64;  // cells

    ShadeMap();  // reserves what it needs

    // Lays the map across `direction`, a unit vector, over all of `puffs`. Returns the light that reaches each,
    // 0 to 1, in their order; valid until the next call.
    std::span<const float> cast(std::span<const sim::powder::Puff> puffs, std::span<const float> opacity,
                                const glm::vec3& direction);

    // A place p is at (dot(across, p) + across.w, dot(up, p) + up.w) of the map, 0 to 1.
    glm::vec4 across() const { return across_; }
    glm::vec4 up() const { return up_; }
    // Per cell, row by row: thickness; the mean of dot(direction, p) of what makes it, times the thickness.
    std::span<const glm::vec2> cells() const { return cells_; }

  private:
    float thickness(glm::vec2 at) const;  // at: cells
    void add(glm::vec2 at, float reach, float thickness, float along);

    glm::vec4 across_{0}, up_{0};
    std::vector<glm::vec2> cells_;
    std::vector<std::pair<float, std::size_t>> order_;
    std::vector<float> light_;
};

// A puff as the GPU draws it. Vertex attributes of powder.vert.
struct DrawnPuff {
    glm::vec4 at;  // its middle; radius, m
    glm::vec4
        look;  // opacity; light from sun or moon and from the sky that other puffs leave, 0 to 1; turn, 0 to 1
    glm::vec4 life;  // age, s; age by life, 0 to 1; share of the lower material; 0
};

// What near puffs leave to see of those behind them: a map of the frame.
class VeilMap {
  public:
    VeilMap();  // reserves what it needs

    void clear();
    // The greatest share that an ellipse in the frame still shows, 0 to 1. `middle` and `half` axes: −1 to 1.
    float seen(glm::vec2 middle, glm::vec2 half) const;
    // Lays a puff over what is farther away.
    void lay(glm::vec2 middle, glm::vec2 half, float opacity);

  private:
    static constexpr int kAcross = 64, kUp = 36;  // cells
    struct Cells {
        int left, bottom, right, top;  // inclusive
    };
    static Cells cells_of(glm::vec2 low, glm::vec2 high);

    std::vector<float> share_;  // that each cell shows, row by row
};

// What is drawn of a cloud in one frame: the puffs in view, from far to near.
class PowderPuffs {
  public:
    PowderPuffs();  // reserves what it needs

    // `strength`: factor on the opacity. `width` and `height` of the frame, samples. `all`: also those that nearer ones
    // hide, which depends on what else is in the frame.
    void find(std::span<const sim::powder::Puff> puffs, const FrameBlock& frame, float strength, int width,
              int height, bool all = false);

    bool empty() const { return drawn_.empty(); }
    std::span<const DrawnPuff> drawn() const { return drawn_; }
    const ShadeMap& shade() const { return shade_; }
    float mean_radius() const { return mean_radius_; }  // m
    bool mixed() const { return mixed_; }               // a puff in view has some of the lower material
    // The part of the frame that the puffs in view and their shadows may cover, −1 to 1: left, bottom, right, top.
    glm::vec4 box() const { return box_; }
    // The same, closer: where nothing else needs drawing.
    std::span<const Rectangle> parts() const { return parts_; }
    // Area of all puffs in view, in areas of the frame.
    float covered() const { return covered_; }

  private:
    ShadeMap shade_, sky_shade_;
    std::vector<float> opacity_;
    // A puff in view, and where in the frame.
    struct InView {
        float behind;  // minus its distance, m
        std::size_t puff;
        glm::vec2 middle, half;
    };

    void find_in_view(std::span<const sim::powder::Puff> puffs, const FrameBlock& frame);
    void light_and_sort(std::span<const sim::powder::Puff> puffs, const glm::vec3& sun);
    void hide_behind_nearer();

    std::vector<InView> in_view_;  // from far to near
    VeilMap veil_;
    std::vector<DrawnPuff> drawn_;
    PowderTiles tiles_;
    std::span<const Rectangle> parts_;  // of tiles_
    glm::vec4 box_{0};
    float covered_ = 0, mean_radius_ = 1;
    bool mixed_ = false;
};

}  // namespace render
