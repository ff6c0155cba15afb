#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace terrains {

// Of a name or a word in ASCII.
inline std::string lower_case(std::string_view word) {
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

}  // namespace terrains
