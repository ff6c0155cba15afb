#include <array>
#include <cmath>
#include <cstdio>

#include "game/ui/panels.h"

// What a challenge asks, and what a try came to.

namespace game::ui {
namespace {

constexpr float kLineWidth = 44, kCardWidth = 22;  // em

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
        std::array<char, 64> text;
        std::snprintf(text.data(), text.size(), "%s: %.4g of %.4g%s%.*s left", verb_of(tool.kind), *left, all,
                      unit.empty() ? "" : " ", static_cast<int>(unit.size()), unit.data());
        if (&tool != &goal.tools.front()) ImGui::SameLine(0, 1.5f * desk.em());
        ImGui::PushStyleColor(ImGuiCol_Text, *left > 0 ? kAccent : kDimText);
        ImGui::TextUnformatted(text.data());
        ImGui::PopStyleColor();
        desk.widgets.note(text.data());
    }
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
    desk.widgets.dim("%s", card.title.c_str());
    ImGui::EndGroup();
}

// Gold around what counts, blue around where tools work.
void outlines(const Desk& desk, const Facts& facts) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto px = [](glm::dvec2 at) { return ImVec2{static_cast<float>(at.x), static_cast<float>(at.y)}; };
    for (const GoalLine& line : facts.goal_lines) {
        list.AddLine(px(line.from), px(line.to), faded(kAccentText, 0.6f), desk.em() * 0.25f);
        list.AddLine(px(line.from), px(line.to), line.zone ? kAccent : medal_colour(3), desk.em() * 0.12f);
    }
}

// The shipped challenge after the current one; the first after the last. Null: this one is not shipped.
const Catalogue::Entry* next_challenge(const Facts& facts) {
    const Catalogue::Entry* first = nullptr;
    bool found = false;
    for (const Catalogue::Entry& entry : facts.catalogue.scenes) {
        if (entry.kind != Catalogue::Kind::kChallenge) continue;
        if (found) return &entry;
        if (!first) first = &entry;
        found = entry.name == facts.scenario.scene;
    }
    return found ? first : nullptr;
}

// Of a recording that was opened.
void try_it(Desk& desk, float width, Actions& actions) {
    if (desk.widgets.button("Try it yourself", "Begins this challenge from its start, untouched.", true,
                            width))
        actions.emplace_back(TryChallenge{});
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
    const Catalogue::Entry* const next = card.medal.value_or(0) > 0 ? next_challenge(facts) : nullptr;
    const float gap = ImGui::GetStyle().ItemSpacing.x, all = ImGui::GetContentRegionAvail().x;
    const float each = next ? (all - 2 * gap) / 3 : (all - gap) / 2;
    if (card.medal && facts.may_try) {
        try_it(desk, each, actions);
    } else if (card.medal) {
        if (desk.widgets.button("Try again", "Starts the challenge again; this try stays in its recording.",
                                !next, each))
            actions.emplace_back(Verb::kReset);
    } else if (desk.widgets.button("Again", "Goes back to just before what you did last.", true, each)) {
        actions.emplace_back(Verb::kUndo);
    }
    ImGui::SameLine();
    if (next) {
        if (desk.widgets.button("Next", next->title.c_str(), true, each))
            actions.emplace_back(Open{next->name, {}});
        ImGui::SameLine();
    }
    if (desk.widgets.button("Look around", "Closes this card; the mountain stays as it is.", false, each))
        actions.emplace_back(Verb::kClosePanel);
}

}  // namespace

void challenge(Desk& desk, const Facts& facts, Actions& actions) {
    if (!facts.scenario.goal || !facts.goal_use) return;
    outlines(desk, facts);
    const float padding = 2 * ImGui::GetStyle().WindowPadding.x;
    const float most = std::min(kLineWidth * desk.em(), desk.size.x - 2 * desk.margin()) - padding;
    const char* const say = facts.scenario.goal->say.c_str();
    const float width = ImGui::CalcTextSize(say, nullptr, false, most).x + padding + 1;
    ImGui::SetNextWindowPos({desk.size.x / 2, desk.toolbar_bottom + desk.margin() / 2}, ImGuiCond_Always,
                            {0.5f, 0});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, desk.size.y});
    const bool may_try = facts.may_try && facts.timeline.watches;
    ImGui::Begin(
        "Challenge", nullptr,
        kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize | (may_try ? 0 : ImGuiWindowFlags_NoInputs));
    desk.widgets.plain("%s", say);
    desk.widgets.note("Task");
    what_is_left(desk, *facts.scenario.goal, *facts.goal_use);
    if (facts.ghost) {
        desk.widgets.dim("Reached: %.1f ha; best run by now %.1f ha, dashed", facts.ghost->own,
                         facts.ghost->best);
        desk.widgets.note("Ghost");
    }
    if (may_try) try_it(desk, 0, actions);
    desk.widgets.keep_window_clear("Challenge");
    ImGui::End();
}

void result_card(Desk& desk, const Facts& facts, Actions& actions) {
    const ResultCard* const card = facts.card;
    if (!card) return;
    const float width = std::min(kCardWidth * desk.em(), desk.size.x - 2 * desk.margin());
    const float right = desk.size.x - desk.margin() - (desk.narrow() ? 0 : desk.right_column);
    ImGui::SetNextWindowPos({right, desk.size.y / 2}, ImGuiCond_Always, {1, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, desk.size.y});
    ImGui::SetNextWindowBgAlpha(0.95f);
    ImGui::Begin("Result", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    verdict(desk, *card);
    if (!card->reason.empty()) desk.widgets.plain("%s", card->reason.c_str());
    ImGui::Separator();
    for (const ResultCard::Row& row : card->rows)
        desk.widgets.fact(row.label.c_str(), "%s", row.value.c_str());
    if (!card->learn.empty()) {
        ImGui::Separator();
        desk.widgets.plain("%s", card->learn.c_str());
    }
    what_next(desk, *card, facts, actions);
    if (!card->medal) make_it_a_challenge(desk, facts, actions);
    desk.widgets.keep_window_clear("Result");
    ImGui::End();
}

}  // namespace game::ui
