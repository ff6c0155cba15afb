#include "tests/fuzz/try_reader.h"

#include "game/base/one_line.h"
#include "game/files/text_file.h"
#include "game/words/language.h"

namespace game::test {
namespace {

Outcome<void> try_language(const std::filesystem::path& file) {
    const auto text = read_text(file);
    if (!text) return tl::unexpected(text.error());
    const auto language = Language::from_text(*text, file.string());
    if (!language) return tl::unexpected(language.error());
    if (language->code().empty() || language->name().empty()) return broken("a language without a name");
    for (const std::string_view message : language->messages()) {
        const std::string* const words = language->find(message);
        if (!words || words->empty()) return broken("a message without words");
        // They are formats of printf and fmt: another placeholder would read what is not there.
        if (!same_placeholders(message, *words)) return broken("other placeholders than the message has");
        if (!is_utf8(*words)) return broken("words that are not UTF-8");
    }
    return {};
}

}  // namespace

const TriedReader kTriedLanguage{"language", "x.po", try_language};

}  // namespace game::test
