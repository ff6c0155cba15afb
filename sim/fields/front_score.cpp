#include "sim/fields/front_score.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "sim/core/workers.h"

namespace sim::fields {
namespace {

// Multiples of the jump that cuts an edge. A fading front must be found above kSurely and not found below
// kHardly; in between the rule may hold it.
constexpr double kSurely = 1.1, kHardly = 0.6;

// A flow in mesh coordinates.
class Lie {
  public:
    Lie(const TestFlow& flow, const Trial& trial)
        : flow_(flow), shift_(trial.shift), cos_(std::cos(trial.turn)), sin_(std::sin(trial.turn)) {}

    glm::dvec2 place(const glm::dvec2& on_mesh) const {
        const glm::dvec2 from = on_mesh - kMiddle;
        return kMiddle + shift_ + glm::dvec2(cos_ * from.x - sin_ * from.y, sin_ * from.x + cos_ * from.y);
    }
    glm::vec2 velocity(const glm::dvec2& on_mesh, double time) const {
        const glm::dvec2 v(flow_.velocity(place(on_mesh), time));
        return {cos_ * v.x + sin_ * v.y, cos_ * v.y - sin_ * v.x};
    }
    int region(const glm::dvec2& on_mesh, double time) const { return flow_.region(place(on_mesh), time); }
    bool parts(const glm::dvec2& a, const glm::dvec2& b, double time, double jump) const {
        return flow_.parts(place(a), place(b), time, jump);
    }
    double distance(const glm::dvec2& on_mesh, double time) const {
        return flow_.distance(place(on_mesh), time);
    }

  private:
    static constexpr glm::dvec2 kMiddle{0.5, 0.5};
    const TestFlow& flow_;
    glm::dvec2 shift_;
    double cos_, sin_;
};

// Finds f where the front crosses an edge whose ends are in two regions.
float crossing_of(const Lie& lie, const front::Mesh& mesh, int edge, double time) {
    const glm::dvec2 a(mesh.position[mesh.edge[edge].a]), along(mesh.along(edge));
    const int region = lie.region(a, time);
    double low = 0, high = 1;
    for (int round = 0; round < 24; ++round) {
        const double middle = (low + high) / 2;
        (lie.region(a + middle * along, time) == region ? low : high) = middle;
    }
    return static_cast<float>((low + high) / 2);
}

// Counts points that break continuity: a point that stays but moves too far, a new one that does not begin at
// the vertex that the front passed, and a vanished one that did not end there.
class Jumps {
  public:
    Jumps(const front::Mesh& mesh, float limit) : mesh_(mesh), limit_(limit) {}

    // `at[i]`: f on the edge detector.cut()[i].
    int count(const front::Detector& detector, const std::vector<float>& at) {
        int jumps = 0;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const int edge = detector.cut()[i], before = detector.before()[i];
            const float moved =
                before < 0 ? from_flip(detector, edge, at[i]) : std::abs(at[i] - before_[before]);
            jumps += moved * mesh_.length[edge] > limit_;
        }
        for (const auto& gone : detector.vanished())
            jumps += from_flip(detector, gone.edge, before_[gone.before]) * mesh_.length[gone.edge] > limit_;
        before_ = at;
        return jumps;
    }

  private:
    // Distance from the nearest flipped end, as a share of the edge; 0 if neither end flipped.
    float from_flip(const front::Detector& detector, int edge, float f) const {
        const auto [a, b] = mesh_.edge[edge];
        const bool from_a = detector.has_flipped(a), from_b = detector.has_flipped(b);
        if (from_a && from_b) return std::min(f, 1 - f);
        return from_a ? f : from_b ? 1 - f : 0;
    }

    const front::Mesh& mesh_;
    float limit_;  // m
    std::vector<float> before_;
};

}  // namespace

FrontScore score(const front::Mesh& mesh, const front::Rule& rule, front::PointSource source,
                 const TestFlow& flow, const Trial& trial) {
    const Lie lie(flow, trial);
    const double dt = 1 / trial.steps_per_second;
    const auto limit = static_cast<float>(0.25 * trial.cell + flow.greatest_front_speed() * dt);
    Workers workers(1);
    front::Tracker tracker(mesh, rule, source, trial.hold);
    Jumps jumps(mesh, limit), true_jumps(mesh, limit);
    std::mt19937 random(1);
    std::normal_distribution<float> noise;  // mean 0, standard deviation 1
    std::uniform_real_distribution<double> share;

    std::vector<glm::vec2> velocity(mesh.position.size());
    std::vector<int> region(mesh.position.size());
    std::vector<double> distances;
    FrontScore score;
    double crossed = 0, cut = 0, steps = 0;
    for (int step = 0; step < std::lround(trial.seconds / dt); ++step) {
        const double time = (step + 1) * dt;
        const double front_time = flow.front_speed * time;
        for (std::size_t v = 0; v < velocity.size(); ++v) {
            const glm::dvec2 at(mesh.position[v]);
            velocity[v] = lie.velocity(at, front_time);
            region[v] = lie.region(at, front_time);
            if (trial.noise > 0)
                velocity[v] += static_cast<float>(trial.noise) * glm::vec2(noise(random), noise(random));
            if (trial.salt > 0 && share(random) < trial.salt) velocity[v] = -velocity[v];
        }
        tracker.advance({velocity, {}}, dt, workers);

        std::vector<float> shown, exact;
        for (const front::Point& point : tracker.points()) {
            const auto [a, b] = mesh.edge[point.edge];
            shown.push_back(point.f);
            exact.push_back(region[a] == region[b] ? point.f
                                                   : crossing_of(lie, mesh, point.edge, front_time));
        }
        const int jumped = jumps.count(tracker.detector(), shown);
        const int truly = true_jumps.count(tracker.detector(), exact);
        if (time <= trial.unscored + dt / 2) continue;

        ++steps, score.jumps += jumped, score.true_jumps += truly;
        for (int e = 0; e < mesh.edges(); ++e) {
            const auto [a, b] = mesh.edge[e];
            const auto parts = [&, from = a, to = b](double times) {
                return region[from] != region[to] &&
                       lie.parts(glm::dvec2(mesh.position[from]), glm::dvec2(mesh.position[to]), front_time,
                                 times * rule.jump);
            };
            const bool is_crossed = parts(kSurely), is_cut = tracker.detector().is_cut(e);
            crossed += is_crossed, cut += is_cut;
            score.missed += is_crossed && !is_cut, score.false_cuts += is_cut && !parts(kHardly);
        }
        for (const front::Point& point : tracker.points())
            if (region[mesh.edge[point.edge].a] != region[mesh.edge[point.edge].b])
                distances.push_back(lie.distance(glm::dvec2(tracker.position(point)), front_time) /
                                    trial.cell);
    }
    double sum = 0;
    for (const double distance : distances) sum += distance * distance;
    if (!distances.empty()) {
        score.rms = std::sqrt(sum / static_cast<double>(distances.size()));
        const auto p95 = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 95 / 100);
        std::nth_element(distances.begin(), p95, distances.end());
        score.p95 = *p95;
    }
    score.missed /= std::max(crossed, 1.0), score.false_cuts /= std::max(cut, 1.0);
    score.jumps /= steps * dt, score.true_jumps /= steps * dt;
    score.points = static_cast<double>(distances.size()) / steps;
    return score;
}

}  // namespace sim::fields
