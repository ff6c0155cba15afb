#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "terrains/massif/massif_numbers.h"
#include "terrains/recipe.h"
#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace terrains {

// "massif": a mountain side made by erosion. Uplift and streams carve it, beds of hard and soft rock that dip
// make cliffs and ledges, slopes fall back to their angle of rest, and debris builds aprons and fans. A valley
// runs west to east through the southern third, the crest runs through the northern part, and one straight
// couloir leads from below the crest to a fan on the valley floor, near the middle of the square.
// x 0 to length (east), y 0 to length (north). Not placed on Earth; has_data is 1 everywhere.
//
// The same parameters and seed give the same bits on every machine, if the compiler does not contract
// multiplications and additions: only + − × ÷, square roots, floor and integers are used.
//
// Grids of other spacing show the same mountain. It is made on levels of 64 to 1024 squares, each from the one
// before, and a level that is fine enough is averaged to the grid. Beyond 1024 squares the grid is interpolated
// and holds no further detail.
inline constexpr int kMassifSquares = 256;  // default grid: cells of 11.7 m
inline constexpr std::array<RecipeNumber<Massif>, 16> kMassifNumbers{{
    {"length", &Massif::length, 500, 20000, "m", "side of the square"},
    {"lowest", &Massif::lowest, -1000, 6000, "m", "height of the valley floor at its lower end"},
    {"relief", &Massif::relief, 1, 5000, "m",
     "height of the summits above the valley floor, up to 0.45 times the length"},
    {"valley", &Massif::valley, 15, 4000, "m", "width of the valley floor, 0.03 to 0.2 times the length"},
    {"ice", &Massif::ice, 0, 1, "", "0: valley cut by a stream; 1: trough with steep walls, and cirques"},
    {"soft_slope", &Massif::soft_slope, 20, 50, "°", "steepest slope of soft beds"},
    {"hard_slope", &Massif::hard_slope, 35, 75, "°", "steepest slope of hard beds"},
    {"hardness_contrast", &Massif::hardness_contrast, 0, 1, "",
     "0: all rock alike; 1: bold cliffs and ledges"},
    {"bed_thickness", &Massif::bed_thickness, 0.1, 1000, "m",
     "thickness of a hard and a soft bed together, up to 0.3 times the relief"},
    {"bed_dip", &Massif::bed_dip, 0, 60, "°", "slope of the beds"},
    {"bed_direction", &Massif::bed_direction, 0, 360, "°",
     "direction in which the beds fall; 0 is north, 90 east"},
    {"roughness", &Massif::roughness, 0, 10, "m", "amplitude of crags on rock"},
    {"snow", &Massif::snow, 0, 5, "m", "full snow depth, vertically; gullies hold more, ribs less"},
    {"snow_line", &Massif::snow_line, -1000, 11000, "m", "height above which snow begins"},
    {"snow_full", &Massif::snow_full, 1, 2000, "m", "height above the snow line at which snow is full"},
    {"bare", &Massif::bare, 30, 80, "°", "slope at which no snow holds; full if 10° gentler"},
}};

// The mountain and what its making knows of the ground. Fields are laid out as those of the terrain.
struct MassifGround {
    Terrain terrain;              // heights and snow in multiples of 2⁻¹⁰ m
    std::vector<float> hardness;  // of the rock at the surface, 0 to 1
    std::vector<float> talus;     // loose debris, m, ≥ 0
    std::vector<float> drainage;  // area that drains through the vertex, m²
};

// Every seed is valid. On one core it takes 0.7 s up to 256 squares, 1.4 s and 60 MB up to 512, 4 s beyond, and
// up to 9 s and 600 MB at 4096. Fails if squares are outside 8 to 4096, the grid is not allowed, or a parameter
// is outside its range. The error names the parameter.
//
// Source: J. Braun and S. D. Willett, A very efficient O(n), implicit and parallel method to solve the stream
// power equation, Geomorphology 180–181 (2013), eq. 21–26 with n = 1, m = 0.5.
tl::expected<MassifGround, std::string> generate_massif(const Massif& recipe, std::uint64_t seed,
                                                        const GridChoice& choice = kMassifSquares);

}  // namespace terrains
