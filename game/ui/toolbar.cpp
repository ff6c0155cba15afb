#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"
#include "game/words/words.h"
#include "sim/world/quanta.h"
#include "sim/world/things.h"

namespace game::ui {
namespace {

constexpr float kNameWidth = 3.8f;  // em

// Places groups of known width side by side, and continues on the next line if the row is full.
class Flow {
  public:
    Flow(float most, float gap) : most_(most), gap_(gap) {}

    void next(float width, float gap_before = 0) {
        const float gap = std::max(gap_before, gap_);
        if (used_ > 0 && used_ + gap + width <= most_)
            ImGui::SameLine(0, gap);
        else if (used_ > 0)
            used_ = -gap;
        used_ += width + (used_ != 0 ? gap : 0);
    }
    float left() const { return most_ - used_; }  // in this row, px

  private:
    float most_, gap_, used_ = 0;
};

// The deed that a button names: of the tool in the hand, what it does with the keys that are held.
const Deed& shown(const ToolInfo& info, const Facts& facts) {
    return info.tool == facts.brush.tool ? facts.deed : *info.plain;
}

// Whether a challenge leaves no choice in a number of the tool.
bool is_fixed(double sim::Command::*number, const Facts& facts) {
    const Goal::Tool* const tool =
        facts.scenario.goal ? tool_of(*facts.scenario.goal, facts.deed.kind) : nullptr;
    const Goal::Limit* const limit = tool ? limit_of(*tool, number) : nullptr;
    return limit && limit->least == limit->most;
}

// Lays the tool buttons out, or measures them: `button` gets each with its width and the gap before it.
template <class Button>
void each_tool(Desk& desk, const Facts& facts, bool wordless, const Button& button) {
    const ToolInfo* before = nullptr;
    for (const ToolInfo& info : tool_infos()) {
        if (!is_offered(info, facts.scenario, facts.state)) continue;
        const std::string key = desk.narrow() ? std::string() : name_of(facts.keys, info.tool);
        float width = 0;  // the same with every key that may be held, so that no button moves
        for (const Deed* deed : {info.plain, info.control, info.shift})
            width = std::max(width, desk.widgets.tool_button_width(deed->label, key.c_str(), wordless));
        button(info, width, before && before->group != info.group ? desk.em() : 0, key.c_str());
        before = &info;
    }
}

float width_of_tools(Desk& desk, const Facts& facts, bool wordless) {
    float sum = 0;
    each_tool(desk, facts, wordless, [&](const ToolInfo&, float width, float gap, const char*) {
        sum += width + std::max(gap, ImGui::GetStyle().ItemSpacing.x);
    });
    return sum;
}

void tools(Desk& desk, const Facts& facts, bool wordless, Actions& actions, Flow& flow) {
    each_tool(desk, facts, wordless, [&](const ToolInfo& info, float width, float gap, const char* key) {
        flow.next(width, gap);
        ImGui::PushID(static_cast<int>(info.tool));
        const Deed& deed = shown(info, facts);
        std::array<char, 160> text;
        std::snprintf(text.data(), text.size(), "%s (%s). %s", tr(info.plain->label),
                      name_of(facts.keys, info.tool).c_str(), tr(info.tooltip));
        if (desk.widgets.tool_button(deed.label, deed.icon, key, text.data(), info.tool == facts.brush.tool,
                                     wordless, width))
            actions.emplace_back(info.tool);
        ImGui::PopID();
    });
}

// What the buttons have no room for.
void name_of_tool(Desk& desk, const Facts& facts, Flow& flow) {
    flow.next(kNameWidth * desk.em());
    const float from = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(facts.deed.label));
    desk.widgets.note("Name of the tool");
    ImGui::SameLine(from + kNameWidth * desk.em(), 0);
    ImGui::Dummy({0, 0});
}

bool pours(const ToolInfo& info) {
    return sim::info_of(info.plain->kind).has_layer || sim::info_of(info.control->kind).has_layer;
}

bool slide(Desk& desk, const ToolNumber& number, double& value, float width) {
    const bool wide = number.most / number.least > 20;
    double shown = number.scale * value;
    if (!desk.widgets.slider(
            number.label, shown,
            {number.scale * number.least, number.scale * number.most, number.format, wide, false, width},
            number.tooltip))
        return false;
    value = std::clamp(shown / number.scale, number.least, number.most);
    return true;
}

// Radius and numbers of the tool in the hand.
void sizes(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    const float width = (desk.narrow() ? 7 : 9) * desk.em();
    Brush brush = facts.brush;
    bool changed = false;
    if (takes(info_of(brush.tool).plain->kind, &sim::Command::radius) &&
        !is_fixed(&sim::Command::radius, facts)) {
        const RadiusRange range = radius_range(facts.state.grid);
        flow.next(width);
        changed |= desk.widgets.slider("Radius", brush.radius,
                                       {range.least, range.most, "Radius %.1f m", true, false, width},
                                       "Radius of the brush; Shift and the wheel also change it.");
    }
    const auto numbers = info_of(brush.tool).numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (is_fixed(numbers[i].member, facts)) continue;
        flow.next(width);
        changed |= slide(desk, numbers[i], brush.own()[i], width);
    }
    if (changed) actions.emplace_back(SetBrush{brush});
    if (!numbers.empty() || desk.narrow()) return;
    std::array<char, 160> purpose;
    std::snprintf(purpose.data(), purpose.size(), tr("Hold the left button to %s"), tr(facts.deed.purpose));
    flow.next(ImGui::CalcTextSize(purpose.data()).x);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    ImGui::TextUnformatted(purpose.data());
    ImGui::PopStyleColor();
}

