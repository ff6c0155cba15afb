#include "game/app/poster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "game/analysis/measures.h"
#include "game/analysis/slide_parts.h"
#include "game/app/result_card.h"
#include "game/app/slide_map.h"
#include "game/base/version.h"
#include "game/compare/lettering.h"
#include "game/scene/surface.h"
#include "game/ui/card_map.h"
#include "game/ui/label_layout.h"
#include "game/ui/widgets.h"
#include "render/mountain/overview.h"
#include "render/mountain/pick.h"
#include "render/pictures/sheet.h"

namespace game {
namespace {

// px
constexpr int kPosterWidth = 2480, kPosterHeight = 1754;
constexpr float kPosterMargin = 90, kPictureTop = 220, kColumnWidth = 660, kRowsTop = 1390;
const glm::vec3 kPosterInk{24, 27, 33}, kPosterDim{104, 110, 120}, kPosterPlate{17, 21, 27},
    kPosterLight{240, 243, 246};

// One page in the making.
struct Page {
    render::Sheet sheet{kPosterWidth, kPosterHeight};
    Lettering title{68}, large{52}, usual{32}, small{26};

    void box(glm::vec2 from, glm::vec2 to, const glm::vec3& colour) {
        sheet.paint(
            from, to, [](glm::vec2) { return 1.f; }, colour);
    }
    void put(glm::vec2 corner, int width, int height, const std::vector<std::uint8_t>& pixels) {
        const auto x0 = static_cast<std::size_t>(corner.x), y0 = static_cast<std::size_t>(corner.y);
        const auto row = 3 * static_cast<std::size_t>(width);
        for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
            std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                        sheet.picture.pixels.begin() +
                            static_cast<std::ptrdiff_t>(3 * ((y0 + y) * kPosterWidth + x0)));
    }
};

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &local);
    return text.data();
}

// The pose of the scene, as wide as it would be in an image of 16 : 9.
render::Camera camera_of(const Scenario& scenario, const sim::View& world) {
    constexpr double kAspect = 16. / 9 * Poster::kPicture.height / Poster::kPicture.width, kWidest = 75;
    render::Camera camera = scenario.camera.value_or(render::overview(world));
    const double half = glm::radians(camera.field_of_view_deg) / 2;
    const double wide = glm::degrees(2 * std::atan(kAspect * std::tan(half)));
    camera.field_of_view_deg = std::max(camera.field_of_view_deg, std::min(wide, kWidest));
    return camera;
}

// Where a place of the ground is in the picture, px; nothing if it is hidden or outside.
std::optional<glm::vec2> seen_at(const Gallery& gallery, const sim::View& world, const render::Camera& camera,
                                 glm::dvec2 place) {
    constexpr double kWidth = Poster::kPicture.width, kHeight = Poster::kPicture.height;
    const glm::dvec3 at(place, surface_height(world, place)), eye = render::eye(camera);
    const glm::dvec4 clip = render::projection_matrix(camera, kWidth / kHeight) *
                            (render::view_matrix(camera) * glm::dvec4(at, 1));
    if (clip.w <= 0 || render::is_hidden(world, gallery.surroundings(), at, eye)) return std::nullopt;
    return glm::vec2((clip.x / clip.w + 1) / 2 * kWidth, (1 - clip.y / clip.w) / 2 * kHeight);
}

