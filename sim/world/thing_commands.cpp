#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/number_text.h"
#include "sim/world/on_ground.h"
#include "sim/world/quanta.h"
#include "sim/world/state.h"
#include "sim/world/thing_places.h"
#include "sim/world/things.h"

namespace sim {
namespace {

constexpr float kFlank = 0.8f;  // greatest slope of earth against natural ground, 1 : 1.25

std::int64_t quanta_in(float metres) {
    return static_cast<std::int64_t>(metres / kQuantum);
}

// ---------------------------------------------------------------------------------------------- earth

// How many of a grid's vertices the box of a disc has.
std::int64_t vertices_about(const Disc& disc, const Grid& grid) {
    const auto count = [](int first, int last, int most) {
        return static_cast<std::int64_t>(std::max(std::min(last, most - 1) - std::max(first, 0) + 1, 0));
    };
    return count(disc.x0, disc.x1, grid.nx) * count(disc.y0, disc.y1, grid.ny);
}

// What a command would do to the earth of a vertex.
struct EarthChange {
    int x, y;
    std::int64_t from, to;  // quanta
};

// The mean height of the ground's neighbours, m above datum.
double mean_beside(const State& s, int x, int y) {
    double sum = 0;
    int count = 0;
    for (const auto& [i, j] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}})
        if (s.grid.contains(i, j) && s.site(i, j) == Site::kGround)
            sum += static_cast<double>(s.bedrock(i, j)), ++count;
    return count ? sum / count : static_cast<double>(s.bedrock(x, y));
}

// Lowers a row of earth until no flank to its other rows, or along it to one side, is steeper than kFlank. `before`: the
// row that was settled before it, if there is one; `step` leads along the row away from its first vertex.
void settle_row(float* row, const float* before, int width, int step, float dx) {
    constexpr float kDiagonal = 1.41421356f;
    const float beside = kFlank * dx, across = kDiagonal * beside;
    if (before) {
        for (int x = 0; x < width; ++x) row[x] = std::min(row[x], before[x] + beside);
        for (int x = 1; x < width; ++x) row[x] = std::min(row[x], before[x - 1] + across);
        for (int x = 0; x + 1 < width; ++x) row[x] = std::min(row[x], before[x + 1] + across);
    }
    float* at = step > 0 ? row : row + width - 1;
    for (int x = 1; x < width; ++x, at += step) at[step] = std::min(at[step], at[0] + beside);
}

// Lowers earth, row by row of `width` vertices, until no flank is steeper than kFlank: a distance transform in two
// passes, from every vertex to those before it and to those after it.
void settle_flanks(std::vector<float>& earth, int width, float dx) {
    const int rows = static_cast<int>(earth.size()) / width;
    const auto row = [&](int y) { return earth.data() + static_cast<std::ptrdiff_t>(y) * width; };
    for (int y = 0; y < rows; ++y) settle_row(row(y), y > 0 ? row(y - 1) : nullptr, width, 1, dx);
    for (int y = rows - 1; y >= 0; --y)
        settle_row(row(y), y + 1 < rows ? row(y + 1) : nullptr, width, -1, dx);
}

