#include "game/controls/guide.h"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "game/app/guide_memory.h"
#include "game/files/text_file.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

using Step = Guide::Step;

constexpr Guide::Seen kAtRest{.may_play = true}, kSliding{.may_play = true, .moves = true};

TEST(Guide, leads_from_one_deed_to_the_next_and_says_one_thing_at_a_time) {
    Guide guide;
    guide.see({});
    EXPECT_FALSE(guide.speaks()) << "a slide is watched";
    guide.next();
    EXPECT_EQ(guide.step(), Step::kBlast);
    guide.see(kAtRest);
    EXPECT_TRUE(guide.speaks());
    guide.did(sim::CommandKind::kBlast);
    EXPECT_EQ(guide.step(), Step::kRewind);
    guide.see(kSliding);
    EXPECT_FALSE(guide.speaks()) << "it speaks over a slide";
    guide.see(kAtRest);
    EXPECT_TRUE(guide.speaks());
    Guide::Seen past = kAtRest;
    past.runs_back = past.looks_back = true;
    guide.see(past);
    EXPECT_EQ(guide.step(), Step::kGoOn);
    EXPECT_FALSE(guide.speaks()) << "time still runs back";
    past.runs_back = false, past.moves = true;
    guide.see(past);
    EXPECT_TRUE(guide.speaks());
    guide.see(kAtRest);
    EXPECT_EQ(guide.step(), Step::kPour);
    EXPECT_TRUE(guide.speaks());
    guide.did(sim::CommandKind::kDig);
    EXPECT_EQ(guide.step(), Step::kPour);
    guide.did(sim::CommandKind::kPour);
    EXPECT_EQ(guide.step(), Step::kChallenge);
    guide.see(kSliding);
    EXPECT_FALSE(guide.speaks());
    guide.see(kAtRest);
    EXPECT_TRUE(guide.speaks());
    guide.next();
    EXPECT_EQ(guide.step(), Step::kDone);
    guide.see(kAtRest);
    EXPECT_FALSE(guide.speaks());
    guide.next();
    EXPECT_EQ(guide.step(), Step::kDone);
}

TEST(Guide, shows_a_place_to_who_does_nothing_for_eight_seconds) {
    Guide guide(Step::kBlast);
    Guide::Seen seen = kAtRest;
    for (seen.now_s = 100; seen.now_s < 107.9; seen.now_s += 0.1) {
        guide.see(seen);
        EXPECT_FALSE(guide.shows_place());
    }
    seen.now_s = 108.1;
    guide.see(seen);
    EXPECT_TRUE(guide.shows_place());
    guide.did(sim::CommandKind::kBlast);
    EXPECT_FALSE(guide.shows_place());
}

TEST(Guide, is_silent_in_a_world_that_is_not_for_playing_freely) {
    for (std::size_t i = 0; i < Guide::kSteps; ++i) {
        Guide guide(static_cast<Step>(i));
        guide.see({.may_play = false});
        EXPECT_FALSE(guide.speaks());
        EXPECT_EQ(Guide::step_of(Guide::name_of(static_cast<Step>(i))), static_cast<Step>(i));
    }
    EXPECT_FALSE(Guide::step_of("dance"));
}

class GuideFile : public testing::Test {
  protected:
    GuideFile() { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }
    std::filesystem::path file() const { return folder_.path() / "couloir/guide.json"; }

    support::TemporaryFolder folder_;
};

TEST_F(GuideFile, keeps_how_far_somebody_was_led) {
    EXPECT_EQ(remembered_guide().guide.step(), Step::kWatch);
    for (const Step step : {Step::kBlast, Step::kPour, Step::kDone}) {
        ASSERT_TRUE(remember(Guide(step)));
        const Remembered again = remembered_guide();
        EXPECT_EQ(again.guide.step(), step);
        EXPECT_EQ(again.told, "");
    }
}

TEST_F(GuideFile, that_is_damaged_is_set_aside_with_a_sentence) {
    for (const auto& [text, fault] :
         {std::pair<std::string, const char*>{"", "is no JSON object"},
          {"{\"version\":1,\"step\":", "is no JSON object"},
          {"[1, 2]", "is no JSON object"},
          {"{\"version\":2,\"step\":\"blast\"}", "does not say \"version\": 1"},
          {"{\"version\":1,\"step\":7}", "has no text \"step\""},
          {"{\"version\":1,\"step\":\"dance\"}", "names no step of the guide: \"dance\""},
          {std::string(5000, ' '), "has more than 4096 bytes"}}) {
        ASSERT_TRUE(write_text(file(), text));
        const Remembered got = remembered_guide();
        EXPECT_EQ(got.guide.step(), Step::kWatch);
        const std::string aside = file().string() + ".damaged";
        EXPECT_EQ(got.told, file().string() + ": " + fault +
                                "; the first steps start again, and it is kept as " + aside);
        EXPECT_FALSE(std::filesystem::exists(file()));
        EXPECT_EQ(read_text(aside).value(), text);
    }
}

}  // namespace
}  // namespace game::test
