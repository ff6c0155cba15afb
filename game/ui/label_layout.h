#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "game/ui/widgets.h"

namespace game::ui {

// Finds room for plates beside the places that they name, each with a straight leader line to it. A plate stays on the
// side of its place where it was in the last frame, while there is room.
class LabelLayout {
  public:
    static constexpr std::size_t kMost = 8;

    struct Label {
        ImVec2 at, size;        // px, of the place and of the plate
        std::size_t key = 0;    // which label it is in every frame, below kMost
        Box plate = {};         // set by lay()
        ImVec2 line_end = {};   // set by lay(), on the plate's edge
        bool has_room = false;  // set by lay()
    };
    // Labels earlier in the list take their room first; one without room, or whose place is outside `room` or under a
    // box of `taken`, is not shown. Plates and lines overlap no other plate, and no plate overlaps a box or a place.
    void lay(std::span<Label> labels, const Box& room, std::span<const Box> taken, float em);

  private:
    std::array<std::optional<std::uint8_t>, kMost> side_;  // of each key, in the last frame
};

bool overlap(const Box& one, const Box& other);
bool contains(const Box& box, ImVec2 point);

}  // namespace game::ui
