#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"
#include "game/words/words.h"

// The first minute: a slide to watch, then hints for the first steps, one at a time.

namespace game::ui {
namespace {

struct Words {
    const char* heading;
    std::array<char, 160> text;
};

Words words_of(Guide::Step step, const Keys& keys) {
    Words words{"", {}};
    const auto say = [&](const char* heading, const char* format, const std::string& key) {
        words.heading = tr(heading);
        std::snprintf(words.text.data(), words.text.size(), tr(format), key.c_str());
    };
    switch (step) {
        case Guide::Step::kBlast:
            say("Your turn", "Click on the snow, high up.", "");
            break;
        case Guide::Step::kRewind:
            say("Too much?", "Press %s: time runs back.", name_of(keys, Verb::kRunBack));
            break;
        case Guide::Step::kGoOn:
            say("Far enough?", "Press %s to go on from here.", name_of(keys, Verb::kTakeOver));
            break;
        case Guide::Step::kPour:
            say("Now pour", "Press %s, then hold the left button and drag along the ridge.",
                name_of(keys, Tool::kPour));
            break;
        case Guide::Step::kChallenge:
            say("A challenge", "One shovel of snow: how far can you make it run?", "");
            break;
        case Guide::Step::kWatch:
        case Guide::Step::kDone:
            break;
    }
    return words;
}

// A ring that closes in on a place, again and again.
void place_to_click(Desk& desk, glm::dvec2 at, double now_s) {
    constexpr double kPeriod = 1.6;  // s
    const float em = desk.em(), share = static_cast<float>(std::fmod(now_s, kPeriod) / kPeriod);
    const ImVec2 middle{static_cast<float>(at.x), static_cast<float>(at.y)};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float radius = em * (3.2f - 2.4f * share);
    list.AddCircle(middle, radius, faded(palette().notice_plate, share), 0, em * 0.32f);
    list.AddCircle(middle, radius, faded(kWarning, share), 0, em * 0.18f);  // white would be lost on snow
    list.AddCircleFilled(middle, em * 0.32f, palette().notice_plate);
    list.AddCircleFilled(middle, em * 0.24f, kWarning);
    const char* const say = tr("Try here");
    const ImVec2 size = ImGui::CalcTextSize(say), from{middle.x - size.x / 2, middle.y + em * 1.2f};
    list.AddRectFilled({from.x - em * 0.5f, from.y - em * 0.2f},
                       {from.x + size.x + em * 0.5f, from.y + size.y + em * 0.2f}, palette().notice_plate,
                       em * 0.3f);
    list.AddText(from, palette().text, say);
    desk.widgets.note("Try here", from, {from.x + size.x, from.y + size.y});
}

// A line on a plate above the lower edge.
void low_line(Desk& desk, const char* text) {
    const float em = desk.em();
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 from{std::round((desk.size.x - size.x) / 2), desk.size.y - 3 * em};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({from.x - em * 0.8f, from.y - em * 0.4f},
                       {from.x + size.x + em * 0.8f, from.y + size.y + em * 0.4f}, palette().panel,
                       em * 0.4f);
    list.AddText(from, palette().text, text);
}

// Text with a shadow that makes it readable over snow.
void over_image(ImFont& font, const char* text, ImVec2 middle, float strength) {
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, 1e6f, 0, text);
    const ImVec2 at{std::round(middle.x - size.x / 2), std::round(middle.y - size.y / 2)};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float off = std::max(font.FontSize / 16, 1.f);
    list.AddText(&font, font.FontSize, {at.x, at.y + off}, faded(kAccentText, 0.7f * strength), text);
    list.AddText(&font, font.FontSize, at, faded(IM_COL32_WHITE, strength), text);
}

}  // namespace

void title(Desk& desk, float strength) {
    over_image(*desk.widgets.letters.title, "Couloir", {desk.size.x / 2, desk.size.y * 0.15f}, strength);
}

