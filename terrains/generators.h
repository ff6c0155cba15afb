#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace terrains {

// Every generator as one list, for whoever offers them by name.

// A parameter; RecipeNumber without the type of its recipe.
struct GeneratorNumber {
    const char* name;
    double lowest, highest, usual;
    const char* unit;
    const char* meaning;
};

// What else a generator knows of the ground, laid out as the terrain's fields.
struct GroundLayer {
    const char *name, *unit, *meaning;
    std::vector<float> values;
};
struct Generated {
    Terrain terrain;
    std::vector<GroundLayer> layers;
};

struct Generator {
    const char* name;
    const char* meaning;
    int squares;  // of the default grid
    bool seeded;  // another seed, another mountain
    std::vector<GeneratorNumber> numbers;
    // `values`: one for each of the numbers. Errors as in generate.h.
    std::function<tl::expected<Generated, std::string>(std::span<const double> values, std::uint64_t seed,
                                                       const GridChoice& choice)>
        make;
};
std::span<const Generator> generators();
std::string generator_names();                           // "massif, alpine-valley, …"
const Generator* find_generator(std::string_view name);  // null: none of this name

}  // namespace terrains
