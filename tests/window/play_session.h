#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/window/x_session.h"

namespace game::test {

// The sandbox in a window, on a small slope where nothing happens without input, with its panels hidden; and
// its recording, as text.
class PlaySession {
  public:
    static constexpr int kWidth = 640, kHeight = 400;                    // of the window
    static constexpr int kMiddleX = kWidth / 2, kMiddleY = kHeight / 2;  // on the mountain

    // Returns once the simulation runs.
    PlaySession();

    XSession& hand() { return desktop_; }
    std::filesystem::path recording() const { return desktop_.folder() / "session.couloir"; }

    // The complete lines now in the file, without the first.
    std::vector<nlohmann::json> lines() const;
    // The commands of one kind ("pour") among them.
    std::vector<nlohmann::json> commands(const std::string& kind) const;
    std::size_t commands() const;  // of any kind
    nlohmann::json last_state() const;
    std::int64_t tick() const { return last_state().value("tick", std::int64_t{-1}); }

    // Whether their number reaches `count` soon.
    bool comes_to(const std::string& kind, std::size_t count) const;
    // Whether the simulation advances by that many ticks soon.
    bool runs(std::int64_t ticks = 12) const;
    // Whether it stays at the current tick.
    bool stands() const;

    // Quits by the keyboard and checks the exit status, the file's name on standard output, the end in the
    // file, and its replay.
    void leave();
    // The same if something else has ended the program, or is about to.
    void check_ending();
    // Replays the file without a window and compares every state; prints its last hash.
    void check_replay() const;

  private:
    XSession desktop_;
};

}  // namespace game::test