// What a command changes if earth has no limit. Flanks carry each other: none gets steeper than kFlank, one that is
// already may stay.
std::vector<EarthChange> wished_by(const State& s, const Things& t, const Command& c) {
    const Disc disc(c, s.grid.dx);
    const int x0 = std::max(disc.x0 - 1, 0), x1 = std::min(disc.x1 + 1, s.grid.nx - 1);
    const int y0 = std::max(disc.y0 - 1, 0), y1 = std::min(disc.y1 + 1, s.grid.ny - 1), width = x1 - x0 + 1;
    if (x1 < x0 || y1 < y0) return {};
    std::vector<float> highest;
    for (int y = y0; y <= y1; ++y)
        highest.insert(highest.end(), t.earth.row(y) + x0, t.earth.row(y) + x1 + 1);
    const auto number = [&](int x, int y) {
        return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x - x0);
    };

    struct Wish {
        int x, y;
        float to;
    };
    std::vector<Wish> wishes;
    wishes.reserve(static_cast<std::size_t>(vertices_about(disc, s.grid)));
    bool any_up = false, any_down = false;
    const SlopeFilter filter(c);
    disc.each_vertex(s.grid, c.profile, [&](int x, int y, double weight) {
        if (s.site(x, y) != Site::kGround || s.rolling(x, y) > 0 || t.built(x, y) != 0) return;
        if (!filter.takes(s, x, y)) return;
        const auto here = static_cast<double>(s.bedrock(x, y));
        double rise = c.rise * weight;
        if (c.kind == CommandKind::kSmooth)
            rise = std::clamp(mean_beside(s, x, y) - here, -c.rise, c.rise);
        else if (c.kind == CommandKind::kLevel)
            rise = std::clamp(c.level - s.datum - here, -c.rise, c.rise);
        constexpr auto kHighest = static_cast<float>(kHighestEarth);
        const float to = std::clamp(t.earth(x, y) + static_cast<float>(rise), -kHighest, kHighest);
        wishes.push_back({x, y, to});
        any_up = any_up || to > t.earth(x, y);
        any_down = any_down || to < t.earth(x, y);
        highest[number(x, y)] = to;
    });

    std::vector<float> lowest;  // the same upside down
    if (any_down) {
        lowest.resize(highest.size());
        std::transform(highest.begin(), highest.end(), lowest.begin(), std::negate<>());
        settle_flanks(lowest, width, s.grid.dx);
    }
    if (any_up) settle_flanks(highest, width, s.grid.dx);
    std::vector<EarthChange> changes;
    changes.reserve(wishes.size());
    for (const Wish& wish : wishes) {
        const std::size_t i = number(wish.x, wish.y);
        const float from = t.earth(wish.x, wish.y);
        if (wish.to == from) continue;
        const float to = wish.to > from ? std::max(from, highest[i]) : std::min(from, -lowest[i]);
        const std::int64_t now = quanta_in(from), then = quanta_in(nearest_quanta(to));
        if (now != then) changes.push_back({wish.x, wish.y, now, then});
    }
    return changes;
}

// Cuts the changes down to what the budget allows: all by the same share, then quantum by quantum.
void keep_within_budget(const Things& t, std::vector<EarthChange>& changes) {
    if (t.budget < 0) return;
    const EarthMoved before = t.earth_moved;
    constexpr std::int64_t kWhole = std::int64_t{1} << 20;
    const auto at = [](const EarthChange& change, std::int64_t share) {
        return change.from + (change.to - change.from) * share / kWhole;
    };
    const auto used = [&](std::int64_t share) {
        EarthMoved moved = before;
        for (const EarthChange& change : changes) moved.add(change.from, -1), moved.add(at(change, share));
        return moved.used();
    };
    // What gives earth back is always allowed.
    if (used(kWhole) <= std::max(t.budget, before.used())) return;
    std::int64_t most = 0;
    for (std::int64_t step = kWhole / 2; step > 0; step /= 2)
        if (used(most + step) <= t.budget) most += step;
    EarthMoved moved = before;
    for (const EarthChange& change : changes) moved.add(change.from, -1), moved.add(at(change, most));
    for (EarthChange& change : changes) {
        const std::int64_t wished = std::exchange(change.to, at(change, most));
        if (change.to == wished) continue;
        // One more quantum each, which rounding has left.
        EarthMoved more = moved;
        const std::int64_t next = change.to + (wished > change.to ? 1 : -1);
        more.add(change.to, -1), more.add(next);
        if (more.used() <= t.budget) change.to = next, moved = more;
    }
}

// ---------------------------------------------------------------------------------------------- objects

struct Point {
    double x, y;  // m
};

// Half of its length and of its width, as vectors, m.
std::array<Point, 2> half_axes(const Thing& thing) {
    const double length = 0.5 * thing.length, width = 0.5 * thing.width;
    return {
        {{length * thing.front_x, length * thing.front_y}, {width * thing.front_y, -width * thing.front_x}}};
}

std::array<Point, 5> corners_of(const Thing& thing) {
    const auto [a, b] = half_axes(thing);
    return {{{thing.x, thing.y},
             {thing.x - a.x - b.x, thing.y - a.y - b.y},
             {thing.x + a.x - b.x, thing.y + a.y - b.y},
             {thing.x + a.x + b.x, thing.y + a.y + b.y},
             {thing.x - a.x + b.x, thing.y - a.y + b.y}}};
}

