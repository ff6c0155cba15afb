// The pages of files: slides to watch, and hills and challenges of the user's own, with their names and pictures.

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

// What is listed; no kind: what ships.
using Listed = std::optional<ShelfKind>;
struct ShelfRow {
    Menu::Page page;
    Listed listed;
    const char* name;
};
constexpr std::array kShelves{
    ShelfRow{Menu::Page::kWatch, std::nullopt, "Slides that ship"},
    ShelfRow{Menu::Page::kWatch, ShelfKind::kRecording, "Your recordings"},
    ShelfRow{Menu::Page::kWatch, ShelfKind::kScreenshot, "Your screenshots"},
    ShelfRow{Menu::Page::kHill, ShelfKind::kWorld, "Your worlds"},
    ShelfRow{Menu::Page::kHill, ShelfKind::kChallenge, "Your challenges"},
};
constexpr std::array kOrderNames{"newest first", "oldest first", "by name"};

Listed listed(const Menu& menu) {
    return menu.page == Menu::Page::kHill ? menu.hill : menu.watched;
}

const std::vector<Entry>& entries_of(const Menu& menu, const Catalogue& catalogue) {
    const Listed kind = listed(menu);
    return kind ? catalogue.own_of(*kind) : catalogue.recordings;
}

const char* write_label(std::span<char> text, const Entry& entry, const Menu& menu, const Facts& facts) {
    const Listed kind = listed(menu);
    if (kind == ShelfKind::kRecording) return write_recording(text, entry, facts.catalogue);
    std::snprintf(text.data(), text.size(), "%s", kind ? entry.name.c_str() : entry.title.c_str());
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
    for (const Entry& entry : entries_of(menu, facts.catalogue))
        if (entry.file.native() != facts.recording &&
            has(write_label(label, entry, menu, facts), menu.search.data()))
            all.push_back(&entry);
    if (!listed(menu)) return all;
    if (menu.order == Menu::Order::kOldest) std::ranges::reverse(all);
    if (menu.order == Menu::Order::kName)
        std::ranges::stable_sort(all, {}, [](const Entry* entry) { return entry->name; });
    return all;
}

// What ships has the picture of its scene.
std::optional<ScenePictures::Part> picture_of_entry(Desk& desk, const Entry& entry) {
    if (!listed(desk.menu)) return desk.pictures.of(entry.name);
    return desk.shelf_pictures.of(entry.file.native());
}

void ask_for_own_pictures(Desk& desk, const std::vector<const Entry*>& all) {
    if (!listed(desk.menu)) return;
    std::vector<ScenePictures::Source> sources;
    sources.reserve(all.size());
    for (const Entry* entry : all) sources.push_back({entry->file.native(), entry->picture});
    desk.shelf_pictures.show(std::move(sources));
}

void head_of_shelf(Desk& desk) {
    Menu& menu = desk.menu;
    const float em = desk.em();
    const auto first = std::ranges::find(kShelves, menu.page, &ShelfRow::page);
    const auto end =
        std::find_if(first, kShelves.end(), [&](const ShelfRow& row) { return row.page != menu.page; });
    const auto now =
        std::find_if(first, end, [&](const ShelfRow& row) { return row.listed == listed(menu); });
    int shelf = static_cast<int>(now - first), order = static_cast<int>(menu.order);
    if (desk.widgets.choice(
            "Shelf", shelf, static_cast<int>(end - first), "What is listed.",
            [&](int i) { return first[i].name; }, 12 * em)) {
        const Listed chosen = first[shelf].listed;
        if (menu.page == Menu::Page::kHill)
            menu.hill = *chosen;
        else
            menu.watched = chosen;
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

void write_length(Desk& desk, double seconds) {
    const int whole = static_cast<int>(std::min(seconds, 1e8));
    desk.widgets.fact("Length", "%d:%02d min", whole / 60, whole % 60);
}

void open_it(Desk& desk, const Entry& entry, float width, Actions& actions) {
    const Listed kind = listed(desk.menu);
    const auto begin = [&](const char* label, const char* tooltip, bool on, bool at_end) {
        if (desk.widgets.button(label, tooltip, on, width))
            actions.emplace_back(Open{entry.file.string(), {}, at_end});
    };
    if (kind == ShelfKind::kWorld)
        begin("Start", "Starts in this world; the current session stays in its recording.", true, false);
    else if (kind == ShelfKind::kChallenge)
        begin("Start", "Shows how this challenge of yours is won; then try it yourself.", true, false);
    else if (kind != ShelfKind::kScreenshot) {
        begin("Watch", "Plays it; you can continue anywhere.", true, false);
        begin("Continue at its end", "Continues where it ends.", false, true);
    }
}

void about_entry(Desk& desk, const Entry& entry, const Facts& facts, Actions& actions) {
    const float width = ImGui::GetContentRegionAvail().x;
    std::array<char, 160> label;
    picture_and_title(desk, picture_of_entry(desk, entry), write_label(label, entry, desk.menu, facts));
    desk.widgets.dim("%s", entry.file.filename().c_str());
    if (entry.length_s) write_length(desk, *entry.length_s);
    ImGui::Dummy({0, desk.em() * 0.3f});
    open_it(desk, entry, width, actions);
    if (listed(desk.menu)) deeds(desk, entry, width, actions);
}

void files_page(Desk& desk, const Facts& facts, Actions& actions) {
    Menu& menu = desk.menu;
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

}  // namespace

void watch_page(Desk& desk, const Facts& facts, Actions& actions) {
    auto& watched = desk.menu.watched;
    if (watched == ShelfKind::kRecording && facts.catalogue.own_of(*watched).empty()) watched.reset();
    files_page(desk, facts, actions);
}

void hill_page(Desk& desk, const Facts& facts, Actions& actions) {
    desk.widgets.plain(
        "Drop an elevation file onto the window: GeoTIFF, Esri ASCII grid or another raster that GDAL reads. "
        "A scene of your own (.toml) works too.");
    desk.widgets.dim("The Scene panel saves the world that is open, with all that was done to it.");
    const auto is_empty = [&](ShelfKind kind) { return facts.catalogue.own_of(kind).empty(); };
    if (is_empty(ShelfKind::kWorld) != is_empty(ShelfKind::kChallenge))
        desk.menu.hill = is_empty(ShelfKind::kWorld) ? ShelfKind::kChallenge : ShelfKind::kWorld;
    files_page(desk, facts, actions);
}

}  // namespace game::ui
