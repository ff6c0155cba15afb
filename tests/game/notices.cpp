#include "game/controls/notices.h"

#include <gtest/gtest.h>

namespace game::test {
namespace {

using Kind = Notice::Kind;

TEST(Notices, keep_the_newest_in_the_order_in_which_they_were_told) {
    Notices notices;
    for (char letter = 'a'; letter <= 'h'; ++letter) notices.tell(Kind::kInfo, std::string(1, letter), 0);
    ASSERT_EQ(notices.size(), Notices::kKept);
    EXPECT_EQ(notices[0].sentence, "c");
    EXPECT_EQ(notices[Notices::kKept - 1].sentence, "h");
}

TEST(Notices, count_a_sentence_that_is_told_again_while_it_is_seen) {
    Notices notices;
    notices.tell(Kind::kInfo, "saved", 0);
    notices.tell(Kind::kInfo, "saved", 5);
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_EQ(notices[0].times, 2);
    EXPECT_EQ(notices[0].told_s, 5);
    notices.tell(Kind::kWarning, "saved", 5);  // another kind is another notice
    EXPECT_EQ(notices.size(), 2u);
}

TEST(Notices, tell_a_sentence_anew_once_it_has_gone) {
    Notices notices;
    notices.tell(Kind::kInfo, "saved", 0);
    notices.tell(Kind::kInfo, "saved", Notices::kInfoStays + 0.1);
    ASSERT_EQ(notices.size(), 2u);
    EXPECT_EQ(notices[1].times, 1);
}

TEST(Notices, fade_over_their_last_second_warnings_later) {
    Notice notice{Kind::kInfo, "", 10, 1};
    EXPECT_EQ(Notices::strength(notice, 10), 1);
    EXPECT_EQ(Notices::strength(notice, 10 + Notices::kInfoStays - 1), 1);
    EXPECT_DOUBLE_EQ(Notices::strength(notice, 10 + Notices::kInfoStays - 0.25), 0.25);
    EXPECT_EQ(Notices::strength(notice, 10 + Notices::kInfoStays), 0);
    notice.kind = Kind::kWarning;
    EXPECT_EQ(Notices::strength(notice, 10 + Notices::kInfoStays), 1);
    EXPECT_EQ(Notices::strength(notice, 10 + Notices::kWarningStays), 0);
}

}  // namespace
}  // namespace game::test
