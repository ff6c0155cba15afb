#include "game/ui/icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "game/ui/style.h"

namespace game::ui {
namespace {

constexpr float kPi = 3.14159265f;

// Draws in a square from −1 to 1 with y down.
class Pen {
  public:
    Pen(ImDrawList& list, ImVec2 centre, float size, ImU32 colour)
        : list_(list), centre_(centre), half_(size / 2), width_(std::max(1.f, size / 9)), colour_(colour) {}

    ImVec2 at(float x, float y) const { return {centre_.x + x * half_, centre_.y + y * half_}; }

    void line(float x0, float y0, float x1, float y1) const {
        list_.AddLine(at(x0, y0), at(x1, y1), colour_, width_);
    }
    void path(std::initializer_list<ImVec2> points) const {
        for (const ImVec2& point : points) list_.PathLineTo(at(point.x, point.y));
        list_.PathStroke(colour_, ImDrawFlags_None, width_);
    }
    void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const {
        list_.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour_);
    }
    void box(float x0, float y0, float x1, float y1) const {
        list_.AddRectFilled(at(x0, y0), at(x1, y1), colour_, half_ * 0.1f);
    }
    void dot(float x, float y, float radius) const {
        list_.AddCircleFilled(at(x, y), radius * half_, colour_);
    }
    void ring(float x, float y, float radius) const {
        list_.AddCircle(at(x, y), radius * half_, colour_, 0, width_);
    }
    // Angles from east, clockwise on screen.
    void arc(float x, float y, float radius, float from, float to) const {
        list_.PathArcTo(at(x, y), radius * half_, from, to);
        list_.PathStroke(colour_, ImDrawFlags_None, width_);
    }
    void text(const char* letter) const {
        const float height = half_ * 2;
        const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(height, 1e6f, 0, letter);
        list_.AddText(ImGui::GetFont(), height, {centre_.x - size.x / 2, centre_.y - size.y / 2}, colour_,
                      letter);
    }
    void rays(float from, float to, int count) const {
        for (int i = 0; i < count; ++i) {
            const float angle = 2 * kPi * static_cast<float>(i) / static_cast<float>(count);
            line(std::cos(angle) * from, std::sin(angle) * from, std::cos(angle) * to, std::sin(angle) * to);
        }
    }

  private:
    ImDrawList& list_;
    ImVec2 centre_;
    float half_, width_;
    ImU32 colour_;
};

void draw_part(const Pen& pen, const IconPart& part) {
    const auto& n = part.numbers;
    switch (part.shape) {
        case IconPart::Shape::kLine:
            return pen.line(n[0], n[1], n[2], n[3]);
        case IconPart::Shape::kTriangle:
            return pen.triangle({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]});
        case IconPart::Shape::kBox:
            return pen.box(n[0], n[1], n[2], n[3]);
        case IconPart::Shape::kDot:
            return pen.dot(n[0], n[1], n[2]);
        case IconPart::Shape::kRing:
            return pen.ring(n[0], n[1], n[2]);
        case IconPart::Shape::kRays:
            return pen.rays(n[0], n[1], static_cast<int>(n[2]));
    }
}

void draw_time(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::kPause:
            pen.box(-0.6f, -0.8f, -0.2f, 0.8f);
            return pen.box(0.2f, -0.8f, 0.6f, 0.8f);
        case Icon::kPlay:
            return pen.triangle({-0.55f, -0.85f}, {0.85f, 0}, {-0.55f, 0.85f});
        case Icon::kStep:
            pen.triangle({-0.75f, -0.75f}, {0.35f, 0}, {-0.75f, 0.75f});
            return pen.box(0.45f, -0.75f, 0.8f, 0.75f);
        case Icon::kSkip:
            pen.triangle({-0.9f, -0.7f}, {-0.1f, 0}, {-0.9f, 0.7f});
            pen.triangle({-0.15f, -0.7f}, {0.6f, 0}, {-0.15f, 0.7f});
            return pen.box(0.65f, -0.7f, 0.9f, 0.7f);
        case Icon::kBack:
            pen.triangle({0.05f, -0.7f}, {-0.85f, 0}, {0.05f, 0.7f});
            return pen.triangle({0.85f, -0.7f}, {-0.05f, 0}, {0.85f, 0.7f});
        case Icon::kUndo:
            pen.arc(0, 0.15f, 0.7f, -kPi * 0.8f, kPi * 0.65f);
            return pen.triangle({-1, -0.05f}, {-0.75f, -0.85f}, {-0.2f, -0.25f});
        case Icon::kRedo:
            pen.arc(0, 0.15f, 0.7f, kPi * 0.35f, kPi * 1.8f);
            return pen.triangle({1, -0.05f}, {0.75f, -0.85f}, {0.2f, -0.25f});
        case Icon::kShare:  // an arrow out of a box
            pen.path({{-0.45f, -0.15f},
                      {-0.8f, -0.15f},
                      {-0.8f, 0.85f},
                      {0.8f, 0.85f},
                      {0.8f, -0.15f},
                      {0.45f, -0.15f}});
            pen.line(0, 0.4f, 0, -0.5f);
            return pen.triangle({0, -1}, {0.4f, -0.4f}, {-0.4f, -0.4f});
        default:  // reset: back to the start
            pen.box(-0.85f, -0.75f, -0.5f, 0.75f);
            return pen.triangle({0.75f, -0.75f}, {-0.4f, 0}, {0.75f, 0.75f});
    }
}

