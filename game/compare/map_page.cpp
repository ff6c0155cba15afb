#include "game/compare/map_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace game {
namespace {

constexpr float kMargin = 28, kGap = 34, kMap = 760;  // px
constexpr float kLeastPageHeight = 720;
constexpr float kIndent = 38;  // of a legend entry's text
const glm::vec3 kText{38, 40, 46}, kDim{110, 114, 122};

// The greatest 1, 2 or 5 times a power of ten that is at most this.
double round_step(double most) {
    const double power = std::pow(10, std::floor(std::log10(most)));
    for (const double times : {5.0, 2.0})
        if (times * power <= most) return times * power;
    return power;
}

// Room on the left, for northings where there are any.
float margin_left(const Scenario& scenario) {
    constexpr float kNorthing = 56;
    return scenario.georeference.has_coordinates() ? kMargin + kNorthing : kMargin;
}

Relief relief_for(const Scenario& scenario, const MapFrame& frame) {
    const glm::ivec2 cells = frame.last - frame.first + 1;
    return {scenario,
            frame.first,
            frame.last,
            {margin_left(scenario), kMargin},
            kMap / static_cast<float>(std::max(cells.x, cells.y))};
}

render::Sheet sheet_for(const Scenario& scenario, const Relief& relief) {
    const glm::vec2 map = relief.size();
    return {static_cast<int>(std::ceil(margin_left(scenario) + map.x + kMargin + kGap + MapPage::kColumn)),
            static_cast<int>(std::ceil(std::max(map.y + 2 * kMargin, kLeastPageHeight)))};
}

}  // namespace

MapFrame frame_around(const sim::Grid& grid, const std::function<bool(std::size_t)>& shows) {
    const glm::ivec2 most(grid.nx - 1, grid.ny - 1);
    glm::ivec2 first = most, last(0);
    std::size_t i = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x, ++i)
            if (shows(i)) first = glm::min(first, glm::ivec2(x, y)), last = glm::max(last, glm::ivec2(x, y));
    if (first.x > last.x) return {{0, 0}, most};
    const glm::ivec2 cells = last - first + 1;
    const int room = std::max(4, std::max(cells.x, cells.y) / 8);
    const glm::ivec2 narrow = glm::max(glm::ivec2(0), glm::ivec2(cells.y, cells.x) / 2 - cells) / 2;
    return {glm::max(first - narrow - room, glm::ivec2(0)), glm::min(last + narrow + room, most)};
}

MapPage::MapPage(const Scenario& scenario)
    : MapPage(scenario, {{0, 0}, {scenario.grid.nx - 1, scenario.grid.ny - 1}}) {}

MapPage::MapPage(const Scenario& scenario, const MapFrame& frame)
    : scenario_(scenario),
      relief_(relief_for(scenario, frame)),
      sheet_(sheet_for(scenario, relief_)),
      large_(26),
      usual_(17),
      small_(14),
      pen_(margin_left(scenario) + relief_.size().x + kGap, kMargin - 4) {}

void MapPage::write(const Lettering& letters, const std::string& text, const glm::vec3& colour) {
    std::istringstream words(text);
    std::string line;
    const float room = static_cast<float>(sheet_.picture.width) - kMargin / 2 - pen_.x;
    const auto end_line = [&] {
        letters.write(sheet_, pen_, line, colour);
        pen_.y += std::round(letters.height() * 1.25f);
        line.clear();
    };
    for (std::string word; words >> word;) {
        std::string longer = line;
        if (!line.empty()) longer += ' ';
        longer += word;
        if (!line.empty() && letters.width(longer) > room) {
            end_line();
            longer = word;
        }
        line = longer;
    }
    end_line();
}

void MapPage::title(const std::string& text) {
    write(large_, text, kText);
}
void MapPage::say(const std::string& text) {
    write(usual_, text, kText);
}
void MapPage::whisper(const std::string& text) {
    write(small_, text, kDim);
}

void MapPage::swatch(const glm::vec3& colour, const std::string& meaning) {
    const float middle = pen_.y + usual_.height() / 2 + 1;
    sheet_.paint(
        {pen_.x, pen_.y - 2}, {pen_.x + 25, pen_.y + usual_.height() + 2},
        [](const glm::vec2&) { return 1.f; }, colour);
    usual_.write(sheet_, {pen_.x + kIndent, middle - usual_.height() / 2 - 1}, meaning, kText);
    pen_.y += usual_.height() + 5;
}

