#include "game/recording/ground_data.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include <zstd.h>

#include "game/recording/base64.h"

namespace game {
namespace {

static_assert(std::endian::native == std::endian::little, "a recording's ground is little-endian");

// The fields in the order in which they are packed.
template <class S>
auto floats_of(S& scenario) {
    std::vector<decltype(&scenario.bedrock)> fields{&scenario.bedrock, &scenario.depth, &scenario.rolling};
    if (scenario.lower) fields.push_back(&scenario.lower->depth);
    return fields;
}

std::size_t packed_size(const Scenario& scenario) {
    return scenario.grid.size() * (floats_of(scenario).size() * sizeof(float) + 1);
}

bool all_within(const std::vector<float>& values, float least, float most) {
    for (const float value : values)
        if (!(value >= least && value <= most)) return false;  // also refuses NaN
    return true;
}

std::string pack(std::string_view bytes) {
    constexpr int kBrisk =
        6;  // zstd level: a user waits for it at every reset, and 19 would take twenty times as long
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kBrisk));
    return to_base64(packed);
}

// Nothing if the text is not that of `count` bytes, which is checked before so much memory is allocated.
std::optional<std::string> unpack(std::string_view text, std::size_t count) {
    const auto packed = from_base64(text);
    if (!packed || ZSTD_getFrameContentSize(packed->data(), packed->size()) != count) return std::nullopt;
    std::string bytes(count, '\0');
    const std::size_t size = ZSTD_decompress(bytes.data(), bytes.size(), packed->data(), packed->size());
    if (ZSTD_isError(size) || size != count) return std::nullopt;
    return bytes;
}

}  // namespace

std::string pack_ground(const Scenario& scenario) {
    std::string bytes;
    bytes.reserve(packed_size(scenario));
    for (const std::vector<float>* field : floats_of(scenario))
        bytes.append(reinterpret_cast<const char*>(field->data()), field->size() * sizeof(float));
    bytes.append(reinterpret_cast<const char*>(scenario.has_data.data()), scenario.has_data.size());

    return pack(bytes);
}

tl::expected<void, std::string> unpack_ground(std::string_view text, Scenario& scenario) {
    const std::size_t vertices = scenario.grid.size();
    const auto bytes = unpack(text, packed_size(scenario));
    if (!bytes) return tl::unexpected(std::string("terrain data that cannot be unpacked"));

    const char* at = bytes->data();
    for (std::vector<float>* field : floats_of(scenario)) {
        field->resize(vertices);
        std::memcpy(field->data(), at, vertices * sizeof(float));
        at += vertices * sizeof(float);
    }
    scenario.has_data.assign(at, at + vertices);

    constexpr float kHighest = 20000;
    const float deepest = sim::kDeepest / 2;
    if (!all_within(scenario.bedrock, -kHighest, kHighest) || !all_within(scenario.depth, 0, deepest) ||
        !all_within(scenario.rolling, 0, deepest) ||
        (scenario.lower && !all_within(scenario.lower->depth, 0, deepest)))
        return tl::unexpected(std::string("a terrain with impossible heights or depths"));
    return {};
}

std::string pack_bytes(std::span<const std::uint8_t> bytes) {
    return pack({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

tl::expected<std::vector<std::uint8_t>, std::string> unpack_bytes(std::string_view text, std::size_t count) {
    const auto bytes = unpack(text, count);
    if (!bytes) return tl::unexpected(std::string("a map that cannot be unpacked"));
    return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

std::string pack_metres(std::span<const float> metres) {
    return pack({reinterpret_cast<const char*>(metres.data()), metres.size_bytes()});
}

tl::expected<std::vector<float>, std::string> unpack_metres(std::string_view text, std::size_t vertices) {
    const auto bytes = unpack(text, vertices * sizeof(float));
    if (!bytes) return tl::unexpected(std::string("a field that cannot be unpacked"));
    std::vector<float> metres(vertices);
    std::memcpy(metres.data(), bytes->data(), bytes->size());
    for (const float each : metres)
        if (!std::isfinite(each)) return tl::unexpected(std::string("a field with impossible values"));
    return metres;
}

namespace {

constexpr std::size_t kBytesPerStems = 6;

bool is_possible(const sim::Stems& stems) {
    if (stems.standing > sim::kMostStems || stems.lying > sim::kMostStems) return false;
    if (stems.standing == 0 && stems.lying == 0) return stems == sim::Stems();
    return stems.diameter_cm >= sim::kLeastStemCm && stems.diameter_cm <= sim::kMostStemCm &&
           stems.height_m >= sim::kLeastTreeM && stems.height_m <= sim::kMostTreeM;
}

}  // namespace

std::string pack_forest(std::span<const sim::Stems> forest) {
    std::string bytes;
    bytes.reserve(forest.size() * kBytesPerStems);
    const auto add = [&](unsigned value) { bytes.push_back(static_cast<char>(value)); };
    for (const sim::Stems& each : forest) add(each.standing & 255u), add(each.standing / 256u);
    for (const sim::Stems& each : forest) add(each.lying & 255u), add(each.lying / 256u);
    for (const sim::Stems& each : forest) add(each.diameter_cm);
    for (const sim::Stems& each : forest) add(each.height_m);
    return pack(bytes);
}

tl::expected<std::vector<sim::Stems>, std::string> unpack_forest(std::string_view text,
                                                                 std::size_t vertices) {
    const auto bytes = unpack(text, vertices * kBytesPerStems);
    if (!bytes) return tl::unexpected(std::string("a forest that cannot be unpacked"));
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>((*bytes)[at]); };
    const auto two = [&](std::size_t at) {
        return static_cast<std::uint16_t>(byte(at) + 256 * byte(at + 1));
    };
    std::vector<sim::Stems> forest(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        forest[i] = {two(2 * i), two(2 * (vertices + i)), byte(4 * vertices + i), byte(5 * vertices + i)};
        if (!is_possible(forest[i])) return tl::unexpected(std::string("a forest with impossible stems"));
    }
    return forest;
}

}  // namespace game
