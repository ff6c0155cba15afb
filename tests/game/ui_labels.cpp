#include <array>
#include <random>

#include <gtest/gtest.h>

#include "game/ui/label_layout.h"
#include "tests/game/ui_hand.h"
#include "tests/support/allocations.h"

namespace game::test {
namespace {

using Part = SlideParts::Part;

constexpr std::array kNames{"Crown", "Stauchwall", "Track", "Front", "Deposit"};

class UiLabels : public UiHand {
  protected:
    void put(Part part, glm::dvec2 at) { slide_labels_.push_back({part, at}); }
    std::optional<ui::Box> box(std::string_view label) const {
        const auto place = ui_->find(label);
        if (!place) return std::nullopt;
        const ImVec2 from(static_cast<float>(place->x), static_cast<float>(place->y));
        return ui::Box{
            from, {from.x + static_cast<float>(place->width), from.y + static_cast<float>(place->height)}};
    }
    int shown() const {
        int count = 0;
        for (const char* name : kNames) count += ui_->find(name).has_value();
        return count;
    }
    // None over another, the bars, or an open panel.
    void expect_clear() const {
        std::vector<ui::Box> boxes;
        const auto expect = [&](const char* label, bool is_fixed) {
            const auto here = box(label);
            if (!here) return;
            for (const ui::Box& other : boxes) {
                if (!is_fixed) {
                    EXPECT_FALSE(ui::overlap(*here, other)) << label;
                }
            }
            boxes.push_back(*here);
        };
        for (const char* bar :
             {"Toolbar", "Tool options", "Time bar", "Readings", "Panel Display", "Panel Physics", "Result"})
            expect(bar, true);
        expect("Compass", false);
        for (const char* name : kNames) expect(name, false);
    }
};

TEST_F(UiLabels, are_hidden_until_they_are_wanted) {
    EXPECT_FALSE(Display{}.labels);
    put(Part::kCrown, {640, 300});
    settle();
    EXPECT_EQ(shown(), 0);
    EXPECT_FALSE(ui_->find("Compass"));
    compass_.emplace();
    settle();
    EXPECT_EQ(shown(), 1);
    EXPECT_TRUE(ui_->find("Compass"));
}

TEST_F(UiLabels, overlap_neither_each_other_nor_bars_and_panels) {
    compass_.emplace().metre_px = 0.7;
    for (const Part part : {Part::kCrown, Part::kStauchwall, Part::kTrack, Part::kFront, Part::kDeposit})
        put(part, {640 + 16.0 * static_cast<int>(part), 300});
    settle();
    EXPECT_EQ(shown(), 5) << "there is room around places a plate's height apart";
    expect_clear();
    under_cursor_.emplace();
    card_ = ui::ResultCard{"The bowl", "Your slide", "", "", std::nullopt, {}};
    ui_->perform(Verb::kToggleDisplay);
    settle();
    expect_clear();
    EXPECT_TRUE(ui_->find("Compass"));
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        for (ui::SlideLabel& label : slide_labels_)
            label.at = {static_cast<double>(random() % 1400) - 60, static_cast<double>(random() % 800) - 40};
        settle(1);
        expect_clear();
    }
}

TEST_F(UiLabels, are_not_drawn_for_what_a_panel_covers) {
    compass_.emplace();
    put(Part::kCrown, {640, 700});
    settle();
    EXPECT_EQ(shown(), 0) << "below the time bar";
    ui_->perform(Verb::kTogglePanels);
    settle();
    EXPECT_EQ(shown(), 1) << "there are no bars";
}

TEST_F(UiLabels, stay_where_they_are_while_their_places_move_a_little) {
    compass_.emplace();
    put(Part::kCrown, {640, 300}), put(Part::kFront, {640, 420});
    settle();
    const auto before = place("Front");
    slide_labels_[1].at += glm::dvec2(9, 5);
    settle(1);
    EXPECT_NEAR(place("Front").x, before.x + 9, 1);
    EXPECT_NEAR(place("Front").y, before.y + 5, 1);
}

TEST_F(UiLabels, have_a_scale_of_a_round_length) {
    compass_.emplace().metre_px = 0.7;
    settle();
    const auto with = place("Compass");
    compass_->metre_px.reset();
    settle();
    EXPECT_LT(place("Compass").width, with.width) << "without ground there is no scale";
}

}  // namespace
}  // namespace game::test
