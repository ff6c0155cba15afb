#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "render/buildings/structures.h"
#include "render/frame/marks.h"
#include "render/mountain/land.h"
#include "render/mountain/surroundings.h"
#include "render/view/camera.h"
#include "render/view/flow_so_far.h"
#include "render/view/ground_kind.h"
#include "render/view/lens.h"
#include "render/view/look.h"
#include "render/view/wind.h"
#include "render/woods/woods.h"
#include "sim/carried/body.h"
#include "sim/front/flow_view.h"
#include "sim/powder/cloud.h"
#include "sim/world/state.h"

namespace render {

// The image of which a frame is a part, pixels, and where the frame begins in it.
struct WholeImage {
    int width = 0, height = 0;  // > 0
    int left = 0, bottom = 0;   // a frame may reach beyond the image
};

// Pixels along the border of a part in which it may differ from the whole image: smoothed edges, the coarse pixels of sky
// and powder. Parts begin at multiples of these, so that coarse pixels are the same.
inline constexpr int kPartOverlap = 24;

// Everything that a frame shows. A plain value, of which draw() keeps nothing: `world`, `flow` and
// `surroundings` must be valid during the call only.
struct FrameInput {
    sim::View world;
    Camera camera;
    Light light = {};
    Look look = {};
    Marks marks = {};
    // Drawn as look.flow says; its mesh is the heightfield of the world's grid. Without either, no texture is
    // advected.
    const sim::front::FlowView* flow = nullptr;
    int width = 0, height = 0;  // of the frame, pixels, > 0
    // The camera's image, if the frame is only a part of it. Parts meet without a seam where they overlap by kPartOverlap.
    std::optional<WholeImage> whole = {};
    std::optional<Lens> lens = {};  // none: as the eye sees
    // Depth of the standing layer at tick 0, m, one value per vertex, row 0 the south; valid during the call.
    // Trees and houses stand on it. If empty, it is unknown.
    std::span<const float> first_depth = {};
    // What it would be now without slides, which tells deposits and scars. If empty, it is the first depth.
    std::span<const float> undisturbed = {};
    // Of this world, with this first depth. If null, the block of terrain stands by itself, with walls.
    const Surroundings* surroundings = nullptr;
    // Of these surroundings, drawn if look has a date. If null or empty, the ground is dry and without brooks.
    const Land* land = nullptr;
    // Powder or dust in the air, in look's colours; valid during the call.
    std::span<const sim::powder::Puff> powder = {};
    float powder_strength = 1;  // 0 to 1, factor on its opacity; 0: none is drawn
    // What flows of soil carry; valid during the call. Not drawn without a date and under an overlay.
    std::span<const sim::carried::Body> carried = {};
    // Of these surroundings, without which no trees are drawn. If null, there are none.
    const Woods* woods = nullptr;
    // What the flow has done until now, for trees to lie where it was; valid during the call.
    FlowSoFar flow_so_far = {};
    // What people have built, as it is now. If null, there is nothing.
    const Structures* structures = nullptr;
    // It blows snow off the ridges of these surroundings, if look is that of dry snow: bright, with much powder.
    Wind wind = {};
    double seconds = 0;  // time of the world, by which that snow moves
    // A part of the ground whose outline marks.extent draws: 255 inside and 0 outside, one value per vertex, row 0 the
    // south; valid during the call. Not empty if marks.extent is not 0.
    std::span<const std::uint8_t> extent = {};
    // How likely something is at each vertex, 0 to 1, or NaN where nothing is known; row 0 the south; valid during the call.
    // Not empty if marks.probability is not 0.
    std::span<const float> probability = {};

    WholeImage image() const { return whole.value_or(WholeImage{width, height}); }

    // Which parts it has.
    GroundKind ground_kind() const { return {look.date.has_value(), world.mixture != nullptr}; }
    std::span<const float> untouched() const { return undisturbed.empty() ? first_depth : undisturbed; }
    bool flows() const { return look.flow && flow; }
    bool surrounded() const { return surroundings && !surroundings->empty(); }
    bool has_land() const { return look.date && surrounded() && land && !land->empty(); }
    bool may_have_trees() const { return marks.overlay == Overlay::kNone; }  // they would hide its values
    bool may_have_carried() const { return look.date && marks.overlay == Overlay::kNone; }
    bool shows_wet_soil() const { return world.things && look.date && marks.overlay == Overlay::kNone; }
};

}  // namespace render
