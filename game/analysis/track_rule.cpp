#include "game/analysis/track_rule.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace game {
namespace {

using sim::front::Mesh;
using sim::front::PointSource;
using sim::front::Rule;

float usual_cell(const Mesh& mesh) {
    std::vector<float> cells;
    for (const float cell : mesh.cell)
        if (cell > 0) cells.push_back(cell);
    const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(cells.size() / 2);
    std::nth_element(cells.begin(), middle, cells.end());
    return *middle;
}

}  // namespace

std::optional<Rule::Kind> track_rule_named(std::string_view name) {
    if (name == "paper") return Rule::Kind::kGradient;
    if (name == "relative") return Rule::Kind::kRelative;
    return std::nullopt;
}

Outcome<void> complete(TrackRule& rule, bool has_scalar, std::string_view dash) {
    const auto wrong = [&](std::string_view sentence) {
        return unusable(fmt::format(fmt::runtime(sentence), fmt::arg("dash", dash)));
    };
    rule.source = rule.source.value_or(PointSource::kFit);
    const bool by_level = rule.source == PointSource::kLevel;
    rule.rule = rule.rule.value_or(by_level ? Rule::Kind::kLevel : Rule::Kind::kGradient);
    if (by_level && (!has_scalar || !rule.level))
        return wrong("{dash}source level needs both {dash}scalar and {dash}level");
    if (!by_level && (has_scalar || rule.level))
        return wrong("{dash}scalar and {dash}level need {dash}source level");
    if (rule.hold && rule.source != PointSource::kPaper) return wrong("{dash}hold needs {dash}source paper");
    if (rule.rule == Rule::Kind::kGradient && !rule.jump && !rule.threshold)
        return wrong("tracking needs {dash}jump or {dash}threshold, which decide what edges are cut");
    if (rule.rule != Rule::Kind::kGradient && rule.threshold)
        return wrong("{dash}threshold needs {dash}rule paper");
    return {};
}

Rule rule_of(const TrackRule& choice, const Mesh& mesh) {
    Rule rule;
    if (choice.rule == Rule::Kind::kGradient) {
        if (choice.jump) rule = sim::front::gradient_rule(static_cast<float>(*choice.jump), usual_cell(mesh));
        if (choice.threshold) rule.threshold = static_cast<float>(*choice.threshold);
    } else if (choice.rule == Rule::Kind::kRelative) {
        rule = sim::front::avalanche_rule();
        if (choice.jump) rule.jump = static_cast<float>(*choice.jump);
    } else {
        rule.kind = Rule::Kind::kLevel;
    }
    if (choice.level) rule.level = static_cast<float>(*choice.level);
    return rule;
}

Outcome<FrontPoint> front_point(const sim::front::Tracker& tracker, const sim::front::Point& point) {
    const auto [i, j] = tracker.mesh().edge[point.edge];
    const glm::vec2 at = tracker.position(point);
    if (!std::isfinite(point.f + at.x + at.y + point.speed))
        return unusable(fmt::format(
            "the front between vertices {} and {} has no finite position or speed; scale the velocities", i,
            j));
    return FrontPoint{i, j, point.f, at.x, at.y, point.speed};
}

}  // namespace game
