#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "files/descriptor.h"
#include "files/whole_file.h"

namespace files {

// A regular file to whose end one process at a time adds. An error is one sentence that names the file.
class AppendedFile {
  public:
    // Opens the file, or makes it, and reads what it holds so far into `text`. Errors: it cannot be opened, is no regular
    // file, has more than `most` bytes, or another process has it open in this way.
    static tl::expected<AppendedFile, std::string> open(const std::filesystem::path& path, std::size_t most,
                                                        std::string& text);
    // Keeps its first `length` bytes.
    Written cut(std::size_t length);
    // Whole, or not at all; passed to the system before it returns.
    Written add(std::string_view bytes);

  private:
    AppendedFile(std::filesystem::path path, Descriptor file, std::size_t length)
        : path_(std::move(path)), file_(std::move(file)), length_(length) {}
    tl::unexpected<std::string> failed() const;

    std::filesystem::path path_;
    Descriptor file_;
    std::size_t length_;
};

}  // namespace files
