#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace terrains {

// Finds steps between neighbouring pixels that no mountain has: over 100 m and five times their distance. They are left
// by a value for no data that the file does not declare (0, -99), and by resampling next to one.
class HeightSteps {
  public:
    // m between neighbouring pixels, along rows and columns.
    HeightSteps(double apart_x, double apart_y) : most_x_(most(apart_x)), most_y_(most(apart_y)) {}

    // Heights in m of the next row, NaN if unknown.
    void add_row(const std::vector<double>& heights);

    // One sentence with the greatest step, its row and column, and how many there are; none without steps.
    std::optional<std::string> warning() const;

  private:
    static double most(double apart) { return 100 + 5 * apart; }
    void see(double height, double neighbour, double most, std::size_t column);

    double most_x_, most_y_;  // m
    std::vector<double> above_;
    std::uint64_t rows_ = 0, steps_ = 0;
    struct Step {
        std::uint64_t row = 0, column = 0;  // counted from 1
        double height = 0, neighbour = 0;   // m
    };
    Step greatest_;
};

}  // namespace terrains
