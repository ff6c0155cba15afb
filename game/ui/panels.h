#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "game/controls/action.h"
#include "game/ui/card_map.h"
#include "game/ui/facts.h"
#include "game/ui/key_choice.h"
#include "game/ui/label_layout.h"
#include "game/ui/menu.h"
#include "game/ui/scene_pictures.h"
#include "game/ui/widgets.h"

namespace game::ui {

// The panels that can be opened and closed.
enum class Panel { kScene, kPhysics, kDisplay, kPerformance, kFilm, kMeasure, kHelp };
inline constexpr std::size_t kPanels = 7;

struct PanelInfo {
    Panel panel;
    Verb verb;  // opens and closes it
    const char* title;
    Icon icon;
    const char* tooltip;
};
inline constexpr PanelInfo kPanelInfos[kPanels] = {
    {Panel::kScene, Verb::kToggleScene, "Scene", Icon::kScene, "Shows the loaded scene and opens others."},
    {Panel::kPhysics, Verb::kTogglePhysics, "Physics", Icon::kPhysics, "Every parameter of the physics."},
    {Panel::kDisplay, Verb::kToggleDisplay, "Display", Icon::kDisplay, "Colours, sun, camera and text size."},
    {Panel::kPerformance, Verb::kTogglePerformance, "Performance", Icon::kPerformance,
     "Time per stage of a frame."},
    {Panel::kFilm, Verb::kToggleFilm, "Film", Icon::kFilm, "Makes a film of the slide, with its sound."},
    {Panel::kMeasure, Verb::kToggleMeasure, "Measure", Icon::kMeasure,
     "A cross-section along a line, and plots over time."},
    {Panel::kHelp, Verb::kToggleHelp, "Help", Icon::kHelp, "All keys and mouse gestures."},
};

// Which panels are open. If two columns would hide the terrain, only one panel is open at a time.
class OpenPanels {
  public:
    bool is_open(Panel panel) const { return open_[static_cast<std::size_t>(panel)]; }
    bool hidden() const { return hidden_; }
    void toggle(Panel panel);
    void toggle_all() { hidden_ = !hidden_; }
    bool any_open() const;
    void close_one();  // the help, which is on top, else the one opened last, else any
    void keep_only_last();

  private:
    std::array<bool, kPanels> open_{};
    Panel last_ = Panel::kScene;
    bool hidden_ = false;  // all panels, and what is in the corners
};

// The choice in the scene panel that has not been started yet. −1: the scene's own.
struct SceneChoice {
    int scene = -1;  // −1: the loaded one if it is shipped, else the first
    int material = -1, model = -1, grid = -1;
};

inline constexpr float kReadingsWidth = 16;  // em
// em: the bars, and a panel beside them, have room on a screen as large as this.
inline constexpr double kLeastWidth = 42, kLeastHeight = 27;

// State that all panels share, kept between frames.
struct Desk {
    Widgets widgets;
    ScenePictures pictures, shelf_pictures;  // of scenes; of what the user has made
    CardMap card_map;
    LabelLayout labels;
    OpenPanels panels;
    Menu menu;
    FilmWish film;
    KeyChoice key_choice;
    SceneChoice choice;
    std::array<char, 128> name_of_world{};  // as typed so far
    bool measures_over_time = false;        // else along a line
    std::optional<std::size_t> house =
        {};  // whose pressure is plotted; nothing: the one with the largest pressure
    std::optional<std::size_t> told_house = {};  // the same, as last shown
    std::optional<double> pointed_s = {};        // time under the cursor in a plot, in the last frame
    std::array<char, 192> refusal{};             // why a number was rejected
    ImVec2 size{1280, 720};                      // of the screen, px
    double usual_em = 16;                        // px, at a text size of 100 %
    // px, as last drawn. lower_edge bounds items for which there is no room beside the time bar.
    float toolbar_bottom = 0, time_bar_top = 0, time_bar_left = 0, lower_edge = 0;
    float options_width = 0;                  // of the tool in the hand
    float card_without_map = 0;               // height of the result card, as if it had no map
    float lesson_text = 0, lesson_below = 0;  // heights in the card of a lesson, as last drawn
    float readings_height = 0;  // kept while the cursor is off the terrain, so that panels do not move
    float left_column = 0, right_column = 0;  // width with margin; 0 if none of its panels is open

    float em() const { return widgets.em; }
    float margin() const { return em() * 0.6f; }
    bool beside_time_bar() const { return (kReadingsWidth + 1.2f) * em() <= time_bar_left; }
    bool narrow() const { return size.x < 75 * em(); }  // tool buttons have no room for words
};

// Always shown.
void toolbar(Desk& desk, const Facts& facts, Actions& actions);
void time_bar(Desk& desk, const Facts& facts, Actions& actions);
void readings(Desk& desk, const Facts& facts);
void notices(Desk& desk, const Facts& facts, bool warnings_only);
void hint(Desk& desk, const Facts& facts);
void bare_ground(Desk& desk, const Facts& facts, Actions& actions);  // instead of a hint
void stroke_note(Desk& desk, const Facts& facts);
void dam(Desk& desk, const Facts& facts);
void run_ends(Desk& desk, const Facts& facts);
void section_line(Desk& desk, const Facts& facts);  // on the terrain
void slide_labels(Desk& desk, const Facts& facts);  // on the terrain; after all that they keep clear of
void challenge(Desk& desk, const Facts& facts, Actions& actions);
void title(Desk& desk, float strength);
void pad_wheel(Desk& desk, const Facts& facts);  // of a gamepad, while one of its buttons opens it
void opening(Desk& desk, const Facts& facts);    // instead of all others
void photo_bar(Desk& desk, const Facts& facts, Actions& actions);  // instead of all others
void menu(Desk& desk, const Facts& facts, Actions& actions);       // instead of all others, while it is open
void guide(Desk& desk, const Facts& facts, Actions& actions);
void result_card(Desk& desk, const Facts& facts, Actions& actions);
void lesson_card(Desk& desk, const Facts& facts, Actions& actions);

// The contents of each panel; open_panels() draws those that are open.
void scene_panel(Desk& desk, const Facts& facts, Actions& actions);
void physics_panel(Desk& desk, const Facts& facts, Actions& actions);
void display_panel(Desk& desk, const Facts& facts, Actions& actions);
void performance_panel(Desk& desk, const Facts& facts);
void film_panel(Desk& desk, const Facts& facts, Actions& actions);
void measure_panel(Desk& desk, const Facts& facts, Actions& actions);
void plots_over_time(Desk& desk, const Facts& facts, Actions& actions);  // in the measure panel
void help_panel(Desk& desk, const Keys& keys);
void open_panels(Desk& desk, const Facts& facts, Actions& actions);

// A window without frame and title that cannot be moved.
inline constexpr ImGuiWindowFlags kFixedWindow = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoSavedSettings |
                                                 ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// The catalogue's title for a name; the name if there is none.
const char* title_in(const std::vector<Catalogue::Entry>& entries, const std::string& name);

}  // namespace game::ui
