#include "game/share/scenery.h"

#include <algorithm>
#include <string>

#include "game/scene/mountains.h"
#include "game/share/built_pieces.h"
#include "render/mountain/spindrift.h"
#include "render/mountain/sun_sweep.h"
#include "render/mountain/surroundings_mesh.h"
#include "render/woods/followed_woods.h"
#include "render/woods/trees_in_view.h"

namespace game {
namespace {

using enum Packing::Predict;

constexpr double kShare = 1.0 / 255;  // quantum of shares

// Writes a column of a table: a value of each row.
template <class Row, class Value>
void pack_column(PackedStream& into, const std::string& name, const std::vector<Row>& rows,
                 const Packing& packing, const Value& value) {
    std::vector<double> column(rows.size());
    std::transform(rows.begin(), rows.end(), column.begin(), value);
    into.add(name, column, packing);
}

}  // namespace

Scenery::Scenery(const Scenario& scenario, const sim::View& first, const render::Structures& structures,
                 const render::FrameBlock& frame)
    : scenario_(scenario), frame_(frame) {
    if (!scenario.model) around_ = mountains_around(scenario);
    land_ = land_on(scenario, around_, render::Land::kInPages);
    if (!around_.empty()) frame_.beyond = glm::dvec4(around_.rough_origin(), around_.rough_cell(), 1);
    render::SunSweep sweep;
    sweep.run(first, &around_, frame_);
    ceilings_.assign(sweep.ceilings().begin(), sweep.ceilings().end());
    rays_ = sweep.rays();
    if (!scenario.model) find_trees(first);
    fell_.assign(trees_.size(), -1);
    for (std::uint32_t i = 0; const render::Tree& tree : trees_) {
        if (tree.vertex >= 0) standing_.push_back(i);
        ++i;
    }
    built_.push_back({0, structures});
}

// Woods and planted forest as the program shows them: none in buildings and on roads.
void Scenery::find_trees(const sim::View& first) {
    const render::Woods woods = woods_on(scenario_, around_, land_);
    render::FollowedWoods followed;
    followed.follow(&woods, &around_, first, scenario_.depth, glm::vec3(frame_.sun), true);
    const render::LitTrees shown = followed.trees();
    for (const render::TreeTile& tile : shown.tiles) {
        if (tile.count == 0) continue;
        const auto trees = shown.trees.subspan(tile.first, tile.count);
        const auto lights = shown.lights.subspan(tile.first, tile.count);
        trees_.insert(trees_.end(), trees.begin(), trees.end());
        tree_lights_.insert(tree_lights_.end(), lights.begin(), lights.end());
        tiles_.push_back(tile.count);
    }
}

void Scenery::see(const render::FlowSoFar& flow, std::span<const sim::Stems> forest,
                  const render::Structures& structures, std::int64_t frame) {
    constexpr float kLies = 0.5f;
    const auto stands = [&](const render::Tree& tree) {
        if (tree.fate == render::TreeFate::kStands)
            return forest.empty() || forest[static_cast<std::size_t>(tree.vertex)].standing > 0;
        return render::lying(tree, flow) < kLies;
    };
    std::erase_if(standing_, [&](std::uint32_t i) {
        if (stands(trees_[i])) return false;
        fell_[i] = frame;
        return true;
    });
    if (structures != built_.back().structures) built_.push_back({frame, structures});
}

void Scenery::pack(PackedStream& into) const {
    const std::vector<double> ceilings(ceilings_.begin(), ceilings_.end());
    into.add("ceiling", ceilings, {0.1, 2, kPlane}, rays_);
    if (around_.empty()) return;
    pack_surroundings(into);
    if (!land_.empty()) pack_land(into);
    if (has_trees()) pack_woods(into);
    if (render::is_dry_snow(scenario_.look)) pack_ridges(into);
}

void Scenery::pack_surroundings(PackedStream& into) const {
    const auto cover = around_.cover();
    std::vector<double> depth, lower;
    for (const glm::vec2& each : cover) {
        depth.push_back(static_cast<double>(each.x));
        lower.push_back(static_cast<double>(each.y));
    }
    into.add("cover_d", depth, {0.01, 2, kPlane}, around_.columns());
    if (frame_.lower_standing.w > 0) into.add("cover_l", lower, {kShare, 1, kPlane}, around_.columns());

    const std::vector<double> rough(around_.rough_heights().begin(), around_.rough_heights().end());
    into.add("rough", rough, {1, 2, kPlane},
             render::Surroundings::kRough);  // for the camera, not for the eye

    const render::SurroundingsMesh mesh = render::surroundings_mesh(around_);
    std::vector<float> sun;
    render::sunlit(around_, mesh.vertices, glm::dvec3(frame_.sun), sun);
    using Vertex = render::SurroundingsVertex;
    const auto add = [&](const std::string& name, const Packing& packing, const auto& value) {
        pack_column(into, "around." + name, mesh.vertices, packing, value);
    };
    add("x", {0.25, 2, kLast}, [](const Vertex& v) { return v.at.x; });
    add("y", {0.25, 2, kLast}, [](const Vertex& v) { return v.at.y; });
    add("z", {0.25, 2, kLast}, [](const Vertex& v) { return v.at.z; });
    add("slope_x", {0.01, 2, kLast}, [](const Vertex& v) { return v.slope.x; });
    add("slope_y", {0.01, 2, kLast}, [](const Vertex& v) { return v.slope.y; });
    add("source_x", {0.1, 2, kLast}, [](const Vertex& v) { return v.source.x; });
    add("source_y", {0.1, 2, kLast}, [](const Vertex& v) { return v.source.y; });
    add("cover_d", {0.02, 1, kLast}, [](const Vertex& v) { return v.cover.x; });
    if (frame_.lower_standing.w > 0)
        add("cover_l", {kShare, 1, kLast}, [](const Vertex& v) { return v.cover.y; });
    add("open", {kShare, 1, kLast}, [](const Vertex& v) { return v.open; });
    add("on", {1, 1, kNone}, [](const Vertex& v) { return v.on_grid; });
    pack_column(into, "around.sun", sun, {kShare, 1, kLast}, [](float share) { return share; });
    into.add("around.index", mesh.indices, 0, 1, 3, kLast);
}

void Scenery::pack_land(PackedStream& into) const {
    for (std::size_t part = 0; const char* name : {"brook", "moisture", "use", "rubble"}) {
        std::vector<std::uint32_t> shares;
        shares.reserve(land_.texels.size() / 4);
        for (std::size_t i = part++; i < land_.texels.size(); i += 4) shares.push_back(land_.texels[i]);
        into.add(std::string("land.") + name, shares, 0, 1, 1, kPlane, land_.columns);
    }
}

void Scenery::pack_woods(PackedStream& into) const {
    using render::Tree;
    const auto add = [&](const std::string& name, const Packing& packing, const auto& value) {
        pack_column(into, "trees." + name, trees_, packing, value);
    };
    add("x", {0.5, 2, kLast}, [](const Tree& t) { return t.foot.x; });
    add("y", {0.5, 2, kLast}, [](const Tree& t) { return t.foot.y; });
    add("z", {0.25, 2, kLast}, [](const Tree& t) { return t.foot.z; });
    add("height", {0.5, 1, kNone}, [](const Tree& t) { return t.height; });
    add("snow", {0.05, 1, kLast}, [](const Tree& t) { return t.snow; });
    if (frame_.lower_standing.w > 0) add("lower", {kShare, 1, kLast}, [](const Tree& t) { return t.lower; });
    add("closed", {1.0 / 15, 1, kLast}, [](const Tree& t) { return t.closed; });
    add("group", {1, 1, kNone}, [](const Tree& t) { return t.group; });
    add("kind", {1, 1, kNone}, [](const Tree& t) { return static_cast<double>(t.kind); });
    add("keeps", {1.0 / 15, 1, kLast}, [](const Tree& t) { return render::snow_kept(t); });
    add("on", {1, 1, kNone}, [](const Tree& t) {
        return t.vertex < 0 ? 0. : t.fate == render::TreeFate::kOfFlow ? 1. : 2.;
    });
    pack_column(into, "trees.sun", tree_lights_, {1.0 / 31, 1, kLast},
                [](const render::TreeLight& light) { return light.sunlit; });
    pack_column(into, "trees.count", tiles_, {1, 2, kNone}, [](std::uint32_t count) { return count; });
}

// Where wind blows snow off.
void Scenery::pack_ridges(PackedStream& into) const {
    render::Ridges ridges(around_, scenario_.wind);
    ridges.light(around_, glm::vec3(frame_.sun));
    const std::vector<render::SpindriftPlace> places(ridges.places().begin(), ridges.places().end());
    if (places.empty()) return;
    using render::SpindriftPlace;
    const auto add = [&](const std::string& name, const Packing& packing, const auto& value) {
        pack_column(into, "ridges." + name, places, packing, value);
    };
    add("x", {0.25, 2, kNone}, [](const SpindriftPlace& p) { return p.at.x; });
    add("y", {0.25, 2, kNone}, [](const SpindriftPlace& p) { return p.at.y; });
    add("z", {0.25, 2, kNone}, [](const SpindriftPlace& p) { return p.at.z; });
    add("strength", {kShare, 1, kNone}, [](const SpindriftPlace& p) { return p.strength; });
    add("chance", {kShare, 1, kNone}, [](const SpindriftPlace& p) { return p.chance; });
    add("sun", {kShare, 1, kNone}, [](const SpindriftPlace& p) { return p.sunlit; });
}

void Scenery::pack_ends(PackedStream& into, const sim::View& world, std::int64_t frames) const {
    if (has_trees())
        pack_column(into, "trees.falls", fell_, {1, 2, kNone},
                    [&](std::int64_t frame) { return static_cast<double>(frame < 0 ? frames : frame); });
    const auto has_any = [](const Built& built) { return !built.structures.empty(); };
    if (std::any_of(built_.begin(), built_.end(), has_any)) pack_structures(into, world, frames);
}

void Scenery::pack_structures(PackedStream& into, const sim::View& world, std::int64_t frames) const {
    const render::BuildingGround ground{world, scenario_.depth, around_.cover(),
                                        render::snowy(scenario_.look)};
    BuiltPieces pieces;
    for (std::size_t i = 0; i < built_.size(); ++i)
        pieces.add(render::structure_mesh(built_[i].structures, ground, glm::vec3(frame_.sun)),
                   built_[i].from, i + 1 < built_.size() ? built_[i + 1].from : frames);
    if (!pieces.empty()) pieces.pack(into);
}

}  // namespace game
