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
    if (spec.alpha_channel == 0 || (spec.nchannels == 2 && spec.alpha_channel != 1))
        return tl::unexpected<std::string>(
            "its channels are not grey, or grey and an opacity; a heightmap must be grey");
    if (const int orientation = spec.get_int_attribute("Orientation", 1); orientation != 1)
        return tl::unexpected(
            fmt::format("states that it is to be shown turned or mirrored (orientation {}); save it upright",
                        orientation));
    if (spec.format == OIIO::TypeDesc::HALF)
        return tl::unexpected<std::string>(
            "half floats, whose steps are metres at a mountain's height; convert it");
    return {};
}

// The grey of every pixel as 0 to 1, read in the file's own type; NaN where it is transparent.
template <class Stored>
Done read_as(OIIO::ImageInput& input, std::vector<float>& brightness) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    // Grey was multiplied by opacity, and divided again it would be coarser than it looks.
    const bool multiplied = channels == 2 && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<Stored> pixels(count * channels);
    const bool read =
        input.read_image(0, 0, 0, spec.nchannels, OIIO::BaseTypeFromC<Stored>::value, pixels.data());
    // Lost strips of a TIFF are read as black, and each leaves a line here.
    if (const std::string faults = input.geterror(); !read || !faults.empty())
        return tl::unexpected(fmt::format("damaged or cut short ({})", faults.substr(0, faults.find('\n'))));
    constexpr bool kWhole = std::numeric_limits<Stored>::is_integer;
    constexpr double kWhite = kWhole ? static_cast<double>(std::numeric_limits<Stored>::max()) : 1;
    const auto at = [&](std::size_t i) {
        return fmt::format("row {}, column {}", i / static_cast<std::size_t>(spec.width) + 1,
                           i % static_cast<std::size_t>(spec.width) + 1);
    };
    brightness.resize(count);
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        const double value = static_cast<double>(pixels[channels * i]) / kWhite;
        const double opacity = channels == 2 ? static_cast<double>(pixels[2 * i + 1]) / kWhite : 1;
        if (!(opacity > 0)) {
            brightness[i] = std::numeric_limits<float>::quiet_NaN();
            continue;
        }
        if (multiplied && opacity < 1)
            return tl::unexpected(fmt::format(
                "{} is partly transparent, which makes its grey darker in this format; remove the opacity",
                at(i)));
        if (!(value >= 0 && value <= 1))
            return tl::unexpected(fmt::format("{} is {}; brightness must be 0 to 1", at(i), value));
        brightness[i] = static_cast<float>(value);
        any = true;
    }
    if (!any) return tl::unexpected<std::string>("all of its pixels are transparent");
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
    OIIO::ImageSpec spec, wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);  // or else grey is multiplied by opacity
    if (!input || !input->open(path.string(), spec, wanted))
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
