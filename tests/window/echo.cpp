// A window that prints its events, for the tests of window.cpp. F11 switches full screen; it ends when its
// window is asked to close.
#include "game/app/window.h"

#include <cstdio>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace game::test {
namespace {

std::string name_of(Modifiers with) {
    return fmt::format("{}{}{}", with.shift ? " shift" : "", with.control ? " control" : "",
                       with.alt ? " alt" : "");
}

struct Printer {
    Window& window;
    bool open = true;

    void operator()(const KeyEvent& event) {
        fmt::print("key {} {}{}{}\n", static_cast<int>(event.key), event.down ? "down" : "up",
                   event.repeat ? " repeat" : "", name_of(event.with));
        if (event.key == function_key(11) && event.down && !event.repeat)
            window.set_fullscreen(!window.fullscreen());
    }
    void operator()(const ButtonEvent& event) {
        fmt::print("button {} {}{}\n", static_cast<int>(event.button), event.down ? "down" : "up",
                   name_of(event.with));
    }
    void operator()(const MoveEvent& event) { fmt::print("move {} {}\n", event.x, event.y); }
    void operator()(const WheelEvent& event) { fmt::print("wheel {}{}\n", event.steps, name_of(event.with)); }
    void operator()(const TextEvent& event) {
        fmt::print("text {}\n", static_cast<unsigned>(event.character));
    }
    void operator()(const FocusEvent& event) { fmt::print("focus {}\n", event.focused); }
    void operator()(const DropEvent&) { fmt::print("drop {}\n", window.dropped().size()); }
    void operator()(const CloseEvent&) {
        fmt::print("close\n");
        open = false;
    }
};

int echo() {
    const auto opened = Window::open("Echo", 640, 400);
    if (!opened) {
        fmt::print(stderr, "{}\n", opened.error().sentence);
        return opened.error().status;
    }
    Window& window = **opened;
    Printer printer{window};
    fmt::print("{}\n", window.renderer_name());
    window.set_clipboard("névé");
    fmt::print("clipboard {}\n", window.clipboard());
    for (ScreenSize last{-1, -1}; printer.open;) {
        for (const Event& event : window.poll()) std::visit(printer, event);
        const ScreenSize now = window.size();
        if (now != last)
            fmt::print("size {} {} full screen {} at {:.3f} s\n", now.width, now.height, window.fullscreen(),
                       window.seconds());
        last = now;
        std::fflush(stdout);
        if (now.width == 0) continue;
        glBindFramebuffer(GL_FRAMEBUFFER, window.framebuffer());
        glViewport(0, 0, now.width, now.height);
        glClearColor(0.2f, 0.4f, 0.8f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        window.present();
    }
    return 0;
}

}  // namespace
}  // namespace game::test

int main() {
    return game::test::echo();
}
