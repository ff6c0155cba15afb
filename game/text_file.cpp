#include "game/text_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace game {

namespace fs = std::filesystem;

WholeFile::WholeFile(const fs::path& path) : path_(path), beside_(path) {
    beside_ += ".part";
    stream_.open(beside_, std::ios::binary);
}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : path_(std::move(other.path_)),
      beside_(std::exchange(other.beside_, {})),
      stream_(std::move(other.stream_)) {}

WholeFile::~WholeFile() {
    std::error_code ignored;
    if (!beside_.empty()) fs::remove(beside_, ignored);
}

Outcome<WholeFile> WholeFile::open(const fs::path& path) {
    if (auto placed = make_place_for(path); !placed) return tl::unexpected(placed.error());
    WholeFile file(path);
    if (!file.stream_) return file.failed(std::strerror(errno));
    return file;
}

Outcome<void> WholeFile::write(std::string_view text) {
    stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream_) return failed(std::strerror(errno));
    return {};
}

Outcome<void> WholeFile::finish() {
    stream_.close();
    if (!stream_) return failed(std::strerror(errno));
    std::error_code error;
    fs::rename(beside_, path_, error);
    if (error) return failed(error.message());
    beside_.clear();
    return {};
}

tl::unexpected<Failure> WholeFile::failed(const std::string& reason) const {
    return machine_fails(fmt::format("{}: cannot be written: {}", path_.string(), reason));
}

Outcome<void> write_text(const fs::path& path, std::string_view text) {
    auto file = WholeFile::open(path);
    if (!file) return tl::unexpected(file.error());
    if (auto written = file->write(text); !written) return written;
    return file->finish();
}

Outcome<void> make_place_for(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return machine_fails(fmt::format("{}: is a folder, not a file", path.string()));
    return path.has_parent_path() ? make_folder(path.parent_path()) : Outcome<void>();
}

Outcome<void> make_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) return machine_fails(fmt::format("{}: cannot be made: {}", path.string(), error.message()));
    if (!fs::is_directory(path)) return machine_fails(fmt::format("{}: is not a folder", path.string()));
    if (access(path.c_str(), W_OK | X_OK) != 0)
        return machine_fails(
            fmt::format("{}: cannot be written into: {}", path.string(), std::strerror(errno)));
    return {};
}

}  // namespace game
