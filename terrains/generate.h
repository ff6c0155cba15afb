#pragma once

#include <array>
#include <string>

#include <tl/expected.hpp>

#include "terrains/recipe.h"
#include "terrains/resample.h"
#include "terrains/terrain.h"

namespace terrains {

// Mountains generated from formulas. A formula gives the height at any point in metres, so grids of any
// spacing sample the same mountain. Heights and cover are rounded to whole multiples of 2⁻¹⁰ m (1 mm), so
// that differences between maths libraries do not reach a hash. The recipes' y runs downhill; ours points
// north, so the slope falls to the south: y = length − downhill. Not placed on Earth; has_data is 1
// everywhere. Both fail if squares are outside 8 to 4096 or a parameter is outside its range. The error names
// the parameter.

// "slope-of-soil": a steady slope that eases into flat ground, a shallow hollow down its middle, gentle
// unevenness, and soil that thins out at the break. x 0 to 160, y 0 (foot) to 160 (top). The recipe's heap at
// (80, 22) downhill is at x = 80, y = 138.
struct SoilSlope {
    double length = 160;
    double steep = 32;
    double flat = 3;
    double break_at = 100;
    double break_width = 8;
    double sway = 2.5;
    double relief = 0.10;
    double hollow = 0.0008;
    double soil = 0.9;
    double soil_at_foot = 0.1;
};
inline constexpr int kSoilSlopeSquares = 80;  // default grid: cells of 2 m
inline constexpr std::array<RecipeNumber<SoilSlope>, 10> kSoilSlopeNumbers{{
    {"length", &SoilSlope::length, 40, 2000, "m", "side of the square"},
    {"steep", &SoilSlope::steep, 5, 45, "°", "slope above the break"},
    {"flat", &SoilSlope::flat, 0, 15, "°", "slope below the break"},
    {"break_at", &SoilSlope::break_at, 0, 2000, "m", "where the slope eases, downhill from the top"},
    {"break_width", &SoilSlope::break_width, 1, 50, "m", "distance over which the slope eases"},
    {"sway", &SoilSlope::sway, 0, 10, "m",
     "displacement of contours up and down hill, so that none follows the grid"},
    {"relief", &SoilSlope::relief, 0, 1, "m", "amplitude of the small unevenness"},
    {"hollow", &SoilSlope::hollow, 0, 0.01, "1/m", "curvature of the hollow across the slope"},
    {"soil", &SoilSlope::soil, 0, 5, "m", "soil on the slope, vertically, in addition to that of the foot"},
    {"soil_at_foot", &SoilSlope::soil_at_foot, 0, 1, "m", "soil everywhere, vertically"},
}};
tl::expected<Terrain, std::string> generate_soil_slope(const SoilSlope& recipe = {},
                                                       const GridChoice& choice = kSoilSlopeSquares);

// "alpine-valley": two sides of a valley with gullies, ribs and summits, a floor that falls gently to the
// east, debris fans at the foot of gullies, and snow above the snow line unless too steep. x and y 0 to 2000.
// The main side faces south, its ridge near y = 1860; the floor runs near y = 500; the opposite side rises to
// the southern border. The recipe's heap at (960, 330) downhill is at x = 960, y = 1670, in the bowl at the
// head of the main gully.
struct AlpineValley {
    double floor_height = 1200;
    double rise = 840;
    double summits = 90;
    double gully_depth = 26;
    double gully_spacing = 480;
    double ruggedness = 60;
    double fan_height = 16;
    double floor_fall = 0.02;
    double opposite_rise = 320;
    double snow = 1.2;
    double snow_line = 1330;
    double snow_full = 150;
    double bare = 52;
};
inline constexpr int kAlpineValleySquares = 160;  // default grid: cells of 12.5 m
inline constexpr std::array<RecipeNumber<AlpineValley>, 13> kAlpineValleyNumbers{{
    {"floor_height", &AlpineValley::floor_height, 0, 4000, "m", "height of the valley floor in its middle"},
    {"rise", &AlpineValley::rise, 100, 2000, "m", "height of the main ridge above the floor"},
    {"summits", &AlpineValley::summits, 0, 300, "m",
     "height of summits and depth of saddles on the main ridge"},
    {"gully_depth", &AlpineValley::gully_depth, 0, 60, "m", "amplitude of the gullies"},
    {"gully_spacing", &AlpineValley::gully_spacing, 150, 1000, "m",
     "distance between gullies of the main side"},
    {"ruggedness", &AlpineValley::ruggedness, 0, 120, "m", "amplitude of ribs and crags"},
    {"fan_height", &AlpineValley::fan_height, 0, 40, "m", "height of the debris fans where gullies end"},
    {"floor_fall", &AlpineValley::floor_fall, 0, 0.1, "m/m", "slope of the valley floor to the east"},
    {"opposite_rise", &AlpineValley::opposite_rise, 0, 1000, "m",
     "rise of the opposite side over its first 520 m"},
    {"snow", &AlpineValley::snow, 0, 5, "m", "full snow depth, vertically"},
    {"snow_line", &AlpineValley::snow_line, -1000, 6000, "m", "height above which snow begins"},
    {"snow_full", &AlpineValley::snow_full, 1, 2000, "m", "height above the snow line at which snow is full"},
    {"bare", &AlpineValley::bare, 30, 80, "°", "slope at which no snow holds; full if 10° gentler"},
}};
tl::expected<Terrain, std::string> generate_alpine_valley(const AlpineValley& recipe = {},
                                                          const GridChoice& choice = kAlpineValleySquares);

}  // namespace terrains
