#include "render/woods/woods.h"
#include "render/frame/make_frame_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "assets/shaders/slots.glsl"
#include "render/woods/followed_woods.h"
#include "render/woods/trees_in_view.h"
#include "tests/render/mountains.h"

// Where conifers stand, and which of them a frame shows; without GL.
namespace render::test {
namespace {

// A valley of a kilometre from west to east, between slopes as steep as 0.6 and a cliff in the north.
double wooded_valley(double, double y) {
    return y > 900 ? 0.6 * 400 + 3 * (y - 900) : 0.6 * std::abs(y - 500);
}

constexpr TreeRules kRules{.density = 300, .line_m = 180, .seed = 7};

class WoodInValley : public testing::Test {
  protected:
    WoodInValley() {
        for (int y = 20; y < 40; ++y)
            for (int x = 20; x < 60; ++x) world.site(x, y) = sim::Site::kDrain;
    }
    Woods woods(const TreeRules& rules = kRules) const {
        return {mountains_around(world), rules, world.datum};
    }
    FrameBlock frame(const Camera& camera) const {
        return make_frame_block({.world = world.view(), .camera = camera, .width = 640, .height = 360},
                                {0, 540}, 1, std::nullopt);
    }
    OnScreen screen(const Camera& camera) const { return {frame(camera).clip_from_world, 640, 360}; }
    std::vector<DrawnTree> drawn(const Woods& of, const Camera& camera, const FlowSoFar& flow = {}) const {
        std::vector<TreeLight> lights;
        light_trees(of, mountains_around(world), glm::normalize(glm::vec3(1, 1, 1)), lights);
        TreesInView trees;
        trees.reserve(of.trees().size());
        trees.find({of.trees(), of.tiles(), lights}, frame(camera), screen(camera));
        trees.settle(of.trees(), world.view(), flow);
        return {trees.drawn().begin(), trees.drawn().end()};
    }

