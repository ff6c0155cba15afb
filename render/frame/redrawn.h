#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/base/rectangle.h"
#include "render/frame/frame_input.h"
#include "render/frame/what_changed.h"
#include "render/view/frame_block.h"
#include "render/view/on_screen.h"
#include "render/view/screen_tiles.h"

namespace render {

// All that a frame depends on but the world, what is built on it and what is in the air. Where one differs from the
// last frame's, all is drawn anew.
struct FrameKey {
    FrameBlock block;  // without a ring and an outline
    bool flows = false, lines = false, mesh = false, coarse = false, lens = false;
    FlowPattern pattern = {};
    std::uint64_t surroundings = 0, land = 0;  // fingerprints; 0: none

    bool operator==(const FrameKey& other) const {
        const auto bytes = [](const FrameBlock& of) { return std::as_bytes(std::span(&of, 1)); };
        return std::ranges::equal(bytes(block), bytes(other.block)) && flows == other.flows &&
               lines == other.lines && mesh == other.mesh && coarse == other.coarse && lens == other.lens &&
               pattern == other.pattern && surroundings == other.surroundings && land == other.land;
    }
};

FrameKey frame_key_of(const FrameInput& input, const FrameBlock& block);

// Whether surface.comp and cover.glsl make the same of a vertex.
bool same_surface(const FrameBlock& a, const FrameBlock& b);

// What a pass finds its parts of a frame by.
struct Redraw {
    const FrameBlock& frame;
    const WhatChanged& changed;
    const OnScreen& screen;
    bool everything = true;  // is drawn anew; else `tiles` are marked where the pass looks different
    ScreenTiles& tiles;
};

// What one frame draws anew, and the last one drew.
struct Redrawn {
    std::optional<FrameKey> key;     // of the last frame; none: it is forgotten
    std::optional<Ring> ring;        // of the last frame
    std::optional<Outline> outline;  // of the last frame
    WhatChanged world;
    ScreenTiles scene_tiles, shown_tiles, smoothed_tiles, ignored_tiles;
    std::vector<Rectangle> scene;            // samples: what stands there
    std::vector<Rectangle> shown;            // pixels: that, and what floats in the air
    std::vector<Rectangle> air, smoothed;    // samples of `shown`; pixels around it whose edges may change
    std::vector<Rectangle> floats, floated;  // samples: powder and spindrift, now and in the last frame

    // `width`, `height`: of the frame, pixels. `samples`: along the edge of one. `powder`, `spindrift`: where they are
    // in this frame.
    void find(int width, int height, int samples, const RedrawRules& rules, std::span<const Rectangle> powder,
              std::span<const Rectangle> spindrift);
};

}  // namespace render
