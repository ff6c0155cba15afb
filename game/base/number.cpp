#include "game/base/number.h"

namespace game {

std::string with_decimal_point(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return {};
    std::string pointed(text);
    pointed[comma] = '.';
    return number_from<double>(pointed) ? pointed : std::string();
}

}  // namespace game
