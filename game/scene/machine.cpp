// What the machine has, and what drawing with OpenGL takes of it. The module of a page has its own (game/live/machine.cpp).
#include <unistd.h>

#include "game/scene/memory.h"
#include "render/pictures/frame_writer.h"
#include "render/woods/woods.h"

namespace game {

std::uint64_t machine_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || bytes <= 0) return 2048 * kMiB;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes);
}

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

std::uint64_t drawing_bytes(const WorldUse& use) {
    std::uint64_t bytes = frame_bytes(use.frames);
    if (!use.draws) return bytes;
    bytes += 340 * kMiB;  // OpenGL by software, shaders compiled for the first time, patterns and trees
    // Trees (render/woods/woods.h): while they are placed, as placed, with their light, and five times as drawn.
    constexpr std::uint64_t kTree = sizeof(render::Tree), kPerTree = 2 * (kTree + 12) + kTree + 16 + 5 * 80;
    return bytes + kPerTree * render::Woods::kMost;
}

}  // namespace game
