#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "game/ui/panels.h"
#include "game/words/words.h"
#include "sim/world/params.h"

namespace game::ui {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

struct Group {
    const char* title;
    std::array<std::string_view, 11> names;  // of kParams; empty beyond the last
};
// Parameters in no group are listed under the last title.
constexpr std::array<Group, 5> kGroups{{
    {"Release", {"start_slope", "start_depth", "loose_slope", "anchor_gain", "anchor_margin", "anchor_step"}},
    {"Flow",
     {"rolling_speed", "shear_rate", "speed_per_slope", "max_speed", "friction", "drag", "friction_thin",
      "friction_fold_depth", "fluidization", "cohesion_depth", "drag_exponent"}},
    {"Exchange and entrainment",
     {"exchange_rate", "exchange_depth", "erosion_rate", "erosion_slope", "erosion_depth"}},
    {"Deposition", {"stop_slope", "deposit_rate", "deposit_speed", "freeze_depth"}},
    {"Time steps", {}},
}};

std::size_t group_of(std::string_view name) {
    for (std::size_t i = 0; i < kGroups.size(); ++i)
        for (const std::string_view each : kGroups[i].names)
            if (each == name) return i;
    return kGroups.size() - 1;
}

// The last group is numerical, not physical, and is fixed by the scene.
bool editable(const sim::ParamInfo& info) {
    return !info.fixed && group_of(info.name) + 1 < kGroups.size();
}

bool is_slope(const sim::ParamInfo& info) {
    return info.unit == "1" && info.name.find("_slope") != std::string_view::npos;
}

// The value as displayed: slopes in degrees.
double shown(const sim::ParamInfo& info, float value) {
    return is_slope(info) ? std::atan(static_cast<double>(value)) * kDegrees : static_cast<double>(value);
}

// The parameter value for a typed number.
float meant(const sim::ParamInfo& info, double typed) {
    return static_cast<float>(is_slope(info) ? std::tan(typed / kDegrees) : typed);
}

const char* unit_of(const sim::ParamInfo& info) {
    return is_slope(info) ? "°" : info.unit == "1" ? "" : info.unit.data();  // a literal
}

// "start slope": the name without a unit suffix.
std::array<char, 32> label_of(const sim::ParamInfo& info) {
    std::string_view name = info.name;
    if (name.ends_with("_s")) name.remove_suffix(2);
    std::array<char, 32> label{};
    for (std::size_t i = 0; i < name.size() && i + 1 < label.size(); ++i)
        label[i] = name[i] == '_' ? ' ' : name[i];
    return label;
}

// Tells what is wrong with what was typed for a parameter, and the value that it keeps.
void refuse(Desk& desk, const sim::ParamInfo& info, float kept, std::string_view sentence) {
    const std::array<char, 32> label = label_of(info);
    const char* unit = unit_of(info);
    std::snprintf(desk.refusal.data(), desk.refusal.size(), tr("Not set: %.*s. %s stays %.4g%s%s."),
                  static_cast<int>(sentence.size()), sentence.data(), tr(label.data()), shown(info, kept),
                  *unit != 0 ? " " : "", unit);
}

// Rejects text that is no number, or a number out of range, in the unit in which it was typed.
void refuse_typed(Desk& desk, const sim::ParamInfo& info, float kept, const double* typed) {
    std::array<char, 160> sentence;
    const std::array<char, 32> label = label_of(info);
    if (typed)
        std::snprintf(sentence.data(), sentence.size(), tr("%s must be from %.4g to %.4g %s, not %.4g"),
                      tr(label.data()), shown(info, info.least), shown(info, info.most), unit_of(info),
                      *typed);
    else
        std::snprintf(sentence.data(), sentence.size(), tr("%s must be a number"), tr(label.data()));
    refuse(desk, info, kept, sentence.data());
}

void set(Desk& desk, const sim::Params& params, std::size_t param, float value, Actions& actions) {
    const sim::ParamInfo& info = sim::kParams[param];
    sim::Params changed = params;
    changed.*info.value = value;
    desk.refusal[0] = 0;
    if (auto fault = sim::fault_of(changed)) {
        std::replace(fault->begin(), fault->end(), '_', ' ');  // names, as they are called in this panel
        refuse(desk, info, params.*info.value, *fault);
    } else
        actions.emplace_back(SetNumber{param, value});
}

void write_tooltip(std::span<char> text, const sim::ParamInfo& info, float value, sim::Model model) {
    const auto length = [](std::string_view part) { return static_cast<int>(part.size()); };
    const std::string_view meaning = tr(info.meaning);
    const double least = shown(info, info.least), most = shown(info, info.most);
    const char* unit = unit_of(info);
    const int used = std::snprintf(text.data(), text.size(), tr("%.*s: %.*s; from %.4g to %.4g%s%s."),
                                   length(info.name), info.name.data(), length(meaning), meaning.data(),
                                   least, most, *unit != 0 ? " " : "", unit);
    if (used <= 0 || static_cast<std::size_t>(used) >= text.size()) return;
    const std::span<char> rest = text.subspan(static_cast<std::size_t>(used));
    // Else it seems wrong wherever steeper ground stays.
    const bool anchored = info.name == "start_slope" && model == sim::Model::kBcreInertial;
    if (is_slope(info))
        std::snprintf(rest.data(), rest.size(), tr(" Its tangent is %.4g.%s"), static_cast<double>(value),
                      anchored ? tr(" Natural ground that began steeper holds: see anchor gain.") : "");
    else if (!editable(info))
        std::snprintf(rest.data(), rest.size(), tr(" Fixed by the scene."));
}

void number(Desk& desk, const Facts& facts, std::size_t param, Actions& actions) {
    const sim::ParamInfo& info = sim::kParams[param];
    const float now = facts.state.params.*info.value, usual = facts.scenario.params.*info.value;
    const std::array<char, 32> label = label_of(info);
    std::array<char, 480> tooltip;
    write_tooltip(tooltip, info, now, facts.state.params.model);
    const Typed typed = desk.widgets.number(
        {label.data(), shown(info, now), shown(info, usual), unit_of(info), tooltip.data(), editable(info)});
    switch (typed.what) {
        case Typed::What::kNothing:
            return;
        case Typed::What::kNonsense:
            return refuse_typed(desk, info, now, nullptr);
        case Typed::What::kUsual:
            return set(desk, facts.state.params, param, usual, actions);
        case Typed::What::kValue:
            if (!(typed.value >= shown(info, info.least) && typed.value <= shown(info, info.most)))
                return refuse_typed(desk, info, now, &typed.value);
            return set(desk, facts.state.params, param, meant(info, typed.value), actions);
    }
}

// Resets one parameter at a time, in an order in which the thresholds stay valid after each step.
void ask_for_defaults(const Facts& facts, Actions& actions) {
    sim::Params params = facts.state.params;
    for (std::size_t pass = 0; pass < std::size(sim::kParams) && params != facts.scenario.params; ++pass)
        for (std::size_t i = 0; i < std::size(sim::kParams); ++i) {
            const auto value = sim::kParams[i].value;
            sim::Params next = params;
            next.*value = facts.scenario.params.*value;
            if (next == params || sim::fault_of(next)) continue;
            params = next;
            actions.emplace_back(SetNumber{i, params.*value});
        }
}

void all_defaults(Desk& desk, const Facts& facts, Actions& actions) {
    ImGui::BeginDisabled(facts.state.params == facts.scenario.params);
    if (desk.widgets.button("All defaults", "Resets every parameter to its value at the start of the scene.",
                            false, ImGui::GetContentRegionAvail().x)) {
        desk.refusal[0] = 0;
        ask_for_defaults(facts, actions);
    }
    ImGui::EndDisabled();
}

}  // namespace

void physics_panel(Desk& desk, const Facts& facts, Actions& actions) {
    const sim::Params& params = facts.state.params;
    ImGui::BeginDisabled(facts.looks_back());
    for (std::size_t group = 0; group < kGroups.size(); ++group) {
        desk.widgets.heading(kGroups[group].title);
        if (group + 1 == kGroups.size())
            desk.widgets.fact("model", "%s", sim::to_string(params.model).data());
        for (std::size_t i = 0; i < std::size(sim::kParams); ++i)
            if (sim::is_used_by(sim::kParams[i], params.model) && group_of(sim::kParams[i].name) == group)
                number(desk, facts, i, actions);
    }
    ImGui::Dummy({0, desk.em() * 0.2f});
    all_defaults(desk, facts, actions);
    ImGui::EndDisabled();
    // Drawn over the bottom of the panel, so that no row moves under the cursor.
    if (desk.refusal[0] != 0) desk.widgets.warn_over_foot("Refusal", desk.refusal.data());
}

}  // namespace game::ui
