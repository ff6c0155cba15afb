#include "game/compare/desync_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "game/compare/map_page.h"
#include "game/recording/divergence_report.h"

namespace game {
namespace {

// Vermilion and ink differ for every kind of colour vision, also by lightness.
const glm::vec3 kDiffers{213, 70, 0}, kInk{20, 20, 24}, kTile{0, 90, 150};
constexpr int kAround = 6;       // cells shown on each side of the first
constexpr float kLarge = 25;     // px, an enlarged cell
constexpr float kLeastMark = 4;  // px, a differing cell on the map

bool differs(const Divergence& parted, const sim::Grid& grid, int x, int y) {
    return grid.contains(x, y) &&
           parted.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) +
                        static_cast<std::size_t>(x)] != 0;
}

auto tint_of(const Divergence& parted, const sim::Grid& grid) {
    return [&parted, &grid](glm::vec2 cells) {
        const bool there = differs(parted, grid, static_cast<int>(std::lround(cells.x)),
                                   static_cast<int>(std::lround(cells.y)));
        return Relief::Tint{kDiffers, there ? 0.85f : 0.f};
    };
}

// Marks cells that would be lost among the pixels of a fine grid.
void mark_small_cells(MapPage& page, const Divergence& parted, const sim::Grid& grid) {
    if (page.relief().pixels_per_cell() >= kLeastMark) return;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            if (differs(parted, grid, x, y)) {
                const glm::vec2 at = page.relief().place({x, y});
                page.sheet().line(at, at, kLeastMark, kDiffers);
            }
}

void draw_tile(MapPage& page, const Divergence& parted, const sim::Grid& grid) {
    const glm::ivec2 size(parted.tile_width, parted.tile_height);
    const glm::ivec2 from = size * glm::ivec2(parted.tile_x, parted.tile_y);
    const glm::ivec2 to(std::min(from.x + size.x, grid.nx), std::min(from.y + size.y, grid.ny));
    page.draw_box(page.relief().place(glm::vec2(from) - 0.5f), page.relief().place(glm::vec2(to) - 0.5f),
                  1.6f, kTile);
}

// Draws the first cell and its surroundings at the pen of the column.
void draw_large(MapPage& page, const Divergence& parted, const Scenario& scenario, glm::ivec2 cell) {
    const glm::vec2 middle(std::clamp(cell.x, 0, scenario.grid.nx - 1),
                           std::clamp(cell.y, 0, scenario.grid.ny - 1));
    const float reach = kAround;
    const Relief near(scenario, middle - reach, middle + reach, page.pen(), kLarge);
    near.draw(page.sheet(), tint_of(parted, scenario.grid));
    for (int i = 0; i <= 2 * kAround + 1; ++i) {
        const float away = static_cast<float>(i) * kLarge;
        const glm::vec3 kGrid{150, 154, 160};
        page.sheet().line(page.pen() + glm::vec2(away, 0), page.pen() + glm::vec2(away, near.size().y), 0.6f,
                          kGrid);
        page.sheet().line(page.pen() + glm::vec2(0, away), page.pen() + glm::vec2(near.size().x, away), 0.6f,
                          kGrid);
    }
    page.draw_box(near.place(middle - 0.5f), near.place(middle + 0.5f), 3, kInk);
    page.skip(near.size().y + 14);
}

}  // namespace

render::Picture desync_picture(const Divergence& parted, const Scenario& scenario,
                               const std::array<std::string, 2>& names) {
    MapPage page(scenario);
    page.relief().draw(page.sheet(), tint_of(parted, scenario.grid));
    mark_small_cells(page, parted, scenario.grid);

    page.title(parted.where == Divergence::Where::kStart ? "They part at the start"
                                                         : fmt::format("They part in tick {}", parted.tick));
    page.say(fmt::format("{} and {}", names[0], names[1]));
    page.skip(8);
    if (!parted.fields.empty()) {
        const FieldDifference& first = parted.fields.front();
        draw_tile(page, parted, scenario.grid);
        page.draw_ring(page.relief().place({first.x, first.y}), 15, kInk);
        draw_large(page, parted, scenario, {first.x, first.y});
        page.say(stage_text(parted, names));
        page.say(fmt::format("{} at cell {}, {}", first.field, first.x, first.y));
        for (const auto& value : first.values) page.say(fmt::format("{:08x} = {}", value.bits, value.number));
        page.say(fmt::format("{} ULP{} apart", first.ulps, first.ulps > 1 ? "s" : ""));
    } else {
        page.say(stage_text(parted, names));
    }
    page.skip(10);
    page.swatch(kDiffers,
                fmt::format("{} of {} cells differ at its end", differing(parted), parted.cells.size()));
    page.skip(4);
    if (!parted.fields.empty()) {
        page.ring(kInk, "the first of them, enlarged above");
        page.stroke(1.6f, 0, kTile, fmt::format("its tile, {}x{}", parted.tile_width, parted.tile_height));
    }
    page.scale_bar();
    return page.sheet().picture;
}

}  // namespace game
