#include "files/growing_file.h"

#include <cerrno>
#include <cstdio>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "files/destination.h"
#include "files/lock.h"
#include "files/new_file.h"

namespace files {
namespace {

namespace fs = std::filesystem;

// Whether the open file is still the one of that name.
bool is_in_place(int file, const fs::path& path) {
    struct stat opened {
    }, named{};
    return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
           opened.st_ino == named.st_ino;
}

bool is_empty(int file) {
    struct stat status {};
    return fstat(file, &status) == 0 && status.st_size == 0;
}

}  // namespace

GrowingFile::GrowingFile(GrowingFile&& other) noexcept {
    *this = std::move(other);
}

GrowingFile& GrowingFile::operator=(GrowingFile&& other) noexcept {
    std::swap(replaces_, other.replaces_);
    target_.swap(other.target_), place_.swap(other.place_), kept_.swap(other.kept_);
    std::swap(file_, other.file_), std::swap(replaced_, other.replaced_);
    std::swap(appeared_, other.appeared_);
    return *this;
}

GrowingFile::~GrowingFile() {
    if (regular() && file_ && !appeared_) unlink(place_.c_str());
}

GrowingFile::Fault GrowingFile::open(const fs::path& path, Replaces replaces) {
    using Kind = Destination::Kind;
    replaces_ = replaces;
    const Destination to = destination_of(path);
    place_ = to.path;
    if (to.kind == Kind::kDescriptor) {
        std::fflush(nullptr);  // earlier output comes first
        file_ = Descriptor(fcntl(to.descriptor, F_DUPFD_CLOEXEC, 3));
        return file_ ? Fault::kNone : Fault::kSystem;
    }
    if (to.kind == Kind::kThrough) {
        file_ = Descriptor(::open(place_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
        return file_ ? Fault::kNone : Fault::kSystem;
    }
    target_ = to.path;
    constexpr int kMostTries = 1000;  // another program may create and delete the name meanwhile
    for (int n = 0; n < kMostTries; ++n) {
        replaced_ = Descriptor(::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
        if (!replaced_ && errno != ENOENT) return Fault::kSystem;
        if (!replaced_) {
            const Fault fault = open_new();
            if (fault == Fault::kSystem && errno == EEXIST) continue;
            return fault;
        }
        if (!lock(replaced_.number())) return Fault::kBeingWritten;
        if (is_in_place(replaced_.number(), target_)) return open_beside();
    }
    return Fault::kSystem;
}

// There is nothing of that name.
GrowingFile::Fault GrowingFile::open_new() {
    if (replaces_ == Replaces::kWhenDone) return open_beside();
    file_ = Descriptor(::open(target_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOCTTY, 0666));
    return lock_own();
}

GrowingFile::Fault GrowingFile::open_beside() {
    NewFile beside = create_beside(target_);
    file_ = std::move(beside.file), place_ = std::move(beside.path);
    return lock_own();
}

GrowingFile::Fault GrowingFile::lock_own() {
    if (!file_) return Fault::kSystem;
    if (lock(file_.number())) return Fault::kNone;
    file_ = Descriptor();  // another program was faster: the file is its own
    return Fault::kBeingWritten;
}

bool GrowingFile::appear() {
    if (appeared_ || !regular()) return true;
    if (place_ != target_ && !replace()) return false;
    place_ = target_;
    replaced_ = Descriptor();
    return appeared_ = true;
}

// At every moment there is a file of the name, if the file system has hard links.
bool GrowingFile::replace() {
    if (replaces_ == Replaces::kAsItGrows && replaced_ && !is_empty(replaced_.number())) {
        fs::path kept = name_to_keep(target_);
        if (link(target_.c_str(), kept.c_str()) != 0 && rename(target_.c_str(), kept.c_str()) != 0)
            return false;
        kept_ = std::move(kept);
    }
    if (rename(place_.c_str(), target_.c_str()) == 0) return true;
    const int reason = errno;
    if (kept_) rename(kept_->c_str(), target_.c_str());  // nothing, if it is a link
    delete_kept();
    errno = reason;
    return false;
}

void GrowingFile::delete_kept() {
    if (kept_) unlink(kept_->c_str());
    kept_.reset();
}

}  // namespace files
