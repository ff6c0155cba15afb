#include "render/flow/flow_changes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "sim/core/workers.h"
#include "tests/support/allocations.h"

// Random sessions: flows that move, stop, leave deposits, go back and start again.
namespace render::test {
namespace {

using sim::front::FlowView;
using sim::front::Mesh;
using sim::front::TextureLayers;

template <class T>
std::string bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

// The description of all vertices, without regard to what changed.
std::vector<FlowVertex> description(const FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    const int count = flow.mesh().vertices();
    std::vector<FlowVertex> vertices;
    for (int v = 0; v < count; ++v) vertices.push_back({-1, flow.deposit(v), v, 0});
    for (int v = 0; v < count; ++v)
        if (vertices[v].deposit > 0)
            for (const auto& spoke : flow.mesh().around(v))
                if (!layers.has_moved(spoke.vertex)) vertices[spoke.vertex].shows = v;
    for (int v = 0; v < count; ++v) {
        if (!layers.has_moved(v)) {
            vertices[v].stretch = static_cast<float>(STRETCH_GONE);
            continue;
        }
        float sum = 0, neighbours = 0;
        for (const auto& [neighbour, edge] : flow.mesh().around(v)) {
            const int own = vertices[v].shows, other = vertices[neighbour].shows;
            if (!layers.has_moved(other) || flow.tracker().detector().is_cut(edge)) continue;
            float apart = 0;
            for (int s = 0; s < TextureLayers::kSheets; ++s)
                apart += layers.weight(own, s) *
                         glm::length(layers.offsets()[other][s] - layers.offsets()[own][s]);
            const float stretch = apart / flow.mesh().length[edge];
            sum += stretch * stretch, neighbours += 1;
        }
        if (neighbours > 0) vertices[v].stretch = std::sqrt(sum / neighbours);
    }
    for (std::size_t i = 0; i < layers.beside_front().size(); ++i)
        vertices[layers.beside_front()[i]].beside = static_cast<int>(i);
    return vertices;
}

// All bytes by which a vertex is drawn.
std::vector<std::string> drawn_bytes(const FlowView& flow) {
    const TextureLayers& layers = flow.layers();
    const std::vector<FlowVertex> vertices = description(flow);
    std::vector<std::string> drawn;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const FlowVertex& of = vertices[v];
        drawn.push_back(bytes_of(of.deposit) + bytes_of(of.shows) + bytes_of(of.stretch));
        for (const std::size_t from : {v, static_cast<std::size_t>(of.shows)})
            drawn[v] += bytes_of(layers.offsets()[from]) + bytes_of(layers.mix()[from]);
        if (of.beside >= 0) drawn[v] += bytes_of(layers.gradients()[static_cast<std::size_t>(of.beside)]);
    }
    for (const sim::front::Point& point : flow.tracker().points())
        for (const int v : {flow.mesh().edge[point.edge].a, flow.mesh().edge[point.edge].b})
            drawn[v] += bytes_of(point.edge) + bytes_of(point.f);
    return drawn;
}

// A flow on a heightfield, driven at random.
class Session {
  public:
    Session(const sim::Grid& grid, unsigned seed) : mesh_(sim::front::mesh_of(grid)), dice_(seed) {
        velocity_.resize(mesh_.position.size());
        rise_.resize(mesh_.position.size());
        begin();
    }

    FlowView& flow() { return *flow_; }
    int below(int count) { return static_cast<int>(dice_() % static_cast<unsigned>(count)); }

    void do_something() {
        const int what = below(20);
        if (what == 0) {
            begin();
        } else if (what == 1 && !memories_.empty()) {
            if (below(2) == 0) begin();
            flow_->layers().restore(
                memories_[static_cast<std::size_t>(below(static_cast<int>(memories_.size())))]);
        } else if (what == 2) {
            memories_.push_back(flow_->layers().memory());
        } else if (what == 3) {
            fill([](int) { return glm::vec2(0, 0); });
        } else if (what < 8) {
            const glm::vec2 way(0.4f * static_cast<float>(below(5) - 2),
                                0.3f * static_cast<float>(below(5) - 2));
            fill([&](int) { return way; });
        } else if (what < 11) {
            const int v = below(mesh_.vertices());
            rise_[v] = rise_[v] > 0 ? 0.f : 0.4f;
        }
        for (int i = below(3); i > 0; --i) flow_->advance({velocity_, {}}, 1 / 60.0, workers_);
    }

  private:
    // In the same place, so that nothing can be told from addresses.
    void begin() {
        flow_.emplace(mesh_, sim::front::gradient_rule(0.1f, 1), sim::front::PointSource::kFit,
                      sim::front::LayerRule{});
        flow_->set_rise(rise_);
    }
    // Sets velocities in a rectangle.
    template <class Velocity>
    void fill(const Velocity& velocity) {
        const int columns = mesh_.columns, rows = mesh_.vertices() / columns;
        const int x0 = below(columns), y0 = below(rows), x1 = x0 + below(9), y1 = y0 + below(7);
        for (int y = y0; y < std::min(y1, rows); ++y)
            for (int x = x0; x < std::min(x1, columns); ++x)
                velocity_[y * columns + x] = velocity(y * columns + x);
    }

