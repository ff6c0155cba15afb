#include "game/pages/table.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace game {
namespace {

// Counts characters, not bytes: UTF-8 continuation bytes have the form 10xxxxxx.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string html_row(const std::vector<std::string>& cells, std::size_t left, const char* tag) {
    std::string row = "<tr>";
    for (std::size_t c = 0; c < cells.size(); ++c)
        row += fmt::format("<{0}{1}>{2}</{0}>", tag, c < left ? " class=\"left\"" : "", html_text(cells[c]));
    return row + "</tr>\n";
}

}  // namespace

std::string as_text(const Table& table) {
    std::vector<std::size_t> width(table.head.size());
    for (std::size_t c = 0; c < width.size(); ++c) {
        width[c] = width_of(table.head[c]);
        for (const auto& row : table.rows) width[c] = std::max(width[c], width_of(row[c]));
    }
    std::string text = table.title + "\n";
    const auto add = [&](const std::vector<std::string>& cells) {
        std::string line;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::string room(width[c] - width_of(cells[c]), ' ');
            line += "  " + (c < table.left ? cells[c] + room : room + cells[c]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    };
    add(table.head);
    for (const auto& row : table.rows) add(row);
    return text;
}

std::string as_html(const Table& table) {
    std::string html = fmt::format("<h3>{}</h3>\n<div class=\"wide\"><table>\n<thead>{}</thead>\n<tbody>\n",
                                   html_text(table.title), html_row(table.head, table.left, "th"));
    for (const auto& row : table.rows) html += html_row(row, table.left, "td");
    return html + "</tbody></table></div>\n";
}

std::string with_signs(std::string text) {
    constexpr std::string_view kTyped = "m3";
    const auto in_word = [&](std::size_t at) {
        return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
    };
    for (std::size_t at = 0; (at = text.find(kTyped, at)) != text.npos; ++at)
        if (!in_word(at - 1) && !in_word(at + kTyped.size())) text.replace(at, kTyped.size(), "m³");
    return text;
}

std::string grouped(double value, int digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    const std::size_t first = text.front() == '-' ? 1 : 0;
    for (std::size_t at = std::min(text.find('.'), text.size()); at > first + 3; text.insert(at, "\u202f"))
        at -= 3;
    return text;
}

std::string html_text(const std::string& text) {
    std::string html;
    for (const char c : text) switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    return html;
}

}  // namespace game
