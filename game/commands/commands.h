#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "game/gallery.h"
#include "game/outcome.h"
#include "game/scene.h"

namespace game {

// Options of each subcommand, as the command line gives them, and what runs them. Results go to standard
// output. Each returns its exit status, or why it ended early.

struct PictureOptions {
    std::optional<std::filesystem::path> folder;
    std::int64_t every = 60;  // ticks
    PictureSize size;
    std::string gl = "auto";
};

struct RunOptions {
    std::string scene;  // empty with a terrain
    std::optional<std::filesystem::path> terrain, release, reference;
    Wishes wishes;
    bool until_rest = false;
    std::optional<double> seconds;
    std::optional<std::filesystem::path> record, export_folder, perf, summary;
    PictureOptions pictures;
    int threads = 1;
    bool json = false;
};
Outcome<int> run(const RunOptions& options);

struct ReplayOptions {
    std::string recording;  // name or file
    std::optional<std::int64_t> until;
    bool verify = false;
    std::optional<std::filesystem::path> perf, summary;
    PictureOptions pictures;
    int threads = 1;
    bool json = false;
};
Outcome<int> replay(const ReplayOptions& options);

struct ListOptions {
    bool json = false;
};
Outcome<int> list(const ListOptions& options);

}  // namespace game
