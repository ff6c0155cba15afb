#include "sim/front/space_time_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

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

double square(double x) {
    return x * x;
}

// Much like e^(−s²/16), but nothing from kReach2 on.
double weight_at(double s) {
    const double share = 1 - s * s / kReach2;
    return share * share * share;
}

}  // namespace

Piece SpaceTimeFit::operator()(const Moment& now, std::span<const Flips> flips, std::span<const int> cuts,
                               int edge, Piece piece) {
    const Mesh& mesh = now.detector.mesh();
    const auto [a, b] = mesh.edge[edge];
    cell_ = std::min(mesh.cell[a], mesh.cell[b]);
    normal_ = piece.normal;
    one_way_ = one_way_at(std::abs(double{piece.bend}) * cell_);
    middle_ = 0.5 * (glm::dvec2(mesh.position[a]) + glm::dvec2(mesh.position[b]));
    step_ = std::abs(piece.speed) * now.dt / cell_;
    near_.gather(now.detector, cuts, edge);
    collect_flips(now, flips);
    collect_crossings(mesh);
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
    const glm::dvec2 from = (glm::dvec2(position) - middle_) / cell_;
    return {-normal_.y * from.x + normal_.x * from.y, glm::dot(normal_, from)};
}

void SpaceTimeFit::collect_flips(const Moment& now, std::span<const Flips> flips) {
    rows_.clear();
    for (const auto& [vertex, side] : near_.vertices()) {
        if (flips[vertex].last[0].time == kNever) continue;
        const auto [s, D] = place(now.detector.mesh().position[vertex]);
        if (s * s >= kReach2) continue;
        const double weight = weight_at(s);
        // The newest went toward B where it left a vertex on A's side; the one before it the other way.
        double way = side;
        for (const Flip& flip : flips[vertex].last) {
            if (flip.time == kNever) break;
            const double along = way * glm::dot(glm::dvec2(flip.direction), normal_);
            if (along > one_way_)
                rows_.push_back({s, D, now.time - flip.time,
                                 weight * std::min((along - one_way_) / (kSurely - one_way_), 1.0)});
            way = -way;
        }
    }
    std::sort(rows_.begin(), rows_.end(), [](const Row& x, const Row& y) { return x.age < y.age; });
}

// What the front crosses now lies on either side of it.
void SpaceTimeFit::collect_crossings(const Mesh& mesh) {
    middles_.clear(), ends_.clear();
    for (const auto& crossing : near_.crossings()) {
        const auto [sa, Da] = place(mesh.position[crossing.a]);
        const auto [sb, Db] = place(mesh.position[crossing.b]);
        const double s = (sa + sb) / 2, D = (Da + Db) / 2;
        if (s * s + D * D > kNear2 || Db - Da < kLeastAcross) continue;
        middles_.push_back({s, D, Db - Da, weight_at(s)});
        ends_.push_back({sa, Da, 1}), ends_.push_back({sb, Db, -1});
    }
}

void SpaceTimeFit::choose_window(double dt) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    double age = 0;
    int count = 0;
    for (const Row& row : rows_) {
        age = row.age;
        least = std::min(least, row.D), most = std::max(most, row.D);
        if (++count > kWindowRows && most - least >= kWindowSpan) break;
    }
    short_window_ = std::max(kWindowShare * age, kLeastWindow * dt);
    window_ = std::max(short_window_, std::min(kUsualWindow * dt, kMostUsual));
}

void SpaceTimeFit::solve() {
    front_ = {};
    const double frame = std::min(kMostOfStep, square(step_) / 12);  // variance of when a flip was
    for (const Row& row : rows_) {
        const double z = row.age / window_;
        if (z > kWindowEnd) break;
        front_.add(row.s, -z, row.D, row.weight / (square(kOfFlip) + frame + square(kOfModel * z * z * z)));
    }
    const double youngest = rows_.empty() ? window_ : rows_.front().age;
    const double fresh = std::max(0.0, 1 - youngest / window_);
    for (const auto& [s, D, across, weight] : middles_) {
        const double deviation =
            kOfMiddle * (1 + kLessWhereFresh * fresh * fresh) * std::max(across, kLeastDeviating);
        front_.add(s, 0, D, weight / square(deviation));
    }
    front_.solve();
}

// By how much a vertex lies on the wrong side, cells.
double SpaceTimeFit::violation(const End& end) const {
    return end.side * (end.D - front_.at(end.s, 0));
}

// A front that has just turned back does not fit a long window.
bool SpaceTimeFit::misses_newest() const {
    if (!rows_.empty()) {
        double sum = 0, weights = 0;
        for (const Row& row : rows_) {
            if (row.age > rows_.front().age) break;
            sum += row.weight * square(row.D - front_.at(row.s, -row.age / window_));
            weights += row.weight;
        }
        if (sum > weights * (square(1.5 * step_) / 12 + square(kOfNewest))) return true;
    }
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
        front_.add(worst->s, 0, worst->D, 1 / square(kSideKept));
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
