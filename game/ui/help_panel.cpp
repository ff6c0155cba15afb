#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kTwoColumns = 48, kThreeColumns = 70;  // em: narrower panels have fewer
constexpr float kCapHeight = 1.08f;                    // em

// Rows of key caps with the same effect, followed by the effect.
class Table {
  public:
    Table(Desk& desk, float label_width) : desk_(desk), label_width_(label_width) {}

    void begin() { from_ = ImGui::GetCursorScreenPos(); }

    void cap(const char* name) {
        const float em = desk_.em(), small = desk_.widgets.letters.small->FontSize;
        const ImVec2 text = desk_.widgets.letters.small->CalcTextSizeA(small, 1e6f, 0, tr(name));
        const ImVec2 at = ImGui::GetCursorScreenPos(), size{text.x + em * 0.7f, em * kCapHeight};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, palette().control, em * 0.25f);
        list.AddRect(at, {at.x + size.x, at.y + size.y}, palette().line, em * 0.25f);
        list.AddText(desk_.widgets.letters.small, small, {at.x + em * 0.35f, at.y + (size.y - small) / 2},
                     palette().text, tr(name));
        ImGui::Dummy(size);
        std::array<char, 32> label;
        std::snprintf(label.data(), label.size(), "key %s", name);
        desk_.widgets.note(label.data());
        ImGui::SameLine(0, em * 0.3f);
    }

    void meaning(std::string_view text) {
        // Vertically centred on the caps.
        ImGui::PushFont(desk_.widgets.letters.small);
        const float lower = (desk_.em() * kCapHeight - ImGui::GetTextLineHeight()) / 2;
        ImGui::SetCursorScreenPos({from_.x + label_width_, from_.y + lower});
        ImGui::PushTextWrapPos(0);
        const std::string_view words = tr(text);
        ImGui::TextUnformatted(words.data(), words.data() + words.size());
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
        desk_.widgets.note(text);
    }

  private:
    Desk& desk_;
    float label_width_;
    ImVec2 from_;  // of the row
};

void mouse(Desk& desk, Table& table) {
    desk.widgets.heading("Mouse, over the terrain");
    for (const GestureBinding& binding : gesture_bindings()) {
        table.begin();
        table.cap(binding.hand.data());  // a literal
        table.meaning(binding.meaning);
    }
}

void held_keys(Desk& desk, Table& table, const Keys& keys) {
    desk.widgets.heading("Held keys");
    const auto held = keys.map.holds();
    const auto cap = [&](Key key) {
        if (key != Key::kNone) table.cap(name_of(keys.layout, key).c_str());
    };
    for (std::size_t i = 0; i < held.size(); ++i) {
        table.begin();
        cap(held[i].key);
        while (i + 1 < held.size() && held[i + 1].held == held[i].held) cap(held[++i].key);
        table.meaning(held[i].meaning);
    }
}

enum class Section { kTools, kView, kRest };

Section section_of(const KeyBinding& binding) {
    const Verb* verb = std::get_if<Verb>(&binding.does);
    if (!verb || (*verb >= Verb::kSmallerBrush && *verb <= Verb::kPourStandingOrRolling))
        return Section::kTools;
    return *verb >= Verb::kOverview && *verb <= Verb::kTogglePanels ? Section::kView : Section::kRest;
}

void pressed_keys(Desk& desk, Table& table, const Keys& keys, const char* heading, Section section) {
    desk.widgets.heading(heading);
    for (const KeyBinding& binding : keys.map.presses()) {
        if (section_of(binding) != section) continue;
        table.begin();
        if (binding.key != Key::kNone) table.cap(name_of(keys.layout, binding.key, binding.with).c_str());
        table.meaning(binding.meaning);
    }
}

}  // namespace

void help_panel(Desk& desk, const Keys& keys) {
    const float em = desk.em(), width = ImGui::GetContentRegionAvail().x;
    Table table(desk, 8.4f * em);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {em * 0.3f, 0});
    const int columns = width >= kThreeColumns * em ? 3 : width >= kTwoColumns * em ? 2 : 1;
    if (columns > 1) ImGui::Columns(columns, "help", false);
    mouse(desk, table);
    pressed_keys(desk, table, keys, "Tools", Section::kTools);
    if (columns > 1) ImGui::NextColumn();
    pressed_keys(desk, table, keys, "View and panels", Section::kView);
    held_keys(desk, table, keys);
    if (columns > 2) ImGui::NextColumn();
    pressed_keys(desk, table, keys, "Time and program", Section::kRest);
    if (columns > 1) ImGui::Columns(1);
    ImGui::PopStyleVar();
}

}  // namespace game::ui
