#include "game/ensemble/page.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "game/base/version.h"
#include "game/ensemble/results.h"
#include "game/pages/html.h"
#include "game/pages/plot.h"
#include "game/pages/table.h"
#include "game/recording/base64.h"
#include "game/recording/format.h"
#include "sim/world/params.h"

namespace game {
namespace {

// Of the colours of plot_style(): apart from one another, and grey for what several variables do together.
constexpr std::size_t kColours = 10;
constexpr int kTogether = 5;
int colour_of(std::size_t variable) {
    constexpr std::array kOrder{0, 2, 3, 4, 6, 7, 1, 8};
    return kOrder.at(variable % kOrder.size());
}

std::string introduction(const EnsembleSpec& spec, const EnsembleResult& result) {
    const std::size_t varied = spec.variables.size(), polygons = spec.scene.patches.size();
    std::string differ;
    if (polygons > 0) differ = fmt::format("releases one of {} polygons in turn", polygons);
    if (varied > 0)
        differ += fmt::format("{}has other values of {}", polygons > 0 ? ", and " : "",
                              varied == 1 ? "one number" : fmt::format("{} numbers", varied));
    std::string html = fmt::format(
        "<p>{} of {} runs of one world, of which each {}. A probability here is the share of these runs "
        "under the "
        "distributions stated below. This is not a hazard assessment.</p>\n",
        result.members.size(), spec.members, differ);
    if (const auto faults = faults_in(result); faults > 0)
        html += fmt::format("<p class=\"bad\">{} of them could not run, and count nowhere.</p>\n", faults);
    if (const auto moving = unfinished_in(result); moving > 0)
        html += fmt::format("<p class=\"bad\">{} of them were still moving after {} s.</p>\n", moving,
                            spec.seconds);
    return html;
}

std::string maps_html(std::span<const EnsembleMap> maps, std::span<const std::string> pictures) {
    std::string html = "<h2 id=\"maps\">Maps</h2>\n<div class=\"row\">\n";
    for (std::size_t i = 0; i < maps.size(); ++i)
        html += fmt::format(
            "<figure class=\"map\"><img src=\"data:image/png;base64,{0}\" alt=\"{1}\"><figcaption>{1} "
            "({2}.tif)</figcaption></figure>\n",
            to_base64(pictures[i]), html_text(maps[i].title), html_text(maps[i].name));
    return html + "</div>\n";
}

std::string spread_html(const EnsembleResult& result) {
    const std::vector<double> run_out = values_of(result, &Member::run_out);
    const Spread s = spread_of(run_out);
    DistributionPlot plot{"run-out, m", "% of runs", run_out, false, {}};
    plot.marks = {{fmt::format("10 % {:.0f}", s.tenth), s.tenth},
                  {fmt::format("median {:.0f}", s.middle), s.middle},
                  {fmt::format("90 % {:.0f}", s.nine_tenths), s.nine_tenths}};
    return "<h2 id=\"spread\">How far, how fast</h2>\n<div class=\"row\">\n" +
           figure_html(svg_of(plot), "Distribution of the run-out.") + "</div>\n" +
           as_html(spread_table(result));
}

std::string variance_html(const EnsembleSpec& spec, const EnsembleResult& result) {
    if (spec.variables.empty()) return "";
    std::string html = "<h2 id=\"variance\">What decides</h2>\n";
    const Table table = variance_table(spec, result);
    if (table.rows.empty())
        return html + fmt::format("<p>Of fewer than {} runs nothing can be said.</p>\n",
                                  least_for_variance(spec.variables.size()));
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < spec.variables.size(); ++i)
        legend.push_back({table.head[i + 1], colour_of(i)});
    legend.push_back({table.head.back(), kTogether});
    BarPlot plot{"% of the variance", {}};
    for (const Told& told : told_of_members()) {
        const auto shares = variance_of(result, told.value);
        if (!shares) continue;
        BarPlot::Bar bar{told.words, {}};
        const auto add = [&](const VarianceShare& share) {
            const LegendEntry& of = legend[bar.pieces.size()];
            bar.pieces.push_back({of.name, of.colour, std::max(0.0, 100 * share.share)});
        };
        for (const VarianceShare& share : shares->of) add(share);
        add(shares->together);
        plot.bars.push_back(std::move(bar));
    }
    return html +
           "<p>The share of the variance of a number that each variable explains by itself (Sobol's index of "
           "first "
           "order), and what only several of them together explain. In the table with two standard "
           "deviations of the "
           "estimate, which may lie a little beyond 0 and 100; bars leave out what is below 0.</p>\n" +
           legend_html(legend) + "<div class=\"row\">\n" + figure_html(svg_of(plot), "") + "</div>\n" +
           as_html(table);
}

std::string scatter_html(const EnsembleSpec& spec, const EnsembleResult& result) {
    constexpr std::size_t kMostDots = 2000;
    std::string html = "<div class=\"row\">\n";
    for (std::size_t i = 0; i < spec.variables.size(); ++i) {
        const Variable& variable = spec.variables[i];
        ScatterPlot plot{fmt::format("{}{}{}", variable.name(), variable.unit() == "1" ? "" : ", ",
                                     variable.unit() == "1" ? "" : variable.unit()),
                         "run-out, m",
                         {},
                         {},
                         colour_of(i)};
        for (const auto& [number, member] : result.members) {
            if (!member.fault.empty() || plot.x.size() == kMostDots) continue;
            plot.x.push_back(member.sample[i]), plot.y.push_back(member.run_out);
        }
        html += figure_html(svg_of(plot), fmt::format("Run-out over {}{}.", variable.name(),
                                                      plot.x.size() == kMostDots ? ", first 2000 runs" : ""));
    }
    return html + "</div>\n";
}

std::string inputs_html(const EnsembleSpec& spec) {
    const Scenario& scenario = spec.scene.scenario;
    Table varied{"Varied", {"variable", "distribution", "numbers", "unit"}, {}, 4};
    for (const Variable& variable : spec.variables) {
        const DistributionInfo& info = info_of(variable.distribution.kind);
        std::string numbers;
        for (const double number : variable.distribution.numbers)
            numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", number);
        varied.rows.push_back({std::string(variable.name()), fmt::format("{} ({})", info.name, info.numbers),
                               numbers, std::string(variable.unit())});
    }
    Table fixed{"The same in all", {"", ""}, {}, 2};
    const auto add = [&](std::string what, std::string value) {
        fixed.rows.push_back({std::move(what), std::move(value)});
    };
    add("terrain", scenario.terrain + (scenario.licence.empty() ? "" : ". " + scenario.licence));
    add("south-west corner", scenario.georeference.describe({0, 0}));
    add("grid",
        fmt::format("{} x {} vertices, {:g} m", scenario.grid.nx, scenario.grid.ny, scenario.grid.dx));
    add("material", scenario.material);
    add("model", std::string(sim::to_string(scenario.params.model)));
    for (const sim::ParamInfo& info : sim::kParams)
        if (sim::is_used_by(info, scenario.params.model))
            add(std::string(info.name), fmt::format("{} {}", scenario.params.*info.value, info.unit));
    add("seed", fmt::format("{}", spec.seed));
    add("ends at the latest after", fmt::format("{} s", spec.seconds));
    add("identity of the ensemble", spec.identity);
    add("version of the physics", fmt::format("{}", kPhysicsVersion));
    return "<h2 id=\"inputs\">Inputs</h2>\n<p>With these, and the ground, anyone can make the same runs; the "
           "hash of the last "
           "state of each is in members.csv.</p>\n" +
           as_html(varied) + as_html(fixed);
}

}  // namespace

std::string page_of(const EnsembleSpec& spec, const EnsembleResult& result, std::span<const EnsembleMap> maps,
                    std::span<const std::string> pictures) {
    const std::string style = plot_style(kColours) + "figure.map { flex: 0 1 640px; }\n";
    return begin_page(spec.title, style) + introduction(spec, result) + maps_html(maps, pictures) +
           spread_html(result) + variance_html(spec, result) + scatter_html(spec, result) +
           inputs_html(spec) + end_page(kProgram);
}

}  // namespace game
