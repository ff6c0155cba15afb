#include "game/figures/gallery_page.h"

#include <fmt/format.h>

#include "game/pages/html.h"
#include "game/pages/table.h"

namespace game {
namespace {

// Neutral and dark in both themes, so that nothing beside an image changes how light it looks.
constexpr const char* kStyle =
    R"(:root { color-scheme: dark; --paper: #1c1c1c; --ink: #ddd; --soft: #a0a0a0; --line: #3c3c3c; }
@media (prefers-color-scheme: dark) { :root { --paper: #1c1c1c; --ink: #ddd; --soft: #a0a0a0; --line: #3c3c3c; } }
body { max-width: none; }
.views { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 760px), 1fr)); gap: 36px 24px; }
.views h2 { margin: .5em 0 0; } .views img { width: 100%; }
)";

std::string ms_text(double ms) {
    return fmt::format("{:.2f}", ms);
}

Table times_table(const DrawnView& view) {
    Table table{"Milliseconds per pass", {"quality"}, {}};
    table.head.insert(table.head.end(), render::kPassNames.begin(), render::kPassNames.end());
    table.head.emplace_back("sum");
    for (const auto& [quality, times] :
         {std::pair("moving", view.moving), std::pair("fast", view.fast), std::pair("fine", view.fine)}) {
        std::vector<std::string> row{quality};
        for (const double ms : times.ms) row.push_back(ms_text(ms));
        row.push_back(ms_text(times.sum()));
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string html_of(const DrawnView& view) {
    const render::Camera& c = view.camera;
    return fmt::format(
        "<figure>\n<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a>\n<h2>{1}</h2>\n<figcaption>Scene {2}, "
        "tick {3}{15}, state {4}. Camera: target {5:.0f}, {6:.0f}, {7:.0f} m, azimuth {8:g}°, elevation "
        "{9:g}°, "
        "distance {10:.0f} m, field of view {11:g}°. Sun: azimuth {12:g}°, elevation {13:g}°.</figcaption>\n"
        "<div class=\"wide\">{14}</div>\n</figure>\n",
        html_text(view.file), html_text(view.title), html_text(view.scene), view.tick, view.state_hash,
        c.target.x, c.target.y, c.target.z, c.azimuth_deg, c.elevation_deg, c.distance_m, c.field_of_view_deg,
        view.light.azimuth_deg, view.light.elevation_deg, as_html(times_table(view)),
        view.still_moving ? ", still moving after an hour" : "");
}

}  // namespace

std::string gallery_page(std::span<const DrawnView> views, const render::DrawnBy& drawn_by,
                         const std::string& note, const std::string& made_by, std::optional<int> reload_s) {
    std::string html = begin_page("Couloir: fixed views", kStyle, reload_s);
    html += fmt::format(
        "<p>{} {} views by {}, {}. Times: {}, of a frame whose world is that of the frame before. Quality "
        "fast has one sample per pixel, fine has four; the images are fine.</p>\n<div class=\"views\">\n",
        html_text(note), views.size(), html_text(drawn_by.renderer), html_text(drawn_by.quality),
        render::to_string(drawn_by.timing));
    for (const DrawnView& view : views) html += html_of(view);
    return html + "</div>\n" + end_page(made_by);
}

}  // namespace game
