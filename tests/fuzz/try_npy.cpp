#include "tests/fuzz/try_reader.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "game/files/array_file.h"

namespace game::test {
namespace {

constexpr float kMost = std::numeric_limits<float>::max();

Outcome<void> try_array(const std::filesystem::path& file) {
    auto array = ArrayFile::open(file);
    if (!array) return tl::unexpected(array.error());
    if (array->shape()[0] == 0) return {};  // there is no frame to read
    std::int64_t numbers = 1;
    for (std::size_t axis = 1; axis < array->shape().size(); ++axis) numbers *= array->shape()[axis];
    std::vector<float> frame(static_cast<std::size_t>(numbers));
    for (std::int64_t i = 0; i < std::min<std::int64_t>(array->shape()[0], 4); ++i) {
        if (const auto read = array->read_frame(frame); !read) return tl::unexpected(read.error());
        if (const auto sound = check_numbers(frame, -kMost, kMost, "a number"); !sound) return sound;
    }
    return {};
}

}  // namespace

const TriedReader kTriedNpy{"npy", "x.npy", try_array};

}  // namespace game::test
