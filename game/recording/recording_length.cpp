#include "game/recording/recording_length.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include "game/base/limits.h"
#include "game/base/number.h"
#include "game/recording/format.h"
#include "terrains/json_reader.h"

namespace game {
namespace {

// Of a header, in which the parameters come before the ground. No text in it can have these bytes: its quotes have backslashes.
std::optional<double> tick_of(std::string_view beginning) {
    constexpr std::string_view kName = "\"tick_s\":";
    const std::size_t at = beginning.find(kName);
    if (at == beginning.npos) return std::nullopt;
    const std::string_view rest = beginning.substr(at + kName.size());
    const auto tick = number_from<double>(rest.substr(0, rest.find_first_of(",}")));
    return tick && *tick > 0 ? tick : std::nullopt;
}

// Of the last whole line.
std::optional<std::int64_t> ticks_of(std::string_view ending) {
    const std::size_t end = ending.rfind('\n');
    if (end == ending.npos) return std::nullopt;
    const std::size_t before = ending.substr(0, end).rfind('\n');
    if (before == ending.npos) return std::nullopt;
    const auto json = terrains::read_json<Json>(ending.substr(before + 1, end - before - 1), kLineLimits);
    if (!json || !json->is_object()) return std::nullopt;
    for (const char* name : {"end", "tick"})
        if (const auto tick = json->find(name); tick != json->end() && tick->is_number_integer())
            return tick->get<std::int64_t>();
    return std::nullopt;
}

}  // namespace

std::optional<double> length_of_recording(const std::filesystem::path& path) {
    constexpr std::streamoff kBeginning = 1 << 12, kEnding = 1 << 16;  // bytes
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    if (!file || size <= 0) return std::nullopt;
    const auto read = [&](std::streamoff from, std::streamoff bytes) {
        std::string text(static_cast<std::size_t>(bytes), '\0');
        file.seekg(from);
        file.read(text.data(), bytes);
        return text;
    };
    const auto tick = tick_of(read(0, std::min(size, kBeginning)));
    const std::streamoff bytes = std::min(size, kEnding);
    const auto ticks = ticks_of(read(size - bytes, bytes));
    if (!file || !tick || !ticks || *ticks < 0) return std::nullopt;
    return *tick * static_cast<double>(*ticks);
}

}  // namespace game
