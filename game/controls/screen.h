#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "game/controls/events.h"

namespace game {

// How large a screen is, and how much larger than usual its letters want to be.
struct ScreenSize {
    int width = 1280, height = 720;  // framebuffer, px; 0 while minimised
    double scale = 1;                // of the monitor: 2 where a letter needs twice the pixels
    bool operator==(const ScreenSize&) const = default;
};

// Where a sandbox is seen and from where it is handled. A window in the program, a script in tests. Owns a
// current GL 4.5 core context for as long as it lives.
class Screen {
  public:
    virtual ~Screen() = default;

    // What happened since the last call, in order; valid until the next. While the screen cannot be seen
    // (width or height 0) it waits for something to happen, at most a tenth of a second.
    virtual std::span<const Event> poll() = 0;
    virtual std::vector<std::filesystem::path> dropped() = 0;  // of the last DropEvent

    virtual ScreenSize size() const = 0;
    virtual unsigned framebuffer() const = 0;  // GL name to draw into
    virtual double seconds() const = 0;        // steady clock

    // Shows what was drawn; waits for the monitor where it has a rhythm.
    virtual void present() = 0;

    virtual void show_title(const std::string& title) = 0;
    virtual void set_fullscreen(bool on) = 0;
    virtual bool fullscreen() const = 0;
    virtual std::string clipboard() const = 0;
    virtual void set_clipboard(const std::string& text) = 0;
    virtual std::string renderer_name() const = 0;  // "llvmpipe …, 4.5 (Core Profile) …"
};

}  // namespace game
