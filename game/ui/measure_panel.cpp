#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <glm/trigonometric.hpp>

#include "game/ui/graph.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kProfileHeight = 8, kSpeedHeight = 4;  // em
constexpr double kLayerShare = 0.2;                    // of the relief, that the deepest layers are drawn as
constexpr double kLeastSpeed = 5;                      // m/s, at the top of its axis

// The letters of the ends, as they are on the mountain; at the bottom, where the ground is behind them.
void name_ends(Desk& desk, const Graph& graph) {
    ImFont* const letters = desk.widgets.letters.small;
    const float edge = 0.3f * desk.em(), high = letters->FontSize, y = graph.bottom() - edge - high;
    graph.list().AddText(letters, high, {graph.left() + edge, y}, palette().text, "A");
    graph.list().AddText(letters, high, {graph.right() - edge - 0.6f * high, y}, palette().text, "B");
}

// How the section is drawn.
struct Profile {
    double length = 0;  // m
    Range heights;      // m
    double times = 1;   // by which the layers are drawn deeper than they are
};

double along(const Profile& profile, std::size_t i) {
    return profile.length * static_cast<double>(i) / static_cast<double>(CrossSection::kPoints - 1);
}

Profile profile_of(const CrossSection& section) {
    constexpr std::array kTimes{100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0};
    constexpr double kLeastRelief = 0.05;                       // of the length
    constexpr double kBelowGround = 0.14, kAboveGround = 0.08;  // of the relief
    Profile profile{section.line()->length(), {1e9, -1e9}, 1};
    for (const SectionPoint& point : section.points()) {
        if (!point.has_data) continue;
        profile.heights.least = std::min(profile.heights.least, point.ground);
        profile.heights.most = std::max(profile.heights.most, point.ground);
    }
    if (profile.heights.length() < 0) profile.heights = {0, 0};
    const double relief = std::max(profile.heights.length(), kLeastRelief * profile.length);
    const auto fits = [&](double times) { return times * section.deepest() <= kLayerShare * relief; };
    const auto times = std::ranges::find_if(kTimes, fits);
    profile.times = times == kTimes.end() ? kTimes.back() : *times;
    profile.heights.least -= kBelowGround * relief;
    profile.heights.most += std::max(profile.times * section.deepest(), kAboveGround * relief);
    return profile;
}

// The curve of `value` from point to point, but for where there is no data.
template <class Draw>
void each_piece(const CrossSection& section, const Draw& draw) {
    const auto points = section.points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        if (points[i].has_data && points[i + 1].has_data) draw(i, points[i], points[i + 1]);
}

void draw_profile(Desk& desk, const CrossSection& section, const Profile& profile, const Graph& graph) {
    const auto standing = [&](const SectionPoint& p) { return p.ground + profile.times * p.standing; };
    const auto rolling = [&](const SectionPoint& p) { return standing(p) + profile.times * p.rolling; };
    each_piece(section, [&](std::size_t i, const SectionPoint& a, const SectionPoint& b) {
        const double x0 = along(profile, i), x1 = along(profile, i + 1);
        graph.fill(x0, x1, {profile.heights.least, a.ground}, {profile.heights.least, b.ground},
                   kBedrockColour);
        graph.fill(x0, x1, {a.ground, standing(a)}, {b.ground, standing(b)}, kStandingColour);
        graph.fill(x0, x1, {standing(a), rolling(a)}, {standing(b), rolling(b)}, kFlowColour);
        graph.line(x0, rolling(a), x1, rolling(b), palette().text, 0.06f * desk.em());
    });
}

void draw_speed(Desk& desk, const CrossSection& section, const Profile& profile, const Graph& graph) {
    each_piece(section, [&](std::size_t i, const SectionPoint& a, const SectionPoint& b) {
        const double x0 = along(profile, i), x1 = along(profile, i + 1);
        graph.fill(x0, x1, {0, a.speed}, {0, b.speed}, faded(kFlowColour, 0.35f));
        graph.line(x0, a.peak_speed, x1, b.peak_speed, palette().dim_text, 0.06f * desk.em());
        if (a.speed > 0 || b.speed > 0) graph.line(x0, a.speed, x1, b.speed, kFlowColour, 0.11f * desk.em());
    });
}

// A square in the colour of what the word after it names.
void swatch(Desk& desk, ImU32 colour, const char* word) {
    const float side = 0.6f * desk.em(), high = desk.widgets.letters.small->FontSize;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + (high - side) / 2;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + side, y + side}, colour, 0.2f * side);
    ImGui::Dummy({side, high});
    ImGui::SameLine(0, 0.35f * desk.em());
    desk.widgets.dim("%s", tr(word));
}

// At the cursor, or of the whole line.
void tell_section(Desk& desk, const CrossSection& section, const Profile& profile,
                  const std::optional<double>& pointed) {
    const auto points = section.points();
    std::array<char, 32> height, length;
    if (!pointed) {
        const double fall = points.front().ground - points.back().ground;
        desk.widgets.dim("Length %s, %s %s, on average %.0f°", write_number(length, "%.0f m", profile.length),
                         fall < 0 ? tr("rise") : tr("fall"), write_number(height, "%.0f m", std::abs(fall)),
                         glm::degrees(std::atan(std::abs(fall) / profile.length)));
        return;
    }
    const double share = *pointed / profile.length;
    const SectionPoint& at =
        points[static_cast<std::size_t>(std::lround(share * static_cast<double>(points.size() - 1)))];
    desk.widgets.dim("%s from A: height %s, standing %.1f m, rolling %.1f m, %.0f m/s",
                     write_number(length, "%.0f m", *pointed), write_number(height, "%.0f m", at.ground),
                     at.standing, at.rolling, at.speed);
}

