#include "files/lock.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace files {
namespace {

bool lock_as(int descriptor, int kind) {
    return flock(descriptor, kind | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

}  // namespace

bool lock(int descriptor) {
    return lock_as(descriptor, LOCK_EX);
}

bool is_locked(const std::filesystem::path& path) {
    // Non-blocking, in case a FIFO has replaced the file.
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return false;
    const bool free = lock_as(file, LOCK_SH);
    close(file);
    return !free;
}

}  // namespace files
