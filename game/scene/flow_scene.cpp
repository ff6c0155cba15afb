#include "game/scene/flow_scene.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "game/scene/material.h"
#include "game/scene/shown_numbers.h"

namespace game {
namespace {

using sim::fields::TestFlow;

constexpr float kSide = 100;  // m
constexpr int kUsualSquares = 20;
static_assert(kFlowKinds.size() == static_cast<std::size_t>(TestFlow::Kind::kRift) + 1);

// The kind, with the place and the angle of the paper's figures.
TestFlow usual(TestFlow::Kind kind, int squares) {
    switch (kind) {
        case TestFlow::Kind::kOpposed:
            return sim::fields::opposed(1.0 / squares, 0.5);
        case TestFlow::Kind::kSwinging:
            return sim::fields::swinging(45);
        case TestFlow::Kind::kPinwheel:
            return sim::fields::pinwheel();
        case TestFlow::Kind::kDisc:
            return sim::fields::disc();
        case TestFlow::Kind::kDrops:
            return sim::fields::drops();
        case TestFlow::Kind::kCrowd:
            return sim::fields::crowd();
        case TestFlow::Kind::kRift:
            return sim::fields::rift(30);
    }
    return {};
}

void read_numbers(TomlTable& table, Scenario::Flow& flow) {
    sim::fields::FlowNumbers& numbers = flow.numbers;
    table.numbers(kFlowNumbers, numbers);
    if (const auto angle = table.number("angle", -360, 360))
        flow.flow.angle = *angle * std::numbers::pi / 180;
    if (const auto name = table.text("source")) {
        const auto source = sim::front::source_named(*name);
        if (!source || *source == sim::front::PointSource::kLevel)
            table.blame("source", "is not one of half, paper, fit");
        numbers.source = source.value_or(numbers.source);
    }
}

void read_look(TomlTable& table, Scenario& scenario) {
    scenario.look.flow = render::FlowLook{render::FlowPattern::kCheckerboard, 2, true};
    if (const auto name = table.text("texture")) {
        const auto pattern = render::flow_pattern_named(*name);
        if (!pattern)
            table.blame("texture", fmt::format("is not a known texture; known are {}",
                                               fmt::join(render::kFlowPatterns, ", ")));
        scenario.look.flow->pattern = pattern.value_or(scenario.look.flow->pattern);
    }
    table.numbers(kFlowLookNumbers, *scenario.look.flow);
}

}  // namespace

Outcome<void> read_flow(TomlTable& table, const Overrides& overrides, Scenario& scenario) {
    if (overrides.material || overrides.model || overrides.scheme || overrides.law)
        return unusable("A flow scene has no material and no physics; only --grid applies to it");
    if (overrides.squares.value_or(0) > kMostFlowSquares)
        return unusable(fmt::format("--grid {}: a flow scene has at most {} squares along a side",
                                    *overrides.squares, kMostFlowSquares));
    const auto name = table.text("kind");
    const auto kind = std::find(kFlowKinds.begin(), kFlowKinds.end(), name.value_or(""));
    if (kind == kFlowKinds.end())
        table.blame(name ? "kind" : "", fmt::format("{} {}", name ? "is not one of" : "needs a kind: one of",
                                                    fmt::join(kFlowKinds, ", ")));
    const auto grid = table.whole("grid", 8, kMostFlowSquares);
    const int squares = overrides.squares.value_or(static_cast<int>(grid.value_or(kUsualSquares)));
    const auto which = kind == kFlowKinds.end() ? 0 : kind - kFlowKinds.begin();
    const sim::Grid level_grid{squares + 1, squares + 1, kSide / static_cast<float>(squares)};
    if (auto allowed = overrides.memory.allows(level_grid, false); !allowed) return unusable(allowed.error());
    scenario.flow = Scenario::Flow{usual(static_cast<TestFlow::Kind>(which), squares), {}};
    read_numbers(table, *scenario.flow);

    const auto material = load_material("snow-dry", sim::Model::kBcreInertial);
    if (!material) return tl::unexpected(material.error());
    scenario.material = material->name;
    scenario.params = material->params;
    scenario.look = material->look;
    read_look(table, scenario);
    table.finish();

    terrains::Terrain level;
    level.name = "level ground";
    level.grid = level_grid;
    level.surface.assign(level.grid.size(), 0.f);
    level.cover.assign(level.grid.size(), 0.f);
    level.has_data.assign(level.grid.size(), 1);
    set_ground(scenario, level);
    return {};
}

}  // namespace game
