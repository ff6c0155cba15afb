#pragma once

#include <cstddef>
#include <string>

namespace game {

// The text as it is printed: control characters (escape sequences, NUL, also those of ISO 8859-1 in UTF-8)
// become '?', because messages quote untrusted input. Line breaks stay.
inline std::string printable(const std::string& text) {
    std::string shown;
    shown.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
        const bool wide = c == 0xc2 && next >= 0x80 && next < 0xa0;  // U+0080 to U+009F
        const bool control = (c < 0x20 && c != '\n') || c == 0x7f || wide;
        shown.push_back(control ? '?' : text[i]);
        if (wide) ++i;
    }
    return shown;
}

// The same for a sentence, whose line breaks become '?' too.
inline std::string one_line(const std::string& sentence) {
    std::string line = printable(sentence);
    for (char& c : line)
        if (c == '\n') c = '?';
    return line;
}

}  // namespace game
