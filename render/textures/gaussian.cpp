#include "render/textures/gaussian.h"

#include <algorithm>

namespace render {
namespace {

// Share of a Gaussian of mean 0.5 and deviation 1/6 below a byte, which may be fractional.
double share_below(double byte) {
    return normal_share_below(6 * (byte / 255 - 0.5));
}

}  // namespace

double normal_share_below(double x) {
    constexpr double kRootOfTwoPi = 2.5066282746310002;
    double term = x, sum = x;
    for (int n = 1; n < 80; ++n) {
        term *= -x * x / (2 * n);
        sum += term / (2 * n + 1);
    }
    return 0.5 + sum / kRootOfTwoPi;
}

Gaussian gaussianise(const Tile& raw) {
    std::vector<float> sorted = raw.heights;
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    std::array<double, 255> steps{};  // shares at which the byte increases by one
    for (int byte = 0; byte < 255; ++byte) steps[static_cast<std::size_t>(byte)] = share_below(byte + 0.5);

    Gaussian gaussian;
    for (const float height : raw.heights) {
        const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), height);
        const double rank =
            0.5 * static_cast<double>((first - sorted.begin()) + (last - sorted.begin())) / count;
        gaussian.bytes.push_back(
            static_cast<std::uint8_t>(std::upper_bound(steps.begin(), steps.end(), rank) - steps.begin()));
    }
    for (std::size_t byte = 0; byte < 256; ++byte)
        gaussian.raw[byte] = sorted[static_cast<std::size_t>(share_below(static_cast<double>(byte)) * count)];
    return gaussian;
}

}  // namespace render
