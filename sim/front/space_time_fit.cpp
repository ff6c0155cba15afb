#include "sim/front/space_time_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace sim::front {
namespace {

constexpr double kReach2 = 48;  // cells² along the front; farther rows have no weight
// Cosine between the front's direction at a flip and the normal: below kOneWay a flip does not count, above
// kSurely it counts fully. Where the front is curved, neighbouring directions differ more.
constexpr double kOneWay = 0.6, kSurely = 0.9;
double one_way_at(double bend) {  // 1/cells
    return kOneWay - std::clamp(bend - 0.25, 0.0, 0.5);
}

// The window of time. It reaches back until kWindowRows rows span kWindowSpan cells across the front, but at
// least kUsualWindow steps, if that is not too long for a quadratic. The short window is used instead if the
// long one misses the newest flips and is at least kMuchShorter times as long.
constexpr int kWindowRows = 8;
constexpr double kWindowSpan = 1.3, kWindowShare = 0.7, kWindowEnd = 2.5;
constexpr double kLeastWindow = 4, kUsualWindow = 30;  // steps
constexpr double kMostUsual = 0.8;                     // s
constexpr double kMuchShorter = 1.3;

// Speed that a front may gain in a window, cells per window². It is less if the front moves kLongStep cells
// or more per step, because flip times then say little.
constexpr double kGain = 10, kLongStep = 0.2;

// Deviations, cells: of a flip, to which the front's step is added; of what a quadratic cannot follow, times
// the cube of the age in windows; of the newest flips from a window that fits them.
constexpr double kOfFlip = 0.02, kOfModel = 0.2, kOfNewest = 0.03;
constexpr double kMostOfStep = 0.1;  // greatest variance due to a step, cells²

// A crossed edge is a row too: the front is at its middle, within this share of its length. It weighs less if
// flips are fresh. An edge counts if it is near and goes far enough across the front.
constexpr double kOfMiddle = 0.4, kLessWhereFresh = 15;
constexpr double kNear2 = 9, kLeastAcross = 0.05, kLeastDeviating = 0.2;  // cells², cells, cells

// How far a vertex may lie on the wrong side, cells, and how many are corrected at most. Beyond kSideLost a
// front has turned back.
constexpr double kSideKept = 0.02, kSideLost = 0.1;
constexpr int kSidesKept = 5;

constexpr double kNone = std::numeric_limits<double>::infinity();

double square(double x) {
    return x * x;
}

MovingQuadratic::Sums<double> total(const fit::LaneSums& lanes) {
    static_assert(fit::kLanes == 4);
    MovingQuadratic::Sums<double> sums;
    for (int i = 0; i < sums.kAll; ++i)
        sums.of[i] = (lanes[i][0] + lanes[i][2]) + (lanes[i][1] + lanes[i][3]);
    return sums;
}

// Takes the next `count` numbers as a list.
double* take(double*& from, int count) {
    return std::exchange(from, from + count);
}

}  // namespace

FrontFit SpaceTimeFit::operator()(const TrackedMoment& now, std::span<const Flips> flips,
                                  std::span<const int> cuts, int edge, FrontFit piece) {
    const Mesh& mesh = now.detector.mesh();
    const auto [a, b] = mesh.edge[edge];
    cell_ = std::min(mesh.cell[a], mesh.cell[b]);
    const glm::dvec2 middle = 0.5 * (glm::dvec2(mesh.position[a]) + glm::dvec2(mesh.position[b]));
    frame_ = {middle.x, middle.y, piece.normal.x / cell_, piece.normal.y / cell_};
    one_way_ = one_way_at(std::abs(double{piece.bend}) * cell_);
    step_ = std::abs(piece.speed) * now.dt / cell_;
    const int here = shores_.find(now.detector, cuts, flips, now.time, a);
    const int beyond = shores_.find(now.detector, cuts, flips, now.time, b);
    claim(shores_[here], shores_[beyond]);
    collect_flips(shores_[here], shores_[beyond]);
    collect_crossings(mesh, shores_[here]);
    choose_window(now.dt);
    solve();
    if (window_ > kMuchShorter * short_window_ && misses_newest()) {
        window_ = short_window_;
        solve();
    }
    keep_sides();
    return met(mesh, edge, piece);
}

