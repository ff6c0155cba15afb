#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

#include "game/outcome.h"

namespace game {

// A file that is whole or not there: written piece by piece beside its target, and renamed when it is
// finished. One that is never finished goes with the object. Errors: status 3.
class WholeFile {
  public:
    static Outcome<WholeFile> open(const std::filesystem::path& path);  // makes its folder
    WholeFile(WholeFile&& other) noexcept;
    ~WholeFile();

    Outcome<void> write(std::string_view text);
    Outcome<void> finish();

  private:
    explicit WholeFile(const std::filesystem::path& path);
    tl::unexpected<Failure> failed(const std::string& reason) const;

    std::filesystem::path path_, beside_;  // beside_: empty when there is nothing to clear away
    std::ofstream stream_;
};

// Writes a whole file beside `path` and renames it, so that nobody sees half of one; makes its folder.
// Errors: status 3.
Outcome<void> write_text(const std::filesystem::path& path, std::string_view text);

// Whether write_text() would find a place for this file; makes its folder. To be asked before long work whose
// result goes there. Errors: status 3.
Outcome<void> make_place_for(const std::filesystem::path& path);

// Makes a folder that can be written into. Errors: status 3.
Outcome<void> make_folder(const std::filesystem::path& path);

}  // namespace game
