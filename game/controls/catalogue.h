#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/files/shelf.h"

namespace game {

// The scenes, materials and recordings that can be opened, by name and title.
struct Catalogue {
    // Pixels of the picture of a shipped scene, which is NAME.jpg beside NAME.toml.
    static constexpr int kPictureWidth = 576, kPictureHeight = 324;
    enum class Kind : std::uint8_t { kChallenge, kMountain, kFlowDemo, kLesson };  // of what is played
    struct Best {
        std::int64_t score = 0;
        int medal = 0;  // 0 none to 3 gold
    };
    struct Entry {
        std::string name, title;
        std::filesystem::path file;  // a scene and a recording may share a name
        Kind kind = Kind::kMountain;
        std::string harder_than = {};         // the name of another challenge; empty: none
        std::optional<Best> best = {};        // run of a challenge that is known; read_catalogue() knows none
        std::string about = {};               // a sentence: of a challenge its task; may be empty
        std::int64_t difficulty = 0;          // of a challenge, 1 to SceneFile::kHardest; 0: not known
        bool is_weekly = false;               // another ground each week
        std::filesystem::path picture = {};   // of what a person has made; it may not exist
        std::optional<double> length_s = {};  // of such a recording, if it is known
    };
    std::vector<Entry> scenes;  // by kind; challenges from easy to hard, then by name
    std::vector<Entry> materials, recordings, lessons;
    // What the user has made, of each kind the newest first.
    std::array<std::vector<Entry>, kShelfKinds.size()> own;
    std::vector<Entry>& own_of(ShelfKind kind) { return own.at(static_cast<std::size_t>(kind)); }
    const std::vector<Entry>& own_of(ShelfKind kind) const { return own.at(static_cast<std::size_t>(kind)); }
};

// Reads everything except what the user has made. Errors: an asset cannot be found or read.
Outcome<Catalogue> read_catalogue();

// The newest of the user's files of a kind, at most kMostOnShelf.
inline constexpr std::size_t kMostOnShelf = 200;
std::vector<Catalogue::Entry> own_entries(ShelfKind kind);

}  // namespace game
