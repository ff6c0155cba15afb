#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "game/outcome.h"
#include "game/recording/format.h"

namespace game {

// Writes a recording as it happens: every line is flushed before the world goes on, so that what was done
// survives a `kill -9` up to its last whole line. Errors of all calls: the file cannot be written (status 3).
class Recorder {
  public:
    // Begins the file, replacing any that has this name; makes its folder.
    static Outcome<Recorder> create(const std::filesystem::path& path, const Start& start);

    Outcome<void> command(const TimedCommand& command);
    Outcome<void> state(const StateLine& line);
    Outcome<void> end(std::int64_t tick);

    const std::filesystem::path& path() const { return path_; }

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    Recorder(std::filesystem::path path, std::FILE* file) : path_(std::move(path)), file_(file) {}
    Outcome<void> write(const Json& json);

    std::filesystem::path path_;
    std::unique_ptr<std::FILE, Close> file_;
    Chain chain_;
};

}  // namespace game
