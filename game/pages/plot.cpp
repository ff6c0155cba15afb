#include "game/pages/plot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "game/pages/table.h"

namespace game {
namespace {

constexpr double kWidth = 440, kHeight = 250, kTallHeight = 360;
constexpr double kLeft = 50, kRight = 12, kTop = 12, kBottom = 38;
constexpr double kLetter = 11;  // px, text height

// Maps values to pixels along one axis.
struct Axis {
    double least = 0, most = 1;  // values
    double from = 0, to = 1;     // pixels
    bool logarithmic = false;

    double at(double value) const {
        const double share =
            logarithmic ? std::log(value / least) / std::log(most / least) : (value - least) / (most - least);
        return from + share * (to - from);
    }
};

Axis across(double least, double most, bool logarithmic = false) {
    return {least, most, kLeft, kWidth - kRight, logarithmic};
}
Axis upwards(double least, double most, bool logarithmic = false) {
    return {least, most, kHeight - kBottom, kTop, logarithmic};
}
Axis far_upwards(double least, double most, bool logarithmic) {
    return {least, most, kTallHeight - kBottom, kTop, logarithmic};
}

// The nearest value that is 1, 2 or 5 times a power of ten, below or above.
double rounded(double value, bool up) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    if (up)
        for (const double step : {1.0, 2.0, 5.0})
            if (power * step >= value) return power * step;
    if (up) return 10 * power;
    return value >= 5 * power ? 5 * power : value >= 2 * power ? 2 * power : power;
}

// The axis range that covers all values.
Axis logarithmic(const std::vector<double>& values, Axis (*axis)(double, double, bool)) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double low = rounded(*least, false), high = rounded(*most, true);
    return axis(low, high > low ? high : 10 * low, true);
}

// The linear axis range that covers all values, from a round number to a round number.
Axis around(const std::vector<double>& values, Axis (*axis)(double, double, bool)) {
    constexpr int kSteps = 8;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (!(*least < *most)) return axis(*least - 1, *most + 1, false);
    const std::vector<double> numbers = round_numbers(*least, *most, kSteps);
    const double step = numbers.size() > 1 ? numbers[1] - numbers[0] : *most - *least;
    return axis(std::floor(*least / step) * step, std::ceil(*most / step) * step, false);
}

std::string number_text(double value) {
    if (value >= 1e6) return fmt::format("{:g}M", value / 1e6);
    if (value >= 1e4) return fmt::format("{:g}k", value / 1e3);
    return fmt::format("{:g}", value);
}

std::string text(double x, double y, const char* anchor, const std::string& what) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                       html_text(what));
}

std::string line(double x1, double y1, double x2, double y2, const char* kind) {
    return fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", kind,
                       x1, y1, x2, y2);
}

std::vector<double> marks_of(const Axis& axis, int count) {
    if (!axis.logarithmic) return round_numbers(axis.least, axis.most, count);
    std::vector<double> marks;
    const int last = static_cast<int>(std::floor(std::log10(axis.most * 1.001)));
    for (int exponent = static_cast<int>(std::floor(std::log10(axis.least))); exponent <= last; ++exponent)
        for (const double step : {1.0, 2.0, 5.0})
            if (const double mark = step * std::pow(10, exponent);
                mark >= axis.least * 0.999 && mark <= axis.most * 1.001)
                marks.push_back(mark);
    if (static_cast<int>(marks.size()) <= count) return marks;
    // Only powers of ten.
    std::erase_if(marks, [](double mark) {
        const double log = std::log10(mark);
        return std::abs(log - std::round(log)) > 1e-6;
    });
    return marks;
}

std::string axes(const Axis& x, const Axis& y, const std::string& x_label, const std::string& y_label) {
    std::string svg;
    for (const double mark : marks_of(y, 7)) {
        svg += line(x.from, y.at(mark), x.to, y.at(mark), "grid");
        svg += text(x.from - 5, y.at(mark) + 4, "end", number_text(mark));
    }
    for (const double mark : marks_of(x, 8)) {
        svg += line(x.at(mark), y.from, x.at(mark), y.from + 4, "axis");
        svg += text(x.at(mark), y.from + 16, "middle", number_text(mark));
    }
    svg += line(x.from, y.from, x.to, y.from, "axis");
    svg += text((x.from + x.to) / 2, y.from + 32, "middle", x_label);
    svg +=
        fmt::format("<text transform=\"translate(11 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                    (y.from + y.to) / 2, html_text(y_label));
    return svg;
}

std::string framed(const std::string& inside, double height, const std::string& label) {
    return fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n{}</svg>\n", kWidth,
                       height, html_text(label), inside);
}

std::string titled(const std::string& name) {
    return fmt::format("<title>{}</title>", html_text(name));
}

