// What a scene file places on its mountain, and what it must not.
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/scene/scene.h"
#include "game/scene/standing.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// 160 m square, in cells of 10 m.
constexpr const char* kSlope = R"([terrain]
generator = "slope-of-soil"
grid = 16
[cover]
material = "soil"
[physics]
)";
constexpr int kLines = 6;  // of it

class Placed : public testing::Test {
  protected:
    Outcome<Scene> load(const std::string& tables, std::optional<int> squares = std::nullopt) {
        const auto path = folder_.path() / "trial.toml";
        write_bytes(path, kSlope + tables);
        Overrides overrides;
        overrides.squares = squares;
        return load_scene(path.string(), overrides);
    }
    Scenario::Standing standing(const std::string& tables, std::optional<int> squares = std::nullopt) {
        const auto scene = load(tables, squares);
        EXPECT_TRUE(scene) << scene.error().sentence;
        return scene ? scene->scenario.standing : Scenario::Standing();
    }
    // The fact of a fault in a line of the tables, counted from 1.
    std::string fault(const std::string& tables, int line) {
        const auto scene = load(tables);
        if (scene) {
            ADD_FAILURE() << "accepted: " << tables;
            return {};
        }
        EXPECT_EQ(scene.error().status, Failure::kUnusable);
        const std::string place = fmt::format("trial.toml:{}: ", kLines + line);
        EXPECT_NE(scene.error().sentence.find(place), std::string::npos) << scene.error().sentence;
        return scene.error().sentence;
    }
    void expect_fault(const std::string& tables, int line, const std::string& fact) {
        const std::string sentence = fault(tables, line);
        EXPECT_NE(sentence.find(fact), std::string::npos) << sentence;
    }

    support::TemporaryFolder folder_;
};

TEST_F(Placed, nothing_stands_in_a_scene_that_names_nothing) {
    EXPECT_TRUE(standing("").empty());
}

TEST_F(Placed, house_has_usual_sizes_and_is_as_strong_as_its_material) {
    const auto usual = standing("[[house]]\nat = [80, 40]\n").placed;
    ASSERT_EQ(usual.size(), 1u);
    EXPECT_EQ(usual[0].kind, sim::CommandKind::kHouse);
    EXPECT_EQ(usual[0].x, 80);
    EXPECT_EQ(usual[0].y, 40);
    EXPECT_EQ(usual[0].turn, 0);
    EXPECT_EQ(usual[0].length, 11);
    EXPECT_EQ(usual[0].width, 9);
    EXPECT_EQ(usual[0].height, 7.5);
    EXPECT_EQ(usual[0].strength, 5);
    for (const auto& [name, strength] : {std::pair{"\"glass\"", 1.0},
                                         {"\"wood\"", 5.0},
                                         {"\"brick\"", 10.0},
                                         {"\"concrete\"", 30.0},
                                         {"7.5", 7.5}}) {
        const auto placed =
            standing(fmt::format("[[house]]\nat = [80, 40]\nheading = -90\nlength = 20.5\nwidth = "
                                 "12\nheight = 9\nstrength = {}\n",
                                 name))
                .placed;
        ASSERT_EQ(placed.size(), 1u);
        EXPECT_EQ(placed[0].strength, strength);
        EXPECT_EQ(placed[0].turn, -90);
        EXPECT_EQ(placed[0].length, 20.5);
        EXPECT_EQ(placed[0].width, 12);
        EXPECT_EQ(placed[0].height, 9);
        EXPECT_EQ(sim::fault_of(placed[0]), std::nullopt);
    }
}

TEST_F(Placed, house_that_cannot_be_is_refused_with_its_line) {
    expect_fault("[[house]]\nheading = 9\n", 1, "needs `at`");
    expect_fault("[[house]]\nat = [80, 40]\nstrength = 0\n", 3, "strength is 0, outside 0.5 to 1000");
    expect_fault("[[house]]\nat = [80, 40]\nstrength = \"straw\"\n", 3, "strength is not a number of kPa");
    expect_fault("[[house]]\nat = [80, 40]\nlength = 2\n", 3, "length is 2, outside 3 to 200");
    expect_fault("[[house]]\nat = [80, 40]\nheight = 31\n", 3, "height is 31, outside 2 to 30");
    expect_fault("[[house]]\nat = [80, 40]\nheading = 400\n", 3, "heading is 400");
    expect_fault("[[house]]\nat = [80, 40]\ncolour = 1\n", 3, "colour is not a known key");
}

