#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "game/controls/resolution_control.h"
#include "game/sound/waves.h"
#include "game/ui/legend.h"
#include "game/ui/panels.h"
#include "render/view/sky_light.h"

namespace game::ui {
namespace {

struct OverlayName {
    render::Overlay overlay;
    const char* name;
};
constexpr std::array<OverlayName, 9> kOverlays{{
    {render::Overlay::kNone, "material"},
    {render::Overlay::kSlope, "slope"},
    {render::Overlay::kStanding, "standing depth"},
    {render::Overlay::kRolling, "rolling depth"},
    {render::Overlay::kSpeed, "speed in plan"},
    {render::Overlay::kPressure, "pressure"},
    {render::Overlay::kStretch, "texture stretch"},
    {render::Overlay::kWater, "water in the soil"},
    {render::Overlay::kProbability, "probability"},  // the last one, because only many runs have it
}};

// Which probability of the runs is shown.
bool probability(Desk& desk, const RunsNote& runs, Display& display) {
    bool changed = false;
    if (display.overlay == render::Overlay::kProbability) {
        int chosen = static_cast<int>(runs.chosen);
        desk.widgets.row("Probability");
        changed = desk.widgets.choice("Probability", chosen, static_cast<int>(runs.maps),
                                      "The share of runs in which a place felt this.",
                                      [&](int i) { return runs.map_name(static_cast<std::size_t>(i)); });
        if (changed) display.probability = static_cast<std::size_t>(chosen);
    }
    changed |= desk.widgets.toggle("End points", display.ends,
                                   "Where the runs ended; a click on one opens its run.");
    return changed;
}

// In which month plants are drawn, where the scene says on which day.
bool month(Desk& desk, const Facts& facts, Display& display) {
    static constexpr std::array kMonths{"January",   "February", "March",    "April",
                                        "May",       "June",     "July",     "August",
                                        "September", "October",  "November", "December"};
    if (!facts.scenario.look.date || !display.date) return false;
    constexpr int kMiddle = 15;  // day
    int chosen = display.date->month - 1;
    desk.widgets.row("Month");
    if (!desk.widgets.choice("Month", chosen, static_cast<int>(kMonths.size()),
                             "How far grass and leaves are, for the eye alone.",
                             [](int i) { return kMonths[static_cast<std::size_t>(i)]; }))
        return false;
    display.date = render::Date{chosen + 1, kMiddle};
    return true;
}

bool colours(Desk& desk, const Facts& facts, Display& display) {
    int chosen = 0;
    for (std::size_t i = 0; i < kOverlays.size(); ++i)
        if (kOverlays[i].overlay == display.overlay) chosen = static_cast<int>(i);
    desk.widgets.row("Colour by");
    const auto count = static_cast<int>(kOverlays.size()) - (facts.runs ? 0 : 1);
    bool changed =
        desk.widgets.choice("Colour by", chosen, count, "Quantity shown by the colours of the ground.",
                            [](int i) { return kOverlays[static_cast<std::size_t>(i)].name; });
    if (changed) display.overlay = kOverlays[static_cast<std::size_t>(chosen)].overlay;
    draw_legend(render::legend_of(display.overlay), desk.em(), *desk.widgets.letters.small);
    if (display.overlay == render::Overlay::kPressure && !densities_of(facts.scenario))
        desk.widgets.dim("Pressure needs the density of every material, and a file here has none.");
    if (facts.runs) changed |= probability(desk, *facts.runs, display);
    changed |= desk.widgets.toggle("Contours", display.contours, "Lines of equal height.");
    changed |= desk.widgets.toggle("Labels", display.labels,
                                   "Names of the parts of the largest slide, with north and a scale.");
    changed |= desk.widgets.toggle("Fronts", display.flow_mesh,
                                   "Shows the texture mesh, cut along the fronts, and the front points.");
    changed |=
        desk.widgets.toggle("Surroundings", display.surroundings,
                            "Mountains around the grid, for the eye alone. Off: a block cut from them.");
    if (facts.scenario.goal)
        changed |=
            desk.widgets.toggle("Ghost", display.ghost,
                                "Dashed: what your best run of this challenge had reached by the same time.");
    if (facts.scenario.trees.density > 0)
        changed |= desk.widgets.toggle("Trees", display.trees, "Trees of the scene, for the eye alone.");
    changed |= month(desk, facts, display);
    return changed;
}

bool sun(Desk& desk, const Facts& facts, Display& display) {
    desk.widgets.heading("Sun");
    desk.widgets.row("Direction");
    bool changed = desk.widgets.slider("Direction", display.light.azimuth_deg, {0, 360, "%.0f°"},
                                       "Azimuth of the sun: 0 is north, 90 east.");
    desk.widgets.row("Height above horizon");
    changed |=
        desk.widgets.slider("Height above horizon", display.light.elevation_deg,
                            {render::kLowestSunDeg, render::kHighestSunDeg, "%.0f°"},
                            "Elevation of the sun; a low sun shows the shape of the ground. Below 0: dusk, "
                            "then night with a moon opposite.");
    if (desk.widgets.button("Reset sun", "Restores the sun position of the scene.")) {
        display.light = facts.scenario.light;
        changed = true;
    }
    return changed;
}

constexpr std::array<const char*, 4> kWays{"no cuts", "half an edge", "the paper's points", "fitted points"};

// Parameters of a flow demo that can change while it runs.
bool flow(Desk& desk, Display& display) {
    sim::fields::FlowNumbers& numbers = display.flow;
    desk.widgets.heading("Flow");
    desk.widgets.row("Flow speed");
    bool changed =
        desk.widgets.slider("Flow speed", numbers.speed, {0, 1, "%.2f sides/s"},
                            "Speed of the flow on each side of the front, in domain widths per second.");
    desk.widgets.row("Front speed");
    changed |= desk.widgets.slider("Front speed", numbers.front_speed, {-4, 4, "%.1f ×"},
                                   "Speed factor of the front: 0 stops it, negative reverses it.");
    desk.widgets.row("Smooth field");
    changed |= desk.widgets.slider("Smooth field", numbers.smooth, {0, 0.1, "%.3f sides/s"},
                                   "Speed of an added smooth field without fronts.");
    int way = numbers.cut ? 1 + static_cast<int>(numbers.source) : 0;
    desk.widgets.row("Texture cuts");
    if (desk.widgets.choice("Texture cuts", way, static_cast<int>(kWays.size()),
                            "Whether textures are cut along fronts, and how the fronts are located.",
                            [](int i) { return kWays[static_cast<std::size_t>(i)]; })) {
        numbers.cut = way > 0;
        if (way > 0) numbers.source = static_cast<sim::front::PointSource>(way - 1);
        changed = true;
    }
    return changed;
}

constexpr double kStep = 5;  // percent, step to which sliders are rounded

double in_steps(double percent) {
    return kStep * std::round(percent / kStep);
}

// The largest text size, in percent, at which a panel still fits beside the bars.
double most_letters(const Desk& desk) {
    const double fits = std::min(static_cast<double>(desk.size.x) / kLeastWidth,
                                 static_cast<double>(desk.size.y) / kLeastHeight);
    return std::clamp(kStep * std::floor(100 * fits / desk.usual_em / kStep), 100., 300.);
}

// The words of resolutions, in the order of kScales.
constexpr std::array<const char*, kScales.size()> kScaleNames{"full", "3/4", "1/2", "3/8", "1/4"};

// What an image may lose while something moves.
bool quality(Desk& desk, Display& display) {
    constexpr std::array<const char*, kTiers.size()> kLabels{"Fast", "Balanced", "Full"};
    desk.widgets.heading("Quality while something moves");
    bool changed = false;
    for (std::size_t i = 0; i < kTiers.size(); ++i) {
        const auto tier = static_cast<Tier>(i);
        if (i > 0) ImGui::SameLine();
        if (!desk.widgets.button(kLabels[i], kTiers[i].tooltip, display.tier == tier)) continue;
        changed |= display.tier != tier;
        display.tier = tier;
    }
    desk.widgets.row("Frame time");
    double frame_ms = display.frame_ms;
    if (desk.widgets.slider("Frame time", frame_ms,
                            {Display::kLeastFrameMs, Display::kMostFrameMs, "%.0f ms", true, true},
                            "Fast and balanced lower the resolution until a frame takes no longer.")) {
        display.frame_ms = std::round(frame_ms);
        changed = true;
    }
    int most = 0;
    for (std::size_t i = 0; i < kScales.size(); ++i)
        if (kScales[i] == display.most_scale) most = static_cast<int>(i);
    desk.widgets.row("Resolution limit");
    if (desk.widgets.choice("Resolution limit", most, static_cast<int>(kScales.size()),
                            "Drawn pixels per screen pixel along each axis, at most, in fast and balanced.",
                            [](int i) { return kScaleNames[static_cast<std::size_t>(i)]; })) {
        display.most_scale = kScales[static_cast<std::size_t>(most)];
        changed = true;
    }
    return changed;
}

// That of the system, and all that there are.
bool language(Desk& desk, const Facts& facts, Display& display) {
    if (facts.languages.size() < 2) return false;
    int chosen = 0;
    for (std::size_t i = 0; i < facts.languages.size(); ++i)
        if (facts.languages[i].code == display.language) chosen = static_cast<int>(i) + 1;
    desk.widgets.row("Language");
    if (!desk.widgets.choice("Language", chosen, static_cast<int>(facts.languages.size()) + 1,
                             "The language of the window.", [&](int i) {
                                 return i == 0
                                            ? "as the system has it"
                                            : facts.languages[static_cast<std::size_t>(i - 1)].name.c_str();
                             }))
        return false;
    display.language = chosen == 0 ? "" : facts.languages[static_cast<std::size_t>(chosen - 1)].code;
    return true;
}

bool picture(Desk& desk, const Facts& facts, Display& display) {
    desk.widgets.heading("Picture");
    bool changed = language(desk, facts, display);
    changed |= desk.widgets.toggle("Field's words", display.field_words,
                                   "Standing and rolling layer, aspect, speed in plan. Off: plain words.");
    changed |= desk.widgets.toggle("High contrast", display.contrast,
                                   "White on black panels, for projectors and bright rooms.");
    double detail = static_cast<double>(display.detail) * 100,
           powder = static_cast<double>(display.powder) * 100, letters = display.letters * 100;
    desk.widgets.row("Fine relief");
    if (desk.widgets.slider("Fine relief", detail, {0, 100, "%.0f %%"},
                            "Strength of the small-scale relief on ground and material.")) {
        display.detail = static_cast<float>(detail / 100);
        changed = true;
    }
    desk.widgets.row("Text size");
    if (desk.widgets.slider("Text size", letters, {50, most_letters(desk), "%.0f %%", false, true},
                            "Size of text and panels.")) {
        display.letters = in_steps(letters) / 100;
        changed = true;
    }
    desk.widgets.row("Powder");
    if (desk.widgets.slider("Powder", powder, {0, 100, "%.0f %%"},
                            "Strength of the powder or dust over a fast flow; 0 draws none.")) {
        display.powder = static_cast<float>(powder / 100);
        changed = true;
    }
    return changed;
}

bool sounds(Desk& desk, const Facts& facts, Display& display) {
    desk.widgets.heading("Sound");
    bool changed = false;
    const auto slider = [&](const char* name, const char* tooltip, double& value) {
        double percent = 100 * value;
        desk.widgets.row(name);
        if (!desk.widgets.slider(name, percent, {0, 100, "%.0f %%", false, true}, tooltip)) return;
        value = percent / 100;
        changed = true;
    };
    bool on = !display.volumes.muted;
    if (desk.widgets.toggle("Sound", on, "Whether anything is heard."))
        display.volumes.muted = !on, changed = true;
    if (!facts.sound_fault.empty()) desk.widgets.dim("Silent: %s.", std::string(facts.sound_fault).c_str());
    slider("Volume", "Of all that is heard.", display.volumes.all);
    for (std::size_t i = 0; i < sound::kGroups; ++i) {
        const sound::GroupInfo& group = sound::info_of(static_cast<sound::Group>(i));
        slider(group.name, group.meaning, display.volumes.of[i]);
    }
    return changed;
}

bool pace(Desk& desk, Display& display) {
    desk.widgets.heading("Time");
    bool changed = desk.widgets.toggle(
        "Slow moments", display.slow_release,
        "Half the speed for a second when a slide breaks loose, and when it first hits a house.");
    changed |= desk.widgets.toggle("Fast creep", display.fast_creep,
                                   "Four times the speed when next to nothing moves any more.");
    return changed;
}

void camera(Desk& desk, const Facts& facts, Actions& actions) {
    desk.widgets.heading("Camera");
    if (desk.widgets.button("Overview", "Shows the whole mountain.")) actions.emplace_back(Verb::kOverview);
    ImGui::SameLine();
    if (desk.widgets.button("From above", "Switches the top view on and off.",
                            facts.camera_mode == CameraMode::kTopDown))
        actions.emplace_back(Verb::kTopDown);
    ImGui::SameLine();
    if (desk.widgets.button("Fly", "Switches fly mode on and off: keys move, the mouse looks around.",
                            facts.camera_mode == CameraMode::kFly))
        actions.emplace_back(Verb::kFly);
    if (desk.widgets.button("Follow", "Follows the front of a slide.",
                            facts.camera_mode == CameraMode::kChase))
        actions.emplace_back(Verb::kChase);
    ImGui::SameLine();
    if (desk.widgets.button("Full screen", "Switches full screen on and off."))
        actions.emplace_back(Verb::kFullscreen);
}

}  // namespace

void display_panel(Desk& desk, const Facts& facts, Actions& actions) {
    Display display = facts.display;
    bool changed = colours(desk, facts, display);
    if (facts.scenario.flow) changed |= flow(desk, display);
    changed |= picture(desk, facts, display);
    changed |= quality(desk, display);
    changed |= sun(desk, facts, display);
    camera(desk, facts, actions);
    changed |= pace(desk, display);
    changed |= sounds(desk, facts, display);
    if (changed) actions.emplace_back(SetDisplay{display});
}

}  // namespace game::ui
