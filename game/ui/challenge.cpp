#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"
#include "game/words/words.h"

// What a challenge asks, and what a try came to.

namespace game::ui {
namespace {

constexpr float kLineWidth = 44, kLeastLine = 24, kCardWidth = 22, kLeastCard = 10;  // em
constexpr const char* kTryIt = "Try it yourself";  // of a recording that was opened
constexpr const char* kTryItMeans = "Begins this challenge from its start, untouched.";
constexpr float kLeastMap = 5;          // em; if there is less room, a card has no map
constexpr std::size_t kLongText = 400;  // bytes; a task has at most 300

const char* verb_of(sim::CommandKind kind) {
    for (const ToolInfo& info : tool_infos())
        for (const Deed* deed : {info.plain, info.control, info.shift})
            if (deed->kind == kind) return deed->label;
    return sim::info_of(kind).name.data();  // a literal
}

// "Blast 2 of 3", "Plant 1.4 of 6 ha"
void what_is_left(Desk& desk, const Goal& goal, const GoalUse& use) {
    for (const Goal::Tool& tool : goal.tools) {
        const auto left = use.left(tool);
        if (!left) continue;
        const double all = tool.total ? *tool.total : static_cast<double>(*tool.count);
        const std::string_view unit = tool.total ? unit_of(tool.kind) : "";
        std::array<char, 160> text;
        std::array<char, 40> volume_left, volume;
        if (unit == "m3")
            std::snprintf(text.data(), text.size(), tr("%s: %s of %s left"), tr(verb_of(tool.kind)),
                          write_number(volume_left, "%.0f m³", *left), write_number(volume, "%.0f m³", all));
        else
            std::snprintf(text.data(), text.size(), tr("%s: %.4g of %.4g%s%.*s left"), tr(verb_of(tool.kind)),
                          *left, all, unit.empty() ? "" : " ", static_cast<int>(unit.size()), unit.data());
        if (&tool != &goal.tools.front()) ImGui::SameLine(0, 1.5f * desk.em());
        ImGui::PushStyleColor(ImGuiCol_Text, *left > 0 ? kAccent : palette().dim_text);
        ImGui::TextUnformatted(text.data());
        ImGui::PopStyleColor();
        desk.widgets.note(text.data());
    }
    const Goal::Tool* const dig = tool_of(goal, sim::CommandKind::kDig);
    if (!dig || !dig->total) return;
    desk.widgets.dim("Digging uses up what it reaches for: where less lies, less is dug.");
    desk.widgets.note("What digging uses up");
}

void verdict(Desk& desk, const ResultCard& card) {
    if (card.medal) {
        const float side = 2.4f * desk.em();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 middle{at.x + side / 2, at.y + side / 2};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddCircleFilled(middle, side / 2, medal_colour(*card.medal));
        list.AddCircle(middle, side * 0.36f, faded(kAccentText, 0.5f), 0, desk.em() * 0.1f);
        ImGui::Dummy({side, side});
        ImGui::SameLine(0, 0.8f * desk.em());
    }
    ImGui::BeginGroup();
    ImGui::TextUnformatted(card.verdict.c_str());
    desk.widgets.note("Verdict");
    desk.widgets.dim("%s", tr(card.title.c_str()));
    ImGui::EndGroup();
}

// A few letters on a plate around a place of the ground, or below it.
void plate(Desk& desk, glm::dvec2 at, double below, const char* text, ImU32 colour, ImDrawList& list) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 from{static_cast<float>(at.x) - size.x / 2,
                      static_cast<float>(at.y) + static_cast<float>(below) * desk.em()};
    const float edge = 0.35f * desk.em();
    list.AddRectFilled({from.x - edge, from.y - edge / 2},
                       {from.x + size.x + edge, from.y + size.y + edge / 2}, palette().panel, edge);
    list.AddText(from, colour, text);
    desk.widgets.note(text, from, {from.x + size.x, from.y + size.y});
}

// The time until something happens there.
void countdown(Desk& desk, const GoalEvent& event, ImDrawList& list) {
    constexpr double kHundredth = 0.01;  // s; 30 s are not 31 because a tick is no decimal
    std::array<char, 32> text;
    const auto seconds = static_cast<int>(std::ceil(event.in_s - kHundredth));
    std::snprintf(text.data(), text.size(), tr("in %d:%02d"), seconds / 60, seconds % 60);
    plate(desk, event.at, 1, text.data(), kWarning, list);
}

// How much of what counts is there.
void amount_there(Desk& desk, const GoalCount& count, ImDrawList& list) {
    std::array<char, 32> text;
    const double whole = std::round(count.amount);
    if (count.is_share)
        std::snprintf(text.data(), text.size(), "%.0f %%", whole);
    else
        write_volume(text, whole);
    plate(desk, count.at, -0.5, text.data(), medal_colour(3), list);
}

ImU32 colour_of(GoalLine::Around around) {
    switch (around) {
        case GoalLine::Around::kZone:
            return kAccent;
        case GoalLine::Around::kCounted:
            return medal_colour(3);
        case GoalLine::Around::kEvent:
            return kDanger;
        case GoalLine::Around::kDam:
        case GoalLine::Around::kSection:
            return palette().text;
    }
    return palette().text;
}

void stroke(Desk& desk, const GoalLine& line, ImDrawList& list) {
    const auto px = [](glm::dvec2 at) { return ImVec2{static_cast<float>(at.x), static_cast<float>(at.y)}; };
    const float width = desk.em() * (line.around == GoalLine::Around::kDam ? 0.08f : 0.12f);
    list.AddLine(px(line.from), px(line.to), faded(kAccentText, 0.6f), 2 * width);
    list.AddLine(px(line.from), px(line.to), colour_of(line.around), width);
}

// Gold around what counts, blue around where tools work, red around what is going to happen.
void outlines(Desk& desk, const Facts& facts) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const GoalLine& line : facts.goal_lines) stroke(desk, line, list);
    for (const GoalCount& count : facts.goal_counts) amount_there(desk, count, list);
    for (const GoalEvent& event : facts.goal_events) countdown(desk, event, list);
}

