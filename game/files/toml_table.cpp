#include "game/files/toml_table.h"

#include <chrono>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "files/input.h"
#include "game/base/limits.h"
#include "game/files/toml_limits.h"

namespace game {

namespace {

std::optional<glm::dvec2> place_from(const toml::node* node) {
    const toml::array* pair = node ? node->as_array() : nullptr;
    if (!pair || pair->size() != 2) return std::nullopt;
    glm::dvec2 place;
    for (int i = 0; i < 2; ++i) {
        const auto value = pair->get(static_cast<std::size_t>(i))->value<double>();
        if (!value || !(std::abs(*value) <= kFarthestPlace)) return std::nullopt;
        place[i] = *value;
    }
    return place;
}

}  // namespace

TomlTable::TomlTable(const toml::table& table, std::string name, std::string file, TomlFault& fault)
    : table_(&table), name_(std::move(name)), file_(std::move(file)), fault_(&fault) {}

const toml::node* TomlTable::find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
}

std::optional<double> TomlTable::number(std::string_view key, double least, double most) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const std::optional<double> value = node->value<double>();
    if (!value || !node->is_number())
        blame(key, "is not a number");
    else if (!(*value >= least && *value <= most))
        blame(key, fmt::format("is {}, outside {} to {}", *value, least, most));
    else
        return value;
    return std::nullopt;
}

std::optional<std::int64_t> TomlTable::whole(std::string_view key, std::int64_t least, std::int64_t most) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const std::optional<std::int64_t> value = node->value_exact<std::int64_t>();
    if (!value)
        blame(key, "is not a whole number");
    else if (*value < least || *value > most)
        blame(key, fmt::format("is {}, outside {} to {}", *value, least, most));
    else
        return value;
    return std::nullopt;
}

std::optional<std::string> TomlTable::text(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    std::optional<std::string> value = node->value_exact<std::string>();
    if (!value) blame(key, "is not a string in quotes");
    return value;
}

std::optional<bool> TomlTable::truth(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    std::optional<bool> value = node->value_exact<bool>();
    if (!value) blame(key, "is neither true nor false");
    return value;
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key, std::size_t count) {
    return numbers(key, count, count);
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key, std::size_t least,
                                                      std::size_t most) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    std::vector<double> values;
    if (array)
        for (const toml::node& element : *array)
            if (const auto value = element.value<double>(); value && std::isfinite(*value))
                values.push_back(*value);
    if (array && values.size() == array->size() && values.size() >= least && values.size() <= most)
        return values;
    blame(key, least == most ? fmt::format("is not a list of {} numbers", least)
                             : fmt::format("is not a list of {} to {} numbers", least, most));
    return std::nullopt;
}

std::optional<std::vector<std::string>> TomlTable::texts(std::string_view key, std::size_t least,
                                                         std::size_t most) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    std::vector<std::string> texts;
    for (std::size_t i = 0; array && i < array->size(); ++i)
        if (auto text = array->get(i)->value_exact<std::string>()) texts.push_back(std::move(*text));
    if (array && texts.size() == array->size() && texts.size() >= least && texts.size() <= most) return texts;
    blame(key, fmt::format("is not a list of {} to {} strings in quotes", least, most));
    return std::nullopt;
}

std::optional<std::vector<glm::dvec2>> TomlTable::places(std::string_view key, std::size_t least,
                                                         std::size_t most) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; array && i < array->size(); ++i)
        if (const auto at = place_from(array->get(i))) places.push_back(*at);
    if (!array || places.size() != array->size())
        blame(key, fmt::format("is not a list of places [x, y] in metres, within ±{:.0f}", kFarthestPlace));
    else if (places.size() < least || places.size() > most)
        blame(key, fmt::format("has {} places; {} to {} are allowed", places.size(), least, most));
    else
        return places;
    return std::nullopt;
}

std::optional<glm::dvec2> TomlTable::place(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto at = place_from(node);
    if (!at) blame(key, fmt::format("is not a place [x, y] in metres, within ±{:.0f}", kFarthestPlace));
    return at;
}

