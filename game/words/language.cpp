#include "game/words/language.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/base/one_line.h"

namespace game {
namespace {

// What takes each value, by its number from 1: ".1f" of "%.1f" for the first.
using Placeholders = std::map<std::size_t, std::string>;

// Takes "2$" or "1" from the beginning of `text`; nothing: no number with this end is there.
std::optional<std::size_t> take_number(std::string_view& text, std::string_view ends) {
    const std::size_t digits = text.find_first_not_of("0123456789");
    if (digits == 0 || digits > 2 || digits == text.npos || ends.find(text[digits]) == text.npos)
        return std::nullopt;
    std::size_t number = 0;
    for (const char digit : text.substr(0, digits))
        number = 10 * number + static_cast<std::size_t>(digit - '0');
    text.remove_prefix(digits);
    return number;
}

// Of a text for fmt, or else for printf. Nothing: it could not be used.
std::optional<Placeholders> placeholders_of(std::string_view text, bool is_fmt) {
    Placeholders all;
    std::size_t counted = 0;  // without a number of their own
    bool has_number = false, has_stars = false;
    const char* const signs = is_fmt ? "{}" : "%";
    for (std::size_t at = text.find_first_of(signs); at != text.npos; at = text.find_first_of(signs)) {
        const char kind = text[at];
        text.remove_prefix(at + 1);
        if (text.starts_with(kind)) {  // "%%", "{{", "}}"
            text.remove_prefix(1);
            continue;
        }
        if (kind == '}') return std::nullopt;
        auto number = take_number(text, is_fmt ? ":}" : "$");
        has_number |= number.has_value();
        if (!number)
            number = ++counted;
        else if (is_fmt)
            ++*number;
        else
            text.remove_prefix(1);
        const std::size_t end = is_fmt ? text.find('}') : text.find_first_not_of("-+ #'0123456789.*hlqjzt");
        if (end == text.npos) return std::nullopt;
        const std::string_view rest = text.substr(0, end + 1);
        has_stars |= rest.find('*') != rest.npos;
        if (!all.emplace(*number, rest).second) return std::nullopt;
        text.remove_prefix(rest.size());
    }
    if (has_number && (counted > 0 || has_stars)) return std::nullopt;
    return all;
}

}  // namespace

bool same_placeholders(std::string_view one, std::string_view other) {
    const bool is_fmt = one.find('{') != one.npos;
    const auto of_one = placeholders_of(one, is_fmt);
    return of_one && of_one == placeholders_of(other, is_fmt);
}

std::vector<std::string_view> Language::messages() const {
    std::vector<std::string_view> all;
    all.reserve(words_.size());
    for (const auto& [english, words] : words_) all.emplace_back(english);
    return all;
}

// Takes a catalogue line by line.
class LanguageReader {
  public:
    explicit LanguageReader(const std::string& file) : file_(file) {}

    Outcome<Language> read(std::string_view text) && {
        while (!text.empty() && !fault_) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            ++line_;
            std::string_view line = text.substr(0, end);
            if (line.ends_with('\r')) line.remove_suffix(1);
            take(line);
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        finish_entry();
        if (!fault_ && !has_header_) blame("has no header: an entry whose msgid is \"\"");
        if (fault_) return unusable(*fault_);
        return std::move(read_);
    }

  private:
    enum class Part { kNone, kId, kWords };

    void blame(const std::string& what) {
        if (!fault_) fault_ = fmt::format("{}:{}: {}", file_, line_, what);
    }

    void take(std::string_view line) {
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == line.npos) return;
        line.remove_prefix(begin);
        if (line[0] == '#') {
            if (part_ == Part::kWords) finish_entry();
            if (line.starts_with("#,") && line.find("fuzzy") != line.npos) is_fuzzy_ = true;
            return;
        }
        if (line[0] == '"') return part_ == Part::kNone ? blame("a text without msgid") : add(line);
        const std::size_t end = std::min(line.find_first_of(" \t\""), line.size());
        const std::string_view word = line.substr(0, end);
        line.remove_prefix(std::min(line.find_first_not_of(" \t", end), line.size()));
        if (word == "msgid") {
            finish_entry();
            part_ = Part::kId;
            first_ = line_;
        } else if (word == "msgstr") {
            if (part_ != Part::kId) return blame("msgstr without msgid");
            part_ = Part::kWords;
        } else if (word == "msgctxt" || word == "msgid_plural" || word.starts_with("msgstr[")) {
            return blame(fmt::format("{}: contexts and plurals are not used here", word));
        } else {
            return blame("begins with neither #, \", msgid nor msgstr");
        }
        add(line);
    }

