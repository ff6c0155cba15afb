#include "tests/support/literals.h"

#include <algorithm>
#include <cctype>

namespace support {
namespace {

bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

class Reader {
  public:
    explicit Reader(std::string_view source) : left_(source) {}

    std::vector<Literal> read() && {
        while (!left_.empty()) {
            const char c = left_[0];
            if (left_.starts_with("//") || (begins_line_ && c == '#')) {
                skip_until('\n');
            } else if (c == '"') {
                take_text();
            } else if (c == '\'') {
                take_character();
            } else if (is_name(c)) {
                take_name();
            } else {
                take_sign(c);
            }
        }
        return std::move(found_);
    }

  private:
    void advance(std::size_t count) {
        line_ += static_cast<int>(std::ranges::count(left_.substr(0, count), '\n'));
        left_.remove_prefix(std::min(count, left_.size()));
    }
    void skip_until(char end) { advance(std::min(left_.find(end), left_.size())); }

    void take_text() {
        begins_line_ = false;
        if (!follows_) found_.push_back({"", callers_.empty() ? "" : callers_.back(), line_});
        std::string& text = found_.back().text;
        advance(1);
        while (!left_.empty() && left_[0] != '"') {
            if (left_[0] == '\\' && left_.size() > 1) {
                text += left_[1] == 'n' ? '\n' : left_[1] == 't' ? '\t' : left_[1];
                advance(2);
            } else {
                text += left_[0];
                advance(1);
            }
        }
        advance(1);
        follows_ = true;
    }

    void take_character() {
        follows_ = begins_line_ = false;
        advance(1);
        while (!left_.empty() && left_[0] != '\'') advance(left_[0] == '\\' ? 2 : 1);
        advance(1);
    }

    // A number too: the ' within 1'000 begins no character.
    void take_name() {
        follows_ = begins_line_ = false;
        const bool is_number = std::isdigit(static_cast<unsigned char>(left_[0])) != 0;
        const auto goes_on = [&](char c) { return is_name(c) || (is_number && (c == '\'' || c == '.')); };
        std::size_t length = 1;
        while (length < left_.size() && goes_on(left_[length])) ++length;
        name_ = left_.substr(0, length);
        advance(length);
    }

    void take_sign(char c) {
        if (c == '\n') begins_line_ = true;
        const bool is_space = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!is_space) follows_ = begins_line_ = false;
        if (c == '(' || c == '{') callers_.push_back(name_);
        if ((c == ')' || c == '}') && !callers_.empty()) callers_.pop_back();
        if (!is_space) name_.clear();
        advance(1);
    }

    std::string_view left_;
    std::vector<Literal> found_;
    std::vector<std::string> callers_;
    std::string name_;  // just before
    bool follows_ = false, begins_line_ = true;
    int line_ = 1;
};

}  // namespace

std::vector<Literal> literals_in(std::string_view source) {
    return Reader(source).read();
}

}  // namespace support
