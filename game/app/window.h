#pragma once

#include <chrono>
#include <memory>

#include "game/base/outcome.h"
#include "game/controls/screen.h"

struct GLFWwindow;

namespace game {

// A desktop window with keyboard and mouse. At most one at a time, on the main thread. Only this class uses
// GLFW. The default framebuffer has colour only: no depth, no alpha.
//
// Keys are what they print, as controls/keyboard.h says. AltGr is no modifier.
class Window final : public Screen {
  public:
    // Opens a window of `width` × `height`, times the monitor's scale, with a current OpenGL 4.5 core context
    // through EGL. Errors (status 3): no display or no such context; the sentence says what was tried.
    static Outcome<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
    ~Window() override;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    std::span<const Event> poll() override;
    std::vector<std::filesystem::path> dropped() override { return dropped_; }
    const KeyboardLayout& layout() const override { return keyboard_.layout(); }
    const std::optional<PadState>& pad() const override { return pad_; }
    std::string pad_name() const override;
    ScreenSize size() const override;
    unsigned framebuffer() const override { return 0; }
    double seconds() const override;
    // Never faster than the monitor's refresh rate, even if swapping does not wait for it.
    void present() override;
    int longest_side() const override { return longest_side_; }
    DeviceFault device_fault() override;
    void show_title(const std::string& title) override;
    // Uses the monitor that contains the window's centre. Off restores the old position and size.
    void set_fullscreen(bool on) override;
    bool fullscreen() const override;
    std::string clipboard() const override;
    void set_clipboard(const std::string& text) override;
    bool has_sound() const override { return true; }
    std::string renderer_name() const override;

  private:
    struct Callbacks;
    struct Pair {
        int x = 0, y = 0;
    };
    using Clock = std::chrono::steady_clock;

    explicit Window(GLFWwindow* window);
    void measure();
    void read_pad();
    void follow_monitor();
    bool minimised() const { return iconified_ || framebuffer_size_.x == 0 || framebuffer_size_.y == 0; }

    GLFWwindow* window_;
    std::vector<Event> events_;
    std::vector<std::filesystem::path> dropped_;
    std::optional<PadState> pad_;  // the first one that GLFW knows
    int pad_number_ = 0;           // of GLFW
    Keyboard keyboard_;            // its keys have GLFW's numbers
    Pair window_size_, framebuffer_size_;
    double scale_ = 1;
    int longest_side_ = 0;
    bool iconified_ = false;
    Pair place_, extent_;  // before full screen
    Clock::time_point begin_ = Clock::now();
    Clock::time_point due_ = begin_;  // time of the next frame
    Clock::duration period_{};        // least time between frames
};

}  // namespace game