    Mesh mesh_;
    std::mt19937 dice_;
    std::vector<glm::vec2> velocity_;
    std::vector<float> rise_;
    std::optional<FlowView> flow_;
    std::vector<TextureLayers::Memory> memories_;
    sim::Workers workers_{1};
};

// What a GPU would hold.
struct Uploaded {
    std::vector<TextureLayers::Offsets> offsets;
    std::vector<TextureLayers::Mix> mixes;
    std::vector<FlowVertex> vertices;
    std::vector<TextureLayers::Gradients> gradients;

    void receive(const FlowChanges& changes, const TextureLayers& layers) {
        const std::size_t count = layers.offsets().size();
        offsets.resize(count), mixes.resize(count), vertices.resize(count);
        for (const auto& [first, last] : changes.ranges()) {
            std::copy(&layers.offsets()[first], layers.offsets().data() + last, &offsets[first]);
            std::copy(&layers.mix()[first], layers.mix().data() + last, &mixes[first]);
            std::copy(&changes.vertices()[first], changes.vertices().data() + last, &vertices[first]);
        }
        if (changes.gradients_changed())
            gradients.assign(layers.gradients().begin(), layers.gradients().end());
    }
};

template <class A, class B>
bool same(const A& a, const B& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof *a.data()) == 0);
}

TEST(FlowChanges, equal_a_comparison_of_all_bytes_in_random_sessions) {
    std::size_t some = 0, none = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Session session(seed % 2 == 0 ? sim::Grid{31, 22, 1} : sim::Grid{24, 40, 1}, seed);
        FlowChanges changes;
        Uploaded uploaded;
        std::vector<std::string> before;
        for (int round = 0; round < 150; ++round) {
            for (int i = session.below(3); i > 0; --i) session.do_something();
            const FlowView& flow = session.flow();
            changes.find(flow);
            const std::vector<std::string> now = drawn_bytes(flow);
            std::vector<int> expected;
            for (std::size_t v = 0; v < now.size(); ++v)
                if (before.empty() || before[v] != now[v]) expected.push_back(static_cast<int>(v));
            ASSERT_TRUE(std::ranges::equal(changes.changed(), expected))
                << "seed " << seed << ", round " << round;
            uploaded.receive(changes, flow.layers());
            ASSERT_TRUE(same(uploaded.offsets, flow.layers().offsets()));
            ASSERT_TRUE(same(uploaded.mixes, flow.layers().mix()));
            ASSERT_TRUE(same(uploaded.vertices, description(flow)));
            ASSERT_TRUE(same(uploaded.gradients, flow.layers().gradients()));
            (expected.empty() ? none : some) += expected.size() < now.size();
            before = now;
        }
    }
    EXPECT_GT(some, 300u);
    EXPECT_GT(none, 20u);
}

TEST(FlowChanges, are_all_vertices_of_a_new_mesh_and_after_forgetting) {
    Session wide({30, 20, 1}, 1), high({20, 30, 1}, 1), finer({30, 20, 0.5f}, 1);
    FlowChanges changes;
    for (Session* session : {&wide, &high, &wide, &finer, &wide}) {
        for (int i = 0; i < 9; ++i) session->do_something();
        changes.find(session->flow());
        EXPECT_EQ(changes.changed().size(), 600u);
        changes.find(session->flow());
        EXPECT_EQ(changes.changed().size(), 0u);
        EXPECT_EQ(changes.ranges().size(), 0u);
    }
    changes.forget();
    changes.find(wide.flow());
    EXPECT_EQ(changes.changed().size(), 600u);
}

TEST(FlowChanges, are_found_without_allocating) {
    Session session({60, 60, 1}, 3);
    FlowChanges changes;
    changes.find(session.flow());
    for (int round = 0; round < 60; ++round) {
        session.do_something();
        const std::int64_t before = support::allocations();
        changes.find(session.flow());
        ASSERT_EQ(support::allocations(), before) << round;
    }
}

// Of layers whose vertices are numbered by rows.
TEST(TextureLayers, leave_groups_untouched_where_nothing_moved) {
    const Mesh mesh = sim::front::mesh_of(sim::Grid{64, 32, 1});
    FlowView flow(mesh, sim::front::gradient_rule(0.1f, 1), sim::front::PointSource::kFit, {});
    std::vector<glm::vec2> velocity(mesh.position.size());
    velocity[5 * 64 + 20] = {1, 0};
    sim::Workers workers(1);
    const TextureLayers::Memory at_first = flow.layers().memory();
    const auto touched = [&] { return std::ranges::count(flow.layers().touched(), 1); };
    EXPECT_EQ(touched(), 0);
    flow.advance({velocity, {}}, 1 / 60.0, workers);
    EXPECT_EQ(touched(), 1);
    EXPECT_EQ(flow.layers().touched()[5], 1);
    const TextureLayers::Memory later = flow.layers().memory();
    flow.layers().restore(at_first);
    EXPECT_EQ(touched(), 0);
    flow.layers().restore(later);
    EXPECT_EQ(touched(), 1);
}

}  // namespace
}  // namespace render::test
