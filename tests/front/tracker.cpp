#include "sim/front/tracker.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <utility>

#include <glm/geometric.hpp>

#include "sim/core/workers.h"
#include "sim/fields/test_flows.h"

namespace {

using sim::Workers;
using sim::front::Mesh;
using sim::front::mesh_of;
using sim::front::Point;
using sim::front::PointSource;
using sim::front::Tracker;

constexpr double kStep = 1 / 60.0;

Mesh unit_square(int squares) {
    return mesh_of(sim::Grid{squares + 1, squares + 1, 1 / static_cast<float>(squares)});
}

std::vector<glm::vec2> velocities(const Mesh& mesh, const std::function<glm::vec2(glm::vec2)>& of) {
    std::vector<glm::vec2> velocity;
    for (const glm::vec2& position : mesh.position) velocity.push_back(of(position));
    return velocity;
}

// Opposed flows on either side of a line that moves along `normal` at constant speed.
struct SteadyLine {
    SteadyLine(int squares, PointSource source, glm::vec2 across, float from, float its_speed,
               bool hold = false)
        : SteadyLine(unit_square(squares), squares, source, across, from, its_speed, hold) {}
    SteadyLine(Mesh of, int squares, PointSource source, glm::vec2 across, float from, float its_speed,
               bool hold = false)
        : mesh(std::move(of)),
          tracker(mesh, sim::front::gradient_rule(0.05f, 1 / static_cast<float>(squares)), source, hold),
          normal(glm::normalize(across)),
          at(from),
          speed(its_speed) {}

    void step() {
        at += speed * static_cast<float>(kStep);
        const auto velocity = velocities(mesh, [&](glm::vec2 x) {
            return (glm::dot(x, normal) < at ? 0.2f : -0.2f) * glm::vec2(-normal.y, normal.x);
        });
        tracker.advance({velocity, {}}, kStep, workers);
    }
    float distance(const Point& point) const { return glm::dot(tracker.position(point), normal) - at; }

