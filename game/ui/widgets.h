#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <imgui.h>

#include "game/ui/icons.h"
#include "game/ui/style.h"

namespace game::ui {

// Positions of widgets in a frame, px from the top left. Records at most kMost.
class Places {
  public:
    struct Place {
        std::array<char, 64> label{};  // cut to fit
        ImVec2 from, to;
    };
    static constexpr std::size_t kMost = 320;

    void clear() { size_ = cut_ = 0; }
    // Words that have no room where they stand. For tests, which look for such.
    void note_cut(std::string_view words);
    using CutWords = std::array<char, 64>;
    std::span<const CutWords> cut() const { return std::span(cut_words_).first(cut_); }
    // Records ImGui's last item, if its centre is visible.
    void note(std::string_view label);
    void note(std::string_view label, ImVec2 from, ImVec2 to);
    // The last one of this label: an item of an open list, not what the list covers.
    const Place* find(std::string_view label) const;

  private:
    std::array<Place, kMost> places_;
    std::array<CutWords, 16> cut_words_;
    std::size_t size_ = 0, cut_ = 0;
};

// A rectangle on the screen, px.
struct Box {
    ImVec2 from, to;
};

struct Slide {
    double least, most;
    const char* format = "%.0f";  // printf format, with the unit
    bool logarithmic = false;
    bool when_released = false;  // the shown value follows the drag; the result changes on release
    float width = 0;             // px; 0: the rest of the row
};

// A number that the user can type, as displayed.
struct Number {
    const char* label;
    double value, usual;  // if they differ, a button resets to the default (`usual`)
    const char* unit;
    const char* tooltip;
    bool editable = true;
};
struct Typed {
    enum class What { kNothing, kValue, kUsual, kNonsense } what = What::kNothing;
    double value = 0;
};

// The kinds of widget used in panels. Labels, tooltips and formats are written in English and shown in the language of the
// window (game/words). Each is identified by its label, to the user and to Places, and has a
// tooltip of one sentence, which is shown beside the panels and over none of them if there is room.
class Widgets {
  public:
    Letters letters;
    float em = 16;  // px

    void begin_frame(double elapsed_s);
    const Places& places() const { return places_; }
    void note(std::string_view label) { places_.note(label); }
    void note(std::string_view label, ImVec2 from, ImVec2 to) { places_.note(label, from, to); }
    // Tooltips of the next frame keep clear of this.
    void keep_clear(const Box& box);
    void keep_window_clear(const char* label);  // the current one
    // All of them so far in this frame.
    std::span<const Box> kept_clear() const {
        return std::span(occupied_next_.boxes).first(occupied_next_.size);
    }

    bool button(const char* label, const char* tooltip, bool on = false, float width = 0);
    // As wide as there is room, with a label that wraps.
    bool long_button(const char* label, bool on = false);
    bool icon_button(const char* label, Icon icon, const char* tooltip, bool on = false);
    // An icon, a word and a key; without the word if `narrow`, without the key if it is empty. `width`: px, at least
    // that of tool_button_width().
    bool tool_button(const char* label, std::span<const IconPart> icon, const char* key, const char* tooltip,
                     bool on, bool narrow, float width);
    float tool_button_width(const char* label, const char* key, bool narrow) const;

    // A large button of the menu, with a line of small letters below its label if it is high enough.
    bool menu_button(const char* label, const char* note, bool on, ImVec2 size);

    // A button with a picture of 16 : 9 above its label. `medal`: of the stars below the label, 0 none to 3 gold; −1: no
    // stars.
    struct Card {
        const char* label;
        int medal = -1;
        const char* note = "";   // beside the stars
        bool is_closed = false;  // greyed, with a lock
        ImTextureID picture = nullptr;
        ImVec2 from = {}, to = {};  // texture coordinates of its top left and bottom right
    };
    bool card(const Card& card, ImVec2 size, bool on);

    // A line of text that is typed, at most as long as its room. `hint`: shown while it is empty. True if Enter ended it.
    bool text_field(const char* label, const char* hint, std::span<char> text, float width);
    bool types_name() const { return types_name_; }  // into such a line, in the last frame
    bool toggle(const char* label, bool& on, const char* tooltip);
    bool slider(const char* label, double& value, const Slide& slide, const char* tooltip);
    Typed number(const Number& number);

    // A drop-down list of `name(i)`, i from 0 to `count` − 1; while none is chosen, it shows `unchosen`. True if
    // `chosen` was changed.
    template <class Name>
    bool choice(const char* label, int& chosen, int count, const char* tooltip, Name&& name, float width = 0,
                const char* unchosen = "") {
        if (!begin_choice(label, chosen >= 0 && chosen < count ? name(chosen) : unchosen, tooltip, width))
            return false;
        bool changed = false;
        for (int i = 0; i < count; ++i)
            if (choice_item(name(i), i, i == chosen)) {
                changed = i != chosen;
                chosen = i;
            }
        ImGui::EndCombo();
        return changed;
    }

    // Starts a row with a label on the left; the next widget fills the rest.
    void row(const char* label);
    void heading(const char* text);
    void caption(const char* text, float width);        // small, over a widget of this width
    void dim(const char* format, ...) IM_FMTARGS(2);    // small, dim
    void plain(const char* format, ...) IM_FMTARGS(2);  // wrapped
    void fact(const char* label, const char* format, ...) IM_FMTARGS(3);  // a read-only row
    // Closes the open list the next time it is built.
    void close_choice() { closing_choice_ = true; }
    // A warning drawn over the bottom of the current window; nothing moves.
    void warn_over_foot(const char* label, const char* text);
    void tooltip(const char* text);  // for the last item; null: none

  private:
    bool begin_choice(const char* label, const char* shown, const char* tooltip, float width);
    bool choice_item(const char* name, int index, bool chosen);
    bool plate(const char* label, ImVec2 size, bool on);  // an empty button
    void fill(const Slide& slide, double value, float width);
    bool usual_mark(const Number& number);
    Typed typed(std::string_view was);
    ImVec2 beside(const Box& item, const Box& panel, ImVec2 size) const;

    Places places_;
    // What tooltips keep clear of, as it was in the last frame and so far in this one.
    struct Boxes {
        std::array<Box, 16> boxes;
        std::size_t size = 0;
    };
    Boxes occupied_, occupied_next_;
    // The widget being edited, and the value it shows meanwhile.
    bool closing_choice_ = false;
    bool types_name_ = false, types_name_next_ = false;
    ImGuiID changing_ = 0;
    double slid_ = 0;
    std::array<char, 32> typed_{};
    // Position of the hovered item, and how long it has been hovered.
    ImVec2 hovered_;
    bool hovering_ = false;  // in this frame
    double hovered_s_ = 0, elapsed_s_ = 0;
};

// The longest of 1, 2 or 5 times a power of ten that is no longer than this.
double round_length(double most);

// Numbers as panels have them, with a blank between thousands. Each writes into `text`, cut to fit, and returns it.
// "12 345 m", from a printf format with one number at its beginning.
const char* write_number(std::span<char> text, const char* format, double value);
// "12 345 m³"
const char* write_volume(std::span<char> text, double cubic_metres);
// A text whose volumes are written like that: "20,000 m3" becomes "20 000 m³".
const char* write_with_volumes(std::span<char> text, std::string_view from);

}  // namespace game::ui
