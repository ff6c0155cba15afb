#include "tests/baselines/image_baseline.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "render/pictures/png.h"
#include "tests/support/places.h"

namespace baselines {
namespace {

using render::Picture;

std::size_t at(const Picture& image, int x, int y, int channel) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(image.channels) +
           static_cast<std::size_t>(channel);
}

// The distance of a value from the range that the other image has around the same pixel: an edge that moved
// by a pixel is not far off.
int beyond_neighbours(const Picture& a, const Picture& b, int x, int y, int channel) {
    int least = 255, most = 0;
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, b.height - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, b.width - 1); ++column) {
            const int value = b.pixels[at(b, column, row, channel)];
            least = std::min(least, value), most = std::max(most, value);
        }
    const int value = a.pixels[at(a, x, y, channel)];
    return std::max({least - value, value - most, 0});
}

struct Difference {
    double mean = 0;
    int worst = 0, worst_x = 0, worst_y = 0;
    Picture image;  // eight times what differs
};

Difference difference_of(const Picture& actual, const Picture& expected) {
    Difference found;
    found.image = actual;
    double sum = 0;
    for (int y = 0; y < actual.height; ++y)
        for (int x = 0; x < actual.width; ++x)
            for (int channel = 0; channel < actual.channels; ++channel) {
                const std::size_t i = at(actual, x, y, channel);
                const int apart = std::abs(actual.pixels[i] - expected.pixels[i]);
                sum += apart;
                found.image.pixels[i] = static_cast<std::uint8_t>(std::min(8 * apart, 255));
                const int beyond = std::max(beyond_neighbours(actual, expected, x, y, channel),
                                            beyond_neighbours(expected, actual, x, y, channel));
                if (beyond > found.worst) found.worst = beyond, found.worst_x = x, found.worst_y = y;
            }
    found.mean = sum / static_cast<double>(actual.pixels.size());
    return found;
}

bool is_within(const Difference& difference, const ImageTolerance& tolerance) {
    return difference.mean <= tolerance.mean && difference.worst <= tolerance.worst;
}

bool renews() {
    const char* value = std::getenv("COULOIR_RENEW_BASELINES");
    return value && std::string(value) == "1";
}

}  // namespace

Picture read_image(const std::filesystem::path& path) {
    const auto texels = render::read_png(path, 3);
    if (!texels) return {};
    Picture image{texels->width, texels->height, {}, texels->channels};
    const auto row = static_cast<std::size_t>(texels->width * texels->channels);
    for (int y = texels->height - 1; y >= 0; --y) {
        const auto from =
            texels->values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row);
        image.pixels.insert(image.pixels.end(), from, from + static_cast<std::ptrdiff_t>(row));
    }
    return image;
}

bool are_alike(const Picture& a, const Picture& b, const ImageTolerance& tolerance) {
    return a.width == b.width && a.height == b.height && is_within(difference_of(a, b), tolerance);
}

testing::AssertionResult matches_baseline(const Picture& frame, const std::string& name,
                                          const ImageTolerance& tolerance) {
    const std::filesystem::path baseline = support::source_dir() / "tests" / "baselines" / (name + ".png");
    if (renews()) {
        const auto written = render::write_png(frame, baseline, render::kSmallestPngCompression);
        if (!written) return testing::AssertionFailure() << written.error();
        return testing::AssertionSuccess();
    }

    const std::filesystem::path left = support::build_dir() / "tests" / "baselines";
    std::filesystem::create_directories(left);
    const auto keep = [&](const char* what, const Picture& image) {
        (void)render::write_png(image, left / (name + "." + what + ".png"));
    };
    const Picture expected = read_image(baseline);
    if (expected.width != frame.width || expected.height != frame.height) {
        keep("actual", frame);
        return testing::AssertionFailure() << baseline << " is missing or has another size; "
                                           << left / (name + ".actual.png") << " has the frame";
    }
    const Difference found = difference_of(frame, expected);
    if (is_within(found, tolerance)) return testing::AssertionSuccess();
    keep("actual", frame), keep("expected", expected), keep("difference", found.image);
    return testing::AssertionFailure()
           << name << ": mean difference " << found.mean << " (at most " << tolerance.mean << "), worst "
           << found.worst << " at pixel " << found.worst_x << ", " << found.worst_y << " (at most "
           << tolerance.worst << "); see " << left;
}

}  // namespace baselines
