#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "game/ui/panels.h"
#include "game/words/words.h"

// Names of the parts of a slide over the world, with north and a scale in a corner.

namespace game::ui {
namespace {

constexpr float kPlateEdge = 0.4f, kCompassHeight = 3.4f, kLongestBar = 9;  // em

ImVec2 sum(ImVec2 at, glm::dvec2 away, float times) {
    return {at.x + times * static_cast<float>(away.x), at.y + times * static_cast<float>(away.y)};
}

// A light line that can be seen on snow too.
void line_on_snow(ImDrawList& list, ImVec2 from, ImVec2 to, float em) {
    list.AddLine(from, to, faded(kAccentText, 0.7f), 0.24f * em);
    list.AddLine(from, to, palette().text, 0.09f * em);
}

void draw_arrow(ImDrawList& list, ImVec2 middle, const Compass& compass, const Letters& letters, float em) {
    constexpr float kTip = 0.6f, kTail = 0.95f, kNotch = 0.65f, kHalfWidth = 0.5f;  // em
    const ImVec2 tip = sum(middle, compass.north, kTip * em), tail = sum(middle, compass.north, -kTail * em),
                 notch = sum(middle, compass.north, -kNotch * em);
    list.AddTriangleFilled(tip, sum(tail, compass.east, kHalfWidth * em), notch, palette().dim_text);
    list.AddTriangleFilled(tip, sum(tail, compass.east, -kHalfWidth * em), notch, palette().text);
    const char* const north = tr("N");
    const ImVec2 size = letters.small->CalcTextSizeA(letters.small->FontSize, 1e6f, 0, north);
    const ImVec2 at = sum(tip, glm::normalize(compass.north), 0.65f * em);
    list.AddText(letters.small, letters.small->FontSize, {at.x - size.x / 2, at.y - size.y / 2},
                 palette().text, north);
}

// A bar of a round length, with that length above it.
void draw_scale(ImDrawList& list, ImVec2 left, double metre_px, float em) {
    const double metres = round_length(static_cast<double>(kLongestBar * em) / metre_px);
    const auto length = static_cast<float>(metres * metre_px);
    std::array<char, 40> text;
    write_number(text, metres < 1 ? "%.2g m" : "%.0f m", metres);
    list.AddText({left.x, left.y - 1.45f * em}, palette().text, text.data());
    const float thick = 0.12f * em, high = 0.45f * em;
    const ImVec2 right{left.x + length, left.y};
    list.AddLine(left, right, palette().text, thick);
    for (const ImVec2 end : {left, right})
        list.AddLine({end.x, end.y - high}, {end.x, end.y}, palette().text, thick);
}

// A corner between the bars and beside the open panels that nothing covers.
std::optional<Box> free_corner(const Desk& desk, const Box& room, ImVec2 size) {
    const float left = room.from.x + (desk.narrow() ? 0 : desk.left_column),
                right = room.to.x - size.x - (desk.narrow() ? 0 : desk.right_column),
                bottom = room.to.y - size.y;
    for (const ImVec2 from :
         {ImVec2{right, room.from.y}, {left, room.from.y}, {right, bottom}, {left, bottom}}) {
        const Box box{from, {from.x + size.x, from.y + size.y}};
        const auto covers = [&](const Box& other) { return overlap(box, other); };
        if (std::ranges::none_of(desk.widgets.kept_clear(), covers)) return box;
    }
    return std::nullopt;
}

// Returns what it takes up, if there is a corner for it.
std::optional<Box> draw_compass(Desk& desk, const Compass& compass, const Box& room, ImDrawList& list) {
    constexpr float kArrow = 3.6f, kGap = 0.8f;  // em
    const float em = desk.em(), width = compass.metre_px ? kArrow + kLongestBar + kGap : kArrow;
    const auto box = free_corner(desk, room, {width * em, kCompassHeight * em});
    if (!box) return box;
    list.AddRectFilled(box->from, box->to, palette().panel, kPlateEdge * em);
    const ImVec2 from = box->from;
    draw_arrow(list, {from.x + kArrow / 2 * em, from.y + kCompassHeight / 2 * em}, compass,
               desk.widgets.letters, em);
    if (compass.metre_px)
        draw_scale(list, {from.x + kArrow * em, from.y + 2.45f * em}, *compass.metre_px, em);
    desk.widgets.note("Compass", box->from, box->to);
    return box;
}

void draw_label(Desk& desk, const LabelLayout::Label& label, ImDrawList& list) {
    const float em = desk.em(), edge = kPlateEdge * em;
    const char* const name = SlideParts::kNames[label.key];
    line_on_snow(list, label.at, label.line_end, em);
    list.AddCircleFilled(label.at, 0.26f * em, faded(kAccentText, 0.8f));
    list.AddCircleFilled(label.at, 0.17f * em, palette().text);
    list.AddRectFilled(label.plate.from, label.plate.to, palette().panel, edge);
    list.AddText({label.plate.from.x + edge, label.plate.from.y + edge / 2}, palette().text, tr(name));
    desk.widgets.note(name, label.plate.from, label.plate.to);
}

}  // namespace

void slide_labels(Desk& desk, const Facts& facts) {
    if (!facts.compass) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float em = desk.em(), edge = kPlateEdge * em, margin = desk.margin();
    const Box room{{margin, margin}, {desk.size.x - margin, desk.size.y - margin}};
    Box beside = room;
    if (!desk.panels.hidden())
        beside.from.y = desk.toolbar_bottom + margin, beside.to.y = desk.lower_edge - margin;

    std::array<Box, 32> taken;  // as many as there can be, and the compass
    const auto clear = desk.widgets.kept_clear();
    std::size_t count = std::min(clear.size(), taken.size() - 1);
    std::copy_n(clear.begin(), count, taken.begin());
    if (const auto box = draw_compass(desk, *facts.compass, beside, list)) taken[count++] = *box;

    std::array<LabelLayout::Label, SlideParts::kParts> labels;
    std::size_t wanted = 0;
    for (const SlideLabel& label : facts.slide_labels) {
        const auto key = static_cast<std::size_t>(label.part);
        const ImVec2 size = ImGui::CalcTextSize(tr(SlideParts::kNames[key]));
        labels[wanted++] = {.at = {static_cast<float>(label.at.x), static_cast<float>(label.at.y)},
                            .size = {size.x + 2 * edge, size.y + edge},
                            .key = key};
    }
    const auto asked = std::span(labels).first(wanted);
    desk.labels.lay(asked, room, std::span(taken).first(count), em);
    for (const LabelLayout::Label& label : asked)
        if (label.has_room) draw_label(desk, label, list);
}

}  // namespace game::ui