// What is left of a budget of earth.
void earth(Desk& desk, const Facts& facts, Flow& flow) {
    const auto& things = facts.state.things;
    if (!things || things->budget < 0 || !takes(facts.deed.kind, &sim::Command::rise)) return;
    const double quantum = static_cast<double>(sim::kQuantum) * facts.state.grid.cell_area();
    std::array<std::array<char, 40>, 2> volumes;
    std::array<char, 160> text;
    std::snprintf(
        text.data(), text.size(), tr("Earth left: %s of %s"),
        write_volume(volumes[0], static_cast<double>(things->budget - sim::earth_used(*things)) * quantum),
        write_volume(volumes[1], static_cast<double>(things->budget) * quantum));
    flow.next(ImGui::CalcTextSize(text.data()).x, desk.em());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.data());
    desk.widgets.note("Earth left");
    desk.widgets.tooltip(
        "What was cut or what was filled, whichever is more, counts. Putting it back frees it.");
}

// Limits a brush to ground of some slopes.
void slopes(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    if (!sim::info_of(info_of(facts.brush.tool).plain->kind).has_slope) return;
    const float width = (desk.narrow() ? 7.5f : 8.f) * desk.em(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    constexpr double kNarrowest = 1;  // degrees
    Brush brush = facts.brush;
    flow.next(2 * width + gap, desk.em());
    bool changed = desk.widgets.slider(
        "Least slope", brush.least_slope,
        {sim::Command::kNoLeast, sim::Command::kNoMost, "Slopes from %.0f°", false, false, width},
        "The tool leaves ground alone that is less steep.");
    if (changed) brush.most_slope = std::max(brush.most_slope, brush.least_slope + kNarrowest);
    ImGui::SameLine(0, gap);
    if (desk.widgets.slider("Most slope", brush.most_slope,
                            {sim::Command::kNoLeast, sim::Command::kNoMost, "to %.0f°", false, false, width},
                            "The tool leaves ground alone that is steeper.")) {
        changed = true;
        brush.least_slope = std::min(brush.least_slope, brush.most_slope - kNarrowest);
    }
    brush.least_slope =
        std::clamp(brush.least_slope, sim::Command::kNoLeast, sim::Command::kNoMost - kNarrowest);
    brush.most_slope = std::clamp(brush.most_slope, kNarrowest, sim::Command::kNoMost);
    if (changed) actions.emplace_back(SetBrush{brush});
}

// Chooses which of two materials is poured.
void parts(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    const Scenario& scenario = facts.scenario;
    const std::array<std::pair<sim::Part, const std::string*>, 2> materials{
        {{sim::Part::kUpper, &scenario.material}, {sim::Part::kLower, &scenario.lower->material}}};
    for (const auto& [part, material] : materials) {
        const char* title = title_in(facts.catalogue.materials, *material);
        const float width = ImGui::CalcTextSize(tr(title)).x + desk.em();
        flow.next(width, part == sim::Part::kUpper ? 0.7f * desk.em() : 0);
        const bool on = facts.brush.of == part;
        if (!desk.widgets.button(title, "Pours this material.", on, width) || on) continue;
        Brush brush = facts.brush;
        brush.of = part;
        actions.emplace_back(SetBrush{brush});
    }
}

// Chooses the layer that receives poured material, and shows the material.
void material(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    struct Way {
        const char *label, *tooltip;
        bool standing;
    };
    constexpr std::array<Way, 2> kWays{
        {{"Rolling", "Pours into the rolling layer: it flows at once.", false},
         {"Standing", "Pours onto the standing layer: it rests until the slope fails.", true}}};
    const float em = desk.em(), width = 5 * em, gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::BeginDisabled(facts.deed.kind != sim::CommandKind::kPour);
    flow.next(2 * width + gap, em);
    for (const Way& way : kWays) {
        if (way.standing) ImGui::SameLine(0, gap);
        const bool on = facts.brush.standing == way.standing;
        if (desk.widgets.button(way.label, way.tooltip, on, width) && !on)
            actions.emplace_back(Verb::kPourStandingOrRolling);
    }
    if (facts.scenario.lower) parts(desk, facts, actions, flow);
    ImGui::EndDisabled();
    if (facts.scenario.lower || desk.narrow()) return;
    const char* title = tr(title_in(facts.catalogue.materials, facts.scenario.material));
    flow.next(ImGui::CalcTextSize(title).x, 0.7f * em);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    ImGui::TextUnformatted(title);
    ImGui::PopStyleColor();
    desk.widgets.note("Material of the world");
    desk.widgets.tooltip("The material of this world. Choose another in the Scene panel.");
}

void options(Desk& desk, const Facts& facts, bool wordless, Actions& actions, Flow& flow) {
    if (wordless) name_of_tool(desk, facts, flow);
    sizes(desk, facts, actions, flow);
    slopes(desk, facts, actions, flow);
    earth(desk, facts, flow);
    if (pours(info_of(facts.brush.tool))) material(desk, facts, actions, flow);
}

// With that of the menu.
float width_of_panel_buttons() {
    return (kPanels + 1) * ImGui::GetFrameHeight() * 1.2f + kPanels * ImGui::GetStyle().ItemSpacing.x;
}

void panel_buttons(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    const float width = width_of_panel_buttons();
    flow.next(width, std::max(2 * desk.em(), flow.left() - width - 1));
    for (const PanelInfo& info : kPanelInfos) {
        std::array<char, 160> text;
        std::snprintf(text.data(), text.size(), "%s (%s). %s", tr(info.title),
                      name_of(facts.keys, info.verb).c_str(), tr(info.tooltip));
        if (desk.widgets.icon_button(info.title, info.icon, text.data(), desk.panels.is_open(info.panel)))
            desk.panels.toggle(info.panel);
        ImGui::SameLine();
    }
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(), tr("Menu (%s). Scenes, challenges, recordings and settings."),
                  name_of(facts.keys, Verb::kClosePanel).c_str());
    if (desk.widgets.icon_button("Menu", Icon::kMenu, text.data())) actions.emplace_back(Verb::kMenu);
}

