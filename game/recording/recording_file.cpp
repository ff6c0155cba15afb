#include "game/recording/recording_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "files/input.h"

namespace game {
namespace {

tl::unexpected<Failure> cannot_write(const std::filesystem::path& path) {
    return machine_fails(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
}

class FileStore final : public RecordingStore {
  public:
    static Outcome<std::unique_ptr<RecordingStore>> open(const std::filesystem::path& path,
                                                         RecordingReplaces replaces) {
        using Fault = files::GrowingFile::Fault;
        auto store = std::make_unique<FileStore>(path, replaces);
        std::error_code error;
        if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
        switch (store->to_.open(path, replaces)) {
            case Fault::kNone:
                return store;
            case Fault::kSystem:
                return cannot_write(path);
            case Fault::kBeingWritten:
                break;
        }
        return machine_fails(fmt::format(
            "{}: another program is recording into it; close that program, or choose another file",
            path.string()));
    }

    FileStore(std::filesystem::path path, RecordingReplaces replaces)
        : path_(std::move(path)), replaces_(replaces) {}

    Outcome<void> write(std::string_view line, bool is_header) override {
        if (!to_.file().write(line)) {
            const auto failed = cannot_write(path_);
            if (to_.regular()) static_cast<void>(to_.file().cut(static_cast<off_t>(bytes_)));
            return failed;
        }
        bytes_ += static_cast<std::int64_t>(line.size());
        return is_header || replaces_ == RecordingReplaces::kWhenDone ? Outcome<void>() : appear();
    }
    Outcome<void> cut(std::int64_t bytes) override {
        if (!to_.file().cut(static_cast<off_t>(bytes))) return cannot_write(path_);
        bytes_ = bytes;
        return {};
    }
    Outcome<std::string> read(std::int64_t bytes) const override {
        auto file = files::open_input(to_.place());
        if (!file) return machine_fails(file.error());
        std::string copy(static_cast<std::size_t>(bytes), '\0');
        if (!file->read(copy.data(), bytes))
            return machine_fails(fmt::format("{}: has lost what was recorded into it", path_.string()));
        return copy;
    }
    Outcome<void> end() override {
        if (!to_.file().settle()) return cannot_write(path_);
        return appear();
    }

    std::string name() const override { return path_.string(); }
    Open again() const override { return into_file(path_, replaces_); }
    std::optional<std::string> replaced() const override {
        return to_.kept() ? std::optional(to_.kept()->string()) : std::nullopt;
    }
    void delete_replaced() override { to_.delete_kept(); }

  private:
    Outcome<void> appear() {
        if (!to_.appear()) return cannot_write(path_);
        return {};
    }

    std::filesystem::path path_;
    RecordingReplaces replaces_;
    files::GrowingFile to_;
    std::int64_t bytes_ = 0;  // written whole
};

}  // namespace

Outcome<Recording> read_recording(const std::filesystem::path& path, const Memory& memory) {
    auto file = files::open_input(path);
    if (!file) return unusable(file.error());
    return read_recording(*file, path.string(), memory);
}

Outcome<Recorder> record_into(const std::filesystem::path& path, const Scenario& scenario,
                              std::optional<Parent> parent) {
    Header header;
    header.scenario = scenario;
    header.parent = std::move(parent);
    return record_into(path, header);
}

Outcome<Recorder> record_into(const std::filesystem::path& path, const Header& header,
                              RecordingReplaces replaces) {
    return Recorder::create(into_file(path, replaces), header);
}

RecordingStore::Open into_file(std::optional<std::filesystem::path> path, RecordingReplaces replaces) {
    return [path = std::move(path), replaces]() -> Outcome<std::unique_ptr<RecordingStore>> {
        if (!path) return unusable("no file to record to");
        return FileStore::open(*path, replaces);
    };
}

}  // namespace game