// Whether two rectangles have a place in common: no axis of either separates them.
bool overlap(const Thing& a, const Thing& b) {
    const auto of_a = half_axes(a), of_b = half_axes(b);
    for (const Point& side : {of_a[0], of_a[1], of_b[0], of_b[1]}) {
        const auto along = [&](const Point& p) { return std::abs(p.x * side.x + p.y * side.y); };
        if (along({b.x - a.x, b.y - a.y}) >=
            along(of_a[0]) + along(of_a[1]) + along(of_b[0]) + along(of_b[1]))
            return false;
    }
    return true;
}

// Of metres, to the metre.
std::string text_of(double metres) {
    return number_text(std::rint(metres) + 0.0);  // 0, not −0
}
std::string joined(std::initializer_list<std::string_view> parts) {
    std::string sentence;
    for (const std::string_view part : parts) sentence += part;
    return sentence;
}
std::string text_of(Point at) {
    return joined({"(", text_of(at.x), ", ", text_of(at.y), ")"});
}
std::string name_of(const Thing& thing) {
    return joined({to_string(thing.kind), " at ", text_of({thing.x, thing.y})});
}

// What is wrong with a place on the terrain, or nothing.
const char* fault_of_place(const State& s, Point at) {
    const double x = at.x / static_cast<double>(s.grid.dx), y = at.y / static_cast<double>(s.grid.dx);
    if (!(x >= 0 && y >= 0 && x <= s.grid.nx - 1 && y <= s.grid.ny - 1)) return "outside the terrain";
    const int i = std::min(static_cast<int>(x), s.grid.nx - 2),
              j = std::min(static_cast<int>(y), s.grid.ny - 2);
    for (const auto& [k, l] : {std::pair{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}})
        if (s.site(k, l) != Site::kGround) return "where the terrain has no data";
    return nullptr;
}

std::int64_t next_group(const std::vector<Thing>& list) {
    return list.empty() ? 0 : list.back().group + 1;
}

double length_of(const Command& c) {
    const double ex = c.to_x - c.x, ey = c.to_y - c.y;
    return std::sqrt(ex * ex + ey * ey);
}

// Pieces of a row of nets, at most a cell long; spans of a lift.
int parts_of(const Command& c, const Grid& grid) {
    const double far = length_of(c);
    if (c.kind == CommandKind::kNet)
        return std::max(1, static_cast<int>(std::ceil(far / static_cast<double>(grid.dx))));
    return c.kind == CommandKind::kLift ? std::max(1, static_cast<int>(std::rint(far / kPylonsApart))) : 1;
}

// How many objects built_by() makes.
std::size_t count_of(const Command& c, const Grid& grid) {
    return static_cast<std::size_t>(parts_of(c, grid)) + (c.kind == CommandKind::kLift ? 1 : 0);
}

// What a command of building adds to a list, all of one group. A lift is straight, with pylons at equal distances.
std::vector<Thing> built_by(const Command& c, const Grid& grid) {
    std::vector<Thing> built;
    const double ex = c.to_x - c.x, ey = c.to_y - c.y, far = length_of(c);
    const int parts = parts_of(c, grid);
    if (c.kind == CommandKind::kHouse) {
        const Direction front = direction_of(c.turn);
        built.push_back({.kind = ThingKind::kHouse,
                         .x = c.x,
                         .y = c.y,
                         .front_x = front.x,
                         .front_y = front.y,
                         .length = c.length,
                         .width = c.width,
                         .height = c.height,
                         .strength = c.strength});
    } else if (c.kind == CommandKind::kRoad) {
        built.push_back(
            {.kind = ThingKind::kRoad, .x = c.x, .y = c.y, .to_x = c.to_x, .to_y = c.to_y, .width = c.width});
    } else if (c.kind == CommandKind::kNet) {
        const auto end = [&](int i) {
            const double t = static_cast<double>(i) / parts;
            return Point{c.x + t * ex, c.y + t * ey};
        };
        for (int i = 0; i < parts; ++i)
            built.push_back({.kind = ThingKind::kNet,
                             .x = end(i).x,
                             .y = end(i).y,
                             .to_x = end(i + 1).x,
                             .to_y = end(i + 1).y,
                             .height = c.height,
                             .strength = c.strength});
    } else {
        for (int i = 0; i <= parts; ++i) {
            const bool end = i == 0 || i == parts;
            const double t = static_cast<double>(i) / parts;
            Thing thing{.kind = end ? ThingKind::kStation : ThingKind::kPylon,
                        .x = c.x + t * ex,
                        .y = c.y + t * ey,
                        .front_x = ex / far,
                        .front_y = ey / far};
            thing.length = end ? kStationLength : kPylonWidth;
            thing.width = end ? kStationWidth : kPylonWidth;
            thing.height = end ? kStationHeight : kPylonHeight;
            thing.strength = end ? kStationStrength : kPylonStrength;
            built.push_back(thing);
        }
    }
    return built;
}

