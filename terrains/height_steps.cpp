#include "terrains/height_steps.h"

#include <cmath>

#include <fmt/format.h>

namespace terrains {

void HeightSteps::see(double height, double neighbour, double most, std::size_t column) {
    const double step = std::abs(height - neighbour);
    if (!(step > most)) return;  // not for NaN
    ++steps_;
    if (step > std::abs(greatest_.height - greatest_.neighbour))
        greatest_ = {rows_ + 1, column + 1, height, neighbour};
}

void HeightSteps::add_row(const std::vector<double>& heights) {
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (i > 0) see(heights[i], heights[i - 1], most_x_, i);
        if (rows_ > 0) see(heights[i], above_[i], most_y_, i);
    }
    above_ = heights;
    ++rows_;
}

std::optional<std::string> HeightSteps::warning() const {
    if (steps_ == 0) return std::nullopt;
    return fmt::format(
        "row {}, column {} is {:.6g} m high, and the pixel beside it {:.6g} m; there are {} such steps. Is "
        "one of them a "
        "value for no data that the file does not declare?",
        greatest_.row, greatest_.column, greatest_.height, greatest_.neighbour, steps_);
}

}  // namespace terrains
