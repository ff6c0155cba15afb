#include "game/ui/menu_pages.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "game/analysis/score.h"
#include "game/scene/week.h"
#include "game/words/names.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr std::array kDifficulties{"", "easy", "medium", "hard", "very hard"};
constexpr const char* kStarts = "Starts this scene; the current session stays in its recording.";

constexpr const char* kBeginsLesson =
    "Begins this lesson: a slide that halts where there is something to see.";

using Kind = Catalogue::Kind;

// The lesson whose card was clicked last; null: none.
const Catalogue::Entry* chosen_lesson(const Desk& desk, const Facts& facts) {
    const auto& lessons = facts.catalogue.lessons;
    const auto found = std::ranges::find(lessons, desk.menu.chosen,
                                         [](const Catalogue::Entry& lesson) { return lesson.file.native(); });
    return found == lessons.end() ? nullptr : &*found;
}

// The scene whose card is chosen: the one clicked last, else the open one, else the first of the kinds that is not won yet.
const Catalogue::Entry* chosen_of(const Desk& desk, const Facts& facts, std::span<const Kind> kinds) {
    const auto& scenes = facts.catalogue.scenes;
    const auto is_there = [&](const Catalogue::Entry& entry) {
        return std::ranges::find(kinds, entry.kind) != kinds.end();
    };
    for (const std::string* name : {&desk.menu.chosen, &facts.scenario.scene}) {
        const auto found = std::ranges::find(scenes, *name, &Catalogue::Entry::name);
        if (found != scenes.end() && is_there(*found)) return &*found;
    }
    const Catalogue::Entry* first = nullptr;
    for (const Catalogue::Entry& entry : scenes) {
        if (!is_there(entry)) continue;
        const bool is_next = entry.kind == Kind::kChallenge && !waits_for(entry, facts) &&
                             (!entry.best || entry.best->medal == 0);
        if (is_next) return &entry;
        if (!first) first = &entry;
    }
    return first;
}

// A harder challenge has the picture of the other one.
std::optional<ScenePictures::Part> picture_of_scene(const Desk& desk, const Catalogue::Entry& entry) {
    return desk.pictures.of(entry.harder_than.empty() ? entry.name : entry.harder_than);
}

Widgets::Card card_of(const Desk& desk, const Catalogue::Entry& entry, const Facts& facts) {
    Widgets::Card card{.label = entry.title.c_str()};
    put_on(card, picture_of_scene(desk, entry));
    if (entry.kind != Kind::kChallenge) return card;
    card.medal = entry.best ? entry.best->medal : 0;
    card.is_closed = waits_for(entry, facts) != nullptr;
    card.note = kDifficulties.at(static_cast<std::size_t>(entry.difficulty));
    return card;
}

void cards(Desk& desk, const char* heading, Kind kind, const Catalogue::Entry* chosen, const Facts& facts) {
    const auto& scenes = facts.catalogue.scenes;
    if (std::ranges::find(scenes, kind, &Catalogue::Entry::kind) == scenes.end()) return;
    if (heading) desk.widgets.heading(heading);
    CardGrid grid(desk, CardGrid::kTitle + (kind == Kind::kChallenge ? CardGrid::kStars : 0));
    for (const Catalogue::Entry& entry : scenes) {
        if (entry.kind != kind) continue;
        grid.next();
        if (desk.widgets.card(card_of(desk, entry, facts), grid.size(), &entry == chosen))
            desk.menu.chosen = entry.name;
    }
}

void lesson_cards(Desk& desk, const Catalogue::Entry* chosen, const Facts& facts) {
    if (facts.catalogue.lessons.empty()) return;
    desk.widgets.heading("Lessons");
    CardGrid grid(desk, CardGrid::kTitle);
    for (const Catalogue::Entry& lesson : facts.catalogue.lessons) {
        grid.next();
        Widgets::Card card{.label = lesson.title.c_str()};
        put_on(card, desk.pictures.of(lesson.file.native()));
        if (desk.widgets.card(card, grid.size(), &lesson == chosen)) desk.menu.chosen = lesson.file.native();
    }
}

// What a person should know of a challenge before it begins.
void facts_of_challenge(Desk& desk, const Catalogue::Entry& entry, const Facts& facts) {
    std::array<char, 160> text;
    const auto& scenes = facts.catalogue.scenes;
    if (entry.difficulty > 0)
        desk.widgets.fact("Difficulty", "%s", tr(kDifficulties[static_cast<std::size_t>(entry.difficulty)]));
    if (entry.best)
        desk.widgets.fact("Your best", "%s, %s",
                          write_number(text, "%.0f", static_cast<double>(entry.best->score)),
                          tr(medal_name(entry.best->medal)));
    const auto harder = std::ranges::find(scenes, entry.name, &Catalogue::Entry::harder_than);
    if (harder != scenes.end() && waits_for(*harder, facts))
        desk.widgets.fact("Gold opens", "%s", tr(harder->title.c_str()));
}