TEST_F(Placed, what_is_beside_the_grid_or_on_something_else_is_refused_with_its_line) {
    expect_fault("[[house]]\nat = [80, 40]\n[[house]]\nat = [400, 40]\n", 3, "house cannot stand: ");
    expect_fault("[[house]]\nat = [80, 40]\n[[house]]\nat = [120, 40]\n[[house]]\nat = [84, 40]\n", 5,
                 "house cannot stand: ");
    expect_fault("[[net]]\npoints = [[20, 80], [50, 400]]\n", 1, "net cannot stand: ");
    expect_fault("[[dam]]\npoints = [[20, 80], [50, 400]]\nradius = 15\nrise = 3\n", 2,
                 "points has point 2, 50, 400, beside the grid");
    expect_fault("[[forest]]\npolygon = [[20, 20], [50, 20], [50, 161]]\n", 2,
                 "polygon has corner 3, 50, 161, beside the grid");
}

TEST_F(Placed, nets_are_straight_rows_between_their_points) {
    const auto placed =
        standing("[[net]]\npoints = [[20, 80], [50, 85], [70, 85.5]]\nheight = 4\nstrength = 20\n").placed;
    ASSERT_EQ(placed.size(), 2u);
    EXPECT_EQ(placed[1].kind, sim::CommandKind::kNet);
    EXPECT_EQ(placed[1].x, 50);
    EXPECT_EQ(placed[1].y, 85);
    EXPECT_EQ(placed[1].to_x, 70);
    EXPECT_EQ(placed[1].to_y, 85.5);
    EXPECT_EQ(placed[1].height, 4);
    EXPECT_EQ(placed[1].strength, 20);
    EXPECT_EQ(standing("[[net]]\npoints = [[20, 80], [50, 85]]\n").placed[0].height, 3);
    EXPECT_EQ(standing("[[net]]\npoints = [[20, 80], [50, 85]]\n").placed[0].strength, 30);
    expect_fault("[[net]]\nheight = 3\n", 1, "needs points");
    expect_fault("[[net]]\npoints = [[20, 80]]\n", 2, "has 1 places; 2 to ");
    expect_fault("[[net]]\npoints = [[20, 80], [20, 80]]\n", 2, "same place twice");
    expect_fault("[[net]]\npoints = [[20, 80], [50, 85]]\nheight = 1\n", 3, "outside 2 to 6");
}

TEST_F(Placed, forest_stands_at_the_vertices_inside_its_polygon) {
    const auto forest =
        standing(
            "[[forest]]\npolygon = [[15, 15], [45, 15], [45, 35], [15, 35]]\nstems = 500\ndiameter = 0.25\n"
            "height = 18\n")
            .forest;
    ASSERT_EQ(forest.size(), 17u * 17u);
    int trees = 0;
    for (std::size_t i = 0; i < forest.size(); ++i) {
        const std::size_t x = i % 17, y = i / 17;
        const bool inside = x >= 2 && x <= 4 && y >= 2 && y <= 3;
        EXPECT_EQ(forest[i], inside ? (sim::Stems{500, 0, 25, 18}) : sim::Stems()) << x << " " << y;
        trees += inside;
    }
    EXPECT_EQ(trees, 6);
    const auto usual = standing("[[forest]]\npolygon = [[15, 15], [45, 15], [45, 35]]\n").forest;
    EXPECT_EQ(usual[17 * 2 + 4], (sim::Stems{400, 0, 30, 22}));
}

// A star of many corners against the test that asks each vertex of the grid about each side.
TEST_F(Placed, forest_of_any_polygon_stands_where_a_ray_to_the_east_leaves_it_an_odd_number_of_times) {
    constexpr int kCorners = 254;
    std::vector<std::pair<double, double>> corners;
    std::string tables = "[[forest]]\npolygon = [";
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * 3.14159265358979 * i / kCorners, radius = i % 2 ? 75 : 20 + i % 7;
        corners.emplace_back(80 + std::round(radius * std::cos(angle)), 80 + radius * std::sin(angle));
        tables += fmt::format("[{}, {}],", corners.back().first, corners.back().second);
    }
    const auto forest = standing(tables + "]\n", 64).forest;
    ASSERT_EQ(forest.size(), 65u * 65u);
    int trees = 0;
    for (std::size_t i = 0; i < forest.size(); ++i) {
        const double east = 2.5 * static_cast<double>(i % 65), north = 2.5 * static_cast<double>(i / 65);
        bool inside = false;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto [ax, ay] = corners[(k + corners.size() - 1) % corners.size()];
            const auto [bx, by] = corners[k];
            if ((ay > north) != (by > north) && east < ax + (bx - ax) * (north - ay) / (by - ay))
                inside = !inside;
        }
        EXPECT_EQ(forest[i].standing > 0, inside) << east << " " << north;
        trees += inside;
    }
    EXPECT_GT(trees, 500);
}

