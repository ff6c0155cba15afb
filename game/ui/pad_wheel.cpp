// The wheel of a gamepad: choices around the middle of the image, of which a stick points at one.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/ui/panels.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kRadius = 9, kChosenRadius = 2.3f, kRimWidth = 5.2f;  // em

// Whether the world lets a person have it.
bool is_there(const PadChoice& choice, const Facts& facts) {
    const Tool* const tool = std::get_if<Tool>(&choice.does);
    return !tool || is_offered(info_of(*tool), facts.scenario, facts.state);
}

void centred(ImDrawList& list, ImFont& font, ImVec2 middle, ImU32 colour, std::string_view text) {
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, 1e6f, 0, text.data(), text.data() + text.size());
    list.AddText(&font, font.FontSize, {std::round(middle.x - size.x / 2), std::round(middle.y - size.y / 2)},
                 colour, text.data(), text.data() + text.size());
}

}  // namespace

void pad_wheel(Desk& desk, const Facts& facts) {
    if (!facts.gamepad || !facts.gamepad->wheel()) return;
    const auto& [wheel, chosen] = *facts.gamepad->wheel();
    const auto choices = choices_of(wheel);
    const float em = desk.em(), radius = std::min(kRadius * em, desk.size.y * 0.36f);
    const ImVec2 middle{desk.size.x / 2, desk.size.y / 2};
    ImFont &usual = *desk.widgets.letters.usual, &small = *desk.widgets.letters.small;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddCircle(middle, radius, faded(palette().notice_plate, 0.85f), 0, kRimWidth * em);
    list.AddCircleFilled(middle, radius * 0.55f, faded(palette().notice_plate, 0.9f));
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const double turn =
            2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(choices.size());
        const ImVec2 at{middle.x + radius * static_cast<float>(std::sin(turn)),
                        middle.y - radius * static_cast<float>(std::cos(turn))};
        const bool on = chosen == i;
        const ImU32 colour = on                            ? kAccentText
                             : is_there(choices[i], facts) ? palette().text
                                                           : faded(palette().dim_text, 0.5f);
        if (on) list.AddCircleFilled(at, kChosenRadius * em, kAccent);
        const Tool* const tool = std::get_if<Tool>(&choices[i].does);
        if (tool) draw_icon(list, info_of(*tool).plain->icon, {at.x, at.y - em * 0.5f}, em * 1.3f, colour);
        centred(list, small, {at.x, at.y + (tool ? em * 0.9f : 0)}, colour, tr(choices[i].label));
        desk.widgets.note(choices[i].label, {at.x - em, at.y - em}, {at.x + em, at.y + em});
    }
    centred(list, usual, {middle.x, middle.y - em * 0.3f}, chosen ? palette().text : palette().dim_text,
            tr(chosen ? choices[*chosen].label : std::string_view("Point with a stick")));
    centred(list, small, {middle.x, middle.y + em * 0.9f}, palette().dim_text, tr("let go to take it"));
}

}  // namespace game::ui