    World world = make_world(100, 10, wooded_valley);
};

const glm::vec2* find_in(const std::map<std::pair<float, float>, glm::vec2>& trees,
                         std::pair<float, float> foot) {
    const auto at = trees.find(foot);
    return at == trees.end() ? nullptr : &at->second;
}

bool same(const Woods& a, const Woods& b) {
    return a.fingerprint() == b.fingerprint() && a.trees().size() == b.trees().size() &&
           std::memcmp(a.trees().data(), b.trees().data(), a.trees().size_bytes()) == 0;
}

TEST_F(WoodInValley, follows_from_ground_rules_and_seed) {
    const Woods first = woods();
    ASSERT_GT(first.trees().size(), 1000u);
    EXPECT_TRUE(same(first, woods()));
    TreeRules other = kRules;
    other.seed = 8;
    EXPECT_FALSE(same(first, woods(other)));
}

TEST_F(WoodInValley, stands_on_no_rock_no_hole_and_not_above_the_tree_line) {
    const Woods all = woods();
    std::size_t on_grid = 0;
    for (const Tree& tree : all.trees()) {
        EXPECT_LT(tree.foot.z, kRules.line_m);
        if (tree.vertex < 0) continue;
        ++on_grid;
        const int x = tree.vertex % world.grid.nx, y = tree.vertex / world.grid.nx;
        EXPECT_NE(world.site(x, y), sim::Site::kDrain) << x << " " << y;
        EXPECT_LT(tree.foot.y, 905);
        EXPECT_NEAR(tree.foot.z, wooded_valley(tree.foot.x, tree.foot.y), 3);
        EXPECT_GE(tree.height, 1);
        EXPECT_LE(tree.height, 23);
        EXPECT_EQ(tree.group, 1);
        EXPECT_GT(tree.downhill.y * (500 - tree.foot.y), -1e-3f);
    }
    EXPECT_GT(on_grid, 300u);
    EXPECT_GT(all.trees().size(), on_grid + 300) << "the wood ends at the border";
}

TEST_F(WoodInValley, is_denser_where_more_is_asked_for_and_never_too_large) {
    TreeRules rules = kRules;
    rules.density = 100;
    const Woods few = woods(rules);
    EXPECT_EQ(few.asked(), static_cast<double>(few.trees().size()));
    rules.density = TreeRules::kDensest;
    const Woods many = woods(rules);
    EXPECT_LE(many.trees().size(), Woods::kMost);
    EXPECT_GT(many.trees().size(), 5 * few.trees().size());
    EXPECT_GT(many.asked(), 1e6);
    rules.density = 0;
    EXPECT_TRUE(woods(rules).empty());
    EXPECT_TRUE(Woods({}, kRules, 0).empty()) << "a model has no trees";
}

TEST_F(WoodInValley, has_those_that_are_left_out_stand_with_those_that_are_kept) {
    TreeRules rules = kRules;
    rules.density = 100;
    Woods many = woods(rules);
    for (; many.asked() <= static_cast<double>(many.trees().size()); many = woods(rules))
        rules.density *= 1.5;
    const double together = many.asked() / static_cast<double>(many.trees().size());
    ASSERT_GT(together, 1);
    ASSERT_LT(together, 2);
    for (const Tree& tree : many.trees()) {
        EXPECT_GE(tree.group, together - 1e-4);
        EXPECT_LE(tree.group, Woods::kMostTogether);
    }
    rules.density = TreeRules::kDensest;
    many = woods(rules);
    for (const Tree& tree : many.trees()) EXPECT_LE(tree.group, Woods::kMostTogether);
}

TEST_F(WoodInValley, grows_only_within_its_polygon) {
    TreeRules rules = kRules;
    rules.polygon = {{200, 220}, {800, 220}, {800, 490}, {500, 340}, {200, 490}};
    const Woods within = woods(rules);
    EXPECT_GT(within.trees().size(), 50u);
    for (const Tree& tree : within.trees()) {
        EXPECT_TRUE(tree.foot.x > 200 && tree.foot.x < 800 && tree.foot.y > 220);
        EXPECT_LT(tree.foot.y, 340 + 0.5f * std::abs(tree.foot.x - 500) + 0.01f);
    }
    EXPECT_NE(within.fingerprint(), woods().fingerprint());
}

TEST_F(WoodInValley, grows_by_shares_if_there_are_any) {
    TreeRules rules = kRules;
    rules.shares.resize(world.grid.size());
    for (std::size_t i = 0; i < rules.shares.size(); ++i)
        if (i % static_cast<std::size_t>(world.grid.nx) > 50) rules.shares[i] = 255;
    const Woods all = woods(rules);
    double closed = 0;
    for (const Tree& tree : all.trees()) {
        EXPECT_GT(tree.foot.x, 500);
        EXPECT_GE(tree.vertex, 0) << "beside the grid";
        const int x = tree.vertex % world.grid.nx, y = tree.vertex / world.grid.nx;
        EXPECT_NE(world.site(x, y), sim::Site::kDrain);
        closed += tree.foot.x > 600 && tree.foot.x < 900 && tree.foot.y > 350 && tree.foot.y < 450;
    }
    EXPECT_NEAR(closed / 3, rules.density, 0.15 * rules.density) << "trees per hectare";
}

TEST_F(WoodInValley, is_in_tiles_that_enclose_it) {
    const Woods all = woods();
    std::uint32_t next = 0;
    for (const TreeTile& tile : all.tiles()) {
        EXPECT_EQ(tile.first, next);
        next += tile.count;
        for (const Tree& tree : all.trees().subspan(tile.first, tile.count)) {
            const glm::vec3 top = tree.foot + glm::vec3(0, 0, tree.height);
            EXPECT_TRUE(tree.foot == glm::clamp(tree.foot, tile.lowest, tile.highest));
            EXPECT_TRUE(top == glm::clamp(top, tile.lowest, tile.highest));
        }
    }
    EXPECT_EQ(next, all.trees().size());
}

TEST_F(WoodInValley, shows_every_near_tree_in_view) {
    const Woods all = woods();
    std::mt19937 random(34);
    int seen = 0;
    for (int i = 0; i < 30; ++i) {
        const Camera camera{{200.0 + static_cast<double>(random() % 600), 300, 150},
                            static_cast<double>(random() % 360),
                            10,
                            80,
                            50};
        const auto shown = drawn(all, camera);
        const FrameBlock block = frame(camera);
        for (const Tree& tree : all.trees()) {
            const glm::vec4 clip = block.clip_from_world * glm::vec4(tree.foot, 1);
            if (clip.w < 1 || clip.w > 200 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w)
                continue;
            ++seen;
            EXPECT_TRUE(std::ranges::any_of(
                shown, [&](const DrawnTree& each) { return glm::vec3(each.foot) == tree.foot; }));
        }
    }
    EXPECT_GT(seen, 150);
}

TEST_F(WoodInValley, has_stands_with_edges_and_few_trees_between_them) {
    std::size_t within = 0, between = 0, edge = 0;
    const Woods all = woods();
    for (const Tree& tree : all.trees())
        ++(tree.closed > 0.9f ? within : tree.closed < 0.1f ? between : edge);
    EXPECT_GT(within, between);
    EXPECT_GT(between, 100u);
    EXPECT_LT(edge, within / 2);
}

TEST_F(WoodInValley, has_larches_and_dwarf_pine_near_the_tree_line_only) {
    int larches = 0, pines = 0;
    const Woods all = woods();
    for (const Tree& tree : all.trees()) {
        if (tree.kind == TreeKind::kSpruce) continue;
        ++(tree.kind == TreeKind::kLarch ? larches : pines);
        EXPECT_GT(tree.foot.z, kRules.line_m - 300);
        EXPECT_TRUE(tree.kind != TreeKind::kPine || tree.height < 3);
    }
    EXPECT_GT(larches, 10);
    EXPECT_GT(pines, 10);
}

// A mountain of a kilometre that rises to the north, with the tree line far above its foot.
class MixedWood : public testing::Test {
  protected:
    Woods woods(bool mixed) const {
        TreeRules rules{.density = 300, .line_m = 640, .seed = 7};
        rules.mixed = mixed;
        return {mountains_around(world), rules, world.datum};
    }
    World world = make_world(100, 10, [](double, double y) { return 0.55 * y; });
};

TEST_F(MixedWood, has_the_trees_of_a_winter_and_the_same_forest_and_bushes_besides) {
    const Woods winter = woods(false), mixed = woods(true);
    EXPECT_NE(winter.fingerprint(), mixed.fingerprint());
    ASSERT_GT(mixed.trees().size(), winter.trees().size());
    for (std::size_t i = 0; i < winter.trees().size(); ++i) {
        Tree as_in_winter = mixed.trees()[i];
        EXPECT_LE(winter.trees()[i].kind, TreeKind::kPine);
        EXPECT_NE(as_in_winter.kind, TreeKind::kBush);
        as_in_winter.kind = winter.trees()[i].kind;
        EXPECT_EQ(std::memcmp(&as_in_winter, &winter.trees()[i], sizeof(Tree)), 0) << i;
    }
    for (const Tree& tree : mixed.trees().subspan(winter.trees().size())) {
        EXPECT_EQ(tree.kind, TreeKind::kBush);
        EXPECT_LT(tree.height, 5);
    }
    EXPECT_LE(mixed.trees().size() - winter.trees().size(), Woods::kMostBushes);
    EXPECT_TRUE(forest_of(mixed, world.grid) == forest_of(winter, world.grid));
}

// A hollow down the mountain, with a brook from its middle on.
TEST_F(MixedWood, keeps_out_of_brooks_and_has_thickets_beside_them) {
    world = make_world(100, 10, [](double x, double y) { return 0.35 * y + 0.15 * std::abs(x - 500); });
    const Surroundings around = mountains_around(world);
    const Land land = land_of(around);
    TreeRules rules{.density = 600, .line_m = 640, .seed = 7};
    rules.mixed = true;
    const Woods dry(around, rules, 0), wet(around, rules, 0, {}, land);
    const auto in_brooks = [&](const Woods& woods) {
        return std::ranges::count_if(woods.trees(), [&](const Tree& tree) {
            return land.to_brook(around.source(glm::dvec2(tree.foot))) < 0.5;
        });
    };
    const auto on_banks = [&](const Woods& woods) {
        return std::ranges::count_if(woods.trees(), [&](const Tree& tree) {
            const double away = land.to_brook(around.source(glm::dvec2(tree.foot)));
            return tree.kind == TreeKind::kBush && away > 1 && away < 5;
        });
    };
    EXPECT_GT(in_brooks(dry), 3);
    EXPECT_EQ(in_brooks(wet), 0);
    EXPECT_GT(on_banks(wet), 2 * on_banks(dry) + 20);
    EXPECT_NE(dry.fingerprint(), wet.fingerprint());
    EXPECT_TRUE(forest_of(dry, world.grid) == forest_of(wet, world.grid));
}

TEST_F(MixedWood, leaves_fields_and_paths_and_has_hedges_and_orchards_that_are_no_forest) {
    world = make_world(100, 10, [](double, double y) { return 0.1 * y + 0.4 * std::max(y - 300, 0.0); });
    const Surroundings around = mountains_around(world);
    Settlement village;
    for (const double x : {300.0, 500.0, 700.0}) village.houses.push_back({{x, 250}, {0, -1}, 11, 9});
    const Land land = land_of(around, village);
    TreeRules rules{.density = 600, .line_m = 640, .seed = 7};
    rules.mixed = true;
    const Woods wild(around, rules, 0), tended(around, rules, 0, {}, land);
    const auto on_paths = [&](const Woods& woods) {
        return std::ranges::count_if(woods.trees(), [&](const Tree& tree) {
            return land.use(around.source(glm::dvec2(tree.foot))) >= LAND_GARDEN;
        });
    };
    int hedge = 0, orchard = 0;
    for (const Tree& tree : tended.trees()) {
        if (tree.origin == TreeOrigin::kWild) continue;
        EXPECT_FALSE(is_of_forest(tree));
        ++(tree.kind == TreeKind::kBush ? hedge : orchard);
    }
    EXPECT_GT(on_paths(wild), 3);
    EXPECT_EQ(on_paths(tended), 0);
    EXPECT_GT(hedge, 100);
    EXPECT_GT(orchard, 6);
    EXPECT_TRUE(forest_of(wild, world.grid) == forest_of(tended, world.grid));
}

TEST_F(MixedWood, is_planted_with_the_kinds_that_grow_there) {
    const Surroundings around = mountains_around(world);
    const Woods winter = woods(false), mixed = woods(true);
    int low = 0, high = 0, of_winter = 0;
    for (int i = 0; i < 400; ++i) {
        const double chance = (i + 0.5) / 400, x = 200 + i;
        low += mixed.kind_of_planted(around, {x, 200}, 1, chance) == TreeKind::kBeech;
        high += mixed.kind_of_planted(around, {x, 950}, 1, chance) == TreeKind::kBeech;
        of_winter += winter.kind_of_planted(around, {x, 200}, 1, chance) <= TreeKind::kLarch;
    }
    EXPECT_GT(low, 150);
    EXPECT_EQ(high, 0);
    EXPECT_EQ(of_winter, 400);
}

TEST_F(MixedWood, is_broad_leaved_low_mixed_between_and_of_conifers_at_the_line) {
    enum Belt { kLow, kBetween, kHigh, kBelts };
    std::array<std::array<int, 6>, kBelts> count{};
    const Woods all = woods(true);
    for (const Tree& tree : all.trees()) {
        const float below = 640 - tree.foot.z;
        const Belt belt = below > 480 ? kLow : below < 120 ? kHigh : kBetween;
        ++count[belt][static_cast<std::size_t>(tree.kind)];
    }
    const auto share = [&](Belt belt, TreeKind kind) {
        int trees = 0;
        for (int i = 0; i < static_cast<int>(TreeKind::kBush); ++i)
            trees += count[belt][static_cast<std::size_t>(i)];
        EXPECT_GT(trees, 200) << belt;
        return static_cast<double>(count[belt][static_cast<std::size_t>(kind)]) / trees;
    };
    EXPECT_GT(share(kLow, TreeKind::kBeech), 0.5);
    EXPECT_GT(share(kBetween, TreeKind::kBeech), 0.15);
    EXPECT_LT(share(kBetween, TreeKind::kBeech), 0.6);
    EXPECT_LT(share(kHigh, TreeKind::kBeech), 0.02);
    EXPECT_GT(share(kBetween, TreeKind::kSpruce), 0.15);
    EXPECT_GT(share(kHigh, TreeKind::kLarch), 0.2);
    EXPECT_GT(share(kHigh, TreeKind::kLarch), 2 * share(kLow, TreeKind::kLarch));
    EXPECT_GT(share(kLow, TreeKind::kBirch) + share(kBetween, TreeKind::kBirch), 0.1);
    EXPECT_EQ(share(kLow, TreeKind::kPine), 0);
    EXPECT_GT(count[kLow][5] + count[kBetween][5] + count[kHigh][5], 100) << "bushes";
}

TEST_F(WoodInValley, stands_in_groups_far_from_the_grid) {
    float largest = 0;
    const Woods all = woods();
    for (const Tree& tree : all.trees()) {
        EXPECT_GE(tree.group, 1);
        EXPECT_LE(tree.group, Woods::kLargestGroup);
        largest = std::max(largest, tree.group);
    }
    EXPECT_GT(largest, 8);
}

TEST_F(WoodInValley, has_fewer_trees_far_away_that_cover_as_much) {
    const Woods all = woods();
    const auto covered = [&](double distance, std::size_t& count) {  // m², on the grid
        double sum = 0;
        count = 0;
        for (const DrawnTree& tree : drawn(all, {{500, 300, 100}, 180, 20, distance, 30})) {
            if (tree.foot.x < 0 || tree.foot.x > 1000 || tree.foot.y < 0 || tree.foot.y > 1000) continue;
            const double triangle = tree.look.w * tree.foot.w;
            sum += triangle * (tree.kind.y > 1.5f ? 4. / 3 : 1);  // a group has no flanks
            ++count;
        }
        return sum;
    };
    std::size_t near = 0, far = 0, farther = 0;
    const double of_near = covered(2500, near), of_far = covered(5000, far),
                 of_farther = covered(10000, farther);
    EXPECT_LT(far, 0.7 * near);
    EXPECT_LT(farther, 0.7 * far);
    EXPECT_NEAR(of_far / of_near, 1, 0.15);
    EXPECT_NEAR(of_farther / of_near, 1, 0.15);
}

TEST_F(WoodInValley, changes_little_by_little_while_the_camera_moves) {
    const Woods all = woods();
    constexpr float kMost = 6;  // m, of what a tree changes by within a step of the camera
    std::vector<TreeLight> lights;
    light_trees(all, mountains_around(world), glm::normalize(glm::vec3(1, 1, 1)), lights);
    TreesInView trees;
    trees.reserve(all.trees().size());
    std::map<std::pair<float, float>, glm::vec2> before;  // by its foot: height, and half its width
    std::size_t changed = 0;
    for (int step = 0; step < 150; ++step) {
        std::map<std::pair<float, float>, glm::vec2> now;
        const Camera camera{{500, 300, 100}, 180, 20, 2000 * std::pow(1.004, step), 40};
        trees.find({all.trees(), all.tiles(), lights}, frame(camera), screen(camera));
        for (const DrawnTree& tree : trees.drawn())
            if (tree.foot.x > 100 && tree.foot.x < 900 && tree.foot.y > 0 && tree.foot.y < 1000)
                now[{tree.foot.x, tree.foot.y}] = {tree.foot.w, tree.look.w};
        if (step > 0)
            for (const auto* frame : {&before, &now})
                for (const auto& [foot, size] : *frame) {
                    const auto *a = find_in(before, foot), *b = find_in(now, foot);
                    const glm::vec2 change = glm::abs((a ? *a : glm::vec2(0)) - (b ? *b : glm::vec2(0)));
                    EXPECT_LT(std::max(change.x, change.y), kMost);
                    changed += !a || !b;
                }
        before = std::move(now);
    }
    EXPECT_GT(changed, 20u) << "some appear or vanish";
}

TEST_F(WoodInValley, shows_trees_wider_than_a_pixel) {
    const Camera camera{{500, 300, 100}, 180, 20, 9000, 30};
    const auto shown = drawn(woods(), camera);
    const FrameBlock block = frame(camera);
    std::size_t wide = 0;
    for (const DrawnTree& tree : shown) {
        const float distance = glm::distance(glm::vec3(tree.foot), glm::vec3(block.eye));
        wide += 2 * tree.look.w / (distance * block.material.y) > 1.19f;
    }
    EXPECT_GT(wide, shown.size() / 2) << "the others shrink before they are left out";
}

TEST_F(WoodInValley, lies_downhill_where_a_flow_was_deep_and_fast) {
    const Woods all = woods();
    const Camera camera{{500, 300, 100}, 180, 20, 900, 60};
    std::vector<float> depth(world.grid.size()), speed(world.grid.size());
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const std::size_t x = i % static_cast<std::size_t>(world.grid.nx);
        depth[i] = x < 50 ? 2.f : 0.05f;
        speed[i] = x > 20 ? 15.f : 0.5f;
    }
    const auto before = drawn(all, camera), after = drawn(all, camera, {depth, speed});
    ASSERT_EQ(before.size(), after.size());
    int lie = 0, stand = 0;
    for (const DrawnTree& tree : after) {
        if (tree.foot.x < 0 || tree.foot.x > 1000 || tree.foot.y < 0 || tree.foot.y > 480) continue;
        const bool hit = tree.foot.x > 210 && tree.foot.x < 490;
        if (hit) {
            ++lie;
            EXPECT_LT(tree.axis.z, 0.3f);
            EXPECT_GT(tree.axis.y, 0) << "uphill";
        } else if (tree.foot.x < 200 || tree.foot.x > 510) {
            ++stand;
            EXPECT_GT(tree.axis.z, 0.97f);
        }
    }
    EXPECT_GT(lie, 20);
    EXPECT_GT(stand, 20);
}

TEST_F(WoodInValley, leans_a_little_and_sheds_snow_on_the_sunny_side) {
    // Snow but for a strip of bare rock, and none in the east.
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < 70; ++x) world.depth(x, y) = x >= 30 && x < 33 ? 0.f : 1.f;
    const Woods all = woods();
    int on_rock = 0, in_the_east = 0;
    std::size_t leaning = 0, upright = 0;
    for (const DrawnTree& tree : drawn(all, {{500, 300, 100}, 180, 20, 900, 60})) {
        EXPECT_NEAR(glm::length(glm::vec3(tree.axis)), 1, 1e-5f);
        ++(tree.axis.z < 0.998f ? leaning : upright);
        const bool slopes = std::abs(tree.foot.x - 500) < 500 && tree.foot.y > 0 && tree.foot.y < 880;
        if (!slopes || std::abs(tree.foot.y - 500) < 60) continue;
        if (tree.foot.x > 740) {
            ++in_the_east;
            EXPECT_EQ(tree.kind.w, 0);
        } else if (tree.foot.x < 700) {
            if (tree.foot.x > 300 && tree.foot.x < 320) ++on_rock;
            EXPECT_NEAR(tree.kind.w, tree.foot.y > 500 ? 0.5f : 1, 0.1f)
                << "north of the floor slopes face south";
        }
    }
    EXPECT_GT(on_rock, 5);
    EXPECT_GT(in_the_east, 20);
    EXPECT_GT(leaning, 5u);
    EXPECT_GT(upright, 10 * leaning);
}

