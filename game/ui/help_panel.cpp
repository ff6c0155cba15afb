#include <algorithm>
#include <array>
#include <string>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"

namespace game::ui {
namespace {

constexpr float kTwoColumns = 48;    // em: narrower panels have one column
constexpr float kCapHeight = 1.2f;  // em

// Rows of key caps with the same effect, followed by the effect.
class Table {
  public:
    Table(Desk& desk, float label_width) : desk_(desk), label_width_(label_width) {}

    void begin() { from_ = ImGui::GetCursorScreenPos(); }

    void cap(const char* name) {
        const float em = desk_.em(), small = desk_.widgets.letters.small->FontSize;
        const ImVec2 text = desk_.widgets.letters.small->CalcTextSizeA(small, 1e6f, 0, name);
        const ImVec2 at = ImGui::GetCursorScreenPos(), size{text.x + em * 0.7f, em * kCapHeight};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, kControl, em * 0.25f);
        list.AddRect(at, {at.x + size.x, at.y + size.y}, kLine, em * 0.25f);
        list.AddText(desk_.widgets.letters.small, small, {at.x + em * 0.35f, at.y + (size.y - small) / 2},
                     kText, name);
        ImGui::Dummy(size);
        ImGui::SameLine(0, em * 0.3f);
    }

    void meaning(std::string_view text) {
        // Vertically centred on the caps.
        const float lower = (desk_.em() * kCapHeight - ImGui::GetTextLineHeight()) / 2;
        ImGui::SetCursorScreenPos({from_.x + label_width_, from_.y + lower});
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
        ImGui::PopTextWrapPos();
        desk_.widgets.note(text);
    }

  private:
    Desk& desk_;
    float label_width_;
    ImVec2 from_;  // of the row
};

void hands(Desk& desk, Table& table) {
    desk.widgets.heading("Mouse, over the terrain");
    for (const GestureBinding& binding : gesture_bindings()) {
        table.begin();
        table.cap(binding.hand.data());  // a literal
        table.meaning(binding.meaning);
    }
    desk.widgets.heading("Held keys");
    const auto held = held_bindings();
    for (std::size_t i = 0; i < held.size(); ++i) {
        table.begin();
        table.cap(name_of(held[i].key).c_str());
        while (i + 1 < held.size() && held[i + 1].held == held[i].held)
            table.cap(name_of(held[++i].key).c_str());
        table.meaning(held[i].meaning);
    }
}

bool is_of_brush(Verb verb) {
    return verb >= Verb::kPour && verb <= Verb::kPourStandingOrRolling;
}

void keys(Desk& desk, Table& table, const char* heading, bool of_brush) {
    desk.widgets.heading(heading);
    for (const KeyBinding& binding : key_bindings()) {
        if (is_of_brush(binding.verb) != of_brush) continue;
        table.begin();
        table.cap(name_of(binding.key, binding.with).c_str());
        table.meaning(binding.meaning);
    }
}

}  // namespace

void help_panel(Desk& desk) {
    const float em = desk.em(), width = ImGui::GetContentRegionAvail().x;
    Table table(desk, 9 * em);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {em * 0.3f, em * 0.05f});
    const bool two = width >= kTwoColumns * em;
    if (two) ImGui::Columns(2, "help", false);
    hands(desk, table);
    keys(desk, table, "Brush keys", true);
    if (two) ImGui::NextColumn();
    keys(desk, table, "Keys", false);
    if (two) ImGui::Columns(1);
    ImGui::PopStyleVar();
}

}  // namespace game::ui
