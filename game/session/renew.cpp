#include "game/session/renew.h"

#include "game/files/assets.h"
#include "game/scene/material.h"

namespace game {

void renew(Recording& recording) {
    if (!recording.header.renewed) return;
    const auto take = [](const std::string& name, sim::Params& params) {
        if (!is_asset(AssetKind::kMaterial, name)) return;
        if (const auto material = load_material(name, params.model)) take_numbers(material->params, params);
    };
    Scenario& scenario = recording.header.scenario;
    take(scenario.material, scenario.params);
    if (scenario.lower) take(scenario.lower->material, scenario.lower->params);
}

}  // namespace game
