#include "game/compare/difference_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "game/compare/comparison.h"
#include "game/compare/map_page.h"

namespace game {
namespace {

// From small to large.
const std::array<glm::vec3, 4> kMore{{{244, 165, 130}, {214, 96, 77}, {178, 24, 43}, {103, 0, 31}}};
const std::array<glm::vec3, 4> kLess{{{146, 197, 222}, {67, 147, 195}, {33, 102, 172}, {5, 48, 97}}};
const glm::vec3 kNone{226, 225, 222};
constexpr std::array<float, 4> kClasses{0.05f, 0.2f, 0.5f, 1.f};  // lower bounds, relative to the greatest
const glm::vec3 kFirst{20, 20, 24}, kSecond{0, 110, 60};

// The greatest of 1, 2 or 5 times a power of ten that one in a hundred of the nonzero values reaches.
float greatest_class(std::vector<float> values) {
    values.erase(std::remove(values.begin(), values.end(), 0.f), values.end());
    if (values.empty()) return 1;
    for (float& value : values) value = std::fabs(value);
    const auto high = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
    std::nth_element(values.begin(), high, values.end());
    const float power = std::pow(10.f, std::floor(std::log10(*high)));
    for (const float times : {5.f, 2.f})
        if (*high >= times * power) return times * power;
    return power;
}

Relief::Tint tint_of(float value, float greatest) {
    const float size = std::fabs(value) / greatest;
    const auto above = std::upper_bound(kClasses.begin(), kClasses.end(), size);
    if (above == kClasses.begin()) return {};
    const auto place = static_cast<std::size_t>(above - kClasses.begin()) - 1;
    return {(value > 0 ? kMore : kLess)[place], 0.94f};
}

void explain_colours(MapPage& page, float greatest) {
    const auto bound = [&](std::size_t i) { return kClasses[i] * greatest; };
    const auto label = [&](std::size_t i, const char* sign) {
        return i + 1 == kClasses.size() ? fmt::format("beyond {}{:g} m", sign, bound(i))
                                        : fmt::format("{0}{1:g} to {0}{2:g} m", sign, bound(i), bound(i + 1));
    };
    for (std::size_t i = kClasses.size(); i-- > 0;) page.swatch(kMore[i], label(i, "+"));
    page.swatch(kNone, fmt::format("less than {:g} m apart", bound(0)));
    for (std::size_t i = 0; i < kClasses.size(); ++i) page.swatch(kLess[i], label(i, "−"));
}

// Where anything moved or differs.
MapFrame frame_of(const Comparison& comparison) {
    return frame_around(comparison.a.session.state().grid, [&](std::size_t i) {
        const float peak =
            std::max(comparison.a.session.peaks().depth[i], comparison.b.session.peaks().depth[i]);
        return peak >= Measures::kExtentDepth || comparison.deposit[i] != 0;
    });
}

// Draws a ring around each command with a place that `a` has and `b` lacks. Returns whether there was one.
bool ring_commands(MapPage& page, const Played& a, const Played& b, const glm::vec3& colour) {
    const auto& others = b.of.recording.commands;
    const auto cell = static_cast<double>(a.session.state().grid.dx);
    bool any = false;
    for (const TimedCommand& each : a.of.recording.commands) {
        if (each.command.kind == sim::CommandKind::kSet) continue;
        const bool shared = std::any_of(others.begin(), others.end(), [&](const TimedCommand& other) {
            return other.tick == each.tick && other.command == each.command;
        });
        if (shared) continue;
        const glm::vec2 at = page.relief().place({each.command.x / cell, each.command.y / cell});
        if (!page.relief().covers(at)) continue;
        const auto radius = static_cast<float>(each.command.radius / cell) * page.relief().pixels_per_cell();
        page.draw_ring(at, std::clamp(radius, 5.f, 200.f), colour);
        any = true;
    }
    return any;
}

}  // namespace

render::Picture difference_map(const Comparison& comparison, MapOf of) {
    const Scenario& scenario = comparison.a.of.recording.header.scenario;
    const std::vector<float>& field = of == MapOf::kDeposit ? comparison.deposit : comparison.peak_depth;
    const float greatest = greatest_class(field);
    MapPage page(scenario, frame_of(comparison));
    page.relief().draw(page.sheet(), [&](glm::vec2 cells) {
        return tint_of(between(scenario.grid, field, cells), greatest);
    });
    const auto outline = [&](const Played& played, float dash, const glm::vec3& colour) {
        page.relief().outline(page.sheet(), played.session.peaks().depth, Measures::kExtentDepth, 1.4f, dash,
                              colour);
    };
    outline(comparison.a, 0, kFirst), outline(comparison.b, 5, kSecond);
    const bool first_rings = ring_commands(page, comparison.a, comparison.b, kFirst);
    const bool second_rings = ring_commands(page, comparison.b, comparison.a, kSecond);

    page.title(of == MapOf::kDeposit ? "Deposit difference" : "Peak depth difference");
    page.say(fmt::format("{} minus {}", comparison.b.of.name, comparison.a.of.name));
    page.skip(12);
    explain_colours(page, greatest);
    page.skip(12);
    page.stroke(1.6f, 0, kFirst, "extent of " + comparison.a.of.name);
    page.stroke(1.6f, 5, kSecond, "extent of " + comparison.b.of.name);
    if (first_rings) page.ring(kFirst, fmt::format("command of {} only", comparison.a.of.name));
    if (second_rings) page.ring(kSecond, fmt::format("command of {} only", comparison.b.of.name));
    page.skip(12);
    const Measures &a = comparison.a.measures, &b = comparison.b.measures;
    page.say(fmt::format("run-out {:.0f} m, was {:.0f}", b.run_out, a.run_out));
    page.say(fmt::format("extent {:.2f} ha, was {:.2f}", b.extent_area / 1e4, a.extent_area / 1e4));
    page.say(
        fmt::format("peak speed on slope {:.1f} m/s, was {:.1f}", b.peak_speed_slope, a.peak_speed_slope));
    if (of == MapOf::kDeposit)
        page.say(fmt::format("{:.0f} m³ more, {:.0f} m³ less", comparison.more, comparison.less));
    page.skip(10);
    page.whisper(scenario.terrain + (scenario.licence.empty() ? "" : ". " + scenario.licence));
    page.scale_bar();
    return page.sheet().picture;
}

}  // namespace game
