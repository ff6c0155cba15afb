#include "game/controls/keyboard.h"

#include <map>

#include <gtest/gtest.h>

#include "game/controls/key_map.h"
#include "tests/support/layouts.h"

namespace game::test {
namespace {

using support::layout;

constexpr Modifiers kNone{}, kShift{true, false, false}, kControl{false, true, false};

// The key there alone, or with Shift or AltGr, typing that.
Key alone(const char* name, char place, char32_t typed = 0) {
    return layout(name).meaning(key(place), kNone, false, typed).key;
}
PressedKey shifted(const char* name, char place, char32_t typed) {
    return layout(name).meaning(key(place), kShift, false, typed);
}
PressedKey with_alt_gr(const char* name, char place, char32_t typed) {
    return layout(name).meaning(key(place), kNone, true, typed);
}
PressedKey just(char which) {
    return {key(which), {}};
}

TEST(Keyboard, of_the_us_does_what_its_keys_are_named_after) {
    for (const char* name : {"us", "unknown"})
        for (int i = 0; i < 128; ++i) {
            const auto place = static_cast<Key>(i);
            if (!KeyboardLayout::is_place(place)) continue;
            const auto lower = static_cast<char32_t>(i >= 'A' && i <= 'Z' ? i + 'a' - 'A' : i);
            const PressedKey expected{place, {}}, with_shift{place, kShift};
            EXPECT_EQ(layout(name).meaning(place, kNone, false, lower), expected) << name << i;
            EXPECT_EQ(layout(name).meaning(place, kShift, false, '{'), with_shift) << name << i;
            EXPECT_EQ(layout(name).name_of(place), std::string(1, static_cast<char>(i)));
        }
}

TEST(Keyboard, reaches_every_key_of_the_map_without_shift_and_by_one_key_on_each_layout) {
    for (const char* name : support::kLayouts) {
        std::map<Key, int> reached;
        for (std::size_t i = 0; i < KeyboardLayout::kPlaces; ++i)
            if (const auto place = static_cast<Key>(i); KeyboardLayout::is_place(place))
                ++reached[layout(name).meaning(place, kNone, false, 0).key];
        const KeyMap map;
        for (const KeyBinding& binding : map.presses())
            if (KeyboardLayout::is_place(binding.key)) {
                EXPECT_EQ(reached[binding.key], 1) << name << " " << static_cast<char>(binding.key);
            }
        for (const HeldBinding& binding : map.holds())
            if (KeyboardLayout::is_place(binding.key)) {
                EXPECT_EQ(reached[binding.key], 1) << name << " " << static_cast<char>(binding.key);
            }
    }
}

TEST(Keyboard, takes_letters_and_marks_from_the_key_that_prints_them) {
    EXPECT_EQ(alone("de", 'Y', 'z'), key('Z'));
    EXPECT_EQ(layout("de").meaning(key('Y'), kControl, false, 0), (PressedKey{key('Z'), kControl}));
    EXPECT_EQ(alone("de", '/', '-'), Key::kMinus);
    EXPECT_EQ(alone("de", '-', U'ß'), Key::kNone) << "it would slow time down";
    EXPECT_EQ(alone("fr", 'M', ','), Key::kComma);
    EXPECT_EQ(alone("fr", ';', 'm'), key('M'));
    EXPECT_EQ(alone("dvorak", '-', '['), Key::kLeftBracket);
    EXPECT_EQ(alone("dvorak", '[', '/'), key('/'));
}

TEST(Keyboard, takes_what_no_key_prints_alone_from_its_place) {
    EXPECT_EQ(alone("de", '[', U'ü'), Key::kLeftBracket);
    EXPECT_EQ(shifted("de", '[', U'Ü'), (PressedKey{Key::kLeftBracket, kShift}));
    EXPECT_EQ(alone("se", ']'), Key::kRightBracket) << "a dead key types nothing";
    EXPECT_EQ(alone("fr", '-', ')'), Key::kMinus);
    EXPECT_EQ(alone("ru", 'W', U'ц'), key('W'));
    EXPECT_EQ(alone("ru", '/', '.'), Key::kPeriod);
}

TEST(Keyboard, takes_a_mark_that_is_typed_with_shift_or_alt_gr_as_the_mark_alone) {
    EXPECT_EQ(with_alt_gr("de", '8', '['), just('['));
    EXPECT_EQ(with_alt_gr("de", '9', ']'), just(']'));
    EXPECT_EQ(with_alt_gr("fr", '5', '['), just('['));
    EXPECT_EQ(with_alt_gr("ch", '[', '['), just('['));
    EXPECT_EQ(shifted("de", '0', '='), just('='));
    EXPECT_EQ(shifted("ch", '0', '='), just('='));
    EXPECT_EQ(shifted("fr", ',', '.'), just('.'));
    // As Windows reports AltGr.
    EXPECT_EQ(layout("de").meaning(key('8'), {false, true, true}, true, '['), just('['));
}

TEST(Keyboard, does_nothing_for_other_characters_of_alt_gr) {
    EXPECT_EQ(with_alt_gr("de", 'Q', '@'), PressedKey{});
    EXPECT_EQ(with_alt_gr("de", '7', '{'), PressedKey{});
    EXPECT_EQ(with_alt_gr("de", '3', 0), PressedKey{}) << "it may be dead";
    EXPECT_EQ(alone("de", '8', '{'), Key::kNone) << "a lock may do what AltGr does";
}

TEST(Keyboard, takes_digits_from_their_places_with_shift_or_without) {
    for (const char* name : support::kLayouts)
        for (char digit = '0'; digit <= '9'; ++digit) EXPECT_EQ(alone(name, digit), key(digit)) << name;
    EXPECT_EQ(alone("fr", '6', '-'), key('6'));
    EXPECT_EQ(shifted("fr", '6', '6'), just('6'));
    EXPECT_EQ(shifted("de", '8', '('), (PressedKey{key('8'), kShift})) << "which does nothing";
}

TEST(Keyboard, names_keys_as_they_are_printed) {
    EXPECT_EQ(name_of(layout("de"), Key::kLeftBracket), "Ü");
    EXPECT_EQ(name_of(layout("de"), Key::kLeftBracket, kShift), "Shift+Ü");
    EXPECT_EQ(name_of(Keys{layout("de"), KeyMap()}, Verb::kUndo), "Ctrl+Z");
    EXPECT_EQ(name_of(layout("de"), Key::kMinus), "-");
    EXPECT_EQ(name_of(layout("de"), Key::kEqual), "=") << "the key there is dead";
    EXPECT_EQ(name_of(layout("fr"), Key::kMinus), ")");
    EXPECT_EQ(name_of(layout("fr"), key('6')), "6");
    EXPECT_EQ(name_of(layout("se"), Key::kLeftBracket), "Å");
    EXPECT_EQ(name_of(layout("ru"), key('W')), "W") << "the panels have no Russian letters";
    EXPECT_EQ(name_of(Keys{layout("fr"), KeyMap()}, Verb::kToggleHelp), "F1");
    EXPECT_EQ(names_of_walking(Keys{layout("fr"), KeyMap()}), "W A S D");
}

// "+[ -[": the keys in order, pressed (+), repeated (*) or released (-), with ^ if Shift counts; typed text in quotes.
std::string text_of(const std::vector<Event>& events) {
    std::string text;
    for (const Event& event : events) {
        if (!text.empty()) text += ' ';
        if (const auto* const key = std::get_if<KeyEvent>(&event)) {
            text += key->repeat ? '*' : key->down ? '+' : '-';
            if (key->with.shift) text += '^';
            text += static_cast<char>(key->key);
        } else if (const auto* const typed = std::get_if<TextEvent>(&event)) {
            text += {'"', static_cast<char>(typed->character), '"'};
        }
    }
    return text;
}

struct Typing {
    explicit Typing(const char* name) { keyboard.set(layout(name)); }
    void press(char place, Modifiers with = {}, bool alt_gr = false) {
        keyboard.press(static_cast<std::size_t>(place), key(place), with, alt_gr, events);
    }
    void repeat(char place, Modifiers with = {}) {
        keyboard.repeat(static_cast<std::size_t>(place), with, events);
    }
    void release(char place, Modifiers with = {}) {
        keyboard.release(static_cast<std::size_t>(place), with, events);
    }
    void type(char32_t character) { keyboard.type(character, events); }
    Keyboard keyboard{256};
    std::vector<Event> events;
};

TEST(Keyboard, repeats_and_releases_the_key_that_was_pressed) {
    Typing hand("de");
    hand.press('0', kShift);
    hand.type('=');
    hand.repeat('0', kShift);
    hand.type('=');
    hand.release('0');
    EXPECT_EQ(text_of(hand.events), R"(+= "=" *= "=" -=)");
}

TEST(Keyboard, tells_of_shift_that_is_pressed_while_a_key_repeats) {
    Typing hand("us");
    hand.press('W');
    hand.type('w');
    hand.repeat('W', kShift);
    hand.type('W');
    hand.release('W', kShift);
    EXPECT_EQ(text_of(hand.events), R"(+W "w" *^W "W" -^W)");
}

TEST(Keyboard, waits_for_the_character_of_a_press_and_no_longer) {
    Typing hand("us");
    hand.press('A');
    EXPECT_EQ(text_of(hand.events), "");
    hand.press('S');
    EXPECT_EQ(text_of(hand.events), "+A");
    hand.keyboard.settle(hand.events);
    hand.keyboard.settle(hand.events);
    EXPECT_EQ(text_of(hand.events), "+A +S");
}

// As input methods send it.
TEST(Keyboard, takes_a_mark_whose_character_comes_later) {
    Typing hand("de");
    hand.press('8', kNone, true);
    hand.keyboard.settle(hand.events);
    hand.release('8');
    hand.type('[');
    EXPECT_EQ(text_of(hand.events), R"(+[ -[ "[")");
    hand.events.clear();
    hand.press('W');
    hand.keyboard.settle(hand.events);
    hand.type('w');
    EXPECT_EQ(text_of(hand.events), R"(+W "w")") << "that does nothing twice";
}

}  // namespace
}  // namespace game::test