// Labels at the right end of lines, moved apart so that they do not overlap.
struct EndLabel {
    double y;
    std::string name;
    int colour;
};
std::string end_labels(std::vector<EndLabel> labels, double x) {
    std::sort(labels.begin(), labels.end(), [](const EndLabel& a, const EndLabel& b) { return a.y < b.y; });
    for (int pass = 0; pass < 100; ++pass)
        for (std::size_t i = 1; i < labels.size(); ++i) {
            const double overlap = kLetter + 1 - (labels[i].y - labels[i - 1].y);
            if (overlap <= 0) continue;
            labels[i - 1].y -= overlap / 2;
            labels[i].y += overlap / 2;
        }
    std::string svg;
    for (const EndLabel& label : labels) {
        svg += fmt::format("<circle class=\"f{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>\n", label.colour, x,
                           label.y);
        svg += text(x + 6, label.y + 4, "start", label.name);
    }
    return svg;
}

constexpr const char* kChartStyle =
    R"(:root { --p0: #0072b2; --p1: #e8d820; --p2: #e69f00; --p3: #009e73; --p4: #cc79a7; --p5: #9a9a9a; --p6: #56b4e9; --p7: #d55e00; --p8: #505050; --p9: #222; }
@media (prefers-color-scheme: dark) { :root { --p0: #3d9be0; --p8: #c8c8c8; --p9: #e4e4e4; } }
.row > figure { flex: 1 1 340px; max-width: 560px; }
svg { display: block; width: 100%; height: auto; }
svg text { font: 11px system-ui, sans-serif; fill: var(--ink); paint-order: stroke; stroke: var(--paper); stroke-width: 3px; }
svg .grid { stroke: var(--line); } svg .axis { stroke: var(--soft); } svg .mark { stroke: var(--ink); stroke-dasharray: 3 3; }
svg polygon { stroke: var(--paper); stroke-width: .4; } svg polyline { fill: none; stroke-width: 1.6; }
.bad { color: #c33; font-weight: bold; }
svg .dot { fill-opacity: .55; }
)";

}  // namespace

std::string plot_style(std::size_t colours) {
    std::string style = kChartStyle;
    for (std::size_t i = 0; i < colours; ++i)
        style += fmt::format(
            "svg .f{0} {{ fill: var(--p{0}); }} svg .l{0} {{ stroke: var(--p{0}); }} svg text.c{0} {{ fill: "
            "var(--p{0}); }}\n",
            i);
    return style;
}

std::string figure_html(const std::string& svg, const std::string& caption) {
    return "<figure>" + svg + "<figcaption>" + html_text(caption) + "</figcaption></figure>\n";
}

std::vector<double> round_numbers(double least, double most, int count) {
    if (!(most > least)) return {least};
    const double rough = (most - least) / count, power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double each : {1.0, 2.0, 5.0})
        if (power * each >= rough * 0.999) {
            step = power * each;
            break;
        }
    std::vector<double> numbers;
    for (auto i = static_cast<long>(std::ceil(least / step - 1e-9));
         static_cast<double>(i) * step <= most * (1 + 1e-9); ++i)
        numbers.push_back(static_cast<double>(i) * step);
    return numbers;
}

std::string svg_of(const StackedPlot& plot) {
    const std::size_t count = plot.x.size();
    std::vector<double> top(count, 0.0);
    for (const auto& layer : plot.layers)
        for (std::size_t i = 0; i < count; ++i) top[i] += layer.y[i];
    const double most = *std::max_element(top.begin(), top.end());
    const Axis x = across(plot.x.front(), plot.x.back()), y = upwards(0, most > 0 ? 1.05 * most : 1);
    std::string svg = axes(x, y, plot.x_label, plot.y_label);
    std::vector<double> base(count, 0.0);
    for (const auto& layer : plot.layers) {
        std::string there, back;
        for (std::size_t i = 0; i < count; ++i)
            there += fmt::format("{:.1f} {:.1f} ", x.at(plot.x[i]), y.at(base[i] + layer.y[i]));
        for (std::size_t i = count; i-- > 0;) {
            back += fmt::format("{:.1f} {:.1f} ", x.at(plot.x[i]), y.at(base[i]));
            base[i] += layer.y[i];
        }
        svg += fmt::format("<polygon class=\"f{}\" points=\"{}{}\">{}</polygon>\n", layer.colour, there, back,
                           titled(layer.name));
    }
    return framed(svg, kHeight, plot.y_label + " over " + plot.x_label);
}

std::string svg_of(const DistributionPlot& plot) {
    std::vector<double> values;
    for (const double value : plot.values)
        if (value > 0 || !plot.logarithmic) values.push_back(value);
    if (values.empty()) return "";
    constexpr std::size_t kMostBins = 48, kValuesPerBin = 10, kLeastBins = 12;
    const std::size_t bins = std::clamp(values.size() / kValuesPerBin, kLeastBins, kMostBins);
    const Axis x = plot.logarithmic ? logarithmic(values, across) : around(values, across);
    std::vector<double> share(bins, 0.0);
    for (const double value : values) {
        const double place = (x.at(value) - x.from) / (x.to - x.from) * static_cast<double>(bins);
        share[std::min(static_cast<std::size_t>(std::max(place, 0.0)), bins - 1)] +=
            100 / static_cast<double>(values.size());
    }
    const Axis y = upwards(0, 1.15 * *std::max_element(share.begin(), share.end()));
    std::string svg = axes(x, y, plot.x_label, plot.y_label);
    const double width = (x.to - x.from) / static_cast<double>(bins);
    for (std::size_t i = 0; i < bins; ++i)
        if (share[i] > 0)
            svg += fmt::format(
                "<rect class=\"f0\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                x.from + width * static_cast<double>(i) + 0.5, y.at(share[i]), width - 1,
                y.from - y.at(share[i]));
    double label_y = y.to + kLetter;
    for (const auto& mark : plot.marks) {
        if (plot.logarithmic && !(mark.value > 0)) continue;
        svg += line(x.at(mark.value), y.from, x.at(mark.value), label_y - kLetter + 2, "mark");
        const bool left = x.at(mark.value) > 0.75 * kWidth;
        svg += text(x.at(mark.value) + (left ? -4 : 4), label_y, left ? "end" : "start", mark.name);
        label_y += kLetter + 3;
    }
    return framed(svg, kHeight, "distribution of " + plot.x_label);
}

