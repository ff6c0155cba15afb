#include "game/compare/relief.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/frame/marks.h"

namespace game {
namespace {

const glm::vec3 kLit{252, 251, 247}, kShade{126, 134, 150};
const glm::vec3 kContour{60, 58, 62};

std::size_t clamped_index(const sim::Grid& grid, int x, int y) {
    return static_cast<std::size_t>(std::clamp(y, 0, grid.ny - 1)) * static_cast<std::size_t>(grid.nx) +
           static_cast<std::size_t>(std::clamp(x, 0, grid.nx - 1));
}

// Weights of the cubic B-spline's four knots around a place, and their derivatives.
struct Spline {
    std::array<float, 4> value, slope;
    explicit Spline(float t) {
        const float s = 1 - t;
        value = {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
                 t * t * t / 6};
        slope = {-s * s / 2, (3 * t * t - 4 * t) / 2, (4 * s - 3 * s * s) / 2, t * t / 2};
    }
};

double interval_of(const Scenario& scenario) {
    render::HeightRange range{1e30f, -1e30f};
    for (std::size_t i = 0; i < scenario.bedrock.size(); ++i) {
        if (!scenario.has_data[i]) continue;
        range.lowest = std::min(range.lowest, scenario.bedrock[i]);
        range.highest = std::max(range.highest, scenario.bedrock[i]);
    }
    return range.lowest <= range.highest ? render::contour_interval(range) : 1;
}

// Brightness of the ground, 0 to 1: two suns, the stronger one in the north-west, as on maps.
float lightness(glm::vec2 fall) {
    const glm::vec3 normal = glm::normalize(glm::vec3(-fall, 1));
    const float main = glm::dot(normal, glm::normalize(glm::vec3(-1, 1, 1.1f)));
    const float fill = glm::dot(normal, glm::normalize(glm::vec3(0.8f, -0.6f, 1.4f)));
    const float light = 0.70f * std::max(main, 0.f) + 0.45f * std::max(fill, 0.f);
    // Quantised in invisible steps, which halves the size of the image.
    return std::round(48 * std::clamp(light, 0.f, 1.f)) / 48;
}

}  // namespace

float between(const sim::Grid& grid, std::span<const float> field, glm::vec2 cells) {
    const glm::vec2 base = glm::floor(cells), t = cells - base;
    const int x = static_cast<int>(base.x), y = static_cast<int>(base.y);
    const auto at = [&](int i, int j) { return field[clamped_index(grid, i, j)]; };
    return glm::mix(glm::mix(at(x, y), at(x + 1, y), t.x), glm::mix(at(x, y + 1), at(x + 1, y + 1), t.x),
                    t.y);
}

Relief::Relief(const Scenario& scenario, glm::vec2 first, glm::vec2 last, glm::vec2 corner,
               float pixels_per_cell)
    : scenario_(scenario),
      first_(first),
      last_(last),
      corner_(corner),
      scale_(pixels_per_cell),
      contours_(static_cast<float>(interval_of(scenario))) {}

glm::vec2 Relief::size() const {
    return (last_ - first_ + 1.f) * scale_;
}
glm::vec2 Relief::place(glm::vec2 cells) const {
    return corner_ + glm::vec2(cells.x - first_.x + 0.5f, last_.y - cells.y + 0.5f) * scale_;
}
glm::vec2 Relief::cells(glm::vec2 place) const {
    const glm::vec2 away = (place - corner_) / scale_;
    return {first_.x + away.x - 0.5f, last_.y - away.y + 0.5f};
}

bool Relief::covers(glm::vec2 place) const {
    const glm::vec2 away = place - corner_;
    return away.x >= 0 && away.y >= 0 && away.x <= size().x && away.y <= size().y;
}

bool Relief::has_ground(glm::vec2 cells) const {
    const int x = static_cast<int>(std::lround(cells.x)), y = static_cast<int>(std::lround(cells.y));
    return scenario_.grid.contains(x, y) && scenario_.has_data[clamped_index(scenario_.grid, x, y)];
}

Relief::Ground Relief::ground(glm::vec2 cells) const {
    const glm::vec2 base = glm::floor(cells);
    const Spline along_x(cells.x - base.x), along_y(cells.y - base.y);
    const int x = static_cast<int>(base.x) - 1, y = static_cast<int>(base.y) - 1;
    Ground ground{0, {0, 0}};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const std::size_t at = clamped_index(scenario_.grid, x + i, y + j);
            const float height = scenario_.bedrock[at] + scenario_.depth[at];
            const auto ii = static_cast<std::size_t>(i), jj = static_cast<std::size_t>(j);
            ground.height += along_x.value[ii] * along_y.value[jj] * height;
            ground.fall +=
                glm::vec2(along_x.slope[ii] * along_y.value[jj], along_x.value[ii] * along_y.slope[jj]) *
                (height / scenario_.grid.dx);
        }
    return ground;
}

void Relief::draw(render::Sheet& sheet, const std::function<Tint(glm::vec2)>& tint) const {
    const glm::vec2 to = corner_ + size();
    for (int y = static_cast<int>(corner_.y); y < static_cast<int>(to.y); ++y)
        for (int x = static_cast<int>(corner_.x); x < static_cast<int>(to.x); ++x) {
            const glm::vec2 at = cells({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
            if (!has_ground(at)) continue;
            const Ground here = ground(at);
            const float light = lightness(here.fall);
            glm::vec3 colour = glm::mix(kShade, kLit, light);
            if (const Tint on = tint(at); on.share > 0)
                colour = glm::mix(colour, on.colour * (0.78f + 0.22f * light), on.share);

            const float height = static_cast<float>(scenario_.datum) + here.height;
            const float per_pixel = glm::length(here.fall) * scenario_.grid.dx / scale_ / contours_;
            const float line = height / contours_, away = std::fabs(line - std::round(line));
            const bool heavy = std::lround(line) % 5 == 0;
            const float there =
                std::clamp((heavy ? 0.85f : 0.5f) - away / std::max(per_pixel, 1e-4f) + 0.5f, 0.f, 1.f);
            const float level = std::clamp(glm::length(here.fall) / 0.03f, 0.f, 1.f);
            colour = glm::mix(colour, kContour, there * level * (heavy ? 0.42f : 0.22f));

            std::uint8_t* pixel =
                &sheet.picture.pixels[3 * (static_cast<std::size_t>(y) *
                                               static_cast<std::size_t>(sheet.picture.width) +
                                           static_cast<std::size_t>(x))];
            for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(std::lround(colour[c]));
        }
}

void Relief::outline(render::Sheet& sheet, std::span<const float> field, float level, float width, float dash,
                     const glm::vec3& colour) const {
    const auto value = [&](glm::vec2 pixel) { return between(scenario_.grid, field, cells(pixel)) - level; };
    const glm::vec2 right(0.5f, 0), down(0, 0.5f);
    sheet.paint(
        corner_, corner_ + size() - 1.f,
        [&](const glm::vec2& pixel) {
            const glm::vec2 steep(value(pixel + right) - value(pixel - right),
                                  value(pixel + down) - value(pixel - down));
            const float length = glm::length(steep);
            if (length < 1e-7f) return 0.f;
            if (dash > 0 && std::fmod(pixel.x + pixel.y, 2 * dash) > 1.2f * dash) return 0.f;
            return width / 2 + 0.5f - std::fabs(value(pixel)) / length;
        },
        colour);
}

}  // namespace game