std::optional<std::string> fault_of_line(const Command& c) {
    const double far = length_of(c);
    const double least = c.kind == CommandKind::kLift ? kShortestLift : 1;
    if (far >= least && far <= kLongestLine) return std::nullopt;
    return joined({"the ", info_of(c.kind).name, " from ", text_of({c.x, c.y}), " is ", text_of(far),
                   " m long; ", text_of(least), " to ", text_of(kLongestLine), " m are allowed"});
}

std::optional<std::string> fault_of_body(const State& s, const std::vector<Thing>& list, const Thing& thing) {
    for (const Point& at : corners_of(thing))
        if (const char* fault = fault_of_place(s, at)) return joined({"the ", name_of(thing), " is ", fault});
    for (const Thing& other : list)
        if (!other.is_line() && overlap(thing, other))
            return joined({"the ", name_of(thing), " stands on the ", name_of(other)});
    return std::nullopt;
}

std::optional<std::string> fault_of_building(const State& s, const std::vector<Thing>& list,
                                             const Command& c) {
    if (c.kind != CommandKind::kHouse)
        if (auto fault = fault_of_line(c)) return fault;
    if (list.size() + count_of(c, s.grid) > kMostThings)  // before they are made
        return joined(
            {"over ", std::to_string(kMostThings), " objects: a lift counts its pylons, nets each cell"});
    const std::vector<Thing> built = built_by(c, s.grid);
    for (const Thing& thing : built) {
        if (!thing.is_line()) {
            if (auto fault = fault_of_body(s, list, thing)) return fault;
            continue;
        }
        for (const Point& at : {Point{thing.x, thing.y}, Point{thing.to_x, thing.to_y}})
            if (const char* fault = fault_of_place(s, at))
                return joined({"the end ", text_of(at), " of the ", to_string(thing.kind), " is ", fault});
    }
    return std::nullopt;
}

void set_front(Thing& house, double turn) {
    const Direction front = direction_of(turn);
    house.front_x = front.x, house.front_y = front.y;
}

// Does a command of building or rearranging to a list. It must have no fault.
void apply_to(std::vector<Thing>& list, const Command& c, const Grid& grid) {
    if (c.kind == CommandKind::kRemove) {
        std::vector<std::int64_t> groups;
        for (const Thing& thing : list)
            if (distance_from(thing, c.x, c.y) <= c.radius) groups.push_back(thing.group);
        std::erase_if(list, [&](const Thing& thing) {
            return std::find(groups.begin(), groups.end(), thing.group) != groups.end();
        });
    } else if (c.kind == CommandKind::kTurn) {
        for (Thing& thing : list)
            if (thing.kind == ThingKind::kHouse && distance_from(thing, c.x, c.y) == 0)
                set_front(thing, c.turn);
    } else {
        const std::int64_t group = next_group(list);
        for (Thing& thing : built_by(c, grid)) {
            thing.group = group;
            list.push_back(thing);
        }
    }
}

