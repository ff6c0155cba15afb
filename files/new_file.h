#pragma once

#include <filesystem>

#include "files/descriptor.h"

namespace files {

// A file that did not exist before, open for writing.
struct NewFile {
    Descriptor file;  // none on failure, with the reason in errno
    std::filesystem::path path;
};

// Creates a file beside `target` that can take its place: NAME.part, or NAME.2.part if that belongs to somebody.
NewFile create_beside(const std::filesystem::path& target);

// A name beside `target` that nobody uses, for what its place is taken from: NAME.before.couloir for NAME.couloir.
std::filesystem::path name_to_keep(const std::filesystem::path& target);

}  // namespace files