TEST_F(Placed, later_forest_replaces_an_earlier_one) {
    const std::string square =
        "[[forest]]\npolygon = [[15, 15], [45, 15], [45, 45], [15, 45]]\nstems = 2000\n";
    const auto forest =
        standing(square + "[[forest]]\npolygon = [[35, 15], [65, 15], [65, 45], [35, 45]]\nstems = 300\n")
            .forest;
    EXPECT_EQ(forest[17 * 2 + 3].standing, 2000);
    EXPECT_EQ(forest[17 * 2 + 4].standing, 300);
    EXPECT_EQ(forest[17 * 2 + 6].standing, 300);
}

TEST_F(Placed, forest_that_cannot_be_is_refused_with_its_line) {
    const std::string square = "[[forest]]\npolygon = [[15, 15], [45, 15], [45, 45], [15, 45]]\n";
    expect_fault(square + "stems = 2001\n", 3, "stems is 2001, outside 1 to 2000");
    expect_fault(square + "stems = 0\n", 3, "stems is 0");
    expect_fault(square + "diameter = 3\n", 3, "outside 0.1 to 0.6");
    expect_fault(square + "height = 80\n", 3, "outside 5 to 35");
    expect_fault("[[forest]]\nstems = 9\n", 1, "needs a polygon");
    expect_fault("[[forest]]\npolygon = [[15, 15], [45, 15]]\n", 2, "has 2 places");
    expect_fault("[[forest]]\npolygon = [[15, 15], [45, 45], [45, 15], [15, 45]]\n", 2,
                 "crosses itself: side 1, from corner 1, meets side 3");
    expect_fault("[[forest]]\npolygon = [[11, 11], [18, 11], [18, 18]]\n", 2, "no vertex of the grid inside");
}

TEST_F(Placed, dam_is_made_of_cones_that_sum_to_its_height_within_a_twentieth) {
    const auto placed =
        standing("[[dam]]\npoints = [[40, 60], [80, 60], [80, 90]]\nradius = 15\nrise = 6\n", 160).placed;
    ASSERT_GT(placed.size(), 4u);
    for (const double at : {60.0, 63.0, 66.6}) {
        double rise = 0;
        for (const sim::Command& stroke : placed) {
            EXPECT_EQ(stroke.kind, sim::CommandKind::kSculpt);
            EXPECT_EQ(stroke.profile, sim::Profile::kCone);
            EXPECT_EQ(stroke.radius, 15);
            EXPECT_EQ(sim::fault_of(stroke), std::nullopt);
            const double away = std::hypot(stroke.x - at, stroke.y - 60);
            rise += stroke.rise * std::max(0.0, 1 - away / 15);
        }
        EXPECT_NEAR(rise, 6, 0.3) << at;
    }
    for (const sim::Command& stroke :
         standing("[[dam]]\npoints = [[40, 60], [80, 60]]\nradius = 15\nrise = -4\n").placed)
        EXPECT_LT(stroke.rise, 0);
}

TEST_F(Placed, dam_needs_as_much_earth_on_any_grid) {
    const std::string dam = "[[dam]]\npoints = [[40, 60], [80, 60]]\nradius = 15\nrise = 6\n";
    const auto needed = [&](int squares) { return earth_needed(load(dam, squares)->scenario); };
    const double fine = needed(160);
    EXPECT_GT(fine, 3000);
    for (const int squares : {16, 32, 64, 80}) EXPECT_NEAR(needed(squares), fine, 0.02 * fine) << squares;
}

TEST_F(Placed, dam_that_cannot_be_is_refused_with_its_line) {
    const std::string line = "[[dam]]\npoints = [[40, 60], [80, 60]]\n";
    expect_fault(line + "rise = 3\n", 1, "needs a radius");
    expect_fault(line + "radius = 9\n", 1, "needs a rise");
    expect_fault(line + "radius = 9\nrise = 6\n", 3,
                 "flanks would be steeper than 1 : 1.25; at least 10.0 m");
    expect_fault(line + "radius = 9\nrise = 31\n", 4, "outside -30 to 30");
    expect_fault(
        "[[dam]]\npoints = [[1, 60], [150, 60], [1, 61], [150, 62], [1, 63], [150, 64], [1, 65], [150, 66]]\n"
        "radius = 1\nrise = 0.5\n",
        2, "more than 2000 strokes");
}

TEST_F(Placed, earth_has_a_budget_if_the_scene_gives_one) {
    EXPECT_EQ(standing("[earth]\nbudget = 15000\n").earth_budget, 15000);
    EXPECT_EQ(standing("[[house]]\nat = [80, 40]\n").earth_budget, -1);
    const std::string dam = "[[dam]]\npoints = [[40, 60], [80, 60]]\nradius = 15\nrise = 6\n";
    expect_fault(dam + "[earth]\nbudget = 1000\n", 6,
                 "budget is 1000.0 m³, and the scene's own [[dam]] needs ");
    EXPECT_EQ(standing(dam + "[earth]\nbudget = 10000\n").earth_budget, 10000);
    expect_fault("[earth]\nbudget = -1\n", 2, "budget is -1");
    expect_fault("[earth]\n", 1, "needs a budget");
}

