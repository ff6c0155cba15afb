#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "game/ui/panels.h"

namespace game::ui {

// How far the challenges that ship have been won.
struct Ladder {
    int challenges = 0, won = 0;  // those that are open or may be opened; with a medal
    int stars = 0;                // three for gold
};
Ladder ladder_of(const std::vector<Catalogue::Entry>& scenes);

// A harder challenge is closed until the other one was won in gold, or it was played itself. The other one; null if this
// one is open.
const Catalogue::Entry* waits_for(const Catalogue::Entry& entry, const Facts& facts);

// "An avalanche in a winter valley, 30 Nov 18:04", of one of the user's recordings; cut to fit.
const char* write_recording(std::span<char> text, const Catalogue::Entry& recording,
                            const Catalogue& catalogue);

// Cards of one size beside and below each other, as many to a row as there is room for. Call next() before each.
class CardGrid {
  public:
    // `below`: em, under the pictures.
    CardGrid(const Desk& desk, float below) {
        constexpr float kLeast = 11;  // em, width
        const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
        columns_ = std::max(1, static_cast<int>((room + gap) / (kLeast * desk.em() + gap)));
        const float width = (room - gap * static_cast<float>(columns_ - 1)) / static_cast<float>(columns_);
        size_ = {width, width * 9 / 16 + below * desk.em()};
    }
    void next() {
        if (drawn_++ % columns_ != 0) ImGui::SameLine();
    }
    ImVec2 size() const { return size_; }
    static constexpr float kTitle = 2.5f, kStars = 1.1f;  // em: heights below a picture

  private:
    int columns_ = 1, drawn_ = 0;
    ImVec2 size_;
};

// Cards at the left, and what is told of the chosen one at the right.
template <class Cards, class About>
void cards_and_choice(const Desk& desk, const Cards& cards, const About& about) {
    constexpr float kAbout = 19;  // em
    const float pane = std::min(kAbout * desk.em(), ImGui::GetContentRegionAvail().x / 2);
    ImGui::BeginChild("Cards", {-pane - desk.em(), 0});
    cards();
    ImGui::EndChild();
    ImGui::SameLine(0, desk.em());
    ImGui::BeginChild("About it", {0, 0});
    about();
    ImGui::EndChild();
}

// A picture as wide as there is room, and the title under it. A picture that is still being read keeps its place, so that
// no button moves from under the pointer when it comes.
void picture_and_title(Desk& desk, const std::optional<ScenePictures::Part>& picture, const char* title);
// The picture of a card, if there is one.
void put_on(Widgets::Card& card, const std::optional<ScenePictures::Part>& picture);

void challenges_page(Desk& desk, const Facts& facts, Actions& actions);
void free_play_page(Desk& desk, const Facts& facts, Actions& actions);
void hill_page(Desk& desk, const Facts& facts, Actions& actions);
void pad_page(Desk& desk, const Facts& facts);
void keys_page(Desk& desk, const Facts& facts, Actions& actions);
void watch_page(Desk& desk, const Facts& facts, Actions& actions);

}  // namespace game::ui
