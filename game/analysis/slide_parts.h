#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "game/scene/scenario.h"
#include "game/session/peak_watch.h"
#include "game/words/words.h"
#include "sim/world/state.h"

namespace game {

// Places of the parts of a slide by which it is described, in the terms of the EAWS glossary. The slide is the largest
// connected part of the extent so far (Measures::kExtentDepth). Everything follows from the world and its maxima at one
// time, however that was reached. A view, which never affects the world. Allocates at its first search in a grid only.
class SlideParts {
  public:
    enum class Part : std::uint8_t {
        kCrown,       // the upper edge of what was released, above the middle of it
        kStauchwall,  // the lower edge of the slab; nothing if none was released
        kTrack,       // between release and toe at half of the height: where most momentum passed
        kFront,       // of what is fast, the place farthest from the crown; nothing once little is
        kDeposit,     // where most new material is at rest; nothing while there is a front
    };
    static constexpr std::size_t kParts = 5;
    static constexpr std::array<const char*, kParts> kNames{
        message("Crown"), message("Stauchwall"), message("Track"), message("Front"), message("Deposit")};

    static constexpr double kFast = 2;         // m/s in plan; slower flow has no front
    static constexpr double kLeastFast = 0.2;  // of the volume at rest: if less is fast, there is no front
    static constexpr double kAtRest = 0.5;     // m/s in plan; slower flow counts as deposit
    static constexpr double kLeastNew = 0.1;   // m, of a deposit
    static constexpr double kLeastTrack =
        10;  // cells in plan from crown to toe; a shorter slide has no track

    // `start`: the world at tick 0. `commands`: in any number of lists; a slab is what those that blast released at once,
    // and the rolling layer of tick 0.
    void find(const Scenario& start, const sim::View& world, const Peaks& peaks,
              std::span<const std::span<const TimedCommand>> commands);

    // m in plan; nothing if the slide has no such part, or if there is no slide.
    const std::optional<glm::dvec2>& at(Part part) const { return at_[static_cast<std::size_t>(part)]; }

  private:
    using Vertices = std::vector<std::uint32_t>;  // indices in a grid, row by row

    // What is looked at in one search.
    struct Sight;

    void find_slide(const Sight& sight);
    void find_slab(const Sight& sight);
    void find_first(const Sight& sight);
    void find_edges(const Sight& sight);
    std::uint32_t climb(const Sight& sight, std::uint32_t from, glm::dvec2 up) const;
    void find_front_or_deposit(const Sight& sight);
    void find_track(const Sight& sight);
    template <class Inside>
    void flood(const sim::Grid& grid, std::uint32_t from, std::uint8_t mark, const Inside& inside);
    bool has(std::uint32_t vertex, std::uint8_t mark) const { return (marks_[vertex] & mark) != 0; }
    void put(Part part, glm::dvec2 place) { at_[static_cast<std::size_t>(part)] = place; }

    std::array<std::optional<glm::dvec2>, kParts> at_;
    std::vector<std::uint8_t> marks_;  // of each vertex
    Vertices slide_, released_;        // released_: the slab, or where the slide moved first
    Vertices flooded_;
    bool has_slab_ = false;
    glm::dvec2 from_{0};  // m, the crown, or the middle of what was released on level ground
};

}  // namespace game
