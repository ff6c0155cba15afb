#include "game/words/words.h"

namespace game {
namespace {

std::shared_ptr<const Language> chosen;  // one for the whole window, as its reader is one

}  // namespace

void speak(std::shared_ptr<const Language> language) {
    chosen = std::move(language);
}

const char* tr(const char* english) {
    const std::string* const words = chosen && english ? chosen->find(english) : nullptr;
    return words ? words->c_str() : english;
}

std::string_view tr(std::string_view english) {
    const std::string* const words = chosen ? chosen->find(english) : nullptr;
    return words ? *words : english;
}

}  // namespace game
