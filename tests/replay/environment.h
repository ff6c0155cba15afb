#pragma once

#include <cstdint>
#include <cstdlib>

#include "game/base/number.h"

namespace game::test {

// A whole number from the environment, or else `otherwise`.
inline std::uint64_t number_of(const char* variable, std::uint64_t otherwise) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? otherwise : number_from<std::uint64_t>(text).value();
}

}  // namespace game::test
