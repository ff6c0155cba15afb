#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/frame/marks.h"
#include "render/mountain/sun_sweep.h"
#include "render/view/frame_block.h"
#include "render/view/on_screen.h"
#include "render/view/screen_tiles.h"
#include "sim/world/state.h"

namespace render {

// How closely a frame is redrawn. A program has no reason to change it: tests draw with tighter and with wrong rules.
struct RedrawRules {
    int tile = 8;              // samples along the edge of the tiles that are marked
    int most_rectangles = 16;  // that are drawn
    int least_gain = 400;      // samples that a further rectangle must leave out
    int block = 2;             // squares of the grid along the edge of the boxes that are marked
    // Vertices from one that changed to the last square where that can be seen. Slopes reach one vertex, splines
    // through what depends on slopes two more, and a crown looks another one aside.
    int reach = 4;
    // Pixels from one that changed to the last one whose edges it changes, as in edges.frag.
    int edge_reach = 18;
    // What a wrong rule leaves out: shadows that move; where ground was before; what stands on ground that changed,
    // as trees, structures and the seam of the surroundings; where powder and spindrift were; one rectangle.
    bool sun = true, old_heights = true, things = true, air = true, last_rectangle = true;
    bool parts_by_kind = true;  // else ground is shaded everywhere as where a slide has left a wall
};

// Where bedrock differs from that of the last frame.
struct ChangedGround {
    std::span<const glm::ivec2> vertices;
    int reach = 0;  // vertices from one of them to the last whose openness may differ
};

// Finds what changed in a world since the last frame, and the squares of the grid that look different for it.
//
//     fields, flow ──▶ vertices ──▶ squares within reach ──▶ boxes of them, with old and new heights ──▶ tiles
//     sun ceilings, ring ───────────▶
class WhatChanged {
  public:
    // Compares the fields with those of the last call, bit by bit, and begins with the squares that they change.
    // `mixture`: two bytes per vertex, as drawn; empty in a world of one material. `walls_to`: the sides of the grid
    // are seen, down to this height, m. `everything`: as if all differed. `water`: vertices
    // where the overlay of water has changed. Allocates nothing while grid and bedrock stay.
    void compare(const sim::View& world, std::span<const std::uint8_t> mixture,
                 std::span<const float> undisturbed, std::optional<float> walls_to, const RedrawRules& rules,
                 bool everything, const ChangedGround& ground = {}, std::span<const glm::ivec2> water = {});
    // Adds what changed besides: vertices of a flow, shadows, a ring or an outline that is drawn elsewhere than in
    // the last frame.
    // `shown`, `shown_before`: per square, not 0 if the flow is seen there.
    void add_flow(std::span<const int> vertices, std::span<const std::uint8_t> shown,
                  std::span<const std::uint8_t> shown_before);
    void add_shadows(const SunSweep& sweep, const FrameBlock& frame);
    void add_ring(const std::optional<Ring>& before, const std::optional<Ring>& now, const FrameBlock& frame);
    void add_outline(const std::optional<Outline>& before, const std::optional<Outline>& now,
                     const FrameBlock& frame);
    // Vertices of an extent whose outline is drawn.
    void add_extent(std::span<const glm::ivec2> vertices);

    // Rows of vertices between which all fields that changed are; none if first > last.
    int first_row() const { return first_row_; }
    int last_row() const { return last_row_; }
    // Groups of GROUP_SQUARE² vertices whose slopes or layers may have changed: x + 65536 y.
    std::span<const std::int32_t> groups() const { return groups_; }

    // Whether a vertex changed within a part of the ground, m, or beside it, or a shadow on what stands there.
    bool is_near(glm::vec2 low, glm::vec2 high) const;
    // The least and the greatest height of the surface there, m, now or in the last frame.
    glm::vec2 heights_in(glm::vec2 low, glm::vec2 high) const;
    // The same between two vertices, inclusive.
    glm::vec2 heights_between(glm::ivec2 first, glm::ivec2 last) const;

    // Marks the samples where squares look different.
    void mark(const OnScreen& screen, ScreenTiles& tiles) const;
    // The vertices where the surface rose or sank.
    std::span<const glm::ivec2> moved() const { return moved_; }
    const sim::Grid& grid() const { return grid_; }
    // Call at the end of a frame: now becomes before.
    void finish();

  private:
    static constexpr std::size_t kFields = 4;

    void resize(const sim::View& world);
    void compare_row(const sim::View& world, int y, bool everything);
    void compare_ground(const sim::View& world, const ChangedGround& ground);
    void compare_mixture(std::span<const std::uint8_t> mixture);
    void change(int x, int y);
    void open_around(int x, int y, int reach) {
        open_squares(x - reach, x + reach - 1, y - reach, y + reach - 1);
    }
    void open_squares(int x0, int x1, int y0, int y1);
    void collect_groups();
    bool is_untouched(int x, int y, float depth) const;
    bool is_untouched_near(int x, int y) const;
    double longest_pixel(glm::ivec2 first, glm::ivec2 last, const FrameBlock& frame) const;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.nx) + static_cast<std::size_t>(x);
    }

    RedrawRules rules_;
    sim::Grid grid_;
    bool everything_ = true;
    std::array<std::vector<float>, kFields> field_;  // as drawn: depth, rolling, velocities
    std::vector<std::uint8_t> mixture_;
    std::vector<float> height_, height_before_;  // of the surface
    std::vector<glm::ivec2> moved_;              // vertices with another height
    std::vector<std::uint8_t> near_;             // per vertex: is_near
    std::vector<std::uint8_t> squares_;          // per vertex: the square to its upper right looks different
    std::vector<std::uint8_t> group_;
    std::vector<std::int32_t> groups_;
    std::vector<std::uint8_t> walled_;  // per vertex: a wall stands there, if walls are seen
    std::optional<float> walls_to_;
    std::span<const float> undisturbed_;
    int far_reach_ = 0;  // of a world of two materials, where nothing has slid
    int first_row_ = 0, last_row_ = -1;
    int left_ = 0, right_ = -1, bottom_ = 0, top_ = -1;  // squares that are marked lie between
};

}  // namespace render
