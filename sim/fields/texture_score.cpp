#include "sim/fields/texture_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "sim/core/check.h"
#include "sim/core/workers.h"
#include "sim/front/gradient.h"

namespace sim::fields {
namespace {

using front::CutTriangle;
using front::TextureLayers;

constexpr int kSheet = 1;         // second phase of the shortest latency: renewed at whole periods
constexpr double kNearCells = 2;  // of a front
constexpr int kNearRings = 2;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// A piece of the cut mesh with its coordinates.
struct FrontFit {
    std::array<glm::dvec2, 3> at, coordinates;

    double area() const { return std::abs(cross(at[1] - at[0], at[2] - at[0])) / 2; }
    glm::dvec2 middle() const { return (at[0] + at[1] + at[2]) / 3.0; }

    // Ratio of the greatest to the least singular value of the gradient of the coordinates.
    double stretch() const {
        const glm::dmat2 ways(at[1] - at[0], at[2] - at[0]);
        const glm::dmat2 g =
            glm::dmat2(coordinates[1] - coordinates[0], coordinates[2] - coordinates[0]) * glm::inverse(ways);
        const auto [greatest, least] = front::singular_values(g);
        return greatest / std::max(std::abs(least), 0.5e-9);
    }

    // Coordinates at a place, if it is in the piece.
    std::optional<glm::dvec2> coordinates_at(const glm::dvec2& place) const {
        const glm::dvec2 u = at[1] - at[0], w = at[2] - at[0], way = place - at[0];
        const double whole = cross(u, w), b = cross(way, w) / whole, c = cross(u, way) / whole;
        constexpr double kRounding = 1e-6;
        if (!(std::min({b, c, 1 - b - c}) >= -kRounding)) return std::nullopt;
        return (1 - b - c) * coordinates[0] + b * coordinates[1] + c * coordinates[2];
    }
};

// The drawn pieces of a triangle. Pieces without area are left out.
std::vector<FrontFit> pieces_of(const front::Tracker& tracker, const TextureLayers& layers, int triangle) {
    std::vector<FrontFit> pieces;
    for (const CutTriangle& part : cut_triangle(tracker, triangle)) {
        FrontFit piece;
        for (int k = 0; k < 3; ++k) {
            piece.at[k] = glm::dvec2(part[k].position);
            piece.coordinates[k] = piece.at[k] + glm::dvec2(layers.offset(part[k], kSheet));
        }
        if (piece.area() > 1e-6 * tracker.mesh().cell[0] * tracker.mesh().cell[0]) pieces.push_back(piece);
    }
    return pieces;
}

// Percentiles of weighted values ≥ 1, in steps of 1/500 of a natural logarithm.
class Histogram {
  public:
    void add(double value, double weight) {
        const auto bin = static_cast<std::size_t>(std::clamp(std::log(value) * kBins, 0.0, kLast));
        if (bin >= weight_.size()) weight_.resize(bin + 1);
        weight_[bin] += weight;
        all_ += weight;
    }
    double percentile(double share) const {
        double sum = 0;
        for (std::size_t bin = 0; bin < weight_.size(); ++bin)
            if ((sum += weight_[bin]) >= share * all_)
                return std::exp((static_cast<double>(bin) + 0.5) / kBins);
        return 1;
    }

  private:
    static constexpr double kBins = 500, kLast = 20000;
    std::vector<double> weight_;
    double all_ = 0;
};

// Ratio of two root mean squares.
struct Ratio {
    double above = 0, below = 0;
    double value() const { return below > 0 ? std::sqrt(above / below) : 0; }
};

// Marks vertices within `rings` rings of a cut edge.
std::vector<char> beside(const front::Detector& detector, int rings) {
    const front::Mesh& mesh = detector.mesh();
    std::vector<char> near(mesh.position.size(), 0);
    for (const int e : detector.cut()) near[mesh.edge[e].a] = near[mesh.edge[e].b] = 1;
    for (int ring = 1; ring < rings; ++ring) {
        const std::vector<char> inner = near;
        for (const auto& [a, b] : mesh.edge)
            if (inner[a] || inner[b]) near[a] = near[b] = 1;
    }
    return near;
}

// A particle that travels with the flow.
struct Particle {
    glm::dvec2 at, coordinates;
    int region;
    bool counts = true;  // no front has come near and it has not left the square
};

class Texture {
  public:
    Texture(const front::Mesh& mesh, const front::Rule& rule, front::PointSource source, const TestFlow& flow,
            Cutting cutting, const TextureTrial& trial)
        : mesh_(mesh),
          flow_(flow),
          trial_(trial),
          tracker_(mesh, cutting == Cutting::kNone ? front::uncut_rule() : rule, source),
          layers_(mesh,
                  {.shortest_s = static_cast<float>(trial.reset_s), .reseed = cutting == Cutting::kReseeded}),
          velocity_(mesh.position.size()),
          at_rest_(mesh.position.size()) {}

    TextureScore run() {
        CHECK(mesh_.columns > 0);
        const double dt = 1 / trial_.steps_per_second;
        for (int step = 1; step <= std::lround(trial_.seconds / dt); ++step) {
            const double time = step * dt, age = layers_.age_s(kSheet);
            for (int v = 0; v < mesh_.vertices(); ++v)
                velocity_[v] = glm::vec2(velocity(glm::dvec2(mesh_.position[v]), time));
            before_.assign(layers_.offsets().begin(), layers_.offsets().end());
            tracker_.advance({velocity_, {}}, dt, workers_);
            layers_.advance(tracker_, trial_.frozen ? at_rest_ : velocity_, dt, workers_);
            const bool renewed = layers_.age_s(kSheet) < age;
            const bool counts = time > trial_.unscored + dt / 2;
            if (counts && !renewed) {
                measure_slip(dt);
                measure_stretch(time);
            }
            follow(time, dt, renewed, counts);
        }
        return result();
    }

