#pragma once

#include <string>
#include <vector>

namespace game {

// A table of strings, for the terminal and for a page.
struct Table {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  // each as long as the head
    std::size_t left = 1;  // number of left-aligned columns; the others are right-aligned
};

std::string as_text(const Table& table);
std::string as_html(const Table& table);

// Escapes the characters that HTML reserves.
std::string html_text(const std::string& text);

}  // namespace game
