#include "game/ui/graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

namespace game::ui {
namespace {

constexpr float kLeft = 3.6f, kRight = 0.5f, kBelow = 1.15f, kClear = 0.5f,
                kAbove = 0.35f;  // em, beside the plot
constexpr ImU32 kGraphPlate = IM_COL32(0, 0, 0, 80);
constexpr int kMostAcross = 5, kMostUp = 5, kPartsFromZero = 4;  // parts of an axis
constexpr float kPartUp = 1.6f;                                  // em, the least

// "1 800 m" at the last number of an axis, else "1 200".
const char* number_at(std::span<char> text, double value, double step, const char* unit) {
    if (value == 0) value = 0;  // and not −0
    std::array<char, 16> format;
    const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 3);
    std::snprintf(format.data(), format.size(), "%%.%df%s%s", digits, *unit ? " " : "", unit);
    return write_number(text, format.data(), value);
}

// The first and the last multiple of a step within a range.
std::pair<std::int64_t, std::int64_t> multiples(const Range& range, double step) {
    constexpr double kRounding = 1e-9;
    return {std::llround(std::ceil(range.least / step - kRounding)),
            std::llround(std::floor(range.most / step + kRounding))};
}

}  // namespace

double round_step(double length, int most) {
    const double least = length / most, power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least * (1 - 1e-9)) return step * power;
    return 10 * power;
}

Range from_zero_to(double value, double least) {
    const double top = std::max(value, least), step = round_step(top, kPartsFromZero);
    return {0, step * std::ceil(top / step - 1e-9)};
}

Graph::Graph(Desk& desk, const char* label, float height, const Axis& across, const Axis& up,
             const char* tooltip)
    : across_(across.range), up_(up.range), list_(ImGui::GetWindowDrawList()) {
    const float em = desk.em();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    from_ = {corner.x + kLeft * em, corner.y + kAbove * em};
    to_ = {corner.x + width - kRight * em, from_.y + height * em};
    ImGui::SetCursorScreenPos(from_);
    ImGui::PushID(label);
    ImGui::InvisibleButton("##graph", {to_.x - from_.x, to_.y - from_.y});
    ImGui::PopID();
    desk.widgets.note(label);
    desk.widgets.tooltip(tooltip);
    hovered_ = ImGui::IsItemHovered();
    held_ = ImGui::IsItemActive();
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({width, (kAbove + height + (across.is_told ? kBelow : 0.2f)) * em});
    list_->AddRectFilled(from_, to_, kGraphPlate);
    axes(desk, across, up);
}

float Graph::x(double value) const {
    const double share = (value - across_.least) / across_.length();
    return from_.x + (to_.x - from_.x) * static_cast<float>(std::clamp(share, 0.0, 1.0));
}

float Graph::y(double value) const {
    const double share = (value - up_.least) / up_.length();
    return to_.y - (to_.y - from_.y) * static_cast<float>(std::clamp(share, 0.0, 1.0));
}

std::optional<double> Graph::pointed() const {
    if (!hovered_ && !held_) return std::nullopt;
    const double share = (ImGui::GetIO().MousePos.x - from_.x) / (to_.x - from_.x);
    return across_.least + across_.length() * std::clamp(share, 0.0, 1.0);
}

void Graph::fill(double x0, double x1, Range at_x0, Range at_x1, ImU32 colour) const {
    const ImDrawListFlags before = list_->Flags;
    list_->Flags &= ~ImDrawListFlags_AntiAliasedFill;  // its fringes would show between neighbours
    list_->AddQuadFilled({x(x0), y(at_x0.most)}, {x(x1), y(at_x1.most)}, {x(x1), y(at_x1.least)},
                         {x(x0), y(at_x0.least)}, colour);
    list_->Flags = before;
}

void Graph::line(double x0, double y0, double x1, double y1, ImU32 colour, float width) const {
    list_->AddLine({x(x0), y(y0)}, {x(x1), y(y1)}, colour, width);
}

void Graph::upright(double value, ImU32 colour) const {
    list_->AddLine({x(value), from_.y}, {x(value), to_.y}, colour);
}

void Graph::axes(Desk& desk, const Axis& across, const Axis& up) const {
    ImFont* const letters = desk.widgets.letters.small;
    const float high = letters->FontSize, em = desk.em();
    const auto width_of = [&](const char* text) { return letters->CalcTextSizeA(high, FLT_MAX, 0, text).x; };
    std::array<char, 32> text;
    const int parts = std::clamp(static_cast<int>((to_.y - from_.y) / (kPartUp * em)), 1, kMostUp);
    const double rise = parts == 1 ? up.range.length() : round_step(up.range.length(), parts);
    const auto [low, top] = multiples(up.range, rise);
    for (std::int64_t i = low; i <= top; ++i) {
        const double value = static_cast<double>(i) * rise;
        list_->AddLine({from_.x, y(value)}, {to_.x, y(value)}, palette().line);
        if (!up.is_told) continue;
        const char* number = number_at(text, value, rise, i == top ? up.unit : "");
        if (width_of(number) > (kLeft - kClear) * em) number = number_at(text, value, rise, "");
        list_->AddText(letters, high, {from_.x - 0.3f * em - width_of(number), y(value) - high / 2},
                       palette().dim_text, number);
    }
    if (!across.is_told) return;
    const double step = round_step(across.range.length(), kMostAcross);
    const auto [first, last] = multiples(across.range, step);
    for (std::int64_t i = first; i <= last; ++i) {
        const double value = static_cast<double>(i) * step;
        const char* const number = number_at(text, value, step, i == last ? across.unit : "");
        const float wide = width_of(number);
        list_->AddLine({x(value), to_.y}, {x(value), to_.y + 0.2f * em}, palette().dim_text);
        list_->AddText(letters, high,
                       {std::min(x(value) - wide / 2, to_.x + kRight * em - wide), to_.y + 0.2f * em},
                       palette().dim_text, number);
    }
}

}  // namespace game::ui
