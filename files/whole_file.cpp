#include "files/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "files/destination.h"
#include "files/lock.h"
#include "files/new_file.h"

namespace files {
namespace {

constexpr const char* kBeingWritten = "another program is recording into it";

}  // namespace

WholeFile::WholeFile(WholeFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      beside_(std::exchange(other.beside_, {})),
      file_(std::move(other.file_)) {}

WholeFile::~WholeFile() {
    if (!beside_.empty()) unlink(beside_.c_str());
}

tl::expected<WholeFile, std::string> WholeFile::open(const std::filesystem::path& path) {
    using Kind = Destination::Kind;
    const Destination destination = destination_of(path);
    WholeFile file(path);
    switch (destination.kind) {
        case Kind::kFolder:
            return tl::unexpected(fmt::format("{}: is a folder, not a file", path.string()));
        case Kind::kDescriptor:
            std::fflush(nullptr);  // flush earlier output first
            file.file_ = Descriptor(fcntl(destination.descriptor, F_DUPFD_CLOEXEC, 3));
            break;
        case Kind::kThrough:
            file.file_ = Descriptor(::open(destination.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
            break;
        case Kind::kFile:
            file.target_ = destination.path;
            if (auto opened = file.open_beside(); !opened) return tl::unexpected(opened.error());
    }
    if (!file.file_) return file.failed(errno);
    return file;
}

Written WholeFile::open_beside() {
    if (is_locked(target_)) return failed(kBeingWritten);
    NewFile beside = create_beside(target_);
    file_ = std::move(beside.file), beside_ = std::move(beside.path);
    return {};
}

Written WholeFile::write(std::string_view bytes) {
    if (!file_.write(bytes)) return failed(errno);
    return {};
}

Written WholeFile::finish() {
    if (!file_.close()) return failed(errno);
    if (target_.empty()) return {};
    if (is_locked(target_)) return failed(kBeingWritten);
    if (rename(beside_.c_str(), target_.c_str()) != 0) return failed(errno);
    beside_.clear();
    return {};
}

tl::unexpected<std::string> WholeFile::failed(int number) const {
    return failed(std::strerror(number));
}
tl::unexpected<std::string> WholeFile::failed(std::string_view fact) const {
    return tl::unexpected(fmt::format("{}: cannot be written: {}", path_.string(), fact));
}

Written write(const std::filesystem::path& path, std::string_view bytes) {
    auto file = WholeFile::open(path);
    if (!file) return tl::unexpected(file.error());
    if (auto written = file->write(bytes); !written) return written;
    return file->finish();
}

}  // namespace files
