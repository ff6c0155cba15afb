#include "game/base/one_line.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

namespace game {
namespace {

struct CodeRange {
    char32_t first, last;
};
// Beside controls below U+00A0 and the last two code points of each plane. Unicode 15: the category Cf, the
// separators of lines and paragraphs, blank letters, and U+FDD0 to U+FDEF.
constexpr auto kHidden = std::to_array<CodeRange>({
    {0x00ad, 0x00ad},                        // soft hyphen
    {0x034f, 0x034f},                        // grapheme joiner
    {0x0600, 0x0605},                        // Arabic number signs
    {0x061c, 0x061c},                        // Arabic letter mark
    {0x06dd, 0x06dd},                        // Arabic end of ayah
    {0x070f, 0x070f},                        // Syriac abbreviation mark
    {0x0890, 0x0891},                        // Arabic pound and piastre marks
    {0x08e2, 0x08e2},                        // Arabic disputed end of ayah
    {0x115f, 0x1160},                        // Hangul fillers
    {0x17b4, 0x17b5},                        // Khmer inherent vowels
    {0x180b, 0x180f},                        // Mongolian selectors and vowel separator
    {0x200b, 0x200f},                        // zero width, marks of direction
    {0x2028, 0x202e},                        // line and paragraph separators, embeddings, overrides
    {0x2060, 0x206f},                        // invisible operators, isolates
    {0x3164, 0x3164},                        // Hangul filler
    {0xfdd0, 0xfdef},                        // no characters
    {0xfeff, 0xfeff},                        // byte order mark
    {0xffa0, 0xffa0},                        // Hangul filler
    {0xfff0, 0xfffb},                        // unassigned, annotations
    {0x110bd, 0x110bd},                      // Kaithi number signs
    {0x110cd, 0x110cd}, {0x13430, 0x1345f},  // Egyptian format controls
    {0x1bca0, 0x1bca3},                      // shorthand format controls
    {0x1d173, 0x1d17a},                      // musical format controls
    {0xe0000, 0xe0fff},                      // tags, variation selectors
});

bool is_hidden(char32_t code) {
    if (code < 0x20 || (code >= 0x7f && code < 0xa0) || (code & 0xfffe) == 0xfffe) return true;
    return std::ranges::any_of(
        kHidden, [code](const CodeRange& range) { return code >= range.first && code <= range.last; });
}

// A character of UTF-8, or a byte that is of none.
struct Character {
    char32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;
};

Character character_at(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return {lead, 1, true};
    const std::size_t bytes = lead < 0xc2 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 1;
    if (bytes == 1 || text.size() < bytes) return {lead, 1, false};
    char32_t code = lead & (0xffu >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {lead, 1, false};
        code = code << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};  // by length; less is overlong
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < kLeast[bytes] || code > 0x10ffff || surrogate) return {lead, 1, false};
    return {code, bytes, true};
}

// `instead` of each hidden character.
template <class Instead>
std::string without_hidden(std::string_view text, Instead&& instead) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const Character c = character_at(text);
        // A byte that is of no character can still be a control where text is ISO 8859-1.
        const bool hidden = c.valid ? is_hidden(c.code) : c.code < 0xa0;
        if (hidden)
            shown += instead(c.code);
        else
            shown += text.substr(0, c.bytes);
        text.remove_prefix(c.bytes);
    }
    return shown;
}

}  // namespace

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const Character c = character_at(text);
        if (!c.valid) return false;
        text.remove_prefix(c.bytes);
    }
    return true;
}

std::string printable(const std::string& text) {
    return without_hidden(text, [](char32_t code) { return code == '\n' ? '\n' : '?'; });
}

std::string one_line(const std::string& sentence) {
    return without_hidden(sentence, [](char32_t) { return '?'; });
}

std::string printable_json(const std::string& json) {
    return without_hidden(json, [](char32_t code) -> std::string {
        if (code == '\n') return "\n";
        const auto number = static_cast<std::uint32_t>(code);
        if (number < 0x10000) return fmt::format("\\u{:04x}", number);
        return fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + ((number - 0x10000) >> 10),
                           0xdc00 + (number & 0x3ff));
    });
}

}  // namespace game
