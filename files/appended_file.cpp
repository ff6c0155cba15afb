#include "files/appended_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "files/lock.h"

namespace files {
namespace {

tl::unexpected<std::string> failure(const std::filesystem::path& path, std::string_view fact) {
    return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
}

// Reads on until the end or the first `most` bytes. Returns false on failure, with the reason in errno.
bool read_all(int file, std::size_t most, std::string& text) {
    text.clear();
    char block[1 << 16];
    while (text.size() < most) {
        const ssize_t count = ::read(file, block, sizeof block);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return count == 0;
        text.append(block, static_cast<std::size_t>(count));
    }
    return true;
}

}  // namespace

tl::expected<AppendedFile, std::string> AppendedFile::open(const std::filesystem::path& path,
                                                           std::size_t most, std::string& text) {
    Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0666));
    struct stat status {};
    if (!file || fstat(file.number(), &status) != 0) return failure(path, std::strerror(errno));
    if (!S_ISREG(status.st_mode)) return failure(path, "is not a regular file");
    if (!lock(file.number())) return failure(path, "another process writes it");
    if (static_cast<std::size_t>(status.st_size) > most)
        return failure(path, fmt::format("has {} bytes; at most {} are read", status.st_size, most));
    if (!read_all(file.number(), most, text)) return failure(path, std::strerror(errno));
    return AppendedFile(path, std::move(file), text.size());
}

tl::unexpected<std::string> AppendedFile::failed() const {
    return failure(path_, std::strerror(errno));
}

Written AppendedFile::cut(std::size_t length) {
    if (length == length_) return {};
    if (!file_.cut(static_cast<off_t>(length))) return failed();
    length_ = length;
    return {};
}

Written AppendedFile::add(std::string_view bytes) {
    if (file_.write(bytes)) {
        length_ += bytes.size();
        return {};
    }
    const int reason = errno;
    static_cast<void>(file_.cut(static_cast<off_t>(length_)));  // what was written of it
    errno = reason;
    return failed();
}

}  // namespace files
