#include "game/analysis/thing_report.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "game/analysis/thing_results.h"

namespace game {
namespace {

// "intact", "damaged", "destroyed" or "buried"; of a road "clear" or "blocked".
std::string_view state_of(const sim::State& world, const sim::Thing& thing) {
    if (thing.kind == sim::ThingKind::kRoad) return blocked_of(world, thing) > 0 ? "blocked" : "clear";
    if (thing.destroyed()) return "destroyed";
    if (thing.under()) return "buried";
    return thing.damaged() ? "damaged" : "intact";
}

// The middle of an object.
terrains::LocalPoint middle_of(const sim::Thing& thing) {
    if (!thing.is_line()) return {thing.x, thing.y};
    return {(thing.x + thing.to_x) / 2, (thing.y + thing.to_y) / 2};
}

double load_kpa(const sim::Thing& thing) {
    return static_cast<double>(thing.load) / 1000;
}
double buried_m(const sim::Thing& thing) {
    return static_cast<double>(thing.buried) / 1000;
}

std::string line_of(const Scenario& scenario, const sim::State& world, const sim::Thing& thing) {
    const terrains::LocalPoint at = middle_of(thing);
    std::string where = scenario.georeference.describe(at);
    if (where.empty()) where = fmt::format("{:.0f} m east, {:.0f} m north", at.x, at.y);
    return fmt::format("{} at {}: {}, load {:.1f} of {:g} kPa, buried {:.1f} m\n", sim::to_string(thing.kind),
                       where, state_of(world, thing), load_kpa(thing), thing.strength, buried_m(thing));
}

// How many pieces of nets are in each state.
std::string net_text(const std::vector<sim::Thing>& list) {
    std::size_t pieces = 0, damaged = 0, destroyed = 0;
    double greatest = 0;
    for (const sim::Thing& thing : list) {
        if (thing.kind != sim::ThingKind::kNet) continue;
        ++pieces;
        destroyed += thing.destroyed();
        damaged += thing.damaged() && !thing.destroyed();
        greatest = std::max(greatest, load_kpa(thing));
    }
    if (pieces == 0) return "";
    return fmt::format("nets: {} pieces, {} damaged, {} destroyed, load up to {:.1f} kPa\n", pieces, damaged,
                       destroyed, greatest);
}

}  // namespace

Json things_to_json(const Scenario& scenario, const Session& session) {
    const sim::Things& things = *session.state().things;
    const ThingResults results = thing_results(session);
    Json json;
    json["objects"] = Json::array();
    for (const sim::Thing& thing : things.list) {
        const terrains::LocalPoint at = middle_of(thing);
        Json object{{"kind", sim::to_string(thing.kind)}, {"x_m", at.x}, {"y_m", at.y}};
        if (const auto place = scenario.georeference.to_lat_lon(at)) {
            object["latitude"] = place->latitude;
            object["longitude"] = place->longitude;
        }
        if (thing.kind == sim::ThingKind::kRoad) {
            object["length_m"] = length_of(thing);
            object["blocked_m"] = blocked_of(session.state(), thing);
        } else {
            object["strength_kpa"] = thing.strength;
            object["load_kpa"] = load_kpa(thing);
            object["buried_m"] = buried_m(thing);
        }
        object["state"] = state_of(session.state(), thing);
        json["objects"].push_back(std::move(object));
    }
    json["forest"] = {{"intact_ha", results.forest_intact_ha}, {"broken_ha", results.forest_broken_ha}};
    json["earth"] = {{"used_m3", results.earth_used}};
    if (things.budget >= 0) json["earth"]["budget_m3"] = session.cubic_metres(things.budget);
    json["road"] = {{"length_m", results.road}, {"blocked_m", results.road_blocked}};
    return json;
}

std::string things_to_text(const Scenario& scenario, const Session& session) {
    constexpr std::size_t kFew = 12, kMostLines = 20;
    const sim::Things& things = *session.state().things;
    const ThingResults results = thing_results(session);
    std::vector<const sim::Thing*> named;
    for (const sim::Thing& thing : things.list)
        if (!thing.is_line()) named.push_back(&thing);
    const std::size_t all = named.size();
    if (all > kFew)
        std::erase_if(named,
                      [&](const sim::Thing* thing) { return state_of(session.state(), *thing) == "intact"; });
    std::string text;
    for (std::size_t i = 0; i < std::min(named.size(), kMostLines); ++i)
        text += line_of(scenario, session.state(), *named[i]);
    if (named.size() > kMostLines)
        text += fmt::format("and {} more that are damaged, destroyed or buried; --json has all\n",
                            named.size() - kMostLines);
    if (all > kFew)
        text += fmt::format("{} of {} buildings and pylons are intact\n", all - named.size(), all);
    text += net_text(things.list);
    if (results.road > 0)
        text += fmt::format("road: {:.0f} m, of which {:.0f} m are blocked\n", results.road,
                            results.road_blocked);
    if (results.forest_intact_ha + results.forest_broken_ha > 0)
        text += fmt::format("forest: {:.2f} ha intact, {:.2f} ha broken\n", results.forest_intact_ha,
                            results.forest_broken_ha);
    if (things.budget >= 0)
        text += fmt::format("earth: {:.1f} of {:.1f} m3 used\n", results.earth_used,
                            session.cubic_metres(things.budget));
    else if (results.earth_used > 0)
        text += fmt::format("earth: {:.1f} m3 used\n", results.earth_used);
    return text;
}

}  // namespace game