std::optional<double> TomlTable::moment(std::string_view key, int first, int last) {
    constexpr const char* kExample = "2026-02-14T08:30:00+01:00";
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = node->value_exact<toml::date_time>();
    if (!value)
        blame(key, fmt::format("is not a date and time without quotes, such as {}", kExample));
    else if (!value->offset)
        blame(key,
              fmt::format("has no offset from UTC; add it at the end, as in {}, or Z for UTC", kExample));
    else if (value->date.year < first || value->date.year > last)
        blame(key, fmt::format("is in the year {}, outside {} to {}", value->date.year, first, last));
    else {
        using namespace std::chrono;
        const toml::time& time = value->time;
        const sys_days date =
            year(value->date.year) / month(value->date.month) / std::chrono::day(value->date.day);
        const auto since = date.time_since_epoch() + hours(time.hour) + minutes(time.minute) +
                           std::chrono::seconds(time.second) - minutes(value->offset->minutes);
        return duration<double>(since).count() + 1e-9 * time.nanosecond;
    }
    return std::nullopt;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (const toml::table* inner = node->as_table())
        return TomlTable(*inner, std::string(key), file_, *fault_);
    blame(key, "is not a table");
    return std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
    std::vector<TomlTable> found;
    const toml::node* node = find(key);
    if (!node) return found;
    if (!node->is_array_of_tables()) {
        blame(key, fmt::format("is not a list of tables; write [[{}]]", key));
        return found;
    }
    for (const toml::node& element : *node->as_array())
        found.emplace_back(*element.as_table(), std::string(key), file_, *fault_);
    return found;
}

bool TomlTable::is_text(std::string_view key) const {
    const toml::node* node = table_->get(key);
    return node && node->is_string();
}

bool TomlTable::is_list(std::string_view key) const {
    const toml::node* node = table_->get(key);
    return node && node->is_array();
}

std::vector<std::string> TomlTable::keys() const {
    std::vector<std::string> all;
    for (const auto& [key, node] : *table_) all.emplace_back(key.str());
    return all;
}

int TomlTable::line_of(std::string_view key) const {
    const toml::node* const node = key.empty() ? table_ : table_->get(key);
    return static_cast<int>((node ? node : table_)->source().begin.line);
}

void TomlTable::blame(std::string_view key, const std::string& fact) {
    if (*fault_) return;
    const toml::node* node = key.empty() ? table_ : table_->get(key);
    const toml::source_region& from = (node ? node : table_)->source();
    const std::string& file = from.path ? *from.path : file_;  // a table may come from several files
    const std::string place =
        name_.empty() ? std::string(key) : fmt::format("{}{}{}", name_, key.empty() ? "" : ".", key);
    *fault_ = fmt::format("{}:{}: {}{}{}", file, from.begin.line, place, place.empty() ? "" : " ", fact);
}

void TomlTable::finish() {
    for (const std::string& key : keys())
        if (!known_.contains(key)) blame(key, "is not a known key");
}

Outcome<toml::table> parse_toml(const std::filesystem::path& file) {
    auto stream = files::open_input(file);
    if (!stream) return unusable(stream.error());
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    if (error) return unusable(fmt::format("{}: {}", file.string(), error.message()));
    if (bytes > kMostTomlBytes)
        return unusable(
            fmt::format("{}: {} bytes; at most {} are allowed", file.string(), bytes, kMostTomlBytes));
    std::string text(static_cast<std::size_t>(bytes), '\0');
    stream->read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!*stream) return unusable(fmt::format("{}: cannot be read", file.string()));
    if (const auto excess = excess_of(text))
        return unusable(fmt::format("{}:{}: {}", file.string(), excess->line, excess->fact));
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& wrong) {
        return unusable(
            fmt::format("{}:{}: {}", file.string(), wrong.source().begin.line, wrong.description()));
    }
}

}  // namespace game
