#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "game/base/outcome.h"

namespace game::test {

// A reader of files from untrusted sources.
struct TriedReader {
    std::string_view name;       // of its fuzz target, NAME_fuzz, and of its seed folder
    std::string_view file_name;  // with the extension that the reader expects
    // Reads the file and checks what was accepted. kBadAnswer: the result breaks a promise of the reader.
    Outcome<void> (*read)(const std::filesystem::path& file);
};

// All readers except the one of recordings, which try_recording.h tries, and the world of a page, which opens one. Each is in try_NAME.cpp.
extern const TriedReader kTriedScene, kTriedMaterial, kTriedObj, kTriedNpy, kTriedGeojson, kTriedDem,
    kTriedPicture, kTriedEnsemble, kTriedJournal, kTriedLive, kTriedCameraPath, kTriedLesson, kTriedLanguage;

// Writes `bytes` into a file in `folder` and reads it. Returns what went wrong,
// or nothing: either the file is accepted and the result keeps the reader's
// promises, or it is refused with status 2 and a sentence that names it.
std::string fault_of_reading(const TriedReader& reader, const std::filesystem::path& folder,
                             std::string_view bytes);

// For checks of accepted files:

constexpr int kTriedSquares = 16;  // whatever a file requests, so that a try is fast

inline tl::unexpected<Failure> broken(std::string fact) {
    return tl::unexpected(Failure{Failure::kBadAnswer, std::move(fact)});
}
// Checks that each value of a field is in this range, inclusive.
Outcome<void> check_numbers(const std::vector<float>& field, float least, float most, const char* what);

}  // namespace game::test
