#include "sim/powder/cloud.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "sim/core/chance.h"
#include "sim/core/check.h"
#include "sim/core/ramp.h"

namespace sim::powder {
namespace {

constexpr float kFullSpeed = 3;           // times Rule::speed, from which on all is thrown up
constexpr float kThinnest = 0.02f;        // m; a thinner flow throws up nothing
constexpr float kThick = 0.25f;           // m; a thicker one no more than this
constexpr float kRadiusPerSpeed = 0.44f;  // s: first radius of a puff by the speed of the flow
constexpr float kShallow = 0.8f, kPerDepth = 0.5f,
                kDeep = 2.4f;                     // times that, by depth in m: a deep flow throws it high
constexpr float kSmallest = 0.3f, kLargest = 30;  // m, first radius
constexpr float kGrowth = 3.2f;                   // first radii that a puff gains over its life
constexpr float kBodyShare = 0.25f;               // of the births at a front, behind it
constexpr float kCover = 5.5f;      // times per second that births at a front cover their ground
constexpr float kDragTime = 1.8f;   // s, in which a puff takes on the speed of the air
constexpr float kClimbTime = 1.6f;  // s, in which it stops to rise or fall
constexpr float kCarried = 0.5f;    // speed of the air over a flow, times that of the flow
constexpr float kDrift = 1.2f;      // m/s, of powder-laden air down a slope of 1
constexpr float kHalfWind = 9;      // m above the ground, where the wind has half of its speed
constexpr float kWindAge =
    3;  // s, at which a puff has half of its share in the wind: it is no part of the flow then
constexpr float kSettling = 0.6f;  // m/s
constexpr float kFadeIn = 0.3f;    // s
constexpr float kSkirt = 0.3f;     // of the births at a front: low fine dust, thrown to the sides
constexpr float kBlastSpeed = 9, kFountainSpeed = 34, kRingSpeed = 17;  // m/s, of what a blast throws up

// Random numbers of one birth: 0 to 1, excluding 1.
class Random {
  public:
    Random(std::int64_t tick, int x, int y)
        : state_(static_cast<std::uint64_t>(tick) * 0x9E3779B97F4A7C15ull ^
                 static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) * 0xBF58476D1CE4E5B9ull ^
                 static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) * 0x94D049BB133111EBull) {}

    std::uint32_t bits() { return next_bits(state_); }
    float share() { return share_of(bits()); }
    float between(float low, float high) { return low + (high - low) * share(); }

  private:
    std::uint64_t state_;
};

// A place between four vertices.
struct Place {
    int x, y;      // of the south-western one
    float u, v;    // from it, cells
    bool outside;  // of the grid; then the nearest place on its border
};

Place place_of(const Grid& grid, float x_m, float y_m) {
    const float x = x_m / grid.dx, y = y_m / grid.dx;
    const float east = static_cast<float>(grid.nx - 1), north = static_cast<float>(grid.ny - 1);
    const float inside_x = std::clamp(x, 0.f, east), inside_y = std::clamp(y, 0.f, north);
    Place place;
    place.x = std::min(static_cast<int>(inside_x), grid.nx - 2);
    place.y = std::min(static_cast<int>(inside_y), grid.ny - 2);
    place.u = inside_x - static_cast<float>(place.x);
    place.v = inside_y - static_cast<float>(place.y);
    place.outside = inside_x != x || inside_y != y;
    return place;
}

template <class Value>
float between(const Place& at, const Value& value) {
    const float south = value(at.x, at.y) + at.u * (value(at.x + 1, at.y) - value(at.x, at.y));
    const float north = value(at.x, at.y + 1) + at.u * (value(at.x + 1, at.y + 1) - value(at.x, at.y + 1));
    return south + at.v * (north - south);
}

float surface(const View& world, int x, int y) {
    return world.bedrock(x, y) + world.depth(x, y) + world.rolling(x, y);
}

float surface(const View& world, const Place& at) {
    return between(at, [&](int x, int y) { return surface(world, x, y); });
}

// Rise of the surface over a metre along x and along y.
glm::vec2 slope(const View& world, int x, int y) {
    const int west = std::max(x - 1, 0), east = std::min(x + 1, world.grid.nx - 1);
    const int south = std::max(y - 1, 0), north = std::min(y + 1, world.grid.ny - 1);
    return {(surface(world, east, y) - surface(world, west, y)) /
                (static_cast<float>(east - west) * world.grid.dx),
            (surface(world, x, north) - surface(world, x, south)) /
                (static_cast<float>(north - south) * world.grid.dx)};
}

