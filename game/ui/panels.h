#pragma once

#include <array>
#include <cstddef>

#include "game/controls/action.h"
#include "game/ui/facts.h"
#include "game/ui/widgets.h"

namespace game::ui {

// What can be opened and closed.
enum class Panel { kScene, kPhysics, kDisplay, kPerformance, kHelp };
inline constexpr std::size_t kPanels = 5;

struct PanelInfo {
    Panel panel;
    Verb verb;  // opens and closes it
    const char* title;
    Icon icon;
    const char* tooltip;
};
inline constexpr PanelInfo kPanelInfos[kPanels] = {
    {Panel::kScene, Verb::kToggleScene, "Scene", Icon::kScene,
     "What is loaded, and a choice of what else to load."},
    {Panel::kPhysics, Verb::kTogglePhysics, "Physics", Icon::kPhysics,
     "Every number of the material's motion."},
    {Panel::kDisplay, Verb::kToggleDisplay, "Display", Icon::kDisplay,
     "Colours, sun, camera and size of letters."},
    {Panel::kPerformance, Verb::kTogglePerformance, "Performance", Icon::kPerformance,
     "Where the time of a frame goes."},
    {Panel::kHelp, Verb::kToggleHelp, "Help", Icon::kHelp, "Every key and every gesture."},
};

// Which panels are open. Where two columns of panels would hide the mountain, one panel at a time.
class OpenPanels {
  public:
    bool is_open(Panel panel) const { return open_[static_cast<std::size_t>(panel)]; }
    bool hidden() const { return hidden_; }
    void toggle(Panel panel);
    void toggle_all() { hidden_ = !hidden_; }
    void close_one();  // the help, which lies on top, else the one opened last, else any
    void keep_only_last();

  private:
    std::array<bool, kPanels> open_{};
    Panel last_ = Panel::kScene;
    bool hidden_ = false;  // all, and what stands in the corners
};

// What a person has chosen in the scene panel and not yet begun. −1: as the scene says.
struct SceneChoice {
    int scene = -1;  // −1: the one that is loaded, if it ships, else the first
    int material = -1, model = -1, grid = -1;
};

inline constexpr float kReadingsWidth = 16;  // em

// What all panels share in a frame and keep between frames.
struct Desk {
    Widgets widgets;
    OpenPanels panels;
    SceneChoice choice;
    std::array<char, 192> refusal{};  // why a number was not taken
    ImVec2 size{1280, 720};           // of the screen, px
    // px, as drawn last. The lower edge is that of what has no room beside the time bar.
    float toolbar_bottom = 0, time_bar_top = 0, time_bar_left = 0, lower_edge = 0;
    float readings_height = 0;  // kept while the cursor is beside, so that panels stay where they are
    float right_column = 0;     // its width with its margin; 0 while none of it is open

    float em() const { return widgets.em; }
    float margin() const { return em() * 0.6f; }
    bool beside_time_bar() const { return (kReadingsWidth + 1.2f) * em() <= time_bar_left; }
    bool narrow() const { return size.x < 75 * em(); }  // a word per tool no longer fits
};

// Always there.
void toolbar(Desk& desk, const Facts& facts, Actions& actions);
void time_bar(Desk& desk, const Facts& facts, Actions& actions);
void readings(Desk& desk, const Facts& facts);
void notices(Desk& desk, const Facts& facts, bool warnings_only);
void hint(Desk& desk, const Facts& facts);

// What stands in a panel; open_panels() draws those that are open.
void scene_panel(Desk& desk, const Facts& facts, Actions& actions);
void physics_panel(Desk& desk, const Facts& facts, Actions& actions);
void display_panel(Desk& desk, const Facts& facts, Actions& actions);
void performance_panel(Desk& desk, const Facts& facts);
void help_panel(Desk& desk);
void open_panels(Desk& desk, const Facts& facts, Actions& actions);

// A window without frame and title that stays where it is put.
inline constexpr ImGuiWindowFlags kFixedWindow = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoSavedSettings |
                                                 ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// The title that the catalogue gives a name; the name where it has none.
const char* title_in(const std::vector<Catalogue::Entry>& entries, const std::string& name);

}  // namespace game::ui
