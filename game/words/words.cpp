#include "game/words/words.h"

#include <algorithm>

#include "game/words/plain.h"

namespace game {
namespace {

std::shared_ptr<const Language> chosen;  // one for the whole window, as its reader is one

const PlainWords* plain_of(std::string_view english) {
    const auto all = plain_words();
    const auto found = std::ranges::lower_bound(all, english, {}, &PlainWords::of_field);
    return found != all.end() && found->of_field == english ? &*found : nullptr;
}

[[gnu::format_arg(1)]] const char* plain_or(const char* english) {
    const PlainWords* const found = speaks_plainly() ? plain_of(english) : nullptr;
    return found ? found->plain : english;
}

}  // namespace

void speak(std::shared_ptr<const Language> language) {
    chosen = std::move(language);
}

const char* tr(const char* english) {
    if (!english) return nullptr;
    const char* const message = plain_or(english);
    const std::string* const words = chosen ? chosen->find(message) : nullptr;
    return words ? words->c_str() : message;
}

std::string_view tr(std::string_view english) {
    if (speaks_plainly())
        if (const PlainWords* const found = plain_of(english)) english = found->plain;
    const std::string* const words = chosen ? chosen->find(english) : nullptr;
    return words ? *words : english;
}

}  // namespace game
