#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <glm/ext/vector_int2.hpp>

#include "game/compare/lettering.h"
#include "game/compare/relief.h"

namespace game {

// Vertices of a grid, both inclusive.
struct MapFrame {
    glm::ivec2 first, last;
};
// The part of a grid to show: where `shows(i)` holds for vertex i, row by row from the south, with a margin, and an aspect
// ratio from 1:2 to 2:1. All of it if it holds nowhere.
MapFrame frame_around(const sim::Grid& grid, const std::function<bool(std::size_t)>& shows);

// A sheet with a world's relief on the left and a text column
// beside it that is filled from the top: titles, legend, sentences.
class MapPage {
  public:
    // Shows all of the world, or a part of it.
    explicit MapPage(const Scenario& scenario);
    MapPage(const Scenario& scenario, const MapFrame& frame);

    render::Sheet& sheet() { return sheet_; }
    const Relief& relief() const { return relief_; }
    glm::vec2 pen() const { return pen_; }  // next position in the column, px
    static constexpr float kColumn = 340;   // px wide

    void title(const std::string& text);
    void say(const std::string& text);      // a paragraph with line breaks
    void whisper(const std::string& text);  // the same, smaller
    void skip(float px) { pen_.y += px; }
    // Adds a legend entry for a colour, a line or a ring on the map.
    void swatch(const glm::vec3& colour, const std::string& meaning);
    void stroke(float width, float dash, const glm::vec3& colour, const std::string& meaning);
    void ring(const glm::vec3& colour, const std::string& meaning);
    // Writes coordinates along the left and the lower edge of the map, where the world has any.
    void coordinates();
    // Draws a scale bar and a north arrow at the foot of the column.
    void scale_bar();

    void draw_ring(glm::vec2 at, float radius, const glm::vec3& colour);
    void draw_box(glm::vec2 from, glm::vec2 to, float thickness, const glm::vec3& colour);

  private:
    void write(const Lettering& letters, const std::string& text, const glm::vec3& colour);

    const Scenario& scenario_;
    Relief relief_;
    render::Sheet sheet_;
    Lettering large_, usual_, small_;
    glm::vec2 pen_;
};

}  // namespace game
