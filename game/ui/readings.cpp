#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "game/ui/legend.h"
#include "game/ui/panels.h"
#include "game/ui/walls.h"
#include "game/words/names.h"
#include "game/words/plain.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kLow = 27;  // em: below this window height the text is small

// The slope class colour used by avalanche services; none below the first class.
std::optional<ImU32> class_colour(double slope_deg) {
    std::optional<ImU32> colour;
    for (const render::LegendStop& stop : render::legend_of(render::Overlay::kSlope).stops)
        if (slope_deg >= static_cast<double>(stop.value)) colour = packed(stop.colour);
    return colour;
}

void slope(Desk& desk, const Facts& facts, const Reading& reading) {
    desk.widgets.fact("Slope", "%.1f°", reading.slope_deg);
    // The colour swatch, only if the ground shows slope colours.
    const auto colour = class_colour(reading.slope_deg);
    if (!colour || facts.display.overlay != render::Overlay::kSlope) return;
    ImGui::SameLine(0, desk.em() * 0.5f);
    const float side = desk.em() * 0.75f;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + (ImGui::GetFrameHeight() - side) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x, y}, {at.x + side * 1.6f, y + side}, *colour, side * 0.25f);
    list.AddRect({at.x, y}, {at.x + side * 1.6f, y + side}, palette().line, side * 0.25f);
    ImGui::Dummy({side * 1.6f, side});
}

const char* state_of(const sim::Thing& thing) {
    if (thing.destroyed()) return "destroyed";
    if (thing.under()) return thing.damaged() ? "damaged, buried" : "buried";
    return thing.damaged() ? "damaged" : "intact";
}

// What stands there, if anything.
void things(Desk& desk, const Reading& reading) {
    Widgets& widgets = desk.widgets;
    if (reading.earth != 0) widgets.fact("Earth", "%+.2f m", reading.earth);
    const sim::Stems& forest = reading.forest;
    if (forest.standing > 0) {
        widgets.fact("Forest", "%d stems/ha", forest.standing);
        widgets.fact("Trees", "%d m high", forest.height_m);
        widgets.fact("Stems", "%.2f m thick", forest.diameter_cm / 100.0);
    }
    if (forest.lying > 0) widgets.fact("Broken", "%d stems/ha", forest.lying);
    if (!reading.thing) return;
    const sim::Thing& thing = *reading.thing;
    const std::string_view kind = sim::to_string(thing.kind);
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%c%.*s", std::toupper(static_cast<unsigned char>(kind.front())),
                  static_cast<int>(kind.size() - 1), kind.data() + 1);
    if (thing.kind != sim::ThingKind::kRoad) {
        widgets.fact(name.data(), "%s", tr(state_of(thing)));
        widgets.fact("Greatest load", "%.1f of %.0f kPa", static_cast<double>(thing.load) / 1000,
                     thing.strength);
    } else {
        widgets.fact(name.data(), "%.0f m wide", thing.width);
    }
    if (thing.buried > 0) widgets.fact("Covered by", "%.1f m", static_cast<double>(thing.buried) / 1000);
}

void rows(Desk& desk, const Facts& facts, const Reading& reading) {
    Widgets& widgets = desk.widgets;
    widgets.fact("Height", "%.1f m", reading.height);
    slope(desk, facts, reading);
    if (reading.aspect_deg)
        widgets.fact("Aspect", "%.0f° %s", *reading.aspect_deg, tr(compass_point(*reading.aspect_deg)));
    else
        widgets.fact("Aspect", "level");
    widgets.fact("Standing", "%.2f m", reading.standing);
    if (reading.water > 0 || facts.brush.tool == Tool::kWater)
        widgets.fact("Wet", "%.0f %%", 100 * reading.water);
    widgets.fact("Rolling", "%.2f m", reading.rolling);
    if (reading.rolling > 0 && !speaks_plainly()) widgets.fact("Thickness", "%.2f m", reading.thickness);
    if (reading.lower_share)
        widgets.fact("Mixture", "%.0f %% %s", 100 * *reading.lower_share,
                     tr(title_in(facts.catalogue.materials, facts.scenario.lower->material)));
    widgets.fact("Speed on slope", "%.1f m/s", reading.speed_slope);
    if (!speaks_plainly()) widgets.fact("Speed in plan", "%.1f m/s", reading.speed_plan);
    if (reading.pressure) {
        const Wall* const wall = broken_by(*reading.pressure);
        if (wall)
            widgets.fact("Pressure", "%.1f kPa, breaks %s", *reading.pressure, tr(wall->what));
        else
            widgets.fact("Pressure", "%.1f kPa", *reading.pressure);
    }
    things(desk, reading);
    if (facts.runs && facts.runs->probability)
        widgets.fact("Probability", "%.1f %%", 100 * *facts.runs->probability);
}

// Latitude and longitude on one line, UTM on the next.
void where(Desk& desk, const Reading& reading) {
    const std::string_view text(reading.where.data());
    const std::size_t comma = std::min(text.find(", "), text.size());
    desk.widgets.dim("%.*s", static_cast<int>(comma), text.data());
    if (comma < text.size()) desk.widgets.dim("%s", text.data() + comma + 2);
}

}  // namespace

void readings(Desk& desk, const Facts& facts) {
    if (!facts.under_cursor) return;
    const float width = kReadingsWidth * desk.em(), margin = desk.margin();
    // Beside the time bar if there is room, else above it.
    const float bottom = desk.beside_time_bar() ? desk.size.y : desk.lower_edge;
    ImGui::SetNextWindowPos({margin, bottom - margin}, ImGuiCond_Always, {0, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const bool low = desk.size.y < kLow * desk.em();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, low ? 0 : desk.em() * 0.05f});
    // As many rows as there is room for below the toolbar; the first ones matter most.
    const float padding = 2 * ImGui::GetStyle().WindowPadding.y, row = ImGui::GetFrameHeight();
    const float room = bottom - 2 * margin - desk.toolbar_bottom - padding;
    const float most = padding + row * std::max(std::floor(room / row), 1.f);
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, most});
    ImGui::Begin("Readings", nullptr,
                 kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    ImGui::PushFont(low ? desk.widgets.letters.small : desk.widgets.letters.usual);
    rows(desk, facts, *facts.under_cursor);
    ImGui::PopFont();
    if (facts.under_cursor->where[0] != 0) where(desk, *facts.under_cursor);
    desk.readings_height = ImGui::GetWindowSize().y;
    desk.widgets.keep_window_clear("Readings");
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace game::ui
