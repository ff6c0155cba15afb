// The page of slides to watch: those that ship, and what the user has made, with its names and pictures.

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <string>
#include <vector>

#include "game/ui/menu_pages.h"

namespace game::ui {
namespace {

using Entry = Catalogue::Entry;

constexpr std::array kShelfNames{"Slides that ship", "Your recordings", "Your screenshots"};
constexpr std::array kOrderNames{"newest first", "oldest first", "by name"};

const std::vector<Entry>& entries_of(Menu::Shelf shelf, const Catalogue& catalogue) {
    if (shelf == Menu::Shelf::kShipped) return catalogue.recordings;
    return shelf == Menu::Shelf::kRecordings ? catalogue.own : catalogue.screenshots;
}

const char* write_label(std::span<char> text, const Entry& entry, const Menu& menu, const Facts& facts) {
    if (menu.shelf == Menu::Shelf::kRecordings) return write_recording(text, entry, facts.catalogue);
    std::snprintf(text.data(), text.size(), "%s",
                  menu.shelf == Menu::Shelf::kShipped ? entry.title.c_str() : entry.name.c_str());
    return text.data();
}

// Whether a text has another one in it, whatever its capitals.
bool has(std::string_view text, std::string_view part) {
    const auto same = [](char one, char other) {
        return std::tolower(static_cast<unsigned char>(one)) ==
               std::tolower(static_cast<unsigned char>(other));
    };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

// What the search finds, in the order that was chosen; the recording that is being written is none.
std::vector<const Entry*> found(const Menu& menu, const Facts& facts) {
    std::vector<const Entry*> all;
    std::array<char, 160> label;
    for (const Entry& entry : entries_of(menu.shelf, facts.catalogue))
        if (entry.file.native() != facts.recording &&
            has(write_label(label, entry, menu, facts), menu.search.data()))
            all.push_back(&entry);
    if (menu.shelf == Menu::Shelf::kShipped) return all;
    if (menu.order == Menu::Order::kOldest) std::ranges::reverse(all);
    if (menu.order == Menu::Order::kName)
        std::ranges::stable_sort(all, {}, [](const Entry* entry) { return entry->name; });
    return all;
}

// What ships has the picture of its scene.
std::optional<ScenePictures::Part> picture_of_entry(Desk& desk, const Entry& entry) {
    if (desk.menu.shelf == Menu::Shelf::kShipped) return desk.pictures.of(entry.name);
    return desk.shelf_pictures.of(entry.file.native());
}

void ask_for_own_pictures(Desk& desk, const std::vector<const Entry*>& all) {
    if (desk.menu.shelf == Menu::Shelf::kShipped) return;
    std::vector<ScenePictures::Source> sources;
    sources.reserve(all.size());
    for (const Entry* entry : all) sources.push_back({entry->file.native(), entry->picture});
    desk.shelf_pictures.show(std::move(sources));
}

void head_of_shelf(Desk& desk) {
    Menu& menu = desk.menu;
    const float em = desk.em();
    int shelf = static_cast<int>(menu.shelf), order = static_cast<int>(menu.order);
    if (desk.widgets.choice(
            "Shelf", shelf, static_cast<int>(kShelfNames.size()), "What is listed.",
            [](int i) { return kShelfNames.at(static_cast<std::size_t>(i)); }, 12 * em)) {
        menu.shelf = static_cast<Menu::Shelf>(shelf);
        menu.chosen.clear();
    }
    ImGui::SameLine();
    if (desk.widgets.choice(
            "Order", order, static_cast<int>(kOrderNames.size()), "How it is sorted.",
            [](int i) { return kOrderNames.at(static_cast<std::size_t>(i)); }, 9 * em))
        menu.order = static_cast<Menu::Order>(order);
    ImGui::SameLine();
    desk.widgets.text_field("Search", "search", menu.search, ImGui::GetContentRegionAvail().x);
}

void cards_of_shelf(Desk& desk, const std::vector<const Entry*>& all, const Entry* chosen,
                    const Facts& facts) {
    if (all.empty())
        desk.widgets.dim(desk.menu.search[0] ? "Nothing here has these letters." : "Nothing here yet.");
    CardGrid grid(desk, CardGrid::kTitle);
    for (const Entry* entry : all) {
        grid.next();
        std::array<char, 160> label;
        Widgets::Card card{.label = write_label(label, *entry, desk.menu, facts)};
        put_on(card, picture_of_entry(desk, *entry));
        ImGui::PushID(entry);
        if (desk.widgets.card(card, grid.size(), entry == chosen)) {
            desk.menu.chosen = entry->file.native();
            desk.menu.renames = desk.menu.asks_to_throw = false;
        }
        ImGui::PopID();
    }
}

// A field for the new name.
void rename(Desk& desk, const Entry& entry, float width, Actions& actions) {
    Menu& menu = desk.menu;
    const bool ended = desk.widgets.text_field("New name", "name", menu.new_name, width);
    const bool pressed =
        desk.widgets.button("Rename it", "Gives the file this name.", true, width / 2 - desk.em() / 4);
    ImGui::SameLine();
    if (desk.widgets.button("Keep the name", "Changes nothing.", false, ImGui::GetContentRegionAvail().x))
        menu.renames = false;
    if (!ended && !pressed) return;
    actions.emplace_back(RenameFile{entry.file, menu.new_name.data()});
    menu.renames = false;
    menu.chosen.clear();
}

void throw_away_or_not(Desk& desk, const Entry& entry, float width, Actions& actions) {
    Menu& menu = desk.menu;
    if (desk.widgets.button("To the trash", "The desktop can give it back.", true,
                            width / 2 - desk.em() / 4)) {
        actions.emplace_back(ThrowAway{entry.file});
        menu.asks_to_throw = false;
        menu.chosen.clear();
    }
    ImGui::SameLine();
    if (desk.widgets.button("Keep it", "Changes nothing.", false, ImGui::GetContentRegionAvail().x))
        menu.asks_to_throw = false;
}

// What can be done with a file that the user has made.
void deeds(Desk& desk, const Entry& entry, float width, Actions& actions) {
    Menu& menu = desk.menu;
    if (menu.renames) return rename(desk, entry, width, actions);
    if (menu.asks_to_throw) return throw_away_or_not(desk, entry, width, actions);
    const float third = (width - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (desk.widgets.button("Rename", "Gives the file another name.", false, third)) {
        menu.renames = true;
        std::snprintf(menu.new_name.data(), menu.new_name.size(), "%s", entry.name.c_str());
    }
    ImGui::SameLine();
    if (desk.widgets.button("Throw away", "Moves the file to the trash.", false, third))
        menu.asks_to_throw = true;
    ImGui::SameLine();
    if (desk.widgets.button("Folder", "Shows the file's folder in the file manager.", false, third))
        actions.emplace_back(ShowFile{entry.file});
}

void about_entry(Desk& desk, const Entry& entry, const Facts& facts, Actions& actions) {
    const float width = ImGui::GetContentRegionAvail().x;
    std::array<char, 160> label;
    picture_and_title(desk, picture_of_entry(desk, entry), write_label(label, entry, desk.menu, facts));
    desk.widgets.dim("%s", entry.file.filename().c_str());
    ImGui::Dummy({0, desk.em() * 0.3f});
    if (desk.menu.shelf != Menu::Shelf::kScreenshots) {
        if (desk.widgets.button("Watch", "Plays it; you can continue anywhere.", true, width))
            actions.emplace_back(Open{entry.file.string(), {}});
        if (desk.widgets.button("Continue at its end", "Continues where it ends.", false, width))
            actions.emplace_back(Open{entry.file.string(), {}, true});
    }
    if (desk.menu.shelf != Menu::Shelf::kShipped) deeds(desk, entry, width, actions);
}

}  // namespace

void watch_page(Desk& desk, const Facts& facts, Actions& actions) {
    Menu& menu = desk.menu;
    if (menu.shelf == Menu::Shelf::kRecordings && facts.catalogue.own.empty())
        menu.shelf = Menu::Shelf::kShipped;
    head_of_shelf(desk);
    const std::vector<const Entry*> all = found(menu, facts);
    ask_for_own_pictures(desk, all);
    const auto clicked =
        std::ranges::find(all, menu.chosen, [](const Entry* entry) { return entry->file.native(); });
    const Entry* const chosen = clicked != all.end() ? *clicked : all.empty() ? nullptr : all.front();
    cards_and_choice(
        desk, [&] { cards_of_shelf(desk, all, chosen, facts); },
        [&] {
            if (chosen) about_entry(desk, *chosen, facts, actions);
        });
}

}  // namespace game::ui