// The shipped challenge that is harder than the current one. Null: there is none.
const Catalogue::Entry* harder_challenge(const Facts& facts) {
    const auto& scenes = facts.catalogue.scenes;
    const auto found = std::ranges::find(scenes, facts.scenario.scene, &Catalogue::Entry::harder_than);
    return found == scenes.end() ? nullptr : &*found;
}

// The shipped challenge after the current one; the first after the last. Null: this one is not shipped.
const Catalogue::Entry* next_challenge(const Facts& facts) {
    const Catalogue::Entry* first = nullptr;
    bool found = false;
    for (const Catalogue::Entry& entry : facts.catalogue.scenes) {
        if (entry.kind != Catalogue::Kind::kChallenge) continue;
        const bool is_harder = !entry.harder_than.empty();
        if (is_harder) found |= entry.name == facts.scenario.scene;
        if (is_harder) continue;
        if (found) return &entry;
        if (!first) first = &entry;
        found = entry.name == facts.scenario.scene;
    }
    return found ? first : nullptr;
}

// Of a slide in free play.
void make_it_a_challenge(Desk& desk, const Facts& facts, Actions& actions) {
    ImGui::BeginDisabled(facts.making_challenge);
    if (desk.widgets.button(
            "Make it a challenge",
            facts.making_challenge
                ? "A challenge is being made: its slide is played again."
                : "Makes a challenge of what you did in this world: the same tools, and gold for "
                  "running as far.",
            false, ImGui::GetContentRegionAvail().x))
        actions.emplace_back(MakeChallenge{});
    ImGui::EndDisabled();
}

// The buttons of the card.
void what_next(Desk& desk, const ResultCard& card, const Facts& facts, Actions& actions) {
    const Catalogue::Entry* const harder = card.medal == kGold ? harder_challenge(facts) : nullptr;
    const Catalogue::Entry* const next = harder                       ? harder
                                         : card.medal.value_or(0) > 0 ? next_challenge(facts)
                                                                      : nullptr;
    // In rows of two; the last one fills what is left.
    const float all = ImGui::GetContentRegionAvail().x, half = (all - ImGui::GetStyle().ItemSpacing.x) / 2;
    int buttons = 0;
    const auto offers = [&](const char* label, const char* tooltip, bool is_main, bool is_last = false) {
        if (buttons % 2 == 1) ImGui::SameLine();
        const float width = is_last && buttons % 2 == 0 ? all : half;
        ++buttons;
        return desk.widgets.button(label, tooltip, is_main, width);
    };
    if (card.medal && facts.may_try) {
        if (offers(kTryIt, kTryItMeans, true)) actions.emplace_back(TryChallenge{});
    } else if (card.medal) {
        if (offers("Try again", "Starts the challenge again; this try stays in its recording.", !next))
            actions.emplace_back(Verb::kReset);
    } else if (offers("Again", "Goes back to just before what you did last.", true)) {
        actions.emplace_back(Verb::kUndo);
    }
    if (next && offers(harder ? "Harder" : "Next", next->title.c_str(), true))
        actions.emplace_back(Open{next->name, {}});
    if (card.medal.value_or(0) > 0 && !facts.may_try &&
        offers("Challenge a friend",
               "A page of this challenge for any browser, which asks to beat your best run.", false))
        actions.emplace_back(ChallengeFriend{});
    if (card.map && offers("From the front", "Plays it again, seen from where it came to rest.", false))
        actions.emplace_back(SeeFromFront{});
    if (offers("Look around", "Closes this card; the mountain stays as it is.", false, true))
        actions.emplace_back(Verb::kClosePanel);
}

}  // namespace

