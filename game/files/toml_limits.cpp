#include "game/files/toml_limits.h"

#include <algorithm>

#include <fmt/format.h>

#include "game/base/limits.h"

namespace game {
namespace {

// Scans a text once and counts what is outside comments and quotes.
class Scan {
  public:
    explicit Scan(std::string_view text) : text_(text) {}

    std::optional<TomlExcess> excess() {
        while (at_ < text_.size() && fact_.empty()) {
            const char c = text_[at_];
            if (c == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (c == '"' || c == '\'')
                skip_quoted(c);
            else
                count(c), ++at_;
        }
        if (fact_.empty()) return std::nullopt;
        return TomlExcess{line_, fact_};
    }

  private:
    void require(std::size_t count, std::size_t most, std::string_view what) {
        if (count > most) fact_ = fmt::format("over {} {}", most, what);
    }

    void count(char c) {
        if (c == '\n') ++line_;
        switch (c) {
            case '.':  // in a number too, which does no harm
                require(++parts_, kMostKeyParts, "parts of a key");
                break;
            case '=':
                if (parts_ > 1) require(++dotted_, kMostDottedKeys, "dotted keys");
                require(++keys_, kMostTomlKeys, "keys");
                break;
            case '[':
            case '{':
                require(++depth_, kMostTomlDepth, "nested lists and tables");
                break;
            case ']':
            case '}':
                if (parts_ > 1 && depth_ == 1) require(++dotted_, kMostDottedKeys, "dotted keys");
                depth_ -= depth_ > 0 ? 1 : 0;
                break;
            default:
                break;
        }
        if (c == '[' && depth_ == 1 && begins_line_) require(++keys_, kMostTomlKeys, "keys");
        if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') parts_ = 1;
        begins_line_ = c == '\n' || (begins_line_ && (c == ' ' || c == '\t'));
    }

    // A string in one or three quotes; an unterminated one ends with its line or the text.
    void skip_quoted(char quote) {
        begins_line_ = false;
        const std::string_view three = text_.substr(at_, 3);
        const bool many_lines = three.size() == 3 && three[1] == quote && three[2] == quote;
        at_ += many_lines ? 3 : 1;
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '\n') {
                if (!many_lines) return;
                ++line_;
            } else if (c == '\\' && quote == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') {
                ++at_;
            } else if (c == quote && !many_lines) {
                ++at_;
                return;
            } else if (c == quote && text_.substr(at_, 3) == three) {
                at_ += 3;
                while (at_ < text_.size() && text_[at_] == quote)
                    ++at_;  // two more quotes may belong to the string
                return;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool begins_line_ = true;
    std::size_t parts_ = 1, dotted_ = 0, keys_ = 0, depth_ = 0;
    std::string fact_;
};

}  // namespace

std::optional<TomlExcess> excess_of(std::string_view toml) {
    return Scan(toml).excess();
}

}  // namespace game