  private:
    double front_time(double time) const { return flow_.front_speed * time; }
    glm::dvec2 velocity(const glm::dvec2& x, double time) const {
        glm::dvec2 v(flow_.velocity(x, front_time(time)));
        if (trial_.smooth_alone)
            v -= glm::dvec2(flow_.of_region(flow_.region(x, front_time(time)), front_time(time)));
        return v;
    }

    void measure_slip(double dt) {
        const std::vector<char> near = beside(tracker_.detector(), kNearRings);
        for (int v = 0; v < mesh_.vertices(); ++v) {
            if (tracker_.detector().has_flipped(v)) continue;
            TextureLayers::Gradients gradient{};
            front::find_gradients<TextureLayers::kSheets>(tracker_.detector(), v, layers_.offsets(),
                                                          gradient);
            const glm::vec2 change =
                (layers_.offsets()[v][kSheet] - before_[v][kSheet]) / static_cast<float>(dt);
            const glm::vec2 slip = change + (glm::mat2(1) + gradient[kSheet]) * velocity_[v];
            Ratio& ratio = near[v] ? slip_near_ : slip_;
            ratio.above += glm::dot(slip, slip), ratio.below += glm::dot(velocity_[v], velocity_[v]);
        }
    }

    void measure_stretch(double time) {
        for (int t = 0; t < static_cast<int>(mesh_.triangle.size()); ++t)
            for (const FrontFit& piece : pieces_of(tracker_, layers_, t)) {
                const double stretch = piece.stretch(), area = piece.area();
                area_ += area, stretched_ += stretch > 2 ? area : 0;
                if (flow_.distance(piece.middle(), front_time(time)) < kNearCells * mesh_.cell[0])
                    near_.add(stretch, area);
            }
    }

    void follow(double time, double dt, bool renewed, bool counts) {
        for (Particle& p : particles_) {
            const glm::dvec2 halfway = p.at + dt / 2 * velocity(p.at, time);
            p.at += dt * velocity(halfway, time);
            p.counts = p.counts && is_inside(p.at) && flow_.region(p.at, front_time(time)) == p.region &&
                       flow_.distance(p.at, front_time(time)) > mesh_.cell[0] / 2;
        }
        if (!renewed) {
            for (Particle& p : particles_)
                if (p.counts) latest(p);
            return;
        }
        if (counts)
            for (const Particle& p : particles_)
                if (p.counts) drift_.add(1 + p_drift(p) / mesh_.cell[0], 1);
        particles_.clear();
        for (const glm::vec2& x : mesh_.position) {
            const glm::dvec2 at = glm::dvec2(x) + 0.37 * static_cast<double>(mesh_.cell[0]);
            if (!is_inside(at)) continue;
            Particle p{at, {}, flow_.region(at, front_time(time))};
            if (const auto c = coordinates_at(at)) {
                p.coordinates = *c;
                particles_.push_back(p);
                last_.resize(particles_.size());
                last_.back() = *c;
            }
        }
    }

    // Keeps the coordinates at a particle, because a renewal overwrites them.
    void latest(const Particle& p) {
        if (const auto c = coordinates_at(p.at)) last_[&p - particles_.data()] = *c;
    }
    double p_drift(const Particle& p) const {
        return glm::length(last_[&p - particles_.data()] - p.coordinates);
    }

    bool is_inside(const glm::dvec2& x) const { return std::min(x.x, x.y) > 0 && std::max(x.x, x.y) < 1; }

    std::optional<glm::dvec2> coordinates_at(const glm::dvec2& x) const {
        const auto cell = static_cast<double>(mesh_.cell[0]);
        const int squares = mesh_.columns - 1;
        const int left = std::clamp(static_cast<int>(x.x / cell), 0, squares - 1);
        const int below = std::clamp(static_cast<int>(x.y / cell), 0, squares - 1);
        for (const int half : {0, 1})
            for (const FrontFit& piece : pieces_of(tracker_, layers_, 2 * (below * squares + left) + half))
                if (const auto c = piece.coordinates_at(x)) return c;
        return std::nullopt;
    }

    TextureScore result() const {
        return {.stretch_p95 = near_.percentile(0.95),
                .stretched = stretched_ / area_,
                .slip = slip_.value(),
                .slip_near = slip_near_.value(),
                .drift_p95 = drift_.percentile(0.95) - 1};
    }

    const front::Mesh& mesh_;
    const TestFlow& flow_;
    TextureTrial trial_;
    Workers workers_{1};
    front::Tracker tracker_;
    TextureLayers layers_;
    std::vector<glm::vec2> velocity_, at_rest_;
    std::vector<TextureLayers::Offsets> before_;
    std::vector<Particle> particles_;
    std::vector<glm::dvec2> last_;  // coordinates at each particle
    Ratio slip_, slip_near_;
    Histogram near_, drift_;
    double area_ = 0, stretched_ = 0;
};

}  // namespace

TextureScore score_texture(const front::Mesh& mesh, const front::Rule& rule, front::PointSource source,
                           const TestFlow& flow, Cutting cutting, const TextureTrial& trial) {
    return Texture(mesh, rule, source, flow, cutting, trial).run();
}

}  // namespace sim::fields
