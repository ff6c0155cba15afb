#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace terrains {

// Limits on untrusted JSON text. Values are numbers, strings, booleans, nulls, arrays and objects.
struct JsonLimits {
    std::size_t depth;    // levels of lists and objects
    std::size_t values;   // of the whole text
    std::size_t members;  // of one object: each new name is compared with those before it
};

// Builds a value while the text is read, and stops at the first limit.
template <class Json>
class JsonBuilder {
  public:
    explicit JsonBuilder(const JsonLimits& limits) : limits_(limits) { open_.reserve(limits.depth); }

    // The events of nlohmann's parser; false ends it.
    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(std::int64_t value) { return add(value); }
    bool number_unsigned(std::uint64_t value) { return add(value); }
    bool number_float(double value, const std::string&) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(typename Json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(Json::value_t::object); }
    bool start_array(std::size_t) { return open(Json::value_t::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        auto& members = open_.back()->template get_ref<typename Json::object_t&>();
        if (members.size() == limits_.members)
            return refuse(fmt::format("an object of over {} members", limits_.members));
        const auto [place, is_new] = members.emplace(name, Json());
        member_ = &place->second;
        // The second one would replace the first, and a reader of the text may take the first for what counts.
        return is_new ||
               refuse(fmt::format("the key '{}' twice in one object", name.substr(0, kLongestQuote)));
    }
    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception&) {
        return refuse(fmt::format("byte {}: not JSON", byte));
    }

    tl::expected<Json, std::string> finish() && {
        if (!fault_.empty()) return tl::unexpected(std::move(fault_));
        return std::move(root_);
    }

  private:
    static constexpr std::size_t kLongestQuote = 60;  // bytes of a name

    bool refuse(std::string fault) {
        fault_ = std::move(fault);
        return false;
    }
    bool add(Json value) { return put(std::move(value)) != nullptr; }
    // Into the innermost list or object that is open; null at the limit.
    Json* put(Json value) {
        if (values_++ == limits_.values) {
            refuse(fmt::format("over {} values", limits_.values));
            return nullptr;
        }
        Json* place = &root_;
        if (!open_.empty() && open_.back()->is_array()) {
            auto& list = open_.back()->template get_ref<typename Json::array_t&>();
            list.push_back(std::move(value));
            return &list.back();
        }
        if (!open_.empty()) place = member_;
        *place = std::move(value);
        return place;
    }
    bool open(typename Json::value_t kind) {
        if (open_.size() == limits_.depth)
            return refuse(fmt::format("nested deeper than {} levels", limits_.depth));
        Json* place = put(Json(kind));
        if (place) open_.push_back(place);
        return place != nullptr;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    JsonLimits limits_;
    Json root_;
    std::vector<Json*> open_;  // from the outside in; a list grows only while nothing in it is open
    Json* member_ = nullptr;   // whose value comes next
    std::size_t values_ = 0;
    std::string fault_;
};

// The only way JSON from outside is read: in time and memory linear in the text, within the limits. Errors: a
// fact without the file's name. Not nlohmann's parse() with a callback, which looks through the whole of the
// enclosing list at the end of each list in it.
template <class Json>
tl::expected<Json, std::string> read_json(std::string_view text, const JsonLimits& limits) {
    JsonBuilder<Json> builder(limits);
    Json::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder).finish();
}

}  // namespace terrains
