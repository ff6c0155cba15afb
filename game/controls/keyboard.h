#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "game/controls/events.h"

namespace game {

// Keys by what they print. A place is where a key lies, called as that key of a US keyboard.

// A key as the key map knows it, and the modifiers that count.
struct PressedKey {
    Key key = Key::kNone;
    Modifiers with;
    bool operator==(const PressedKey&) const = default;
};

// What each key prints alone, and what it therefore does.
//
// A letter or mark is the key that prints it. If no key prints it alone, it is the key at its place, unless that key
// prints another letter or mark of a US keyboard. Digits are at their places, because on some keyboards they need Shift.
class KeyboardLayout {
  public:
    static constexpr std::size_t kPlaces = static_cast<std::size_t>(Key::kExtra2) + 1;
    // By place; 0: the key prints nothing alone, or it is not known what.
    using Printed = std::array<char32_t, kPlaces>;

    KeyboardLayout() : KeyboardLayout(Printed{}) {}  // US
    explicit KeyboardLayout(const Printed& printed);

    // Whether a key of this place may print something: a letter, digit or mark.
    static bool is_place(Key place);

    // What a press of the key there means. `typed`: the character that the press has typed with all that was held,
    // 0 if none. A mark of the key map that is typed with Shift or AltGr is the mark alone, whatever key that took.
    PressedKey meaning(Key place, Modifiers with, bool alt_gr, char32_t typed) const;

    // What is printed on the key, in capitals and UTF-8; the name on a US keyboard if the key prints nothing, or
    // no Latin letter. Empty if the key prints nothing on any keyboard.
    std::string name_of(Key key) const;

    bool operator==(const KeyboardLayout& other) const { return printed_ == other.printed_; }

  private:
    void assign();

    Printed printed_;
    std::array<Key, kPlaces> keys_{};    // by place
    std::array<char32_t, 128> names_{};  // by key; 0: as on a US keyboard
};

// Turns presses into events. The character that a press types comes after the press and decides what it means, so an
// event waits for it.
class Keyboard {
  public:
    explicit Keyboard(std::size_t keys) : down_(keys) {}

    const KeyboardLayout& layout() const { return layout_; }
    void set(const KeyboardLayout& layout) { layout_ = layout; }

    // `number` tells the keys of this keyboard apart: a release reports the same key as its press.
    void press(std::size_t number, PressedKey key,
               std::vector<Event>& events);  // prints nothing, or is on a keypad
    void press(std::size_t number, Key place, Modifiers with, bool alt_gr, std::vector<Event>& events);
    void repeat(std::size_t number, Modifiers with, std::vector<Event>& events);
    void release(std::size_t number, Modifiers with, std::vector<Event>& events);
    void type(char32_t character, std::vector<Event>& events);
    // No character follows the last press at once. To be called before any other event, and after the last one.
    void settle(std::vector<Event>& events);

  private:
    struct Down {
        Key key = Key::kNone;
        bool alone = false;  // what was held only served to type it
    };
    struct Press {
        std::size_t number;
        Key place;
        Modifiers with;
        bool alt_gr;
    };
    void decide(const Press& press, char32_t typed, std::vector<Event>& events);

    KeyboardLayout layout_;
    std::vector<Down> down_;        // by number: as it was reported
    std::optional<Press> waiting_;  // for its character
    std::optional<Press>
        silent_;  // the last press, if it had no character; an input method may send one later
};

}  // namespace game
