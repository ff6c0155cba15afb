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
    input.take(events, {}, {.mouse = false, .keys = KeysKept::kOfText}, actions);
    ASSERT_EQ(actions.size(), 1u);
    EXPECT_EQ(std::get<Verb>(actions[0]), Verb::kScreenshot);
}

TEST(KeyMap, has_no_key_that_does_two_things_after_any_change) {
    KeyMap map;
    const std::vector<Chord> chords{{key('W'), {}},        {key('W'), {true, false, false}},
                                    {Key::kSpace, {}},     {key('Z'), {false, true, false}},
                                    {key('K'), {}},        {Key::kEscape, {}},
                                    {function_key(9), {}}, {}};
    for (std::size_t row = 0; row < map.size(); ++row)
        for (const Chord chord : chords) {
            if (!map.accepts(row, chord)) continue;
            map.bind(row, chord);
            EXPECT_EQ(map.at(row), chord);
            for (std::size_t each = 0; each < map.size(); ++each)
                EXPECT_FALSE(map.conflict(each, map.at(each))) << map.name(each);
        }
}

TEST(KeyMap, gives_a_held_key_no_modifier_and_no_action_a_bare_one) {
    const KeyMap map;
    const std::size_t held = map.presses().size();
    EXPECT_TRUE(map.accepts(held, {key('K'), {}}));
    EXPECT_FALSE(map.accepts(held, {key('K'), {true, false, false}}));
    for (const Key bare : {Key::kShift, Key::kControl, Key::kAlt}) {
        EXPECT_FALSE(map.accepts(0, {bare, {}}));
        EXPECT_FALSE(map.accepts(held, {bare, {}}));
    }
}

TEST(KeyMap, reads_the_names_of_all_keys_that_it_writes) {
    std::set<std::string_view> names;
    for (std::size_t row = 0; row < kUsual.size(); ++row) {
        EXPECT_EQ(chord_of(text_of(kUsual.at(row))), kUsual.at(row)) << text_of(kUsual.at(row));
        EXPECT_TRUE(names.insert(kUsual.name(row)).second) << kUsual.name(row);
    }
    EXPECT_EQ(chord_of(""), Chord{});
    EXPECT_EQ(chord_of("Ctrl+Alt+Shift+\\"), (Chord{key('\\'), {true, true, true}}));
    for (const char* none : {"Ctrl+", "Hyper+A", "a", "F13", "Shift+Ctrl+A", " "})
        EXPECT_FALSE(chord_of(none)) << none;
}

TEST(Input, obeys_a_changed_map_and_none_but_the_program_s_keys_beside_the_menu) {
    KeyMap map;
    Input input(map);
    const auto verbs = [&](Key key, KeysKept kept) {
        Actions actions;
        input.take(std::vector<Event>{KeyEvent{key, true, false, {}}}, {}, {.keys = kept}, actions);
        return actions.size();
    };
    for (std::size_t row = 0; row < map.size(); ++row)
        if (map.name(row) == "pause") map.bind(row, {key('K'), {}});
    EXPECT_EQ(verbs(Key::kSpace, KeysKept::kNone), 0u);
    EXPECT_EQ(verbs(key('K'), KeysKept::kNone), 1u);
    EXPECT_EQ(verbs(key('K'), KeysKept::kOfWorld), 0u);
    EXPECT_EQ(verbs(Key::kEscape, KeysKept::kOfWorld), 1u);
    EXPECT_EQ(verbs(function_key(12), KeysKept::kOfWorld), 1u);
    EXPECT_EQ(verbs(function_key(12), KeysKept::kAll), 0u);
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
