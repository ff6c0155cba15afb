#pragma once

#include <filesystem>
#include <optional>

#include <imgui.h>

namespace game::ui {

// Colours, sizes and fonts shared by all panels. Sizes are in em, the height of the usual font, so that
// panels scale with it.

// Colours that depend on the contrast, sRGB.
struct Palette {
    ImU32 text, dim_text;
    ImU32 panel, notice_plate, border, line;
    ImU32 control, control_hovered, control_held;
};
inline constexpr Palette kUsualPalette{
    .text = IM_COL32(233, 238, 243, 255),
    .dim_text = IM_COL32(159, 171, 184, 255),
    .panel = IM_COL32(17, 21, 27, 226),
    .notice_plate = IM_COL32(17, 21, 27, 250),
    .border = IM_COL32(255, 255, 255, 22),
    .line = IM_COL32(255, 255, 255, 28),
    .control = IM_COL32(255, 255, 255, 20),
    .control_hovered = IM_COL32(255, 255, 255, 40),
    .control_held = IM_COL32(255, 255, 255, 60),
};
// For projectors and bright rooms.
inline constexpr Palette kHighContrastPalette{
    .text = IM_COL32(255, 255, 255, 255),
    .dim_text = IM_COL32(226, 232, 238, 255),
    .panel = IM_COL32(0, 0, 0, 255),
    .notice_plate = IM_COL32(0, 0, 0, 255),
    .border = IM_COL32(255, 255, 255, 150),
    .line = IM_COL32(255, 255, 255, 110),
    .control = IM_COL32(255, 255, 255, 48),
    .control_hovered = IM_COL32(255, 255, 255, 80),
    .control_held = IM_COL32(255, 255, 255, 110),
};
// That of the current ImGui context, which set_letters() and set_contrast() give it.
const Palette& palette();
void set_contrast(bool high);

// The others. One accent colour; amber only for warnings.
inline constexpr ImU32 kAccent = IM_COL32(88, 184, 240, 255);
inline constexpr ImU32 kAccentText = IM_COL32(8, 22, 32, 255);  // on the accent
inline constexpr ImU32 kWarning = IM_COL32(250, 184, 76, 255);
inline constexpr ImU32 kDanger = IM_COL32(240, 84, 64, 255);

// Of a medal, 0 none to 3 gold.
constexpr ImU32 medal_colour(int medal) {
    constexpr ImU32 kColours[]{IM_COL32(255, 255, 255, 60), IM_COL32(205, 127, 70, 255),
                               IM_COL32(200, 208, 216, 255), IM_COL32(250, 200, 60, 255)};
    return kColours[medal];
}

constexpr ImU32 faded(ImU32 colour, float strength) {
    const auto alpha = static_cast<float>(colour >> IM_COL32_A_SHIFT) * strength;
    return (colour & ~IM_COL32_A_MASK) | (static_cast<ImU32>(alpha) << IM_COL32_A_SHIFT);
}

struct Letters {
    ImFont* usual = nullptr;
    ImFont* small = nullptr;
    ImFont* title = nullptr;  // has only the letters of the title
};

// Rebuilds the font atlas of the current context with text `em` px high, and scales all sizes with it.
// `font`: a TrueType file. If there is none or it cannot be read, uses ImGui's own font, which has only
// Latin-1.
Letters set_letters(const std::optional<std::filesystem::path>& font, float em);

}  // namespace game::ui
