#include "terrains/grey_picture.h"

#include <array>
#include <cstdint>
#include <exception>
#include <limits>
#include <new>
#include <string_view>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "files/input.h"
#include "terrains/limits.h"

namespace terrains {
namespace {

using Done = tl::expected<void, std::string>;

// The OpenImageIO format of a file with these first bytes; null if it is none that we read.
const char* format_of(std::string_view beginning) {
    using namespace std::string_view_literals;
    struct Signature {
        std::string_view bytes;
        const char* format;
    };
    constexpr std::array kSignatures{
        Signature{"\x89PNG"sv, "png"},
        Signature{"II*\0"sv, "tiff"},
        Signature{"MM\0*"sv, "tiff"},
        Signature{"II+\0"sv, "tiff"},
        Signature{"MM\0+"sv, "tiff"},
        Signature{"\x76\x2f\x31\x01"sv, "openexr"},
        Signature{"\xff\xd8\xff"sv, "jpeg"},
        Signature{"BM"sv, "bmp"},
        Signature{"P1"sv, "pnm"},
        Signature{"P2"sv, "pnm"},
        Signature{"P3"sv, "pnm"},
        Signature{"P4"sv, "pnm"},
        Signature{"P5"sv, "pnm"},
        Signature{"P6"sv, "pnm"},
        Signature{"PF"sv, "pnm"},
        Signature{"Pf"sv, "pnm"},
    };
    for (const Signature& signature : kSignatures)
        if (beginning.starts_with(signature.bytes)) return signature.format;
    return nullptr;
}

Done check_picture(const OIIO::ImageSpec& spec) {
    constexpr auto kMostPixels = static_cast<double>(kMostHeightmapPixels);
    if (spec.width < 2 || spec.height < 2 || static_cast<double>(spec.width) * spec.height > kMostPixels)
        return tl::unexpected(
            fmt::format("{} × {} pixels; a heightmap has at least 2 along each side and at most 100 million",
                        spec.width, spec.height));
    // OpenImageIO reads whole tiles, even if little of them is in the image.
    if (static_cast<double>(spec.tile_width) * spec.tile_height > kMostPixels || spec.depth > 1)
        return tl::unexpected(fmt::format("tiles of {} × {} pixels exceed the limit for heightmaps",
                                          spec.tile_width, spec.tile_height));
    if (spec.nchannels > kMostHeightmapChannels)
        return tl::unexpected(fmt::format("{} channels; a heightmap must be grey", spec.nchannels));
    if (spec.format == OIIO::TypeDesc::HALF)
        return tl::unexpected<std::string>(
            "half floats, whose steps are metres at a mountain's height; convert it");
    return {};
}

// The first channel of every pixel as 0 to 1, read in the file's own type.
template <class Stored>
Done read_as(OIIO::ImageInput& input, std::vector<float>& brightness) {
    const OIIO::ImageSpec& spec = input.spec();
    std::vector<Stored> pixels(static_cast<std::size_t>(spec.width) * spec.height);
    if (!input.read_image(0, 0, 0, 1, OIIO::BaseTypeFromC<Stored>::value, pixels.data()))
        return tl::unexpected(fmt::format("damaged or cut short ({})", input.geterror()));
    brightness.resize(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        double value = static_cast<double>(pixels[i]);
        if constexpr (std::numeric_limits<Stored>::is_integer) value /= std::numeric_limits<Stored>::max();
        if (!(value >= 0 && value <= 1))
            return tl::unexpected(fmt::format("row {}, column {} is {}; brightness must be 0 to 1",
                                              i / spec.width + 1, i % spec.width + 1, value));
        brightness[i] = static_cast<float>(value);
    }
    return {};
}

Done read_brightness(OIIO::ImageInput& input, std::vector<float>& brightness) {
    switch (input.spec().format.basetype) {
        case OIIO::TypeDesc::UINT8:
            return read_as<std::uint8_t>(input, brightness);
        case OIIO::TypeDesc::UINT16:
            return read_as<std::uint16_t>(input, brightness);
        case OIIO::TypeDesc::UINT32:
            return read_as<std::uint32_t>(input, brightness);
        case OIIO::TypeDesc::FLOAT:
            return read_as<float>(input, brightness);
        default:
            return tl::unexpected(fmt::format("pixels of type {}; a heightmap has 8, 16 or 32 bits or floats",
                                              input.spec().format.c_str()));
    }
}

tl::expected<GreyPicture, std::string> read(const std::filesystem::path& path) {
    auto file = files::open_input(path);
    if (!file) return tl::unexpected(file.error());
    const auto bad = [&path](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
    };
    std::string beginning(8, ' ');
    file->read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    const char* format = format_of(beginning);
    if (format == nullptr) return bad("not a readable image; use PNG, TIFF, PNM, OpenEXR, JPEG or BMP");
    const auto input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    if (!input || !input->open(path.string(), spec))
        return bad(fmt::format("not a readable image ({})", input ? input->geterror() : OIIO::geterror()));
    if (auto fits = check_picture(spec); !fits) return bad(fits.error());
    GreyPicture picture{spec.width, spec.height, {}, spec.get_string_attribute("Copyright")};
    if (auto done = read_brightness(*input, picture.brightness); !done) return bad(done.error());
    return picture;
}

}  // namespace

// Catches exceptions, because OpenImageIO throws on some damage.
tl::expected<GreyPicture, std::string> read_grey_picture(const std::filesystem::path& path) try {
    return read(path);
} catch (const std::bad_alloc&) {
    throw;  // out of memory is not the file's fault
} catch (const std::exception& thrown) {
    return tl::unexpected(fmt::format("{}: not a readable image ({})", path.string(), thrown.what()));
}

}  // namespace terrains

// grey_picture_door.cpp finds this symbol by name.
extern "C" {
[[gnu::visibility("default")]] extern const decltype(&terrains::read_grey_picture) couloir_read_grey_picture;
const decltype(&terrains::read_grey_picture) couloir_read_grey_picture = terrains::read_grey_picture;
}
