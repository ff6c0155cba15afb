#include "game/recording/divergence_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/stages/stage_watch.h"

namespace game {
namespace {

std::string in_substep(const Divergence& parted) {
    if (parted.substep == sim::StageWatch::kCommands) return "before the first sub-step";
    if (parted.substep >= parted.substeps)
        return fmt::format("stage {} after the last sub-step", parted.stage);
    return fmt::format("stage {} in sub-step {} of {}", parted.stage, parted.substep + 1, parted.substeps);
}

std::string value_text(const FieldDifference::Value& value) {
    return fmt::format("{:08x}  {}", value.bits, value.number);
}

std::string also_text(const Divergence& parted) {
    std::string text;
    for (std::size_t i = 1; i < parted.fields.size(); ++i)
        text += fmt::format("{}{} ({})", i == 1 ? "" : ", ", parted.fields[i].field, parted.fields[i].count);
    return text;
}

double metres(const Scenario& start, int cells) {
    return cells * static_cast<double>(start.grid.dx);
}

std::string_view name_of(Divergence::Where where) {
    constexpr std::string_view kNames[] = {"start", "stage", "sweep", "lost", "else", "refused"};
    return kNames[static_cast<std::size_t>(where)];
}

}  // namespace

std::string stage_text(const Divergence& parted, const std::array<std::string, 2>& names) {
    switch (parted.where) {
        case Divergence::Where::kStart:
            return "the start, before any tick";
        case Divergence::Where::kStage:
            return fmt::format("{}, {}", parted.name, in_substep(parted));
        case Divergence::Where::kSweep:
            return fmt::format("sweep: the plain steps of both agree{}",
                               parted.wrong_side
                                   ? fmt::format(", and the sweep of {} does not",
                                                 names[static_cast<std::size_t>(*parted.wrong_side)])
                                   : ", and neither sweep does");
        case Divergence::Where::kLost:
            return "not found: the tick ends alike when repeated, so the fault is intermittent";
        case Divergence::Where::kRefused:
            return fmt::format("commands: {} does not take them: {}",
                               names[static_cast<std::size_t>(parted.wrong_side.value_or(0))], parted.name);
        case Divergence::Where::kElse:
            break;
    }
    return "not comparable: the two runs have different stages";
}

std::size_t differing(const Divergence& parted) {
    return static_cast<std::size_t>(std::count(parted.cells.begin(), parted.cells.end(), 1));
}

std::string to_text(const Divergence& parted, const Scenario& start,
                    const std::array<std::string, 2>& names) {
    std::string text;
    if (parted.where == Divergence::Where::kRefused)
        text = fmt::format("they part before tick {}\n", parted.tick);
    else if (parted.where != Divergence::Where::kStart)
        text = fmt::format("they part in tick {} (at {:.2f} s): alike at its start, not at its end\n",
                           parted.tick,
                           static_cast<double>(parted.tick) * static_cast<double>(start.params.tick_s));
    else
        text = "they part before the first tick\n";
    const auto line = [&](const std::string& what, const std::string& said) {
        text += fmt::format("  {:<9} {}\n", what, said);
    };
    line("stage", stage_text(parted, names));
    if (parted.where == Divergence::Where::kRefused) return text;
    if (parted.fields.empty()) {
        line("field", "none: active commands or the mass ledger differ");
    } else {
        const FieldDifference& first = parted.fields.front();
        line("field", fmt::format("{}, {} value{}", first.field, first.count, first.count > 1 ? "s" : ""));
        const terrains::LocalPoint at{metres(start, first.x), metres(start, first.y)};
        const std::string place = start.georeference.describe(at);
        line("cell", fmt::format("{}, {}: {:.4g} m east, {:.4g} m north{}{}", first.x, first.y, at.x, at.y,
                                 place.empty() ? "" : "; ", place));
        line("tile", fmt::format("{}, {} of {}x{} vertices", parted.tile_x, parted.tile_y, parted.tile_width,
                                 parted.tile_height));
        const std::size_t width = std::max(names[0].size(), names[1].size());
        for (std::size_t side = 0; side < 2; ++side)
            line("bits", fmt::format("{:<{}}  {}", names[side], width, value_text(first.values[side])));
        line("distance", fmt::format("{} ULP{}", first.ulps, first.ulps > 1 ? "s" : ""));
        if (parted.fields.size() > 1) line("also in", also_text(parted));
    }
    line("then",
         fmt::format("{} of {} cells differ at the end of the tick", differing(parted), parted.cells.size()));
    return text;
}

Json to_json(const Divergence& parted, const Scenario& start) {
    Json json{{"tick", parted.tick}, {"where", name_of(parted.where)}};
    if (parted.where == Divergence::Where::kStage) {
        json["substep"] = parted.substep + 1;  // 0: the commands
        json["substeps"] = parted.substeps;
        json["stage"] = {{"number", parted.stage}, {"name", parted.name}};
    }
    if (parted.where == Divergence::Where::kRefused) json["reason"] = parted.name;
    if (parted.wrong_side) json["wrong_side"] = *parted.wrong_side == 0 ? "first" : "second";
    json["fields"] = Json::array();
    for (const FieldDifference& each : parted.fields)
        json["fields"].push_back({{"field", each.field},
                                  {"values", each.count},
                                  {"cell", {each.x, each.y}},
                                  {"x_m", metres(start, each.x)},
                                  {"y_m", metres(start, each.y)},
                                  {"first",
                                   {{"bits", fmt::format("{:08x}", each.values[0].bits)},
                                    {"number", shortest(each.values[0].number)}}},
                                  {"second",
                                   {{"bits", fmt::format("{:08x}", each.values[1].bits)},
                                    {"number", shortest(each.values[1].number)}}},
                                  {"ulps", each.ulps}});
    if (!parted.fields.empty())
        json["tile"] = {{"x", parted.tile_x},
                        {"y", parted.tile_y},
                        {"vertices", {parted.tile_width, parted.tile_height}}};
    json["cells"] = differing(parted);
    return json;
}

}  // namespace game
