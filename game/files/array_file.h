#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// A NumPy array file, as numpy.save() writes it: little-endian f4 or f8 in C order. It is read frame by frame
// along its first axis, so it may be larger than memory.
class ArrayFile {
  public:
    // Errors: status 2, file and fact: not such an array, or more or less data than its shape needs.
    static Outcome<ArrayFile> open(const std::filesystem::path& path);

    const std::vector<std::int64_t>& shape() const { return shape_; }
    std::string shape_text() const;  // "(120, 400, 2)"

    // Reads the next frame as float: as many values as the product of the other axes. Errors: status 2, a
    // number that is not finite, with its place.
    Outcome<void> read_frame(std::span<float> values);

  private:
    std::filesystem::path path_;
    std::ifstream file_;
    std::vector<std::int64_t> shape_;
    bool is_double_ = false;
    std::int64_t frame_ = 0;
    std::vector<char> bytes_;
};

}  // namespace game
