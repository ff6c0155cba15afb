#include "render/frame/redrawn.h"

namespace render {
namespace {

// A rectangle of samples, in pixels.
Rectangle in_pixels(const Rectangle& r, int samples) {
    return {r.left / samples, r.bottom / samples, (r.right + samples - 1) / samples,
            (r.top + samples - 1) / samples};
}

}  // namespace

FrameKey frame_key_of(const FrameInput& input, const FrameBlock& block) {
    FrameKey key{block};
    key.block.ring = key.block.ring_colour = glm::vec4(0);
    key.block.outline = key.block.outline_colour = glm::vec4(0);
    key.flows = input.flows();
    key.lines = input.marks.has_lines();
    key.mesh = input.marks.flow_mesh;
    key.lens = input.lens.has_value();
    if (key.flows) key.pattern = input.look.flow->pattern;
    if (input.surrounded()) key.surroundings = input.surroundings->fingerprint();
    if (input.has_land()) key.land = input.land->fingerprint;
    return key;
}

bool same_surface(const FrameBlock& a, const FrameBlock& b) {
    return a.overlay == b.overlay && a.density == b.density && a.meadow.w == b.meadow.w &&
           a.standing.w == b.standing.w && a.rolling.w == b.rolling.w &&
           a.lower_standing.w == b.lower_standing.w;
}

// What floats in the air is laid over the scene each time, where it is now or was before.
void Redrawn::find(int width, int height, int samples, const RedrawRules& rules,
                   std::span<const Rectangle> powder, std::span<const Rectangle> spindrift) {
    const auto marked = scene_tiles.rectangles(rules.most_rectangles, rules.least_gain);
    scene.assign(marked.begin(), marked.end());
    if (!rules.last_rectangle && scene.size() > 1) scene.pop_back();
    floated.swap(floats);
    floats.assign(powder.begin(), powder.end());
    floats.insert(floats.end(), spindrift.begin(), spindrift.end());

    shown_tiles.begin(width, height, rules.tile);
    for (const Rectangle& part : scene) shown_tiles.mark(in_pixels(part, samples));
    for (const Rectangle& part : floats) shown_tiles.mark(in_pixels(part, samples));
    if (rules.air)
        for (const Rectangle& part : floated) shown_tiles.mark(in_pixels(part, samples));
    const auto parts = shown_tiles.rectangles(rules.most_rectangles, rules.least_gain);
    shown.assign(parts.begin(), parts.end());
    air.clear();
    smoothed_tiles.begin(width, height, rules.tile);
    for (const Rectangle& part : shown) {
        air.push_back({part.left * samples, part.bottom * samples, part.right * samples, part.top * samples});
        smoothed_tiles.mark(grown(part, rules.edge_reach));
    }
    const auto around = smoothed_tiles.rectangles(rules.most_rectangles / 4, 4 * rules.least_gain);
    smoothed.assign(around.begin(), around.end());
}

}  // namespace render
