#pragma once

#include <string_view>
#include <utility>

#include <sys/types.h>

namespace files {

// Owns an open file descriptor. Failures leave their reason in errno.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { static_cast<void>(close()); }

    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }
    // Writes every byte; on failure some may be written.
    bool write(std::string_view bytes) const;
    // Whether the system has stored all that was written; some systems report that only when a file is
    // closed. The descriptor stays open.
    bool settle() const;
    // Truncates a regular file to this length and continues there.
    bool cut(off_t length) const;
    bool close();

  private:
    int number_;
};

}  // namespace files
