#pragma once

#include <string>
#include <vector>

namespace game {

// Texts in columns, for the screen and for a page.
struct Table {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  // as many as there are heads in each
    std::size_t left = 1;  // columns that begin at the left; the others end at the right
};

std::string as_text(const Table& table);
std::string as_html(const Table& table);

// With what HTML reserves replaced.
std::string html_text(const std::string& text);

}  // namespace game
