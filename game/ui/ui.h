#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/controls/action.h"
#include "game/controls/events.h"
#include "game/controls/screen.h"
#include "game/ui/facts.h"

namespace game::ui {

// Panels, toolbar, readings and notices over the image, drawn with Dear ImGui. It requests changes as actions
// and itself changes only which panels are open. At most one instance, because ImGui has one context.
class Ui {
  public:
    // `font`: a TrueType file; without one, ImGui's own font is used. Needs no GL until draw().
    explicit Ui(std::optional<std::filesystem::path> font);
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    // Begins a frame with these events; keeps_mouse() and keeps_keys() then say what the panels use of them.
    // `letters` as in Display. `screen` provides the clipboard.
    void begin(std::span<const Event> events, Screen& screen, double letters, double elapsed_s);
    bool keeps_mouse() const;  // the cursor is over a panel
    KeysKept keeps_keys() const;

    // Opens and closes panels and the menu. Returns false for other verbs.
    bool perform(Verb verb);

    // The menu, over everything else; time is to stand still behind it.
    void begin_menu();  // as the first thing that is seen
    void close_menu();
    bool shows_menu() const;
    bool shows_measures() const;  // the panel of the cross-section

    // Builds all open panels; to be called once per frame between begin() and draw().
    void build(const Facts& facts, Actions& actions);
    // Builds nothing but the program's name, for the time until there is a world.
    void build_title();
    bool hides_panels() const;
    // What toolbar and time bar leave of the screen's height, px: at least half of it, and all while panels are hidden.
    double free_height(const ScreenSize& size, double letters) const;
    // Draws onto the bound framebuffer. Needs the screen's GL context. Preserves the GL state.
    void draw();

    // For tests: where the widget with this label was in the last frame, in pixels; nothing if it was not
    // visible. Labels are the visible text of widgets.
    struct Place {
        double x, y, width, height;
    };
    std::optional<Place> find(std::string_view label) const;
    // For tests: words that had no room where they stood in the last frame.
    std::vector<std::string> cut() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace game::ui
