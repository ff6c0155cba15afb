#include "sim/front/space_time_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "sim/numbers.h"

namespace sim::front {
namespace {

constexpr double kReach2 = 48;  // cells² along the front: rows farther away weigh nothing
// Cosine between the way the front went at a flip and the normal: none counts below kOneWay, all above
// kSurely. Where the front is bent, neighbours go other ways.
constexpr double kOneWay = 0.6, kSurely = 0.9;
double one_way_at(double bend) {  // 1/cells
    return kOneWay - std::clamp(bend - 0.25, 0.0, 0.5);
}

// The window of time: it reaches back to where so many rows span so many cells across the front, but to so
// many steps at least, if that is not too long for a quadratic to follow. A short one does instead where it
// is this much shorter and the long one misses the newest flips.
constexpr int kWindowRows = 8;
constexpr double kWindowSpan = 1.3, kWindowShare = 0.7, kWindowEnd = 2.5;
constexpr double kLeastWindow = 4, kUsualWindow = 30;  // steps
constexpr double kMostUsual = 0.8;                     // s
constexpr double kMuchShorter = 1.3;

// Deviations, cells: of a flip, to which comes what the front goes in a step; of what a quadratic cannot
// follow, times the cube of the age in windows; of the newest flips from a window that fits them.
constexpr double kOfFlip = 0.02, kOfModel = 0.2, kOfNewest = 0.03;
constexpr double kMostOfStep = 0.1;  // variance that comes of a step at most, cells²

// That the front crosses an edge now says that it is near the middle, give or take this share of the edge;
// less where flips are fresh. Edges count that lie so near and go so far across.
constexpr double kOfMiddle = 0.4, kLessWhereFresh = 15;
constexpr double kNear2 = 9, kLeastAcross = 0.05, kLeastDeviating = 0.2;  // cells², cells, cells

// How far a vertex may lie on the wrong side, cells, and how many are put right at most; beyond the last a
// front has turned back.
constexpr double kSideKept = 0.02, kSideLost = 0.1;
constexpr int kSidesKept = 5;

// Rows that are reckoned with at once: so many on any machine, so that sums have the same bits.
using Lanes = stdx::simd<double, stdx::simd_abi::deduce_t<double, Shore::kLanes>>;
constexpr std::size_t kLanes = Shore::kLanes;

constexpr double kNone = std::numeric_limits<double>::infinity();

double square(double x) {
    return x * x;
}

// Much like e^(−s²/16), but nothing from kReach2 on.
double weight_at(double s) {
    const double share = 1 - s * s / kReach2;
    return share * share * share;
}

MovingQuadratic::Sums<double> total(const MovingQuadratic::Sums<Lanes>& lanes) {
    MovingQuadratic::Sums<double> sums;
    for (std::size_t i = 0; i < sums.power.size(); ++i) sums.power[i] = stdx::reduce(lanes.power[i]);
    for (std::size_t i = 0; i < sums.with_D.size(); ++i) sums.with_D[i] = stdx::reduce(lanes.with_D[i]);
    return sums;
}

}  // namespace

Piece SpaceTimeFit::operator()(const Moment& now, std::span<const Flips> flips, std::span<const int> cuts,
                               int edge, Piece piece) {
    const Mesh& mesh = now.detector.mesh();
    const auto [a, b] = mesh.edge[edge];
    cell_ = std::min(mesh.cell[a], mesh.cell[b]);
    per_cell_ = 1 / cell_;
    normal_ = piece.normal;
    one_way_ = one_way_at(std::abs(double{piece.bend}) * cell_);
    middle_ = 0.5 * (glm::dvec2(mesh.position[a]) + glm::dvec2(mesh.position[b]));
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

// s and D.
std::pair<double, double> SpaceTimeFit::place(const glm::vec2& position) const {
    const glm::dvec2 from = (glm::dvec2(position) - middle_) * per_cell_;
    return {-normal_.y * from.x + normal_.x * from.y, glm::dot(normal_, from)};
}

// Which vertices are beyond the front. One that lies on both shores is the nearer one's.
void SpaceTimeFit::claim(const Shore& here, const Shore& beyond) {
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

void SpaceTimeFit::collect_flips(const Shore& here, const Shore& beyond) {
    rows_.begin[1] = Shore::filled_up(here.flipped.size());
    rows_.begin[2] = rows_.begin[1] + Shore::filled_up(beyond.flipped.size());
    if (rows_.s.size() < rows_.begin[2]) rows_.resize(2 * rows_.begin[2]);
    collect_flips(here, 1, rows_.begin[0]);
    collect_flips(beyond, -1, rows_.begin[1]);
    youngest_ = kNone;
    for (const int side : {0, 1})
        for (std::size_t i = rows_.begin[side]; i < rows_.begin[side + 1]; ++i)
            if (rows_.weight[i] > 0) {
                youngest_ = std::min(youngest_, rows_.age[i]);
                break;
            }
}

void SpaceTimeFit::collect_flips(const Shore& shore, double side, std::size_t first) {
    const std::size_t count = shore.flipped.size();
    double* __restrict s = &rows_.s[first], * __restrict D = &rows_.D[first];
    double* __restrict age = &rows_.age[first], * __restrict weight = &rows_.weight[first];
    const double *x = shore.x, *y = shore.y, *then = shore.age, *east = shore.east, *north = shore.north;
    const double u = normal_.x / cell_, v = normal_.y / cell_, from_x = middle_.x, from_y = middle_.y;
    const double way_x = side * normal_.x, way_y = side * normal_.y, one_way = one_way_;
    const double per_way = 1 / (kSurely - one_way);
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x[i] - from_x, dy = y[i] - from_y;
        s[i] = u * dy - v * dx, D[i] = u * dx + v * dy, age[i] = then[i];
        const double far = std::max(0.0, 1 - s[i] * s[i] / kReach2);
        const double along = (way_x * east[i] + way_y * north[i] - one_way) * per_way;
        weight[i] = far * far * far * std::min(std::max(along, 0.0), 1.0);
    }
    if (meet_)
        for (std::size_t i = 0; i < count; ++i)
            if (is_beyond(shore.flipped[i]) == side > 0) weight[i] = 0;
    for (std::size_t i = count; i % kLanes != 0; ++i) s[i] = D[i] = age[i] = weight[i] = 0;
}

// What the front crosses now lies on either side of it, and near the middle of its edge.
void SpaceTimeFit::collect_crossings(const Mesh& mesh, const Shore& here) {
    crossed_ = {}, ends_.clear();
    for (const auto& crossing : here.crossings) {
        if (!is_beyond(crossing.beyond) || (meet_ && is_beyond(crossing.here))) continue;
        const auto [sa, Da] = place(mesh.position[crossing.here]);
        const auto [sb, Db] = place(mesh.position[crossing.beyond]);
        const double s = (sa + sb) / 2, D = (Da + Db) / 2;
        if (s * s + D * D > kNear2 || Db - Da < kLeastAcross) continue;
        crossed_.add_now(s, D, weight_at(s) / square(std::max(Db - Da, kLeastDeviating)));
        ends_.push_back({sa, Da, 1}), ends_.push_back({sb, Db, -1});
    }
}

void SpaceTimeFit::choose_window(double dt) {
    double least = kNone, most = -kNone;
    double age = 0;
    int count = 0;
    std::size_t a = rows_.begin[0], b = rows_.begin[1];
    while (a < rows_.begin[1] || b < rows_.begin[2]) {
        const bool is_b = a == rows_.begin[1] || (b < rows_.begin[2] && rows_.age[b] < rows_.age[a]);
        const std::size_t i = is_b ? b++ : a++;
        if (rows_.weight[i] <= 0) continue;
        age = rows_.age[i];
        least = std::min(least, rows_.D[i]), most = std::max(most, rows_.D[i]);
        if (++count > kWindowRows && most - least >= kWindowSpan) break;
    }
    short_window_ = std::max(kWindowShare * age, kLeastWindow * dt);
    window_ = std::max(short_window_, std::min(kUsualWindow * dt, kMostUsual));
}

void SpaceTimeFit::solve() {
    front_.sums = {};
    add_flips();
    const double fresh = std::max(0.0, 1 - std::min(youngest_, window_) / window_);
    front_.sums.add(crossed_, 1 / square(kOfMiddle * (1 + kLessWhereFresh * fresh * fresh)));
    front_.solve();
}

void SpaceTimeFit::add_flips() {
    MovingQuadratic::Sums<Lanes> sums;
    const Lanes variance = square(kOfFlip) + std::min(kMostOfStep, square(step_) / 12);
    const Lanes per_window = 1 / window_;
    for (const int side : {0, 1})
        for (std::size_t i = rows_.begin[side]; i < rows_.begin[side + 1]; i += kLanes) {
            const auto load = [i](const std::vector<double>& of) {
                return Lanes(&of[i], stdx::element_aligned);
            };
            const Lanes z = load(rows_.age) * per_window, far = kOfModel * z * z * z;
            const auto counts = z <= kWindowEnd;
            if (stdx::none_of(counts)) break;
            Lanes weight = load(rows_.weight) / (variance + far * far);
            where(!counts, weight) = 0;
            sums.add(load(rows_.s), -z, load(rows_.D), weight);
        }
    front_.sums.add(total(sums));
}

// By how much a vertex lies on the wrong side, cells.
double SpaceTimeFit::violation(const End& end) const {
    return end.side * (end.D - front_.at(end.s, 0));
}

// A front that has just turned back does not fit a long window.
bool SpaceTimeFit::misses_newest() const {
    double sum = 0, weights = 0;
    for (const int side : {0, 1})
        for (std::size_t i = rows_.begin[side]; i < rows_.begin[side + 1]; ++i) {
            if (rows_.age[i] > youngest_) break;
            sum += rows_.weight[i] * square(rows_.D[i] - front_.at(rows_.s[i], -rows_.age[i] / window_));
            weights += rows_.weight[i];
        }
    if (sum > weights * (square(1.5 * step_) / 12 + square(kOfNewest))) return true;
    return std::any_of(ends_.begin(), ends_.end(),
                       [&](const End& end) { return violation(end) > kSideLost + step_; });
}

// What has not flipped yet the front has not passed: the worst that is on the wrong side becomes a row.
void SpaceTimeFit::keep_sides() {
    for (int round = 0; round < kSidesKept; ++round) {
        const End* worst = nullptr;
        double by = kSideKept;
        for (const End& end : ends_)
            if (const double violated = violation(end); violated > by) worst = &end, by = violated;
        if (!worst) return;
        front_.sums.add_now(worst->s, worst->D, 1 / square(kSideKept));
        front_.solve();
    }
}

Piece SpaceTimeFit::met(const Mesh& mesh, int edge, Piece piece) const {
    const auto [sa, Da] = place(mesh.position[mesh.edge[edge].a]);
    const auto [sb, Db] = place(mesh.position[mesh.edge[edge].b]);
    double f = 0.5;
    for (int round = 0; round < 3; ++round) {
        const double s = sa + f * (sb - sa);
        const double rise = Db - Da - front_.slope(s) * (sb - sa);
        f -= (Da + f * (Db - Da) - front_.at(s, 0)) / std::max(rise, 0.05);
        f = std::clamp(f, 0.0, 1.0);
    }
    const double s = sa + f * (sb - sa);
    const glm::dvec2 tangent(-normal_.y, normal_.x);
    piece.f = static_cast<float>(f);
    piece.normal = glm::vec2(glm::normalize(normal_ - front_.slope(s) * tangent));
    piece.speed = static_cast<float>(front_.speed(s) * cell_ / window_);
    piece.bend = static_cast<float>(front_.bend() / cell_);
    return piece;
}

}  // namespace sim::front
