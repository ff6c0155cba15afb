#include "game/scene/shipped_look.h"

#include "game/files/assets.h"
#include "game/scene/material.h"

namespace game {

Outcome<void> take_look(LookFrom from, Scenario& scenario) {
    if (from == LookFrom::kRecorded || scenario.flow) return {};
    if (is_asset(AssetKind::kMaterial, scenario.material)) {
        const auto upper = load_material(scenario.material, scenario.params.model);
        if (!upper) return tl::unexpected(upper.error());
        render::Look look = upper->look;
        look.lower_standing = scenario.look.lower_standing;
        look.lower_rolling = scenario.look.lower_rolling;
        look.lower_turf = scenario.look.lower_turf;
        look.lower_powder = scenario.look.lower_powder;
        look.date = scenario.look.date;
        scenario.look = look;
        leave_old_cover_on_bare_ground(scenario);
    }
    if (!scenario.lower || !is_asset(AssetKind::kMaterial, scenario.lower->material)) return {};
    const auto lower = load_material(scenario.lower->material, scenario.params.model);
    if (!lower) return tl::unexpected(lower.error());
    take_look_of_lower(lower->look, scenario.look);
    return {};
}

}  // namespace game
