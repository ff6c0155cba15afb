#include "render/pictures/png.h"

#include <algorithm>

#include <benchmark/benchmark.h>

#include "tests/support/places.h"

// Processor time to encode a frame of 1280×720 pixels as a PNG, and the size of the file, by compression.

namespace bench {
namespace {

render::Picture shipped_frame() {
    const auto texels = render::read_png(support::source_dir() / "assets/pictures/snow-debris.png", 3);
    if (!texels) return {};
    render::Picture picture{texels->width, texels->height, texels->values};
    const auto row = 3 * static_cast<std::ptrdiff_t>(picture.width);
    for (int y = 0; y < picture.height / 2; ++y)  // texels have the lowest row first
        std::swap_ranges(picture.pixels.begin() + y * row, picture.pixels.begin() + (y + 1) * row,
                         picture.pixels.end() - (y + 1) * row);
    return picture;
}

void encode(benchmark::State& state, const render::PngCompression& compression) {
    const render::Picture picture = shipped_frame();
    if (picture.pixels.empty()) return state.SkipWithError("assets/pictures/snow-debris.png cannot be read");
    std::size_t bytes = 0;
    while (state.KeepRunning()) {
        const auto file = render::encode_png(picture, compression, {});
        if (!file) return state.SkipWithError(file.error().c_str());
        bytes = file->size();
    }
    state.counters["kB"] = static_cast<double>(bytes) / 1000;
}

BENCHMARK_CAPTURE(encode, frame, render::kFramePngCompression)
    ->Name("png, frame of a run")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(encode, single, render::kFastPngCompression)
    ->Name("png, single image")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(encode, smallest, render::kSmallestPngCompression)
    ->Name("png, smallest")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bench