void opening(Desk& desk, const Facts& facts) {
    constexpr float kTitleStays = 3.5f, kFades = 1, kSkipFrom = 2;  // s
    const auto shown_s = static_cast<float>(*facts.opening_s);
    const float strength = std::clamp((kTitleStays - shown_s) / kFades, 0.f, 1.f);
    if (strength > 0) title(desk, strength);
    std::array<char, 160> text;
    std::array<char, 40> volume;
    if (shown_s > kTitleStays + kFades && facts.state.ledger.rolling > 0) {
        const double quantum = static_cast<double>(sim::kQuantum) * facts.state.grid.cell_area();
        std::snprintf(text.data(), text.size(),
                      tr("%s of snow on the move. It began with a few blasts on the ridge."),
                      write_volume(volume, static_cast<double>(facts.state.ledger.rolling) * quantum));
        low_line(desk, text.data());
    } else if (shown_s > kSkipFrom) {
        low_line(desk, tr("Press any key to play"));
    }
    desk.widgets.note("Couloir", {0, 0}, desk.size);
}

// Of a hill without a cover, such as an elevation file has none, on which old snow is only drawn.
void bare_ground(Desk& desk, const Facts& facts, Actions& actions) {
    if (!facts.is_bare() || desk.panels.is_open(Panel::kHelp)) return;
    constexpr double kCover = 1;  // m
    const float width = std::min(44 * desk.em(), desk.size.x - 2 * desk.margin());
    ImGui::SetNextWindowPos({desk.size.x / 2, desk.time_bar_top - desk.margin()}, ImGuiCond_Always,
                            {0.5f, 1});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, desk.size.y});
    ImGui::Begin("Bare ground", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    desk.widgets.plain(
        "Nothing lies on this ground that could be released or dug: old snow on it is only drawn.");
    desk.widgets.note("Bare ground");
    if (desk.widgets.button("Cover it with 1 m",
                            "Begins this world anew with 1 m of its material on all ground "
                            "that is not too steep.",
                            true))
        actions.emplace_back(CoverGround{kCover});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::Text(tr("or pour some: tool %s."), name_of(facts.keys, Tool::kPour).c_str());
    desk.lower_edge = ImGui::GetWindowPos().y;
    desk.widgets.keep_window_clear("Cover");
    ImGui::End();
}

void guide(Desk& desk, const Facts& facts, Actions& actions) {
    if (!facts.guide || !facts.guide->speaks() || facts.is_bare() || desk.panels.is_open(Panel::kHelp))
        return;
    if (facts.card && desk.narrow()) return;  // it needs the room
    const Words words = words_of(facts.guide->step(), facts.keys);
    const bool asks = facts.guide->step() == Guide::Step::kChallenge;
    const float em = desk.em();
    ImGui::SetNextWindowPos({desk.size.x / 2, desk.time_bar_top - desk.margin()}, ImGuiCond_Always,
                            {0.5f, 1});
    ImGui::Begin("Guide", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    ImGui::TextUnformatted(words.heading);
    ImGui::PopStyleColor();
    desk.widgets.note(words.heading);
    ImGui::SameLine(0, em);
    ImGui::TextUnformatted(words.text.data());
    desk.widgets.note(words.text.data());
    ImGui::SameLine(0, em);
    if (asks && desk.widgets.button("Try it", "Starts this challenge.", true))
        actions.insert(actions.end(),
                       {Action(GuideWish{GuideWish::kNext}), Action(Open{Guide::kChallenge, {}})});
    if (asks) ImGui::SameLine();
    if (asks ? desk.widgets.button("Later", "The menu has all challenges.")
             : desk.widgets.icon_button("Close hint", Icon::kClose,
                                        "Closes this hint and goes on to the next."))
        actions.emplace_back(GuideWish{GuideWish::kNext});
    desk.lower_edge = ImGui::GetWindowPos().y;
    desk.widgets.keep_window_clear("Guide");
    ImGui::End();
    if (facts.place_to_click) place_to_click(desk, *facts.place_to_click, facts.now_s);
}

}  // namespace game::ui
