#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "sim/core/workers.h"
#include "sim/front/point_estimator.h"
#include "sim/front/space_time_fit.h"

// A vertex flips when a front passes it: its velocity jumps. The flips near a cut edge, with their times,
// sides and directions, are samples of the surface that the front sweeps in space and time. A small quadratic
// piece of it (moving_quadratic.h) is fitted to them (space_time_fit.h) and intersected with the edge at the
// present time.
//
//           A ── A ── A        A, B: vertices reached from either end of the edge without crossing the
//            \  / \  / \       front. The last flips of each are known: when the front passed, and in
//     ········\/···\/···\····  which direction. On A's side it went along the normal n, on B's against
//              B ── B ── B     it, or it has come back since.

namespace sim::front {
namespace {

constexpr double kLookAhead = 0.7;  // weight in a flip's direction of the edges that the front enters

// A flip that is undone in the next step is discarded if the front was farther away than this, cells. Nearer
// to the vertex the front may have turned back, which is valuable information.
constexpr float kFarAway = 0.6f;

// Least cosine between edge and normal, which limits a front's speed along the edge: for coasting points, and
// for shown ones.
constexpr float kLeastShareCoasting = 0.15f, kLeastShareShown = 0.3f;

// A shown point moves toward the fitted one by the share kLed per 1/60 s, or by kLedAtFirst after a front has
// passed a vertex. The fitted one first moves by kSmoothed toward the chord of its neighbours, in each of two
// sweeps.
constexpr double kLed = 0.39, kLedAtFirst = 0.5, kSmoothed = 0.4;
constexpr int kSweeps = 2;
// An edge far from any flip is fitted in every kTurns-th step, but at least every kLongestTurn seconds.
constexpr int kTurns = 4;
constexpr double kLongestTurn = 1 / 15.0;  // s

class FitLocator : public PointEstimator {
  public:
    explicit FitLocator(const Mesh& mesh)
        : mesh_(mesh),
          flips_(mesh.position.size()),
          near_flip_(mesh.position.size(), 0),
          cuts_(mesh.position.size(), 0) {}

