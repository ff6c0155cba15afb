#include "sim/world/things.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/world/quanta.h"
#include "sim/world/state.h"

namespace sim {
namespace {

constexpr double kRubble = 1;              // m, what a destroyed building that was solid leaves
constexpr float kNetDrag = 0.3f;           // 1/m
constexpr float kWallSlope = 0.57735027f;  // tan 30°, from which on a rise of sculpted ground is a wall

struct Place {
    double x, y;  // m
};
Place operator*(double factor, Place a) {
    return {factor * a.x, factor * a.y};
}
double dot(Place a, Place b) {
    return a.x * b.x + a.y * b.y;
}
double length(Place a) {
    return std::sqrt(dot(a, a));
}

Place middle_of(const Thing& thing) {
    if (!thing.is_line()) return {thing.x, thing.y};
    return {0.5 * (thing.x + thing.to_x), 0.5 * (thing.y + thing.to_y)};
}

std::int32_t number_of(const Grid& grid, int x, int y) {
    return y * grid.nx + x;
}

// The vertex nearest to a place, within the grid.
std::int32_t nearest_vertex(const Grid& grid, Place at) {
    const auto dx = static_cast<double>(grid.dx);
    const auto nearest = [](double cell, int count) {
        return static_cast<int>(std::clamp(std::rint(cell), 0.0, static_cast<double>(count - 1)));
    };
    return number_of(grid, nearest(at.x / dx, grid.nx), nearest(at.y / dx, grid.ny));
}

// A rectangle about a place: from `before` behind it to `after` ahead along a unit vector, and to `half` on either side.
struct Rectangle {
    Place at, along;
    double before, after, half;  // m

    Place across() const { return {along.y, -along.x}; }
};

// A range of places, to be cut down to those p with least <= p * factor + offset <= most.
struct Span {
    double from, to;

    // Of a factor that is almost 0 the range has no end that could be computed.
    void cut(double factor, double offset, double least, double most) {
        constexpr double kAlmost = 1e-3;
        if (std::abs(factor) < kAlmost) return;
        const double a = (least - offset) / factor, b = (most - offset) / factor;
        from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
};

// Visits the vertices of the grid in a rectangle, row by row, and perhaps some beside it.
template <class Visit>
void each_near(const Grid& grid, const Rectangle& within, Visit&& visit) {
    const auto dx = static_cast<double>(grid.dx);
    const Place across = within.across();
    const double far = std::max(within.before, within.after);
    const double reach_x = std::abs(within.along.x) * far + std::abs(across.x) * within.half,
                 reach_y = std::abs(within.along.y) * far + std::abs(across.y) * within.half;
    const auto vertex = [&](double metres, int count) {
        return static_cast<int>(std::clamp(metres / dx, -1.0, static_cast<double>(count)));
    };
    const double margin = dx + 1e-3;  // more than any rounding
    for (int y = std::max(vertex(within.at.y - reach_y - margin, grid.ny), 0);
         y <= std::min(vertex(within.at.y + reach_y + margin, grid.ny), grid.ny - 1); ++y) {
        const double north = y * dx - within.at.y;
        Span east{-reach_x, reach_x};
        east.cut(within.along.x, north * within.along.y, -within.before, within.after);
        east.cut(across.x, north * across.y, -within.half, within.half);
        for (int x = std::max(vertex(within.at.x + east.from - margin, grid.nx), 0);
             x <= std::min(vertex(within.at.x + east.to + margin, grid.nx), grid.nx - 1); ++x)
            visit(x, y, Place{x * dx - within.at.x, north});
    }
}

// Length of the strip upslope of a net of height 1 in which it holds the snow, on a slope of this tangent.
double strip_of(double slope) {
    constexpr double kFriction = 0.55, kLongest = 13;
    return slope > kFriction ? std::min(2 * slope / (slope - kFriction), kLongest) : kLongest;
}

// What one object adds to the derived fields. `of` is the list's.
class Builder {
  public:
    Builder(const State& state, Things& things) : s_(state), t_(things) {}

    void add(const Thing& thing) {
        const auto first = static_cast<std::uint32_t>(t_.loaded.size());
        switch (thing.kind) {
            case ThingKind::kHouse:
            case ThingKind::kStation:
                if (is_solid(thing, s_.grid))
                    add_solid(thing);
                else
                    add_body(thing, thing.width);
                break;
            case ThingKind::kPylon:
                add_body(thing, thing.width);
                break;
            case ThingKind::kNet:
                add_net(thing);
                break;
            case ThingKind::kRoad:
                break;
        }
        t_.loaded_of.push_back({first, static_cast<std::uint32_t>(t_.loaded.size()) - first});
    }

  private:
    // Less than two cells wide: it slows the flow at the vertex that is nearest to it.
    void add_body(const Thing& thing, double width) {
        for (const std::int32_t vertex : footprint_of(thing, s_.grid)) t_.loaded.push_back({vertex, 0, 0});
        if (thing.destroyed()) return;
        const std::int32_t at = nearest_vertex(s_.grid, middle_of(thing));
        t_.built_drag(at % s_.grid.nx, at / s_.grid.nx) += static_cast<float>(width / s_.grid.cell_area());
    }

