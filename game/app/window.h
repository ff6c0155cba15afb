#pragma once

#include <array>
#include <chrono>
#include <memory>

#include "game/base/outcome.h"
#include "game/controls/screen.h"

struct GLFWwindow;

namespace game {

// A window of the desktop, with keyboard and mouse. At most one at a time, on the main thread; the only place
// that knows the windowing library. Its default framebuffer has colour and nothing else: no depth, no alpha.
//
// Keys are known by their place on the board, as the letter that a US board has there, so that a hand's usual
// keys are where the hand is. With Control held a letter is the one that is printed on the key: Ctrl+Z is Z
// everywhere.
class Window final : public Screen {
  public:
    // Opens it: `width` × `height` as large as the monitor's scale makes them, with a current OpenGL 4.5 core
    // context got through EGL. Errors (of the machine): no display, no such context; says what was tried.
    static Outcome<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
    ~Window() override;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    std::span<const Event> poll() override;
    std::vector<std::filesystem::path> dropped() override { return dropped_; }
    ScreenSize size() const override;
    unsigned framebuffer() const override { return 0; }
    double seconds() const override;
    // Never quicker than the monitor shows pictures, also where swapping does not wait for it.
    void present() override;
    void show_title(const std::string& title) override;
    // On the monitor that holds the window's middle; off again, the window has its old place and size.
    void set_fullscreen(bool on) override;
    bool fullscreen() const override;
    std::string clipboard() const override;
    void set_clipboard(const std::string& text) override;
    std::string renderer_name() const override;

  private:
    struct Callbacks;
    struct Pair {
        int x = 0, y = 0;
    };
    using Clock = std::chrono::steady_clock;

    explicit Window(GLFWwindow* window);
    void measure();
    void follow_monitor();
    bool minimised() const { return iconified_ || framebuffer_size_.x == 0 || framebuffer_size_.y == 0; }

    GLFWwindow* window_;
    std::vector<Event> events_;
    std::vector<std::filesystem::path> dropped_;
    std::array<Key, 512> pressed_{};  // by the library's number: as what a key went down
    Pair window_size_, framebuffer_size_;
    double scale_ = 1;
    bool iconified_ = false;
    Pair place_, extent_;  // before full screen
    Clock::time_point begin_ = Clock::now();
    Clock::time_point due_ = begin_;  // of the next picture
    Clock::duration period_{};        // at least between two pictures
};

}  // namespace game
