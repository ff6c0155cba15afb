#include "game/sound/mixer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "game/scene/surface.h"

namespace game::sound {
namespace {

constexpr double kSpeedOfSound = 331;  // m/s, at 0 °C
constexpr double kWide = 0.5;          // of the distance: slopes throw sound back from all around
constexpr double kNearest = 5;         // m; a source is not nearer

// Of air at 10 °C and 70 % humidity, dB/km (ISO 9613-2, table 2), in the middle of what each loop has.
constexpr double kLowAbsorbed = 0.2, kMiddleAbsorbed = 2, kHighAbsorbed = 33;

// Which part of a flow's power is low, middle and high; stones knock instead of hissing.
struct Parts {
    double low, middle, high, stones;
};
Parts parts_of(const Emitter& flow) {
    const double fast = std::min(flow.speed / 30, 1.);
    return {0.6, 0.15 + 0.25 * fast, 0.08 * fast * (1 - flow.stony), 0.3 * flow.stony * fast};
}

double level(double part, const Emitter& from, double distance_m, double absorbed) {
    return level_at(part * from.watts, distance_m, absorbed);
}

// How fast a loop gets louder and quieter, s.
constexpr double kRises = 0.15, kFalls = 0.5;

// No two places sound the same: 0.9 to 1.1.
float pitch_at(const glm::dvec3& at) {
    const double turns = 0.381 * at.x + 0.618 * at.y;
    return static_cast<float>(0.9 + 0.2 * (turns - std::floor(turns)));
}

double absorbed_of(Wave wave) {
    switch (wave) {
        case Wave::kTree:
        case Wave::kWood:
        case Wave::kCrack:
        case Wave::kMetal:
            return 4;
        case Wave::kWall:
            return 2;
        default:
            return 0.5;
    }
}

}  // namespace

Ear ear_of(const render::Camera& camera, const sim::View& world) {
    Ear ear;
    ear.at = render::eye(camera);
    ear.ahead = glm::normalize(camera.target - ear.at);
    ear.above_m = ear.at.z - surface_height(world, glm::dvec2(ear.at));
    return ear;
}

double level_at(double watts, double distance_m, double absorbed_db_per_km) {
    if (!(watts > 0)) return -HUGE_VAL;
    const double r = std::max(distance_m, kNearest);
    return 120 + 10 * std::log10(watts) - 10 * std::log10(4 * std::numbers::pi * r * r) -
           absorbed_db_per_km * r / 1000;
}

double gain_of(double level_db) {
    const auto played = [](double level) {
        return std::pow(10., Mixer::kSlope * (level - Mixer::kLoudest) / 20);
    };
    if (!(level_db > Mixer::kQuietest)) return 0;
    const double least = played(Mixer::kQuietest);
    return std::min((played(level_db) - least) / (1 - least), 1.);
}

void Mixer::note(Wave wave) {
    if (std::ranges::find(notes_, wave) == notes_.end()) notes_.push_back(wave);
}

void Mixer::set(std::size_t loop, Wave wave, const glm::dvec3& from, double gain, double spread,
                double elapsed_s) {
    Voice& voice = loops_.at(loop);
    const bool rises = gain > static_cast<double>(voice.gain);
    const double share = 1 - std::exp(-elapsed_s / (rises ? kRises : kFalls));
    double now = static_cast<double>(voice.gain) + share * (gain - static_cast<double>(voice.gain));
    if (gain == 0 && now < 1e-4) now = 0;
    // Heard elsewhere at once only if it was not heard before.
    const double moves = voice.gain == 0 ? 1 : share;
    const double wide = std::max(spread, kWide * glm::length(from));
    voice = {wave, voice.from + moves * (from - voice.from), static_cast<float>(now),
             0.96f + 0.02f * static_cast<float>(loop % 5), static_cast<float>(wide)};
}

void Mixer::mix(const Heard& heard, std::span<const Happened> happened, const sim::View& world,
                const Ear& ear, const Volumes& volumes, double elapsed_s) {
    now_s_ += elapsed_s;
    shots_.clear();
    const double all = volumes.muted ? 0 : volumes.all * (ear.looks ? 1 : 0.25);
    const auto loud = [&](Wave wave) {
        return all * volumes.of.at(static_cast<std::size_t>(info_of(wave).group));
    };
    const double passes = ear.passes ? 1 : 0;

    std::size_t loop = 0;
    const auto put = [&](Wave wave, const glm::dvec3& at, double gain, double spread) {
        set(loop++, wave, at - ear.at, passes * loud(wave) * gain, spread, elapsed_s);
    };
    for (const Emitter& flow : heard.flow) {
        // Where it is wide and near, one is beside its middle.
        const double away = std::hypot(glm::distance(flow.at, ear.at), 0.5 * flow.spread);
        const Parts parts = parts_of(flow);
        put(Wave::kRumble, flow.at, gain_of(level(parts.low, flow, away, kLowAbsorbed)), flow.spread);
        put(Wave::kRoar, flow.at, gain_of(level(parts.middle, flow, away, kMiddleAbsorbed)), flow.spread);
        put(Wave::kHiss, flow.at, gain_of(level(parts.high, flow, away, kHighAbsorbed)), flow.spread);
        put(Wave::kStones, flow.at, gain_of(level(parts.stones, flow, away, kMiddleAbsorbed)), flow.spread);
    }
    const Emitter& powder = heard.powder;
    put(Wave::kHiss, powder.at,
        gain_of(level(1, powder, std::hypot(glm::distance(powder.at, ear.at), 0.5 * powder.spread),
                      kHighAbsorbed)),
        powder.spread);
    // Windier high above the ground.
    put(Wave::kWind, ear.at, 0.05 + 0.1 * std::clamp(ear.above_m / 400, 0., 1.), 0);
    const bool scrapes = ear.scrapes.has_value();
    put(Wave::kScrape, ear.scrapes.value_or(ear.at),
        scrapes ? gain_of(level_at(0.3, glm::distance(*ear.scrapes, ear.at), kMiddleAbsorbed)) : 0, 0);

    if (ear.passes) {
        // Sound comes with the picture, but of what happens at the same time the nearest is heard first.
        double nearest = HUGE_VAL;
        for (const Happened& each : happened) nearest = std::min(nearest, glm::distance(each.at, ear.at));
        for (const Happened& each : happened) {
            const double farther = glm::distance(each.at, ear.at) - nearest;
            later_.push_back({each, now_s_ + each.after_s + farther / kSpeedOfSound});
            if (each.wave == Wave::kBlast) add_echoes(each, world, ear);
        }
    }
    const auto due = std::partition(later_.begin(), later_.end(),
                                    [&](const Later& later) { return later.due_s > now_s_; });
    for (auto later = due; later != later_.end() && ear.passes && shots_.size() < kMostShots; ++later) {
        const Happened& what = later->what;
        const double away = glm::distance(what.at, ear.at);
        const double gain = loud(what.wave) * gain_of(level_at(what.watts, away, absorbed_of(what.wave)));
        if (gain > 0)
            shots_.push_back({what.wave, what.at - ear.at, static_cast<float>(gain), pitch_at(what.at),
                              static_cast<float>(kWide * away)});
    }
    later_.erase(due, later_.end());
    if (!ear.passes) later_.clear();
    for (const Wave wave : notes_)
        if (loud(wave) > 0) shots_.push_back({wave, {}, static_cast<float>(0.5 * loud(wave)), 1, 0});
    notes_.clear();
}

// From slopes that look at both, as many as are told apart: in each of sixteen directions the place that is highest above the
// horizon of the blast. The way there and on to the ear is longer than the straight one; sound comes so much later.
void Mixer::add_echoes(const Happened& blast, const sim::View& world, const Ear& ear) {
    constexpr int kDirections = 16;
    constexpr std::size_t kEchoes = 3;
    constexpr double kLeastWay = 60, kLeastSlope = 0.12, kReflected = 0.2;
    constexpr double kApart = 0.25;  // s
    struct Echo {
        glm::dvec3 at;
        double later_s, watts, level;
    };
    std::vector<Echo> echoes;
    const double straight = glm::distance(blast.at, ear.at), step = 4 * static_cast<double>(world.grid.dx);
    const glm::dvec2 end =
        static_cast<double>(world.grid.dx) * glm::dvec2(world.grid.nx - 1, world.grid.ny - 1);
    for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * std::numbers::pi * i / kDirections;
        const glm::dvec2 toward(std::sin(angle), std::cos(angle));
        double steepest = kLeastSlope;
        std::optional<glm::dvec3> best;
        for (double way = kLeastWay + step;; way += step) {
            const glm::dvec2 at = glm::dvec2(blast.at) + way * toward;
            if (at.x < 0 || at.y < 0 || at.x > end.x || at.y > end.y) break;
            const double height = surface_height(world, at), slope = (height - blast.at.z) / way;
            if (slope > steepest) steepest = slope, best = {at, height};
        }
        if (!best) continue;
        const double longer = glm::distance(blast.at, *best) + glm::distance(*best, ear.at);
        // As loud as from a mirror at the end of that way: the ear hears it from its place.
        const double nearer = std::max(glm::distance(*best, ear.at), kNearest) / std::max(longer, kNearest);
        const double watts = kReflected * blast.watts * nearer * nearer;
        echoes.push_back({*best, (longer - straight) / kSpeedOfSound, watts,
                          level_at(watts, glm::distance(*best, ear.at), 1)});
    }
    std::ranges::sort(echoes, std::ranges::greater(), &Echo::level);
    std::vector<double> taken{0};
    for (const Echo& echo : echoes) {
        if (taken.size() > kEchoes) break;
        const auto same = [&](double before) { return std::abs(before - echo.later_s) < kApart; };
        if (std::ranges::any_of(taken, same)) continue;
        taken.push_back(echo.later_s);
        later_.push_back({{Wave::kEcho, echo.at, echo.watts, 0}, now_s_ + blast.after_s + echo.later_s});
    }
}

}  // namespace game::sound