// 1 where little flows ahead: at a front, and less so at a flank.
float frontness(const View& world, int x, int y, glm::vec2 velocity, float speed) {
    const glm::vec2 ahead = velocity / speed, aside(-ahead.y, ahead.x);
    const auto thin = [&](glm::vec2 toward, float seconds) {  // 1 where little flows
        const glm::vec2 to = toward * std::max(seconds * speed / world.grid.dx, 3 * seconds) + 0.5f;
        const int at_x = x + static_cast<int>(std::floor(to.x)),
                  at_y = y + static_cast<int>(std::floor(to.y));
        if (!world.grid.contains(at_x, at_y)) return 0.f;
        return 1 - ramp(0.015f, 0.15f, world.rolling(at_x, at_y));
    };
    const float head = std::max(thin(ahead, 0.4f), thin(ahead, 1));
    const float flank = std::max(thin(ahead + 0.9f * aside, 0.7f), thin(ahead - 0.9f * aside, 0.7f));
    return std::max({head, 0.6f * thin(ahead, 2.5f), 0.35f * flank});
}

}  // namespace

float radius(const Puff& puff) {
    const float a = puff.age_s / puff.life_s;
    return puff.first_radius * (1 + kGrowth * a * (2 - a));
}

float opacity(const Puff& puff) {
    const float a = puff.age_s / puff.life_s;
    return puff.density * ramp(0, kFadeIn, puff.age_s) *
           (1 - ramp(0, 0.8f, a) * (0.75f + 0.25f * ramp(0.5f, 1, a)));
}

Cloud::Cloud(const Rule& upper, const Rule& lower, glm::vec2 wind)
    : upper_(upper), lower_(lower), wind_(wind) {
    puffs_.reserve(kMost);
}

void Cloud::advance(const View& world, float dt_s) {
    CHECK(dt_s > 0);
    move(world, dt_s);
    give_birth(world, dt_s);
}

void Cloud::move(const View& world, float dt_s) {
    for (Puff& puff : puffs_) {
        const Place before = place_of(world.grid, puff.at.x, puff.at.y);
        const float ground_before = surface(world, before);
        const glm::vec2 fall = slope(world, before.x, before.y);
        const float flows = ramp(kThinnest, kThick, between(before, world.rolling));
        const float height = std::max(puff.at.z - ground_before, 0.f);
        const float windy = height / (height + kHalfWind) * (puff.age_s / (puff.age_s + kWindAge));
        const glm::vec2 air =
            kCarried * flows *
                glm::vec2(between(before, world.velocity_x), between(before, world.velocity_y)) -
            kDrift * fall + windy * wind_;
        const float share = std::min(dt_s / kDragTime, 1.f);
        puff.velocity.x += share * (air.x - puff.velocity.x);
        puff.velocity.y += share * (air.y - puff.velocity.y);
        puff.at.x += dt_s * puff.velocity.x;
        puff.at.y += dt_s * puff.velocity.y;

        // Along the ground it rises and sinks with it; over a step it flies on.
        const Place after = place_of(world.grid, puff.at.x, puff.at.y);
        const float ground = surface(world, after), along = (ground - ground_before) / dt_s;
        puff.velocity.z += std::min(dt_s / kClimbTime, 1.f) * (along - kSettling - puff.velocity.z);
        puff.at.z += dt_s * puff.velocity.z;
        puff.age_s += after.outside ? 4 * dt_s : dt_s;
        const float lowest = ground + 0.25f * radius(puff);
        if (puff.at.z < lowest) {
            puff.at.z = lowest;
            puff.velocity.z = std::max(puff.velocity.z, along);
        }
    }
    std::erase_if(puffs_, [](const Puff& puff) { return puff.age_s >= puff.life_s; });
}

Rule Cloud::rule_of(const View& world, int x, int y) const {
    if (!world.mixture) return upper_;
    const float lower = share_in_rolling(world, x, y);
    return {upper_.strength + lower * (lower_.strength - upper_.strength),
            upper_.speed + lower * (lower_.speed - upper_.speed)};
}

// Nothing flows in a tile that sleeps. A world without an engine has no tiles.
void Cloud::give_birth(const View& world, float dt_s) {
    const Tiles& tiles = world.tiles;
    if (tiles.awake.empty()) {
        for (int y = 0; y < world.grid.ny; ++y) give_birth_in(world, dt_s, y, 0, world.grid.nx);
        return;
    }
    for (int y = 0; y < world.grid.ny; ++y)
        for (int column = 0; column < tiles.columns; ++column)
            if (tiles.awake[tiles.number(column, y / tiles.height)])
                give_birth_in(world, dt_s, y, column * tiles.width,
                              std::min((column + 1) * tiles.width, world.grid.nx));
}

