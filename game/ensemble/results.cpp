#include "game/ensemble/results.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "game/ensemble/maps.h"
#include "game/ensemble/page.h"
#include "game/files/text_file.h"
#include "game/recording/format.h"
#include "render/pictures/png.h"
#include "terrains/export.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr std::array kTold{Told{"run_out", "m", "run-out", &Member::run_out},
                           Told{"fall", "m", "fall", &Member::fall},
                           Told{"extent", "m2", "extent", &Member::extent},
                           Told{"top_speed", "m/s", "top speed", &Member::top_speed},
                           Told{"thickness", "m", "greatest thickness", &Member::thickness},
                           Told{"released", "m3", "released", &Member::released},
                           Told{"eroded", "m3", "eroded", &Member::eroded}};

// A text in a table of comma-separated values (RFC 4180).
std::string csv_text(const std::string& text) {
    std::string quoted;
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return text.empty() ? "" : '"' + quoted + '"';
}

std::string csv_of(const EnsembleSpec& spec, const EnsembleResult& result) {
    std::string text = "member";
    if (!spec.scene.patches.empty()) text += ",polygon";
    for (const Variable& variable : spec.variables) text += fmt::format(",{}", variable.name());
    text += ",ended,seconds_s";
    for (const Told& told : kTold)
        text += fmt::format(",{}_{}", told.name, std::string(told.unit) == "m/s" ? "m_s" : told.unit);
    text += ",state_hash,fault\n";
    for (const auto& [number, member] : result.members) {
        text += fmt::format("{}", number);
        if (const auto patch = spec.patch_of(number)) text += fmt::format(",{}", *patch);
        for (const double value : member.sample) text += fmt::format(",{}", value);
        text += fmt::format(",{},{:.2f}", member.ended, member.seconds);
        for (const Told& told : kTold) text += fmt::format(",{:.2f}", member.*told.value);
        text += fmt::format(",{},{}\n", member.hash, csv_text(member.fault));
    }
    return text;
}

}  // namespace

std::vector<double> values_of(const EnsembleResult& result, double Member::*value) {
    std::vector<double> values;
    for (const auto& [number, member] : result.members)
        if (member.fault.empty()) values.push_back(member.*value);
    return values;
}

std::int64_t faults_in(const EnsembleResult& result) {
    return std::ranges::count_if(result.members, [](const auto& each) { return !each.second.fault.empty(); });
}

std::int64_t unfinished_in(const EnsembleResult& result) {
    return std::ranges::count_if(result.members,
                                 [](const auto& each) { return each.second.ended == "limit"; });
}

std::span<const Told> told_of_members() {
    return kTold;
}

Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
    };
    return {at(0), at(0.1), at(0.5), at(0.9), at(1)};
}

Table spread_table(const EnsembleResult& result) {
    Table table{"", {"", "least", "10 %", "median", "90 %", "most"}, {}};
    for (const Told& told : kTold) {
        const Spread s = spread_of(values_of(result, told.value));
        std::vector<std::string> row{fmt::format("{}, {}", told.words, told.unit)};
        for (const double value : {s.least, s.tenth, s.middle, s.nine_tenths, s.most})
            row.push_back(fmt::format("{:.1f}", value));
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::optional<VarianceShares> variance_of(const EnsembleResult& result, double Member::*value) {
    if (result.members.empty() || result.members.begin()->second.sample.empty()) return std::nullopt;
    std::vector<std::vector<double>> samples;
    for (const auto& [number, member] : result.members)
        if (member.fault.empty()) samples.push_back(member.sample);
    return variance_shares(samples, values_of(result, value));
}

Table variance_table(const EnsembleSpec& spec, const EnsembleResult& result) {
    Table table{"", {"% of the variance of"}, {}};
    for (const Variable& variable : spec.variables) table.head.emplace_back(variable.name());
    table.head.emplace_back("together");
    for (const Told& told : kTold) {
        const auto shares = variance_of(result, told.value);
        if (!shares) continue;
        std::vector<std::string> row{told.words};
        const auto add = [&](const VarianceShare& share) {
            // Plus 0, so that nothing is "-0".
            row.push_back(
                fmt::format("{:.0f} ± {:.0f}", std::round(100 * share.share) + 0.0, 200 * share.error));
        };
        for (const VarianceShare& share : shares->of) add(share);
        add(shares->together);
        table.rows.push_back(std::move(row));
    }
    return table;
}

Json to_json(const EnsembleSpec& spec, const EnsembleResult& result) {
    Json json{{"title", spec.title},
              {"ensemble", spec.identity},
              {"physics_version", kPhysicsVersion},
              {"members", spec.members},
              {"finished", result.members.size()},
              {"could_not_run", faults_in(result)},
              {"still_moving", unfinished_in(result)},
              {"seed", spec.seed}};
    json["variables"] = Json::array();
    for (const Variable& variable : spec.variables)
        json["variables"].push_back({{"of", variable.name()}, {"unit", variable.unit()}});
    for (const Told& told : kTold) {
        const Spread spread = spread_of(values_of(result, told.value));
        json[told.name] = {{"unit", told.unit},
                           {"least", spread.least},
                           {"tenth", spread.tenth},
                           {"median", spread.middle},
                           {"nine_tenths", spread.nine_tenths},
                           {"most", spread.most}};
        const auto shares = variance_of(result, told.value);
        if (!shares) continue;
        Json& of = json[told.name]["share_of_variance"];
        const auto tell = [&](const std::string& name, const VarianceShare& share) {
            constexpr double kDigits = 1e4;
            of[name] = {{"share", std::round(kDigits * share.share) / kDigits},
                        {"error", std::round(kDigits * share.error) / kDigits}};
        };
        for (std::size_t i = 0; i < spec.variables.size(); ++i)
            tell(std::string(spec.variables[i].name()), shares->of[i]);
        tell("together", shares->together);
    }
    return json;
}

Outcome<void> write_results(const fs::path& folder, const EnsembleSpec& spec, const EnsembleResult& result) {
    if (auto written = write_text(folder / "members.csv", csv_of(spec, result)); !written) return written;
    const Scenario& scenario = spec.scene.scenario;
    const std::vector<EnsembleMap> maps = maps_of(spec, result);
    std::vector<std::string> pictures;
    for (const EnsembleMap& map : maps) {
        if (const auto written = terrains::write_geotiff(folder / (map.name + ".tif"), scenario.grid,
                                                         scenario.georeference, map.values);
            !written)
            return machine_fails(written.error());
        const auto picture =
            render::encode_png(picture_of(map, spec, result), render::kFastPngCompression, {});
        if (!picture) return machine_fails(picture.error());
        pictures.emplace_back(picture->begin(), picture->end());
        if (auto written = write_text(folder / (map.name + ".png"), pictures.back()); !written)
            return written;
    }
    if (auto written = write_text(folder / "report.html", page_of(spec, result, maps, pictures)); !written)
        return written;
    return write_text(folder / "ensemble.json", printed(to_json(spec, result)));
}

}  // namespace game