// Marks the vertices beyond the front. One that is in both neighbourhoods belongs to the nearer vertex.
void SpaceTimeFit::claim(const OneSidedNeighbourhood& here, const OneSidedNeighbourhood& beyond) {
    ++round_;
    int next = 0;
    for (std::uint64_t ring = 0; ring < beyond.ring_end.size(); ++ring)
        for (; next < beyond.ring_end[ring]; ++next)
            beyond_[beyond.vertices[next]] = round_ * kRingsOf + ring;
    meet_ = false;
    for (const int vertex : here.vertices) meet_ |= is_beyond(vertex);
    if (!meet_) return;
    next = 0;
    for (std::uint64_t ring = 0; ring < here.ring_end.size(); ++ring)
        for (; next < here.ring_end[ring]; ++next) {
            std::uint64_t& that = beyond_[here.vertices[next]];
            if (that >= round_ * kRingsOf + ring) that = 0;
        }
}

void SpaceTimeFit::collect_flips(const OneSidedNeighbourhood& here, const OneSidedNeighbourhood& beyond) {
    const OneSidedNeighbourhood* const shores[] = {&here, &beyond};
    int length[2];
    for (const int side : {0, 1}) {
        sides_[side].count = static_cast<int>(shores[side]->flipped.size());
        length[side] = fit::filled_up(sides_[side].count);
    }
    flip_numbers_.resize(
        std::max(flip_numbers_.size(), static_cast<std::size_t>(4 * (length[0] + length[1]))));
    double* next = flip_numbers_.data();
    youngest_ = kNone;
    for (const int side : {0, 1}) {
        auto& [count, rows] = sides_[side];
        rows = {take(next, length[side]), take(next, length[side]), take(next, length[side]),
                take(next, length[side])};
        // On this side the front went along the normal, beyond it against it.
        const double way = side == 0 ? cell_ : -cell_;
        kernels_.place_flips(frame_, {way * frame_.u, way * frame_.v, one_way_, kSurely, kReach2},
                             shores[side]->flips, count, rows);
        if (meet_) forget_flips(*shores[side], side == 0, rows);
        const double* newest = std::find_if(rows.weight, rows.weight + count, [](double w) { return w > 0; });
        if (newest < rows.weight + count) youngest_ = std::min(youngest_, rows.age[newest - rows.weight]);
    }
}

// Removes flips of shared vertices that belong to the other side.
void SpaceTimeFit::forget_flips(const OneSidedNeighbourhood& shore, bool of_here, const fit::FlipRows& rows) {
    for (std::size_t i = 0; i < shore.flipped.size(); ++i)
        if (is_beyond(shore.flipped[i]) == of_here) rows.weight[i] = 0;
}

// A crossed edge has an end on either side of the front, which is near its middle.
void SpaceTimeFit::collect_crossings(const Mesh& mesh, const OneSidedNeighbourhood& here) {
    const int length = fit::filled_up(static_cast<int>(here.crossings.size()));
    crossing_numbers_.resize(std::max(crossing_numbers_.size(), static_cast<std::size_t>(11 * length)));
    double* next = crossing_numbers_.data();
    double *const x = take(next, length), *const y = take(next, length);
    double *const beyond_x = take(next, length), *const beyond_y = take(next, length);
    crossing_rows_ = {take(next, length), take(next, length), take(next, length), take(next, length),
                      take(next, length)};
    wrong_ = take(next, length), wrong_beyond_ = next;
    crossings_ = 0;
    for (const auto& crossing : here.crossings) {
        if (!is_beyond(crossing.beyond) || (meet_ && is_beyond(crossing.here))) continue;
        const glm::vec2 from = mesh.position[crossing.here], to = mesh.position[crossing.beyond];
        x[crossings_] = from.x, y[crossings_] = from.y;
        beyond_x[crossings_] = to.x, beyond_y[crossings_] = to.y;
        crossing_rows_.counts[crossings_++] = 1;
    }
    for (int i = crossings_; i < fit::filled_up(crossings_); ++i)
        x[i] = y[i] = beyond_x[i] = beyond_y[i] = crossing_rows_.counts[i] = 0;
    fit::LaneSums lanes{};
    kernels_.place_crossings(frame_, {kNear2, kLeastAcross, kLeastDeviating, kReach2},
                             {x, y, beyond_x, beyond_y}, crossings_, crossing_rows_, lanes);
    crossed_ = total(lanes);
}

