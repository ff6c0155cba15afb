#include "tests/game/unpacked_page.h"

#include <zlib.h>

#include <array>
#include <cstddef>
#include <stdexcept>

#include "game/recording/base64.h"

namespace game::test {
namespace {

std::uint32_t unzigzag(std::uint32_t e) {
    return (e >> 1) ^ (~(e & 1) + 1);
}

std::uint8_t byte_at(const std::string& part, std::size_t i) {
    return static_cast<std::uint8_t>(part.at(i));
}

}  // namespace

std::string unzipped(const std::string& bytes) {
    z_stream stream{};
    if (inflateInit2(&stream, 15 + 16) != Z_OK) return {};
    std::vector<unsigned char> in(bytes.begin(), bytes.end());
    stream.next_in = in.data();
    stream.avail_in = static_cast<uInt>(in.size());
    std::string plain;
    int status = Z_OK;
    while (status == Z_OK) {
        std::array<unsigned char, 65536> out;
        stream.next_out = out.data();
        stream.avail_out = static_cast<uInt>(out.size());
        status = inflate(&stream, Z_NO_FLUSH);
        plain.append(out.begin(), out.end() - static_cast<std::ptrdiff_t>(stream.avail_out));
    }
    inflateEnd(&stream);
    return status == Z_STREAM_END ? plain : std::string();
}

std::string script_of(const std::string& html, std::string_view id) {
    const std::size_t named = html.find("id=\"" + std::string(id) + "\"");
    if (named == std::string::npos) throw std::runtime_error("no element " + std::string(id));
    const std::size_t begin = html.find('>', named) + 1;
    return html.substr(begin, html.find("</script>", begin) - begin);
}

UnpackedPage::UnpackedPage(const std::string& html) : info_(Json::parse(script_of(html, "slide"))) {
    split(info_["parts"], unzipped(from_base64(script_of(html, "fields")).value()));
}

UnpackedPage::UnpackedPage(const Json& parts, const Json& arrays, const std::string& plain) {
    info_["arrays"] = arrays;
    split(parts, plain);
}

void UnpackedPage::split(const Json& parts, const std::string& plain) {
    std::size_t at = 0;
    for (const Json& part : parts) {
        const auto size = part[1].get<std::size_t>();
        if (at + size > plain.size()) throw std::runtime_error("the stream ends within a part");
        parts_[part[0]] += plain.substr(at, size);
        at += size;
    }
    if (at != plain.size()) throw std::runtime_error("the stream goes on after its parts");
}

std::vector<double> UnpackedPage::array(const std::string& name) const {
    const Json& rule = info_["arrays"].at(name);
    std::size_t count = 1;
    for (const Json& side : rule["size"]) count *= side.get<std::size_t>();
    const auto planes = rule["planes"].get<std::size_t>();
    const auto width = rule["size"][0].get<std::size_t>();
    const std::string predict = rule["predict"];
    const std::uint32_t mask = planes == 4 ? ~0u : (1u << 8 * planes) - 1;
    std::vector<std::uint32_t> q(count);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t e = 0;
        for (std::size_t plane = 0; plane < planes; ++plane)
            e |= static_cast<std::uint32_t>(byte_at(part(name + "." + std::to_string(plane)), i))
                 << 8 * plane;
        std::uint32_t expected = 0;
        if (predict == "last" && i > 0) expected = q[i - 1];
        if (predict == "plane") {
            const bool west = i % width > 0, south = i >= width;
            expected =
                (west ? q[i - 1] : 0) + (south ? q[i - width] : 0) - (west && south ? q[i - width - 1] : 0);
        }
        q[i] = (unzigzag(e) + expected) & mask;
        values[i] = rule["zero"].get<double>() + rule["step"].get<double>() * q[i];
    }
    return values;
}

std::vector<std::uint16_t> UnpackedPage::moving(const std::string& name, int nx, int ny, std::int64_t frame,
                                                std::vector<std::uint16_t> q) const {
    const int across = (nx + 7) / 8, tiles = across * ((ny + 7) / 8), bytes = (tiles + 7) / 8;
    const std::string &map = part(name + ".map"), &low = part(name + ".0"), &high = part(name + ".1");
    std::size_t at = 0;
    for (std::int64_t f = 0; f <= frame; ++f)
        for (int tile = 0; tile < tiles; ++tile) {
            const std::uint8_t bits = byte_at(map, static_cast<std::size_t>(f * bytes + tile / 8));
            if (!(bits >> tile % 8 & 1)) continue;
            for (int k = 0; k < 64; ++k, ++at) {
                const int x = tile % across * 8 + k % 8, y = tile / across * 8 + k / 8;
                const std::uint32_t e = byte_at(low, at) | static_cast<std::uint32_t>(byte_at(high, at)) << 8;
                if (x >= nx || y >= ny) {
                    if (e != 0) throw std::runtime_error("a change outside the grid");
                    continue;
                }
                std::uint16_t& value = q[static_cast<std::size_t>(y * nx + x)];
                value = static_cast<std::uint16_t>(value + unzigzag(e));
            }
        }
    return q;
}

}  // namespace game::test
