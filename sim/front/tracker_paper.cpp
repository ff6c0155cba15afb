#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "sim/front/hold.h"
#include "sim/front/least_squares.h"
#include "sim/front/point_estimator.h"

// Section 3 of the paper. A discontinuity front moves at constant speed while it is on an edge. When it
// leaves edges (α, j) through vertex j, it arrives there at time T_j; it had entered them at x_α at time T_α.
// The gradient r of its arrival time, its slowness, is the least-squares solution of
//
//     (x_j − x_α) · r = T_j − T_α          for all edges (α, j) that it leaves            equations (3) – (6)
//
// If the front was first seen on an edge, the middle of that edge takes the place of x_α. On the edges (j, β)
// that it enters, its speed is
//
//     w = 1 / (r · u)                      u: unit vector from j to β                     equation (7)
//
// Unlike equation (3), this has no pole if a front arrives everywhere at once.

namespace sim::front {
namespace {

// r · u is at least this share of |r|, because a front is taken to move along an edge at most four times as
// fast as across. Rounding may otherwise let it enter edges that it never crosses.
constexpr double kLeastShare = 0.25;

class PaperLocator : public PointEstimator {
  public:
    explicit PaperLocator(const Mesh& mesh)
        : mesh_(mesh),
          passed_(mesh.position.size(), kNever),
          slowness_(mesh.position.size()),
          arrived_(mesh.position.size(), 0),
          entered_(mesh.position.size(), 0) {}

    void locate(const TrackedMoment& now, std::span<Point> points) override {
        crossing_ = now.time - now.dt / 2;  // halfway between the previous moment and this one
        mark_entered(now, 1);
        find_slowness(now);
        carry_origins(now);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (now.detector.before()[i] < 0)
                begin(points[i], origins_[i], now);
            else
                go_on(points[i], origins_[i], now);
        }
        mark_entered(now, 0);
        for (const int v : arrivals_) arrived_[v] = 0;
        for (const int v : now.detector.flipped()) passed_[v] = passed(now, v);
    }

  private:
    // Where and when a front entered an edge.
    struct Origin {
        int vertex = -1;  // entry vertex; -1: first seen at `f`
        float f = 0.5f;
        double time = 0;  // s
    };

    // When the front really passed a vertex that flips now, s.
    double passed(const TrackedMoment& now, int vertex) const {
        return now.hold && now.detector.has_flipped(vertex) ? now.hold->passed(vertex) : crossing_;
    }

    // Marks vertices from which a front enters an edge now.
    void mark_entered(const TrackedMoment& now, std::uint8_t mark) {
        for (std::size_t i = 0; i < now.detector.cut().size(); ++i)
            if (now.detector.before()[i] < 0) {
                const auto [a, b] = mesh_.edge[now.detector.cut()[i]];
                entered_[a] = entered_[b] = mark;
            }
    }

    // The vertex through which a front left an edge, -1 if unknown: the one from which it enters others. If
    // that holds for both ends or neither, the one that it passed or was moving toward.
    int exit_of(const TrackedMoment& now, const Detector::Gone& gone) const {
        const auto [a, b] = mesh_.edge[gone.edge];
        if (entered_[a] != entered_[b]) return entered_[a] ? a : b;
        const bool at_a = now.detector.has_flipped(a), at_b = now.detector.has_flipped(b);
        if (at_a != at_b) return at_a ? a : b;
        const float speed = now.previous[gone.before].speed;
        return speed > 0 ? b : speed < 0 ? a : -1;
    }

    void find_slowness(const TrackedMoment& now) {
        exits_.clear();
        for (const Detector::Gone& gone : now.detector.vanished())
            if (const int vertex = exit_of(now, gone); vertex >= 0) exits_.push_back({vertex, gone});
        std::stable_sort(exits_.begin(), exits_.end(),
                         [](const Exit& x, const Exit& y) { return x.vertex < y.vertex; });
        arrivals_.clear();
        for (auto exit = exits_.begin(); exit != exits_.end();) {
            const int vertex = exit->vertex;
            LeastSquares rows;
            bool came_back = false;
            for (; exit != exits_.end() && exit->vertex == vertex; ++exit) {
                const Origin& origin = origins_[exit->gone.before];
                if (origin.vertex == vertex) {
                    came_back = true;
                    continue;
                }
                rows.add(way_from(origin, exit->gone.edge, vertex),
                         std::max(passed(now, vertex) - origin.time, now.dt / 2));
            }
            if (rows.xx + rows.yy > 0)
                slowness_[vertex] = rows.solve();
            else if (came_back && is_newest(vertex))
                slowness_[vertex] = -slowness_[vertex];  // constant deceleration, equation (8)
            else
                continue;
            arrived_[vertex] = 1;
            arrivals_.push_back(vertex);
        }
    }

