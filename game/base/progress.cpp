#include "game/base/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "game/base/one_line.h"

namespace game {

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(!what_.empty() && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(double share, const std::string& note) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (shown_ && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    constexpr int kWidth = 24;
    std::string bar;
    if (share >= 0) {
        const auto full = static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * kWidth));
        bar = fmt::format("[{}{}] {:3.0f} % ", std::string(full, '#'), std::string(kWidth - full, '.'),
                          100 * share);
    }
    fmt::print(stderr, "\r\x1b[K{} {}{}", one_line(what_), bar, one_line(note));
    std::fflush(stderr);
}

}  // namespace game