void past(Desk& desk, const Facts& facts, Actions& actions) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(facts.timeline.watches ? "Watching a recording (read-only)."
                                                     : "Looking at the past (read-only)."));
    desk.widgets.note("Watching a recording");
    ImGui::SameLine();
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(), tr("%s: continues from this tick in a new recording."),
                  name_of(facts.keys, Verb::kTakeOver).c_str());
    if (desk.widgets.button("Continue from here", text.data())) actions.emplace_back(Verb::kTakeOver);
}

}  // namespace

void toolbar(Desk& desk, const Facts& facts, Actions& actions) {
    const float margin = desk.margin(), padding = 2 * ImGui::GetStyle().WindowPadding.x;
    const float most = desk.size.x - 2 * margin, gap = ImGui::GetStyle().ItemSpacing.x;
    const auto width = [&](bool wordless) {
        return width_of_tools(desk, facts, wordless) + width_of_panel_buttons() + 2 * desk.em() + padding;
    };
    const bool wordless = width(false) > most, wraps = width(wordless) > most;
    const auto needs = [&](Flow& flow) {
        if (facts.looks_back())
            past(desk, facts, actions);
        else
            options(desk, facts, wordless, actions, flow);
    };
    // As wide with every tool, so that no button moves when another one is chosen.
    const float wide = std::min(width(wordless), most);
    ImGui::SetNextWindowPos({desk.size.x / 2, margin}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSizeConstraints({wide, 0}, {wide, desk.size.y});
    ImGui::Begin("Toolbar", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    Flow buttons(wide - padding, gap);
    ImGui::BeginDisabled(facts.looks_back());
    tools(desk, facts, wordless, actions, buttons);
    ImGui::EndDisabled();
    panel_buttons(desk, facts, actions, buttons);
    if (wraps) needs(buttons);  // a small window has no room for another plate
    const ImVec2 from = ImGui::GetWindowPos();
    desk.toolbar_bottom = from.y + ImGui::GetWindowSize().y;
    desk.widgets.keep_window_clear("Toolbar");
    ImGui::End();

    if (!wraps) {  // below it, as wide as what the tool in the hand needs
        // A challenge with few tools has the narrower toolbar of the two.
        const float left = std::max(std::min(from.x, (desk.size.x - desk.options_width) / 2), margin),
                    room = desk.size.x - margin - left;
        ImGui::SetNextWindowPos({left, desk.toolbar_bottom + margin / 3});
        ImGui::SetNextWindowSizeConstraints({0, 0}, {room, desk.size.y});
        ImGui::Begin("Tool options", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
        Flow row(room - padding, gap);
        needs(row);
        desk.options_width = ImGui::GetWindowSize().x;
        desk.toolbar_bottom = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y;
        desk.widgets.keep_window_clear("Tool options");
        ImGui::End();
    }
    desk.widgets.note("Tools", from, {from.x + wide, desk.toolbar_bottom});
}

}  // namespace game::ui
