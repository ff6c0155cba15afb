#include "game/recording/base64.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace game {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kStrange = 64;

// The six bits of each letter.
constexpr auto kBits = [] {
    std::array<std::uint8_t, 256> bits{};
    bits.fill(kStrange);
    for (std::size_t i = 0; i < kLetters.size(); ++i)
        bits[static_cast<unsigned char>(kLetters[i])] = static_cast<std::uint8_t>(i);
    return bits;
}();

}  // namespace

std::string to_base64(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    std::uint32_t bits = 0;
    int pending = 0;  // bits
    std::size_t end = 0;
    for (const char byte : bytes) {
        bits = bits << 8 | static_cast<unsigned char>(byte);
        for (pending += 8; pending >= 6; pending -= 6) text[end++] = kLetters[bits >> (pending - 6) & 63];
    }
    if (pending > 0) text[end] = kLetters[bits << (6 - pending) & 63];
    return text;
}

std::optional<std::string> from_base64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    int pending = 0;
    for (const char letter : text) {
        const std::uint8_t six = kBits[static_cast<unsigned char>(letter)];
        if (six == kStrange) return std::nullopt;
        bits = bits << 6 | six;
        pending += 6;
        if (pending < 8) continue;
        pending -= 8;
        bytes.push_back(static_cast<char>(bits >> pending & 255));
    }
    if ((bits & ((1u << pending) - 1)) != 0) return std::nullopt;
    return bytes;
}

}  // namespace game
