#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace game {

// Plots as SVG elements for a page whose style sets the colours: --p0, --p1, … for data, --line for axes, the
// text colour for the rest. Strings are plain UTF-8.

// Stacked layers over x.
struct StackedPlot {
    std::string x_label, y_label;
    std::vector<double> x;  // ascending, at least two
    struct Layer {
        std::string name;
        int colour;
        std::vector<double> y;  // ≥ 0, one per x
    };
    std::vector<Layer> layers;  // lowest first
};
std::string svg_of(const StackedPlot& plot);

// CSS of a page with plots, with this many colours for data: Okabe and Ito's, safe for colour-blind viewers, and greys.
std::string plot_style(std::size_t colours);
// A plot with a sentence below it.
std::string figure_html(const std::string& svg, const std::string& caption);

// A distribution of values, with marks at some values.
struct DistributionPlot {
    std::string x_label, y_label;
    std::vector<double> values;
    bool logarithmic = false;  // its axis; values that are not above 0 are skipped then
    struct Mark {
        std::string name;
        double value;
    };
    std::vector<Mark> marks;
};
std::string svg_of(const DistributionPlot& plot);

// Points over linear axes.
struct ScatterPlot {
    std::string x_label, y_label;
    std::vector<double> x, y;
    int colour = 0;
};
std::string svg_of(const ScatterPlot& plot);

// Stacked bars, one below the other.
struct BarPlot {
    std::string x_label;
    struct Bar {
        std::string name;
        struct Piece {
            std::string name;
            int colour;
            double value;  // ≥ 0
        };
        std::vector<Piece> pieces;
    };
    std::vector<Bar> bars;
};
std::string svg_of(const BarPlot& plot);

// Series over logarithmic axes. Points that are not above 0 are skipped.
struct LogPlot {
    std::string x_label, y_label;
    struct Series {
        std::string name;
        int colour;
        std::vector<double> x, y;
    };
    std::vector<Series> series;
    bool lines = true;  // false: points only
};
std::string svg_of(const LogPlot& plot);

// About `count` round numbers from `least` to `most`.
std::vector<double> round_numbers(double least, double most, int count);

// A row of swatches with names.
struct LegendEntry {
    std::string name;
    int colour;
};
std::string legend_html(std::span<const LegendEntry> entries);

}  // namespace game
