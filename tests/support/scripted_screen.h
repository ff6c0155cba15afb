#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "game/controls/screen.h"

namespace support {

// A screen controlled by a test: it returns the events that the test queued, and records the calls it
// received. Has no GL: drawing needs a context from elsewhere, and the test sets framebuffer().
class ScriptedScreen : public game::Screen {
  public:
    // Events for the next poll(), in order.
    void happen(std::initializer_list<game::Event> events) { coming_.insert(coming_.end(), events); }
    void move(double x, double y) { happen({game::MoveEvent{x, y}}); }
    void press(game::Button button, game::Modifiers with = {}) {
        happen({game::ButtonEvent{button, true, with}});
    }
    void release(game::Button button, game::Modifiers with = {}) {
        happen({game::ButtonEvent{button, false, with}});
    }
    // Press and release.
    void tap(game::Key key, game::Modifiers with = {});
    void type(std::string_view text);  // ASCII
    void drop(std::vector<std::filesystem::path> files);
    void have(const game::KeyboardLayout& layout) { layout_ = layout; }

    void hold(std::optional<game::PadState> pad) { pad_ = pad; }  // from the next poll() on

    void resize(game::ScreenSize size) { size_ = size; }
    void pass(double seconds) { seconds_ += seconds; }
    void limit_side(int longest) { longest_side_ = longest; }
    // The next calls of device_fault() return these.
    void fail(std::vector<game::DeviceFault> faults) { faults_ = std::move(faults); }
    void draw_into(unsigned framebuffer) { framebuffer_ = framebuffer; }

    const std::string& title() const { return title_; }
    int frames() const { return frames_; }  // presented so far

    std::span<const game::Event> poll() override;
    std::vector<std::filesystem::path> dropped() override { return std::exchange(dropped_, {}); }
    const game::KeyboardLayout& layout() const override { return layout_; }
    const std::optional<game::PadState>& pad() const override { return pad_; }
    std::string pad_name() const override { return "scripted pad"; }
    game::ScreenSize size() const override { return size_; }
    unsigned framebuffer() const override { return framebuffer_; }
    double seconds() const override { return seconds_; }
    void present() override { ++frames_; }
    int longest_side() const override { return longest_side_; }
    game::DeviceFault device_fault() override;
    void show_title(const std::string& title) override { title_ = title; }
    void set_fullscreen(bool on) override { fullscreen_ = on; }
    bool fullscreen() const override { return fullscreen_; }
    std::string clipboard() const override { return clipboard_; }
    void set_clipboard(const std::string& text) override { clipboard_ = text; }
    std::string renderer_name() const override { return "scripted"; }

  private:
    std::vector<game::Event> coming_, polled_;
    std::vector<std::filesystem::path> dropped_;
    game::KeyboardLayout layout_;
    std::optional<game::PadState> pad_;
    game::ScreenSize size_;
    unsigned framebuffer_ = 0;
    double seconds_ = 0;
    int longest_side_ = 16384;
    std::vector<game::DeviceFault> faults_;  // in order
    std::string title_, clipboard_;
    bool fullscreen_ = false;
    int frames_ = 0;
};

}  // namespace support
