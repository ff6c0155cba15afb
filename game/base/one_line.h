#pragma once

#include <string>
#include <string_view>

namespace game {

// What must not reach a terminal, a window or a page from text that somebody else wrote: control characters (escape
// sequences, NUL, those of ISO 8859-1), characters that turn the direction of text or separate lines, invisible ones
// with which two names look alike, and code points that are no characters. Text that is not UTF-8 keeps its bytes,
// but for those from 0x80 to 0x9f, which are controls of ISO 8859-1.

bool is_utf8(std::string_view text);

// The text as it is printed: each such character becomes '?'. Line breaks stay.
std::string printable(const std::string& text);

// The same for a sentence, whose line breaks become '?' too.
std::string one_line(const std::string& sentence);

// The same for JSON, which has the means to keep them: \u202e. Of those beyond U+FFFF it makes surrogates.
std::string printable_json(const std::string& json);

}  // namespace game
