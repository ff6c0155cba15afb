#include "game/commands/runs_of_ensemble.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "game/ensemble/ensemble.h"

namespace game {
namespace {

std::string words_of(const EnsembleSpec& spec, const Member& member) {
    std::string words = fmt::format("{}, run-out {:.0f} m", member.number, member.run_out);
    for (std::size_t i = 0; i < spec.variables.size(); ++i) {
        const Variable& variable = spec.variables[i];
        const bool bare = variable.unit() == "1";
        words += fmt::format("\n{} {:.4g}{}{}", variable.name(), member.sample[i], bare ? "" : " ",
                             bare ? "" : variable.unit());
    }
    return words;
}

}  // namespace

Outcome<Runs> runs_of_ensemble(const std::filesystem::path& spec_file, const std::filesystem::path& folder,
                               const Overrides& overrides) {
    auto spec = read_ensemble_spec(spec_file, overrides);
    if (!spec) return tl::unexpected(spec.error());
    if (spec->maps.thresholds.empty())
        return unusable(
            fmt::format("{}: maps no probability; a [[map]] with `over` does", spec_file.string()));
    const auto result = read_ensemble(*spec, folder);
    if (!result) return tl::unexpected(result.error());

    Runs runs;
    runs.world.scene = spec->scene;
    runs.world.memory = overrides.memory;
    runs.world.told =
        fmt::format("Loaded {}: {} of {} runs", spec->title, result->members.size(), spec->members);
    for (std::size_t i = 0; i < spec->maps.thresholds.size(); ++i) {
        const Threshold& each = spec->maps.thresholds[i];
        const MappedInfo& info = info_of(each.of);
        runs.maps.push_back({fmt::format("{} of {} {} and more", info.name, each.least, info.unit),
                             result->counts.probability(i)});
    }
    for (const auto& [number, member] : result->members)
        if (member.fault.empty() && member.run_out > 0)
            runs.ended.push_back({number, {member.toe_x, member.toe_y}, words_of(*spec, member)});
    runs.world_of = [of = std::move(*spec),
                     memory = overrides.memory](std::int64_t member) -> Outcome<LoadedWorld> {
        auto scenario = of.scenario_of(member);
        if (!scenario) return tl::unexpected(scenario.error());
        LoadedWorld loaded;
        loaded.scene = of.scene;
        loaded.scene.scenario = std::move(*scenario);
        loaded.told = fmt::format("Run {} of {}", member, of.title);
        loaded.memory = memory;
        return loaded;
    };
    return runs;
}

}  // namespace game
