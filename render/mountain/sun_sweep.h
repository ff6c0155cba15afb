#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/mountain/surroundings.h"
#include "render/view/frame_block.h"
#include "sim/world/state.h"

namespace render {

// The largest `size.z` of a frame block that any light needs on a grid: rays of a sweep.
inline int most_rays(const sim::Grid& grid) {
    return 2 * (grid.nx + grid.ny) + 1;
}
// The largest `size.w`: rows of a sweep.
inline int most_rows(const sim::Grid& grid) {
    return std::max(grid.nx, grid.ny);
}

// Computes the height below which the sun is hidden, swept away from the sun in O(vertices).
//
//   sun  \        step 0     the row (or column) nearest to the sun
//         \  ▲    step 1     ceiling₁ = max(ceiling₀, z₀) − fall
//          \/ \   step 2     ceiling₂ = max(ceiling₁, z₁) − fall
//          /   \  …          a place is in shadow where z < ceiling
//
// Rays start half a cell apart and move `shear` cells aside per row, so heights are interpolated once and a
// shadow does not blur on its way. Outside the grid and at vertices without data, heights are those of the
// surroundings; without surroundings, the base of the block.
//
// Equal arguments give equal bits, whatever was swept before. A later run on the same grid allocates nothing.
class SunSweep {
  public:
    // `frame`: made from this world, its light and these surroundings. `around` may be null or empty.
    void run(const sim::View& world, const Surroundings* around, const FrameBlock& frame);

    int rays() const { return course_.rays; }
    int rows() const { return course_.rows; }
    // m above datum, one per row and ray, row by row. sun_ceiling.glsl says which place each belongs to.
    std::span<const float> ceilings() const { return now_; }
    // The same of the previous run. If light, grid or surroundings changed, it belongs to other places.
    std::span<const float> before() const { return before_; }
    // The rows that differ from the previous run lie between these two, inclusive. If none does, the first is greater.
    // If light, grid or surroundings changed, all do.
    int first_changed() const { return first_changed_; }
    int last_changed() const { return last_changed_; }

  private:
    // What is swept, without the heights.
    struct Course {
        sim::Grid grid;
        glm::vec3 beyond{0};              // of the rough heights: place of vertex (0, 0), m; cell, m
        std::uint64_t surroundings = 0;   // fingerprint; 0: none
        double shear = 0, first_ray = 0;  // cells per row; cells
        float fall = 0, base = 0;         // m per row; m
        bool turned = false;              // rows of the sweep are columns of the grid
        bool backwards = false;           // it starts at the last one
        int rays = 0, rows = 0, columns = 0;

        bool operator==(const Course&) const = default;
    };
    // Which rays of even or of odd number are on the grid at a step: those from `first` to before `last`, counted
    // among themselves. Ray k is between the vertices left + k and left + k + 1, at this part of the way.
    struct Crossing {
        int first, last, left;
        float part;
    };
    struct Drain {
        int step, column;
        float height;  // m
    };

    static Course course_of(const sim::View& world, const Surroundings* around, const FrameBlock& frame);
    bool is_known(const Course& course, const sim::View& world) const;
    void survey(const Surroundings* around);
    void survey_drains(const Surroundings* around);
    void sweep(const sim::View& world);
    void find_heights(const sim::View& world, int step);
    void store(int step);
    void find_changes(bool all);

    int number(int parity) const { return (course_.rays + 1 - parity) / 2; }  // of rays of a parity
    double column(int parity, double step) const {                            // of the first ray of a parity
        return course_.first_ray + 0.5 * parity + course_.shear * step;
    }
    int row(int step) const { return course_.backwards ? course_.rows - 1 - step : step; }
    Crossing crossing(int parity, int step) const;

    Course course_;
    sim::Field<sim::Site> site_;
    // What does not change with the heights: ceilings at the first row, and heights outside the grid in the order in
    // which they are met, by step, parity and ray. Without surroundings there are none.
    std::array<std::vector<float>, 2> start_;  // by parity
    std::vector<float> outside_;
    std::vector<Drain> drains_;  // vertices without data, by step

    std::array<std::vector<float>, 2> ceiling_;  // at the current step, by parity
    std::vector<float> heights_;                 // of some rows from the current one on
    std::vector<float> now_, before_;
    int first_changed_ = 0, last_changed_ = -1;
};

}  // namespace render
