#include "game/share/filled.h"

#include <cstddef>

namespace game {

std::string filled(std::string_view text,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> slots) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const auto* found = slots.end();
        std::size_t first = std::string_view::npos;
        for (const auto& slot : slots)
            if (const std::size_t place = text.find(slot.first, at); place < first)
                first = place, found = &slot;
        out += text.substr(at, first - at);
        if (first == std::string_view::npos) break;
        out += found->second;
        at = first + found->first.size();
    }
    return out;
}

}  // namespace game
