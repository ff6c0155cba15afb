// The menu over the window: how to begin, and what there is to begin with. Time stands still behind it.

#include "game/ui/menu.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "game/analysis/score.h"
#include "game/controls/key_map.h"
#include "game/ui/menu_pages.h"
#include "game/ui/panels.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kMenuColumn = 17, kMenuTop = 5.6f,
                kNarrowMenu = 60;     // em: of the buttons; of the title; without a column
constexpr float kSettingsWidth = 30;  // em

struct Item {
    Menu::Page page;
    const char* label;
};
constexpr std::array kItems{
    Item{Menu::Page::kChallenges, "Challenges"}, Item{Menu::Page::kFreePlay, "Free play"},
    Item{Menu::Page::kHill, "My hill"},          Item{Menu::Page::kWatch, "Watch"},
    Item{Menu::Page::kSettings, "Settings"},     Item{Menu::Page::kKeys, "Keys"},
};
// Dark under the words, and clear beside them.
void shade(Desk& desk, float column) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    constexpr ImU32 kDark = IM_COL32(9, 14, 22, 255);
    constexpr int kSteps = 16;
    const float end = std::min(column * 2.4f, desk.size.x), step = end / kSteps;
    const auto strength = [](int at) {  // eases out, so that no edge is seen
        const float left = 1 - static_cast<float>(at) / kSteps;
        return 0.93f * left * left * (3 - 2 * left);
    };
    for (int i = 0; i < kSteps; ++i) {
        const ImU32 from = faded(kDark, strength(i)), to = faded(kDark, strength(i + 1));
        list.AddRectFilledMultiColor({step * static_cast<float>(i), 0},
                                     {step * static_cast<float>(i + 1), desk.size.y}, from, to, to, from);
    }
}

// Of the cards; they are read when the menu is first seen.
void ask_for_pictures(Desk& desk, const Catalogue& catalogue) {
    const auto &scenes = catalogue.scenes, &lessons = catalogue.lessons;
    std::vector<ScenePictures::Source> sources;
    sources.reserve(scenes.size() + lessons.size());
    for (const Catalogue::Entry& scene : scenes) {
        std::filesystem::path file = scene.file;
        sources.push_back({scene.name, file.replace_extension(".jpg")});
    }
    for (const Catalogue::Entry& lesson : lessons) {
        std::filesystem::path file = lesson.file;
        sources.push_back({lesson.file.native(), file.replace_extension(".jpg")});
    }
    desk.pictures.show(std::move(sources));
}

// The note under a button.
struct MenuNote {
    std::array<char, 160> text{};
};

MenuNote note_of(const Item& item, const Facts& facts) {
    MenuNote note;
    const auto& scenes = facts.catalogue.scenes;
    if (item.page == Menu::Page::kChallenges) {
        const Ladder ladder = ladder_of(scenes);
        std::snprintf(note.text.data(), note.text.size(), tr("%d of %d won"), ladder.won, ladder.challenges);
    } else if (item.page == Menu::Page::kFreePlay) {
        std::snprintf(note.text.data(), note.text.size(), tr("%d mountains"),
                      static_cast<int>(
                          std::ranges::count(scenes, Catalogue::Kind::kMountain, &Catalogue::Entry::kind)));
    } else if (item.page == Menu::Page::kHill) {
        std::snprintf(note.text.data(), note.text.size(), tr("your own terrain and worlds"));
    } else if (item.page == Menu::Page::kWatch) {
        std::snprintf(note.text.data(), note.text.size(), tr("slides that ship, and yours"));
    } else if (item.page == Menu::Page::kKeys) {
        std::snprintf(note.text.data(), note.text.size(), tr("what each key does; change them"));
    } else {
        std::snprintf(note.text.data(), note.text.size(), tr("picture, sound, text size"));
    }
    return note;
}

// Back to the world, or to the newest recording when the program has just started.
void go_on(Desk& desk, const Facts& facts, ImVec2 size, Actions& actions) {
    const bool on = desk.menu.page == Menu::Page::kStart;
    if (!desk.menu.begins) {
        if (desk.widgets.menu_button("Resume", facts.scenario.title.c_str(), on, size)) desk.menu.close();
        return;
    }
    const auto& own = facts.catalogue.own_of(ShelfKind::kRecording);
    const auto last = std::ranges::find_if(
        own, [&](const Catalogue::Entry& entry) { return entry.file.native() != facts.recording; });
    if (last == own.end()) return;
    std::array<char, 96> what;
    if (desk.widgets.menu_button("Continue", write_recording(what, *last, facts.catalogue), on, size))
        actions.emplace_back(Open{last->file.string(), {}, true});
}