TEST_F(Placed, more_than_two_thousand_are_refused) {
    std::string many;
    for (int i = 0; i <= static_cast<int>(kMostPlaced); ++i)
        many += fmt::format("[[house]]\nat = [{}, {}]\n", i % 150, i / 15);
    expect_fault(many, 2 * static_cast<int>(kMostPlaced) + 1, "at most 2000 pieces");
    std::string vast;
    for (int i = 0; i < 30'000; ++i) vast += "[[house]]\nat=[1,2]\n";
    const auto refused = load(vast);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Failure::kUnusable);
    EXPECT_NE(refused.error().sentence.find("trial.toml:"), std::string::npos) << refused.error().sentence;
}

// Some lines of text must not cost minutes. Refused by counting, before anything is done.
TEST_F(Placed, what_would_visit_too_many_vertices_is_refused_with_its_line) {
    std::string zigzag = "[[dam]]\nradius = 80\nrise = 1\npoints = [";
    for (int i = 0; i < 180; ++i) zigzag += fmt::format("[{}, {}],", i % 2 ? 1 : 159, 1 + 0.85 * i);
    zigzag += "]\n";
    EXPECT_TRUE(load(zigzag, 128)) << "on a coarse grid it is a dam like any other";
    const auto refused = load(zigzag, 1024);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Failure::kUnusable);
    EXPECT_NE(refused.error().sentence.find("trial.toml:7: "), std::string::npos) << refused.error().sentence;
    EXPECT_NE(refused.error().sentence.find("67108864"), std::string::npos) << refused.error().sentence;

    const std::string forest = "[[forest]]\npolygon = [[15, 15], [45, 15], [45, 35]]\n";
    std::string forests;
    for (int i = 0; i < 1000; ++i) forests += forest;
    EXPECT_TRUE(load(forests, 128));
    const auto much = load(forests, 1024);
    ASSERT_FALSE(much);
    EXPECT_NE(much.error().sentence.find("too much forest"), std::string::npos) << much.error().sentence;

    std::string roads = forest;
    for (int i = 0; i < 8; ++i)
        roads += fmt::format("[[road]]\nwidth = 30\npoints = [[1, {0}], [159, {0}]]\n", 1 + i);
    EXPECT_TRUE(load(roads));
    const auto fine = load(roads, 1024);
    ASSERT_FALSE(fine);
    EXPECT_NE(fine.error().sentence.find("too much road"), std::string::npos) << fine.error().sentence;
}

TEST_F(Placed, commands_of_one_tick_that_visit_too_many_vertices_are_refused) {
    std::string strokes;
    for (int i = 0; i < 256; ++i)
        strokes += "[[command]]\nat = 0\nsmooth = { x = 80, y = 80, radius = 100000, rise = 1 }\n";
    const auto path = folder_.path() / "strokes.toml";
    write_bytes(path, kSlope + strokes);
    const auto run = [&](const char* squares) {
        return couloir({"run", path.string(), "--grid", squares, "--seconds", "0.02"});
    };
    EXPECT_EQ(run("64").status, 0);
    const Finished refused = run("512");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("tick 0: "), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("67371264 vertices"), std::string::npos) << refused.err;
}

TEST_F(Placed, commands_of_a_scene_may_act_on_some_slopes_only) {
    const auto scene = load(
        "[[command]]\nat = 1\nplant = { x = 80, y = 40, radius = 20, stems = 400, diameter = 0.3, height = "
        "22, slope = "
        "[30, 45] }\n");
    ASSERT_TRUE(scene) << scene.error().sentence;
    ASSERT_EQ(scene->commands.size(), 1u);
    EXPECT_EQ(scene->commands[0].command.least_slope, 30);
    EXPECT_EQ(scene->commands[0].command.most_slope, 45);
    for (const char* wrong : {"[45, 30]", "[30, 30]", "[-1, 30]", "[30, 91]", "[30]", "30", "[\"a\", 3]"})
        fault(
            fmt::format("[[command]]\nat = 1\nfell = {{ x = 80, y = 40, radius = 20, slope = {} }}\n", wrong),
            3);
    expect_fault("[[command]]\nat = 1\nremove = { x = 80, y = 40, radius = 20, slope = [0, 9] }\n", 3,
                 "slope is not a known key");
}

}  // namespace
}  // namespace game::test