    const Mesh mesh;
    Tracker tracker;
    Workers workers{1};
    glm::vec2 normal;
    float at, speed;  // m, m/s
};

// Expected error of `half`. A line with unit normal n that moves steadily crosses an edge e while its place
// along n is in a range of length |e·n|. So the share of time, and of edges of that kind, is proportional to
// |e·n|. Each place in the range is equally likely, so the distance from the edge's middle is uniform from
// −|e·n|/2 to |e·n|/2, with mean square |e·n|²/12. A mesh of squares has as many edges along x as along y and
// along diagonals:
//
//     RMS² = Σ |e·n|³ / 12 / Σ |e·n|,    e = (1, 0), (0, 1) and (1, 1) or, mirrored, (−1, 1), in cells
double rms_of_middles(const glm::vec2& normal, const glm::vec2& diagonal) {
    double cut = 0, squares = 0;
    for (const glm::vec2& edge : {glm::vec2(1, 0), glm::vec2(0, 1), diagonal}) {
        const double across = std::abs(glm::dot(edge, normal));
        cut += across, squares += across * across * across / 12;
    }
    return std::sqrt(squares / cut);
}

// Squares cut by the diagonal from the lower left or, mirrored, from the lower right.
Mesh unit_square_cut_by(const glm::vec2& diagonal, int squares) {
    Mesh mesh = unit_square(squares);
    if (diagonal.x > 0) return mesh;
    auto position = mesh.position;
    for (glm::vec2& at : position) at.x = 1 - at.x;
    return std::get<Mesh>(mesh_of(position, mesh.triangle));
}

constexpr glm::vec2 kDiagonals[] = {{1, 1}, {-1, 1}};

TEST(HalfSource, has_the_expected_error_of_edge_midpoints) {
    constexpr int kSquares = 20;
    for (const glm::vec2& diagonal : kDiagonals)
        for (const glm::vec2 normal : {glm::vec2(1, 1), glm::vec2(-1, 1), glm::vec2(0.3f, 1),
                                       glm::vec2(-0.5f, 0.866f), glm::vec2(-2, 1), glm::vec2(0, 1)}) {
            const bool rises = normal.x >= 0;
            const glm::vec2 n = glm::normalize(normal);
            SteadyLine line(unit_square_cut_by(diagonal, kSquares), kSquares, PointSource::kHalf, n,
                            rises ? 0.4f : -0.3f, 0.1f);
            double sum = 0, count = 0;
            for (int i = 0; i < 240; ++i) {
                line.step();
                for (const Point& point : line.tracker.points()) {
                    const double cells = line.distance(point) * kSquares;
                    sum += cells * cells, ++count;
                }
            }
            const double expected = rms_of_middles(n, diagonal);
            EXPECT_NEAR(std::sqrt(sum / count), expected, 0.03 * expected)
                << "diagonal " << diagonal.x << ", normal " << normal.x << ' ' << normal.y;
        }
}

// Velocities at the vertices only tell that a line at rest is between them. At a fifth of each edge that it
// crosses, all points are wrong by 0.3 cells, for either diagonal.
TEST(PointSources, locate_a_line_at_rest_only_to_an_edge) {
    for (const PointSource source : {PointSource::kHalf, PointSource::kPaper, PointSource::kFit})
        for (const glm::vec2& diagonal : kDiagonals) {
            SteadyLine line(unit_square_cut_by(diagonal, 10), 10, source, {0, 1}, 0.52f, 0);
            for (int i = 0; i < 240; ++i) {
                line.step();
                ASSERT_EQ(line.tracker.points().size(), 21u);
                for (const Point& point : line.tracker.points())
                    ASSERT_NEAR(line.distance(point) * 10, 0.3, 0.02) << to_string(source);
            }
        }
}

TEST(PointSources, follow_a_steady_line_once_it_has_passed_some_vertices) {
    for (const auto& [source, allowed] :
         {std::pair(PointSource::kPaper, 0.25), std::pair(PointSource::kFit, 0.08)}) {
        SteadyLine line(20, source, {0, 1}, 0.1f, 0.2f);
        for (int i = 0; i < 120; ++i) line.step();
        for (int i = 0; i < 60; ++i) {
            line.step();
            for (const Point& point : line.tracker.points()) {
                EXPECT_LT(std::abs(line.distance(point)) * 20, allowed) << to_string(source);
                // Speed that a point on this edge needs to keep up.
                const glm::vec2 along = line.mesh.along(point.edge);
                const float expected = 0.2f * line.mesh.length[point.edge] / along.y;
                EXPECT_NEAR(point.speed, expected, 0.1 * expected) << to_string(source);
            }
        }
    }
}

// A front suddenly doubles its speed. Its points keep the speed with which it entered their edges.
TEST(PaperSource, leads_late_points_to_their_vertex) {
    constexpr int kSquares = 20;
    constexpr double kMost = 16 * kStep;  // greatest step of a late point, cells
    for (const bool hold : {false, true}) {
        SteadyLine line(kSquares, PointSource::kPaper, {0, 1}, 0.11f, 0.05f, hold);
        for (int i = 0; i < 180; ++i) line.step();
        line.speed = 0.1f;
        // cells: distance from its vertex when a point vanishes; longest step
        double farthest = 0, fastest = 0;
        for (int i = 0; i < 60; ++i) {
            const std::vector<Point> before(line.tracker.points().begin(), line.tracker.points().end());
            line.step();
            const auto& detector = line.tracker.detector();
            for (const auto& gone : detector.vanished()) {
                EXPECT_TRUE(detector.has_flipped(line.mesh.edge[gone.edge].b));
                const float length = line.mesh.length[gone.edge];
                farthest = std::max(farthest, double{(1 - before[gone.before].f) * length * kSquares});
            }
            for (const Point& point : line.tracker.points()) {
                const int at = detector.before()[detector.slot(point.edge)];
                const float moved = at < 0 ? 0 : std::abs(point.f - before[at].f);
                fastest = std::max(fastest, double{moved * line.mesh.length[point.edge] * kSquares});
            }
        }
        EXPECT_LT(fastest, kMost + 1e-4);
        if (hold) {
            EXPECT_LT(farthest, kMost);
        } else {
            EXPECT_GT(farthest, 0.4);
        }
    }
}

// The front passes a row of vertices, and turns back before the points arrive there.
TEST(PaperSource, hides_a_front_that_returns_while_it_is_held) {
    for (const bool hold : {false, true}) {
        SteadyLine line(10, PointSource::kPaper, {0, 1}, 0.52f, 0, hold);
        for (int i = 0; i < 60; ++i) line.step();
        std::size_t changes = 0;
        for (const float at : {0.59f, 0.61f, 0.61f, 0.59f, 0.59f, 0.59f, 0.59f}) {
            line.at = at;
            line.step();
            changes += line.tracker.detector().vanished().size();
        }
        EXPECT_EQ(changes, hold ? 0 : 2 * 21);
    }
}

TEST(LevelSource, is_exact_for_a_linear_scalar) {
    const Mesh mesh = unit_square(8);
    Tracker tracker(mesh, {.kind = sim::front::Rule::Kind::kLevel, .level = 0.25f}, PointSource::kLevel);
    Workers workers(1);
    const std::vector<glm::vec2> rest(mesh.position.size());
    const glm::vec2 gradient(0.4f, -0.9f);
    for (int i = 0; i < 30; ++i) {
        std::vector<float> scalar;
        const float rise = 0.3f * static_cast<float>(i * kStep);
        for (const glm::vec2& x : mesh.position) scalar.push_back(glm::dot(x, gradient) + 0.5f + rise);
        tracker.advance({rest, scalar}, kStep, workers);
        ASSERT_FALSE(tracker.points().empty());
        for (const Point& point : tracker.points()) {
            EXPECT_NEAR(glm::dot(tracker.position(point), gradient) + 0.5f + rise, 0.25, 1e-5);
            const float across = glm::dot(mesh.along(point.edge), gradient);
            if (i > 0 && std::abs(across) > 0.01f) {
                EXPECT_NEAR(point.speed, -0.3f / across * mesh.length[point.edge], 1e-2);
            }
        }
    }
}

TEST(Tracker, reports_the_age_of_a_point) {
    SteadyLine line(10, PointSource::kFit, {0, 1}, 0.52f, 0);
    for (int i = 0; i < 31; ++i) line.step();
    for (const Point& point : line.tracker.points()) EXPECT_NEAR(point.age, 0.5, 1e-5);
}

TEST(Tracker, is_bit_identical_for_any_number_of_threads) {
    const Mesh mesh = unit_square(20);
    const auto flow = sim::fields::pinwheel();
    for (const PointSource source : {PointSource::kPaper, PointSource::kFit}) {
        std::vector<Point> one;
        for (const int threads : {1, 2, 5}) {
            Tracker tracker(mesh, sim::front::gradient_rule(0.05f, 0.05f), source);
            Workers workers(threads);
            for (int i = 1; i <= 200; ++i)
                tracker.advance(
                    {velocities(mesh, [&](glm::vec2 x) { return flow.velocity(glm::dvec2(x), i * kStep); }),
                     {}},
                    kStep, workers);
            const std::vector<Point> points(tracker.points().begin(), tracker.points().end());
            if (threads == 1) one = points;
            ASSERT_EQ(points.size(), one.size());
            EXPECT_EQ(std::memcmp(points.data(), one.data(), one.size() * sizeof(Point)), 0)
                << to_string(source) << ", threads " << threads;
        }
    }
}

TEST(PointSource, is_found_by_its_name) {
    for (const PointSource source :
         {PointSource::kHalf, PointSource::kPaper, PointSource::kFit, PointSource::kLevel})
        EXPECT_EQ(sim::front::source_named(to_string(source)), source);
    EXPECT_EQ(sim::front::source_named("third"), std::nullopt);
}

}  // namespace
