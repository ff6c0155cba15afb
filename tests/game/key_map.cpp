#include "game/controls/key_map.h"

#include <set>

#include <gtest/gtest.h>

#include "game/controls/input.h"

namespace game::test {
namespace {

const KeyMap kUsual;

TEST(KeyMap, binds_no_key_twice) {
    std::set<std::string> names;
    for (const KeyBinding& binding : kUsual.presses())
        EXPECT_TRUE(names.insert(name_of({}, binding.key, binding.with)).second) << binding.meaning;
    // Keys to hold act with any modifier but Ctrl, so that even their bare key must be free.
    for (const HeldBinding& binding : kUsual.holds())
        EXPECT_TRUE(names.insert(name_of({}, binding.key)).second) << binding.meaning;
}

TEST(KeyMap, binds_every_verb_every_tool_and_everything_that_is_held) {
    std::set<Verb> verbs;
    std::set<Tool> tools;
    for (const KeyBinding& binding : kUsual.presses())
        if (const Verb* verb = std::get_if<Verb>(&binding.does))
            verbs.insert(*verb);
        else
            tools.insert(std::get<Tool>(binding.does));
    EXPECT_EQ(verbs.size(), kVerbs);
    EXPECT_EQ(tools.size(), kTools);
    std::set<Held> held;
    for (const HeldBinding& binding : kUsual.holds()) held.insert(binding.held);
    EXPECT_EQ(held.size(), 6u);
}

TEST(KeyMap, gives_one_meaning_to_each_gesture_of_the_hand) {
    std::set<std::pair<int, bool>> hands;
    for (const GestureBinding& binding : gesture_bindings())
        EXPECT_TRUE(
            hands.insert({binding.button ? static_cast<int>(*binding.button) : -1, binding.shift}).second)
            << binding.hand;
    std::set<Gesture> gestures;
    for (const GestureBinding& binding : gesture_bindings()) gestures.insert(binding.gesture);
    EXPECT_EQ(gestures.size(), 5u);
}

TEST(KeyMap, says_something_of_every_binding) {
    for (const KeyBinding& binding : kUsual.presses()) {
        EXPECT_FALSE(binding.meaning.empty());
        EXPECT_FALSE(name_of({}, binding.key, binding.with).empty()) << binding.meaning;
    }
    for (const HeldBinding& binding : kUsual.holds()) EXPECT_FALSE(name_of({}, binding.key).empty());
}

TEST(KeyMap, names_keys_as_they_are_printed_on_keyboards) {
    EXPECT_EQ(name_of({}, key('Z'), {false, true, false}), "Ctrl+Z");
    EXPECT_EQ(name_of({}, Key::kLeftBracket, {true, false, false}), "Shift+[");
    EXPECT_EQ(name_of({}, Key::kSpace), "Space");
    EXPECT_EQ(name_of({}, function_key(1)), "F1");
    EXPECT_EQ(name_of({}, function_key(9)), "F9");
    EXPECT_EQ(name_of({}, function_key(10)), "F10");
    EXPECT_EQ(name_of({}, function_key(12)), "F12");
    EXPECT_EQ(name_of({}, Key::kPageDown), "PageDown");
    EXPECT_EQ(name_of({}, Key::kNone), "");
    EXPECT_EQ(name_of(Keys{{}, kUsual}, Verb::kToggleHelp), "F1");
}

TEST(KeyMap, hears_function_keys_but_no_others_while_a_number_is_typed) {
    const KeyMap map;
    Input input(map);
    Actions actions;
    const std::vector<Event> events{KeyEvent{key('T'), true, false, {}},
                                    KeyEvent{function_key(12), true, false, {}}};
    input.take(events, {}, {.mouse = false, .keys = true}, actions);
    ASSERT_EQ(actions.size(), 1u);
    EXPECT_EQ(std::get<Verb>(actions[0]), Verb::kScreenshot);
}

// On a slow machine the cursor is elsewhere by the end of the frame.
TEST(Input, knows_where_the_brush_was_released) {
    const KeyMap map;
    Input input(map);
    Actions actions;
    const ScreenSize size{200, 100, 1};
    input.take(std::vector<Event>{MoveEvent{100, 50}, ButtonEvent{Button::kLeft, true, {}}}, size, {},
               actions);
    EXPECT_TRUE(input.brush_held());
    EXPECT_FALSE(input.brush_released_at());
    input.take(
        std::vector<Event>{MoveEvent{150, 50}, ButtonEvent{Button::kLeft, false, {}}, MoveEvent{20, 90}},
        size, {}, actions);
    EXPECT_FALSE(input.brush_held());
    ASSERT_TRUE(input.brush_released_at());
    EXPECT_EQ(*input.brush_released_at(), glm::dvec2(0.5, 0));
    EXPECT_EQ(input.cursor()->y, 1 - 2 * 0.9);
    input.take({}, size, {}, actions);
    EXPECT_FALSE(input.brush_released_at());
}

}  // namespace
}  // namespace game::test
