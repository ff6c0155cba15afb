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

// A text with the signs of print where a keyboard has none: "3,500 m³" of "3,500 m3".
std::string with_signs(std::string text);

// A number for people to read, with narrow blanks between its thousands: "27 000", "46.2".
std::string grouped(double value, int digits = 0);

}  // namespace game
