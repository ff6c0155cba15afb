#include <algorithm>
#include <array>
#include <cstdio>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"

namespace game::ui {
namespace {

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

  private:
    float most_, gap_, used_ = 0;
};

struct ToolInfo {
    Tool tool;
    Verb verb;
    const char* label;
    const char* inverted;  // what it does while Ctrl is held
    Icon icon, inverted_icon;
    const char* tooltip;
    const char* strength;  // format
};
constexpr std::array<ToolInfo, kTools> kToolInfos{{
    {Tool::kPour, Verb::kPour, "Pour", "Dig", Icon::kPour, Icon::kDig,
     "Hold the left button on the terrain to add material; with Ctrl, to remove it.", "Rate %.2f m/s"},
    {Tool::kDig, Verb::kDig, "Dig", "Pour", Icon::kDig, Icon::kPour,
     "Hold the left button on the terrain to remove material; with Ctrl, to add it.", "Rate %.2f m/s"},
    {Tool::kBlast, Verb::kBlast, "Blast", "Settle", Icon::kBlast, Icon::kSettle,
     "Click on the terrain to release the ground; with Ctrl, to deposit the flow.", "Depth %.2f m"},
}};

void tools(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    for (const ToolInfo& info : kToolInfos) {
        const bool on = facts.brush.tool == info.tool, inverted = on && facts.inverted;
        const char* label = inverted ? info.inverted : info.label;
        const std::string key = name_of(info.verb);
        flow.next(desk.widgets.tool_button_width(label, key.c_str(), desk.narrow()));
        ImGui::PushID(info.label);
        if (desk.widgets.tool_button(label, inverted ? info.inverted_icon : info.icon, key.c_str(),
                                     info.tooltip, on, desk.narrow()))
            actions.emplace_back(info.verb);
        ImGui::PopID();
    }
}

void sizes(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    const float em = desk.em(), width = 9 * em;
    Brush brush = facts.brush;
    const RadiusRange range = radius_range(facts.state.grid);
    flow.next(width, em);
    bool changed = desk.widgets.slider("Radius", brush.radius,
                                       {range.least, range.most, "Radius %.1f m", true, false, width},
                                       "Radius of the brush; Shift and the wheel also change it.");
    flow.next(width);
    const char* format = kToolInfos[static_cast<std::size_t>(brush.tool)].strength;
    changed |= desk.widgets.slider("Strength", brush.amount(),
                                   {Brush::kLeastStrength, Brush::kMostStrength, format, true, false, width},
                                   brush.tool == Tool::kBlast ? "Depth of ground that a blast releases."
                                                              : "Depth added or removed per second.");
    if (changed) actions.emplace_back(SetBrush{brush});
}

// Chooses which of two materials is poured.
void parts(Desk& desk, const Facts& facts, Actions& actions, Flow& flow) {
    const Scenario& scenario = facts.scenario;
    const std::array<std::pair<sim::Part, const std::string*>, 2> materials{
        {{sim::Part::kUpper, &scenario.material}, {sim::Part::kLower, &scenario.lower->material}}};
    for (const auto& [part, material] : materials) {
        const char* title = title_in(facts.catalogue.materials, *material);
        const float width = ImGui::CalcTextSize(title).x + desk.em();
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
    ImGui::BeginDisabled(deed_of(facts.brush, facts.inverted) != sim::CommandKind::kPour);
    flow.next(2 * width + gap, em);
    for (const Way& way : kWays) {
        if (way.standing) ImGui::SameLine(0, gap);
        const bool on = facts.brush.standing == way.standing;
        if (desk.widgets.button(way.label, way.tooltip, on, width) && !on)
            actions.emplace_back(Verb::kPourStandingOrRolling);
    }
    if (facts.scenario.lower) parts(desk, facts, actions, flow);
    ImGui::EndDisabled();
    if (facts.scenario.lower) return;
    const char* title = title_in(facts.catalogue.materials, facts.scenario.material);
    flow.next(ImGui::CalcTextSize(title).x, 0.7f * em);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, kDimText);
    ImGui::TextUnformatted(title);
    ImGui::PopStyleColor();
    desk.widgets.note("Material of the world");
    desk.widgets.tooltip("The material of this world. Choose another in the Scene panel.");
}

void panel_buttons(Desk& desk, Flow& flow) {
    const float width = ImGui::GetFrameHeight() * 1.2f, gap = ImGui::GetStyle().ItemSpacing.x;
    flow.next(kPanels * width + (kPanels - 1) * gap, desk.em());
    for (const PanelInfo& info : kPanelInfos) {
        std::array<char, 96> text;
        std::snprintf(text.data(), text.size(), "%s: %s", name_of(info.verb).c_str(), info.tooltip);
        if (info.panel != Panel::kScene) ImGui::SameLine();
        if (desk.widgets.icon_button(info.title, info.icon, text.data(), desk.panels.is_open(info.panel)))
            desk.panels.toggle(info.panel);
    }
}

void past(Desk& desk, const Facts& facts, Actions& actions) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(facts.timeline.watches ? "Watching a recording (read-only)."
                                                  : "Looking at the past (read-only).");
    desk.widgets.note("Watching a recording");
    ImGui::SameLine();
    std::array<char, 96> text;
    std::snprintf(text.data(), text.size(), "%s: continues from this tick in a new recording.",
                  name_of(Verb::kTakeOver).c_str());
    if (desk.widgets.button("Continue from here", text.data())) actions.emplace_back(Verb::kTakeOver);
}

}  // namespace

void toolbar(Desk& desk, const Facts& facts, Actions& actions) {
    const float margin = desk.margin();
    ImGui::SetNextWindowPos({desk.size.x / 2, margin}, ImGuiCond_Always, {0.5f, 0});
    ImGui::Begin("Toolbar", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    const float inside = desk.size.x - 2 * margin - 2 * ImGui::GetStyle().WindowPadding.x;
    Flow flow(inside, ImGui::GetStyle().ItemSpacing.x);
    ImGui::BeginDisabled(facts.looks_back());
    tools(desk, facts, actions, flow);
    sizes(desk, facts, actions, flow);
    material(desk, facts, actions, flow);
    ImGui::EndDisabled();
    panel_buttons(desk, flow);
    if (facts.looks_back()) past(desk, facts, actions);
    desk.toolbar_bottom = margin + ImGui::GetWindowSize().y;
    ImGui::End();
}

}  // namespace game::ui