void label_picture(Page& page, const Poster::Subject& subject, const Gallery& gallery,
                   const render::Camera& camera, glm::vec2 corner) {
    constexpr float kEdge = 12;  // px
    const sim::View world = subject.session.view();
    SlideParts parts;
    const std::array commands{subject.commands};
    parts.find(subject.scenario, world, subject.session.peaks(), commands);
    std::vector<ui::LabelLayout::Label> labels;
    for (std::size_t i = 0; i < SlideParts::kParts; ++i) {
        const auto& place = parts.at(static_cast<SlideParts::Part>(i));
        const auto at = place ? seen_at(gallery, world, camera, *place) : std::nullopt;
        if (!at) continue;
        labels.push_back(
            {.at = {corner.x + at->x, corner.y + at->y},
             .size = {page.usual.width(SlideParts::kNames[i]) + 2 * kEdge, page.usual.height() + kEdge},
             .key = i});
    }
    const ui::Box room{
        {corner.x + kEdge, corner.y + kEdge},
        {corner.x + Poster::kPicture.width - kEdge, corner.y + Poster::kPicture.height - kEdge}};
    ui::LabelLayout().lay(labels, room, {}, page.usual.height());
    for (const ui::LabelLayout::Label& label : labels) {
        if (!label.has_room) continue;
        const glm::vec2 at(label.at.x, label.at.y), end(label.line_end.x, label.line_end.y),
            from(label.plate.from.x, label.plate.from.y), to(label.plate.to.x, label.plate.to.y);
        page.sheet.line(at, end, 7, kPosterPlate);
        page.sheet.line(at, end, 3, kPosterLight);
        page.sheet.line(at, at, 16, kPosterPlate);
        page.sheet.line(at, at, 11, kPosterLight);
        page.box(from, to, kPosterPlate);
        page.usual.write(page.sheet, from + glm::vec2(kEdge, kEdge / 2), SlideParts::kNames[label.key],
                         kPosterLight);
    }
}

using Mark = ui::SlideMap::Mark;

struct MarkName {
    Mark::Kind kind;
    const char* name;
};
constexpr std::array<MarkName, 4> kMarkNames{{{Mark::Kind::kCommand, "where it was set off"},
                                              {Mark::Kind::kIntact, "house"},
                                              {Mark::Kind::kDamaged, "damaged house"},
                                              {Mark::Kind::kDestroyed, "destroyed house"}}};

// Houses are squares, and what was done is a ring.
void draw_map_mark(Page& page, glm::vec2 at, Mark::Kind kind) {
    constexpr float kHalf = 7;
    const auto packed = ImGui::ColorConvertU32ToFloat4(ui::mark_colour(kind));
    const glm::vec3 colour = 255.f * glm::vec3(packed.x, packed.y, packed.z);
    if (kind == Mark::Kind::kCommand) {
        page.sheet.line(at, at, 3 * kHalf, kPosterInk);
        page.sheet.line(at, at, 2.2f * kHalf, colour);
        page.sheet.line(at, at, kHalf, kPosterInk);
        return;
    }
    page.box(at - kHalf - 3.f, at + kHalf + 3.f, kPosterInk);
    page.box(at - kHalf, at + kHalf, colour);
}

// A bar of a round length, and an arrow: north is up.
void draw_scale_and_north(Page& page, glm::vec2 at, double metre_px) {
    constexpr double kLongest = 320;  // px
    const double metres = ui::round_length(kLongest / metre_px);
    const glm::vec2 right = at + glm::vec2(metres * metre_px, 0);
    page.sheet.line(at, right, 4, kPosterInk);
    for (const glm::vec2 end : {at, right}) page.sheet.line(end, end - glm::vec2(0, 14), 4, kPosterInk);
    std::array<char, 40> text;
    page.small.write(page.sheet, at - glm::vec2(-4, 46), ui::write_number(text, "%.0f m", metres),
                     kPosterInk);
    const glm::vec2 foot(kPosterWidth - kPosterMargin - 24, at.y);
    page.sheet.triangle({foot - glm::vec2(0, 60), foot + glm::vec2(-16, 0), foot - glm::vec2(0, 12)},
                        kPosterInk);
    page.sheet.triangle({foot - glm::vec2(0, 60), foot + glm::vec2(16, 0), foot - glm::vec2(0, 12)},
                        kPosterDim);
    page.small.write(page.sheet, foot + glm::vec2(-48, -50), "N", kPosterInk);
}

void draw_key(Page& page, glm::vec2 at, const ui::SlideMap& map) {
    page.small.write(page.sheet, at, "largest speed along the slope, m/s", kPosterDim);
    const auto colours = speed_colours();
    const float width = (kColumnWidth - 80) / static_cast<float>(colours.size());
    at.y += 44;
    for (std::size_t i = 0; i <= colours.size(); ++i) {
        const float x = at.x + width * static_cast<float>(i);
        if (i < colours.size()) page.box({x, at.y}, {x + width, at.y + 26}, colours[i]);
        const std::string bound =
            fmt::format("{:.0f}", map.fastest * static_cast<double>(i) / static_cast<double>(colours.size()));
        page.small.write(page.sheet, {x, at.y + 32}, bound, kPosterInk);
    }
    at.y += 92;
    for (const MarkName& mark : kMarkNames) {
        if (std::ranges::find(map.marks, mark.kind, &Mark::kind) == map.marks.end()) continue;
        draw_map_mark(page, at + glm::vec2(14, 16), mark.kind);
        page.small.write(page.sheet, at + glm::vec2(46, 0), mark.name, kPosterInk);
        at.y += 40;
    }
}

