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

// Where widgets stand, px from the top left. Of a frame, at most kMost: the rest are not noted.
class Places {
  public:
    struct Place {
        std::array<char, 64> label{};  // cut to fit
        ImVec2 from, to;
    };
    static constexpr std::size_t kMost = 320;

    void clear() { size_ = 0; }
    // The last item of ImGui's, if its middle can be seen.
    void note(std::string_view label);
    void note(std::string_view label, ImVec2 from, ImVec2 to);
    const Place* find(std::string_view label) const;

  private:
    std::array<Place, kMost> places_;
    std::size_t size_ = 0;
};

struct Slide {
    double least, most;
    const char* format = "%.0f";  // of printf, with the unit
    bool logarithmic = false;
    bool when_released = false;  // what it shows follows the hand, its value only the hand's end
    float width = 0;             // px; 0: the rest of the row
};

// A number to be typed, as a person reads it.
struct Number {
    const char* label;
    double value, usual;  // a mark leads back to the usual one where they differ
    const char* unit;
    const char* tooltip;
    bool editable = true;
};
struct Typed {
    enum class What { kNothing, kValue, kUsual, kNonsense } what = What::kNothing;
    double value = 0;
};

// The few kinds of widget that panels are made of. Each is known to a person, and to Places, by its label,
// and has a tooltip of one sentence.
class Widgets {
  public:
    Letters letters;
    float em = 16;  // px

    void begin_frame(double elapsed_s);
    const Places& places() const { return places_; }
    void note(std::string_view label) { places_.note(label); }
    void note(std::string_view label, ImVec2 from, ImVec2 to) { places_.note(label, from, to); }

    bool button(const char* label, const char* tooltip, bool on = false, float width = 0);
    bool icon_button(const char* label, Icon icon, const char* tooltip, bool on = false);
    // A picture, a word and a key; the word is left out where `narrow`.
    bool tool_button(const char* label, Icon icon, const char* key, const char* tooltip, bool on,
                     bool narrow);
    float tool_button_width(const char* label, const char* key, bool narrow) const;

    bool toggle(const char* label, bool& on, const char* tooltip);
    bool slider(const char* label, double& value, const Slide& slide, const char* tooltip);
    Typed number(const Number& number);

    // A list to choose from: `name(i)` for i from 0 to `count`. True if `chosen` was changed.
    template <class Name>
    bool choice(const char* label, int& chosen, int count, const char* tooltip, Name&& name,
                float width = 0) {
        if (!begin_choice(label, chosen >= 0 && chosen < count ? name(chosen) : "", tooltip, width))
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

    // A label at the left of a row; what follows stands at its right and fills it.
    void row(const char* label);
    void heading(const char* text);
    void dim(const char* format, ...) IM_FMTARGS(2);                      // small, dim
    void plain(const char* format, ...) IM_FMTARGS(2);                    // wrapped
    void fact(const char* label, const char* format, ...) IM_FMTARGS(3);  // a row that only tells
    // The list that is open closes when it is built next.
    void close_choice() { closing_choice_ = true; }
    // A warning over the foot of the window that is being built; nothing moves for it.
    void warn_over_foot(const char* label, const char* text);
    void tooltip(const char* text);  // for the last item

  private:
    bool begin_choice(const char* label, const char* shown, const char* tooltip, float width);
    bool choice_item(const char* name, int index, bool chosen);
    bool plate(const char* label, ImVec2 size, bool on);  // an empty button
    void fill(const Slide& slide, double value, float width);
    bool usual_mark(const Number& number);
    Typed typed(std::string_view was);

    Places places_;
    // The widget that is being changed, and what it shows meanwhile.
    bool closing_choice_ = false;
    ImGuiID changing_ = 0;
    double slid_ = 0;
    std::array<char, 32> typed_{};
    // Where the item under the cursor stands, and for how long the cursor has been there.
    ImVec2 hovered_;
    bool hovering_ = false;  // in this frame
    double hovered_s_ = 0, elapsed_s_ = 0;
};

// "12 345 m³" for people, into `text`.
const char* write_volume(std::span<char> text, double cubic_metres);

}  // namespace game::ui