    void locate(const TrackedMoment& now, std::span<Point> points) override {
        remember_flips(now);
        carry_pieces(now, points);
        count_cuts(now);
        mark_near_flips(now);
        turns_ = static_cast<int>(std::clamp(std::round(kLongestTurn / now.dt), 1.0, double{kTurns}));
        while (fits_.size() < static_cast<std::size_t>(now.workers.threads()))
            fits_.emplace_back(mesh_.position.size(), fit::kernels_for(best_instruction_set()));
        for (SpaceTimeFit& fit : fits_) fit.begin_moment();
        now.workers.each_member(static_cast<int>(points.size()), [&](int member, int first, int last) {
            for (int i = first; i < last; ++i) {
                if (is_due(points[i].edge, pieces_[i]))
                    pieces_[i] = fits_[member](now, flips_, cuts_, points[i].edge, pieces_[i]);
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
    // Records in which direction a front passed a vertex: from the edges that it left toward those that it
    // entered.
    void remember_flips(const TrackedMoment& now) {
        gone_.clear();
        for (const auto& gone : now.detector.vanished()) {
            const auto [a, b] = mesh_.edge[gone.edge];
            const FrontFit& piece = pieces_[gone.before];
            const float across = glm::dot(piece.normal, mesh_.along(gone.edge));
            const float shown = now.previous[gone.before].f;
            gone_.push_back({a, -piece.normal, -piece.speed, piece.f * across, shown * across});
            gone_.push_back({b, piece.normal, piece.speed, (1 - piece.f) * across, (1 - shown) * across});
        }
        std::stable_sort(gone_.begin(), gone_.end(),
                         [](const Gone& x, const Gone& y) { return x.vertex < y.vertex; });
        for (const int v : now.detector.flipped()) {
            Flips& flips = flips_[v];
            if (!flips.expected[0] && flips.last[0].time > last_began_) {
                std::rotate(flips.last.begin(), flips.last.begin() + 1, flips.last.end());
                std::rotate(flips.expected.begin(), flips.expected.begin() + 1, flips.expected.end());
                flips.last.back() = {}, flips.expected.back() = true;
                continue;
            }
            const Gone came = came_to(v);
            const glm::vec2 ahead = ahead_of(now.detector, v);
            const glm::vec2 sum = unit(came.normal) + static_cast<float>(kLookAhead) * unit(ahead);
            std::rotate(flips.last.begin(), flips.last.end() - 1, flips.last.end());
            std::rotate(flips.expected.begin(), flips.expected.end() - 1, flips.expected.end());
            flips.last[0] = {now.time - now.dt / 2, unit(sum)};
            flips.expected[0] = came.away <= kFarAway * mesh_.cell[v];
        }
    }

    static glm::vec2 unit(const glm::vec2& v) {
        const float length = glm::length(v);
        return length > 0 ? v / length : glm::vec2(0, 0);
    }

    // An edge that is no longer cut, seen from one of its ends.
    struct Gone {
        int vertex;
        glm::vec2 normal;  // toward the vertex
        float speed;       // along it, m/s
        float away;        // distance left to the vertex along it, m
        float left;        // the same from the shown point, m
    };
    // Mean of the pieces that left their edges through a vertex, and the least distance; the normal is 0 if
    // there are none.
    Gone came_to(int vertex) const {
        Gone mean{vertex, {0, 0}, 0, std::numeric_limits<float>::infinity(), 0};
        const auto [first, last] =
            std::equal_range(gone_.begin(), gone_.end(), mean,
                             [](const Gone& x, const Gone& y) { return x.vertex < y.vertex; });
        for (auto gone = first; gone != last; ++gone) {
            mean.normal += gone->normal, mean.speed += gone->speed, mean.left += gone->left;
            mean.away = std::min(mean.away, gone->away);
        }
        if (const auto count = static_cast<float>(last - first); count > 0)
            mean.speed /= count, mean.left /= count;
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

    void carry_pieces(const TrackedMoment& now, std::span<const Point> points) {
        previous_.swap(pieces_);
        pieces_.clear();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const int before = now.detector.before()[i];
            pieces_.push_back(before >= 0 ? previous_[before] : begun(now, points[i].edge));
        }
    }

    // Starts a piece on an edge that a front has just entered: it continues from the common vertex.
    FrontFit begun(const TrackedMoment& now, int edge) const {
        const auto [a, b] = mesh_.edge[edge];
        const glm::vec2 u = unit(mesh_.along(edge));
        for (const int v : {a, b}) {
            if (!now.detector.has_flipped(v)) continue;
            Gone came = came_to(v);
            came.normal = unit(came.normal);
            if (came.normal == glm::vec2(0, 0)) continue;
            const float way = glm::dot(came.normal, u) >= 0 ? 1.f : -1.f;
            const float in = beyond(came, edge, now.dt);
            return {.f = v == a ? 0.f : 1.f,
                    .normal = way * came.normal,
                    .speed = way * came.speed,
                    .entered = v == a ? in : 1 - in,
                    .is_new = true};
        }
        return {.normal = u, .is_new = true};
    }

    // Share of the edge that the front has covered since it passed the vertex in this step.
    float beyond(const Gone& came, int edge, double dt) const {
        const float run = std::max(0.f, came.speed * static_cast<float>(dt));
        const float across = std::abs(glm::dot(came.normal, mesh_.along(edge)));
        const float way = std::max(across, kLeastShareShown * mesh_.length[edge]);
        return std::min(std::clamp(run - came.left, 0.f, run) / way, 1.f);
    }

    void count_cuts(const TrackedMoment& now) {
        for (const auto& gone : now.detector.vanished())
            --cuts_[mesh_.edge[gone.edge].a], --cuts_[mesh_.edge[gone.edge].b];
        for (std::size_t i = 0; i < now.detector.cut().size(); ++i)
            if (now.detector.before()[i] < 0) {
                const auto [a, b] = mesh_.edge[now.detector.cut()[i]];
                ++cuts_[a], ++cuts_[b];
            }
    }

    // Marks vertices within two rings of a flip.
    void mark_near_flips(const TrackedMoment& now) {
        marked_.assign(now.detector.flipped().begin(), now.detector.flipped().end());
        for (const int v : marked_) near_flip_[v] = 1;
        std::size_t first = 0;
        for (int ring = 0; ring < 2; ++ring)
            for (const std::size_t last = marked_.size(); first < last; ++first)
                for (const auto& spoke : mesh_.around(marked_[first]))
                    if (!std::exchange(near_flip_[spoke.vertex], std::uint8_t{1}))
                        marked_.push_back(spoke.vertex);
    }

    bool is_due(int edge, const FrontFit& piece) const {
        const auto [a, b] = mesh_.edge[edge];
        return piece.is_new || near_flip_[a] || near_flip_[b] || (edge + step_) % turns_ == 0 ||
               piece.f <= 0 || piece.f >= 1;
    }

    float advance(int edge, const FrontFit& piece, float least, double dt) const {
        const float across = glm::dot(piece.normal, mesh_.along(edge)) / mesh_.length[edge];
        return piece.speed * static_cast<float>(dt) / (std::max(least, across) * mesh_.length[edge]);
    }

    void coast(int edge, FrontFit& piece, double dt) const {
        piece.f = std::clamp(piece.f + advance(edge, piece, kLeastShareCoasting, dt), 0.f, 1.f);
    }

    // Jacobi sweeps toward the chord between a point's neighbours. For display only: fed back into the fit
    // they would shrink circles.
    void smooth(const TrackedMoment& now, std::span<const Point> points) {
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
        const auto share = [&](double of) { return static_cast<float>(1 - std::pow(1 - of, 60 * dt)); };
        const float led = share(kLed), led_at_first = share(kLedAtFirst);
        for (std::size_t i = 0; i < points.size(); ++i) {
            Point& point = points[i];
            FrontFit& piece = pieces_[i];
            const float run = advance(point.edge, piece, kLeastShareShown, dt);
            point.speed = run / static_cast<float>(dt) * mesh_.length[point.edge];
            const bool goes_on = !piece.is_new;
            if (goes_on || piece.entered >= 0) {
                const float ahead = goes_on ? point.f + run : piece.entered;
                point.f = std::clamp(ahead + (goes_on ? led : led_at_first) * (smooth_[i] - ahead), 0.f, 1.f);
            } else {
                point.f = smooth_[i];
            }
            piece.is_new = false;
        }
    }

    const Mesh& mesh_;
    int step_ = 0, turns_ = kTurns;
    double last_began_ = kNever;           // start of the previous step, s
    std::vector<Flips> flips_;             // per vertex, newest first
    std::vector<std::uint8_t> near_flip_;  // per vertex, now
    std::vector<int> cuts_;                // per vertex: number of cut edges
    std::vector<int> marked_;
    std::vector<Gone> gone_;
    std::vector<FrontFit> pieces_, previous_;  // per point
    std::vector<float> smooth_, before_;
    std::vector<SpaceTimeFit> fits_;  // one for each thread
};

}  // namespace

std::unique_ptr<PointEstimator> fit_estimator(const Mesh& mesh) {
    return std::make_unique<FitLocator>(mesh);
}

}  // namespace sim::front