void dam(Desk& desk, const Facts& facts) {
    if (!facts.dam) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const GoalLine& line : facts.dam_lines) stroke(desk, line, list);
    std::array<char, 32> volume;
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), tr("%.1f m high, %s"), facts.dam->height,
                  write_volume(volume, facts.dam->volume));
    constexpr double kAbove = -2;  // em
    plate(desk, facts.dam->at, kAbove, text.data(), palette().text, list);
}

void challenge(Desk& desk, const Facts& facts, Actions& actions) {
    if (!facts.scenario.goal || !facts.goal_use) return;
    outlines(desk, facts);
    // Between what is open on the left and on the right, if there is room.
    const float padding = 2 * ImGui::GetStyle().WindowPadding.x;
    float left = desk.left_column, right = desk.right_column + (facts.card ? kCardWidth * desk.em() : 0);
    if (desk.size.x - left - right < kLeastLine * desk.em()) left = right = 0;
    const float room = desk.size.x - left - right - 2 * desk.margin(),
                most = std::min(kLineWidth * desk.em(), room) - padding;
    std::array<char, kLongText> text;
    const char* const say = write_with_volumes(text, tr(std::string_view(facts.scenario.goal->say)));
    const float width = ImGui::CalcTextSize(say, nullptr, false, most).x + padding + 1;
    ImGui::SetNextWindowPos({(left + desk.size.x - right) / 2, desk.toolbar_bottom + desk.margin() / 2},
                            ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, desk.size.y});
    const bool may_try = facts.may_try && facts.timeline.watches;
    ImGui::Begin(
        "Challenge", nullptr,
        kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize | (may_try ? 0 : ImGuiWindowFlags_NoInputs));
    desk.widgets.plain("%s", say);
    desk.widgets.note("Task");
    what_is_left(desk, *facts.scenario.goal, *facts.goal_use);
    if (facts.clock.paused() && !facts.goal_events.empty()) {
        desk.widgets.plain("Time stands still. Look around and get ready, then press %s",
                           name_of(facts.keys, Verb::kPauseOrGoOn).c_str());
        desk.widgets.note("Ready");
    }
    if (facts.ghost) {
        desk.widgets.dim("Reached: %.1f ha; best run by now %.1f ha, dashed", facts.ghost->own,
                         facts.ghost->best);
        desk.widgets.note("Ghost");
    }
    if (may_try && desk.widgets.button(kTryIt, kTryItMeans)) actions.emplace_back(TryChallenge{});
    desk.widgets.keep_window_clear("Challenge");
    ImGui::End();
}

void result_card(Desk& desk, const Facts& facts, Actions& actions) {
    const ResultCard* const card = facts.card;
    if (!card) return;
    const float width = std::min(kCardWidth * desk.em(), desk.size.x - 2 * desk.margin());
    const float right = desk.size.x - desk.margin() - (desk.narrow() ? 0 : desk.right_column);
    // Between the bars, and scrolled if that is not enough.
    const float top = desk.toolbar_bottom + desk.margin(),
                room = std::max(desk.time_bar_top - desk.margin() - top, kLeastCard * desk.em());
    ImGui::SetNextWindowPos({right, top + room / 2}, ImGuiCond_Always, {1, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, room});
    ImGui::SetNextWindowBgAlpha(0.95f);
    ImGui::Begin("Result", nullptr,
                 (kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize) & ~ImGuiWindowFlags_NoScrollbar);
    verdict(desk, *card);
    std::array<char, kLongText> text;
    if (!card->reason.empty()) desk.widgets.plain("%s", write_with_volumes(text, card->reason));
    const float above = ImGui::GetCursorPosY(), map_height = room - desk.card_without_map;
    const bool has_map = card->map && desk.card_without_map > 0 && map_height >= kLeastMap * desk.em();
    if (has_map)
        desk.card_map.show(desk.widgets, card->map, map_height, actions);
    else
        ImGui::Separator();
    const float map_and_gap = has_map ? ImGui::GetCursorPosY() - above : 0;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, desk.em() * 0.1f});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, desk.em() * 0.05f});
    for (const ResultCard::Row& row : card->rows)
        desk.widgets.fact(row.label.c_str(), "%s", write_with_volumes(text, row.value));
    ImGui::PopStyleVar(2);
    if (!card->learn.empty()) {
        ImGui::Separator();
        desk.widgets.plain("%s", write_with_volumes(text, card->learn));
    }
    what_next(desk, *card, facts, actions);
    if (!card->medal) make_it_a_challenge(desk, facts, actions);
    // Of this frame, for the next one: what the map leaves room for does not depend on the map.
    desk.card_without_map = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y - map_and_gap +
                            ImGui::GetStyle().ItemSpacing.y;
    desk.widgets.keep_window_clear("Result");
    ImGui::End();
}

}  // namespace game::ui
