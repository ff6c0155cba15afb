#include "game/recording/ground_data.h"

#include <bit>
#include <cmath>
#include <cstring>

#include <zstd.h>

#include "game/recording/base64.h"

namespace game {
namespace {

static_assert(std::endian::native == std::endian::little, "a recording's ground is little-endian");

// In the order in which they are packed.
template <class S>
auto floats_of(S& start) {
    std::vector<decltype(&start.bedrock)> fields{&start.bedrock, &start.depth, &start.rolling};
    if (start.lower) fields.push_back(&start.lower->depth);
    return fields;
}

std::size_t packed_size(const Start& start) {
    return start.grid.size() * (floats_of(start).size() * sizeof(float) + 1);
}

bool all_within(const std::vector<float>& values, float least, float most) {
    for (const float value : values)
        if (!(value >= least && value <= most)) return false;  // NaN too
    return true;
}

}  // namespace

std::string pack_ground(const Start& start) {
    std::string bytes;
    bytes.reserve(packed_size(start));
    for (const std::vector<float>* field : floats_of(start))
        bytes.append(reinterpret_cast<const char*>(field->data()), field->size() * sizeof(float));
    bytes.append(reinterpret_cast<const char*>(start.has_data.data()), start.has_data.size());

    constexpr int kBrisk = 6;  // a person waits for it at every reset; 19 would take twenty times as long
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kBrisk));
    return to_base64(packed);
}

tl::expected<void, std::string> unpack_ground(std::string_view text, Start& start) {
    const auto packed = from_base64(text);
    const std::size_t vertices = start.grid.size();
    // Before that much memory is asked for.
    if (!packed || ZSTD_getFrameContentSize(packed->data(), packed->size()) != packed_size(start))
        return tl::unexpected(std::string("terrain data that does not unpack"));
    std::string bytes(packed_size(start), '\0');
    const std::size_t size = ZSTD_decompress(bytes.data(), bytes.size(), packed->data(), packed->size());
    if (ZSTD_isError(size) || size != bytes.size())
        return tl::unexpected(std::string("terrain data that does not unpack"));

    const char* at = bytes.data();
    for (std::vector<float>* field : floats_of(start)) {
        field->resize(vertices);
        std::memcpy(field->data(), at, vertices * sizeof(float));
        at += vertices * sizeof(float);
    }
    start.has_data.assign(at, at + vertices);

    constexpr float kHighest = 20000;
    const float deepest = sim::kDeepest / 2;
    if (!all_within(start.bedrock, -kHighest, kHighest) || !all_within(start.depth, 0, deepest) ||
        !all_within(start.rolling, 0, deepest) ||
        (start.lower && !all_within(start.lower->depth, 0, deepest)))
        return tl::unexpected(std::string("a terrain with impossible heights or depths"));
    return {};
}

}  // namespace game