std::optional<std::string> fault_of_turning(const State& s, const std::vector<Thing>& list,
                                            const Command& c) {
    for (const Thing& thing : list) {
        if (thing.kind != ThingKind::kHouse || distance_from(thing, c.x, c.y) > 0) continue;
        std::vector<Thing> others;
        for (const Thing& other : list)
            if (&other != &thing) others.push_back(other);
        Thing turned = thing;
        set_front(turned, c.turn);
        return fault_of_body(s, others, turned);
    }
    return joined({"no house stands at ", text_of({c.x, c.y})});
}

std::optional<std::string> fault_of_removing(const std::vector<Thing>& list, const Command& c) {
    const bool any = std::any_of(list.begin(), list.end(), [&](const Thing& thing) {
        return distance_from(thing, c.x, c.y) <= c.radius;
    });
    if (any) return std::nullopt;
    return joined({"nothing stands within ", text_of(c.radius), " m of ", text_of({c.x, c.y})});
}

std::optional<std::string> fault_of_sculpting(const State& s, const Command& c) {
    bool flows = false;
    Disc(c, s.grid.dx).each_vertex(s.grid, Profile::kDisc, [&](int x, int y, double) {
        flows = flows || (s.site(x, y) == Site::kGround && s.rolling(x, y) > 0);
    });
    if (flows) return joined({"the ground at ", text_of({c.x, c.y}), " cannot be changed under a flow"});
    if (!s.things || s.things->budget < 0) return std::nullopt;
    std::vector<EarthChange> changes = wished_by(s, *s.things, c);
    const bool wished = !changes.empty();
    keep_within_budget(*s.things, changes);
    const bool allowed = std::any_of(changes.begin(), changes.end(),
                                     [](const EarthChange& change) { return change.from != change.to; });
    if (!wished || allowed) return std::nullopt;
    const double budget =
        static_cast<double>(s.things->budget) * static_cast<double>(kQuantum) * s.grid.cell_area();
    const double rounded = std::rint(10 * budget) / 10;
    return joined({"the budget of earth, ", number_text(rounded), " m3, is used up"});
}

// Water in the soil acts by the weight of the soil, in the models whose friction it takes.
double lightest_density(const State& s) {
    return static_cast<double>(s.mixture ? std::min(s.params.density, s.mixture->lower.density)
                                         : s.params.density);
}

std::optional<std::string> fault_of_soaking(const State& s, const Command& c) {
    const std::string_view name = info_of(c.kind).name;
    if (!has_momentum(s.params.model))
        return joined({name, " acts in the models bcre-inertial and voellmy, and this world has ",
                       to_string(s.params.model)});
    const double lightest = lightest_density(s);
    if (lightest > kWaterDensity) return std::nullopt;
    const std::string lacks = lightest > 0 ? joined({"has ", number_text(lightest), " kg/m3"}) : "has none";
    return joined({name, " needs a material with a density of over ", number_text(kWaterDensity),
                   " kg/m3, and that of this world ", lacks});
}

}  // namespace

double distance_from(const Thing& thing, double x, double y) {
    if (thing.is_line()) {
        const double ex = thing.to_x - thing.x, ey = thing.to_y - thing.y, squared = ex * ex + ey * ey;
        const double t =
            squared > 0 ? std::clamp(((x - thing.x) * ex + (y - thing.y) * ey) / squared, 0.0, 1.0) : 0;
        const double px = x - (thing.x + t * ex), py = y - (thing.y + t * ey);
        return std::max(std::sqrt(px * px + py * py) - 0.5 * thing.width, 0.0);
    }
    const double along = std::abs((x - thing.x) * thing.front_x + (y - thing.y) * thing.front_y);
    const double across = std::abs((x - thing.x) * thing.front_y - (y - thing.y) * thing.front_x);
    const double a = std::max(along - 0.5 * thing.length, 0.0), b = std::max(across - 0.5 * thing.width, 0.0);
    return std::sqrt(a * a + b * b);
}

void sculpt(State& s, const Command& c) {
    Things& t = things_of(s);
    std::vector<EarthChange> changes = wished_by(s, t, c);
    keep_within_budget(t, changes);
    for (const EarthChange& change : changes) {
        t.earth(change.x, change.y) = static_cast<float>(change.to) * kQuantum;
        t.earth_moved.add(change.from, -1), t.earth_moved.add(change.to);
        set_bedrock(s, change.x, change.y);
    }
    if (!changes.empty()) ++t.changed, t.unhashed = true;
}

