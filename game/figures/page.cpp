#include "game/figures/page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "render/marks.h"

namespace game {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Texture advection on discontinuous flows: the figures</title>
<style>
body { font: 16px/1.5 system-ui, sans-serif; color: #222; background: #fff; max-width: 1320px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; } h2 { font-size: 1.25em; margin: 2.2em 0 .2em; } h3 { font-size: 1em; margin: 1.6em 0 .4em; }
p { max-width: 46em; margin: .3em 0 .8em; }
.row { display: flex; flex-wrap: wrap; gap: 12px; align-items: flex-start; }
figure { margin: 0; flex: 1 1 300px; } figure.large { flex-basis: 100%; } img { max-width: 100%; display: block; }
figcaption, .small { font-size: .87em; color: #555; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .87em; font-variant-numeric: tabular-nums; }
th, td { padding: .18em .7em; text-align: right; white-space: nowrap; border-bottom: 1px solid #ddd; }
th:first-child, td:first-child { text-align: left; }
.swatch { display: inline-block; width: 1.1em; height: 1.1em; vertical-align: -.2em; margin: 0 .3em 0 .9em; border: 1px solid #999; }
</style>
</head>
<body>
<h1>Texture advection on discontinuous flows: the figures</h1>
<p>After Rodríguez-Cerro, García-Fernández, Martínez-Durá and Pla-Castells. Figures have the paper's numbers. Left: the
textures travel as if there were no fronts. Right: the same textures with the mesh cut along the fronts.</p>
)";

// What the colours of the overlay mean.
std::string legend_of_stretch() {
    const render::Legend legend = render::legend_of(render::Overlay::kStretch);
    std::string html = "<p class=\"small\">Drawn out, greatest over least stretch:";
    for (const render::LegendStop& stop : legend.stops) {
        const auto byte = [](float share) { return std::lround(255 * share); };
        html += fmt::format("<span class=\"swatch\" style=\"background: rgb({}, {}, {})\"></span>{:g}",
                            byte(stop.colour.r), byte(stop.colour.g), byte(stop.colour.b), stop.value);
    }
    return html + "</p>\n";
}

std::string html_of(const PageFigure& figure) {
    std::string html =
        fmt::format("<h2 id=\"figure-{0}\">Figure {0}: {1}</h2>\n<p>{2}</p>\n<div class=\"row\">\n",
                    figure.number, html_text(figure.title), html_text(figure.caption));
    for (const auto& [file, note] : figure.pictures)
        html += fmt::format(
            "<figure{0}><a href=\"{1}\"><img src=\"{1}\" alt=\"Figure {2}: "
            "{3}\"></a><figcaption>{3}</figcaption></figure>\n",
            figure.pictures.size() == 1 ? " class=\"large\"" : "", html_text(file), figure.number,
            html_text(note));
    return html + "</div>\n" + (figure.stretch ? legend_of_stretch() : "");
}

}  // namespace

std::string page_of(std::span<const PageFigure> figures, std::span<const Table> tables,
                    const std::string& made_by) {
    std::string html = kHead;
    for (const PageFigure& figure : figures) html += html_of(figure);
    if (!tables.empty())
        html +=
            "<h2 id=\"numbers\">In numbers</h2>\n<p>The same with more digits: <a "
            "href=\"numbers.csv\">numbers.csv</a>.</p>\n";
    for (const Table& table : tables) html += as_html(table);
    return html + fmt::format("<p class=\"small\">Made by {}.</p>\n</body>\n</html>\n", html_text(made_by));
}

}  // namespace game
