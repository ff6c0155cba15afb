#include "game/ui/style.h"

#include <algorithm>
#include <cmath>

namespace game::ui {
namespace {

constexpr float kSmall = 0.8125f, kTitle = 5;  // relative to the usual text size

// Latin-1, plus other characters used in titles, units and place names. Ranges in pairs, ending with 0.
constexpr ImWchar kGlyphs[] = {0x0020, 0x00ff, 0x0100, 0x017f, 0x2010, 0x2027, 0x2032,
                               0x2033, 0x20ac, 0x20ac, 0x215b, 0x215e, 0x2190, 0x21ff,
                               0x2212, 0x2212, 0x2248, 0x2248, 0x2264, 0x2265, 0};

constexpr ImWchar kTitleGlyphs[] = {'A', 'Z', 'a', 'z', 0};

ImFont* own_letters(ImFontAtlas& atlas, float height) {
    ImFontConfig config;
    config.SizePixels = height;
    return atlas.AddFontDefault(&config);
}

ImFont* letters_of(ImFontAtlas& atlas, const std::optional<std::filesystem::path>& font, float height,
                   const ImWchar* glyphs = kGlyphs) {
    std::error_code error;
    if (!font || !std::filesystem::is_regular_file(*font, error)) return own_letters(atlas, height);
    ImFontConfig config;
    config.OversampleH = height < 24 ? 2 : 1;
    ImFont* letters = atlas.AddFontFromFileTTF(font->c_str(), height, &config, glyphs);
    return letters ? letters : own_letters(atlas, height);
}

ImVec4 colour(ImU32 packed) {
    return ImGui::ColorConvertU32ToFloat4(packed);
}

void set_colours(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    auto& colours = style.Colors;
    colours[ImGuiCol_Text] = colour(palette().text);
    colours[ImGuiCol_TextDisabled] = colour(palette().dim_text);
    colours[ImGuiCol_WindowBg] = colour(palette().panel);
    colours[ImGuiCol_PopupBg] = colour(IM_COL32(24, 30, 38, 250));
    colours[ImGuiCol_ChildBg] = colours[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
    colours[ImGuiCol_Border] = colour(palette().border);
    colours[ImGuiCol_Separator] = colour(palette().line);
    colours[ImGuiCol_FrameBg] = colours[ImGuiCol_Button] = colour(palette().control);
    colours[ImGuiCol_FrameBgHovered] = colours[ImGuiCol_ButtonHovered] = colour(palette().control_hovered);
    colours[ImGuiCol_FrameBgActive] = colours[ImGuiCol_ButtonActive] = colour(palette().control_held);
    colours[ImGuiCol_Header] = colour(faded(kAccent, 0.35f));
    colours[ImGuiCol_HeaderHovered] = colour(faded(kAccent, 0.5f));
    colours[ImGuiCol_HeaderActive] = colour(faded(kAccent, 0.6f));
    colours[ImGuiCol_CheckMark] = colour(kAccent);
    // Invisible grabs: a slider's fill ends at its value, and a grab would cover the text.
    colours[ImGuiCol_SliderGrab] = colours[ImGuiCol_SliderGrabActive] = {0, 0, 0, 0};
    colours[ImGuiCol_TextSelectedBg] = colour(faded(kAccent, 0.45f));
    colours[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
    colours[ImGuiCol_ScrollbarGrab] = colour(palette().control_hovered);
    colours[ImGuiCol_ScrollbarGrabHovered] = colour(palette().control_held);
    colours[ImGuiCol_ScrollbarGrabActive] = colour(faded(kAccent, 0.75f));
}

void set_measures(ImGuiStyle& style, float em) {
    const auto px = [em](float of_em) { return std::round(of_em * em); };
    style.WindowPadding = {px(0.75f), px(0.75f)};
    style.FramePadding = {px(0.55f), px(0.3f)};
    style.ItemSpacing = {px(0.5f), px(0.4f)};
    style.ItemInnerSpacing = {px(0.4f), px(0.3f)};
    style.WindowRounding = style.PopupRounding = px(0.5f);
    style.FrameRounding = style.GrabRounding = px(0.3f);
    style.GrabMinSize = px(0.2f);
    style.ScrollbarSize = px(0.6f);
    style.ScrollbarRounding = px(0.3f);
    style.WindowBorderSize = style.PopupBorderSize = std::max(1.f, std::floor(em / 16));
    style.FrameBorderSize = 0;
    style.WindowMinSize = {px(2), px(2)};
    style.DisabledAlpha = 0.4f;
}

}  // namespace

const Palette& palette() {
    return *static_cast<const Palette*>(ImGui::GetIO().UserData);
}

void set_contrast(bool high) {
    const Palette* const wanted = high ? &kHighContrastPalette : &kUsualPalette;
    void*& chosen = ImGui::GetIO().UserData;
    if (chosen == wanted) return;
    chosen = const_cast<Palette*>(wanted);  // ImGui keeps it as void*; palette() alone reads it
    set_colours(ImGui::GetStyle());
}

Letters set_letters(const std::optional<std::filesystem::path>& font, float em) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    Letters letters;
    letters.usual = letters_of(*io.Fonts, font, em);
    letters.small = letters_of(*io.Fonts, font, std::round(em * kSmall));
    letters.title = letters_of(*io.Fonts, font, std::round(em * kTitle), kTitleGlyphs);
    io.Fonts->Build();
    io.FontDefault = letters.usual;
    if (!io.UserData) set_contrast(false);
    set_measures(ImGui::GetStyle(), em);
    return letters;
}

}  // namespace game::ui
