#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <variant>

#include "render/gl/program.h"
#include "render/passes/remesher.h"
#include "sim/core/workers.h"
#include "sim/fields/test_flows.h"
#include "sim/front/remesh_reference.h"
#include "tests/render/gl_scene.h"
#include "tests/render/watched.h"
#include "tests/support/allocations.h"
#include "tests/support/places.h"

namespace render::test {
namespace {

namespace fs = std::filesystem;
using sim::front::cut_triangle;
using sim::front::CutTriangle;
using sim::front::CutTriangles;
using sim::front::CutVertex;
using sim::front::Mesh;
using sim::front::Point;

// Draws to memory instead of pixels.
constexpr const char* kCaptureShader = R"(
layout(xfb_buffer = 0, xfb_stride = 16) out;
layout(xfb_offset = 0) out vec2 position;
layout(xfb_offset = 8) flat out int side;
layout(xfb_offset = 12) flat out int on_front;
void main() {
    CutVertex vertex = cut_vertex(gl_VertexID);
    position = vertex.position;
    side = vertex.side;
    on_front = int(vertex.on_front);
    gl_Position = vec4(position, 0.0, 1.0);
}
)";
struct Captured {
    glm::vec2 position;
    std::int32_t side, on_front;
};

class Remeshing : public Gl {
  protected:
    void SetUp() override {
        context();
        const fs::path shaders = support::source_dir() / "assets" / "shaders";
        for (const char* name : {"slots.glsl", "cut_vertex.glsl"})
            fs::copy(shaders / name, folder_.path() / name);
        std::ofstream(folder_.path() / "capture.vert") << kCaptureShader;
        auto capture = link_program(folder_.path(),
                                    {{GL_VERTEX_SHADER, {"slots.glsl", "cut_vertex.glsl", "capture.vert"}}});
        ASSERT_TRUE(capture) << capture.error();
        capture_ = std::move(*capture);
        // Without a window there is no framebuffer until one is created, even if no pixel is drawn.
        nowhere_ = make_framebuffer();
        glNamedFramebufferParameteri(nowhere_.name(), GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
        glNamedFramebufferParameteri(nowhere_.name(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
        auto made = Remesher::create(shaders);
        ASSERT_TRUE(made) << made.error();
        remesher = std::move(*made);
    }

    void TearDown() override {
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        glUseProgram(0);  // otherwise a frame would restore the program of this test
    }

    // The remesher's triangles, in its order.
    std::vector<CutTriangle> drawn() const {
        return captured_from(remesher.indices().size(), [this] { remesher.draw(); });
    }
    // The same of some runs.
    std::vector<CutTriangle> drawn(const std::vector<TriangleRun>& runs) {
        int triangles = remesher.further_pieces();
        for (const TriangleRun& run : runs) triangles += run.last - run.first;
        return captured_from(static_cast<std::size_t>(3 * triangles), [&] { remesher.draw(runs); });
    }

    Remesher remesher;

  private:
    template <class Draw>
    std::vector<CutTriangle> captured_from(std::size_t indices, const Draw& draw) const {
        std::vector<Captured> captured(indices);
        if (captured.empty()) return {};
        const auto size = static_cast<GLsizeiptr>(sizeof(Captured) * captured.size());
        const Buffer buffer = make_buffer();
        glNamedBufferStorage(buffer.name(), size, nullptr, 0);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.name());
        glBindFramebuffer(GL_FRAMEBUFFER, nowhere_.name());
        glUseProgram(capture_.name());
        remesher.bind();
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginTransformFeedback(GL_TRIANGLES);
        draw();
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        glGetNamedBufferSubData(buffer.name(), 0, size, captured.data());
        std::vector<CutTriangle> triangles(captured.size() / 3);
        for (std::size_t i = 0; i < captured.size(); ++i)
            triangles[i / 3][i % 3] = {captured[i].position, captured[i].side, captured[i].on_front != 0};
        return triangles;
    }

    support::TemporaryFolder folder_;
    ProgramName capture_;
    Framebuffer nowhere_;
};

// Triangles as bits, in a canonical order.
std::vector<std::array<std::uint32_t, 12>> bits_of(const std::vector<CutTriangle>& triangles) {
    std::vector<std::array<std::uint32_t, 12>> all;
    for (const CutTriangle& triangle : triangles) {
        auto to = all.emplace_back().begin();
        for (const CutVertex& vertex : triangle) {
            *to++ = std::bit_cast<std::uint32_t>(vertex.position.x);
            *to++ = std::bit_cast<std::uint32_t>(vertex.position.y);
            *to++ = static_cast<std::uint32_t>(vertex.side);
            *to++ = vertex.on_front;
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}
bool same(const std::vector<CutTriangle>& a, const std::vector<CutTriangle>& b) {
    return bits_of(a) == bits_of(b);
}

void append(std::vector<CutTriangle>& all, const CutTriangles& some) {
    all.insert(all.end(), some.begin(), some.end());
}

std::vector<CutTriangle> reference(const sim::front::Tracker& tracker) {
    std::vector<CutTriangle> all;
    for (int t = 0; t < static_cast<int>(tracker.mesh().triangle.size()); ++t)
        append(all, cut_triangle(tracker, t));
    return all;
}

// Points that no tracker would set. `seen` collects which edges of a triangle were cut, and by which diagonal
// the rest after two cuts was split.
std::vector<CutTriangle> reference(const Mesh& mesh, const std::vector<Point>& points,
                                   std::set<std::pair<int, bool>>* seen = nullptr) {
    std::vector<std::optional<glm::vec2>> crossing(mesh.edge.size());
    for (const Point& point : points) {
        const float f = std::clamp(point.f, sim::front::kNearestToEnd, 1 - sim::front::kNearestToEnd);
        crossing[point.edge] = mesh.position[mesh.edge[point.edge].a] + f * mesh.along(point.edge);
    }
    std::vector<CutTriangle> all;
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
        std::array<glm::vec2, 3> at;
        std::array<std::optional<glm::vec2>, 3> of_triangle;
        int pattern = 0;
        for (int k = 0; k < 3; ++k) {
            at[k] = mesh.position[mesh.triangle[t][k]];
            of_triangle[k] = crossing[mesh.triangle_edge[t][k]];
            pattern |= of_triangle[k].has_value() << k;
        }
        const CutTriangles cut = cut_triangle(mesh.triangle[t], at, of_triangle);
        const bool two = std::popcount(static_cast<unsigned>(pattern)) == 2;
        if (seen) seen->emplace(pattern, two && cut.triangle[1][2].on_front);
        append(all, cut);
    }
    return all;
}

class Dice {
  public:
    float real() { return std::uniform_real_distribution<float>(0, 1)(source_); }
    int below(int count) { return std::uniform_int_distribution(0, count - 1)(source_); }
    template <class T>
    void shuffle(std::vector<T>& values) {
        std::shuffle(values.begin(), values.end(), source_);
    }

  private:
    std::mt19937 source_{4};
};

// Squares of one metre, with inner vertices moved, random diagonals, random vertex numbers and triangles that
// start at any corner; if `turned`, in either direction too.
Mesh irregular_mesh(int squares, bool turned, Dice& dice) {
    const int side = squares + 1;
    std::vector<int> number(static_cast<std::size_t>(side * side));
    std::iota(number.begin(), number.end(), 0);
    dice.shuffle(number);
    std::vector<glm::vec2> position(number.size());
    const auto moved = [&](int i) {
        return static_cast<float>(i) + (i > 0 && i < squares ? 0.5f * (dice.real() - 0.5f) : 0);
    };
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) position[number[y * side + x]] = {moved(x), moved(y)};
    std::vector<std::array<int, 3>> triangle;
    const auto add = [&](std::array<int, 3> corner) {
        std::rotate(corner.begin(), corner.begin() + dice.below(3), corner.end());
        if (turned && dice.below(2) == 1) std::swap(corner[0], corner[1]);
        triangle.push_back(corner);
    };
    for (int y = 0; y < squares; ++y)
        for (int x = 0; x < squares; ++x) {
            const int* at = &number[y * side + x];
            const int a = at[0], b = at[1], c = at[side + 1], d = at[side];
            if (dice.below(2) == 1)
                add({a, b, c}), add({a, c, d});
            else
                add({a, b, d}), add({b, c, d});
        }
    dice.shuffle(triangle);
    return std::get<Mesh>(sim::front::mesh_of(std::move(position), std::move(triangle)));
}

// Points on a share of all edges, at the limits of the edge, in the middle, and anywhere.
std::vector<Point> random_points(const Mesh& mesh, float share, Dice& dice) {
    std::vector<Point> points;
    for (int e = 0; e < mesh.edges(); ++e) {
        const float some[] = {0, 0.01f, 0.5f, 0.99f, 1, dice.real(), dice.real(), dice.real()};
        if (dice.real() < share) points.push_back({e, some[dice.below(8)], 0, 0});
    }
    return points;
}

double signed_area(const CutTriangle& triangle) {
    const glm::dvec2 p(triangle[0].position), q(triangle[1].position), r(triangle[2].position);
    return 0.5 * ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}

TEST_F(Remeshing, draws_the_mesh_itself_if_nothing_is_cut) {
    Dice dice;
    const Mesh mesh = irregular_mesh(5, true, dice);
    remesher.send_mesh(mesh);
    EXPECT_TRUE(same(drawn(), reference(mesh, {})));
    remesher.cut({});
    EXPECT_TRUE(same(drawn(), reference(mesh, {})));
}

TEST_F(Remeshing, is_bit_identical_to_the_reference_for_all_cuts) {
    Dice dice;
    std::set<std::pair<int, bool>> seen;
    for (const int squares : {1, 7, 30}) {
        const Mesh mesh = irregular_mesh(squares, true, dice);
        remesher.send_mesh(mesh);
        for (const float share : {0.02f, 0.5f, 1.f, 0.8f, 0.3f, 0.f, 0.6f, 0.1f, 0.f}) {
            const std::vector<Point> points = random_points(mesh, share, dice);
            remesher.cut(points);
            EXPECT_TRUE(same(drawn(), reference(mesh, points, &seen))) << squares << " squares, " << share;
        }
    }
    EXPECT_EQ(seen.size(), 8u + 3u) << "some pattern of cuts or some diagonal was not drawn";
}

TEST_F(Remeshing, draws_the_runs_it_is_given_and_all_further_pieces) {
    Dice dice;
    const Mesh mesh = irregular_mesh(12, true, dice);
    const int triangles = static_cast<int>(mesh.triangle.size());
    remesher.send_mesh(mesh);
    for (const float share : {0.f, 0.05f, 0.5f, 1.f, 0.3f, 0.f}) {
        remesher.cut(random_points(mesh, share, dice));
        const std::vector<CutTriangle> all = drawn();
        ASSERT_EQ(static_cast<int>(all.size()), triangles + remesher.further_pieces());
        EXPECT_EQ(remesher.further_pieces() > 0, share > 0);
        std::vector<TriangleRun> runs;
        std::vector<CutTriangle> expected;
        for (int first = dice.below(4); first < triangles; first += 1 + dice.below(40)) {
            const int last = std::min(first + 1 + dice.below(20), triangles);
            runs.push_back({first, last});
            expected.insert(expected.end(), all.begin() + first, all.begin() + last);
            first = last;
        }
        expected.insert(expected.end(), all.begin() + triangles, all.end());
        EXPECT_TRUE(same(drawn(runs), expected)) << share;
        EXPECT_EQ(static_cast<int>(drawn(std::vector<TriangleRun>{}).size()), remesher.further_pieces());
        EXPECT_TRUE(same(drawn({{0, triangles}}), all));
    }
}

// In undeformed squares both diagonals after two cuts may be equally long.
TEST_F(Remeshing, equals_the_reference_if_diagonals_are_equal) {
    const Mesh mesh = sim::front::mesh_of(sim::Grid{9, 9, 1});
    remesher.send_mesh(mesh);
    Dice dice;
    for (int round = 0; round < 10; ++round) {
        std::vector<Point> points = random_points(mesh, 0.6f, dice);
        for (Point& point : points) point.f = 0.5f;
        remesher.cut(points);
        EXPECT_TRUE(same(drawn(), reference(mesh, points)));
    }
}

TEST_F(Remeshing, comparison_detects_swapped_copies_of_an_edge) {
    Dice dice;
    const Mesh mesh = irregular_mesh(4, true, dice);
    remesher.send_mesh(mesh);
    const std::vector<Point> points = random_points(mesh, 0.5f, dice);
    remesher.cut(points);
    const std::vector<std::uint32_t> indices = remesher.indices();
    for (const Point& point : points) {
        std::vector<CutTriangle> swapped = drawn();
        const auto copy = static_cast<std::uint32_t>(mesh.vertices() + 2 * point.edge);
        for (std::size_t i = 0; i < indices.size(); ++i)
            if (indices[i] == copy || indices[i] == copy + 1) {
                const auto [a, b] = mesh.edge[point.edge];
                int& side = swapped[i / 3][i % 3].side;
                side = a + b - side;
            }
        EXPECT_FALSE(same(swapped, reference(mesh, points)));
    }
}

// Every side of a drawn triangle is bit-identical to that of another one, from end to end, except along the
// border.
TEST_F(Remeshing, has_no_cracks_and_covers_the_mesh_once) {
    Dice dice;
    constexpr int kSquares = 20;
    const Mesh mesh = irregular_mesh(kSquares, false, dice);
    remesher.send_mesh(mesh);
    const std::vector<Point> points = random_points(mesh, 0.4f, dice);
    remesher.cut(points);
    using Place = std::pair<float, float>;
    std::map<std::pair<Place, Place>, int> open;
    double area = 0;
    for (const CutTriangle& triangle : drawn()) {
        area += signed_area(triangle);
        EXPECT_GE(signed_area(triangle), -1e-6);
        for (int k = 0; k < 3; ++k) {
            const glm::vec2 p = triangle[k].position, q = triangle[(k + 1) % 3].position;
            const Place from(p.x, p.y), to(q.x, q.y);
            ++open[{from, to}], --open[{to, from}];
        }
    }
    EXPECT_NEAR(area, kSquares * kSquares, 1e-4);
    double border = 0;
    for (const auto& [ends, count] : open) {
        if (count <= 0) continue;
        const auto& [from, to] = ends;
        const bool along_x = from.second == to.second && (to.second == 0 || to.second == kSquares);
        const bool along_y = from.first == to.first && (to.first == 0 || to.first == kSquares);
        EXPECT_TRUE(count == 1 && (along_x || along_y));
        border += std::hypot(to.first - from.first, to.second - from.second);
    }
    EXPECT_NEAR(border, 4 * kSquares, 1e-4);
}

// A rotating disc: where its front has left, the cuts are gone.
class RemeshingADisc : public Remeshing {
  protected:
    static constexpr int kSquares = 24;
    const Mesh mesh = sim::front::mesh_of(sim::Grid{kSquares + 1, kSquares + 1, 1.f / kSquares});
    sim::front::Tracker tracker{mesh, sim::front::gradient_rule(0.05f, 1.f / kSquares),
                                sim::front::PointSource::kFit};

    void step() {
        ++steps_;
        for (std::size_t v = 0; v < velocity_.size(); ++v)
            velocity_[v] = flow_.velocity(glm::dvec2(mesh.position[v]), steps_ / 60.0);
        tracker.advance({velocity_, {}}, 1 / 60.0, workers_);
    }

  private:
    const sim::fields::TestFlow flow_ = sim::fields::disc();
    std::vector<glm::vec2> velocity_{mesh.position.size()};
    sim::Workers workers_{1};
    int steps_ = 0;
};

TEST_F(RemeshingADisc, follows_its_front) {
    remesher.send_mesh(mesh);
    std::set<int> ever_cut;
    std::vector<CutTriangle> before;
    for (int i = 0; i < 100; ++i) {
        step();
        remesher.cut(tracker.points());
        const std::vector<CutTriangle> now = drawn();
        ASSERT_TRUE(same(now, reference(tracker))) << "step " << i;
        ASSERT_FALSE(same(now, before)) << "it moves: step " << i;
        before = now;
        ever_cut.insert(tracker.detector().cut().begin(), tracker.detector().cut().end());
    }
    EXPECT_GT(ever_cut.size(), 2 * tracker.points().size());
}

TEST_F(RemeshingADisc, tolerates_skipped_steps) {
    remesher.send_mesh(mesh);
    for (int i = 0; i < 90; ++i) {
        step();
        if (i % 30 == 0) remesher.cut(tracker.points());
    }
    remesher.cut(tracker.points());
    EXPECT_TRUE(same(drawn(), reference(tracker)));
    remesher.cut({});
    EXPECT_TRUE(same(drawn(), reference(mesh, {})));
}

TEST_F(RemeshingADisc, is_dropped_by_a_new_mesh) {
    remesher.send_mesh(mesh);
    step();
    remesher.cut(tracker.points());
    Dice dice;
    const Mesh other = irregular_mesh(3, true, dice);
    remesher.send_mesh(other);
    EXPECT_TRUE(same(drawn(), reference(other, {})));
    const std::vector<Point> points = random_points(other, 0.5f, dice);
    remesher.cut(points);
    EXPECT_TRUE(same(drawn(), reference(other, points)));
}

TEST_F(RemeshingADisc, allocates_nothing_and_creates_no_object_in_later_steps) {
    remesher.send_mesh(mesh);
    const auto remesh = [&] {
        remesher.cut(tracker.points());
        glFinish();
    };
    step();
    remesh();
    const Watched<&epoxy_glCreateBuffers> buffers;
    const Watched<&epoxy_glCreateVertexArrays> vertex_arrays;
    const Watched<&epoxy_glCreateTextures> textures;
    gl_objects = 0;
    for (int i = 0; i < 20; ++i) {
        step();
        const std::int64_t before = support::allocations_of_all_threads();
        remesh();
        EXPECT_EQ(support::allocations_of_all_threads(), before);
    }
    EXPECT_EQ(gl_objects, 0);
    remesher.send_mesh(mesh);
    EXPECT_GE(gl_objects, 8) << "the same counters see a new mesh";
}

}  // namespace
}  // namespace render::test
