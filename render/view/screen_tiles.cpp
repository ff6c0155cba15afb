#include "render/view/screen_tiles.h"

#include <cstring>

#include "sim/core/check.h"

namespace render {
namespace {

int tiles_of(const Rectangle& box) {
    return box.empty() ? 0 : box.width() * box.height();
}

}  // namespace

void ScreenTiles::begin(int width, int height, int tile) {
    CHECK(width > 0 && height > 0 && tile > 0);
    if (width != width_ || height != height_ || tile != tile_) {
        width_ = width;
        height_ = height;
        tile_ = tile;
        columns_ = (width + tile - 1) / tile;
        rows_ = (height + tile - 1) / tile;
        tiles_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
        const auto lines = static_cast<std::size_t>(std::max(columns_, rows_)) + 1;
        for (std::vector<Rectangle>* lists : {&line_, &before_, &after_}) lists->resize(lines);
    } else if (!around_.empty()) {
        for (int row = around_.bottom; row < around_.top; ++row)
            std::memset(&tiles_[index(around_.left, row)], 0, static_cast<std::size_t>(around_.width()));
    }
    around_ = {};
}

void ScreenTiles::mark(const Rectangle& samples) {
    const Rectangle inside = common_part(samples, {0, 0, width_, height_});
    if (inside.empty()) return;
    const Rectangle tiles{inside.left / tile_, inside.bottom / tile_, (inside.right - 1) / tile_ + 1,
                          (inside.top - 1) / tile_ + 1};
    for (int row = tiles.bottom; row < tiles.top; ++row)
        std::memset(&tiles_[index(tiles.left, row)], 1, static_cast<std::size_t>(tiles.width()));
    around_ = around_both(around_, tiles);
}

void ScreenTiles::mark_all() {
    mark({0, 0, width_, height_});
}

std::span<const Rectangle> ScreenTiles::rectangles(int most, int least_gain) {
    rectangles_.clear();
    if (!any()) return rectangles_;
    parts_.clear();
    parts_.push_back({around_, {}, {}, 0});
    find_split(parts_.front());
    while (static_cast<int>(parts_.size()) < most) {
        const auto best = std::max_element(parts_.begin(), parts_.end(),
                                           [](const Part& a, const Part& b) { return a.gain < b.gain; });
        if (best->gain == 0 || best->gain * tile_ * tile_ < least_gain) break;
        Part second{best->second, {}, {}, 0};
        *best = {best->first, {}, {}, 0};
        find_split(*best);
        find_split(second);
        parts_.push_back(second);
    }
    for (const Part& part : parts_)
        rectangles_.push_back({part.box.left * tile_, part.box.bottom * tile_,
                               std::min(part.box.right * tile_, width_),
                               std::min(part.box.top * tile_, height_)});
    return rectangles_;
}

void ScreenTiles::find_split(Part& part) {
    find_split(part, false);
    find_split(part, true);
}

// Splits a part by a line across x (`upright`) or y, if that leaves out more than its best split so far.
void ScreenTiles::find_split(Part& part, bool upright) {
    const Rectangle& box = part.box;
    const int lines = upright ? box.width() : box.height();
    for (int i = 0; i < lines; ++i) {
        Rectangle line = box;
        (upright ? line.left : line.bottom) += i;
        (upright ? line.right : line.top) = (upright ? line.left : line.bottom) + 1;
        line_[static_cast<std::size_t>(i)] = tight(line);
    }
    before_[0] = {};
    for (int i = 0; i < lines; ++i) {
        const auto at = static_cast<std::size_t>(i);
        before_[at + 1] = around_both(before_[at], line_[at]);
    }
    after_[static_cast<std::size_t>(lines)] = {};
    for (int i = lines; i-- > 0;) {
        const auto at = static_cast<std::size_t>(i);
        after_[at] = around_both(after_[at + 1], line_[at]);
    }
    for (int i = 1; i < lines; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const int gain = tiles_of(box) - tiles_of(before_[at]) - tiles_of(after_[at]);
        if (gain > part.gain) part = {box, before_[at], after_[at], gain};
    }
}

// The smallest box around the marks in `box`.
Rectangle ScreenTiles::tight(const Rectangle& box) const {
    Rectangle around;
    for (int row = box.bottom; row < box.top; ++row)
        for (int column = box.left; column < box.right; ++column)
            if (is_marked(column, row)) {
                int last = box.right - 1;
                while (!is_marked(last, row)) --last;
                around = around_both(around, {column, row, last + 1, row + 1});
                break;
            }
    return around;
}

}  // namespace render
