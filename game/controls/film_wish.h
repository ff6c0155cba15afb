#pragma once

#include "game/controls/film_camera.h"

namespace game {

// How a person wants a slide filmed.
struct FilmWish {
    enum class Kind : std::uint8_t { kMp4, kWebm, kMkv };

    FilmView view = FilmView::kScene;  // kScene: from where it is seen now
    int width = 1280, height = 720;    // pixels
    int fps = 30;
    Kind kind = Kind::kMp4;
    bool silent = false;
    bool operator==(const FilmWish&) const = default;
};

// Where films end, with the dot.
constexpr const char* ending_of(FilmWish::Kind kind) {
    constexpr const char* kEndings[]{".mp4", ".webm", ".mkv"};
    return kEndings[static_cast<int>(kind)];
}

}  // namespace game
