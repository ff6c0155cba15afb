#include "tests/window/screenshot.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "tests/game/program.h"

namespace game::test {
namespace {

// Words of an XWD header, four bytes each, most significant first.
enum Word {
    kHeaderBytes = 0,
    kWidth = 4,
    kHeight = 5,
    kByteOrder = 7,
    kBitsPerPixel = 11,
    kBytesPerLine = 12,
    kColours = 19
};
constexpr std::size_t kColourBytes = 12;

std::size_t word(const std::string& bytes, Word which) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes.at(static_cast<std::size_t>(which) * 4 + i));
    return value;
}

std::size_t at(const render::Picture& picture, int x, int y) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
            static_cast<std::size_t>(x)) *
           3;
}

}  // namespace

render::Picture read_screen(const std::filesystem::path& file, int x, int y, int width, int height) {
    const std::string bytes = read_bytes(file);
    if (bytes.size() < 100 || word(bytes, kBitsPerPixel) != 32 || word(bytes, kByteOrder) != 0)
        throw std::runtime_error(file.string() + " is no screen of 24 bit");
    const std::size_t begin = word(bytes, kHeaderBytes) + word(bytes, kColours) * kColourBytes;
    const int screen_width = static_cast<int>(word(bytes, kWidth));
    const int screen_height = static_cast<int>(word(bytes, kHeight));
    render::Picture picture{width, height, {}};
    picture.pixels.resize(at(picture, 0, height));
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            if (x + column < 0 || x + column >= screen_width || y + row < 0 || y + row >= screen_height)
                continue;
            const std::size_t from = begin + static_cast<std::size_t>(y + row) * word(bytes, kBytesPerLine) +
                                     static_cast<std::size_t>(x + column) * 4;
            for (std::size_t channel = 0; channel < 3; ++channel)  // stored blue, green, red
                picture.pixels[at(picture, column, row) + channel] =
                    static_cast<std::uint8_t>(bytes.at(from + 2 - channel));
        }
    return picture;
}

double difference(const render::Picture& a, const render::Picture& b, int least) {
    if (a.width != b.width || a.height != b.height) return 1;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        int most = 0;
        for (std::size_t channel = i; channel < i + 3; ++channel)
            most = std::max(most, std::abs(a.pixels[channel] - b.pixels[channel]));
        differing += most > least;
    }
    return a.pixels.empty() ? 0 : 3.0 * static_cast<double>(differing) / static_cast<double>(a.pixels.size());
}

render::Picture middle(const render::Picture& picture, double part) {
    const int width = static_cast<int>(picture.width * part),
              height = static_cast<int>(picture.height * part);
    const int left = (picture.width - width) / 2, top = (picture.height - height) / 2;
    render::Picture cut{width, height, {}};
    for (int row = 0; row < height; ++row) {
        const auto begin = picture.pixels.begin() + static_cast<std::ptrdiff_t>(at(picture, left, top + row));
        cut.pixels.insert(cut.pixels.end(), begin, begin + width * 3);
    }
    return cut;
}

}  // namespace game::test
