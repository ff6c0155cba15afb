#include "tests/window/x_session.h"

#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "game/base/number.h"
#include "tests/window/screenshot.h"

namespace game::test {
namespace {

constexpr double kToStart = 30, kToAnswer = 10;  // s, on a busy machine

// Time for a frame or two to process the input, as between movements by hand.
void breathe() {
    rest(0.06);
}

}  // namespace

std::optional<std::string> missing_for_a_desktop() {
    for (const char* program : {"Xvfb", "xdotool", "blackbox", "wmctrl"})
        if (!is_installed(program)) return std::string(program) + " is not installed";
    return std::nullopt;
}

XSession::XSession(int width, int height) {
    const std::string home = folder_.path().string();
    server_ = std::make_unique<Child>(
        std::vector<std::string>{"Xvfb", "-displayfd", "3", "-noreset", "-nolisten", "tcp", "-screen", "0",
                                 std::to_string(width) + "x" + std::to_string(height) + "x24", "-fbdir",
                                 home},
        Environment{}, file("server.out"), file("server.err"), true);
    const std::string number = server_->read_pipe(kToStart);
    if (number.empty()) throw std::runtime_error("no X server: " + read_bytes(file("server.err")));
    environment_ = {
        // xdotool types, and the window receives, only the letters of the locale.
        {"LC_ALL", "C.UTF-8"},   {"DISPLAY", ":" + number}, {"WAYLAND_DISPLAY", std::nullopt}, {"HOME", home},
        {"XDG_DATA_HOME", home}, {"XDG_CONFIG_HOME", home}, {"XAUTHORITY", std::nullopt}};
    // Nothing may be opened on a desktop that is only virtual.
    write_bytes(file("xdg-open"), "#!/bin/sh\necho \"$@\" >> \"$HOME/opened\"\n");
    std::filesystem::permissions(file("xdg-open"), std::filesystem::perms::owner_all);
    const char* path = std::getenv("PATH");
    environment_["PATH"] = home + ":" + (path ? path : "/usr/bin:/bin");
    manager_ = std::make_unique<Child>(std::vector<std::string>{"blackbox"}, environment_,
                                       file("manager.out"), file("manager.err"));
    // The window manager answers once it manages windows.
    if (!within(kToStart, [&] {
            Child asked({"wmctrl", "-m"}, environment_, file("tool.out"), file("tool.err"));
            return asked.wait(kToAnswer) == 0;
        }))
        throw std::runtime_error("no window manager: " + read_bytes(file("manager.err")));
}

void XSession::start(const std::vector<std::string>& arguments, const std::string& title) {
    program_ = std::make_unique<Child>(arguments, environment_, file("program.out"), file("program.err"));
    const bool seen = within(kToStart, [&] {
        if (program_->ended()) give_up("the program ended before it had a window");
        Child search({"xdotool", "search", "--onlyvisible", "--name", "^" + title}, environment_,
                     file("tool.out"), file("tool.err"));
        if (search.wait(kToAnswer) != 0) return false;
        std::istringstream(read_bytes(file("tool.out"))) >> window_;
        return !window_.empty();
    });
    if (!seen) give_up("no window is named " + title);
    tool({"xdotool", "windowfocus", "--sync", window_});
    move(5, 5);
}

void XSession::move(int x, int y) {
    x_ = x;
    y_ = y;
    tool({"xdotool", "mousemove", "--window", window_, std::to_string(x), std::to_string(y)});
    breathe();
}

void XSession::press(Mouse button) {
    tool({"xdotool", "mousedown", std::to_string(static_cast<int>(button))});
    breathe();
}

void XSession::release(Mouse button) {
    tool({"xdotool", "mouseup", std::to_string(static_cast<int>(button))});
    breathe();
}

void XSession::drag(int x, int y, int steps) {
    const int from_x = x_, from_y = y_;
    for (int i = 1; i <= steps; ++i)
        move(from_x + (x - from_x) * i / steps, from_y + (y - from_y) * i / steps);
}

void XSession::wheel(int steps) {
    for (int i = 0; i < std::abs(steps); ++i) {
        tool({"xdotool", "click", steps > 0 ? "4" : "5"});
        breathe();
    }
}

void XSession::key(const std::string& keys) {
    tool({"xdotool", "key", "--delay", "60", keys});
    breathe();
}

void XSession::keys(const std::vector<std::string>& keys) {
    std::vector<std::string> command{"xdotool", "key", "--delay", "20"};
    command.insert(command.end(), keys.begin(), keys.end());
    tool(command);
    breathe();
}

void XSession::key_down(const std::string& name) {
    tool({"xdotool", "keydown", name});
    breathe();
}

void XSession::key_up(const std::string& name) {
    tool({"xdotool", "keyup", name});
    breathe();
}

void XSession::type(const std::string& text) {
    tool({"xdotool", "type", "--delay", "60", text});
    breathe();
}

void XSession::keyboard(const std::string& layout) {
    tool({"setxkbmap", layout});
    breathe();
}

void XSession::resize(int width, int height) {
    tool({"xdotool", "windowsize", "--sync", window_, std::to_string(width), std::to_string(height)});
    breathe();
}

void XSession::minimise() {
    tool({"xdotool", "windowminimize", window_});
    breathe();
}

void XSession::restore() {
    tool({"xdotool", "windowmap", "--sync", window_});
    tool({"xdotool", "windowfocus", "--sync", window_});
    breathe();
}

void XSession::close() {
    tool({"wmctrl", "-i", "-c", window_});
}

void XSession::kill() {
    program_->signal(SIGKILL);
}

XSession::Place XSession::place() {
    Place place;
    std::istringstream lines(tool({"xdotool", "getwindowgeometry", "--shell", window_}));
    for (std::string line; std::getline(lines, line);) {
        const auto split = line.find('=');
        if (split == std::string::npos) continue;
        const std::string name = line.substr(0, split);
        const int value = game::number_from<int>(std::string_view(line).substr(split + 1)).value_or(0);
        if (name == "X") place.x = value;
        if (name == "Y") place.y = value;
        if (name == "WIDTH") place.width = value;
        if (name == "HEIGHT") place.height = value;
    }
    return place;
}

render::Picture XSession::screenshot() {
    const Place at = place();
    return read_screen(file("Xvfb_screen0"), at.x, at.y, at.width, at.height);
}

std::string XSession::out() const {
    return read_bytes(file("program.out"));
}

std::string XSession::opened() const {
    return std::filesystem::exists(file("opened")) ? read_bytes(file("opened")) : "";
}

Finished XSession::finish(double seconds) {
    const auto status = program_->wait(seconds);
    if (!status) give_up("the program did not end");
    return {*status, read_bytes(file("program.out")), read_bytes(file("program.err"))};
}

// Runs a small program to its end and returns its output.
std::string XSession::tool(std::vector<std::string> arguments) {
    Child child(arguments, environment_, file("tool.out"), file("tool.err"));
    const auto status = child.wait(kToAnswer);
    if (status == 0) return read_bytes(file("tool.out"));
    std::string what;
    for (const std::string& argument : arguments) what += argument + " ";
    give_up(what + (status ? "failed: " + read_bytes(file("tool.err")) : "did not end"));
}

void XSession::give_up(const std::string& what) const {
    throw std::runtime_error(what + "\nThe program said: " + read_bytes(file("program.out")) +
                             read_bytes(file("program.err")));
}

}  // namespace game::test
