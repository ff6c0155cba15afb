#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/window/x_session.h"

namespace game::test {

// The sandbox in a window, on a small slope where nothing happens that a hand does not do, with its panels
// out of the way; and its recording, as text.
class PlaySession {
  public:
    static constexpr int kWidth = 640, kHeight = 400;                    // of the window
    static constexpr int kMiddleX = kWidth / 2, kMiddleY = kHeight / 2;  // on the mountain

    // Returns once the world runs.
    PlaySession();

    XSession& hand() { return desktop_; }
    std::filesystem::path recording() const { return desktop_.folder() / "session.couloir"; }

    // Whole lines but the first, as they stand in the file now.
    std::vector<nlohmann::json> lines() const;
    // What stands under one kind of command ("pour") in them.
    std::vector<nlohmann::json> commands(const std::string& kind) const;
    std::size_t commands() const;  // of whatever kind
    nlohmann::json last_state() const;
    std::int64_t tick() const { return last_state().value("tick", std::int64_t{-1}); }

    // Whether it comes to be so many, soon.
    bool comes_to(const std::string& kind, std::size_t count) const;
    // Whether the world gets that many ticks further, soon.
    bool runs(std::int64_t ticks = 12) const;
    // Whether it stays at the tick where it is.
    bool stands() const;

    // Leaves by the keyboard and checks that all went well: exit status, the file's name on standard output,
    // the end in the file, and its replay.
    void leave();
    // The same where something else has ended the program, or is about to.
    void check_ending();
    // Replays the file without a window and compares every state; prints its last hash.
    void check_replay() const;

  private:
    XSession desktop_;
};

}  // namespace game::test
