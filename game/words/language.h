#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// A language to choose: "de", "Deutsch".
struct LanguageChoice {
    std::string code, name;
};

// The messages of one language, from a gettext catalogue (.po; GNU gettext manual, "The Format of PO Files").
class Language {
  public:
    // Reads the text of a file at run time, so that a new language is a file and nothing is built. Messages without words and
    // those marked fuzzy are left out; they are shown in English. Contexts and plurals are not known. Errors: it is damaged or
    // too large, is not in UTF-8, or has other placeholders than the English message (2), each with file and line.
    static Outcome<Language> from_text(std::string_view text, const std::string& file);

    // Null: none.
    const std::string* find(std::string_view english) const {
        const auto found = words_.find(english);
        return found == words_.end() ? nullptr : &found->second;
    }
    // "de", and "Deutsch": Language and X-Language-Name of its header.
    const std::string& code() const { return code_; }
    const std::string& name() const { return name_; }
    // Of all messages with words.
    std::vector<std::string_view> messages() const;

  private:
    struct Hash : std::hash<std::string_view> {
        using is_transparent = void;
    };
    std::unordered_map<std::string, std::string, Hash, std::equal_to<>> words_;
    std::string code_, name_;

    friend class LanguageReader;
};

// Whether both have the same placeholders for the same values: fields of fmt ("{:.1f}") if the first has a {, else directives
// of printf ("%.1f").
bool same_placeholders(std::string_view one, std::string_view other);

}  // namespace game