    // Adds a text in quotation marks to the part that is under way.
    void add(std::string_view quoted) {
        std::string& to = part_ == Part::kId ? id_ : words_;
        while (quoted.ends_with(' ') || quoted.ends_with('\t')) quoted.remove_suffix(1);
        if (quoted.size() < 2 || quoted.front() != '"') return blame("no text in quotation marks");
        for (std::size_t i = 1; i < quoted.size(); ++i) {
            const char c = quoted[i];
            if (c == '"') {
                if (i + 1 < quoted.size()) blame("something follows the text in quotation marks");
                if (to.size() > kLongestMessage)
                    blame(fmt::format("a text of more than {} bytes", kLongestMessage));
                return;
            }
            if (c != '\\') {
                to += c;
                continue;
            }
            const char escaped = ++i < quoted.size() ? quoted[i] : ' ';
            constexpr std::string_view kEscaped = "n\"\\", kMeant = "\n\"\\";
            const std::size_t which = kEscaped.find(escaped);
            if (which == kEscaped.npos)
                return blame(fmt::format("\\{} is no escape that is used here", escaped));
            to += kMeant[which];
        }
        blame("a text whose quotation mark does not close");
    }

    void finish_entry() {
        const Part part = std::exchange(part_, Part::kNone);
        const bool fuzzy = part == Part::kNone ? false : std::exchange(is_fuzzy_, false);
        const std::string id = std::exchange(id_, {}), words = std::exchange(words_, {});
        if (fault_ || part == Part::kNone) return;
        const int here = std::exchange(line_, first_);
        if (part == Part::kId)
            blame("msgid without msgstr");
        else if (id.empty())
            take_header(words);
        else if (!words.empty() && !fuzzy)
            take_entry(id, words);
        line_ = here;
    }

    void take_entry(const std::string& id, const std::string& words) {
        if (!is_utf8(words) || printable(words) != words)
            return blame(fmt::format("\"{}\": not UTF-8, or has signs that cannot be seen", one_line(id)));
        if (!same_placeholders(id, words))
            return blame(
                fmt::format("\"{}\": the placeholders of \"{}\" differ", one_line(id), one_line(words)));
        if (!read_.words_.emplace(id, words).second) return blame(fmt::format("\"{}\" is there twice", id));
        if (read_.words_.size() > kMostMessages) blame(fmt::format("more than {} messages", kMostMessages));
    }

    void take_header(const std::string& header) {
        if (std::exchange(has_header_, true)) return blame("a second header");
        const auto field = [&](std::string_view name) -> std::string {
            const std::size_t at = ("\n" + header).find(fmt::format("\n{}:", name));
            if (at == header.npos || at >= header.size()) return "";
            std::string value = header.substr(at + name.size() + 1);
            value.resize(std::min(value.find('\n'), value.size()));
            const std::size_t begin = std::min(value.find_first_not_of(' '), value.size());
            return value.substr(begin, value.find_last_not_of(" \r") + 1 - begin);
        };
        if (field("Content-Type").find("charset=UTF-8") == std::string::npos)
            return blame("Content-Type does not say charset=UTF-8");
        read_.code_ = field("Language");
        read_.name_ = field("X-Language-Name");
        const auto is_name = [](const std::string& name) {
            return !name.empty() && name.size() < 24 && one_line(name) == name;
        };
        if (!is_name(read_.code_)) blame("Language is no short name, such as de");
        if (!is_name(read_.name_)) blame("X-Language-Name is no short name, such as Deutsch");
    }

    const std::string& file_;
    Language read_;
    std::optional<std::string> fault_;
    int line_ = 0, first_ = 0;  // that of the entry under way
    Part part_ = Part::kNone;
    bool is_fuzzy_ = false, has_header_ = false;
    std::string id_, words_;
};

Outcome<Language> Language::from_text(std::string_view text, const std::string& file) {
    if (text.size() > kMostLanguageBytes)
        return unusable(fmt::format("{}: more than {} bytes", file, kMostLanguageBytes));
    return LanguageReader(file).read(text);
}

}  // namespace game
