#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "sim/front/locator.h"
#include "sim/front/moving_quadratic.h"
#include "sim/workers.h"

// A vertex flips when a front passes it: its velocity jumps. The flips near a cut edge, with their times,
// sides and directions, are samples of the surface that the front sweeps in space and time. A small quadratic
// piece of it (moving_quadratic.h) is fitted to them and met with the edge as it is now.
//
//           A ── A ── A        A, B: vertices that are reached from either end of the edge without
//            \  / \  / \       crossing the front. Of each the last flips are known: when the front
//     ········\/···\/···\····  passed, and which way it went. On A's side it went as the normal n
//              B ── B ── B     points, on B's against it, or it has come back since.
//
// Lengths are in cells: the shorter of the shortest edges at both ends; times in windows. Sides are those of
// one edge, so any number of regions may meet.

namespace sim::front {
namespace {

constexpr int kRings = 4;       // of vertices around an edge that are asked
constexpr int kFlips = 3;       // that a vertex remembers
constexpr double kReach2 = 48;  // cells² along the front: rows farther away weigh nothing
// Cosine between the way the front went at a flip and the normal: none counts below kOneWay, all above
// kSurely. Where the front is bent, neighbours go other ways.
constexpr double kOneWay = 0.6, kSurely = 0.9;
double one_way_at(double bend) {  // 1/cells
    return kOneWay - std::clamp(bend - 0.25, 0.0, 0.5);
}
constexpr double kLookAhead = 0.7;  // of a flip's direction: weight of where the front went on to

// A flip that is undone in the next step was none, if the front was farther away than this, cells. Nearer it
// may have turned there, and that tells much.
constexpr float kFarAway = 0.6f;

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

// Along an edge a front is taken to go at most this many times as fast as across: when a point coasts, when
// it is shown.
constexpr float kLeastShareCoasting = 0.15f, kLeastShareShown = 0.3f;

// What is shown is led toward what was fitted, at this share per step of 1/60 s, and toward the chord of its
// neighbours at that share in each of two sweeps.
constexpr double kLed = 0.39, kSmoothed = 0.4;
constexpr int kSweeps = 2;
// An edge far from any flip is fitted in every fourth step, but after so many seconds at most.
constexpr int kTurns = 4;
constexpr double kLongestTurn = 1 / 15.0;  // s

double square(double x) {
    return x * x;
}

// The vertices around an edge, told apart by the side of the front on which they lie.
class Neighbourhood {
  public:
    explicit Neighbourhood(std::size_t count) : seen_(count, 0), side_(count, 0) {}

    struct Vertex {
        int vertex;
        int side;  // 1: A's, -1: B's
    };
    struct Crossing {
        int a, b;  // ends of a cut edge on A's and on B's side
    };

    // Within kRings of either end over edges that are not cut. A vertex that both reach is the nearer one's.
    void gather(const Detector& detector, int edge) {
        const Mesh& mesh = detector.mesh();
        vertices.clear(), crossings.clear();
        ++round_;
        const auto add = [&](int vertex, int side) {
            seen_[vertex] = round_, side_[vertex] = static_cast<signed char>(side);
            vertices.push_back({vertex, side});
        };
        add(mesh.edge[edge].a, 1), add(mesh.edge[edge].b, -1);
        std::size_t first = 0;
        for (int ring = 0; ring <= kRings; ++ring) {
            const std::size_t last = vertices.size();
            for (; first < last; ++first) {
                const auto [vertex, side] = vertices[first];
                for (const auto& spoke : mesh.around(vertex)) {
                    if (detector.is_cut(spoke.edge)) {
                        if (side > 0) crossings.push_back({vertex, spoke.vertex});
                    } else if (ring < kRings && seen_[spoke.vertex] != round_) {
                        add(spoke.vertex, side);
                    }
                }
            }
        }
        std::erase_if(crossings, [&](const Crossing& c) { return seen_[c.b] != round_ || side_[c.b] > 0; });
    }

    std::vector<Vertex> vertices;
    std::vector<Crossing> crossings;

  private:
    std::vector<unsigned> seen_;
    std::vector<signed char> side_;
    unsigned round_ = 0;
};

struct Flip {
    double time = kNever;       // s
    glm::vec2 direction{0, 0};  // in which the front went, unit
    bool expected = true;       // the front was known to be near
};

// What is known of a front where it crosses an edge.
struct Piece {
    float f = 0.5f;          // as fitted
    glm::vec2 normal{1, 0};  // unit, from the side of vertex a to that of b
    float speed = 0;         // along the normal, m/s
    float bend = 0;          // of the front there: what its slope gains per metre along it, 1/m
    bool is_new = false;
};

// One fit. Everything in here is in cells and, after the window is chosen, in windows.
class Fit {
  public:
    explicit Fit(std::size_t vertices) : near_(vertices) {}

