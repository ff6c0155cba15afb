#include <cstdlib>

#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/game/ui_hand.h"
#include "tests/support/allocations.h"

namespace game::test {
namespace {

int asked_by_imgui = 0;

// ImGui's memory counted for as long as it lives.
class UiMemory : public UiHand {
  protected:
    void SetUp() override {
        ui_.reset();
        ImGui::GetAllocatorFunctions(&allocate_, &free_, &user_);
        ImGui::SetAllocatorFunctions(
            [](std::size_t size, void*) {
                ++asked_by_imgui;
                return std::malloc(size);
            },
            [](void* memory, void*) { std::free(memory); });
        begin_anew({1920, 1080, 1});
    }
    void TearDown() override {
        ui_.reset();
        ImGui::SetAllocatorFunctions(allocate_, free_, user_);
    }

    // What a frame asks for, test's own vectors left out.
    std::int64_t asked_in_a_frame(const ui::Facts& facts, Actions& actions) {
        const auto events = screen_.poll();
        const std::int64_t before = support::allocations();
        const int imgui_before = asked_by_imgui;
        ui_->begin(events, screen_, 1, 1.0 / 60);
        ui_->build(facts, actions);
        return support::allocations() - before + asked_by_imgui - imgui_before;
    }

  private:
    ImGuiMemAllocFunc allocate_;
    ImGuiMemFreeFunc free_;
    void* user_;
};

TEST_F(UiMemory, asks_for_none_in_a_frame_with_all_panels_open) {
    for (const Verb verb : {Verb::kToggleScene, Verb::kTogglePhysics, Verb::kToggleDisplay,
                            Verb::kTogglePerformance, Verb::kToggleMeasure, Verb::kToggleHelp})
        ui_->perform(verb);
    CrossSection section;
    section.lay({{10, 10}, {10, 90}}, 0);
    section_.emplace(ui::SectionNote{.section = section});
    SlideHistory history;
    history_ = &history;
    under_cursor_.emplace();
    std::snprintf(under_cursor_->where.data(), under_cursor_->where.size(),
                  "47.3° N 11.4° E, UTM 32T 683912 5240010");
    for (int i = 0; i < 300; ++i) times_.add({{1, 2, 3, 4, 5}, static_cast<float>(10 + i % 60), 2, 1});
    notices_.tell(Notice::Kind::kWarning, "summit.tif: has no coordinate system", 1e6);
    display_.overlay = render::Overlay::kSlope;
    actions_to_undo_ = 3;
    state_.params.start_slope *= 1.1f;
    Lesson::Stop stop;
    stop.heading = "A stop", stop.text = "{speed} {volume} {pressure}";
    const LessonFigures figures;
    lesson_.emplace(
        ui::LessonNote{.title = "A lesson", .stop = stop, .figures = figures, .number = 1, .stops = 2});
    lesson_marks_ = {{{400, 300}, false}, {{500, 350}, true}};
    settle(30);

    const ui::Facts facts = this->facts();
    Actions actions;
    actions.reserve(64);
    std::int64_t most = 0;
    for (int i = 0; i < 240; ++i) {
        state_.tick = 1000 + 977 * i;  // texts change
        section.see(sim::view(state_), {});
        history.see(sim::view(state_), {}, {}, 1, state_.tick);
        screen_.move(10 + 7.0 * i, 200 + 3.0 * i);  // over panels and beside
        if (i % 8 == 0) screen_.happen({WheelEvent{i % 16 ? 1.0 : -1.0, {}}});
        const std::int64_t asked = asked_in_a_frame(facts, actions);
        if (i >= 120) most = std::max(most, asked);
    }
    EXPECT_EQ(most, 0);
    EXPECT_TRUE(actions.empty());
}

TEST_F(UiMemory, asks_for_none_in_a_frame_with_plots_over_time) {
    SlideHistory history;
    state_.rolling(10, 5) = 1, state_.velocity_y(10, 5) = 10;
    history_ = &history;
    ui_->perform(Verb::kToggleMeasure);
    settle();
    EXPECT_TRUE(click("Over time").empty());
    timeline_.known_until = 60 * 200;
    for (state_.tick = 0; state_.tick < timeline_.known_until; ++state_.tick)
        history.see(sim::view(state_), {}, {}, 1.0 / 60, state_.tick);
    settle(30);
    const ui::Facts facts = this->facts();
    Actions actions;
    actions.reserve(64);
    std::int64_t most = 0;
    for (int i = 0; i < 60; ++i) {
        ++state_.tick;
        screen_.move(10 + 7.0 * i, 200 + 3.0 * i);
        const std::int64_t asked = asked_in_a_frame(facts, actions);
        if (i >= 30) most = std::max(most, asked);
    }
    EXPECT_EQ(most, 0);
}

}  // namespace
}  // namespace game::test
