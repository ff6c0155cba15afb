#include <algorithm>
#include <array>
#include <cstdio>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"
#include "game/words/words.h"
#include "sim/world/ledger.h"

// Notices and the first hint, drawn over the image. They are not windows, so the mouse passes through them.

namespace game::ui {
namespace {

struct Line {
    const char* text;
    ImU32 mark;  // colour of the bar at its left
    float strength;
    float most_width;  // px, of the text
};

ImVec2 size_of(const Desk& desk, const Line& line) {
    const ImVec2 text = ImGui::CalcTextSize(line.text, nullptr, false, line.most_width);
    return {text.x + 1.7f * desk.em(), text.y + desk.em()};
}

void draw(const Desk& desk, const Line& line, ImVec2 from) {
    const float em = desk.em();
    const ImVec2 size = size_of(desk, line), to{from.x + size.x, from.y + size.y};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled(from, to, faded(palette().panel | IM_COL32_A_MASK, 0.94f * line.strength), em * 0.4f);
    list.AddRectFilled({from.x, from.y}, {from.x + em * 0.25f, to.y}, faded(line.mark, line.strength),
                       em * 0.4f, ImDrawFlags_RoundCornersLeft);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {from.x + em * 0.95f, from.y + em * 0.5f},
                 faded(palette().text, line.strength), line.text, nullptr, line.most_width);
}

// The page of a shared slide: how much of it is done, as a number and as a bar along the lower edge.
void draw_progress(const Desk& desk, double done, const Line& line, ImVec2 from) {
    draw(desk, line, from);
    const ImVec2 size = size_of(desk, line);
    const float em = desk.em(), left = from.x + em * 0.95f, y = from.y + size.y - em * 0.3f;
    const float width = size.x - 1.7f * em;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({left, y}, {left + width, y + em * 0.12f}, palette().control_held);
    list.AddRectFilled({left, y}, {left + width * static_cast<float>(done), y + em * 0.12f}, kAccent);
}

}  // namespace

void notices(Desk& desk, const Facts& facts, bool warnings_only) {
    const float margin = desk.margin(), em = desk.em();
    // Beside the time bar if there is room, else above it, beside the readings or the panels.
    const bool hidden = desk.panels.hidden() || facts.photo;
    const bool column = desk.right_column > 0 && !desk.narrow() && !hidden;
    const bool beside = ((desk.beside_time_bar() && !column) || hidden) && !facts.photo;
    const float right = desk.size.x - (column ? desk.right_column : 0);
    const float room = facts.photo ? desk.size.x
                       : beside    ? desk.time_bar_left
                                   : desk.size.x - (kReadingsWidth + 0.6f) * em;
    float bottom = (beside ? desk.size.y : desk.lower_edge) - margin;
    if (facts.sharing && !warnings_only) {
        std::array<char, 64> text;
        std::snprintf(text.data(), text.size(), tr("Sharing this slide: %3.0f %% of its page"),
                      100 * *facts.sharing);
        const Line line{text.data(), kAccent, 1, room};
        const ImVec2 size = size_of(desk, line), from{right - margin - size.x, bottom - size.y};
        draw_progress(desk, *facts.sharing, line, from);
        desk.widgets.note("Sharing", from, {from.x + size.x, bottom});
        bottom = from.y - margin / 2;
    }
    for (std::size_t i = facts.notices.size(); i-- > 0;) {  // the newest is lowest
        const Notice& notice = facts.notices[i];
        const bool warning = notice.kind == Notice::Kind::kWarning;
        const auto strength = static_cast<float>(Notices::strength(notice, facts.now_s));
        if (strength <= 0 || (warnings_only && !warning)) continue;
        std::array<char, 512> text, sentence;
        std::snprintf(text.data(), text.size(), notice.times > 1 ? tr("%s (%d times)") : "%s",
                      write_with_volumes(sentence, notice.sentence), notice.times);
        const Line line{text.data(), warning ? kWarning : kAccent, strength,
                        std::min(24 * em, room - 2 * margin - 2.5f * em)};
        const ImVec2 size = size_of(desk, line);
        const ImVec2 from{right - margin - size.x, bottom - size.y};
        draw(desk, line, from);
        desk.widgets.note(notice.sentence, from, {from.x + size.x, bottom});
        desk.widgets.keep_clear({from, {from.x + size.x, bottom}});
        bottom = from.y - margin / 2;
    }
}

void hint(Desk& desk, const Facts& facts) {
    desk.lower_edge = desk.time_bar_top;
    if (facts.guide && facts.guide->step() != Guide::Step::kDone && !facts.scenario.goal)
        return;  // it says more
    if (facts.touched || facts.looks_back() || facts.is_bare() || desk.panels.is_open(Panel::kHelp)) return;
    if (sim::flows(facts.state) && !facts.scenario.flow) return;  // what moves by itself is looked at first
    std::array<char, 256> text;
    const std::string keys = name_of(facts.keys, Verb::kToggleHelp);
    if (facts.scenario.flow)
        std::snprintf(text.data(), text.size(),
                      tr("Flow demo: press %s to change its speeds, %s to show all keys."),
                      name_of(facts.keys, Verb::kToggleDisplay).c_str(), keys.c_str());
    else
        std::snprintf(text.data(), text.size(),
                      tr("Hold the left button on the terrain to %s. Press %s to show all keys."),
                      tr(facts.deed.purpose), keys.c_str());
    const Line line{text.data(), kAccent, 1, desk.size.x - 4 * desk.em()};
    const ImVec2 size = size_of(desk, line);
    const ImVec2 from{(desk.size.x - size.x) / 2, desk.time_bar_top - desk.margin() - size.y};
    draw(desk, line, from);
    desk.lower_edge = from.y;
    const ImVec2 to{from.x + size.x, from.y + size.y};
    desk.widgets.note("Hint", from, to);
    desk.widgets.keep_clear({from, to});
}

// Beside the cursor: what the stroke costs, or how long its line is.
void stroke_note(Desk& desk, const Facts& facts) {
    if (!facts.stroke) return;
    const StrokeNote& note = *facts.stroke;
    const float em = desk.em();
    const ImVec2 at{static_cast<float>(note.cursor.x), static_cast<float>(note.cursor.y)};
    std::array<char, 160> text{};
    std::array<char, 40> used{}, left{};
    if (note.left_alone)
        std::snprintf(text.data(), text.size(), tr("Left alone: slope outside %.0f° to %.0f°"),
                      facts.brush.least_slope, facts.brush.most_slope);
    else if (note.length && *note.length >= 1)
        std::snprintf(text.data(), text.size(), "%.0f m", *note.length);
    else if (note.earth && *note.earth < 0)
        std::snprintf(text.data(), text.size(), tr("%s of earth given back"),
                      write_volume(used, -*note.earth));
    else if (note.earth && note.earth_left)
        std::snprintf(text.data(), text.size(), tr("%s of earth, %s left"), write_volume(used, *note.earth),
                      write_volume(left, *note.earth_left));
    else if (note.earth)
        std::snprintf(text.data(), text.size(), tr("%s of earth"), write_volume(used, *note.earth));
    if (text[0] == 0) return;
    const Line line{text.data(), kAccent, 1, 24 * em};
    const ImVec2 size = size_of(desk, line);
    const ImVec2 from{std::min(at.x + 1.2f * em, desk.size.x - size.x), std::max(at.y - em - size.y, 0.f)};
    draw(desk, line, from);
    desk.widgets.note("Stroke", from, {from.x + size.x, from.y + size.y});
}

}  // namespace game::ui