void SpaceTimeFit::choose_window(double dt) {
    double least = kNone, most = -kNone, age = 0;
    int count = 0;
    const auto& [here, beyond] = sides_;
    int a = 0, b = 0;
    while (a < here.count || b < beyond.count) {
        const bool is_b = a == here.count || (b < beyond.count && beyond.rows.age[b] < here.rows.age[a]);
        const fit::FlipRows& rows = is_b ? beyond.rows : here.rows;
        const int i = is_b ? b++ : a++;
        if (rows.weight[i] <= 0) continue;
        age = rows.age[i];
        least = std::min(least, rows.D[i]), most = std::max(most, rows.D[i]);
        if (++count > kWindowRows && most - least >= kWindowSpan) break;
    }
    short_window_ = std::max(kWindowShare * age, kLeastWindow * dt);
    window_ = std::max(short_window_, std::min(kUsualWindow * dt, kMostUsual));
}

void SpaceTimeFit::solve() {
    // variance of the flip time, as a distance
    const double frame = std::min(kMostOfStep, square(step_) / 12);
    const fit::Deviation deviation{window_, kWindowEnd, square(kOfFlip) + frame, kOfModel};
    fit::LaneSums lanes{};
    for (const Side& side : sides_) kernels_.add_flips(deviation, side.rows, side.count, lanes);
    front_.sums = total(lanes);
    front_.gain = step_ > kLongStep ? kGain * std::sqrt(kLongStep / step_) : kGain;
    const double fresh = std::max(0.0, 1 - std::min(youngest_, window_) / window_);
    front_.sums.add(crossed_, 1 / square(kOfMiddle * (1 + kLessWhereFresh * fresh * fresh)));
    front_.solve();
}

// Finds how far ends of crossed edges lie on the wrong side now, in wrong_; returns the largest, cells.
double SpaceTimeFit::find_wrong() {
    const double now[] = {front_.at(0, 0), front_.slope(0), front_.bend()};
    return kernels_.find_wrong(now, crossing_rows_, crossings_, wrong_, wrong_beyond_);
}

// True if a long window does not fit, because the front has just turned back.
bool SpaceTimeFit::misses_newest() {
    double sum = 0, weights = 0;
    for (const auto& [count, rows] : sides_)
        for (int i = 0; i < count && rows.age[i] <= youngest_; ++i) {
            sum += rows.weight[i] * square(rows.D[i] - front_.at(rows.s[i], -rows.age[i] / window_));
            weights += rows.weight[i];
        }
    if (sum > weights * (square(1.5 * step_) / 12 + square(kOfNewest))) return true;
    return find_wrong() > kSideLost + step_;
}

// A vertex that has not flipped has not been passed: the worst one on the wrong side becomes a row.
void SpaceTimeFit::keep_sides() {
    for (int round = 0; round < kSidesKept; ++round) {
        const double most = find_wrong();
        if (most <= kSideKept) return;
        const auto worst_of = [&](const double* wrong) {
            return static_cast<int>(std::find(wrong, wrong + crossings_, most) - wrong);
        };
        const int here = worst_of(wrong_), beyond = worst_of(wrong_beyond_);
        const auto& rows = crossing_rows_;
        if (here <= beyond)
            front_.sums.add_now(rows.s[here], rows.D[here], 1 / square(kSideKept));
        else
            front_.sums.add_now(rows.beyond_s[beyond], rows.beyond_D[beyond], 1 / square(kSideKept));
        front_.solve();
    }
}

FrontFit SpaceTimeFit::met(const Mesh& mesh, int edge, FrontFit piece) const {
    const auto [u, v] = std::pair(frame_.u, frame_.v);
    const glm::dvec2 along = mesh.along(edge);  // s and D are 0 at its middle
    const double ds = u * along.y - v * along.x, dD = u * along.x + v * along.y;
    double f = 0.5;
    for (int round = 0; round < 3; ++round) {
        const double s = (f - 0.5) * ds;
        f -= ((f - 0.5) * dD - front_.at(s, 0)) / std::max(dD - front_.slope(s) * ds, 0.05);
        f = std::clamp(f, 0.0, 1.0);
    }
    const double s = (f - 0.5) * ds;
    const glm::dvec2 normal(piece.normal), tangent(-normal.y, normal.x);
    piece.f = static_cast<float>(f);
    piece.normal = glm::vec2(glm::normalize(normal - front_.slope(s) * tangent));
    piece.speed = static_cast<float>(front_.speed(s) * cell_ / window_);
    piece.bend = static_cast<float>(front_.bend() / cell_);
    return piece;
}

}  // namespace sim::front
