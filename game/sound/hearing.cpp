#include "game/sound/hearing.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "game/scene/surface.h"
#include "sim/world/mixture.h"

namespace game::sound {
namespace {

constexpr float kVisible = Peaks::kVisible;
constexpr double kGravity = 9.81;
constexpr double kPuffWatts = 2e-5;   // of a puff of 1 m² and 1 m/s, that hides what is behind it
constexpr double kSlabVolume = 20;    // m³; less breaks off without a crack
constexpr double kCrackAfter = 0.12;  // s after a blast
constexpr int kMostTreesOfTick = 3;

glm::dvec3 on_surface(const sim::View& world, glm::dvec2 at) {
    return {at, surface_height(world, at)};
}

const sim::Stems& stems_at(const sim::Things& things, std::int32_t vertex) {
    const int row = things.forest.nx();
    return things.forest(vertex % row, vertex / row);
}

std::int8_t broken(const sim::Thing& thing) {
    return thing.destroyed() ? 2 : thing.damaged() ? 1 : 0;
}

Wave wave_of(const sim::Thing& thing) {
    constexpr double kWood = 8;  // kPa; stronger walls are brick or concrete
    if (thing.kind != sim::ThingKind::kHouse) return Wave::kMetal;
    return thing.strength > kWood ? Wave::kWall : Wave::kWood;
}

// Sums of what belongs to an emitter.
struct Share {
    double watts = 0, fast = 0, stony = 0, away = 0;
    glm::dvec2 place{0};
};

}  // namespace

void Hearing::begin(const Session& session) {
    tick_ = session.state().tick;
    rolling_ = session.state().ledger.rolling;
    broken_.clear();
    lying_.clear();
    const sim::Things* const things = session.view().things;
    things_ = things ? things->changed : 0;
    if (!things) return;
    for (const sim::Thing& thing : things->list) broken_.push_back(broken(thing));
    for (const std::int32_t vertex : things->wooded) lying_.push_back(stems_at(*things, vertex).lying);
}

void Hearing::see(const Session& session, std::span<const sim::Command> commands) {
    if (session.state().tick != tick_ + 1) return begin(session);
    see_blasts(session, commands);
    see_things(session);
    tick_ = session.state().tick;
    rolling_ = session.state().ledger.rolling;
}

void Hearing::see_blasts(const Session& session, std::span<const sim::Command> commands) {
    const double released = session.cubic_metres(session.state().ledger.rolling - rolling_);
    for (const sim::Command& blast : commands) {
        if (blast.kind != sim::CommandKind::kBlast) continue;
        const auto at = on_surface(session.view(), {blast.x, blast.y});
        const double size = std::max(blast.radius, 1.) / 10;
        happened_.push_back({Wave::kBlast, at, kBlastWatts * size * size, 0});
        if (released > kSlabVolume)
            happened_.push_back(
                {Wave::kCrack, at, 0.25 * kBlastWatts * std::min(released / 500, 4.), kCrackAfter});
    }
}

// What was damaged or destroyed in this tick.
void Hearing::see_things(const Session& session) {
    const sim::Things* const things = session.view().things;
    if (!things) return;
    if (things->list.size() != broken_.size()) {  // built or removed
        broken_.resize(things->list.size());
        std::ranges::transform(things->list, broken_.begin(), broken);
    }
    for (std::size_t i = 0; i < broken_.size(); ++i) {
        const sim::Thing& thing = things->list[i];
        const std::int8_t now = broken(thing);
        if (now > std::exchange(broken_[i], now))
            happened_.push_back(
                {wave_of(thing), on_surface(session.view(), {thing.x, thing.y}), now == 2 ? 30. : 3., 0});
    }
    if (std::exchange(things_, things->changed) != things->changed) see_trees(session);
}

// Where stems were broken; a few of the many.
void Hearing::see_trees(const Session& session) {
    const sim::View world = session.view();
    const auto& wooded = world.things->wooded;
    const bool same = lying_.size() == wooded.size();
    lying_.resize(wooded.size());
    int told = 0;
    for (std::size_t i = 0; i < wooded.size(); ++i) {
        const std::uint16_t now = stems_at(*world.things, wooded[i]).lying;
        if (now <= std::exchange(lying_[i], now) || !same || told == kMostTreesOfTick) continue;
        ++told;
        const glm::dvec2 at(wooded[i] % world.grid.nx, wooded[i] / world.grid.nx);
        happened_.push_back({Wave::kTree, on_surface(world, at * static_cast<double>(world.grid.dx)), 1, 0});
    }
}

const Heard& Hearing::look(const Session& session) {
    if (session.state().tick != tick_) begin(session);
    look_at_flow(session);
    look_at_powder(session);
    return heard_;
}

// Friction turns ρ g h |v| μ of each square metre into heat, and a little of that into sound. Each cell counts for the emitter
// that is nearest to it, and emitters go where their cells are: as k-means does, one round a call.
void Hearing::look_at_flow(const Session& session) {
    const sim::View world = session.view();
    const auto dx = static_cast<double>(world.grid.dx);
    const Densities densities = session.densities().value_or(Densities{kUsualDensity, kUsualDensity});
    auto& flow = heard_.flow;
    std::array<Share, kFlowEmitters> shares{};
    double farthest = -1;  // from any emitter, with its power: where one without cells goes
    glm::dvec2 lonely(0);
    const auto see_cell = [&](int x, int y) {
        const float depth = world.rolling(x, y);
        if (!(depth >= kVisible)) return;
        const double speed = glm::length(glm::dvec2(world.velocity_x(x, y), world.velocity_y(x, y)));
        if (speed == 0) return;
        const double lower = world.mixture ? static_cast<double>(sim::share_in_rolling(world, x, y)) : 0;
        const double density = densities.of(lower);
        const double watts =
            kEfficiency * kFriction * density * kGravity * static_cast<double>(depth) * speed * dx * dx;
        const glm::dvec2 at = dx * glm::dvec2(x, y);
        std::size_t nearest = 0;
        double away = -1;
        for (std::size_t i = 0; i < flow.size(); ++i) {
            if (flow[i].watts == 0) continue;
            const double d = glm::distance(at, glm::dvec2(flow[i].at));
            if (away < 0 || d < away) nearest = i, away = d;
        }
        Share& share = shares[nearest];
        share.watts += watts;
        share.place += watts * at;
        share.fast += watts * speed;
        share.away += watts * std::max(away, 0.);
        if (density > kStonyDensity) share.stony += watts;
        if (watts * away > farthest) farthest = watts * away, lonely = at;
    };
    const sim::Tiles& tiles = world.tiles;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            if (!tiles.awake[tiles.number(column, row)]) continue;
            const int x0 = column * tiles.width, y0 = row * tiles.height;
            for (int y = y0; y < std::min(y0 + tiles.height, world.grid.ny); ++y)
                for (int x = x0; x < std::min(x0 + tiles.width, world.grid.nx); ++x) see_cell(x, y);
        }
    bool placed = false;
    for (std::size_t i = 0; i < flow.size(); ++i) {
        const Share& share = shares[i];
        if (share.watts > 0) {
            flow[i] = {on_surface(world, share.place / share.watts), share.watts, share.away / share.watts,
                       share.fast / share.watts, share.stony / share.watts};
        } else if (farthest > 0 && !std::exchange(placed, true)) {
            constexpr double kWhisper = 1e-12;  // it has cells from the next call on
            flow[i] = {on_surface(world, lonely), kWhisper, 0, 0, 0};
        } else {
            flow[i].watts = 0;
        }
    }
}

void Hearing::look_at_powder(const Session& session) {
    Share share;
    glm::dvec3 place(0);
    const auto puffs = session.powder();
    const auto watts_of = [](const sim::powder::Puff& puff) {
        const double radius = static_cast<double>(sim::powder::radius(puff));
        const double speed = glm::length(glm::dvec3(puff.velocity));
        return kPuffWatts * static_cast<double>(sim::powder::opacity(puff)) * radius * radius * speed;
    };
    for (const sim::powder::Puff& puff : puffs) {
        const double watts = watts_of(puff);
        share.watts += watts;
        place += watts * glm::dvec3(puff.at);
        share.fast += watts * glm::length(glm::dvec3(puff.velocity));
    }
    heard_.powder = {};
    if (share.watts == 0) return;
    const glm::dvec3 middle = place / share.watts;
    for (const sim::powder::Puff& puff : puffs)
        share.away += watts_of(puff) * glm::distance(middle, glm::dvec3(puff.at));
    heard_.powder = {middle + glm::dvec3(0, 0, session.view().datum), share.watts, share.away / share.watts,
                     share.fast / share.watts, 0};
}

}  // namespace game::sound
