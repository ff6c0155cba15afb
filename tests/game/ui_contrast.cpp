// Texts on panels are readable, by the contrast ratio of WCAG 2.2 (https://www.w3.org/TR/WCAG22/#dfn-contrast-ratio).
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "game/ui/style.h"
#include "tests/game/ui_hand.h"

namespace game::test {
namespace {

double channel(ImU32 colour, int shift) {
    return static_cast<double>(colour >> shift & 0xff);
}

// Relative luminance of a colour over another one, 0 to 1.
double luminance(ImU32 colour, ImU32 under) {
    const double alpha = channel(colour, IM_COL32_A_SHIFT) / 255;
    const auto linear = [&](int shift) {
        const double value = (alpha * channel(colour, shift) + (1 - alpha) * channel(under, shift)) / 255;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(IM_COL32_R_SHIFT) + 0.7152 * linear(IM_COL32_G_SHIFT) +
           0.0722 * linear(IM_COL32_B_SHIFT);
}

// The least of a text on a panel, whatever is behind that: 1 to 21.
double contrast(ImU32 text, ImU32 panel) {
    double least = 21;
    for (const ImU32 behind : {IM_COL32_WHITE, IM_COL32_BLACK}) {
        const double of_text = luminance(text, behind), of_panel = luminance(panel, behind);
        least = std::min(least, (std::max(of_text, of_panel) + 0.05) / (std::min(of_text, of_panel) + 0.05));
    }
    return least;
}

TEST(Contrast, is_enough_for_small_texts_and_high_if_wanted) {
    constexpr double kEnough = 4.5, kHigh = 7;  // AA and AAA of WCAG
    const auto least = [](const ui::Palette& of) {
        double ratio = 21;
        for (const ImU32 panel : {of.panel, of.notice_plate})
            for (const ImU32 text : {of.text, of.dim_text, ui::kAccent, ui::kWarning})
                ratio = std::min(ratio, contrast(text, panel));
        return ratio;
    };
    EXPECT_GE(least(ui::kUsualPalette), kEnough);
    EXPECT_GE(least(ui::kHighContrastPalette), kHigh);
    EXPECT_GE(contrast(ui::kHighContrastPalette.dim_text, ui::kHighContrastPalette.panel), 2 * kHigh);
}

class UiContrast : public UiHand {};

TEST_F(UiContrast, changes_with_the_setting_and_stays_with_another_text_size) {
    const auto is_high = [] {
        return ImGui::GetColorU32(ImGuiCol_WindowBg) == ui::kHighContrastPalette.panel;
    };
    EXPECT_FALSE(is_high());
    display_.contrast = true;
    settle();
    EXPECT_TRUE(is_high());
    display_.letters = 2;
    settle();
    EXPECT_TRUE(is_high());
    display_.contrast = false;
    settle();
    EXPECT_FALSE(is_high());
}

}  // namespace
}  // namespace game::test