TEST_F(WoodInValley, parts_before_the_eye) {
    const Woods all = woods();
    const Tree& tree = all.trees()[all.trees().size() / 2];
    const auto nearest = [&](double above) {
        // The eye is at the tree, looking north from a metre south of its axis.
        const Camera camera{glm::dvec3(tree.foot) + glm::dvec3(0, 9, above), 180, 0, 10, 60};
        float least = 1e9f;
        for (const DrawnTree& each : drawn(all, camera))
            least = std::min(least, glm::distance(glm::vec2(each.foot), glm::vec2(tree.foot)));
        return least;
    };
    EXPECT_GT(nearest(0.4 * static_cast<double>(tree.height)), 0.1f) << "it is not drawn around the eye";
}

// The woods of the valley with a forest in the world's state.
class FollowedForest : public WoodInValley {
  protected:
    FollowedForest() : around_(mountains_around(world)), woods_(woods()) {
        world.things.emplace(world.grid);
        world.things->natural = world.bedrock;
    }
    using Places = std::map<std::pair<float, float>, Tree>;
    Places follow(bool with_woods = true) {
        change_ = followed_.follow(with_woods ? &woods_ : nullptr, &around_, world.view(), {},
                                   glm::normalize(glm::vec3(1, 1, 1)), false);
        const LitTrees all = followed_.trees();
        EXPECT_EQ(all.lights.size(), all.trees.size());
        Places places;
        for (const TreeTile& tile : all.tiles)
            for (const Tree& tree : all.trees.subspan(tile.first, tile.count)) {
                EXPECT_TRUE(glm::all(glm::greaterThanEqual(tree.foot, tile.lowest)));
                places[{tree.foot.x, tree.foot.y}] = tree;
            }
        return places;
    }
    void set_forest(const std::vector<sim::Stems>& forest) {
        for (int y = 0; y < world.grid.ny; ++y)
            for (int x = 0; x < world.grid.nx; ++x)
                world.things->forest(x, y) =
                    forest[static_cast<std::size_t>(y) * static_cast<std::size_t>(world.grid.nx) +
                           static_cast<std::size_t>(x)];
    }
    static bool contains(const Places& all, const Places& some) {
        return std::ranges::all_of(some, [&](const auto& tree) { return all.contains(tree.first); });
    }

