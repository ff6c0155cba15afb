#include "files/destination.h"

#include <charconv>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace files {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // the kernel's limit

// N if `path` is /proc/self/fd/N by any name, and N is open.
std::optional<int> descriptor_of(const fs::path& path) {
    std::error_code error;
    const fs::path own = fs::canonical("/proc/self/fd", error);
    if (error || fs::canonical(path.parent_path(), error) != own || error) return std::nullopt;
    const std::string name = path.filename().string();
    int number = -1;
    const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (fault != std::errc() || end != name.data() + name.size()) return std::nullopt;
    return fcntl(number, F_GETFD) >= 0 ? std::optional(number) : std::nullopt;
}

std::optional<Identity> identity_of(const struct stat& status) {
    if (S_ISCHR(status.st_mode) || S_ISDIR(status.st_mode)) return std::nullopt;
    return Identity{status.st_dev, status.st_ino, {}};
}

}  // namespace

Destination destination_of(const fs::path& path) {
    using Kind = Destination::Kind;
    fs::path at = path;
    std::error_code error;
    for (int links = 0; links < kMostLinks && fs::is_symlink(at, error); ++links) {
        if (const auto number = descriptor_of(at)) return {Kind::kDescriptor, at, *number};
        const fs::path next = fs::read_symlink(at, error);
        if (error) break;
        at = at.parent_path() / next;  // an absolute one replaces it all
    }
    struct stat status {};
    if (stat(at.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return {Kind::kFile, at};
    return {S_ISDIR(status.st_mode) ? Kind::kFolder : Kind::kThrough, at};
}

std::optional<Identity> identity_of(const fs::path& path) {
    const Destination destination = destination_of(path);
    if (destination.kind == Destination::Kind::kDescriptor) return identity_of(destination.descriptor);
    struct stat status {};
    if (stat(destination.path.c_str(), &status) == 0) return identity_of(status);
    std::error_code error;
    fs::path name = fs::weakly_canonical(fs::absolute(destination.path, error), error);
    return Identity{0, 0, error ? destination.path : name};
}

std::optional<Identity> identity_of(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0) return std::nullopt;
    return identity_of(status);
}

}  // namespace files
