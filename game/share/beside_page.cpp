#include "game/share/beside_page.h"

#include "game/base/one_line.h"
#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/pages/table.h"
#include "game/recording/format.h"
#include "game/share/filled.h"
#include "game/share/scripts.h"

namespace game {

Outcome<std::string> beside_page(const std::array<BesideSlide, 2>& slides) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    const auto frame = read_text(*assets / "web/beside.html");
    if (!frame) return tl::unexpected(frame.error());
    const auto program = read_text(*assets / "web/beside.js");
    if (!program) return tl::unexpected(program.error());
    const auto& [one, other] = slides;
    const std::string page = filled(*frame, {{"@PROGRAM@", *program}});
    // The two frames inherit the policy of this page, and each has its own.
    const std::string scripts = names_of_scripts(page + one.page + other.page);
    return filled(page, {{"@TITLE@", html_text(one_line(one.title + " | " + other.title))},
                         {"@SCRIPTS@", scripts},
                         {"@FIRST@", html_text(one_line(one.title))},
                         {"@SECOND@", html_text(one_line(other.title))},
                         {"@PAGES@", in_script(Json{one.page, other.page})}});
}

}  // namespace game