    const Surroundings around_;
    Woods woods_;
    FollowedWoods followed_;
    FollowedWoods::Change change_ = FollowedWoods::Change::kNone;
};

TEST_F(FollowedForest, of_woods_that_act_shows_these_until_it_changes) {
    const Places before = follow();
    EXPECT_EQ(before.size(), woods_.trees().size());
    woods_.let_act();
    set_forest(forest_of(woods_, world.grid));
    const Places acting = follow();
    ASSERT_EQ(acting.size(), before.size());
    for (const auto& [place, tree] : before) {
        ASSERT_TRUE(acting.contains(place));
        EXPECT_EQ(acting.at(place).height, tree.height);
        EXPECT_EQ(acting.at(place).fate, tree.vertex < 0 ? TreeFate::kOfFlow : TreeFate::kStands);
    }
    follow();
    EXPECT_EQ(change_, FollowedWoods::Change::kNone);

    // All is felled, and only the trees outside the grid are left.
    set_forest(std::vector<sim::Stems>(world.grid.size()));
    for (const auto& [place, tree] : follow()) EXPECT_LT(tree.vertex, 0);
    EXPECT_EQ(change_, FollowedWoods::Change::kSome);
    set_forest(forest_of(woods_, world.grid));
    EXPECT_EQ(follow().size(), before.size());
}

