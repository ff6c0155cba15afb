#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/base/rectangle.h"
#include "render/frame/frame_input.h"
#include "render/view/on_screen.h"
#include "render/view/screen_tiles.h"

namespace render {

// Divides a frame into parts where a slide may be seen, moving or at rest, those of them where a slab may have
// left a wall, parts where earth was sculpted or soil is wet, and parts where nothing of it can be. Ground without slides is much
// cheaper to shade.
class SlideTiles {
  public:
    // Allocates nothing while size and grid are those of the last call. Not `by_kind`: every part is as one with a wall.
    void find(const FrameInput& input, const OnScreen& screen, bool by_kind = true);

    // Marks the tiles that are of another kind than in the last frame.
    void mark_changes(ScreenTiles& tiles) const;

    // Together they cover the frame, each sample once. `with_slides`: without a wall; `with_earth`: with earth or wet
    // soil, with or without slides and walls.
    std::span<const Rectangle> with_earth() const { return with_earth_; }
    std::span<const Rectangle> with_walls() const { return with_walls_; }
    std::span<const Rectangle> with_slides() const { return with_slides_; }
    std::span<const Rectangle> without() const { return without_; }

  private:
    bool find_blocks(const FrameInput& input);
    bool find_earth(const FrameInput& input);
    void mark(int x, int y, int reach, std::uint8_t kind);
    void project(const sim::View& world, int x, int y, const OnScreen& screen);
    void resize(const sim::Grid& grid, int width, int height);
    void collect();

    sim::Grid grid_;
    int width_ = 0, height_ = 0;                   // samples
    int columns_ = 0, rows_ = 0;                   // tiles of the frame
    int blocks_along_x_ = 0, blocks_along_y_ = 0;  // of the grid
    std::vector<std::uint8_t> blocks_, tiles_;  // 0: nothing, 1: a slide, 2: and a wall, 3: earth or wet soil
    std::vector<std::uint8_t> before_;          // tiles of the last frame
    std::vector<Rectangle> with_earth_, with_walls_, with_slides_, without_;
};

}  // namespace render
