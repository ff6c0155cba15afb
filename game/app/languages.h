#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "game/base/outcome.h"
#include "game/words/language.h"

namespace game {

// The languages of the window: English, which is in the program, and a catalogue each of others.
class Languages {
  public:
    // Those of assets/languages, and those that a person has put into couloir/languages of the XDG data folder, which come
    // before one of the same code. A file that cannot be read is left out, and told().
    static Languages of_user();
    // English alone.
    Languages() = default;

    const std::vector<LanguageChoice>& choices() const {
        return choices_;
    }                                                               // English first, the others by name
    const std::vector<std::string>& told() const { return told_; }  // what was wrong, a sentence each

    // Speaks the language of this code; an empty one: that of the system. English if there is none.
    void choose(std::string_view code);

  private:
    std::vector<LanguageChoice> choices_{{"en", "English"}};
    std::vector<std::shared_ptr<const Language>> read_{nullptr};  // as choices_
    std::vector<std::string> told_;
};

// Reads a catalogue. Errors: as Language::from_text() says; it cannot be read (3).
Outcome<Language> read_language(const std::filesystem::path& file);

// The code of the first language among these that the system asks for, by LANGUAGE, LC_ALL, LC_MESSAGES and LANG as
// gettext reads them; "en" if there is none.
std::string language_of_system(const std::vector<LanguageChoice>& choices);

}  // namespace game
