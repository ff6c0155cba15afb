#include "game/analysis/export_iseesnow.h"

#include <algorithm>
#include <ctime>
#include <limits>

#include <fmt/format.h>

#include "game/analysis/export_results.h"
#include "game/base/one_line.h"
#include "game/base/version.h"
#include "game/files/text_file.h"
#include "terrains/export.h"

namespace game {
namespace {

std::vector<float> with_gaps(const Scenario& scenario, std::vector<float> field) {
    for (std::size_t i = 0; i < field.size(); ++i)
        if (!scenario.has_data[i]) field[i] = std::numeric_limits<float>::quiet_NaN();
    return field;
}

// The volume that moved or lies on the grid now, m³.
double volume(const Session& session) {
    return session.cubic_metres(session.state().ledger.standing + session.state().ledger.rolling);
}

std::string configuration(const std::filesystem::path& release, const Summary& summary) {
    const Scenario& scenario = summary.scenario;
    const sim::Params& params = scenario.params;
    std::string text = fmt::format("[MODEL]\nname = couloir\nversion = {}\ncommit = {}\nmodel = {}\n",
                                   kProgram, kCommit, sim::to_string(params.model));
    if (params.model == sim::Model::kBcre)
        text +=
            fmt::format("scheme = {}\nlaw = {}\n", sim::to_string(params.scheme), sim::to_string(params.law));
    text += fmt::format("\n[PARAMETERS]\n# SI units; slopes are tangents\nmaterial = {}\n",
                        one_line(scenario.material));
    if (scenario.density) text += fmt::format("density = {}\n", *scenario.density);
    for (const sim::ParamInfo& info : sim::kParams)
        if (sim::is_used_by(info, params.model))
            text += fmt::format("{} = {}\n", info.name, params.*info.value);
    text +=
        fmt::format("\n[NUMERICS]\ncell_m = {}\nvertices_x = {}\nvertices_y = {}\nsubsteps_per_tick = {}\n",
                    scenario.grid.dx, scenario.grid.nx, scenario.grid.ny,
                    sim::substeps_of(params, scenario.grid.dx).count);
    text += fmt::format("\n[INPUT]\nterrain = {}\nrelease = {}\n", one_line(scenario.terrain),
                        one_line(release.filename().string()));
    text += fmt::format(
        "\n[RESULT]\nflow_time_s = {:.2f}\nended_by = {}\nvolume_first_m3 = {:.1f}\n"
        "volume_last_m3 = {:.1f}\nvolume_out_m3 = {:.1f}\nspeed_limited = {}\nstate_hash = {}\n",
        summary.session.seconds(), to_string(summary.ended.value_or(Ended::kTick)),
        summary.session.cubic_metres(summary.session.state().ledger.initial), volume(summary.session),
        summary.session.cubic_metres(summary.session.state().ledger.out), summary.session.state().limited,
        hex(summary.session.state_line().hash));
    return text;
}

std::string table(const std::string& name, const Summary& summary) {
    const double cell = summary.scenario.grid.dx;
    return fmt::format(
        ",testCase,computation duration (CPU) [s],avalanche flow time [s],volume at t0 [m3],volume at tFinal "
        "[m3],spatial resolution x [m],spatial resolution y [m],number of particles\n"
        "1,{},{:.2f},{:.2f},{:.1f},{:.1f},{},{},\n",
        name.substr(name.find('_') + 1), static_cast<double>(std::clock()) / CLOCKS_PER_SEC,
        summary.session.seconds(), summary.session.cubic_metres(summary.session.state().ledger.initial),
        volume(summary.session), cell, cell);
}

}  // namespace

std::string iseesnow_name(const std::filesystem::path& release, const std::filesystem::path& terrain) {
    const auto part = [](const std::filesystem::path& file) {
        std::string name = file.stem().string();
        std::erase_if(name, [](char c) { return !is_iseesnow_name(std::string("x_") + c); });
        return name.empty() ? std::string("unnamed") : name;
    };
    return part(release) + "_" + part(terrain);
}

bool is_iseesnow_name(std::string_view name) {
    const auto fits = [](std::string_view part) {
        return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) {
            return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
                   c == '.';
        });
    };
    const std::size_t at = name.find('_');
    return at != std::string_view::npos && fits(name.substr(0, at)) && fits(name.substr(at + 1));
}

Outcome<void> export_iseesnow(const std::filesystem::path& folder, const std::string& name,
                              const std::filesystem::path& release, const Summary& summary) {
    if (auto made = make_folder(folder); !made) return made;
    const Scenario& scenario = summary.scenario;
    const Peaks& peaks = summary.session.peaks();
    const std::string stem = name + "_null_couloir";
    const auto write = [&](const char* what, const std::vector<float>& field) {
        return terrains::write_ascii(folder / fmt::format("{}_{}.asc", stem, what), scenario.grid,
                                     scenario.georeference, with_gaps(scenario, field),
                                     terrains::AsciiStyle::kCentred);
    };
    if (auto written = write("pft", peak_thickness_of(scenario, peaks)); !written)
        return machine_fails(written.error());
    if (auto written = write("pfv", peaks.speed_slope); !written) return machine_fails(written.error());
    if (!peaks.pressure.empty())
        if (auto written = write("ppr", peaks.pressure); !written) return machine_fails(written.error());
    if (auto written = write_text(folder / (stem + ".txt"), configuration(release, summary)); !written)
        return written;
    return write_text(folder / "simulationResultTable.csv", table(name, summary));
}

}  // namespace game