TEST_F(FollowedForest, lies_where_it_is_broken) {
    woods_.let_act();
    std::vector<sim::Stems> forest = forest_of(woods_, world.grid);
    for (sim::Stems& stems : forest) std::swap(stems.standing, stems.lying);
    set_forest(forest);
    for (const auto& [place, tree] : follow()) {
        EXPECT_EQ(lying(tree, {}), tree.vertex < 0 ? 0 : 1);
        EXPECT_EQ(tree.fate, tree.vertex < 0 ? TreeFate::kOfFlow : TreeFate::kLies);
    }
}

TEST_F(FollowedForest, has_bushes_that_are_not_felled_with_it) {
    TreeRules rules = kRules;
    rules.mixed = true;
    woods_ = woods(rules);
    woods_.let_act();
    set_forest(forest_of(woods_, world.grid));
    EXPECT_EQ(follow().size(), woods_.trees().size());
    set_forest(std::vector<sim::Stems>(world.grid.size()));
    int bushes = 0;
    for (const auto& [place, tree] : follow()) {
        EXPECT_TRUE(tree.vertex < 0 || tree.kind == TreeKind::kBush);
        EXPECT_TRUE(tree.kind != TreeKind::kBush || tree.fate == TreeFate::kOfFlow);
        bushes += tree.kind == TreeKind::kBush && tree.vertex >= 0;
    }
    EXPECT_GT(bushes, 20);
}

