#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

#include "files/new_file.h"
#include "game/base/outcome.h"

namespace game {

// An empty file beside another, for a program that takes a name: deleted with the object, unless it has become that other
// file.
class PartFile {
  public:
    // Errors (status 3): none can be made there.
    static Outcome<PartFile> beside(const std::filesystem::path& target) {
        files::NewFile made = files::create_beside(target);
        if (!made.file)
            return machine_fails(
                fmt::format("{}: cannot be written: {}", target.string(), std::strerror(errno)));
        return PartFile(std::move(made.path));
    }
    PartFile(PartFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    PartFile& operator=(PartFile&& other) noexcept {
        std::swap(path_, other.path_);
        return *this;
    }
    ~PartFile() {
        if (!path_.empty()) unlink(path_.c_str());
    }

    const std::filesystem::path& path() const { return path_; }
    // Takes the place of `target`. Errors (status 3): it cannot.
    Outcome<void> become(const std::filesystem::path& target) {
        if (std::rename(path_.c_str(), target.c_str()) != 0)
            return machine_fails(
                fmt::format("{}: cannot be written: {}", target.string(), std::strerror(errno)));
        path_.clear();
        return {};
    }

  private:
    explicit PartFile(std::filesystem::path path) : path_(std::move(path)) {}

    std::filesystem::path path_;
};

}  // namespace game
