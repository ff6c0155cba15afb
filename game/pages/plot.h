#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace game {

// Plots as SVG elements to stand in a page whose style gives the colours: --p0, --p1, … for what is shown,
// --line for axes, the text's colour for the rest. Texts are plain UTF-8.

// Layers on top of each other over x.
struct StackedPlot {
    std::string x_label, y_label;
    std::vector<double> x;  // ascending, two at least
    struct Layer {
        std::string name;
        int colour;
        std::vector<double> y;  // ≥ 0, as many as x
    };
    std::vector<Layer> layers;  // the lowest first
};
std::string svg_of(const StackedPlot& plot);

// How often values come, over a logarithmic axis, with marks at some of them.
struct DistributionPlot {
    std::string x_label;
    std::vector<double> values;  // > 0; others are left out
    struct Mark {
        std::string name;
        double value;
    };
    std::vector<Mark> marks;
};
std::string svg_of(const DistributionPlot& plot);

// Bars of parts, one below the other.
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

// Series over logarithmic axes. Points that are not above 0 are left out.
struct LogPlot {
    std::string x_label, y_label;
    struct Series {
        std::string name;
        int colour;
        std::vector<double> x, y;
    };
    std::vector<Series> series;
    bool lines = true;  // else points alone
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