TEST_F(FollowedForest, is_planted_besides_woods_that_are_a_view) {
    const Places wild = follow();
    for (int y = 10; y < 14; ++y)
        for (int x = 70; x < 80; ++x) world.things->forest(x, y) = {800, 0, 30, 22};
    const Places planted = follow();
    EXPECT_TRUE(contains(planted, wild));
    EXPECT_EQ(planted.size(), wild.size() + 40 * 8);
    for (const auto& [place, tree] : planted)
        if (!wild.contains(place)) {
            EXPECT_NEAR(tree.foot.z, wooded_valley(0, tree.foot.y), 1);
            EXPECT_GT(tree.height, 22 * 0.59);
            EXPECT_LT(tree.height, 22 * 1.16);
        }
}

TEST_F(FollowedForest, keeps_its_trees_where_more_are_planted_and_gives_up_the_last_ones) {
    const auto with = [&](std::uint16_t stems) {
        world.things->forest(50, 12) = {stems, 0, 30, 22};
        return follow(false);
    };
    const Places few = with(300), more = with(1200);
    EXPECT_EQ(more.size(), 12u);
    EXPECT_LT(few.size(), more.size());
    EXPECT_TRUE(contains(more, few));
    EXPECT_EQ(with(300).size(), few.size());
    EXPECT_TRUE(contains(few, with(300)));
    EXPECT_TRUE(with(0).empty());
}