    Piece operator()(const Moment& now, const std::vector<std::array<Flip, kFlips>>& flips, int edge,
                     Piece piece) {
        const Mesh& mesh = now.detector.mesh();
        const auto [a, b] = mesh.edge[edge];
        cell_ = std::min(mesh.cell[a], mesh.cell[b]);
        normal_ = piece.normal;
        one_way_ = one_way_at(std::abs(double{piece.bend}) * cell_);
        middle_ = 0.5 * (glm::dvec2(mesh.position[a]) + glm::dvec2(mesh.position[b]));
        step_ = std::abs(piece.speed) * now.dt / cell_;
        near_.gather(now.detector, edge);
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

  private:
    struct Row {
        double s, D, age, weight;
    };
    struct Middle {  // of an edge that the front crosses now, which goes so far across
        double s, D, across, weight;
    };
    struct End {
        double s, D, side;
    };

    // Much like e^(−s²/16), but nothing from kReach2 on.
    static double weight_at(double s) {
        const double share = 1 - s * s / kReach2;
        return share * share * share;
    }

    // s and D.
    std::pair<double, double> place(const glm::vec2& position) const {
        const glm::dvec2 from = (glm::dvec2(position) - middle_) / cell_;
        return {-normal_.y * from.x + normal_.x * from.y, glm::dot(normal_, from)};
    }

    void collect_flips(const Moment& now, const std::vector<std::array<Flip, kFlips>>& flips) {
        rows_.clear();
        for (const auto& [vertex, side] : near_.vertices) {
            if (flips[vertex][0].time == kNever) continue;
            const auto [s, D] = place(now.detector.mesh().position[vertex]);
            if (s * s >= kReach2) continue;
            const double weight = weight_at(s);
            // The newest went toward B where it left a vertex on A's side; the one before it the other way.
            double way = side;
            for (const Flip& flip : flips[vertex]) {
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
    void collect_crossings(const Mesh& mesh) {
        middles_.clear(), ends_.clear();
        for (const auto& crossing : near_.crossings) {
            const auto [sa, Da] = place(mesh.position[crossing.a]);
            const auto [sb, Db] = place(mesh.position[crossing.b]);
            const double s = (sa + sb) / 2, D = (Da + Db) / 2;
            if (s * s + D * D > kNear2 || Db - Da < kLeastAcross) continue;
            middles_.push_back({s, D, Db - Da, weight_at(s)});
            ends_.push_back({sa, Da, 1}), ends_.push_back({sb, Db, -1});
        }
    }

    void choose_window(double dt) {
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

    void solve() {
        front_ = {};
        const double frame = std::min(kMostOfStep, square(step_) / 12);  // variance of when a flip was
        for (const Row& row : rows_) {
            const double z = row.age / window_;
            if (z > kWindowEnd) break;
            front_.add(row.s, -z, row.D,
                       row.weight / (square(kOfFlip) + frame + square(kOfModel * z * z * z)));
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
    double violation(const End& end) const { return end.side * (end.D - front_.at(end.s, 0)); }

    // A front that has just turned back does not fit a long window.
    bool misses_newest() const {
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
    void keep_sides() {
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

    Piece met(const Mesh& mesh, int edge, Piece piece) const {
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

    Neighbourhood near_;
    MovingQuadratic front_;
    std::vector<Row> rows_;
    std::vector<Middle> middles_;
    std::vector<End> ends_;
    glm::dvec2 middle_{0, 0}, normal_{1, 0};  // of the edge, m; across it, unit
    double one_way_ = 0;                      // cosine, below which a flip does not count
    double cell_ = 1;                         // m
    double step_ = 0;                         // what the front goes in a step, cells
    double window_ = 1, short_window_ = 1;    // s
};

class FitLocator : public Locator {
  public:
    explicit FitLocator(const Mesh& mesh)
        : mesh_(mesh), flips_(mesh.position.size()), near_flip_(mesh.position.size(), 0) {}

    void locate(const Moment& now, std::span<Point> points) override {
        remember_flips(now);
        carry_pieces(now, points);
        mark_near_flips(now);
        turns_ = static_cast<int>(std::clamp(std::round(kLongestTurn / now.dt), 1.0, double{kTurns}));
        while (fits_.size() < static_cast<std::size_t>(now.workers.threads()))
            fits_.emplace_back(mesh_.position.size());
        now.workers.each_member(static_cast<int>(points.size()), [&](int member, int first, int last) {
            for (int i = first; i < last; ++i) {
                if (is_due(points[i].edge, pieces_[i]))
                    pieces_[i] = fits_[member](now, flips_, points[i].edge, pieces_[i]);
                else
                    coast(points[i].edge, pieces_[i], now.dt);
            }
        });
        smooth(now, points);
        show(points, now.dt);
        last_began_ = now.time - now.dt;
        for (const int v : marked_) near_flip_[v] = 0;
        ++step_;
    }

  private:
    // Which way a front passed a vertex: as the edges say that it left, and toward those that it entered.
    void remember_flips(const Moment& now) {
        gone_.clear();
        for (const auto& gone : now.detector.vanished()) {
            const auto [a, b] = mesh_.edge[gone.edge];
            const Piece& piece = pieces_[gone.before];
            const float across = glm::dot(piece.normal, mesh_.along(gone.edge));
            gone_.push_back({a, -piece.normal, -piece.speed, piece.f * across});
            gone_.push_back({b, piece.normal, piece.speed, (1 - piece.f) * across});
        }
        std::stable_sort(gone_.begin(), gone_.end(),
                         [](const Gone& x, const Gone& y) { return x.vertex < y.vertex; });
        for (const int v : now.detector.flipped()) {
            auto& flips = flips_[v];
            if (!flips[0].expected && flips[0].time > last_began_) {
                std::rotate(flips.begin(), flips.begin() + 1, flips.end());
                flips.back() = {};
                continue;
            }
            const Gone came = came_to(v);
            const glm::vec2 ahead = ahead_of(now.detector, v);
            const glm::vec2 sum = unit(came.normal) + static_cast<float>(kLookAhead) * unit(ahead);
            std::rotate(flips.begin(), flips.end() - 1, flips.end());
            flips[0] = {now.time - now.dt / 2, unit(sum), came.away <= kFarAway * mesh_.cell[v]};
        }
    }

    static glm::vec2 unit(const glm::vec2& v) {
        const float length = glm::length(v);
        return length > 0 ? v / length : glm::vec2(0, 0);
    }

    // An edge that is no longer cut, as one of its ends sees it.
    struct Gone {
        int vertex;
        glm::vec2 normal;  // toward the vertex
        float speed;       // along it, m/s
        float away;        // how far it had to go along it, m
    };
    // The mean of what left its edges through a vertex, and the nearest; a normal of 0 where nothing did.
    Gone came_to(int vertex) const {
        Gone mean{vertex, {0, 0}, 0, std::numeric_limits<float>::infinity()};
        const auto [first, last] =
            std::equal_range(gone_.begin(), gone_.end(), mean,
                             [](const Gone& x, const Gone& y) { return x.vertex < y.vertex; });
        for (auto gone = first; gone != last; ++gone) {
            mean.normal += gone->normal, mean.speed += gone->speed;
            mean.away = std::min(mean.away, gone->away);
        }
        if (first != last) mean.speed /= static_cast<float>(last - first);
        return mean;
    }

    glm::vec2 ahead_of(const Detector& detector, int vertex) const {
        glm::vec2 cut(0, 0), all(0, 0);
        int count = 0;
        const auto around = mesh_.around(vertex);
        for (const auto& spoke : around) {
            const glm::vec2 u = unit(mesh_.position[spoke.vertex] - mesh_.position[vertex]);
            all += u;
            if (detector.is_cut(spoke.edge)) cut += u, ++count;
        }
        return cut - all * (static_cast<float>(count) / static_cast<float>(around.size()));
    }

    void carry_pieces(const Moment& now, std::span<const Point> points) {
        previous_.swap(pieces_);
        pieces_.clear();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const int before = now.detector.before()[i];
            pieces_.push_back(before >= 0 ? previous_[before] : begun(now, points[i].edge));
        }
    }

    // On an edge that a front has just entered it goes on as it came to the vertex between.
    Piece begun(const Moment& now, int edge) const {
        const auto [a, b] = mesh_.edge[edge];
        const glm::vec2 u = unit(mesh_.along(edge));
        for (const int v : {a, b}) {
            if (!now.detector.has_flipped(v)) continue;
            Gone came = came_to(v);
            came.normal = unit(came.normal);
            if (came.normal == glm::vec2(0, 0)) continue;
            const float way = glm::dot(came.normal, u) >= 0 ? 1.f : -1.f;
            return {v == a ? 0.f : 1.f, way * came.normal, way * came.speed, 0, true};
        }
        return {0.5f, u, 0, 0, true};
    }

    // Vertices within two rings of a flip.
    void mark_near_flips(const Moment& now) {
        marked_.assign(now.detector.flipped().begin(), now.detector.flipped().end());
        for (const int v : marked_) near_flip_[v] = 1;
        std::size_t first = 0;
        for (int ring = 0; ring < 2; ++ring)
            for (const std::size_t last = marked_.size(); first < last; ++first)
                for (const auto& spoke : mesh_.around(marked_[first]))
                    if (!std::exchange(near_flip_[spoke.vertex], std::uint8_t{1}))
                        marked_.push_back(spoke.vertex);
    }

    bool is_due(int edge, const Piece& piece) const {
        const auto [a, b] = mesh_.edge[edge];
        return piece.is_new || near_flip_[a] || near_flip_[b] || (edge + step_) % turns_ == 0 ||
               piece.f <= 0 || piece.f >= 1;
    }

    float advance(int edge, const Piece& piece, float least, double dt) const {
        const float across = glm::dot(piece.normal, mesh_.along(edge)) / mesh_.length[edge];
        return piece.speed * static_cast<float>(dt) / (std::max(least, across) * mesh_.length[edge]);
    }

    void coast(int edge, Piece& piece, double dt) const {
        piece.f = std::clamp(piece.f + advance(edge, piece, kLeastShareCoasting, dt), 0.f, 1.f);
    }

    // Jacobi sweeps toward the chord between the neighbours of a point: for the eye, since fed back into the
    // fit it would shrink circles.
    void smooth(const Moment& now, std::span<const Point> points) {
        smooth_.resize(points.size()), before_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) smooth_[i] = pieces_[i].f;
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            before_.swap(smooth_);
            for (std::size_t i = 0; i < points.size(); ++i)
                smooth_[i] = toward_chord(now.detector, points, static_cast<int>(i));
        }
    }

    float toward_chord(const Detector& detector, std::span<const Point> points, int i) const {
        std::array<glm::vec2, 2> neighbour;
        const int edge = points[i].edge;
        for (int side = 0; side < 2; ++side) {
            const int triangle = mesh_.edge_triangle[edge][side];
            if (triangle < 0) return before_[i];
            int count = 0;
            for (const int e : mesh_.triangle_edge[triangle])
                if (e != edge && detector.is_cut(e)) {
                    const float f = before_[detector.slot(e)];
                    neighbour[side] = mesh_.position[mesh_.edge[e].a] + f * mesh_.along(e);
                    ++count;
                }
            if (count != 1) return before_[i];
        }
        const auto cross = [](const glm::vec2& u, const glm::vec2& v) { return u.x * v.y - u.y * v.x; };
        const glm::vec2 chord = neighbour[1] - neighbour[0], along = mesh_.along(edge);
        const float across = cross(along, chord);
        if (std::abs(across) <= 0.05f * mesh_.length[edge] * glm::length(chord)) return before_[i];
        const float f = cross(neighbour[0] - mesh_.position[mesh_.edge[edge].a], chord) / across;
        return before_[i] + static_cast<float>(kSmoothed) * (std::clamp(f, 0.f, 1.f) - before_[i]);
    }

    void show(std::span<Point> points, double dt) {
        const auto led = static_cast<float>(1 - std::pow(1 - kLed, 60 * dt));
        for (std::size_t i = 0; i < points.size(); ++i) {
            Point& point = points[i];
            Piece& piece = pieces_[i];
            const float run = advance(point.edge, piece, kLeastShareShown, dt);
            point.speed = run / static_cast<float>(dt) * mesh_.length[point.edge];
            const float ahead = point.f + run;
            point.f = piece.is_new ? smooth_[i] : std::clamp(ahead + led * (smooth_[i] - ahead), 0.f, 1.f);
            piece.is_new = false;
        }
    }

    const Mesh& mesh_;
    int step_ = 0, turns_ = kTurns;
    double last_began_ = kNever;                   // when the step before began, s
    std::vector<std::array<Flip, kFlips>> flips_;  // of each vertex, the newest first
    std::vector<std::uint8_t> near_flip_;          // of each vertex, now
    std::vector<int> marked_;
    std::vector<Gone> gone_;
    std::vector<Piece> pieces_, previous_;  // of each point
    std::vector<float> smooth_, before_;
    std::vector<Fit> fits_;  // one for each thread
};

}  // namespace

std::unique_ptr<Locator> fit_locator(const Mesh& mesh) {
    return std::make_unique<FitLocator>(mesh);
}

}  // namespace sim::front
