#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "game/base/outcome.h"
#include "game/session/loaded_world.h"
#include "game/share/slide_page.h"

namespace game {

// Plays a recording and writes the page of it, until its slide comes to rest. That of an untouched challenge asks to beat the best run on this machine. Errors: as read_recording() and SlidePage. With `stop` set it ends with a
// failure and nothing is written. `progress` becomes the share that is done, 0 to 1. Both may be null.
Outcome<PageReport> write_page_of(const std::filesystem::path& recording, const std::filesystem::path& page,
                                  PageOptions options, const std::atomic<bool>* stop,
                                  std::atomic<float>* progress);

// Makes the page of what was opened: of a recording, its slide; of a scene that does something by itself, its slide until it
// comes to rest; of a challenge and of any other world, an untouched one, in which whoever opens the page takes over at tick
// 0. A challenge asks to beat the best run on this machine. Errors: as SlidePage.
Outcome<MadePage> make_page_of_loaded(const LoadedWorld& world, PageOptions options);
// The same into a file.
Outcome<PageReport> write_page_of_loaded(const LoadedWorld& world, const std::filesystem::path& page,
                                         PageOptions options);

// The command by which anybody with a recording repeats its slide and compares the states. `recording`: name of a shipped
// one, which everybody has, or a file.
std::string proof_of(const std::filesystem::path& recording);

}  // namespace game
