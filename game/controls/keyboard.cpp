#include "game/controls/keyboard.h"

#include <string_view>

namespace game {
namespace {

constexpr std::u32string_view kMarks = U"',-./;=[\\]`";  // that a US keyboard prints without Shift
constexpr char32_t kEndOfLatin = 0x180;                  // the letters of the panels have no others

constexpr bool is_digit(char32_t character) {
    return character >= '0' && character <= '9';
}
constexpr bool is_letter(char32_t character) {
    return character >= 'a' && character <= 'z';
}
constexpr bool is_mark(char32_t character) {
    return kMarks.find(character) != std::u32string_view::npos;
}

constexpr char32_t capital(char32_t character) {
    const bool ascii = is_letter(character);
    const bool latin = character >= 0xe0 && character <= 0xfe && character != 0xf7;
    return ascii || latin ? character - ('a' - 'A') : character;
}

constexpr std::size_t key_index(Key key) {
    return static_cast<std::size_t>(key);
}
constexpr char32_t character_of(Key key) {
    return static_cast<char32_t>(key);
}

// The key that is named after a character; none if a US keyboard has no such key.
constexpr Key named_after(char32_t character) {
    return is_letter(character) || is_mark(character) ? static_cast<Key>(capital(character)) : Key::kNone;
}

// In UTF-8; below kEndOfLatin two bytes are enough.
std::string text_of(char32_t character) {
    if (character < 0x80) return {static_cast<char>(character)};
    return {static_cast<char>(0xc0 | (character >> 6)), static_cast<char>(0x80 | (character & 0x3f))};
}

}  // namespace

bool KeyboardLayout::is_place(Key place) {
    const char32_t character = character_of(place);
    return is_digit(character) || is_mark(character) || (character >= 'A' && character <= 'Z') ||
           place == Key::kExtra1 || place == Key::kExtra2;
}

KeyboardLayout::KeyboardLayout(const Printed& printed) : printed_(printed) {
    assign();
}

void KeyboardLayout::assign() {
    std::array<bool, kPlaces> is_printed{};
    for (std::size_t place = 0; place < kPlaces; ++place) {
        if (!is_place(static_cast<Key>(place)) || is_digit(static_cast<char32_t>(place))) continue;
        keys_[place] = named_after(printed_[place]);
        is_printed[key_index(keys_[place])] = true;
    }
    for (std::size_t place = 0; place < names_.size(); ++place) {
        const auto own = static_cast<Key>(place);
        if (!is_place(own)) continue;
        if (keys_[place] == Key::kNone && !is_printed[place]) {
            keys_[place] = own;
            if (!is_digit(character_of(own)) && printed_[place] < kEndOfLatin)
                names_[place] = capital(printed_[place]);
        }
    }
}

PressedKey KeyboardLayout::meaning(Key place, Modifiers with, bool alt_gr, char32_t typed) const {
    const Key alone = keys_[key_index(place)];
    if (alt_gr) with.control = with.alt = false;  // as which some systems report it
    if (with.control || with.alt) return {alone, with};
    const bool by_another_level = typed != 0 && typed != printed_[key_index(place)];
    if (by_another_level && (is_mark(typed) || is_digit(typed))) return {static_cast<Key>(typed), {}};
    const bool by_lock = by_another_level && !with.shift && is_digit(character_of(place));
    if (alt_gr || by_lock) return {};
    return {alone, with};
}

std::string KeyboardLayout::name_of(Key key) const {
    if (key_index(key) >= names_.size() || !is_place(key)) return {};
    const char32_t name = names_[key_index(key)];
    return text_of(name == 0 ? character_of(key) : name);
}

void Keyboard::press(std::size_t number, PressedKey key, std::vector<Event>& events) {
    settle(events);
    silent_.reset();
    down_[number] = {key.key};
    if (key.key != Key::kNone) events.emplace_back(KeyEvent{key.key, true, false, key.with});
}

void Keyboard::press(std::size_t number, Key place, Modifiers with, bool alt_gr, std::vector<Event>& events) {
    settle(events);
    silent_.reset();
    waiting_ = Press{number, place, with, alt_gr};
}

void Keyboard::repeat(std::size_t number, Modifiers with, std::vector<Event>& events) {
    settle(events);
    const Down& down = down_[number];
    if (down.key != Key::kNone)
        events.emplace_back(KeyEvent{down.key, true, true, down.alone ? Modifiers{} : with});
}

void Keyboard::release(std::size_t number, Modifiers with, std::vector<Event>& events) {
    settle(events);
    const Key key = down_[number].key;
    if (key != Key::kNone) events.emplace_back(KeyEvent{key, false, false, with});
}

void Keyboard::type(char32_t character, std::vector<Event>& events) {
    if (waiting_) {
        decide(*waiting_, character, events);
        waiting_.reset();
    } else if (silent_) {
        const PressedKey late = layout_.meaning(silent_->place, silent_->with, silent_->alt_gr, character);
        if (late.key != Key::kNone && late.key != down_[silent_->number].key) {
            events.emplace_back(KeyEvent{late.key, true, false, late.with});
            events.emplace_back(KeyEvent{late.key, false, false, silent_->with});
        }
        silent_.reset();
    }
    events.emplace_back(TextEvent{character});
}

void Keyboard::settle(std::vector<Event>& events) {
    if (!waiting_) return;
    decide(*waiting_, 0, events);
    silent_ = waiting_;
    waiting_.reset();
}

void Keyboard::decide(const Press& press, char32_t typed, std::vector<Event>& events) {
    const PressedKey key = layout_.meaning(press.place, press.with, press.alt_gr, typed);
    down_[press.number] = {key.key, key.with != press.with};
    if (key.key != Key::kNone) events.emplace_back(KeyEvent{key.key, true, false, key.with});
}

}  // namespace game
