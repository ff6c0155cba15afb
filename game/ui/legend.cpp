#include "game/ui/legend.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "game/ui/style.h"

namespace game::ui {
namespace {

constexpr std::array<LegendStop, 4> kSlope{{
    {30, {0.98f, 0.87f, 0.30f}},
    {35, {0.95f, 0.57f, 0.16f}},
    {40, {0.80f, 0.22f, 0.20f}},
    {45, {0.40f, 0.19f, 0.52f}},
}};
constexpr std::array<LegendStop, 6> kDepth{{
    {0.1f, {0.267f, 0.005f, 0.329f}},
    {0.2f, {0.254f, 0.265f, 0.530f}},
    {0.5f, {0.164f, 0.471f, 0.558f}},
    {1.0f, {0.135f, 0.659f, 0.518f}},
    {2.0f, {0.478f, 0.821f, 0.318f}},
    {5.0f, {0.993f, 0.906f, 0.144f}},
}};
constexpr std::array<LegendStop, 6> kSpeed{{
    {1, {0.050f, 0.030f, 0.528f}},
    {10, {0.417f, 0.001f, 0.658f}},
    {20, {0.693f, 0.165f, 0.565f}},
    {30, {0.881f, 0.393f, 0.383f}},
    {40, {0.988f, 0.652f, 0.211f}},
    {50, {0.940f, 0.975f, 0.131f}},
}};

}  // namespace

Legend legend_of(render::Overlay overlay) {
    switch (overlay) {
        case render::Overlay::kSlope:
            return {kSlope, "°", true};
        case render::Overlay::kStanding:
        case render::Overlay::kRolling:
            return {kDepth, "m", false};
        case render::Overlay::kSpeed:
            return {kSpeed, "m/s", false};
        case render::Overlay::kNone:
            break;
    }
    return {{}, "", false};
}

ImU32 packed(const glm::vec3& colour) {
    return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1});
}

void draw_legend(const Legend& legend, float em, ImFont& letters) {
    const std::size_t count = legend.stops.size();
    if (count == 0) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = em * 0.8f;
    const float part = width / static_cast<float>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float x = from.x + part * static_cast<float>(i);
        const bool mixed = !legend.stepped && i + 1 < count;
        const ImU32 left = packed(legend.stops[i].colour);
        const ImU32 right = mixed ? packed(legend.stops[i + 1].colour) : left;
        list.AddRectFilledMultiColor({x, from.y}, {x + part, from.y + height}, left, right, right, left);
        std::array<char, 24> text;
        std::snprintf(text.data(), text.size(), i == 0 ? "%g %s" : "%g",
                      static_cast<double>(legend.stops[i].value), legend.unit);
        list.AddText(&letters, letters.FontSize, {x, from.y + height + em * 0.15f}, kDimText, text.data());
    }
    ImGui::Dummy({width, height + em * 0.15f + letters.FontSize});
}

}  // namespace game::ui