void choices(Desk& desk, const Facts& facts, float width, Actions& actions) {
    constexpr float kUsual = 2.7f, kLeast = 1.5f;  // em
    const float room = (desk.size.y - desk.margin() - ImGui::GetCursorPosY()) / (kItems.size() + 2);
    const ImVec2 size{
        width, std::clamp(room - ImGui::GetStyle().ItemSpacing.y, kLeast * desk.em(), kUsual * desk.em())};
    go_on(desk, facts, size, actions);
    for (const Item& item : kItems)
        if (desk.widgets.menu_button(item.label, note_of(item, facts).text.data(),
                                     desk.menu.page == item.page, size))
            desk.menu.show(item.page);
    if (desk.widgets.menu_button("Quit", "what you did stays in its recording", false, size))
        actions.emplace_back(Verb::kQuit);
}

const char* title_of(Menu::Page page) {
    if (page == Menu::Page::kPad) return "Gamepad";
    const auto* const item = std::ranges::find(kItems, page, &Item::page);
    return item == kItems.end() ? "" : item->label;
}

void contents(Desk& desk, const Facts& facts, Actions& actions) {
    switch (desk.menu.page) {
        case Menu::Page::kChallenges:
            return challenges_page(desk, facts, actions);
        case Menu::Page::kFreePlay:
            return free_play_page(desk, facts, actions);
        case Menu::Page::kHill:
            return hill_page(desk, facts, actions);
        case Menu::Page::kWatch:
            return watch_page(desk, facts, actions);
        case Menu::Page::kSettings:
            return display_panel(desk, facts, actions);
        case Menu::Page::kKeys:
            return keys_page(desk, facts, actions);
        case Menu::Page::kPad:
            return pad_page(desk, facts);
        case Menu::Page::kStart:
            return;
    }
}

// A page beside the column, or over it in a narrow window.
void page_window(Desk& desk, const Facts& facts, float left, Actions& actions) {
    const float margin = desk.margin(), em = desk.em();
    const float wide = desk.size.x - left - margin;
    const bool sets = desk.menu.page == Menu::Page::kSettings;
    ImGui::SetNextWindowPos({left, margin});
    ImGui::SetNextWindowSize({sets ? std::min(wide, kSettingsWidth * em) : wide, desk.size.y - 2 * margin});
    ImGui::SetNextWindowBgAlpha(0.93f);
    ImGui::Begin("Page of the menu", nullptr, kFixedWindow & ~ImGuiWindowFlags_NoScrollbar);
    if (desk.widgets.icon_button("Back", Icon::kLeft, "Goes back.")) desk.menu.back();
    ImGui::SameLine(0, em);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(title_of(desk.menu.page)));
    ImGui::Separator();
    contents(desk, facts, actions);
    desk.widgets.note("Page of the menu", ImGui::GetWindowPos(),
                      {ImGui::GetWindowPos().x + ImGui::GetWindowSize().x,
                       ImGui::GetWindowPos().y + ImGui::GetWindowSize().y});
    ImGui::End();
}

}  // namespace

void menu(Desk& desk, const Facts& facts, Actions& actions) {
    ask_for_pictures(desk, facts.catalogue);
    const float em = desk.em(), margin = desk.margin(), left = 2 * margin;
    const bool at_start = desk.menu.page == Menu::Page::kStart, narrow = desk.size.x < kNarrowMenu * em;
    const float width = std::min(kMenuColumn * em, desk.size.x - 2 * left);
    shade(desk, at_start || !narrow ? width + 2 * left : desk.size.x);
    // Under everything, so that no click reaches the mountain.
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(desk.size);
    ImGui::SetNextWindowBgAlpha(0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin("Menu", nullptr, kFixedWindow | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    desk.widgets.note("Menu", {0, 0}, desk.size);
    if (at_start || !narrow) {
        ImFont& letters = *desk.widgets.letters.title;
        const float low = desk.size.y < 36 * em ? 0.6f : 1;  // a window without room
        ImGui::GetWindowDrawList()->AddText(&letters, letters.FontSize * 0.62f * low, {left, 1.5f * margin},
                                            palette().text, "Couloir");
        ImGui::SetCursorPos({left, kMenuTop * em * low * 0.9f});
        ImGui::BeginGroup();
        choices(desk, facts, width, actions);
        ImGui::EndGroup();
    }
    ImGui::End();
    if (!at_start) page_window(desk, facts, narrow ? margin : width + 2 * left, actions);
}

}  // namespace game::ui
