#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace support {

// A text in a C++ source; those that follow each other are one, as for the compiler.
struct Literal {
    std::string text;
    std::string caller;  // the name before the innermost parenthesis or brace around it; empty: none
    int line = 0;
};

// Those of a source, without its comments and its #include lines. Escapes are \n, \t, \" and \\.
std::vector<Literal> literals_in(std::string_view source);

}  // namespace support