// What is chosen, if anything, with the button that begins it.
void about(Desk& desk, const Catalogue::Entry* chosen, const Facts& facts, Actions& actions) {
    if (!chosen) return;
    const Catalogue::Entry& entry = *chosen;
    const bool is_lesson = entry.kind == Kind::kLesson;
    picture_and_title(desk, is_lesson ? desk.pictures.of(entry.file.native()) : picture_of_scene(desk, entry),
                      entry.title.c_str());
    std::array<char, 512> text;
    if (!entry.about.empty())
        desk.widgets.plain("%s", write_with_volumes(text, tr(std::string_view(entry.about))));
    desk.widgets.note("About");
    if (entry.is_weekly) {
        const auto week = static_cast<int>(this_week());
        desk.widgets.fact("Week", "%d, %d", week % 100, week / 100);
    }
    if (entry.kind == Kind::kChallenge) facts_of_challenge(desk, entry, facts);
    const Catalogue::Entry* const other = waits_for(entry, facts);
    if (other) desk.widgets.plain("Opens with gold in “%s”.", tr(other->title.c_str()));
    ImGui::Dummy({0, desk.em() * 0.3f});
    ImGui::BeginDisabled(other != nullptr);
    if (desk.widgets.button("Start", is_lesson ? kBeginsLesson : kStarts, true,
                            ImGui::GetContentRegionAvail().x))
        actions.emplace_back(Open{is_lesson ? entry.file.string() : entry.name, {}});
    ImGui::EndDisabled();
}

}  // namespace

void put_on(Widgets::Card& card, const std::optional<ScenePictures::Part>& picture) {
    if (picture) card.picture = picture->texture, card.from = picture->from, card.to = picture->to;
}

void picture_and_title(Desk& desk, const std::optional<ScenePictures::Part>& picture, const char* title) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 size{width, width * 9 / 16};
    if (picture)
        ImGui::Image(picture->texture, size, picture->from, picture->to);
    else
        ImGui::Dummy(size);
    ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    desk.widgets.plain("%s", tr(title));
    ImGui::PopStyleColor();
}

const Catalogue::Entry* waits_for(const Catalogue::Entry& entry, const Facts& facts) {
    if (entry.harder_than.empty() || entry.best || entry.name == facts.scenario.scene) return nullptr;
    const auto& scenes = facts.catalogue.scenes;
    const auto easier = std::ranges::find(scenes, entry.harder_than, &Catalogue::Entry::name);
    const bool is_closed = easier != scenes.end() && (!easier->best || easier->best->medal < kGold);
    return is_closed ? &*easier : nullptr;
}

Ladder ladder_of(const std::vector<Catalogue::Entry>& scenes) {
    Ladder ladder;
    for (const Catalogue::Entry& entry : scenes) {
        if (entry.kind != Kind::kChallenge) continue;
        ++ladder.challenges;
        const int medal = entry.best ? entry.best->medal : 0;
        ladder.won += medal > 0;
        ladder.stars += medal;
    }
    return ladder;
}

const char* write_recording(std::span<char> text, const Catalogue::Entry& recording,
                            const Catalogue& catalogue) {
    // Named by time and scene: 2026-11-21_18-04-59_alpine-valley
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0, length = 0;
    const int read = std::sscanf(recording.name.c_str(), "%4d-%2d-%2d_%2d-%2d-%2d_%n", &year, &month, &day,
                                 &hour, &minute, &second, &length);
    if (read < 6 || length == 0 || month < 1 || month > 12) {
        std::snprintf(text.data(), text.size(), "%s", recording.name.c_str());
        return text.data();
    }
    const std::string scene = recording.name.substr(static_cast<std::size_t>(length));
    std::snprintf(text.data(), text.size(), tr("%s, %d %s %02d:%02d"), tr(title_in(catalogue.scenes, scene)),
                  day, tr(month_name(month)), hour, minute);
    return text.data();
}

void challenges_page(Desk& desk, const Facts& facts, Actions& actions) {
    constexpr std::array kKinds{Kind::kChallenge};
    const Catalogue::Entry* const chosen = chosen_of(desk, facts, kKinds);
    const Ladder ladder = ladder_of(facts.catalogue.scenes);
    desk.widgets.dim("%d of %d won, %d of %d stars. A gold medal opens the harder one of a challenge.",
                     ladder.won, ladder.challenges, ladder.stars, kGold * ladder.challenges);
    cards_and_choice(
        desk, [&] { cards(desk, nullptr, Kind::kChallenge, chosen, facts); },
        [&] { about(desk, chosen, facts, actions); });
}

void free_play_page(Desk& desk, const Facts& facts, Actions& actions) {
    constexpr std::array kKinds{Kind::kMountain, Kind::kFlowDemo};
    const Catalogue::Entry* const lesson = chosen_lesson(desk, facts);
    const Catalogue::Entry* const chosen = lesson ? lesson : chosen_of(desk, facts, kKinds);
    cards_and_choice(
        desk,
        [&] {
            cards(desk, nullptr, Kind::kMountain, chosen, facts);
            lesson_cards(desk, chosen, facts);
            cards(desk, "Flow demos: the figures of the paper", Kind::kFlowDemo, chosen, facts);
        },
        [&] { about(desk, chosen, facts, actions); });
}

}  // namespace game::ui
