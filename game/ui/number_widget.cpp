#include <array>
#include <cstdio>

#include "game/base/number.h"
#include "game/ui/widgets.h"
#include "game/words/words.h"

// The widget for a typed number.

namespace game::ui {
namespace {

// Parses a number with a decimal point or comma, ignoring spaces; nothing if `text` is not a number.
std::optional<double> number_from(std::string_view text) {
    std::array<char, 32> plain{};
    std::size_t length = 0;
    for (const char c : text)
        if (c != ' ' && length < plain.size()) plain[length++] = c == ',' ? '.' : c;
    const std::size_t sign = length > 0 && plain[0] == '+' ? 1 : 0;
    return game::number_from<double>({plain.data() + sign, length - sign});
}

}  // namespace

Typed Widgets::typed(std::string_view was) {
    const std::string_view text(typed_.data());
    const auto value = number_from(text);
    if (!value) return {Typed::What::kNonsense, 0};
    if (text == was || value == number_from(was)) return {};
    return {Typed::What::kValue, *value};
}

bool Widgets::usual_mark(const Number& number) {
    std::array<char, 64> label, text;
    std::snprintf(label.data(), label.size(), "%s: default", number.label);
    std::snprintf(text.data(), text.size(), tr("Resets to the default, %.4g %s."), number.usual, number.unit);
    const float side = ImGui::GetFrameHeight();
    const bool pressed = ImGui::InvisibleButton("##usual", {side, side});
    const ImVec2 from = ImGui::GetItemRectMin();
    draw_icon(*ImGui::GetWindowDrawList(), Icon::kUndo, {from.x + side / 2, from.y + side / 2}, em * 0.75f,
              ImGui::IsItemHovered() ? palette().text : kAccent);
    places_.note(label.data());
    tooltip(text.data());
    return pressed;
}

Typed Widgets::number(const Number& number) {
    std::array<char, 32> shown{};
    std::snprintf(shown.data(), shown.size(), "%.4g", number.value);
    ImGui::PushID(number.label);
    row(number.label);
    const ImGuiID id = ImGui::GetID("##number");
    std::array<char, 32>& text = changing_ == id ? typed_ : shown;
    const std::array<char, 32> was = shown;
    Typed result;
    ImGui::BeginDisabled(!number.editable);
    ImGui::SetNextItemWidth(em * 5.5f);
    ImGui::InputText("##number", text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
    ImGui::EndDisabled();
    places_.note(number.label);
    if (ImGui::IsItemActive()) {
        if (changing_ != id) typed_ = shown;
        changing_ = id;
    } else if (changing_ == id) {
        changing_ = 0;
        if (ImGui::IsItemDeactivatedAfterEdit()) result = typed(was.data());
    }
    tooltip(number.tooltip);
    ImGui::SameLine(0, em * 0.4f);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    ImGui::TextUnformatted(number.unit);
    ImGui::PopStyleColor();
    if (number.editable && number.value != number.usual) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
        if (usual_mark(number)) result = {Typed::What::kUsual, number.usual};
    }
    ImGui::PopID();
    return result;
}

}  // namespace game::ui