// Of the vertices of a row from `first` to before `last`.
void Cloud::give_birth_in(const View& world, float dt_s, int y, int first, int last) {
    const float cell = world.grid.dx;
    const float* rolling = world.rolling.row(y);
    const float *u = world.velocity_x.row(y), *v = world.velocity_y.row(y);
    for (int x = first; x < last; ++x) {
        if (rolling[x] < kThinnest) continue;
        const Rule rule = rule_of(world, x, y);
        const glm::vec2 velocity(u[x], v[x]);
        const float speed_2 = glm::dot(velocity, velocity);
        if (rule.strength <= 0 || speed_2 < rule.speed * rule.speed) continue;
        const float speed = std::sqrt(speed_2);
        const float fast =
            ramp(rule.speed, kFullSpeed * rule.speed, speed) * ramp(kThinnest, kThick, rolling[x]);
        if (fast < 0.02f) continue;

        const float front = frontness(world, x, y, velocity, speed);
        const glm::vec2 rise = slope(world, x, y);
        const float steep = ramp(0.8f, 1.4f, std::sqrt(glm::dot(rise, rise)));
        const float size =
            std::clamp(kRadiusPerSpeed * speed * std::min(kShallow + kPerDepth * rolling[x], kDeep),
                       kSmallest, kLargest);
        const float room = 1 - static_cast<float>(puffs_.size()) / static_cast<float>(kMost);
        const float births = dt_s * kCover / (3.14f * size * size) * cell * cell * fast * room *
                             (kBodyShare + (1 - kBodyShare) * front) * (1 + steep);
        Random random(world.tick, x, y);
        const int count = static_cast<int>(births + random.share());
        for (int i = 0; i < count && puffs_.size() < kMost; ++i) {
            Puff puff;
            puff.at.x = (static_cast<float>(x) + random.between(-0.5f, 0.5f)) * cell;
            puff.at.y = (static_cast<float>(y) + random.between(-0.5f, 0.5f)) * cell;
            puff.first_radius = size * random.between(0.6f, 1.3f) * (0.7f + 0.3f * front);
            puff.at.z =
                surface(world, place_of(world.grid, puff.at.x, puff.at.y)) + 0.25f * puff.first_radius;
            const glm::vec2 forward = velocity * random.between(0.7f, 1 + 0.2f * front);
            const glm::vec2 jitter = speed * glm::vec2{random.between(-0.12f, 0.12f),
                                                       random.between(-0.12f, 0.12f)};  // in this order
            // Few are thrown high: they make the top ragged.
            const float high = random.share();
            const float thrown =
                speed * (0.06f + high * high * random.between(0.3f, 0.5f + 0.9f * front + 0.3f * steep));
            puff.velocity = glm::vec3(forward + jitter, glm::dot(forward, rise) + thrown);
            puff.life_s = random.between(5, 8 + 3 * front);
            puff.density = rule.strength * (0.35f + 0.65f * fast) * random.between(0.6f, 1);
            if (random.share() < kSkirt * front) {
                const glm::vec2 aside = random.between(-0.35f, 0.35f) * glm::vec2(-velocity.y, velocity.x);
                puff.first_radius *= 0.5f;
                puff.velocity = glm::vec3(0.6f * forward + aside, glm::dot(0.6f * forward + aside, rise));
                puff.density *= 0.5f;
            }
            puff.lower = world.mixture ? share_in_rolling(world, x, y) : 0.f;
            puff.seed = random.bits();
            puffs_.push_back(puff);
        }
    }
}

void Cloud::blast(const View& world, glm::vec2 at, float radius) {
    constexpr int kPuffs = 96;
    const float reach = std::clamp(radius, world.grid.dx, 40.f);
    const Place middle = place_of(world.grid, at.x, at.y);
    if (middle.outside) return;
    const float lies = between(middle, world.depth) + between(middle, world.rolling);
    const Rule rule = rule_of(world, middle.x, middle.y);
    const float density = rule.strength * ramp(kThinnest, kThick, lies);
    if (density <= 0) return;
    // A fountain in the middle, and a low ring that runs out over the snow.
    Random random(world.tick, static_cast<int>(at.x), static_cast<int>(at.y));
    const glm::vec2 rise = slope(world, middle.x, middle.y);
    for (int i = 0; i < kPuffs && puffs_.size() < kMost; ++i) {
        const bool fountain = i % 2 == 0;
        glm::vec2 out{random.between(-1, 1), random.between(-1, 1)};  // in this order
        const float from_middle = std::max(std::sqrt(glm::dot(out, out)), 0.05f);
        if (!fountain || from_middle > 1) out /= from_middle;
        out *= fountain ? 0.25f : 0.8f;
        Puff puff;
        puff.at.x = at.x + reach * out.x;
        puff.at.y = at.y + reach * out.y;
        if (fountain) {
            // What is thrown highest is the least.
            const float high = random.share();
            puff.first_radius = reach * random.between(0.10f, 0.22f) * (1.3f - 0.6f * high);
            puff.velocity = glm::vec3(kBlastSpeed * out, kFountainSpeed * (0.15f + high));
            puff.life_s = random.between(3.5f, 6.5f);
            puff.density = density * random.between(0.7f, 1);
        } else {
            const glm::vec2 away = kRingSpeed * random.between(0.7f, 1.2f) * out;
            puff.first_radius = reach * random.between(0.06f, 0.12f);
            puff.velocity = glm::vec3(away, glm::dot(away, rise) + random.between(0.5f, 2));
            puff.life_s = random.between(2, 4);
            puff.density = density * random.between(0.4f, 0.7f);
        }
        puff.at.z = surface(world, place_of(world.grid, puff.at.x, puff.at.y)) + 0.3f * puff.first_radius;
        puff.seed = random.bits();
        puffs_.push_back(puff);
    }
}

}  // namespace sim::powder
