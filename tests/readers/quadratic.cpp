#include "tests/readers/quadratic.h"

#include <nlohmann/json.hpp>

void test::parse_with_callback(std::string_view json) {
    using Json = nlohmann::json;
    [[maybe_unused]] const Json parsed =
        Json::parse(json, [](int, Json::parse_event_t, const Json&) { return true; });
}
