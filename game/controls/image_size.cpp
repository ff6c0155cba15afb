#include "game/controls/image_size.h"

#include <algorithm>
#include <cmath>

#include "game/scene/memory.h"

namespace game {
namespace {

int samples_of(bool fine) {
    return fine ? 2 : 1;
}

// The largest scale up to `scale` that is within the bounds.
double bounded(const ScreenSize& screen, double scale, bool fine, const ImageBounds& bounds) {
    const double longest = std::max(screen.width, screen.height) * samples_of(fine);
    const auto bytes = static_cast<double>(bytes_of({screen.width, screen.height, fine}));
    return std::min(
        {scale, bounds.longest_side / longest, std::sqrt(static_cast<double>(bounds.most_bytes) / bytes)});
}

}  // namespace

std::uint64_t bytes_of(const ImageSize& image) {
    return frame_bytes({image.width, image.height, samples_of(image.fine)});
}

double least_scale(Tier tier, const ScreenSize& screen, bool camera_moves) {
    const double least = camera_moves ? 640.0 * 360.0 : 1280.0 * 720.0,
                 pixels = static_cast<double>(screen.width) * screen.height;
    return std::max(info_of(tier).least_scale, std::min(std::sqrt(least / pixels), 1.0));
}

ImageSize image_for(const ScreenSize& screen, double scale, bool fine, const ImageBounds& bounds) {
    if (fine && bounded(screen, scale, fine, bounds) < scale) fine = false;
    const double fits = bounded(screen, scale, fine, bounds);
    // Rounded down where a bound decides, so that it holds.
    const auto along = [&](int pixels) {
        const double drawn = pixels * fits;
        return std::max(1, static_cast<int>(fits < scale ? std::floor(drawn) : std::lround(drawn)));
    };
    return {along(screen.width), along(screen.height), fine};
}

}  // namespace game
