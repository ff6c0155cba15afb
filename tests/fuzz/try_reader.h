#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "game/base/outcome.h"

namespace game::test {

// A reader of files that come from strangers.
struct TriedReader {
    std::string_view name;       // of its fuzz target, NAME_fuzz, and of its folder of seeds
    std::string_view file_name;  // with the extension that it goes by
    // Reads the file and looks at what was accepted. kBadAnswer: it is not what the reader promises.
    Outcome<void> (*read)(const std::filesystem::path& file);
};

// All but the reader of recordings, which try_recording.h tries. Each is in try_NAME.cpp.
extern const TriedReader kTriedScene, kTriedMaterial, kTriedObj, kTriedNpy, kTriedGeojson, kTriedDem,
    kTriedPicture;

// Writes `bytes` into a file in `folder` and reads that. Returns what is wrong with how that went, which is
// nothing: either the file is accepted and is what the reader promises, or it is refused with status 2 and
// a sentence that names it.
std::string fault_of_reading(const TriedReader& reader, const std::filesystem::path& folder,
                             std::string_view bytes);

// For what looks at accepted files:

constexpr int kTriedSquares = 16;  // whatever a file says, so that a try is over in a moment

inline tl::unexpected<Failure> broken(std::string fact) {
    return tl::unexpected(Failure{Failure::kBadAnswer, std::move(fact)});
}
// Whether each number of a field lies between these, both included.
Outcome<void> check_numbers(const std::vector<float>& field, float least, float most, const char* what);

}  // namespace game::test
