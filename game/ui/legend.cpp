#include "game/ui/legend.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "game/ui/style.h"

namespace game::ui {
ImU32 packed(const glm::vec3& colour) {
    return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1});
}

void draw_legend(const render::Legend& legend, float em, ImFont& letters) {
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
        std::snprintf(text.data(), text.size(),
                      i > 0                   ? "%g"
                      : legend.unit[0] == 'm' ? "%g %s"
                                              : "%g%s",
                      static_cast<double>(legend.stops[i].value), legend.unit);
        list.AddText(&letters, letters.FontSize, {x, from.y + height + em * 0.15f}, palette().dim_text,
                     text.data());
    }
    ImGui::Dummy({width, height + em * 0.15f + letters.FontSize});
}

}  // namespace game::ui
