#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/pictures/picture.h"
#include "tests/game/program.h"
#include "tests/support/places.h"
#include "tests/window/child.h"

namespace game::test {

// What a virtual desktop needs and this machine lacks, as the message of a skipped test.
std::optional<std::string> missing_for_a_desktop();

enum class Mouse { kLeft = 1, kMiddle = 2, kRight = 3 };

// A virtual desktop: an X server with a window manager, one program with one window, and simulated mouse and
// keyboard. Positions are in pixels from the window's top left. Every call has a time limit, after which it
// throws std::runtime_error with the program's output. The program has its own home.
class XSession {
  public:
    explicit XSession(int width = 1280, int height = 800);

    // Starts a program, by path, and waits for a window whose title begins with `title` and that has the
    // keyboard focus.
    void start(const std::vector<std::string>& arguments, const std::string& title);

    void move(int x, int y);
    void press(Mouse button);
    void release(Mouse button);
    // Moves there in small steps, starting from the target of the last move().
    void drag(int x, int y, int steps = 10);
    void wheel(int steps);              // away from the user is positive
    void key(const std::string& keys);  // as xdotool names them: "ctrl+z", "space", "period"
    void keys(const std::vector<std::string>& keys);
    void key_down(const std::string& name);
    void key_up(const std::string& name);
    void type(const std::string& text);
    void keyboard(const std::string& layout);  // "us", "de"

    void resize(int width, int height);
    void minimise();
    void restore();
    void close();  // asks the window to close, as the close button does
    void kill();   // ends the program without asking
    struct Place {
        int x = 0, y = 0, width = 0, height = 0;
    };
    Place place();  // of the window on the desktop

    // The window's part of the desktop as shown now.
    render::Picture screenshot();
    // The program's output so far.
    std::string out() const;
    bool ended() { return program_->ended(); }
    // Waits for the program to end.
    Finished finish(double seconds = 20);

    const std::filesystem::path& folder() const { return folder_.path(); }  // deleted with the session
    // What the program had opened on the desktop, one path a line.
    std::string opened() const;

  private:
    std::string tool(std::vector<std::string> arguments);
    [[noreturn]] void give_up(const std::string& what) const;
    std::filesystem::path file(const char* name) const { return folder_.path() / name; }

    support::TemporaryFolder folder_;
    Environment environment_;
    std::unique_ptr<Child> server_, manager_, program_;  // ended in reverse order
    std::string window_;
    int x_ = 0, y_ = 0;
};

}  // namespace game::test
