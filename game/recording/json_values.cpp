#include "game/recording/json_values.h"

#include <stdexcept>

#include "game/base/limits.h"
#include "game/base/number.h"

namespace game {

double shortest(float value) {
    return number_from<double>(fmt::format("{}", value)).value_or(static_cast<double>(value));
}

}  // namespace game

namespace game::values {

void refuse(const std::string& fact) {
    throw std::runtime_error(fact);
}

const Json& member(const Json& json, const char* key) {
    if (!json.is_object() || !json.contains(key)) refuse(fmt::format("has no {}", key));
    return json.at(key);
}

double number(const Json& json, const char* key, double least, double most) {
    const Json& value = member(json, key);
    if (!value.is_number()) refuse(fmt::format("{} is not a number", key));
    const double number = value.get<double>();
    if (!(number >= least && number <= most))
        refuse(fmt::format("{} is {}, outside {} to {}", key, number, least, most));
    return number;
}

std::int64_t whole(const Json& json, const char* key, std::int64_t least, std::int64_t most) {
    const Json& value = member(json, key);
    if (!value.is_number_integer()) refuse(fmt::format("{} is not a whole number", key));
    if (value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX)
        refuse(fmt::format("{} is {}, outside {} to {}", key, value.get<std::uint64_t>(), least, most));
    const auto number = value.get<std::int64_t>();
    if (number < least || number > most)
        refuse(fmt::format("{} is {}, outside {} to {}", key, number, least, most));
    return number;
}

std::string text(const Json& json, const char* key) {
    const Json& value = member(json, key);
    if (!value.is_string()) refuse(fmt::format("{} is not a string", key));
    return value.get<std::string>();
}

glm::dvec3 triple(const Json& json, const char* key, double least, double most) {
    const Json& list = member(json, key);
    if (!list.is_array() || list.size() != 3) refuse(fmt::format("{} is not three numbers", key));
    glm::dvec3 values;
    for (int i = 0; i < 3; ++i) {
        const Json& value = list.at(static_cast<std::size_t>(i));
        if (!value.is_number()) refuse(fmt::format("{} is not three numbers", key));
        values[i] = value.get<double>();
        if (!(values[i] >= least && values[i] <= most))
            refuse(fmt::format("{} has {}, outside {} to {}", key, values[i], least, most));
    }
    return values;
}

glm::dvec2 range(const Json& json, const char* key, double least, double most) {
    const Json& pair = member(json, key);
    const bool is_pair =
        pair.is_array() && pair.size() == 2 && pair.at(0).is_number() && pair.at(1).is_number();
    const glm::dvec2 values =
        is_pair ? glm::dvec2(pair.at(0).get<double>(), pair.at(1).get<double>()) : glm::dvec2(0);
    if (!(least <= values.x && values.x < values.y && values.y <= most))
        refuse(fmt::format("{} is not two rising numbers of {} to {}", key, least, most));
    return values;
}

glm::dvec2 place_from(const Json& json) {
    const auto coordinate = [&](std::size_t i) {
        const bool is_number = json.is_array() && json.size() == 2 && json.at(i).is_number();
        const double value = is_number ? json.at(i).get<double>() : 0;
        if (!is_number || !(std::abs(value) <= kFarthestPlace))
            refuse("a place is not two numbers of metres");
        return value;
    };
    return {coordinate(0), coordinate(1)};
}

const Json& list(const Json& json, const char* key, std::size_t most) {
    static const Json kNone = Json::array();
    if (!json.contains(key)) return kNone;
    const Json& list = json.at(key);
    if (!list.is_array() || list.size() > most)
        refuse(fmt::format("{} is not a list of at most {}", key, most));
    return list;
}

Json numbers(std::initializer_list<double> values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(value);
    return list;
}

Json place_json(glm::dvec2 at) {
    return numbers({at.x, at.y});
}

}  // namespace game::values