void draw_panel(const Pen& pen, Icon icon) {
    constexpr std::array kKnobs{0.4f, -0.35f, 0.15f};
    switch (icon) {
        case Icon::kScene:  // mountains
            pen.triangle({-0.3f, -0.8f}, {0.45f, 0.75f}, {-1, 0.75f});
            return pen.triangle({0.5f, -0.2f}, {1, 0.75f}, {0, 0.75f});
        case Icon::kPhysics:  // knobs on slides
            for (std::size_t i = 0; i < kKnobs.size(); ++i) {
                const float y = -0.65f + 0.65f * static_cast<float>(i);
                pen.line(-0.9f, y, 0.9f, y);
                pen.dot(kKnobs[i], y, 0.26f);
            }
            return;
        case Icon::kDisplay:  // sun
            pen.ring(0, 0, 0.4f);
            return pen.rays(0.65f, 1, 8);
        case Icon::kPerformance:
            pen.box(-0.85f, 0.1f, -0.4f, 0.8f);
            pen.box(-0.22f, -0.8f, 0.22f, 0.8f);
            return pen.box(0.4f, -0.3f, 0.85f, 0.8f);
        case Icon::kFilm:  // a camera from the side
            pen.box(-0.9f, -0.5f, 0.35f, 0.6f);
            return pen.triangle({0.45f, 0.05f}, {0.95f, -0.45f}, {0.95f, 0.55f});
        case Icon::kMeasure:  // axes with a curve
            pen.path({{-0.85f, -0.85f}, {-0.85f, 0.8f}, {0.9f, 0.8f}});
            return pen.path({{-0.5f, 0.4f}, {-0.15f, -0.15f}, {0.2f, 0.15f}, {0.8f, -0.65f}});
        case Icon::kHelp:
            return pen.text("?");
        case Icon::kLeft:
            return pen.path({{0.35f, -0.7f}, {-0.35f, 0}, {0.35f, 0.7f}});
        case Icon::kMenu:
            for (const float y : {-0.55f, 0.f, 0.55f}) pen.line(-0.75f, y, 0.75f, y);
            return;
        case Icon::kLock:
            pen.arc(0, -0.2f, 0.42f, -kPi, 0);
            return pen.box(-0.7f, -0.15f, 0.7f, 0.85f);
        default:  // close
            pen.line(-0.6f, -0.6f, 0.6f, 0.6f);
            return pen.line(-0.6f, 0.6f, 0.6f, -0.6f);
    }
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
    const Pen pen(list, centre, size, colour);
    if (icon < Icon::kScene) return draw_time(pen, icon);
    draw_panel(pen, icon);
}

void draw_icon(ImDrawList& list, std::span<const IconPart> parts, ImVec2 centre, float size, ImU32 colour) {
    const Pen pen(list, centre, size, colour);
    for (const IconPart& part : parts) draw_part(pen, part);
}

void draw_stars(ImDrawList& list, int medal, ImVec2 left, float em, ImU32 outline) {
    constexpr int kStars = 3, kCorners = 10;
    const float each = kStarsWidth * em / kStars;
    for (int star = 0; star < kStars; ++star) {
        const ImVec2 middle{left.x + each * (static_cast<float>(star) + 0.5f), left.y};
        std::array<ImVec2, kCorners> corners;
        for (int i = 0; i < kCorners; ++i) {
            const float angle = kPi * (2 * static_cast<float>(i) / kCorners - 0.5f),
                        radius = each * (i % 2 == 0 ? 0.48f : 0.21f);
            corners[static_cast<std::size_t>(i)] = {middle.x + radius * std::cos(angle),
                                                    middle.y + radius * std::sin(angle)};
        }
        const bool filled = star < medal;
        if (filled)
            for (std::size_t i = 0; i < kCorners; i += 2)
                list.AddQuadFilled(middle, corners[(i + kCorners - 1) % kCorners], corners[i], corners[i + 1],
                                   medal_colour(medal));
        list.AddPolyline(corners.data(), kCorners, filled ? medal_colour(medal) : faded(outline, 0.5f),
                         ImDrawFlags_Closed, std::max(1.f, em * 0.06f));
    }
}

}  // namespace game::ui
