#include "game/bench/page.h"

#include <algorithm>

#include <fmt/format.h>

#include "game/pages/html.h"
#include "game/pages/plot.h"

namespace game {
namespace {

std::string legend_of_parts(std::size_t first, std::size_t end) {
    std::vector<LegendEntry> entries;
    for (std::size_t part = first; part < end; ++part)
        entries.push_back({kPartNames[part], static_cast<int>(part)});
    return legend_html(entries);
}

std::string name_of(const Measured& each) {
    return fmt::format("{}, {} squares, {}", each.recording, each.squares, each.physics);
}

// Each part over the time of the avalanche: medians over the ticks of a pixel or two.
StackedPlot ticks_plot(const Measured& each) {
    constexpr std::size_t kMostPlaces = 160;
    const std::size_t count = each.rows.size(), places = std::min(count, kMostPlaces);
    StackedPlot plot{"s of the avalanche", "ms", {}, {}};
    for (std::size_t part = 0; part < kTickParts; ++part)
        plot.layers.push_back({kPartNames[part], static_cast<int>(part), {}});
    for (std::size_t place = 0; place < places; ++place) {
        const std::size_t first = place * count / places, end = (place + 1) * count / places;
        plot.x.push_back(each.rows[first].time_s);
        for (std::size_t part = 0; part < kTickParts; ++part) {
            std::vector<double> ms;
            for (std::size_t i = first; i < end; ++i) ms.push_back(each.rows[i].ms[part].value_or(0));
            plot.layers[part].y.push_back(median_of(std::move(ms)));
        }
    }
    return plot;
}

DistributionPlot distribution_plot(const Measured& each, const FrameFigures& figures) {
    DistributionPlot plot{"ms of a tick", "% of ticks", {}, true, {}};
    for (const PerfRow& row : each.rows) plot.values.push_back(row.ms.tick());
    plot.marks = {{fmt::format("median {:.3g}", figures.tick.median), figures.tick.median},
                  {fmt::format("95 % {:.3g}", figures.tick.p95), figures.tick.p95},
                  {fmt::format("99 % {:.3g}", figures.tick.p99), figures.tick.p99}};
    return plot;
}

BarPlot bars_of(const BenchReport& report, std::size_t first, std::size_t end, const char* label) {
    BarPlot plot{label, {}};
    for (const Measured& each : report.cases) {
        const FrameFigures figures = frame_figures(each);
        BarPlot::Bar bar{name_of(each), {}};
        for (std::size_t part = first; part < end; ++part)
            if (figures.parts[part].count > 0)
                bar.pieces.push_back({kPartNames[part], static_cast<int>(part), figures.parts[part].mean});
        plot.bars.push_back(std::move(bar));
    }
    return plot;
}

std::string bars_html(const BenchReport& report) {
    const bool drawn = report.around.drawn.has_value();
    std::string html =
        "<h2 id=\"bars\">Where the time goes</h2>\n" + legend_of_parts(0, drawn ? kPartCount : kTickParts) +
        "<div class=\"row\">\n" +
        figure_html(svg_of(bars_of(report, 0, kTickParts, "ms of a tick, mean")), "Ticks alone.");
    if (drawn)
        html += figure_html(svg_of(bars_of(report, 0, kPartCount, "ms of a frame, mean")),
                            "Ticks and the frames that draw them.");
    return html + "</div>\n";
}

std::string cases_html(const BenchReport& report) {
    std::string html = "<h2 id=\"ticks\">Tick by tick</h2>\n" + legend_of_parts(0, kTickParts);
    for (const Measured& each : report.cases) {
        if (each.rows.size() < 2) continue;
        const FrameFigures figures = frame_figures(each);
        html += fmt::format("<h3>{}: {}</h3>\n<div class=\"row\">\n", html_text(name_of(each)),
                            to_string(each.proof));
        html += figure_html(svg_of(ticks_plot(each)), "Time of a tick during the avalanche.");
        html += figure_html(svg_of(distribution_plot(each, figures)),
                            fmt::format("Distribution over {} ticks.", each.rows.size()));
        html += "</div>\n";
    }
    return html;
}

// For each grid, its moments at `time_s`, or all of them.
LogPlot scaling_plot(const Scaling& scaling, bool over_points) {
    LogPlot plot{over_points ? "points of the front" : "vertices", "ms", {}, !over_points};
    const double time_s = scaling.rows.front().time_s;
    const auto add = [&](const std::string& name, std::size_t colour, const auto& ms_of) {
        LogPlot::Series series{name, static_cast<int>(colour), {}, {}};
        for (const ScalingRow& row : scaling.rows) {
            if (!over_points && row.time_s > time_s + 1) continue;
            series.x.push_back(static_cast<double>(over_points ? row.points : row.vertices));
            series.y.push_back(ms_of(row));
        }
        plot.series.push_back(std::move(series));
    };
    for (std::size_t part = 0; part < kPartCount; ++part)
        add(kPartNames[part], part, [&](const ScalingRow& row) { return row.ms[part].value_or(0); });
    if (!over_points) add("tick", kPartCount, [](const ScalingRow& row) { return row.ms.tick(); });
    return plot;
}

std::string scaling_html(const Scaling& scaling) {
    return "<h2 id=\"scaling\">Scaling</h2>\n" + legend_of_parts(0, kPartCount) + "<div class=\"row\">\n" +
           figure_html(svg_of(scaling_plot(scaling, false)),
                       fmt::format("{} in {}, {:.0f} s after its start, on each grid.", scaling.recording,
                                   scaling.physics, scaling.rows.front().time_s)) +
           figure_html(svg_of(scaling_plot(scaling, true)),
                       "The same parts over the length of the front, at every moment.") +
           "</div>\n";
}

std::string introduction(const BenchReport& report) {
    std::string html;
    if (const auto fault = report.invalid())
        html += fmt::format("<p class=\"bad\">Not valid: {}.</p>\n", html_text(*fault));
    const Json around = to_json(report.around);
    html += fmt::format(
        "<p>{}, commit {}; {}.<br>{}; {} for the simulation.", html_text(around["program"]),
        html_text(around["commit"]), html_text(around["compiler"]), html_text(around["processor"]),
        report.around.threads == 1 ? "one thread" : fmt::format("{} threads", report.around.threads));
    if (const auto& by = report.around.drawn)
        html += fmt::format("<br>Drawn by {}, {}; timed by {}.", html_text(by->renderer),
                            html_text(by->quality), render::to_string(by->timing));
    html += "</p>\n";
    if (!report.cases.empty())
        html +=
            "<p>Times are medians of the repeats of each tick; medians, 95 % and 99 % percentiles over all "
            "ticks. <em>Golden</em>: every recorded state is bit-identical. <em>Unverified</em>: no states "
            "are recorded for this grid or physics, but the repeats agree. <em>Slow</em>: frames that take "
            "longer than the time they show. B/vertex: memory of the simulation and its fronts.</p>\n";
    return html;
}

}  // namespace

std::string page_of(const BenchReport& report, std::span<const Table> tables) {
    std::string html = begin_page("Couloir benchmark", plot_style(kPartCount + 1)) + introduction(report);
    if (!report.cases.empty()) html += bars_html(report);
    if (report.scaling) html += scaling_html(*report.scaling);
    html += "<h2 id=\"numbers\">In numbers</h2>\n";
    for (const Table& table : tables) html += as_html(table);
    if (!report.cases.empty()) html += cases_html(report);
    return html + end_page(to_json(report.around)["program"].get<std::string>());
}

}  // namespace game
