#include "files/new_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>

#include <fmt/format.h>

namespace files {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTries = 1000;

}  // namespace

NewFile create_beside(const fs::path& target) {
    for (int n = 1; n <= kMostTries; ++n) {
        fs::path name = target;
        name += n == 1 ? ".part" : fmt::format(".{}.part", n);
        if (Descriptor file(open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)); file)
            return {std::move(file), std::move(name)};
        if (errno != EEXIST) break;
    }
    return {Descriptor(), {}};
}

fs::path name_to_keep(const fs::path& target) {
    std::error_code error;
    fs::path name;
    for (int n = 1; n <= kMostTries; ++n) {
        name = target.parent_path() / target.stem();
        name += n == 1 ? ".before" : fmt::format(".before{}", n);
        name += target.extension();
        if (!fs::exists(fs::symlink_status(name, error))) break;
    }
    return name;
}

}  // namespace files
