#include "render/flow/flow_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/core/workers.h"
#include "sim/front/remesh_reference.h"
#include "tests/render/world.h"

// The cut mesh as a page gets it: nothing is missing, doubled or painted otherwise than the program paints it.
namespace render::test {
namespace {

using sim::front::CutVertex;
using sim::front::FlowView;
using sim::front::TextureLayers;

constexpr int kSquares = 22, kColumns = kSquares + 1;
constexpr float kVisible = 0.05f;

// A tongue that slides over a slope, leaves a deposit behind it, and turns.
class FlowOfTongue : public testing::Test {
  protected:
    FlowOfTongue()
        : world_(make_world(kSquares, 1, [](double x, double) { return -0.5 * x; })),
          mesh_(sim::front::mesh_of(world_.grid)) {
        sim::front::Rule rule;
        rule.kind = sim::front::Rule::Kind::kLevel;
        rule.level = kVisible;
        flow_.emplace(mesh_, rule, sim::front::PointSource::kLevel, sim::front::LayerRule{});
        rise_.resize(mesh_.position.size());
        flow_->set_rise(rise_);
        look_.flow.emplace();
        look_.rolling_visible_m = kVisible;
    }

    void go(int steps) {
        for (int step = 0; step < steps; ++step) {
            std::vector<float> rolling;
            std::vector<glm::vec2> velocity;
            for (const glm::vec2& at : mesh_.position) {
                const glm::vec2 way = at - middle_;
                const float depth = 0.4f - 0.03f * glm::dot(way, way);
                rolling.push_back(std::max(depth, 0.f));
                velocity.push_back(depth > kVisible ? glm::vec2(2 + 0.2f * way.y, 0.5f - 0.1f * way.x)
                                                    : glm::vec2(0));
            }
            for (int v = 0; v < mesh_.vertices(); ++v) {
                world_.rolling(v % kColumns, v / kColumns) = rolling[v];
                if (mesh_.position[v].x < middle_.x - 2 && rolling[v] > 0) rise_[v] = 0.1f;
                world_.depth(v % kColumns, v / kColumns) = rise_[v];
            }
            flow_->advance({velocity, rolling}, 1 / 30.0, workers_);
            middle_ += glm::vec2(2, 0.5f) / 30.f;
        }
        made_.make(*flow_, world_.view(), std::vector<float>(mesh_.position.size()), look_);
    }

    double area() const {
        double sum = 0;
        for (std::size_t i = 0; i < made_.indices().size(); i += 3) {
            const glm::vec2 a = at(i), b = at(i + 1) - a, c = at(i + 2) - a;
            EXPECT_GE(b.x * c.y - b.y * c.x, -1e-5f) << "turned over";
            sum += 0.5 * static_cast<double>(b.x * c.y - b.y * c.x);
        }
        return sum;
    }
    glm::vec2 at(std::size_t i) const { return made_.vertices()[made_.indices()[i]].at; }

    World world_;
    sim::front::Mesh mesh_;
    std::optional<FlowView> flow_;
    std::vector<float> rise_;
    Look look_;
    glm::vec2 middle_{6, 8};
    sim::Workers workers_{1};
    FlowMesh made_;
};

TEST_F(FlowOfTongue, is_empty_before_anything_flows) {
    made_.make(*flow_, world_.view(), std::vector<float>(mesh_.position.size()), look_);
    EXPECT_TRUE(made_.indices().empty());
    EXPECT_TRUE(made_.vertices().empty());
}

TEST_F(FlowOfTongue, covers_the_ground_once_where_all_of_it_is_texture) {
    look_.flow->everywhere = true;
    go(40);
    EXPECT_NEAR(area(), kSquares * kSquares, 1e-3);
}

TEST_F(FlowOfTongue, ends_at_the_front_of_what_is_seen) {
    go(40);
    const auto shows = [&](int v) {
        return world_.rolling(v % kColumns, v / kColumns) > kVisible || rise_[v] > 0;
    };
    double expected = 0;
    int whole = 0, cut = 0;
    for (int t = 0; t < static_cast<int>(mesh_.triangle.size()); ++t) {
        const auto pieces = cut_triangle(flow_->tracker(), t);
        (pieces.count == 1 ? whole : cut) += 1;
        for (const auto& piece : pieces) {
            const glm::vec2 b = piece[1].position - piece[0].position,
                            c = piece[2].position - piece[0].position;
            if (std::ranges::any_of(piece, [&](const CutVertex& each) { return shows(each.side); }))
                expected += 0.5 * static_cast<double>(b.x * c.y - b.y * c.x);
        }
    }
    EXPECT_GT(cut, 20);
    EXPECT_GT(whole, 500);
    EXPECT_NEAR(area(), expected, 1e-3);
    EXPECT_LT(expected, 0.4 * kSquares * kSquares);
}

// Each corner is one of the reference's, with the coordinates that it has on its side of the front.
TEST_F(FlowOfTongue, carries_on_the_coordinates_of_each_side) {
    go(40);
    std::vector<FlowVertex> described(mesh_.position.size());
    describe(*flow_, described);
    int on_front = 0;
    for (const FlowMeshVertex& vertex : made_.vertices()) {
        bool found = false;
        for (int t = 0; t < static_cast<int>(mesh_.triangle.size()) && !found; ++t)
            for (const auto& piece : cut_triangle(flow_->tracker(), t))
                for (const CutVertex& corner : piece) {
                    if (corner.position != vertex.at || found) continue;
                    const int shows = described[corner.side].shows;
                    found = true;
                    for (int sheet = 0; sheet < TextureLayers::kSheets; ++sheet) {
                        const glm::vec2 own = flow_->layers().offsets()[shows][sheet];
                        const glm::vec2 carried = flow_->layers().offset(corner, sheet) -
                                                  flow_->layers().offsets()[corner.side][sheet] + own;
                        found &= glm::distance(vertex.offset[sheet], carried) < 1e-5f;
                    }
                    on_front += found && corner.on_front;
                }
        ASSERT_TRUE(found) << vertex.at.x << ", " << vertex.at.y;
    }
    EXPECT_GT(on_front, 20);
}

}  // namespace
}  // namespace render::test
