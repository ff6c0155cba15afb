#include "game/figures/page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "game/pages/html.h"
#include "render/frame/marks.h"

namespace game {
namespace {

constexpr const char* kTitle = "Texture advection on discontinuous flows: the figures";
constexpr const char* kIntroduction =
    R"(<p>After Rodríguez-Cerro, García-Fernández, Martínez-Durá and Pla-Castells. Figures have the paper's numbers. Left: the
textures travel as if there were no fronts. Right: the same textures with the mesh cut along the fronts.</p>
)";

// Legend of the overlay's colours.
std::string legend_of_stretch() {
    const render::Legend legend = render::legend_of(render::Overlay::kStretch);
    std::string html = "<p class=\"small\">Stretch, greatest over least:";
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
    std::string html = begin_page(kTitle, "") + kIntroduction;
    for (const PageFigure& figure : figures) html += html_of(figure);
    if (!tables.empty())
        html +=
            "<h2 id=\"numbers\">In numbers</h2>\n<p>The same with more digits: <a "
            "href=\"numbers.csv\">numbers.csv</a>.</p>\n";
    for (const Table& table : tables) html += as_html(table);
    return html + end_page(made_by);
}

}  // namespace game
