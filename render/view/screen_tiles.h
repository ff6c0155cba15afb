#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/base/rectangle.h"

namespace render {

// Marked tiles of a frame, and few rectangles around them. Drawing a rectangle costs something whatever its size, and
// each of its samples costs something too.
class ScreenTiles {
  public:
    // Begins with no marks. `width` and `height` in samples, `tile`: their number along the edge of one. Allocates
    // nothing while these are those of the last call.
    void begin(int width, int height, int tile);
    // Marks the tiles that a rectangle meets. It may reach beyond the frame.
    void mark(const Rectangle& samples);
    void mark_all();
    bool any() const { return !around_.empty(); }

    // Up to `most` disjoint rectangles that cover all marks: their bounding box, split again and again where that
    // leaves out most. A split that leaves out fewer than `least_gain` samples is not made. Valid until the next call.
    std::span<const Rectangle> rectangles(int most, int least_gain);

  private:
    struct Part {
        Rectangle box, first, second;  // tiles; the halves of its best split
        int gain = 0;                  // tiles that the split leaves out
    };
    void find_split(Part& part);
    void find_split(Part& part, bool upright);
    bool is_marked(int column, int row) const { return tiles_[index(column, row)] != 0; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    Rectangle tight(const Rectangle& box) const;

    int width_ = 0, height_ = 0, tile_ = 1;
    int columns_ = 0, rows_ = 0;
    Rectangle around_;  // all marks, tiles
    std::vector<std::uint8_t> tiles_;
    std::vector<Part> parts_;
    // Of a split: around each line, all before it, all from it on.
    std::vector<Rectangle> line_, before_, after_;
    std::vector<Rectangle> rectangles_;
};

}  // namespace render
