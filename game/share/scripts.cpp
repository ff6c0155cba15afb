#include "game/share/scripts.h"

#include <fmt/format.h>

#include "game/base/one_line.h"
#include "game/recording/base64.h"
#include "game/share/sha256.h"

namespace game {

std::string names_of_scripts(std::string_view page) {
    constexpr std::string_view kBegin = "<script>", kEnd = "</script>";
    std::string names;
    for (auto at = page.find(kBegin); at != std::string_view::npos; at = page.find(kBegin, at)) {
        at += kBegin.size();
        const auto digest = sha256(page.substr(at, page.find(kEnd, at) - at));
        const std::string_view bytes(reinterpret_cast<const char*>(digest.data()), digest.size());
        names += fmt::format("{}'sha256-{}'", names.empty() ? "" : " ", to_base64(bytes));
    }
    return names;
}

std::string in_script(const Json& json) {
    std::string text;
    for (const char c : printable(json.dump(-1, ' ', false, Json::error_handler_t::replace)))
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

}  // namespace game
