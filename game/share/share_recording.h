#pragma once

#include <atomic>
#include <filesystem>

#include "game/base/outcome.h"
#include "game/share/slide_page.h"

namespace game {

// Plays a recording and writes the page of it. Errors: as read_recording() and SlidePage. With `stop` set it ends with a
// failure and nothing is written. `progress` becomes the share that is done, 0 to 1. Both may be null.
Outcome<PageReport> write_page_of(const std::filesystem::path& recording, const std::filesystem::path& page,
                                  const PageOptions& options, const std::atomic<bool>* stop,
                                  std::atomic<float>* progress);

// Writes the page of a world in which nothing was done yet: whoever opens it takes over at tick 0. Errors: as SlidePage.
Outcome<PageReport> write_page_of_world(const Scenario& scenario, const std::filesystem::path& page,
                                        const PageOptions& options);

// The command by which anybody with a recording repeats its slide and compares the states. `recording`: name of a shipped
// one, which everybody has, or a file.
std::string proof_of(const std::filesystem::path& recording);

}  // namespace game
