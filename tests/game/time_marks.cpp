#include "game/app/time_marks.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "game/scene/scene.h"

namespace game::test {
namespace {

using Kind = ui::TimeMark::Kind;

std::vector<std::int64_t> ticks_of(const TimeMarks& marks, Kind kind) {
    std::vector<std::int64_t> ticks;
    for (const ui::TimeMark& mark : marks.all())
        if (mark.kind == kind) ticks.push_back(mark.tick);
    return ticks;
}

sim::Command of(sim::CommandKind kind) {
    sim::Command command;
    command.kind = kind;
    return command;
}

// Blasts that release a slab above a hamlet.
class MarkedWorld : public testing::Test {
  protected:
    MarkedWorld() {
        Overrides overrides;
        overrides.squares = 80;
        scene_ = load_scene("protection", overrides).value();
        session_.emplace(Session::begin(scene_.scenario, {}, std::nullopt).value());
    }
    void play(std::int64_t until) {
        std::vector<sim::Command> due;
        while (session_->state().tick < until) {
            due.clear();
            for (const TimedCommand& each : commands_at(scene_.commands, session_->state().tick))
                due.push_back(each.command);
            ASSERT_TRUE(session_->advance(due));
            marks_.see(*session_, due);
        }
    }
    Scene scene_;
    std::optional<Session> session_;
    TimeMarks marks_;
};

TEST_F(MarkedWorld, has_a_mark_where_something_is_done_and_where_something_is_hit) {
    const std::int64_t blast = scene_.commands.front().tick;
    play(blast + 1);
    EXPECT_EQ(ticks_of(marks_, Kind::kAction), std::vector{blast});
    EXPECT_TRUE(ticks_of(marks_, Kind::kHit).empty());
    play(blast + 30 * 60);
    const auto hits = ticks_of(marks_, Kind::kHit);
    ASSERT_FALSE(hits.empty());
    EXPECT_GT(hits.front(), blast);
    EXPECT_EQ(marks_.after(blast), hits.front());
    EXPECT_EQ(marks_.before(hits.front()), blast);
    EXPECT_EQ(marks_.before(blast), std::nullopt);
    EXPECT_EQ(marks_.after(hits.back()), std::nullopt);

    const auto all = marks_.all().size();
    session_.emplace(Session::begin(scene_.scenario, {}, std::nullopt).value());
    play(blast + 30 * 60);
    EXPECT_EQ(marks_.all().size(), all) << "what is known is not marked twice";
    marks_.forget_after(blast);
    EXPECT_EQ(marks_.all().size(), 1u);
}

TEST_F(MarkedWorld, counts_a_stroke_as_one_action_and_another_tool_as_another) {
    std::vector<TimedCommand> known;
    for (int tick = 10; tick < 100; ++tick) known.push_back({tick, of(sim::CommandKind::kPour)});
    for (int tick = 200; tick < 210; ++tick) known.push_back({tick, of(sim::CommandKind::kPour)});
    known.push_back({205, of(sim::CommandKind::kDig)});
    std::ranges::stable_sort(known, {}, &TimedCommand::tick);
    known.push_back({220, of(sim::CommandKind::kSet)});  // which no tool does
    marks_.begin(known);
    const auto actions = ticks_of(marks_, Kind::kAction);
    EXPECT_EQ(actions.front(), 10);
    EXPECT_EQ(actions[1], 200);
    EXPECT_EQ(actions[2], 205);
    EXPECT_LE(actions.back(), 206);
}

TEST(TimeMarks, are_bounded) {
    std::vector<TimedCommand> known;
    for (int i = 0; i < 1000; ++i) known.push_back({100 * i, of(sim::CommandKind::kBlast)});
    TimeMarks marks;
    marks.begin(known);
    EXPECT_EQ(marks.all().size(), TimeMarks::kMost);
}

TEST(TimeMarks, are_at_the_stops_of_a_lesson) {
    TimeMarks marks;
    const std::array<std::int64_t, 2> stops{30, 900};
    marks.begin({}, stops);
    EXPECT_EQ(ticks_of(marks, Kind::kStop), (std::vector<std::int64_t>{30, 900}));
    EXPECT_EQ(marks.after(30), 900);
}

}  // namespace
}  // namespace game::test
