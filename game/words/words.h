#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "game/words/language.h"

// What a person reads in the window is written in English where it is used, as with gettext, and shown in the language that was
// chosen. Errors and the command line stay English. assets/languages/README.md tells how a language is added.
namespace game {

// From now on tr() takes the words of this language; null: English. For the thread of the window alone.
void speak(std::shared_ptr<const Language> language);

// The message in the language that was chosen; itself if that has no words for it. A printf format stays one: a catalogue
// whose placeholders differ is not read.
[[gnu::format_arg(1)]] const char* tr(const char* english);
std::string_view tr(std::string_view english);

// A message in a table, which tr() is given later.
constexpr const char* message(const char* english) {
    return english;
}

// The same as tr() with values in its {}.
template <class... Values>
std::string said(fmt::format_string<Values...> english, Values&&... values) {
    const fmt::string_view message = english;
    const std::string_view words = tr(std::string_view(message.data(), message.size()));
    return fmt::vformat(fmt::string_view(words.data(), words.size()), fmt::make_format_args(values...));
}

}  // namespace game