    // Flow meets its walls. A wall takes the speed at the vertex before it, so the one before that counts too.
    void add_solid(const Thing& thing) {
        const std::vector<std::int32_t> on = footprint_of(thing, s_.grid);
        const auto height =
            static_cast<float>(thing.destroyed() ? std::min(kRubble, thing.height) : thing.height);
        for (const std::int32_t vertex : on) t_.built(vertex % s_.grid.nx, vertex / s_.grid.nx) = height;
        constexpr std::array<std::array<std::int8_t, 2>, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
        for (const std::int32_t vertex : on)
            for (const auto& [to_x, to_y] : kSides)
                for (int away = 1; away <= 2; ++away) {
                    const int x = vertex % s_.grid.nx - away * to_x, y = vertex / s_.grid.nx - away * to_y;
                    if (!s_.grid.contains(x, y) || s_.site(x, y) != Site::kGround) break;
                    const std::int32_t before = number_of(s_.grid, x, y);
                    if (std::binary_search(on.begin(), on.end(), before)) break;
                    t_.loaded.push_back({before, to_x, to_y});
                }
    }

    void add_net(const Thing& thing) {
        const Grid& grid = s_.grid;
        const Place middle = middle_of(thing);
        const std::int32_t at = nearest_vertex(grid, middle);
        const int x = at % grid.nx, y = at / grid.nx;
        t_.loaded.push_back({at, 0, 0});
        if (thing.destroyed()) return;
        t_.built_drag(x, y) = std::max(t_.built_drag(x, y), kNetDrag);
        const double two_cells = 2 * static_cast<double>(grid.dx);
        const Place rise{static_cast<double>(t_.natural(x + 1, y) - t_.natural(x - 1, y)) / two_cells,
                         static_cast<double>(t_.natural(x, y + 1) - t_.natural(x, y - 1)) / two_cells};
        const double slope = length(rise);
        if (slope == 0) return;
        const Place up = (1 / slope) * rise, across{-up.y, up.x};
        const double reach = thing.height * strip_of(slope), half = 0.75 * static_cast<double>(grid.dx);
        each_near(grid, {middle, up, half, reach, half}, [&](int i, int j, Place from_middle) {
            const double above = dot(from_middle, up);
            if (above < -half || above > reach || std::abs(dot(from_middle, across)) > half) return;
            t_.net_depth(i, j) = std::max(t_.net_depth(i, j), static_cast<float>(thing.height));
        });
    }