    glm::dvec2 way_from(const Origin& origin, int edge, int vertex) const {
        const glm::dvec2 a(mesh_.position[mesh_.edge[edge].a]), along(mesh_.along(edge));
        const glm::dvec2 start =
            origin.vertex >= 0 ? glm::dvec2(mesh_.position[origin.vertex]) : a + double{origin.f} * along;
        return glm::dvec2(mesh_.position[vertex]) - start;
    }

    // True if a front has passed none of a vertex's neighbours since it passed the vertex.
    bool is_newest(int vertex) const {
        const auto around = mesh_.around(vertex);
        return passed_[vertex] > kNever && std::all_of(around.begin(), around.end(), [&](const auto& spoke) {
                   return passed_[spoke.vertex] <= passed_[vertex];
               });
    }

    void carry_origins(const TrackedMoment& now) {
        previous_.swap(origins_);
        origins_.clear();
        for (const int before : now.detector.before())
            origins_.push_back(before >= 0 ? previous_[before] : Origin{-1, 0.5f, crossing_});
    }

    void begin(Point& point, Origin& origin, const TrackedMoment& now) {
        const auto [a, b] = mesh_.edge[point.edge];
        const glm::dvec2 unit = glm::dvec2(mesh_.along(point.edge)) / double{mesh_.length[point.edge]};
        // Slowness along the edge from either end, s/m. Of two ends the slower one is used.
        const auto slowness_from = [&](int vertex, const glm::dvec2& u) {
            const glm::dvec2 r = slowness_[vertex];
            return arrived_[vertex] ? std::max(glm::dot(r, u), kLeastShare * glm::length(r)) : 0;
        };
        const double from_a = slowness_from(a, unit), from_b = slowness_from(b, -unit);
        if (from_a == 0 && from_b == 0) return;  // first seen here: it stays in the middle, at rest
        const bool at_a = from_a >= from_b;
        const double speed = 1 / std::max(from_a, from_b);
        const double run = std::min(speed * now.dt / 2 / mesh_.length[point.edge], 1.0);
        origin = {at_a ? a : b, at_a ? 0.f : 1.f, passed(now, at_a ? a : b)};
        point.f = static_cast<float>(at_a ? run : 1 - run);
        point.speed = static_cast<float>(at_a ? speed : -speed);
    }

    // Moves a point; at the end of its edge it waits.
    void go_on(Point& point, const Origin& origin, const TrackedMoment& now) const {
        const double length = mesh_.length[point.edge];
        const double run = now.hold ? hurry(point, origin, now) : point.speed * now.dt;
        point.f = static_cast<float>(std::clamp(point.f + run / length, 0.0, 1.0));
    }

    // Step of a possibly late point, m: the front has left its edge, or the point entered the edge after the
    // front.
    double hurry(const Point& point, const Origin& origin, const TrackedMoment& now) const {
        const double length = mesh_.length[point.edge], most = now.hold->hurried(point, now.dt);
        if (const int end = now.hold->left_through(point.edge); end >= 0) {
            const double way = ((end == mesh_.edge[point.edge].a ? 0 : 1) - point.f) * length;
            const double step = std::max(most, std::abs(way) / now.hold->steps_left(end));
            return std::clamp(way, -step, step);
        }
        const double run = point.speed * now.dt;
        if (origin.vertex < 0) return run;
        const double behind = (origin.f - point.f) * length + (now.time - origin.time) * point.speed;
        return std::copysign(std::clamp(std::copysign(1.0, run) * behind, std::abs(run), most), run);
    }

    struct Exit {
        int vertex;
        Detector::Gone gone;
    };

    const Mesh& mesh_;
    double crossing_ = 0;                          // time of the changes seen now, s
    std::vector<double> passed_;                   // per vertex: last time that a front passed it, s
    std::vector<glm::dvec2> slowness_;             // per vertex: slowness on arrival, s/m
    std::vector<std::uint8_t> arrived_, entered_;  // per vertex: in this step
    std::vector<int> arrivals_;
    std::vector<Exit> exits_;
    std::vector<Origin> origins_, previous_;  // per point
};

}  // namespace

std::unique_ptr<PointEstimator> paper_estimator(const Mesh& mesh) {
    return std::make_unique<PaperLocator>(mesh);
}

}  // namespace sim::front
