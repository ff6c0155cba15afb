#include "game/figures/field_figure.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "render/pictures/sheet.h"

namespace game {
namespace {

using sim::fields::TestFlow;

// Okabe and Ito's palette, safe for colour-blind viewers.
constexpr glm::vec3 kArrow{70, 70, 70}, kFront{213, 94, 0};
constexpr int kArrows = 9;  // along each side

// The unit square on the sheet.
class Plan {
  public:
    explicit Plan(int pixels) : side_(static_cast<float>(pixels)) {}
    glm::vec2 on_sheet(const glm::dvec2& x) const { return {to_pixels(x.x), side_ - to_pixels(x.y)}; }
    glm::dvec2 in_flow(const glm::vec2& at) const { return {at.x / side_, 1 - at.y / side_}; }
    float to_pixels(double metres) const { return static_cast<float>(metres) * side_; }

  private:
    float side_;
};

void draw_arrow(render::Sheet& sheet, const glm::vec2& from, const glm::vec2& to, float thickness) {
    const float length = glm::distance(from, to);
    const glm::vec2 ahead = (to - from) / length, aside(-ahead.y, ahead.x);
    const float head = std::min(5 * thickness, 0.6f * length);
    const glm::vec2 neck = to - head * ahead;
    sheet.line(from, neck, thickness, kArrow);
    sheet.triangle({to, neck + 0.45f * head * aside, neck - 0.45f * head * aside}, kArrow);
}

// Skip arrows that cross a front, because they would hide it.
void draw_arrows(render::Sheet& sheet, const Plan& plan, const TestFlow& flow, double time) {
    constexpr double kLongest = 0.78 / kArrows, kAway = 0.012;  // m
    double fastest = 1e-9;
    const auto each = [&](const auto& visit) {
        for (int y = 0; y < kArrows; ++y)
            for (int x = 0; x < kArrows; ++x) {
                const glm::dvec2 at((x + 0.5) / kArrows, (y + 0.5) / kArrows);
                visit(at, glm::dvec2(flow.velocity(at, time)));
            }
    };
    each([&](const glm::dvec2&, const glm::dvec2& velocity) {
        fastest = std::max(fastest, glm::length(velocity));
    });
    each([&](const glm::dvec2& at, const glm::dvec2& velocity) {
        const glm::dvec2 half = kLongest / 2 / fastest * velocity;
        const auto is_free = [&](const glm::dvec2& end) {
            return flow.region(end, time) == flow.region(at, time) && flow.distance(end, time) > kAway;
        };
        if (glm::length(velocity) > 0 && is_free(at - half) && is_free(at + half))
            draw_arrow(sheet, plan.on_sheet(at - half), plan.on_sheet(at + half), plan.to_pixels(0.005));
    });
}

void draw_border(render::Sheet& sheet, int pixels) {
    const float side = static_cast<float>(pixels);
    const glm::vec2 corner[] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    for (int k = 0; k < 4; ++k) sheet.line(corner[k], corner[(k + 1) % 4], 3, kArrow);
}

// Centres of dashes: points on the front, found row by row, each at least one dash spacing from all before
// it. This does not need to trace the fronts, of which there may be many.
std::vector<glm::vec2> middles_of_dashes(const Plan& plan, const TestFlow& flow, double time, float apart) {
    std::vector<glm::vec2> middles;
    const int pixels = static_cast<int>(plan.to_pixels(1));
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            const glm::vec2 at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            if (plan.to_pixels(flow.distance(plan.in_flow(at), time)) > 0.75f) continue;
            const auto is_near = [&](const glm::vec2& other) { return glm::distance(at, other) < apart; };
            if (std::none_of(middles.begin(), middles.end(), is_near)) middles.push_back(at);
        }
    return middles;
}

void draw_front(render::Sheet& sheet, const Plan& plan, const TestFlow& flow, double time) {
    const float dash = plan.to_pixels(0.032), thickness = plan.to_pixels(0.009);
    for (const glm::vec2& middle : middles_of_dashes(plan, flow, time, plan.to_pixels(0.05)))
        sheet.paint(
            middle - dash / 2, middle + dash / 2,
            [&](const glm::vec2& at) {
                const float away = plan.to_pixels(flow.distance(plan.in_flow(at), time));
                return std::min(thickness / 2 - away, dash / 2 - glm::distance(at, middle)) + 0.5f;
            },
            kFront);
}

}  // namespace

render::Picture field_picture(const TestFlow& flow, double time, int pixels) {
    render::Sheet sheet(pixels, pixels);
    const Plan plan(pixels);
    draw_arrows(sheet, plan, flow, time);
    draw_front(sheet, plan, flow, time);
    draw_border(sheet, pixels);
    return std::move(sheet.picture);
}

}  // namespace game
