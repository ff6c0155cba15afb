#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <toml++/toml.h>
#include <glm/vec2.hpp>

#include "game/base/outcome.h"

namespace game {

// The first fault in a TOML file, as "file:line: fact".
using TomlFault = std::optional<std::string>;

// One table of a TOML file, read key by key. Every reader returns nothing if the key is absent. A key of the
// wrong type or out of range is a fault, and so is, at finish(), a key that was never read. Faults carry
// their line. Valid as long as the document and the fault are.
class TomlTable {
  public:
    TomlTable(const toml::table& table, std::string name, std::string file, TomlFault& fault);

    std::optional<double> number(std::string_view key, double least, double most);
    // The numbers of `list` (game/scene/shown_numbers.h) that are given; the others stay as they are.
    template <class List, class Of>
    void numbers(const List& list, Of& of) {
        for (const auto& each : list)
            if (const auto value = number(each.in_scene, each.least, each.most))
                of.*each.value = static_cast<std::remove_reference_t<decltype(of.*each.value)>>(*value);
    }
    std::optional<std::int64_t> whole(std::string_view key, std::int64_t least, std::int64_t most);
    std::optional<std::string> text(std::string_view key);
    std::optional<bool> truth(std::string_view key);  // true or false
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count);
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t least, std::size_t most);
    // A list of `least` to `most` strings.
    std::optional<std::vector<std::string>> texts(std::string_view key, std::size_t least, std::size_t most);
    // A list of `least` to `most` places [x, y], each coordinate within ±kFarthestPlace metres.
    std::optional<std::vector<glm::dvec2>> places(std::string_view key, std::size_t least, std::size_t most);
    std::optional<glm::dvec2> place(std::string_view key);
    std::optional<TomlTable> table(std::string_view key);
    std::vector<TomlTable> tables(std::string_view key);  // of an array of tables
    // A date and time with its offset from UTC, in the years `first` to `last`, as seconds from 1970-01-01
    // UTC.
    std::optional<double> moment(std::string_view key, int first, int last);
    bool has(std::string_view key) const { return table_->contains(key); }
    bool is_text(std::string_view key) const;
    bool is_list(std::string_view key) const;
    std::vector<std::string> keys() const;
    int line() const { return line_of({}); }  // of the file, 1 the first
    int line_of(std::string_view key) const;  // of the table itself, if there is no such key

    // Reports that `key` (or the table itself, if empty) is wrong.
    void blame(std::string_view key, const std::string& fact);
    // Call this after all keys have been read: any others are unknown.
    void finish();

  private:
    const toml::node* find(std::string_view key);

    const toml::table* table_;
    std::string name_, file_;
    TomlFault* fault_;
    std::set<std::string, std::less<>> known_;
};

// A parsed file. Errors: unreadable, beyond game/base/limits.h, or not TOML, with its line.
Outcome<toml::table> parse_toml(const std::filesystem::path& file);

}  // namespace game
