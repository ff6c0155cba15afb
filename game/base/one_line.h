#pragma once

#include <algorithm>
#include <string>

namespace game {

// The sentence as it is printed. Control characters (line breaks, escape sequences, NUL) become '?', because
// messages quote untrusted input.
inline std::string one_line(std::string sentence) {
    std::ranges::replace_if(
        sentence, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return sentence;
}

}  // namespace game
