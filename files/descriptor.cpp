#include "files/descriptor.h"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace files {

bool Descriptor::write(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t written = ::write(number_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

bool Descriptor::settle() const {
    Descriptor copy(fcntl(number_, F_DUPFD_CLOEXEC, 3));
    return copy && copy.close();
}

bool Descriptor::cut(off_t length) const {
    return ftruncate(number_, length) == 0 && lseek(number_, length, SEEK_SET) == length;
}

bool Descriptor::close() {
    return number_ < 0 || ::close(std::exchange(number_, -1)) == 0;
}

}  // namespace files
