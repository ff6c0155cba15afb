#include "game/scene/memory.h"

#include <unistd.h>

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "game/base/number.h"
#include "render/pictures/frame_writer.h"
#include "render/woods/woods.h"

namespace game {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

}  // namespace

// Buffers of a frame (render/passes/target.h and render/passes/flow_pass.h), and images on their way to a file.
std::uint64_t frame_bytes(const FrameUse& frames) {
    constexpr std::uint64_t kDepth = 4, kLinear = 8, kScreen = 4;  // per sample or pixel: 32F, RGBA16F, RGBA8
    // Depth, that of the ground, the flow's albedo and relief, and what is drawn over by what floats in the air.
    constexpr std::uint64_t kPerSample = 2 * kDepth + 3 * kLinear;
    // One image that was read back, those that wait, and for each worker one being encoded and three times an
    // image for the bytes of the file while they grow.
    constexpr std::uint64_t kImage = 3, kWait = render::FrameWriter::kCapacity;
    constexpr std::uint64_t kImages = 1 + kWait + (1 + 3) * render::FrameWriter::kMostWorkers;
    const auto along_edge = static_cast<std::uint64_t>(frames.samples), samples = along_edge * along_edge;
    const std::uint64_t colours = samples > 1 ? (samples + 1) * kLinear : kLinear;
    constexpr std::uint64_t kSmoothing = kScreen + 1;  // the image with stairs, and a stencil of edges
    // Powder (render/passes/powder_pass.h): reach, thickness, mixture, light and what hides it, at half the resolution.
    const std::uint64_t powder = samples * (4 + 2 * kLinear + 18) / 4;
    // The coarse ground of a moving frame (render/passes/coarse_ground.h), which has one sample per pixel: a target of a
    // quarter as many.
    const std::uint64_t coarse = (2 * kDepth + 2 * kLinear + kScreen + kSmoothing) / 4;
    return (samples * kPerSample + colours + coarse + powder + kScreen + kSmoothing + kImages * kImage) *
           static_cast<std::uint64_t>(frames.width) * static_cast<std::uint64_t>(frames.height);
}

std::uint64_t machine_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || bytes <= 0) return 2048 * kMiB;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes);
}

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
    // Things (sim/world/things.h): fields and the numbers of vertices in a world, and the forest and earth of a start.
    const std::uint64_t things = has_things || use.goes_back ? 72 : 0;
    const std::uint64_t start = (two_materials ? 70 : 50) + (things > 0 ? 10 : 0);
    const std::uint64_t session = (two_materials ? 322 : 77) + things;
    const std::uint64_t run = (two_materials ? 235 : 55) + things;
    std::uint64_t using_it = start + session * static_cast<std::uint64_t>(use.sessions) +
                             run * static_cast<std::uint64_t>(use.runs);
    if (use.draws) using_it += grid.size() <= kMostFollowed ? 1020 : 280;
    std::uint64_t bytes = 60 * kMiB + std::max(reading, using_it) * grid.size();
    if (use.draws) bytes += 244 * kMiB;  // OpenGL by software, shaders, patterns and trees
    // Trees (render/woods/woods.h): while they are placed, as placed, with their light, and five times as drawn.
    constexpr std::uint64_t kTree = sizeof(render::Tree), kPerTree = 2 * (kTree + 12) + kTree + 16 + 5 * 80;
    if (use.draws) bytes += kPerTree * render::Woods::kMost;
    bytes += frame_bytes(use.frames);
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
