// The page on which a person changes what keys do.

#include "game/ui/key_choice.h"

#include <array>
#include <cstdio>
#include <string>

#include "game/ui/menu_pages.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kCapWidth = 7.5f, kTwoColumnsOfKeys = 50;  // em

std::string label_of(const Keys& keys, Chord chord) {
    return chord.key == Key::kNone ? tr("no key") : name_of(keys.layout, chord.key, chord.with);
}

void bind(Actions& actions, std::size_t row, Chord chord) {
    actions.emplace_back(BindKey{row, chord.key, chord.with});
}

// Takes the key that was pressed, unless another action has it.
void take_pressed(KeyChoice& choice, const KeyMap& map, Actions& actions) {
    if (!choice.row || !choice.got || map.conflict(*choice.row, *choice.got)) return;
    if (map.accepts(*choice.row, *choice.got)) bind(actions, *choice.row, *choice.got);
    choice.end();
}

// The line above the rows: what a person decides if the key has another action, else what to do. The other action gets the
// key that this one had, or nothing changes.
void head(Desk& desk, const Facts& facts, Actions& actions) {
    KeyChoice& choice = desk.key_choice;
    const KeyMap& map = facts.keys.map;
    const auto other = choice.row && choice.got ? map.conflict(*choice.row, *choice.got) : std::nullopt;
    if (!other) {
        ImGui::BeginDisabled(map == KeyMap::usual());
        if (desk.widgets.button("All usual keys", "Gives every action its usual key again.")) {
            choice.end();
            actions.emplace_back(ResetKeys{});
        }
        ImGui::EndDisabled();
        ImGui::SameLine();
        if (desk.widgets.button("Gamepad", "Shows what the buttons of a gamepad do."))
            desk.menu.show(Menu::Page::kPad);
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(tr("Click a key, then press the one that it shall be."));
        return;
    }
    const Chord before = map.at(*choice.row);
    const bool may_swap = map.may_change(*other) && map.accepts(*choice.row, *choice.got);
    ImGui::BeginDisabled(!may_swap);
    if (desk.widgets.button("Swap",
                            may_swap ? "Gives that action the key that this one had."
                                     : "Escape always leads out, so it keeps its key.",
                            true)) {
        bind(actions, *choice.row, *choice.got);
        if (map.accepts(*other, before)) bind(actions, *other, before);
        choice.end();
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (desk.widgets.button("Leave it", "Changes nothing.")) choice.end();
    if (!choice.got) return;
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    ImGui::AlignTextToFramePadding();
    const std::string_view meaning = tr(map.meaning(*other));
    ImGui::Text(tr("%s is taken: %.*s"), label_of(facts.keys, *choice.got).c_str(),
                static_cast<int>(meaning.size()), meaning.data());
    ImGui::PopStyleColor();
    desk.widgets.note("Conflict");
}

void row(Desk& desk, std::size_t at, const Facts& facts, Actions& actions) {
    KeyChoice& choice = desk.key_choice;
    const KeyMap& map = facts.keys.map;
    const bool asks = choice.row == at && choice.asks, differs = map.at(at) != KeyMap::usual().at(at);
    const std::string label = asks ? "press a key" : label_of(facts.keys, map.at(at));
    ImGui::PushID(static_cast<int>(at));
    ImGui::BeginDisabled(!map.may_change(at));
    const float from = ImGui::GetCursorPosX();
    if (desk.widgets.button(label.c_str(), nullptr, asks, kCapWidth * desk.em()))
        asks ? choice.end() : choice.ask(at);
    ImGui::EndDisabled();
    std::array<char, 48> note;
    std::snprintf(note.data(), note.size(), "key of %.*s", static_cast<int>(map.name(at).size()),
                  map.name(at).data());
    desk.widgets.note(note.data());
    if (differs) {
        ImGui::SameLine();
        if (desk.widgets.icon_button("Usual key", Icon::kReset, "Gives it its usual key again.")) {
            choice.end();
            bind(actions, at, KeyMap::usual().at(at));
        }
    }
    ImGui::SameLine();
    ImGui::SetCursorPosX(from + (kCapWidth + 2.4f) * desk.em());
    ImGui::AlignTextToFramePadding();
    const std::string_view meaning = tr(map.meaning(at));
    const bool lost = map.at(at).key == Key::kNone;
    ImGui::PushStyleColor(ImGuiCol_Text, lost ? kWarning : palette().text);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(meaning.data(), meaning.data() + meaning.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopID();
}

}  // namespace

void KeyChoice::hear(std::span<const Event> events) {
    asked = asks;
    if (!asks) return;
    for (const Event& event : events) {
        const auto* const pressed = std::get_if<KeyEvent>(&event);
        if (!pressed || !pressed->down || pressed->repeat) continue;
        if (pressed->key == Key::kShift || pressed->key == Key::kControl || pressed->key == Key::kAlt)
            continue;
        if (pressed->key == Key::kEscape) return end();
        got = Chord{pressed->key, pressed->with};
        asks = false;
        return;
    }
}

void keys_page(Desk& desk, const Facts& facts, Actions& actions) {
    const KeyMap& map = facts.keys.map;
    take_pressed(desk.key_choice, map, actions);
    head(desk, facts, actions);
    ImGui::BeginChild("Rows of keys");
    const int columns = ImGui::GetContentRegionAvail().x >= kTwoColumnsOfKeys * desk.em() ? 2 : 1;
    if (columns > 1) ImGui::Columns(columns, "keys", false);
    const std::size_t half = (map.size() + 1) / 2;
    for (std::size_t at = 0; at < map.size(); ++at) {
        if (columns > 1 && at == half) ImGui::NextColumn();
        row(desk, at, facts, actions);
    }
    if (columns > 1) ImGui::Columns(1);
    ImGui::EndChild();
}

}  // namespace game::ui
