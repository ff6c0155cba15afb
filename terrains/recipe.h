#pragma once

#include <string>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace terrains {

// One parameter of a recipe: its key in a scene file, and its range.
template <class Recipe>
struct RecipeNumber {
    const char* name;
    double Recipe::*value;
    double lowest, highest;
    const char* unit;
    const char* meaning;
};

// Fails if a parameter is outside its range; the error names it.
template <class Recipe, class Numbers>
tl::expected<void, std::string> check_numbers(const Recipe& recipe, const Numbers& numbers) {
    for (const auto& number : numbers) {
        const double value = recipe.*(number.value);
        const std::string unit = *number.unit ? std::string(" ") + number.unit : "";
        if (!(value >= number.lowest && value <= number.highest))
            return tl::unexpected(fmt::format("'{}' is {}{}; it must be {} to {}{}", number.name, value, unit,
                                              number.lowest, number.highest, unit));
    }
    return {};
}

}  // namespace terrains
