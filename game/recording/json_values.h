#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace game {

using Json = nlohmann::ordered_json;

// The double whose shortest text equals the float's.
double shortest(float value);

}  // namespace game

// Values of a recording's JSON, read and written. The readers throw std::runtime_error with the fact; the public
// functions of format.h return it as a value.
namespace game::values {

[[noreturn]] void refuse(const std::string& fact);

const Json& member(const Json& json, const char* key);
double number(const Json& json, const char* key, double least, double most);
std::int64_t whole(const Json& json, const char* key, std::int64_t least, std::int64_t most);
std::string text(const Json& json, const char* key);
glm::dvec3 triple(const Json& json, const char* key, double least, double most);
// Two different numbers, the smaller one first.
glm::dvec2 range(const Json& json, const char* key, double least, double most);
// A place in metres.
glm::dvec2 place_from(const Json& json);
// An array of at most so many; empty if there is none.
const Json& list(const Json& json, const char* key, std::size_t most);

// One of the names that `find` accepts.
template <class Find>
auto named(const Json& json, const char* key, Find&& find) {
    const std::string name = text(json, key);
    const auto value = find(name);
    if (!value) refuse(fmt::format("{} is '{}', which this version does not know", key, name));
    return *value;
}

Json numbers(std::initializer_list<double> values);

inline double as_recorded(float value) {
    return shortest(value);
}
inline double as_recorded(double value) {
    return value;
}

// The recorded numbers of `list` (game/scene/shown_numbers.h).
template <class List, class Of>
void numbers_from(const Json& json, const List& list, Of& of) {
    for (const auto& each : list)
        if (!each.in_recording.empty())
            of.*each.value = static_cast<std::remove_reference_t<decltype(of.*each.value)>>(
                number(json, each.in_recording.data(), each.least, each.most));
}
template <class List, class Of>
void add_numbers(const List& list, const Of& of, Json& json) {
    for (const auto& each : list)
        if (!each.in_recording.empty()) json[each.in_recording.data()] = as_recorded(of.*each.value);
}
template <class List, class Of>
Json numbers_json(const List& list, const Of& of) {
    Json json;
    add_numbers(list, of, json);
    return json;
}
Json place_json(glm::dvec2 at);

}  // namespace game::values
