#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "game/controls/action.h"
#include "game/controls/events.h"
#include "game/controls/screen.h"
#include "game/ui/facts.h"

namespace game::ui {

// Panels, toolbar, readings and notices over the picture, through Dear ImGui. It asks by actions and changes
// nothing itself but which panels are open. One at a time: ImGui has one context.
class Ui {
  public:
    // `font`: a TrueType file; without one ImGui's own letters are used. Needs no GL until draw().
    explicit Ui(std::optional<std::filesystem::path> font);
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    // Begins a frame: hands the events on and says what of them the panels keep for themselves. `letters` as
    // in Display. `screen` lends its clipboard.
    void begin(std::span<const Event> events, Screen& screen, double letters, double elapsed_s);
    bool keeps_mouse() const;  // the cursor is over a panel
    bool keeps_keys() const;   // a number is being typed

    // Opens and closes panels; other verbs are not its own. True if it was.
    bool perform(Verb verb);

    // All panels that are open, once per frame between begin() and draw().
    void build(const Facts& facts, Actions& actions);
    // Onto the bound framebuffer. Needs the screen's GL context. Leaves GL's state as it was.
    void draw();

    // For tests: where the widget with this label stood in the last frame, in pixels; nothing where it was
    // not seen. Labels are what a person reads on the widget.
    struct Place {
        double x, y, width, height;
    };
    std::optional<Place> find(std::string_view label) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace game::ui