void cross_section(Desk& desk, const CrossSection& section) {
    const Profile profile = profile_of(section);
    const Range across{0, profile.length};
    swatch(desk, kBedrockColour, "ground");
    ImGui::SameLine(0, desk.em());
    swatch(desk, kStandingColour, "standing layer");
    ImGui::SameLine(0, desk.em());
    swatch(desk, kFlowColour, "rolling layer");
    const Graph ground(desk, "Profile", kProfileHeight, {across, "m", false}, {profile.heights, "m"});
    draw_profile(desk, section, profile, ground);
    name_ends(desk, ground);
    double fastest = 0;
    for (const SectionPoint& point : section.points())
        fastest = std::max({fastest, point.speed, point.peak_speed});
    const Graph speed(desk, "Speed along the line", kSpeedHeight, {across, "m"},
                      {from_zero_to(fastest, kLeastSpeed), "m/s"});
    draw_speed(desk, section, profile, speed);
    const auto pointed = ground.pointed() ? ground.pointed() : speed.pointed();
    if (pointed) ground.upright(*pointed, palette().text), speed.upright(*pointed, palette().text);
    tell_section(desk, section, profile, pointed);
    desk.widgets.note("Of the line");
    desk.widgets.dim("Layers are drawn %.0f × as deep. Grey: the greatest speed so far.", profile.times);
    desk.widgets.note("Scale of the layers");
}

void along_a_line(Desk& desk, const Facts& facts, Actions& actions) {
    const float width = ImGui::GetContentRegionAvail().x;
    const bool waits = facts.section && facts.section->waits,
               has_line = facts.section && facts.section->section.line();
    if (desk.widgets.button(waits ? "Draw no line" : "Draw a line",
                            waits ? "The left button is for the tool again."
                                  : "The next drag with the left button on the mountain is the line of the "
                                    "cross-section.",
                            waits || !has_line, width))
        actions.emplace_back(DrawSection{!waits});
    if (waits)
        desk.widgets.plain("Now drag on the mountain with the left button, from A to B.");
    else if (!has_line)
        desk.widgets.dim(
            "Draw a line on the mountain, such as down the path of a slide. The cross-section shows the "
            "ground "
            "along it, the layers on it and the speed of the flow.");
    if (has_line) cross_section(desk, facts.section->section);
}

void end_mark(Desk& desk, const std::optional<glm::dvec2>& at, const char* name, ImDrawList& list) {
    if (!at) return;
    const float em = desk.em();
    const ImVec2 middle{static_cast<float>(at->x), static_cast<float>(at->y)},
        size = ImGui::CalcTextSize(name);
    list.AddCircleFilled(middle, 0.75f * em, palette().panel);
    list.AddCircle(middle, 0.75f * em, palette().text, 0, 0.1f * em);
    list.AddText({middle.x - size.x / 2, middle.y - size.y / 2}, palette().text, name);
}

// Its number, as in the list.
void house_mark(Desk& desk, const HouseMark& house, ImDrawList& list) {
    const bool is_told = house.house == desk.told_house;
    std::array<char, 24> number;
    std::snprintf(number.data(), number.size(), "%zu", house.house + 1);
    const ImVec2 size = ImGui::CalcTextSize(number.data());
    const float edge = 0.25f * desk.em();
    const ImVec2 from{static_cast<float>(house.at.x) - size.x / 2,
                      static_cast<float>(house.at.y) - size.y - 2 * edge};
    list.AddRectFilled({from.x - edge, from.y - edge / 2},
                       {from.x + size.x + edge, from.y + size.y + edge / 2},
                       is_told ? kAccent : palette().panel, edge);
    list.AddText(from, is_told ? kAccentText : palette().text, number.data());
}

}  // namespace

void measure_panel(Desk& desk, const Facts& facts, Actions& actions) {
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (desk.widgets.button("Along a line", "A cross-section along a line that you draw.",
                            !desk.measures_over_time, half))
        desk.measures_over_time = false;
    ImGui::SameLine();
    if (desk.widgets.button("Over time", "Run-out, volume, speed and pressure since the beginning.",
                            desk.measures_over_time, half)) {
        desk.measures_over_time = true;
        if (facts.section && facts.section->waits) actions.emplace_back(DrawSection{false});
    }
    desk.measures_over_time ? plots_over_time(desk, facts, actions) : along_a_line(desk, facts, actions);
}

void section_line(Desk& desk, const Facts& facts) {
    if (!facts.section) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto px = [](glm::dvec2 at) { return ImVec2{static_cast<float>(at.x), static_cast<float>(at.y)}; };
    const float thin = 0.12f * desk.em();
    for (const GoalLine& piece : facts.section->pieces)
        list.AddLine(px(piece.from), px(piece.to), faded(kAccentText, 0.6f), 2.5f * thin);
    for (const GoalLine& piece : facts.section->pieces)
        list.AddLine(px(piece.from), px(piece.to), palette().text, thin);
    end_mark(desk, facts.section->from, "A", list);
    end_mark(desk, facts.section->to, "B", list);
    if (!desk.measures_over_time) return;
    for (const HouseMark& house : facts.houses) house_mark(desk, house, list);
}

}  // namespace game::ui
