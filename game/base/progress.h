#pragma once

#include <chrono>
#include <string>

namespace game {

// A progress bar on standard error, shown only if that is a terminal. It is drawn at most ten times a second
// and erased by the destructor.
class Progress {
  public:
    // `what`: of the work; empty: nothing is shown.
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `share`: fraction of the work done, 0 to 1, or negative if unknown. `note` is printed after the bar.
    void show(double share, const std::string& note);

  private:
    std::string what_;
    bool terminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace game
