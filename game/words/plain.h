#pragma once

#include <span>
#include <string_view>

namespace game {

// Messages with words of the field, and the same in words that a newcomer knows. docs/glossary.md has the field's.
struct PlainWords {
    std::string_view of_field;
    const char* plain;  // with the same placeholders
};
std::span<const PlainWords> plain_words();

// Whether tr() says the plain ones from now on. For the thread of the window alone.
void speak_plainly(bool plainly);
bool speaks_plainly();

}  // namespace game