// In the column on the right.
void draw_map_column(Page& page, const Poster::Subject& subject) {
    constexpr int kMapHeight = 740;
    const glm::vec2 corner(kPosterWidth - kPosterMargin - kColumnWidth, kPictureTop);
    const sim::Grid& grid = subject.scenario.grid;
    auto map = map_of_slide(subject.scenario, subject.session, subject.commands, kMapHeight);
    if (!map) return page.usual.write(page.sheet, corner, "Nothing has moved", kPosterDim);
    if (map->width > static_cast<int>(kColumnWidth))
        map = map_of_slide(subject.scenario, subject.session, subject.commands,
                           kMapHeight * static_cast<int>(kColumnWidth) / map->width);
    page.put(corner, map->width, map->height, map->texels);
    const glm::dvec2 size = map->north_east - map->south_west;
    const double metre_px = map->height / std::max(size.y, static_cast<double>(grid.dx));
    for (const Mark& mark : map->marks) {
        const glm::vec2 at = corner + glm::vec2((mark.at.x - map->south_west.x) * metre_px,
                                                (map->north_east.y - mark.at.y) * metre_px);
        const glm::vec2 end = corner + glm::vec2(map->width, map->height);
        constexpr float kInside = 14;
        if (glm::any(glm::lessThan(at, corner + kInside)) || glm::any(glm::greaterThan(at, end - kInside)))
            continue;
        draw_map_mark(page, at, mark.kind);
    }
    const float below = corner.y + static_cast<float>(map->height);
    draw_scale_and_north(page, {corner.x, below + 90}, metre_px);
    draw_key(page, {corner.x, below + 130}, *map);
}

void draw_numbers(Page& page, const Poster::Subject& subject) {
    const Measures measures =
        measure(subject.scenario, subject.session, release_area(subject.scenario, subject.commands), {});
    const ui::ResultCard card = card_of_slide(subject.scenario, measures, subject.session.seconds());
    const auto columns = static_cast<float>(std::max<std::size_t>(card.rows.size(), 1));
    glm::vec2 at(kPosterMargin, kRowsTop);
    for (const ui::ResultCard::Row& row : card.rows) {
        page.usual.write(page.sheet, at, row.label, kPosterDim);
        page.large.write(page.sheet, at + glm::vec2(0, 44), row.value, kPosterInk);
        at.x += (kPosterWidth - 2 * kPosterMargin) / columns;
    }
}

}  // namespace

Outcome<render::Picture> Poster::draw(const Subject& subject, const std::string& gl) {
    const Scenario& scenario = subject.scenario;
    auto gallery = Gallery::open(std::nullopt, kPicture, gl, scenario);
    if (!gallery) return tl::unexpected(gallery.error());
    const render::Camera camera = camera_of(scenario, subject.session.view());
    const render::Picture seen = gallery->image(subject.session, camera);

    Page page;
    const glm::vec2 corner(kPosterMargin, kPictureTop);
    page.title.write(page.sheet, {kPosterMargin, 66}, scenario.title, kPosterInk);
    page.small.write(
        page.sheet, {kPosterMargin, 152},
        fmt::format("{} on {}, {:.0f} s after the start, computed in cells of {:.3g} m", scenario.material,
                    scenario.terrain, subject.session.seconds(), static_cast<double>(scenario.grid.dx)),
        kPosterDim);
    page.put(corner, seen.width, seen.height, seen.pixels);
    label_picture(page, subject, *gallery, camera, corner);
    draw_map_column(page, subject);
    draw_numbers(page, subject);
    page.small.write(page.sheet, {kPosterMargin, kPosterHeight - kPosterMargin - 26},
                     fmt::format("{}. Recording {}, {}. A simulation, no hazard assessment.", kProgram,
                                 subject.recording, today()),
                     kPosterDim);
    return std::move(page.sheet.picture);
}

}  // namespace game
