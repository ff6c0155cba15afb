#pragma once

#include <functional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/scene/scenario.h"
#include "render/pictures/sheet.h"

namespace game {

// A grey shaded relief of part of a world's initial surface, from above, with contours and north at the top,
// without GL. It is the background of maps. A vertex's cell extends half a cell beyond it.
class Relief {
  public:
    // Vertices first to last, inclusive and possibly fractional, in a rectangle of a sheet whose top left
    // corner is `corner`, `pixels_per_cell` > 0.
    Relief(const Scenario& scenario, glm::vec2 first, glm::vec2 last, glm::vec2 corner,
           float pixels_per_cell);

    glm::vec2 corner() const { return corner_; }  // top left, on the sheet
    glm::vec2 size() const;                       // px
    glm::vec2 place(glm::vec2 cells) const;       // of a vertex, on the sheet
    glm::vec2 cells(glm::vec2 place) const;       // inverse of place()
    bool covers(glm::vec2 place) const;           // a place on the sheet
    float pixels_per_cell() const { return scale_; }

    // `tint(cells)` colours the ground: sRGB 0 to 255 and an opacity, 0 to 1. The relief shades it too.
    struct Tint {
        glm::vec3 colour{0};
        float share = 0;
    };
    void draw(render::Sheet& sheet, const std::function<Tint(glm::vec2)>& tint) const;

    // Draws the outline of where a field is at least `level`, `width` px wide; dashed if `dash` > 0, px.
    void outline(render::Sheet& sheet, std::span<const float> field, float level, float width, float dash,
                 const glm::vec3& colour) const;

  private:
    struct Ground {
        float height;    // m above datum
        glm::vec2 fall;  // gradient to the east and to the north
    };
    Ground ground(glm::vec2 cells) const;
    bool has_ground(glm::vec2 cells) const;

    const Scenario& scenario_;
    glm::vec2 first_, last_, corner_;
    float scale_;
    float contours_;  // contour interval, m
};

// Interpolates a field bilinearly between vertices; beyond the border, the border's value.
float between(const sim::Grid& grid, std::span<const float> field, glm::vec2 cells);

}  // namespace game
