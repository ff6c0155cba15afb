#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "files/descriptor.h"

namespace files {

using Written = tl::expected<void, std::string>;

// An atomically written file: written piece by piece beside its target, and renamed when it is finished; the
// destructor deletes an unfinished one. A link to a file stays and its target is replaced. A device, FIFO or
// descriptor of this process is written through. An error is one sentence that names the file as given.
class WholeFile {
  public:
    static tl::expected<WholeFile, std::string> open(const std::filesystem::path& path);
    WholeFile(WholeFile&& other) noexcept;
    WholeFile& operator=(WholeFile&&) = delete;
    ~WholeFile();

    Written write(std::string_view bytes);
    Written finish();

  private:
    explicit WholeFile(std::filesystem::path path) : path_(std::move(path)) {}
    Written open_beside();
    tl::unexpected<std::string> failed(int number) const;
    tl::unexpected<std::string> failed(std::string_view fact) const;

    std::filesystem::path path_;    // as given
    std::filesystem::path target_;  // the file that it replaces; empty if written through
    std::filesystem::path beside_;  // deleted if never finished
    Descriptor file_;
};

// Writes a whole file in one call.
Written write(const std::filesystem::path& path, std::string_view bytes);

}  // namespace files
