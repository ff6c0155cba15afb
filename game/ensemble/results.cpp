#include "game/ensemble/results.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "game/compare/map_page.h"
#include "game/files/text_file.h"
#include "game/recording/format.h"
#include "render/pictures/picture.h"
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
    for (const Variable& variable : spec.variables) text += fmt::format(",{}", variable.name());
    text += ",ended,seconds_s";
    for (const Told& told : kTold)
        text += fmt::format(",{}_{}", told.name, std::string(told.unit) == "m/s" ? "m_s" : told.unit);
    text += ",state_hash,fault\n";
    for (const auto& [number, member] : result.members) {
        text += fmt::format("{}", number);
        for (const double value : member.sample) text += fmt::format(",{}", value);
        text += fmt::format(",{},{:.2f}", member.ended, member.seconds);
        for (const Told& told : kTold) text += fmt::format(",{:.2f}", member.*told.value);
        text += fmt::format(",{},{}\n", member.hash, csv_text(member.fault));
    }
    return text;
}

std::string name_of(const Threshold& threshold) {
    return fmt::format("probability_{}_over_{}", threshold.name(), threshold.least);
}

// Classes of probability, from small to large (viridis of van der Walt and Smith, 2015, reversed: dark is likely).
struct Class {
    float least;
    glm::vec3 colour;
    const char* words;
};
const std::array<Class, 6> kClasses{{{1e-6f, {253, 231, 37}, "below 5 %"},
                                     {0.05f, {122, 209, 81}, "5 to 25 %"},
                                     {0.25f, {34, 168, 132}, "25 to 50 %"},
                                     {0.5f, {42, 120, 142}, "50 to 75 %"},
                                     {0.75f, {65, 68, 135}, "75 to 95 %"},
                                     {0.95f, {68, 1, 84}, "95 % and more"}}};

Relief::Tint tint_of(float share) {
    Relief::Tint tint;
    for (const Class& each : kClasses)
        if (share >= each.least) tint = {each.colour, 0.82f};
    return tint;
}

render::Picture map_of(const EnsembleSpec& spec, const EnsembleResult& result, std::size_t threshold) {
    const Scenario& scenario = spec.scene.scenario;
    const Threshold& of = result.exceedances.thresholds()[threshold];
    std::vector<float> share = result.exceedances.probability(threshold);
    for (float& each : share)
        if (std::isnan(each)) each = 0;
    MapPage page(scenario, frame_around(scenario.grid, [&](std::size_t i) { return share[i] > 0; }));
    page.relief().draw(page.sheet(),
                       [&](glm::vec2 cells) { return tint_of(between(scenario.grid, share, cells)); });
    page.relief().outline(page.sheet(), share, 0.5f, 1.4f, 0, {20, 20, 24});
    page.title(fmt::format("Probability of {} of {} {} and more", of.name(), of.least, of.unit()));
    page.say(fmt::format("{}: {} members", spec.title, result.exceedances.members()));
    page.skip(12);
    for (std::size_t i = kClasses.size(); i-- > 0;) page.swatch(kClasses[i].colour, kClasses[i].words);
    page.skip(6);
    page.stroke(1.6f, 0, {20, 20, 24}, "one half");
    page.skip(12);
    const Spread run_out = spread_of(values_of(result, &Member::run_out));
    page.say(fmt::format("run-out {:.0f} m; in four of five members {:.0f} to {:.0f} m", run_out.middle,
                         run_out.tenth, run_out.nine_tenths));
    page.skip(8);
    for (const Variable& variable : spec.variables) {
        std::string numbers;
        for (std::size_t i = 0; i < variable.distribution.numbers.size() && i < 6; ++i)
            numbers += fmt::format("{}{}", i > 0 ? ", " : "", variable.distribution.numbers[i]);
        for (const DistributionInfo& info : distribution_infos())
            if (info.kind == variable.distribution.kind)
                page.whisper(fmt::format("{}: {} ({})", variable.name(), info.name, numbers));
    }
    page.skip(8);
    page.whisper(scenario.terrain + (scenario.licence.empty() ? "" : ". " + scenario.licence));
    page.whisper("Not a hazard assessment.");
    page.scale_bar();
    return page.sheet().picture;
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
    }
    return json;
}

Outcome<void> write_results(const fs::path& folder, const EnsembleSpec& spec, const EnsembleResult& result) {
    if (auto written = write_text(folder / "members.csv", csv_of(spec, result)); !written) return written;
    const Scenario& scenario = spec.scene.scenario;
    for (std::size_t i = 0; i < result.exceedances.thresholds().size(); ++i) {
        const std::string name = name_of(result.exceedances.thresholds()[i]);
        if (const auto written =
                terrains::write_geotiff(folder / (name + ".tif"), scenario.grid, scenario.georeference,
                                        result.exceedances.probability(i));
            !written)
            return machine_fails(written.error());
        if (const auto written = render::write_png(map_of(spec, result, i), folder / (name + ".png"));
            !written)
            return machine_fails(written.error());
    }
    return write_text(folder / "ensemble.json", printed(to_json(spec, result)));
}

}  // namespace game
