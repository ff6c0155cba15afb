#include <algorithm>
#include <array>
#include <cmath>

#include "game/ui/legend.h"
#include "game/ui/panels.h"

namespace game::ui {
namespace {

struct OverlayName {
    render::Overlay overlay;
    const char* name;
};
constexpr std::array<OverlayName, 6> kOverlays{{
    {render::Overlay::kNone, "what it is made of"},
    {render::Overlay::kSlope, "steepness"},
    {render::Overlay::kStanding, "standing depth"},
    {render::Overlay::kRolling, "rolling depth"},
    {render::Overlay::kSpeed, "speed"},
    {render::Overlay::kStretch, "stretch of what it carries"},
}};

bool colours(Desk& desk, Display& display) {
    int chosen = 0;
    for (std::size_t i = 0; i < kOverlays.size(); ++i)
        if (kOverlays[i].overlay == display.overlay) chosen = static_cast<int>(i);
    desk.widgets.row("Ground shows");
    bool changed = desk.widgets.choice("Ground shows", chosen, static_cast<int>(kOverlays.size()),
                                       "What the colours of the ground tell.",
                                       [](int i) { return kOverlays[static_cast<std::size_t>(i)].name; });
    if (changed) display.overlay = kOverlays[static_cast<std::size_t>(chosen)].overlay;
    draw_legend(render::legend_of(display.overlay), desk.em(), *desk.widgets.letters.small);
    changed |= desk.widgets.toggle("Contours", display.contours, "Lines of equal height.");
    changed |=
        desk.widgets.toggle("Fronts", display.flow_mesh,
                            "The mesh that textures are drawn on, cut along the fronts, and its points.");
    return changed;
}

bool sun(Desk& desk, const Facts& facts, Display& display) {
    desk.widgets.heading("Sun");
    desk.widgets.row("Direction");
    bool changed = desk.widgets.slider("Direction", display.light.azimuth_deg, {0, 360, "%.0f°"},
                                       "Where the sun stands: 0 is north, 90 east.");
    desk.widgets.row("Height above horizon");
    changed |= desk.widgets.slider("Height above horizon", display.light.elevation_deg, {1, 90, "%.0f°"},
                                   "How high the sun stands; low sun shows the shape of the ground.");
    if (desk.widgets.button("Sun as the scene says", "Puts the sun back where the scene has it.")) {
        display.light = facts.scenario.light;
        changed = true;
    }
    return changed;
}

constexpr std::array<const char*, 4> kWays{"no cuts", "half an edge", "the paper's points", "fitted points"};

// What is changed while it runs, of a scene that shows a flow.
bool flow(Desk& desk, Display& display) {
    sim::fields::FlowNumbers& numbers = display.flow;
    desk.widgets.heading("Flow");
    desk.widgets.row("Flow speed");
    bool changed = desk.widgets.slider("Flow speed", numbers.speed, {0, 1, "%.2f sides/s"},
                                       "How fast the ground flows on either side, in sides of the square.");
    desk.widgets.row("Front speed");
    changed |= desk.widgets.slider("Front speed", numbers.front_speed, {-4, 4, "%.1f ×"},
                                   "How fast the front goes: 0 stops it, below 0 it goes back.");
    desk.widgets.row("Smooth field");
    changed |= desk.widgets.slider("Smooth field", numbers.smooth, {0, 0.1, "%.3f sides/s"},
                                   "A field without fronts on top, as any flow has one.");
    int way = numbers.cut ? 1 + static_cast<int>(numbers.source) : 0;
    desk.widgets.row("Textures with");
    if (desk.widgets.choice("Textures with", way, static_cast<int>(kWays.size()),
                            "Whether textures are cut along fronts, and what tells where these lie.",
                            [](int i) { return kWays[static_cast<std::size_t>(i)]; })) {
        numbers.cut = way > 0;
        if (way > 0) numbers.source = static_cast<sim::front::PointSource>(way - 1);
        changed = true;
    }
    return changed;
}

constexpr double kStep = 5;  // percent, to which a hand's slide is rounded

double in_steps(double percent) {
    return kStep * std::round(percent / kStep);
}

// The largest letters, in percent, with which a panel still has its place beside the bars.
double most_letters(const Desk& desk, double letters) {
    constexpr double kWide = 42, kHigh = 27;  // em
    const double em = static_cast<double>(desk.em()) / letters;
    const double fits =
        std::min(static_cast<double>(desk.size.x) / kWide, static_cast<double>(desk.size.y) / kHigh);
    return std::clamp(kStep * std::floor(100 * fits / em / kStep), 100., 300.);
}

bool picture(Desk& desk, Display& display) {
    desk.widgets.heading("Picture");
    bool changed = false;
    double detail = static_cast<double>(display.detail) * 100, resolution = display.resolution * 100,
           letters = display.letters * 100;
    desk.widgets.row("Fine relief");
    if (desk.widgets.slider("Fine relief", detail, {0, 100, "%.0f %%"},
                            "Strength of the small relief that is drawn onto ground and material.")) {
        display.detail = static_cast<float>(detail / 100);
        changed = true;
    }
    desk.widgets.row("Resolution");
    if (desk.widgets.slider("Resolution", resolution, {25, 100, "%.0f %%", false, true},
                            "Pixels drawn along an edge for each of the screen's; fewer are faster.")) {
        display.resolution = in_steps(resolution) / 100;
        changed = true;
    }
    changed |= desk.widgets.toggle("Smooth edges", display.fine, "Four samples per pixel: finer and slower.");
    desk.widgets.row("Letters");
    if (desk.widgets.slider("Letters", letters,
                            {50, most_letters(desk, display.letters), "%.0f %%", false, true},
                            "Size of letters and panels.")) {
        display.letters = in_steps(letters) / 100;
        changed = true;
    }
    return changed;
}

void camera(Desk& desk, const Facts& facts, Actions& actions) {
    desk.widgets.heading("Camera");
    if (desk.widgets.button("Overview", "Shows the whole mountain.")) actions.emplace_back(Verb::kOverview);
    ImGui::SameLine();
    if (desk.widgets.button("From above", "Looks straight down, and back.",
                            facts.camera_mode == CameraMode::kTopDown))
        actions.emplace_back(Verb::kTopDown);
    ImGui::SameLine();
    if (desk.widgets.button("Fly", "Moves with the keys and looks round with the mouse, and back.",
                            facts.camera_mode == CameraMode::kFly))
        actions.emplace_back(Verb::kFly);
    ImGui::SameLine();
    if (desk.widgets.button("Full screen", "Fills the monitor, and back."))
        actions.emplace_back(Verb::kFullscreen);
}

}  // namespace

void display_panel(Desk& desk, const Facts& facts, Actions& actions) {
    Display display = facts.display;
    bool changed = colours(desk, display);
    if (facts.scenario.flow) changed |= flow(desk, display);
    changed |= sun(desk, facts, display);
    changed |= picture(desk, display);
    if (changed) actions.emplace_back(SetDisplay{display});
    camera(desk, facts, actions);
}

}  // namespace game::ui
