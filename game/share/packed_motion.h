#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/share/packed_stream.h"

namespace game {

// A field in time: for each frame the tiles that changed, as differences of whole quanta from the frame before. Sums of
// whole numbers are exact both ways, so that a page goes back as it came.
class PackedMotion {
  public:
    static constexpr int kTile = 8;  // vertices along a side

    // Values are 0 to 65535 quanta of `step`.
    PackedMotion(std::string name, int nx, int ny, double step);

    // Sets what is known before the first frame, one value per vertex, row 0 the south; without it all are 0. Errors: a
    // value is beyond the quanta; the fact has it, and nothing was set.
    tl::expected<void, std::string> begin_with(std::span<const float> values);
    std::vector<std::uint32_t> quanta() const { return {now_.begin(), now_.end()}; }  // of the last frame
    // Adds a frame. Errors: as begin_with().
    tl::expected<void, std::string> add(std::span<const float> values);
    std::size_t waiting() const {
        return map_.size() + low_.size() + high_.size();
    }  // bytes that flush() moves
    // Moves the frames until now into the stream. Call it now and then: they are kept in memory until then.
    void flush(PackedStream& into);

    double step() const { return step_; }
    double most_error() const { return 0.51 * step_; }  // half a quantum, and what a float adds to it

  private:
    tl::expected<void, std::string> take(std::span<const float> values);
    void add_tile(int left, int bottom);

    std::string name_;
    int nx_, ny_, tiles_x_, tiles_y_;
    double step_;
    std::vector<std::int32_t> now_, next_;
    std::vector<std::uint8_t> map_, low_, high_;
};

}  // namespace game
