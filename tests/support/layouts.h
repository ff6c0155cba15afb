#pragma once

#include <array>
#include <string_view>

#include "game/controls/keyboard.h"

namespace support {

// Layouts of keyboards, by their names in X: what each key prints alone. A blank is a dead key.
inline constexpr std::array kLayouts{"us", "de", "fr", "ch", "se", "ru", "dvorak"};

inline game::KeyboardLayout layout(std::string_view name) {
    // From the row of digits down, each from the left, and last the key that a US keyboard lacks.
    constexpr std::u32string_view kPlaces = U"`1234567890-=QWERTYUIOP[]\\ASDFGHJKL;'ZXCVBNM,./\u00a1";
    struct Named {
        std::string_view name;
        std::u32string_view prints;
    };
    constexpr std::array kPrints{
        Named{"us", U"`1234567890-=qwertyuiop[]\\asdfghjkl;'zxcvbnm,./ "},
        Named{"de", U" 1234567890ß qwertzuiopü+#asdfghjklöäyxcvbnm,.-<"},
        Named{"fr", U"²&é\"'(-è_çà)=azertyuiop $*qsdfghjklmùwxcvbn,;:!<"},
        Named{"ch", U"§1234567890' qwertzuiopü $asdfghjklöäyxcvbnm,.-<"},
        Named{"se", U"§1234567890+ qwertyuiopå 'asdfghjklöäzxcvbnm,.-<"},
        Named{"ru", U"ё1234567890-=йцукенгшщзхъ\\фывапролджэячсмитьбю. "},
        Named{"dvorak", U"`1234567890[]',.pyfgcrl/=\\aoeuidhtns-;qjkxbmwvz "},
    };
    game::KeyboardLayout::Printed printed{};
    for (const Named& each : kPrints)
        for (std::size_t i = 0; each.name == name && i < kPlaces.size(); ++i)
            printed[kPlaces[i]] = each.prints[i] == ' ' ? 0 : each.prints[i];
    return game::KeyboardLayout(printed);
}

}  // namespace support
