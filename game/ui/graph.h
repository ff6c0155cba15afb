#pragma once

#include <imgui.h>

#include "game/ui/panels.h"

namespace game::ui {

// The colours of what is measured.
inline constexpr ImU32 kBedrockColour = IM_COL32(86, 92, 100, 255),
                       kStandingColour = IM_COL32(222, 231, 240, 255), kFlowColour = kAccent;

// The values from least to most along an axis.
struct Range {
    double least = 0, most = 1;
    double length() const { return most - least; }
};

// 1, 2 or 5 times a power of ten: the least of them that divides `length` into at most `most` parts.
double round_step(double length, int most);
// 0 to the least such round number, or a multiple of it, that is no smaller than `value` and `least`.
Range from_zero_to(double value, double least);

// A plot in a panel, as wide as its row, with round numbers at its axes.
class Graph {
  public:
    struct Axis {
        Range range;
        const char* unit;     // "m"
        bool is_told = true;  // with numbers
    };
    // `label`: as of a widget. `height`: em, of the plot itself.
    Graph(Desk& desk, const char* label, float height, const Axis& across, const Axis& up,
          const char* tooltip = nullptr);

    float x(double value) const;
    float y(double value) const;
    float top() const { return from_.y; }
    float bottom() const { return to_.y; }
    float left() const { return from_.x; }
    float right() const { return to_.x; }
    // The cursor, along the horizontal axis; nothing if it is elsewhere.
    std::optional<double> pointed() const;
    bool held() const { return held_; }
    ImDrawList& list() const { return *list_; }

    // Between two curves. Values outside the axes are cut off.
    void fill(double x0, double x1, Range at_x0, Range at_x1, ImU32 colour) const;
    void line(double x0, double y0, double x1, double y1, ImU32 colour, float width) const;
    void upright(double value, ImU32 colour) const;  // a line from top to bottom

  private:
    void axes(Desk& desk, const Axis& across, const Axis& up) const;

    ImVec2 from_, to_;  // px
    Range across_, up_;
    ImDrawList* list_;
    bool hovered_ = false, held_ = false;
};

}  // namespace game::ui
