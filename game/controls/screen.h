#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/controls/events.h"
#include "game/controls/keyboard.h"

namespace game {

// Size and scale of a screen.
struct ScreenSize {
    int width = 1280, height = 720;  // framebuffer, px; 0 while minimised
    double scale = 1;                // of the monitor: 2 if text needs twice the pixels
    bool operator==(const ScreenSize&) const = default;
};

// What the graphics driver reports.
enum class DeviceFault {
    kNone,
    kOutOfMemory,
    kRefused,  // it cannot draw into buffers of this format or size
    kLost,     // it was reset, and every GL object is gone
};

// The display and input device of a sandbox: a window in the program, a script in tests. Owns a current GL
// 4.5 core context during its lifetime.
class Screen {
  public:
    virtual ~Screen() = default;

    // Events since the last call, in order; valid until the next call. While the screen is hidden (width or
    // height 0), waits for an event for at most 0.1 s.
    virtual std::span<const Event> poll() = 0;
    virtual std::vector<std::filesystem::path> dropped() = 0;  // paths of the last DropEvent
    virtual const KeyboardLayout& layout() const = 0;          // of the keyboard, as of the last poll()

    // The gamepad, as of the last poll(); nothing: there is none.
    virtual const std::optional<PadState>& pad() const = 0;
    virtual std::string pad_name() const = 0;

    virtual ScreenSize size() const = 0;
    virtual unsigned framebuffer() const = 0;  // GL name to draw into
    virtual double seconds() const = 0;        // steady clock

    // Shows the drawn frame; waits for the monitor's refresh if it has one.
    virtual void present() = 0;

    // The longest side of an image that the device can draw, px.
    virtual int longest_side() const = 0;
    // What has gone wrong on the device since the last call.
    virtual DeviceFault device_fault() = 0;

    virtual void show_title(const std::string& title) = 0;
    virtual void set_fullscreen(bool on) = 0;
    virtual bool fullscreen() const = 0;
    virtual std::string clipboard() const = 0;
    virtual void set_clipboard(const std::string& text) = 0;
    virtual bool has_sound() const { return false; }  // on the device of the desktop
    virtual std::string renderer_name() const = 0;    // "llvmpipe …, 4.5 (Core Profile) …"
};

}  // namespace game