void plant(State& s, const Command& c) {
    Things& t = things_of(s);
    const Stems stems = c.kind == CommandKind::kFell
                            ? Stems{}
                            : Stems{static_cast<std::uint16_t>(std::rint(c.stems)), 0,
                                    static_cast<std::uint8_t>(std::rint(100 * c.diameter)),
                                    static_cast<std::uint8_t>(std::rint(c.height))};
    each_ground(s, c, Profile::kDisc, [&](int x, int y, double) {
        if (c.kind == CommandKind::kPlant && t.built(x, y) != 0) return;
        t.forest(x, y) = stems;
        rebuild_forest(s, x, y);
    });
    ++t.changed, t.unhashed = true;
}

void build(State& s, const Command& c) {
    Things& t = things_of(s);
    if (fault_of_building(s, t.list, c)) return;
    apply_to(t.list, c, s.grid);
    t.unhashed = true;
}

void rearrange(State& s, const Command& c) {
    Things& t = things_of(s);
    if (c.kind == CommandKind::kTurn && fault_of_turning(s, t.list, c)) return;
    apply_to(t.list, c, s.grid);
    t.unhashed = true;
}

bool is_of_objects(const Command& c) {
    return c.kind >= CommandKind::kHouse && c.kind <= CommandKind::kRemove;
}

std::optional<std::string> fault_of_visits(const Grid& grid, std::span<const Command> commands,
                                           std::int64_t always) {
    const auto whole = static_cast<std::int64_t>(grid.size());
    std::int64_t visits = 0;
    bool in_a_row = false;  // the last command was of objects too
    for (const Command& c : commands) {
        const bool objects = is_of_objects(c);
        if (objects && !in_a_row) visits += whole;
        in_a_row = objects;
        if (c.kind >= CommandKind::kSculpt && c.kind <= CommandKind::kFell)
            visits += vertices_about(Disc(c, grid.dx), grid);
    }
    const std::int64_t most = std::max(kMostVisits * whole, always);
    if (visits <= most) return std::nullopt;
    return joined({"the commands of things visit ", std::to_string(visits),
                   " vertices together; on this grid ", std::to_string(most),
                   " are allowed: use smaller discs, or fewer at once"});
}

bool takes_water(const State& s) {
    return has_momentum(s.params.model) && lightest_density(s) > kWaterDensity;
}

std::optional<std::string> fault_of_place(const State& s, const Command& c) {
    switch (c.kind) {
        case CommandKind::kHouse:
        case CommandKind::kLift:
        case CommandKind::kNet:
        case CommandKind::kRoad:
            return fault_of_building(s, {}, c);
        case CommandKind::kWet:
        case CommandKind::kDrain:
            return fault_of_soaking(s, c);
        default:
            return std::nullopt;
    }
}

std::optional<ThingFault> fault_of_things(const State& s, std::span<const Command> commands) {
    std::optional<std::vector<Thing>> list;  // as it will be
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& c = commands[i];
        std::optional<std::string> fault;
        switch (c.kind) {
            case CommandKind::kSculpt:
            case CommandKind::kSmooth:
            case CommandKind::kLevel:
                fault = fault_of_sculpting(s, c);
                break;
            case CommandKind::kWet:
            case CommandKind::kDrain:
                fault = fault_of_soaking(s, c);
                break;
            case CommandKind::kHouse:
            case CommandKind::kLift:
            case CommandKind::kNet:
            case CommandKind::kRoad:
            case CommandKind::kTurn:
            case CommandKind::kRemove: {
                if (!list) list = s.things ? s.things->list : std::vector<Thing>();
                fault = c.kind == CommandKind::kTurn     ? fault_of_turning(s, *list, c)
                        : c.kind == CommandKind::kRemove ? fault_of_removing(*list, c)
                                                         : fault_of_building(s, *list, c);
                if (!fault) apply_to(*list, c, s.grid);
                break;
            }
            default:
                break;
        }
        if (fault) return ThingFault{i, *fault};
    }
    return std::nullopt;
}

}  // namespace sim
