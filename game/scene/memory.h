#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "sim/core/grid.h"

namespace game {

// Vertices of a grid whose fronts and textures are followed, at most.
inline constexpr std::size_t kMostFollowed = 900'000;

// What a command keeps in memory of one ground.
struct WorldUse {
    int sessions = 1;        // worlds that are played and measured
    int runs = 0;            // further worlds that are stepped only, to compare with
    bool draws = false;      // fronts, textures and frames
    bool goes_back = false;  // keyframes and undo
};

std::uint64_t machine_memory();  // bytes

// How much memory a world may take, and what it is for. A grid is checked before memory is taken for it.
struct Memory {
    std::uint64_t most = machine_memory() / 2;  // bytes
    WorldUse use = {};

    // Of a sandbox, out of `most`.
    std::uint64_t for_keyframes() const;
    std::uint64_t for_undo() const;

    // Errors: what the grid takes is above `most`; a fact with both figures.
    tl::expected<void, std::string> allows(const sim::Grid& grid, bool two_materials) const;
};

// Expected peak of the whole program, bytes: reading the ground or using it, whichever takes more.
// docs/limits.md has what was measured.
std::uint64_t expected_bytes(const sim::Grid& grid, bool two_materials, const Memory& memory);

// "800M", "4G", "1073741824": bytes, or with K, M, G or T of 1024 each. Nothing where it is none of these, or
// 0.
std::optional<std::uint64_t> bytes_from(std::string_view text);
// "1.5 GiB"
std::string bytes_text(std::uint64_t bytes);

}  // namespace game
