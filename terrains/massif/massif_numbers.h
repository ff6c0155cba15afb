#pragma once

namespace terrains {

// What makes a massif: terrains/massif.h has its meaning, units and ranges.
struct Massif {
    double length = 3000;
    double lowest = 1200;
    double relief = 850;
    double valley = 360;
    double ice = 0.6;
    double soft_slope = 37;
    double hard_slope = 62;
    double hardness_contrast = 0.8;
    double bed_thickness = 110;
    double bed_dip = 14;
    double bed_direction = 300;
    double roughness = 3;
    double snow = 1.5;
    double snow_line = 1100;
    double snow_full = 150;
    double bare = 52;
};

}  // namespace terrains
