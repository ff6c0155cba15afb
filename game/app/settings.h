#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "game/base/outcome.h"
#include "game/controls/display.h"
#include "game/controls/key_map.h"
#include "game/controls/tier.h"

namespace game {

// What a window begins with as a person left it.
struct Settings {
    static constexpr int kLeastSide = 160, kMostSide = 16384;  // of a window

    Display display;            // of it what a person sets for good: no colours, no sun, no flow demo
    std::optional<Tier> tier;   // none: measured
    int width = 0, height = 0;  // of the window, before the monitor's scale; 0: the usual ones
    bool fullscreen = false;
    KeyMap keys;
    bool operator==(const Settings&) const = default;
};

// Settings in couloir/settings.toml in the XDG configuration folder. A damaged file is set aside as settings.toml.damaged. One of a
// newer program, or one that cannot be read, stays as it is, and nothing is kept over it.
class SettingsFile {
  public:
    static constexpr int kVersion = 1;

    // None: nothing is read or kept.
    SettingsFile() = default;
    // Reads the file, if there is one.
    static SettingsFile of_user();

    // As they were read; the usual ones if they were not.
    const Settings& begun() const { return begun_; }
    // What was wrong, for the person; empty: nothing.
    const std::string& told() const { return told_; }

    // Once a frame: writes settings that differ from those in the file, once they have stayed for a second. Errors, told once: the file cannot be written (3).
    Outcome<void> see(const Settings& now, double now_s);
    // The same at once, at the end.
    Outcome<void> finish(const Settings& now);

  private:
    Outcome<void> write(const Settings& now);

    std::optional<std::filesystem::path> path_;  // none: not kept
    Settings begun_, kept_, seen_;               // at the start; in the file; last
    double since_s_ = 0;                         // seen_
    std::string told_;
};

}  // namespace game
