#pragma once

#include <chrono>
#include <string>

namespace game {

// A bar on standard error while long work runs, where that is a terminal; nothing elsewhere. Drawn at most
// ten times a second, wiped when it goes.
class Progress {
  public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `share` of the work done, 0 to 1, or negative where nobody knows; `note` stands behind the bar.
    void show(double share, const std::string& note);

  private:
    std::string what_;
    bool terminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace game
