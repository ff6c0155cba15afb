#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/mountain/land.h"
#include "render/mountain/surroundings.h"
#include "sim/world/things.h"

namespace render {

// How trees stand on a mountain. It belongs to a scene, never to the simulation.
struct TreeRules {
    static constexpr double kDensest = 1e6;  // trees per hectare that can be asked for

    double density = 0;      // trees per hectare where the wood is closed, 0 to kDensest; 0: no trees
    double line_m = 1800;    // the tree line: height above the terrain's zero that no tree grows above, m
    std::uint32_t seed = 1;  // another seed, another wood
    // Corners, m east and north of vertex (0, 0), in order, without crossing sides: no tree grows outside.
    // None: no such limit.
    std::vector<glm::dvec2> polygon = {};
    // For each vertex of the grid, row 0 the south: the share of the closed wood that grows there, 0 to 255
    // for 0 to 1. Then none grows outside the grid. None: stands as this program makes them.
    std::vector<std::uint8_t> shares = {};
    // Which kinds grow, as for a day of the year: with larches, broad-leaved trees and bushes. Else conifers of a winter. Number,
    // place and height of trees are the same, so that a forest in the state is.
    bool mixed = false;
    bool operator==(const TreeRules&) const = default;
};

enum class TreeKind : std::int32_t {
    kSpruce,  // dark, with needles and snow
    kLarch,   // bare in winter, light brown
    kPine,    // dwarf pine: a low cushion
    kBeech,   // and what else has a broad crown
    kBirch,
    kBush,  // hazel, willow, green alder; it belongs to no forest, and a flow lays it
};
// Half the width of a crown, in heights of the tree.
float radius_of(TreeKind kind);

// By what a tree stands or lies.
enum class TreeFate : std::int32_t {
    kOfFlow,  // a view: by what a flow has done
    kStands,  // by the forest in a world's state
    kLies,
};

enum class TreeOrigin : std::int32_t { kWild, kPlanted };  // planted in a hedge or an orchard

// A tree where it grew, or outside the grid a group of them. Space as in shaders.
struct Tree {
    glm::vec3 foot;       // m, on the ground at tick 0
    float height;         // m
    glm::vec2 downhill;   // unit vector
    float chance;         // 0 to 1, its own number, by which trees differ
    float snow;           // depth of the standing layer at its foot at tick 0, m
    float snow_near;      // and the greatest within some 25 m, m: a tree on a bare rock in snow carries some
    float lower;          // share of the lower material at the surface of that, 0 to 1
    std::int32_t vertex;  // the grid's vertex nearest to it, row by row from the south; −1 outside the grid
    float closed;         // how closed the wood is around it, 0 to 1
    float group;  // number of trees side by side that it stands for, 1 to kLargestGroup; 1 on the grid
    TreeKind kind;
    TreeFate fate = TreeFate::kOfFlow;
    TreeOrigin origin = TreeOrigin::kWild;
};

// Whether the stems of a world's forest count it: trees on the grid are; bushes, and what is planted in hedges and
// orchards, are not.
bool is_of_forest(const Tree& tree);

// The greatest depth of the standing layer within some 25 m of a place at tick 0, m.
float snow_near(const Surroundings& around, glm::dvec2 at);

// A place where no tree grows: all within a distance of a line.
struct Clearing {
    glm::dvec2 from, to;  // m
    double reach;         // m
};

// Trees that are drawn or left out together: those of a square of ground. Their order is random, so that the
// first ones are as evenly spread as all of them.
struct TreeTile {
    std::uint32_t first = 0, count = 0;  // in Woods::trees()
    glm::vec3 lowest{0}, highest{0};     // corners of the box around feet and tops, m
};

// The trees of a world, on its grid and on the mountains around it. They stand in closed stands with clear
// edges on slopes below the tree line: not on rock and not on level ground. At the line stands are few, and
// follow ribs; single trees and dwarf pine are between them. In gullies, where avalanches run, only some
// trees stand. Of mixed woods broad-leaved trees are low and on gentle ground, larches high, and birches and bushes where the wood is
// open. Along brooks are thickets, and hedges and orchards are where the land has them. A tree
// whose place is in a brook, on a path or within a field stands beside it, but counts where it grew. A view:
// nothing else knows of them, unless they act.
//
// A tree of the grid is a function of ground, rules and place, bit-identical on every machine. Those around
// it are equal on one machine, as Surroundings are.
class Woods {
  public:
    static constexpr std::size_t kMost = 80'000;  // trees; of more, an even share is kept
    static constexpr std::size_t kMostBushes = 30'000;
    static constexpr float kMostTogether = 20;  // trees that one stands for
    static constexpr float kLargestGroup = 16;  // trees that one far from the grid stands for

    // None.
    Woods() = default;
    // `datum`: height of shaders' z = 0 above the terrain's zero, m. Without surroundings there are no trees. `land`: of these
    // surroundings, for mixed woods.
    Woods(const Surroundings& around, const TreeRules& rules, double datum,
          std::span<const Clearing> clearings = {}, const Land& land = {});

    // From now on those on the grid are those of the forest in a world's state, which begins with forest_of() them. Else
    // they are a view, and any forest is shown besides.
    void let_act();
    bool act() const { return act_; }

    bool empty() const { return trees_.empty(); }
    // Valid as long as the woods are, so not of woods that end with the expression.
    std::span<const Tree> trees() const& { return trees_; }
    std::span<const TreeTile> tiles() const& { return tiles_; }
    std::span<const Tree> trees() const&& = delete;
    std::span<const TreeTile> tiles() const&& = delete;
    // How many trees the rules ask for: more than there are, if those are too many.
    double asked() const { return asked_; }
    // Which kind a planted tree of the grid is: that of the woods' own at its place, if they are mixed. `closed` and `chance`:
    // those of the tree.
    TreeKind kind_of_planted(const Surroundings& around, glm::dvec2 at, double closed, double chance) const;
    // Equal for equal woods, else different but for one chance in 2⁶⁴.
    std::uint64_t fingerprint() const { return fingerprint_; }

  private:
    void put_on_mesh(const Surroundings& around);
    void sort_into_tiles(double tile_m, std::span<const Tree> trees);

    std::vector<Tree> trees_;
    std::vector<TreeTile> tiles_;
    TreeRules planted_;  // without polygon and shares
    double datum_ = 0;
    double asked_ = 0;
    std::uint64_t fingerprint_ = 0;
    bool act_ = false;
};

// The forest that stands for the trees of woods on the grid, one value per vertex: their number, clamped to
// sim::kMostStems, and their mean height.
std::vector<sim::Stems> forest_of(const Woods& woods, const sim::Grid& grid);

}  // namespace render
