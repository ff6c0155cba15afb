#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "sim/core/grid.h"

namespace game {

inline constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;  // bytes

// The most vertices of a grid whose fronts and textures are tracked.
inline constexpr std::size_t kMostFollowed = 900'000;

// The size of the images that a subcommand draws. A software renderer keeps their buffers in main memory.
struct FrameUse {
    int width = 0, height = 0;  // pixels; 0: none
    int samples = 2;            // along the edge of a pixel, as in render::Target

    bool operator==(const FrameUse&) const = default;
};

// What a command keeps in memory for one ground.
struct WorldUse {
    int sessions = 1;        // worlds that are stepped and measured
    int runs = 0;            // further worlds that are only stepped, for comparison
    bool draws = false;      // fronts and textures
    FrameUse frames = {};    // images, or the window
    bool goes_back = false;  // keyframes and undo
    bool page = false;       // of the slide, in the making
};

std::uint64_t machine_memory();  // bytes
// Memory of the buffers of a frame, and of images on their way to a file, bytes.
std::uint64_t frame_bytes(const FrameUse& frames);
// Of everything that is drawn with, but for what it takes per vertex, bytes.
std::uint64_t drawing_bytes(const WorldUse& use);

// How much memory a world may take, and for what. A grid is checked before memory is allocated for it.
struct Memory {
    std::uint64_t most = machine_memory() / 2;  // bytes
    WorldUse use = {};

    // The allowance of a sandbox, out of `most`.
    std::uint64_t for_keyframes() const;
    std::uint64_t for_undo() const;

    // Errors: the grid needs more than `most`; the fact has both sizes.
    tl::expected<void, std::string> allows(const sim::Grid& grid, bool two_materials,
                                           bool has_things = false) const;
};

// Expected peak of the whole program, bytes: of reading the ground or of using it, whichever is more.
// docs/results/costs.md#memory has the measurements.
// `has_things`: something stands at tick 0, or a command places it. A user may always place something.
std::uint64_t expected_bytes(const sim::Grid& grid, bool two_materials, const Memory& memory,
                             bool has_things = false);

// Parses "800M", "4G", "1073741824": bytes, or multiples of
// 1024 with K, M, G or T. Nothing for any other text or 0.
std::optional<std::uint64_t> bytes_from(std::string_view text);
// Formats bytes as "1.5 GiB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace game
