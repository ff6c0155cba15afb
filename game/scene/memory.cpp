#include "game/scene/memory.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "game/base/number.h"

namespace game {

std::uint64_t Memory::for_keyframes() const {
    return std::min(384 * kMiB, most / 16 * 3);
}
std::uint64_t Memory::for_undo() const {
    return std::min(128 * kMiB, most / 16);
}

std::uint64_t expected_bytes(const sim::Grid& grid, bool two_materials, const Memory& memory,
                             bool has_things) {
    // Bytes per vertex, measured (docs/results/costs.md#memory).
    const WorldUse& use = memory.use;
    const std::uint64_t reading = 130;
    // Things (sim/world/things.h): fields and the numbers of vertices in a world, and the forest, earth and water of a start.
    const std::uint64_t things = has_things || use.goes_back ? 76 : 0;
    const std::uint64_t start = (two_materials ? 70 : 50) + (things > 0 ? 14 : 0);
    const std::uint64_t session = (two_materials ? 322 : 77) + things;
    const std::uint64_t run = (two_materials ? 235 : 55) + things;
    std::uint64_t using_it = start + session * static_cast<std::uint64_t>(use.sessions) +
                             run * static_cast<std::uint64_t>(use.runs);
    if (use.draws) using_it += grid.size() <= kMostFollowed ? 1020 : 280;
    std::uint64_t bytes = 60 * kMiB + std::max(reading, using_it) * grid.size();
    bytes += drawing_bytes(use);
    // Per vertex as measured on 2048 by 2048 squares; mountains and trees around, and a page of 32 MB with its parts.
    if (use.page) bytes += 230 * grid.size() + 140 * kMiB;
    if (use.goes_back) bytes += memory.for_keyframes() + memory.for_undo();
    return bytes;
}

tl::expected<void, std::string> Memory::allows(const sim::Grid& grid, bool two_materials,
                                               bool has_things) const {
    const std::uint64_t expected = expected_bytes(grid, two_materials, *this, has_things);
    if (expected <= most) return {};
    const std::string images = use.frames.width > 0 ? fmt::format(" and images of {} by {} pixels",
                                                                  use.frames.width, use.frames.height)
                                                    : "";
    return tl::unexpected(
        fmt::format("{} by {} vertices{} need about {} of memory, and {} is allowed; raise --max-memory",
                    grid.nx, grid.ny, images, bytes_text(expected), bytes_text(most)));
}

std::optional<std::uint64_t> bytes_from(std::string_view text) {
    constexpr std::string_view kUnits = "KMGT";
    const auto power = text.empty() ? kUnits.npos : kUnits.find(text.back());
    const bool has_unit = power != kUnits.npos;
    if (has_unit) text.remove_suffix(1);
    const auto shift = has_unit ? 10 * (power + 1) : 0;
    const auto number = number_from<std::uint64_t>(text);
    if (!number || *number == 0 || *number > std::numeric_limits<std::uint64_t>::max() >> shift)
        return std::nullopt;
    return *number << shift;
}

std::string bytes_text(std::uint64_t bytes) {
    const bool large = bytes >= 1024 * kMiB;
    return fmt::format("{:.1f} {}",
                       static_cast<double>(bytes) / static_cast<double>(large ? 1024 * kMiB : kMiB),
                       large ? "GiB" : "MiB");
}

}  // namespace game
