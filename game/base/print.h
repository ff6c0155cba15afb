#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "game/base/one_line.h"

// Everything that the program prints goes through here, except --help and the progress bar.
namespace game {

// Prints text of any number of lines to standard output.
inline void print_text(const std::string& text) {
    const std::string shown = printable(text);
    std::fwrite(shown.data(), 1, shown.size(), stdout);
}

// Prints a sentence as one line.
template <class... Arguments>
void print_line(std::FILE* stream, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    const std::string line = one_line(fmt::format(format, std::forward<Arguments>(arguments)...)) + '\n';
    std::fwrite(line.data(), 1, line.size(), stream);
}

}  // namespace game
