#pragma once

#include <filesystem>
#include <optional>

#include "files/descriptor.h"

namespace files {

// A file that is written as its content happens, by one writer: it is locked meanwhile. What its name holds already is
// whole until appear(), and a file that never appears leaves nothing behind. A link to a file stays and its target is
// replaced. A device, FIFO or descriptor of this process is written through.
class GrowingFile {
  public:
    enum class Replaces {
        kAsItGrows,  // a new name shows it from the start; what it replaces is kept beside it
        kWhenDone,   // nobody sees it before appear(), which deletes what it replaces
    };
    enum class Fault { kNone, kSystem, kBeingWritten };  // kSystem: the reason is in errno

    // A file that has no writer yet.
    GrowingFile() = default;
    Fault open(const std::filesystem::path& path, Replaces replaces);
    GrowingFile(GrowingFile&& other) noexcept;
    GrowingFile& operator=(GrowingFile&& other) noexcept;
    ~GrowingFile();

    const Descriptor& file() const { return file_; }
    // False: a device or a pipe, whose bytes cannot be taken back.
    bool regular() const { return !target_.empty(); }
    // Where its bytes are now.
    const std::filesystem::path& place() const { return place_; }

    // Takes its name, once; later calls do nothing. False on failure, with the reason in errno.
    bool appear();
    // What it replaced, while that is kept.
    const std::optional<std::filesystem::path>& kept() const { return kept_; }
    void delete_kept();

  private:
    Fault open_new();
    Fault open_beside();
    Fault lock_own();
    bool replace();

    Replaces replaces_ = Replaces::kAsItGrows;
    std::filesystem::path target_;  // that it is going to be; empty if written through
    std::filesystem::path place_;
    Descriptor file_, replaced_;  // both locked; replaced_ is what target_ holds until appear()
    bool appeared_ = false;
    std::optional<std::filesystem::path> kept_;
};

}  // namespace files
