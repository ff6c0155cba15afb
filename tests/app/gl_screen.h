#pragma once

#include <vector>

#include "game/screen.h"
#include "render/context.h"
#include "render/gl_handle.h"
#include "render/picture.h"

namespace app_test {

// A screen without a window: events are given by the test, its clock goes on by what present() is told a frame
// takes, and what was shown can be looked at.
class GlScreen : public game::Screen {
  public:
    GlScreen(int width, int height);  // throws where there is no GL 4.5

    // Given before a frame, taken by its poll().
    void give(const game::Event& event) { waiting_.push_back(event); }
    void move_to(double x, double y) { give(game::MoveEvent{x, y}); }
    void press(game::Button button, game::Modifiers with = {}) { give(game::ButtonEvent{button, true, with}); }
    void release(game::Button button) { give(game::ButtonEvent{button, false, {}}); }
    void tap(game::Key key, game::Modifiers with = {}) {
        give(game::KeyEvent{key, true, false, with});
        give(game::KeyEvent{key, false, false, {}});
    }
    void drop(std::filesystem::path path);
    void resize(int width, int height);

    double frame_s = 1.0 / 60;  // what a frame takes
    std::string title;
    int shown = 0;  // frames

    render::Picture picture() const;  // as shown last

    std::span<const game::Event> poll() override;
    std::vector<std::filesystem::path> dropped() override { return dropped_; }
    game::ScreenSize size() const override { return size_; }
    unsigned framebuffer() const override { return framebuffer_.name(); }
    double seconds() const override { return seconds_; }
    void present() override;
    void show_title(const std::string& text) override { title = text; }
    void set_fullscreen(bool on) override { fullscreen_ = on; }
    bool fullscreen() const override { return fullscreen_; }
    std::string clipboard() const override { return {}; }
    void set_clipboard(const std::string&) override {}
    std::string renderer_name() const override { return context_.renderer_name(); }

  private:
    render::HeadlessContext context_;
    game::ScreenSize size_;
    render::Texture colour_;
    render::Framebuffer framebuffer_;
    std::vector<game::Event> waiting_, given_;
    std::vector<std::filesystem::path> dropped_;
    double seconds_ = 1000;
    bool fullscreen_ = false;
};

}  // namespace app_test