void MapPage::stroke(float width, float dash, const glm::vec3& colour, const std::string& meaning) {
    const float middle = std::round(pen_.y + usual_.height() / 2) + 0.5f;
    const float step = dash > 0 ? 2 * dash : 26;
    for (int i = 0; static_cast<float>(i) * step < 25; ++i) {
        const float x = static_cast<float>(i) * step;
        sheet_.line({pen_.x + x, middle}, {pen_.x + std::min(x + (dash > 0 ? dash : 26), 26.f), middle},
                    width, colour);
    }
    usual_.write(sheet_, {pen_.x + kIndent, pen_.y}, meaning, kText);
    pen_.y += usual_.height() + 6;
}

void MapPage::ring(const glm::vec3& colour, const std::string& meaning) {
    draw_ring(pen_ + glm::vec2(13, usual_.height() / 2), 8, colour);
    usual_.write(sheet_, {pen_.x + kIndent, pen_.y}, meaning, kText);
    pen_.y += usual_.height() + 6;
}

void MapPage::coordinates() {
    const terrains::Georeference& place = scenario_.georeference;
    if (!place.has_coordinates()) return;
    const double dx = scenario_.grid.dx;
    const glm::vec2 size = relief_.size(), corner = relief_.corner();
    constexpr float kTick = 5;
    constexpr double kBetween = 170;  // px, about
    const double step = round_step(kBetween * dx / static_cast<double>(relief_.pixels_per_cell()));
    // Calls mark(place) for each multiple of the step from one place to another.
    const auto each_step = [step](double from, double to, const auto& mark) {
        for (auto i = static_cast<std::int64_t>(std::ceil(from / step)); static_cast<double>(i) * step <= to;
             ++i)
            mark(static_cast<double>(i) * step);
    };
    const glm::vec2 low = relief_.cells(corner + glm::vec2(0, size.y)),
                    high = relief_.cells(corner + glm::vec2(size.x, 0));
    const auto east = [&](float cells) { return place.origin_x() + static_cast<double>(cells) * dx; };
    const auto north = [&](float cells) { return place.origin_y() + static_cast<double>(cells) * dx; };
    each_step(east(low.x), east(high.x), [&](double at) {
        const float x = relief_.place({static_cast<float>((at - place.origin_x()) / dx), 0}).x,
                    y = corner.y + size.y;
        sheet_.line({x, y - kTick}, {x, y + 2}, 1.2f, kDim);
        const std::string text = fmt::format("{:.0f}", at);
        small_.write(sheet_, {x - small_.width(text) / 2, y + 4}, text, kDim);
    });
    each_step(north(low.y), north(high.y), [&](double at) {
        const float y = relief_.place({0, static_cast<float>((at - place.origin_y()) / dx)}).y;
        sheet_.line({corner.x - 2, y}, {corner.x + kTick, y}, 1.2f, kDim);
        const std::string text = fmt::format("{:.0f}", at);
        small_.write(sheet_, {corner.x - 6 - small_.width(text), y - small_.height() / 2}, text, kDim);
    });
}

void MapPage::scale_bar() {
    const double metres_per_pixel = static_cast<double>(scenario_.grid.dx / relief_.pixels_per_cell());
    const double metres = round_step(0.55 * static_cast<double>(kColumn) * metres_per_pixel);
    const auto length = static_cast<float>(metres / metres_per_pixel);
    const float y =
        std::round(std::max(pen_.y + 40, static_cast<float>(sheet_.picture.height) - kMargin)) - 2.5f;
    const glm::vec2 left(pen_.x, y), right(pen_.x + length, y);
    sheet_.line(left, right, 2, kText);
    for (const glm::vec2& end : {left, right}) sheet_.line(end - glm::vec2(0, 6), end, 2, kText);
    usual_.write(sheet_, left - glm::vec2(-2, 27), fmt::format("{:g} m", metres), kText);

    const glm::vec2 foot(pen_.x + kColumn - 26, y);
    sheet_.triangle({foot + glm::vec2(-8, 0), foot + glm::vec2(8, 0), foot - glm::vec2(0, 26)}, kText);
    usual_.write(sheet_, foot - glm::vec2(usual_.width("N") / 2, 46), "N", kText);
}

void MapPage::draw_ring(glm::vec2 at, float radius, const glm::vec3& colour) {
    const glm::vec3 kHalo{255, 255, 255};
    for (const auto& [width, ink] : {std::pair{5.f, kHalo}, std::pair{2.2f, colour}})
        sheet_.paint(
            at - radius - 4.f, at + radius + 4.f,
            [&, half = width / 2](const glm::vec2& pixel) {
                return half + 0.5f - std::fabs(glm::length(pixel - at) - radius);
            },
            ink);
}

void MapPage::draw_box(glm::vec2 from, glm::vec2 to, float thickness, const glm::vec3& colour) {
    const glm::vec2 corners[] = {from, {to.x, from.y}, to, {from.x, to.y}};
    for (int i = 0; i < 4; ++i) sheet_.line(corners[i], corners[(i + 1) % 4], thickness, colour);
}

}  // namespace game
