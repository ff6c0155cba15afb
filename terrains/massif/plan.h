#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "terrains/massif/exact.h"

namespace terrains::massif {

// Where the valley, the crest and the couloir run, in units of the length.
class Plan {
  public:
    // `floor`: width of the valley floor.
    Plan(double floor, std::uint64_t seed) : bend_(seed, 1), number_(seed, 2), half_floor_(floor / 2) {
        foot_x_ = 0.5 + 0.05 * (number_.unit(0) - 0.5);
        foot_y_ = north_edge(foot_x_) + 0.035;
        const double slant = 0.05 + 0.09 * number_.unit(1);
        top_x_ = foot_x_ + (number_.unit(2) < 0.5 ? -slant : slant);
        top_y_ = 0.74 + 0.05 * number_.unit(3);
    }
    double axis(double x) const {
        return 0.17 + 0.035 * bend_.at(2.3 * x, 0.5) + 0.01 * bend_.at(7 * x, 9.5);
    }
    double half_floor() const { return half_floor_; }
    double north_edge(double x) const { return axis(x) + half_floor_; }
    double floor_rise(double x) const { return number_.unit(4) < 0.5 ? x : 1 - x; }
    double crest(double x) const { return 0.83 + 0.05 * bend_.at(2.7 * x, 20.5); }

    // The couloir where it crosses a row.
    struct Crossing {
        double s;        // 0 at the foot to 1 at the top
        double x;        // its place
        double squeeze;  // distance from its line, per distance along the row
        double away(double at) const { return squeeze * std::abs(at - x); }
    };
    Crossing couloir_at(double s) const {
        const double tilt = (top_x_ - foot_x_) / (top_y_ - foot_y_);
        return {s, mixed(foot_x_, top_x_, s) + 0.012 * bend_.at(4 * s, 40.5) + 0.004 * bend_.at(13 * s, 50.5),
                1 / std::sqrt(1 + tilt * tilt)};
    }
    Crossing crossing(double y) const { return couloir_at((y - foot_y_) / (top_y_ - foot_y_)); }
    double couloir_y(double s) const { return mixed(foot_y_, top_y_, s); }

    // How well walls of rock enclose the couloir, 0 to 1; another number on either side.
    double wall(const Crossing& c, double x) const {
        return std::clamp(0.75 + 0.6 * bend_.octaves(5 * c.s, x < c.x ? 60.5 : 70.5, 2), 0.3, 1.0);
    }

  private:
    Noise bend_, number_;
    double half_floor_, foot_x_, foot_y_, top_x_, top_y_;
};

}  // namespace terrains::massif