std::string svg_of(const ScatterPlot& plot) {
    if (plot.x.empty()) return "";
    const Axis x = around(plot.x, across), y = around(plot.y, upwards);
    std::string svg = axes(x, y, plot.x_label, plot.y_label);
    for (std::size_t i = 0; i < plot.x.size(); ++i)
        svg += fmt::format("<circle class=\"f{} dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\"/>\n", plot.colour,
                           x.at(plot.x[i]), y.at(plot.y[i]));
    return framed(svg, kHeight, plot.y_label + " over " + plot.x_label);
}

std::string svg_of(const BarPlot& plot) {
    constexpr double kBar = 34, kThick = 12;
    double most = 0;
    for (const auto& bar : plot.bars) {
        const double sum =
            std::accumulate(bar.pieces.begin(), bar.pieces.end(), 0.0,
                            [](double so_far, const auto& piece) { return so_far + piece.value; });
        most = std::max(most, sum);
    }
    const double bottom = kTop + kBar * static_cast<double>(plot.bars.size());
    const Axis x{0, most > 0 ? most : 1, 4, kWidth - 44, false};
    std::string svg;
    for (const double mark : round_numbers(0, x.most, 6)) {
        svg += line(x.at(mark), kTop, x.at(mark), bottom, "grid");
        svg += text(x.at(mark), bottom + 14, "middle", number_text(mark));
    }
    svg += text((x.from + x.to) / 2, bottom + 30, "middle", plot.x_label);
    double y = kTop;
    for (const auto& bar : plot.bars) {
        svg += text(x.from, y + kLetter, "start", bar.name);
        double sum = 0;
        for (const auto& piece : bar.pieces) {
            svg += fmt::format(
                "<rect class=\"f{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{}\">{}</rect>\n",
                piece.colour, x.at(sum), y + kLetter + 4, x.at(piece.value) - x.from, kThick,
                titled(fmt::format("{}: {:.3g}", piece.name, piece.value)));
            sum += piece.value;
        }
        svg += text(x.at(sum) + 4, y + kLetter + kThick + 3, "start", fmt::format("{:.3g}", sum));
        y += kBar;
    }
    return framed(svg, bottom + 36, plot.x_label);
}

std::string svg_of(const LogPlot& plot) {
    constexpr double kNames = 60;  // px at the right edge
    std::vector<double> xs, ys;
    for (const auto& series : plot.series)
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (series.x[i] > 0 && series.y[i] > 0) xs.push_back(series.x[i]), ys.push_back(series.y[i]);
    if (xs.empty()) return "";
    Axis x = logarithmic(xs, across);
    x.to -= kNames;
    const Axis y = logarithmic(ys, far_upwards);
    std::string svg = axes(x, y, plot.x_label, plot.y_label);
    std::vector<EndLabel> labels;
    for (const auto& series : plot.series) {
        std::string points, dots;
        double last_x = 0, last_y = 0;
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            if (!(series.x[i] > 0 && series.y[i] > 0)) continue;
            const double at_x = x.at(series.x[i]), at_y = y.at(series.y[i]);
            points += fmt::format("{:.1f} {:.1f} ", at_x, at_y);
            dots += fmt::format(
                "<circle class=\"f{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\">{}</circle>\n", series.colour,
                at_x, at_y,
                titled(fmt::format("{}: {:.3g} at {}", series.name, series.y[i], number_text(series.x[i]))));
            if (at_x >= last_x) last_x = at_x, last_y = at_y;
        }
        if (points.empty()) continue;
        if (plot.lines)
            svg += fmt::format("<polyline class=\"l{}\" points=\"{}\"/>\n", series.colour, points);
        svg += dots;
        labels.push_back({last_y, series.name, series.colour});
    }
    svg += end_labels(std::move(labels), x.to + 12);
    return framed(svg, kTallHeight, plot.y_label + " over " + plot.x_label);
}

std::string legend_html(std::span<const LegendEntry> entries) {
    std::string html = "<p class=\"small\">";
    for (const LegendEntry& entry : entries)
        html += fmt::format("<span class=\"swatch\" style=\"background: var(--p{})\"></span>{}", entry.colour,
                            html_text(entry.name));
    return html + "</p>\n";
}

}  // namespace game
