#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/mountain/surroundings.h"
#include "render/woods/tree_light.h"
#include "render/woods/woods.h"
#include "sim/world/state.h"

namespace render {

// The trees of woods, and those of the forest in a world's state.
//
//     forest at a vertex ──▶ n trees: first the woods' own there, if they act, then others at places that depend on
//                            the vertex alone; planting adds trees at the end, felling takes them from there
//
// Of the n trees the first lie, as many as the state has broken. Of more than Woods::kMost that the forest asks for
// beyond the woods, an even share is shown. No tree is shown in a building or on a road. What changes of the forest is paid for, not what there is of it.
class FollowedWoods {
  public:
    // What of the trees differs from those of the last call: those of some tiles, or all may.
    enum class Change { kNone, kSome, kAll };
    // Makes them those of this world. `woods` and `around` may be null. `new_ground`: bedrock by nature, or the first
    // depth, is not that of the last call.
    Change follow(const Woods* woods, const Surroundings* around, const sim::View& world,
                  std::span<const float> first_depth, const glm::vec3& sun, bool new_ground);

    // Valid until the next call, and as long as the woods.
    LitTrees trees() const;
    // The tiles with other trees than in the last call; all other trees are where they were among `trees`.
    std::span<const ChangedTile> changed_tiles() const { return changed_tiles_; }

  private:
    // What a tile shows: trees of a tile of the woods, or the others of a block of vertices.
    struct Plot {
        std::uint32_t room = 0;  // trees from its first one on
        bool is_stale = true;
    };
    // A tree of the woods on the grid.
    struct Own {
        std::uint32_t tree = 0, plot = 0;
    };
    // Where a thing stands, with some room.
    struct Footprint {
        glm::dvec2 at{0}, along{0};  // its middle; unit vector
        glm::dvec2 half{0};          // along it and across
        bool operator==(const Footprint&) const = default;
        bool covers(glm::dvec2 place) const;
        bool meets(glm::dvec2 low, glm::dvec2 high) const;
    };
    struct Ordered {
        float order;
        Tree tree;
    };
    struct World {
        const Woods* woods;
        const Surroundings* around;
        const sim::View& view;
        std::span<const float> first_depth;
    };

    void light_woods(const Surroundings* around);
    void begin(const World& world);
    void find_own(const Woods& woods);
    bool compare(const World& world);
    bool compare_footprints(const sim::Things& things);
    void mark_around(const Footprint& footprint);
    void list_footprints(const sim::Things& things);
    void find_near(glm::dvec2 low, glm::dvec2 high);
    bool is_built_on(const Tree& tree) const;
    void mark_stale(std::size_t vertex);
    bool thin();
    void renew_stale(const World& world);
    void grow_own(std::size_t plot, const Woods& woods);
    void grow_others(std::size_t plot, const World& world);
    Tree other(int x, int y, int number, const World& world) const;
    void settle(std::size_t plot, const Surroundings* around);

    std::size_t vertex_at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.nx) + static_cast<std::size_t>(x);
    }
    std::size_t plot_at(int x, int y) const {
        return own_plots_ + static_cast<std::size_t>(y / block_) * static_cast<std::size_t>(blocks_along_x_) +
               static_cast<std::size_t>(x / block_);
    }
    const sim::Stems& at(std::size_t vertex) const {
        const auto columns = static_cast<std::size_t>(grid_.nx);
        return forest_(static_cast<int>(vertex % columns), static_cast<int>(vertex / columns));
    }
    std::size_t count_own(std::size_t vertex) const { return first_own_[vertex + 1] - first_own_[vertex]; }
    double beyond_own(std::size_t vertex) const;
    int shown_own(std::size_t vertex) const;
    int shown_others(std::size_t vertex) const;
    int lying_of(std::size_t vertex) const;

    const Woods* woods_ = nullptr;  // of the last call
    std::uint64_t woods_known_ = 0, around_known_ = 0;
    bool follows_ = false;  // a forest; else these are the woods
    sim::Grid grid_;
    glm::vec3 sun_{0};

    sim::Field<sim::Stems> forest_;         // as followed
    std::vector<std::uint32_t> first_own_;  // of each vertex, in own_
    std::vector<Own> own_;
    std::vector<sim::Stems> forest_of_own_;
    std::vector<Footprint> footprints_, footprints_now_;
    std::vector<Footprint> near_;  // the plot that is renewed
    int block_ = 1, blocks_along_x_ = 0;
    std::size_t own_plots_ = 0;
    double beyond_ = 0;  // trees that the forest asks for beyond the woods' own
    double share_ = 1;   // of them that is shown

    std::vector<Plot> plots_;
    std::size_t room_ = 0;         // of all plots
    std::vector<TreeTile> tiles_;  // of each plot
    std::vector<Tree> trees_;
    std::vector<TreeLight> lights_;  // of trees_, or of the woods
    std::vector<Ordered> grown_;     // of one plot
    std::vector<ChangedTile> changed_tiles_;
};

}  // namespace render
