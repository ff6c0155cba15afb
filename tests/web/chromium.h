#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/places.h"
#include "tests/window/child.h"

namespace game::test {

using Json = nlohmann::json;

// The Chromium that PATH finds; none, and then the tests that need one are skipped.
std::optional<std::string> installed_chromium();

// A headless browser with one page, driven through the pipes of the DevTools protocol: JSON messages that end with a zero
// byte. It draws in software, has its own home, and ends with this object. Every call has a time limit, after which it
// throws std::runtime_error with what the browser printed.
class Chromium {
  public:
    // `switches`: of its command line, in addition.
    explicit Chromium(const std::vector<std::string>& switches = {});
    ~Chromium();
    Chromium(const Chromium&) = delete;
    Chromium& operator=(const Chromium&) = delete;

    // Calls a method for the page: "Page.navigate". Returns its result.
    Json call(const std::string& method, const Json& parameters = Json::object());
    // The value of a JavaScript expression; a promise's, if it is one. Throws if the expression does.
    Json value(const std::string& expression);

    void size(int width, int height, double pixels = 1, bool touch = false);
    // Opens an address as a fresh page and waits until the root's data-state is set. Returns it: "ready", "failed".
    std::string open(const std::string& address);
    // Presses and releases a key, as KeyboardEvent names it: "Home", "a".
    void press(const std::string& key, bool shift = false);
    void click(double x, double y);
    // From one place to another with the left button, in small steps.
    void drag(double from_x, double from_y, double to_x, double to_y, bool shift = false);
    void wheel(double x, double y, double pixels);
    void tap(double x, double y);
    // One finger stays at a place; another moves, from and to places beside it.
    void pinch(double x, double y, double from_x, double from_y, double to_x, double to_y);
    // Polls an expression until it is true; false after the time limit.
    bool comes(const std::string& expression, double seconds = 120);

    // Whether it stopped answering. Then nothing else will work.
    bool is_stuck() const { return stuck_; }

    // Since the last open(): exceptions, messages in the console and in the log; addresses that were asked for.
    std::vector<std::string> messages();
    std::vector<std::string> requests();

  private:
    Json call(Json message);
    Json read_message(double seconds);
    void keep(const Json& event);
    [[noreturn]] void give_up(const std::string& what) const;
    [[noreturn]] void stop(const std::string& what);
    std::filesystem::path file(const char* name) const { return folder_.path() / name; }

    support::TemporaryFolder folder_;
    int to_ = -1, from_ = -1;  // descriptors
    std::unique_ptr<Child> browser_;
    std::string session_;  // of the page
    std::string unread_;
    int last_id_ = 0;
    bool stuck_ = false;
    std::vector<std::string> messages_, requests_;
};

}  // namespace game::test