TEST_F(FollowedForest, gives_way_to_what_is_built) {
    const auto in_house = [](const Places& all) {
        return std::ranges::count_if(all, [](const auto& tree) {
            return std::abs(tree.first.first - 800) < 20 && std::abs(tree.first.second - 300) < 20;
        });
    };
    const auto wild = in_house(follow());
    world.things->list.push_back(
        {.x = 800, .y = 300, .length = 40, .width = 40, .height = 8, .strength = 10});
    EXPECT_EQ(in_house(follow()), 0);
    for (int y = 25; y < 35; ++y)
        for (int x = 75; x < 85; ++x) world.things->forest(x, y) = {1000, 0, 30, 22};
    EXPECT_EQ(in_house(follow()), 0);
    world.things->list.clear();
    EXPECT_GE(in_house(follow()), wild + 100);
}

TEST_F(FollowedForest, is_bounded) {
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x) world.things->forest(x, y) = {sim::kMostStems, 0, 30, 22};
    const std::size_t all = follow(false).size();
    EXPECT_LE(all, Woods::kMost + Woods::kMost / 20);
    EXPECT_GT(all, Woods::kMost / 3);
}

TEST_F(FollowedForest, is_the_same_whatever_was_followed_before) {
    std::mt19937 random(5);
    for (int step = 0; step < 12; ++step) {
        const int x = static_cast<int>(random() % 90), y = static_cast<int>(random() % 90);
        const auto stems = static_cast<std::uint16_t>(random() % 1500),
                   laid = static_cast<std::uint16_t>(random() % 300);
        for (int j = y; j < y + 8; ++j)
            for (int i = x; i < x + 8; ++i) world.things->forest(i, j) = {stems, laid, 30, 20};
        const Places now = follow();
        FollowedWoods kept = std::exchange(followed_, FollowedWoods());
        const Places fresh = follow();
        followed_ = std::move(kept);
        ASSERT_EQ(now.size(), fresh.size());
        EXPECT_TRUE(contains(now, fresh));
    }
}

}  // namespace
}  // namespace render::test