    const State& s_;
    Things& t_;
};

// Rise of bedrock between two vertices where it is a wall, else 0.
float wall_between(const State& s, int x0, int y0, int x1, int y1) {
    const Things& t = *s.things;
    if (s.site(x0, y0) != Site::kGround || s.site(x1, y1) != Site::kGround) return 0;
    const auto is_made = [&](int x, int y) { return t.earth(x, y) != 0 || t.built(x, y) != 0; };
    if (!is_made(x0, y0) && !is_made(x1, y1)) return 0;
    const float rise = s.bedrock(x1, y1) - s.bedrock(x0, y0);
    return std::abs(rise) > s.grid.dx * kWallSlope ? rise : 0;
}

}  // namespace

void VertexBox::add(int x, int y) {
    if (empty())
        *this = {x, x, y, y};
    else
        *this = {std::min(x0, x), std::max(x1, x), std::min(y0, y), std::max(y1, y)};
}

Things::Things(const Grid& grid)
    : earth(grid),
      forest(grid),
      water(grid),
      natural(grid),
      natural_slope(grid),
      no_floor(Grid{grid.nx, 1, grid.dx}),
      built(grid),
      built_drag(grid),
      drag(grid),
      detrain(grid),
      hold(grid),
      net_depth(grid),
      wall_x(grid),
      wall_y(grid) {}

bool Things::dry() const {
    for (int y = 0; y < water.ny(); ++y)
        if (!std::all_of(water.row(y), water.row(y) + water.nx(), [](float m) { return m == 0; }))
            return false;
    return true;
}

bool Things::empty() const {
    if (!list.empty() || budget >= 0 || !dry()) return false;
    for (int y = 0; y < earth.ny(); ++y) {
        const auto bare = [](const Stems& stems) { return stems == Stems{}; };
        if (!std::all_of(earth.row(y), earth.row(y) + earth.nx(), [](float e) { return e == 0; }))
            return false;
        if (!std::all_of(forest.row(y), forest.row(y) + earth.nx(), bare)) return false;
    }
    return true;
}

EarthMoved moved_in(const Field<float>& earth) {
    EarthMoved moved;
    for (int y = 0; y < earth.ny(); ++y)
        for (int x = 0; x < earth.nx(); ++x) moved.add(static_cast<std::int64_t>(earth(x, y) / kQuantum));
    return moved;
}

Things& things_of(State& s) {
    if (!s.things) {
        s.things.emplace(s.grid);
        s.things->natural = s.bedrock;
        s.things->natural_slope = s.first_slope;
    }
    return *s.things;
}

bool is_solid(const Thing& thing, const Grid& grid) {
    const bool is_building = thing.kind == ThingKind::kHouse || thing.kind == ThingKind::kStation;
    return is_building && std::min(thing.length, thing.width) >= 2 * static_cast<double>(grid.dx);
}

std::vector<std::int32_t> footprint_of(const Thing& thing, const Grid& grid) {
    const Place along{thing.front_x, thing.front_y}, across{thing.front_y, -thing.front_x},
        middle = middle_of(thing);
    std::vector<std::int32_t> vertices;
    if (!thing.is_line())
        each_near(grid, {middle, along, 0.5 * thing.length, 0.5 * thing.length, 0.5 * thing.width},
                  [&](int x, int y, Place from_middle) {
                      if (std::abs(dot(from_middle, along)) <= 0.5 * thing.length &&
                          std::abs(dot(from_middle, across)) <= 0.5 * thing.width)
                          vertices.push_back(number_of(grid, x, y));
                  });
    if (vertices.empty()) vertices.push_back(nearest_vertex(grid, middle));
    return vertices;
}

void rebuild_objects(State& s) {
    Things& t = *s.things;
    const Field<float> built_before = t.built;
    for (Field<float>* field : {&t.built, &t.built_drag, &t.net_depth}) field->fill(0);
    t.loaded.clear(), t.loaded_of.clear();
    Builder builder(s, t);
    for (const Thing& thing : t.list) builder.add(thing);
    for (int y = 0; y < s.grid.ny; ++y)
        for (int x = 0; x < s.grid.nx; ++x) {
            rebuild_forest(s, x, y);
            if (t.built(x, y) != built_before(x, y)) set_bedrock(s, x, y);
        }
    ++t.changed;
    s.tiles.wake_all();  // what was held may start
}

void rebuild_forest(State& s, int x, int y) {
    Things& t = *s.things;
    const Stems& stems = t.forest(x, y);
    t.drag(x, y) = drag_of(stems) + t.built_drag(x, y);
    t.detrain(x, y) = detrain_of(stems);
    t.hold(x, y) = hold_of(stems);
}

void rebuild_wooded(Things& t) {
    t.wooded.clear();
    for (int y = 0; y < t.forest.ny(); ++y)
        for (int x = 0; x < t.forest.nx(); ++x)
            if (t.forest(x, y).standing > 0) t.wooded.push_back(y * t.forest.nx() + x);
}

void set_bedrock(State& s, int x, int y) {
    Things& t = *s.things;
    const float made = t.earth(x, y) + t.built(x, y);
    // Natural ground as it was, −0 too: the sum would be 0.
    s.bedrock(x, y) =
        made == 0 ? t.natural(x, y)
                  : static_cast<float>(static_cast<double>(t.natural(x, y)) + static_cast<double>(made));
    t.stale.add(x, y);
}

void find_walls(State& s, const VertexBox& box) {
    Things& t = *s.things;
    for (int y = std::max(box.y0, 0); y <= std::min(box.y1 + 1, s.grid.ny - 1); ++y)
        for (int x = std::max(box.x0, 0); x <= std::min(box.x1 + 1, s.grid.nx - 1); ++x) {
            if (x > 0) t.wall_x(x, y) = wall_between(s, x - 1, y, x, y);
            if (y > 0) t.wall_y(x, y) = wall_between(s, x, y - 1, x, y);
        }
}

double Thing::turn() const {
    return std::atan2(front_x, front_y) * (180 / 3.14159265358979323846);
}

std::string_view to_string(ThingKind kind) {
    constexpr std::array<std::string_view, kThingKinds> kNames{"house", "station", "pylon", "net", "road"};
    return kNames[static_cast<std::size_t>(kind)];
}

float drag_of(const Stems& stems) {
    constexpr float kHectare = 1e4f;  // m²
    return static_cast<float>(stems.standing * stems.diameter_cm) / (100 * kHectare);
}

float detrain_of(const Stems& stems) {
    constexpr float kOfUsual = 25, kUsualStems = 400;  // Pa, 1/ha
    return kOfUsual / kUsualStems * stems.standing;
}

float hold_of(const Stems& stems) {
    constexpr float kAllHeld = 400;  // 1/ha
    return std::min(stems.standing / kAllHeld, 1.f);
}

float held_share(const Things& t, int x, int y, float depth) {
    return t.net_depth(x, y) > 0 && depth <= t.net_depth(x, y) ? 1.f : t.hold(x, y);
}

double moment_of(const Stems& stems) {
    constexpr double kBendingStrength = 40e6;                           // Pa, of green wood
    constexpr double kUprooting = 2000, kDiameter = 0.1, kHeight = 10;  // N m for a stem of these sizes, m
    constexpr double kPi = 3.14159265358979323846;
    const double d = stems.diameter_cm / 100.0;
    const double breaks = kBendingStrength * kPi / 32 * (d * d * d);
    const double uproots = kUprooting * (d / kDiameter) * (d / kDiameter) * (stems.height_m / kHeight);
    return std::min(breaks, uproots);
}

}  // namespace sim
