#include "game/scene/date.h"
#include "game/scene/scene.h"

#include <filesystem>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/recording/recording_file.h"
#include "game/scene/mountains.h"
#include "game/scene/scene_file.h"
#include "game/scene/week.h"
#include "game/session/session.h"
#include "tests/game/program.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"

namespace game::test {
namespace {

constexpr const char* kScene = R"(title = "A trial"
[terrain]
generator = "slope-of-soil"
grid = 16
[cover]
material = "soil"
[physics]
model = "bcre-inertial"
borders = "open"
[[command]]
at = 1.5
pour = { x = 80, y = 138, radius = 9, rate = 38, duration = 1 }
[camera]
target = [80, 72, -48]
[light]
azimuth = 255
)";

class SceneFile : public testing::Test {
  protected:
    SceneFile() : path_(folder_.path() / "trial.toml") {}

    Outcome<Scene> load(const std::string& text, const Overrides& overrides = {}) {
        write_bytes(path_, text);
        return load_scene(path_.string(), overrides);
    }
    static std::string with(const std::string& old_text, const std::string& new_text) {
        std::string text = kScene;
        const auto at = text.find(old_text);
        EXPECT_NE(at, std::string::npos) << old_text;
        return text.replace(at, old_text.size(), new_text);
    }

    support::TemporaryFolder folder_;
    std::filesystem::path path_;
};

TEST(Dates, are_found_from_the_day_of_the_year_and_back) {
    for (int day = 0; day < 366; ++day) EXPECT_EQ(render::day_of_year(date_of(day)), day + 1);
    EXPECT_EQ(to_string(date_of(0)), "01-01");
    EXPECT_EQ(to_string(date_of(366 + 59)), "02-29");
    EXPECT_EQ(to_string(date_of(335)), "12-01");
}

TEST(ShippedScenes, are_recorded_in_files_that_can_be_read) {
    const support::TemporaryFolder folder;
    const auto names = asset_names(AssetKind::kScene).value();
    for (const std::string& name : names)
        for (const bool own_grid : {true, false}) {
            Overrides overrides;
            if (!own_grid) overrides.squares = 32;
            const Scene scene = load_scene(name, overrides).value();
            if (scene.scenario.flow && own_grid) continue;
            const std::filesystem::path path = folder.path() / fmt::format("{}_{}.couloir", name, own_grid);
            auto recorder = record_into(path, scene.scenario);
            ASSERT_TRUE(recorder) << recorder.error().sentence;
            auto session = Session::begin(scene.scenario, {}, std::move(*recorder)).value();
            for (int tick = 0; tick < 3; ++tick) ASSERT_TRUE(session.advance({})) << name;
            ASSERT_TRUE(session.finish());

            const auto recording = read_recording(path);
            ASSERT_TRUE(recording) << name << ": " << recording.error().sentence;
            EXPECT_FALSE(recording->warning) << name;
            auto again = Session::begin(recording->header.scenario, {}, std::nullopt).value();
            for (int tick = 0; tick < 3; ++tick) ASSERT_TRUE(again.advance({})) << name;
            EXPECT_EQ(again.state_line().hash, session.state_line().hash) << name;
        }
}

TEST(ShippedScenes, load_on_their_own_grid_and_on_a_coarser_one) {
    const auto names = asset_names(AssetKind::kScene).value();
    ASSERT_GE(names.size(), 2u);
    for (const std::string& name : names) {
        const auto own = load_scene(name, {});
        ASSERT_TRUE(own) << own.error().sentence;
        EXPECT_EQ(own->scenario.scene, name);
        // Empty until the user acts, or a flow, on which nothing else happens. A challenge may be either.
        if (!own->scenario.goal) {
            EXPECT_EQ(own->commands.empty(), name == "alpine-valley" || name == "winter-valley" ||
                                                 name == "couloir" || own->scenario.flow);
        }
        Overrides coarse;
        coarse.squares = 16;
        const auto coarser = load_scene(name, coarse);
        ASSERT_TRUE(coarser) << coarser.error().sentence;
        const sim::Grid &fine = own->scenario.grid, &grid = coarser->scenario.grid;
        EXPECT_EQ(std::max(grid.nx, grid.ny), 17);
        EXPECT_GT(std::max(fine.nx, fine.ny), 17);
        // The domain stays; only the cell size changes.
        EXPECT_FLOAT_EQ(grid.dx * 16, fine.dx * static_cast<float>(std::max(fine.nx, fine.ny) - 1));
        EXPECT_EQ(coarser->scenario.params, own->scenario.params);
    }
}

TEST_F(SceneFile, is_read_with_its_terrain_material_commands_and_view) {
    const auto scene = load(kScene);
    ASSERT_TRUE(scene) << scene.error().sentence;
    EXPECT_EQ(scene->scenario.title, "A trial");
    EXPECT_EQ(scene->scenario.material, "soil");
    EXPECT_EQ(scene->scenario.grid.nx, 17);
    ASSERT_EQ(scene->commands.size(), 1u);
    EXPECT_EQ(scene->commands[0].tick, 90);
    EXPECT_EQ(scene->commands[0].command.rate, 38);
    ASSERT_TRUE(scene->scenario.camera);
    EXPECT_EQ(scene->scenario.camera->target.z, -48);
    EXPECT_EQ(scene->scenario.light.azimuth_deg, 255);
}

TEST(Week, is_that_of_iso_8601) {
    using namespace std::chrono;
    const auto week = [](int y, unsigned m, unsigned d) { return week_of(year(y) / month(m) / day(d)); };
    EXPECT_EQ(week(2026, 11, 29), 202648);  // a Sunday
    EXPECT_EQ(week(2026, 11, 30), 202649);
    EXPECT_EQ(week(2026, 12, 31), 202653);
    EXPECT_EQ(week(2027, 1, 3), 202653);
    EXPECT_EQ(week(2027, 1, 4), 202701);
    EXPECT_EQ(week(2024, 12, 30), 202501);
}

TEST_F(SceneFile, of_a_week_has_the_ground_of_the_week_of_who_plays) {
    const std::string rest =
        "[terrain]\ngenerator = \"massif\"\ngrid = 16\nseed = 5\n[cover]\nmaterial = "
        "\"soil\"\n[physics]\nmodel = \"bcre\"\n";
    const auto ground = [&](const std::string& words, std::optional<std::int64_t> week) {
        Overrides overrides;
        overrides.week = week;
        const auto scene = load(words + rest, overrides);
        EXPECT_TRUE(scene) << scene.error().sentence;
        return scene ? scene->scenario.bedrock : decltype(scene->scenario.bedrock){};
    };
    const auto own = ground("", std::nullopt);
    EXPECT_EQ(ground("", 202649), own);
    EXPECT_EQ(ground("weekly = true\n", std::nullopt), own);
    const auto of_week = ground("weekly = true\n", 202649);
    EXPECT_NE(of_week, own);
    EXPECT_EQ(ground("weekly = true\n", 202649), of_week);
    EXPECT_NE(ground("weekly = true\n", 202650), of_week);
    const auto no_seed = load("weekly = true\n[terrain]\nfile = \"a.tif\"\ngrid = 16\n");
    ASSERT_FALSE(no_seed);
    EXPECT_NE(no_seed.error().sentence.find("weekly"), std::string::npos) << no_seed.error().sentence;
}

class HarderScene : public SceneFile {
  protected:
    static constexpr const char* kGoal = R"([goal]
say = "Move it."
medals = [1, 2, 3]
latest = 20
[[goal.tool]]
command = "blast"
count = 3
radius = 9
depth = 1
[[goal.score]]
measure = "eroded"
)";
    HarderScene() { write_bytes(folder_.path() / "easy.toml", std::string(kScene) + kGoal); }

    // The sentence without the folder.
    std::string fault_of(const std::string& text) {
        const auto scene = load(text);
        if (scene) return "none";
        std::string sentence = scene.error().sentence;
        const std::string folder = folder_.path().string() + "/";
        for (auto at = sentence.find(folder); at != std::string::npos; at = sentence.find(folder))
            sentence.erase(at, folder.size());
        return sentence;
    }
};

TEST_F(HarderScene, has_all_of_the_other_one_but_what_it_states) {
    const auto easy = load_scene((folder_.path() / "easy.toml").string(), {});
    ASSERT_TRUE(easy) << easy.error().sentence;
    const auto hard = load(R"(harder_than = "easy"
title = "Harder"
[goal]
medals = [10, 20, 30]
[[goal.tool]]
command = "blast"
count = 1
radius = 4
depth = 1
)");
    ASSERT_TRUE(hard) << hard.error().sentence;
    EXPECT_EQ(hard->scenario.scene, "trial");
    EXPECT_EQ(hard->scenario.title, "Harder");
    EXPECT_EQ(hard->files.size(), easy->files.size() + 1);
    EXPECT_EQ(ground_hash(hard->scenario), ground_hash(easy->scenario));
    EXPECT_EQ(hard->commands, easy->commands);
    Goal expected = *easy->scenario.goal;
    expected.medals = {10, 20, 30};
    expected.tools.front().count = 1;
    expected.tools.front().limits.front().least = expected.tools.front().limits.front().most = 4;
    EXPECT_EQ(*hard->scenario.goal, expected);
}

TEST_F(HarderScene, blames_the_file_that_a_fault_is_in) {
    EXPECT_EQ(fault_of("harder_than = \"easy\"\n[goal]\nmedals = 3\n"),
              "trial.toml:3: goal.medals is not a list of 3 numbers");
    write_bytes(folder_.path() / "easy.toml", std::string(kScene) + kGoal + "sum = 1\n");
    EXPECT_EQ(fault_of("harder_than = \"easy\"\n"),
              "trial.toml: is harder than \"easy\": easy.toml:28: score.sum is not a known key");
}

TEST_F(HarderScene, is_one_step_harder_than_the_other_one_unless_it_states_its_difficulty) {
    write_bytes(folder_.path() / "easy.toml",
                "about = \"It moves.\"\ndifficulty = 3\n" + std::string(kScene) + kGoal);
    const auto read = [&](const std::string& text) {
        write_bytes(folder_.path() / "trial.toml", text);
        return read_scene_file(folder_.path() / "trial.toml").value();
    };
    EXPECT_EQ(read("harder_than = \"easy\"\n").difficulty, 4);
    EXPECT_EQ(read("harder_than = \"easy\"\ndifficulty = 2\n").difficulty, 2);
    EXPECT_EQ(read("about = \"A hill.\"\n" + std::string(kScene)).about, "A hill.");
    EXPECT_EQ(fault_of("harder_than = \"easy\"\n"), "none") << "the world knows nothing of it";
}

TEST_F(HarderScene, refuses_words_for_people_that_are_none) {
    const std::string long_text(201, 'a');
    EXPECT_EQ(fault_of("about = 3\n"), "trial.toml:1: about is not a string in quotes");
    EXPECT_EQ(fault_of("about = \"" + long_text + "\"\n"), "trial.toml:1: about has more than 200 bytes");
    EXPECT_EQ(fault_of("harder_than = \"easy\"\ndifficulty = 5\n"),
              "trial.toml:2: difficulty is 5, outside 1 to 4");
    EXPECT_EQ(fault_of("difficulty = 1\n" + std::string(kScene)),
              "trial.toml:1: difficulty is of a challenge, but the scene has no [goal]");
}

TEST_F(HarderScene, is_harder_than_a_challenge_that_ships_or_is_beside_it_and_is_no_chain) {
    EXPECT_EQ(fault_of("harder_than = 3\n"), "trial.toml:1: harder_than is not a string in quotes");
    EXPECT_EQ(fault_of("\nharder_than = \"none\"\n"),
              "trial.toml:2: harder_than is \"none\", which neither ships nor is none.toml beside this file");
    EXPECT_EQ(fault_of("harder_than = \"../easy\"\n"),
              "trial.toml:1: harder_than is not the name of a scene");
    EXPECT_EQ(fault_of("harder_than = \"landslide\"\n"),
              "trial.toml:1: harder_than is \"landslide\", which is no challenge");
    EXPECT_EQ(fault_of("harder_than = \"trial\"\n"),
              "trial.toml:1: harder_than is \"trial\", which is harder than another one itself");
    EXPECT_EQ(fault_of("harder_than = \"one-shovel\"\ntitle = \"A\"\n"), "none");
}

TEST_F(SceneFile, applies_its_own_parameters_to_its_own_model_only) {
    const std::string text = with("borders = \"open\"", "borders = \"wall\"\ndrag = 750");
    const auto own = load(text);
    ASSERT_TRUE(own) << own.error().sentence;
    EXPECT_EQ(own->scenario.params.drag, 750.f);
    EXPECT_EQ(own->scenario.params.borders[sim::kEast], sim::Border::kWall);
    Overrides other;
    other.model = sim::Model::kBcre;
    const auto bcre = load(text, other);
    ASSERT_TRUE(bcre) << bcre.error().sentence;
    EXPECT_EQ(bcre->scenario.params.model, sim::Model::kBcre);
    EXPECT_NE(bcre->scenario.params.drag, 750.f);
}

TEST_F(SceneFile, is_a_landscape_unless_its_style_is_model) {
    const auto is_model = [this](const std::string& look) {
        const auto scene = load(with("[light]", look + "[light]"));
        EXPECT_TRUE(scene) << scene.error().sentence;
        return scene && scene->scenario.model;
    };
    EXPECT_FALSE(is_model(""));
    EXPECT_FALSE(is_model("[look]\nstyle = \"landscape\"\n"));
    EXPECT_TRUE(is_model("[look]\nstyle = \"model\"\n"));
}

TEST_F(SceneFile, shows_plants_as_on_its_date) {
    const auto date = [this](const std::string& look) {
        const auto scene = load(with("[light]", look + "[light]"));
        EXPECT_TRUE(scene) << scene.error().sentence;
        return scene ? scene->scenario.look.date : std::nullopt;
    };
    EXPECT_EQ(date(""), std::nullopt);
    EXPECT_EQ(date("[look]\ndate = \"07-15\"\n"), (render::Date{7, 15}));
    EXPECT_EQ(date("[look]\ndate = \"02-29\"\n"), (render::Date{2, 29}));
}

TEST_F(SceneFile, has_trees_only_if_it_asks_for_them) {
    const auto trees = [this](const std::string& table) {
        const auto scene = load(with("[light]", table + "[light]"));
        EXPECT_TRUE(scene) << scene.error().sentence;
        return scene ? scene->scenario.trees : render::TreeRules();
    };
    EXPECT_EQ(trees("").density, 0);
    EXPECT_EQ(trees("[trees]\ndensity = 200\ntree_line = 1650\nseed = 9\n"),
              (render::TreeRules{.density = 200, .line_m = 1650, .seed = 9}));
    EXPECT_EQ(trees("[trees]\ndensity = 200\n"), (render::TreeRules{.density = 200}));
}

TEST_F(SceneFile, has_what_people_built_and_refuses_it_off_the_terrain) {
    const auto built = [this](const std::string& tables) {
        return load(with("[light]", tables + "[light]"));
    };
    EXPECT_TRUE(built("")->scenario.standing.empty());
    const auto scene = built(
        "[[house]]\nat = [80, 40]\nheading = 190\n[[road]]\npoints = [[20, 20], [90, 25]]\nwidth = 5\n"
        "[[lift]]\nfrom = [120, 30]\nto = [120, 130]\n");
    ASSERT_TRUE(scene) << scene.error().sentence;
    std::vector<sim::CommandKind> kinds;
    for (const sim::Command& each : scene->scenario.standing.placed) kinds.push_back(each.kind);
    EXPECT_EQ(kinds,
              (std::vector{sim::CommandKind::kHouse, sim::CommandKind::kRoad, sim::CommandKind::kLift}));

    const auto outside = built("[[house]]\nat = [80, 400]\n");
    ASSERT_FALSE(outside);
    EXPECT_NE(outside.error().sentence.find("at (80, 400) is outside the terrain"), std::string::npos)
        << outside.error().sentence;
    std::string many;
    for (int i = 0; i < 9; ++i) many += "[[lift]]\nfrom = [120, 30]\nto = [120, 130]\n";
    ASSERT_FALSE(built(many));
    EXPECT_NE(built(many).error().sentence.find("at most 8"), std::string::npos);
}

TEST_F(SceneFile, has_wind_only_if_it_asks_for_it) {
    const auto wind = [this](const std::string& table) {
        const auto scene = load(with("[light]", table + "[light]"));
        EXPECT_TRUE(scene) << scene.error().sentence;
        return scene ? scene->scenario.wind : render::Wind{90, 90};
    };
    EXPECT_EQ(wind("").speed, 0);
    EXPECT_EQ(wind("[wind]\nfrom = 290\nspeed = 7.5\n"), (render::Wind{290, 7.5}));
    EXPECT_EQ(wind("[wind]\nfrom = -90\nspeed = 60\n"), (render::Wind{-90, 60}));
}

TEST_F(SceneFile, may_say_within_which_polygon_trees_grow) {
    const auto scene =
        load(with("[light]", "[trees]\ndensity = 200\npolygon = [[10, 20], [90.5, 20], [50, 100]]\n[light]"));
    ASSERT_TRUE(scene) << scene.error().sentence;
    EXPECT_EQ(scene->scenario.trees.polygon, (std::vector<glm::dvec2>{{10, 20}, {90.5, 20}, {50, 100}}));
    const auto beside =
        load(with("[light]", "[trees]\ndensity = 200\npolygon = [[10, 20], [161, 20], [50, 99]]\n[light]"));
    ASSERT_FALSE(beside);
    EXPECT_NE(beside.error().sentence.find("corner 2"), std::string::npos) << beside.error().sentence;
}

class TreesOfRaster : public SceneFile {
  protected:
    // Shares that grow toward the east, of `side` × `side` vertices.
    void write_raster(int side, double cell, double most = 1, double left = 0,
                      const char* name = "wood.asc") {
        std::string asc =
            fmt::format("ncols {0}\nnrows {0}\nxllcorner {2}\nyllcorner 0\ncellsize {1}\n", side, cell, left);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) asc += fmt::format("{} ", most * x / (side - 1));
        write_bytes(folder_.path() / name, asc + "\n");
    }
    Outcome<Scene> load_with(const std::string& raster, const Overrides& overrides = {}) {
        return load(with("[light]", "[trees]\ndensity = 200\nraster = \"" + raster + "\"\n[light]"),
                    overrides);
    }
    // What is wrong with a raster.
    std::string fault(const std::string& raster = "wood.asc") {
        const auto scene = load_with(raster);
        EXPECT_FALSE(scene);
        return scene ? "" : scene.error().sentence;
    }
};

TEST_F(TreesOfRaster, grow_by_its_shares_on_any_number_of_squares) {
    write_raster(17, 10);
    for (const int squares : {16, 32}) {
        Overrides overrides;
        overrides.squares = squares;
        const auto scene = load_with("wood.asc", overrides);
        ASSERT_TRUE(scene) << scene.error().sentence;
        const auto& shares = scene->scenario.trees.shares;
        const auto side = static_cast<std::size_t>(squares) + 1;
        ASSERT_EQ(shares.size(), side * side);
        EXPECT_EQ(shares.front(), 0);
        EXPECT_NEAR(shares[side / 2], 128, 1);
        EXPECT_EQ(shares.back(), 255);
        EXPECT_EQ(scene->files.back().filename(), "wood.asc");
    }
}

TEST_F(TreesOfRaster, are_refused_in_one_sentence_if_it_does_not_fit) {
    write_raster(9, 10);
    EXPECT_NE(fault().find("17 × 17"), std::string::npos) << fault();
    write_raster(17, 10, 3);
    EXPECT_NE(fault().find("0 to 1"), std::string::npos) << fault();
    EXPECT_NE(fault("none.asc").find("none.asc"), std::string::npos) << fault("none.asc");
    EXPECT_NE(fault("../wood.asc").find("outside the scene's folder"), std::string::npos);
}

TEST_F(TreesOfRaster, are_refused_if_it_lies_elsewhere) {
    write_raster(17, 10, 60, 5000, "hill.asc");  // the terrain
    const std::string scene = [] {
        std::string text = with("generator = \"slope-of-soil\"", "file = \"hill.asc\"");
        const std::string light = "[light]";
        return text.replace(text.find(light), light.size(),
                            "[trees]\ndensity = 200\nraster = \"wood.asc\"\n[light]");
    }();
    write_raster(17, 10, 1, 5000);
    EXPECT_TRUE(load(scene)) << load(scene).error().sentence;
    write_raster(17, 10, 1, 5006);
    ASSERT_FALSE(load(scene));
    const std::string fault = load(scene).error().sentence;
    EXPECT_NE(fault.find("wood.asc"), std::string::npos) << fault;
    EXPECT_NE(fault.find("same place"), std::string::npos) << fault;
}

TEST_F(SceneFile, says_that_there_is_no_place_for_its_trees_or_that_some_are_left_out) {
    const auto notice = [this](const std::string& table) {
        const auto scene = load(with("[light]", table + "[light]"));
        EXPECT_TRUE(scene) << scene.error().sentence;
        return woods_notice(scene->scenario, woods_on(scene->scenario, mountains_around(scene->scenario)));
    };
    EXPECT_EQ(notice(""), "");
    EXPECT_EQ(notice("[trees]\ndensity = 20\n"), "");
    EXPECT_NE(notice("[trees]\ndensity = 20\ntree_line = -5000\n").find("no place"), std::string::npos);
    EXPECT_NE(notice("[trees]\ndensity = 1000000\n").find("smaller [trees] density"), std::string::npos);
}

TEST_F(SceneFile, sorts_its_commands_by_time) {
    const auto scene = load(with(
        "[camera]", "[[command]]\nat = 0.25\nblast = { x = 1, y = 2, radius = 3, depth = 0.5 }\n[camera]"));
    ASSERT_TRUE(scene) << scene.error().sentence;
    ASSERT_EQ(scene->commands.size(), 2u);
    EXPECT_EQ(scene->commands[0].tick, 15);
    EXPECT_EQ(scene->commands[0].command.kind, sim::CommandKind::kBlast);
    EXPECT_EQ(scene->commands[0].command.depth, 0.5);
}

struct Fault {
    const char *old_text, *new_text;
    int line;
    const char* key;  // or the fact, if the fault is in a whole table
};

constexpr Fault kFaults[] = {
    // Unknown keys, in every table.
    {"grid = 16", "grid = 16\ngrids = 3", 5, "terrain.grids"},
    {"material = \"soil\"", "material = \"soil\"\ncolour = 3", 7, "cover.colour"},
    {"borders = \"open\"", "borders = \"open\"\ngravity = 9.8", 10, "physics.gravity"},
    {"borders = \"open\"", "borders = \"open\"\nrolling_speed = 3", 10, "physics.rolling_speed"},  // of bcre
    {"at = 1.5", "at = 1.5\nwhen = 3", 12, "command.when"},
    {"radius = 9", "radius = 9, size = 3", 12, "pour.size"},
    {"azimuth = 255", "azimuth = 255\ncolour = 3", 17, "light.colour"},
    {"target = [80, 72, -48]", "target = [80, 72, -48]\nroll = 3", 15, "camera.roll"},
    {"[light]", "[goals]\nx = 1\n[light]", 15, "goals"},
    {"[light]", "[look]\ncolour = 3\n[light]", 16, "look.colour"},
    {"[light]", "[trees]\ndensity = 100\nspecies = 3\n[light]", 17, "trees.species"},
    {"[light]", "[[house]]\nat = [80, 80]\nstoreys = 3\n[light]", 17, "house.storeys"},
    {"[light]", "[[road]]\npoints = [[8, 8], [9, 9]]\nlanes = 3\n[light]", 17, "road.lanes"},
    {"[light]", "[[lift]]\nfrom = [10, 10]\nto = [10, 90]\nseats = 6\n[light]", 18, "lift.seats"},
    {"[light]", "[wind]\nfrom = 1\nspeed = 2\ngusts = 3\n[light]", 18, "wind.gusts"},
    // Wrong kinds.
    {"[light]", "[[house]]\nat = [80, \"x\"]\n[light]", 16, "house.at is not a place"},
    {"[light]", "[[house]]\nat = [80, nan]\n[light]", 16, "house.at is not a place"},
    {"[light]", "[house]\nat = [80, 80]\n[light]", 15, "house is not a list of tables"},
    {"[light]", "[[road]]\npoints = [8, 9]\n[light]", 16, "road.points is not a list of places"},
    {"title = \"A trial\"", "title = 3", 1, "title"},
    {"grid = 16", "grid = 16.5", 4, "terrain.grid"},
    {"grid = 16", "grid = \"16\"", 4, "terrain.grid"},
    {"material = \"soil\"", "material = 3", 6, "cover.material"},
    {"borders = \"open\"", "borders = \"open\"\ndrag = \"fast\"", 10, "physics.drag"},
    {"at = 1.5", "at = \"noon\"", 11, "command.at"},
    {"radius = 9", "radius = [9]", 12, "pour.radius"},
    {"[80, 72, -48]", "[80, 72]", 14, "camera.target"},
    {"[80, 72, -48]", "[80, 72, \"x\"]", 14, "camera.target"},
    {"[[command]]", "[command]", 10, "command"},
    {"[light]", "[look]\nstyle = true\n[light]", 16, "look.style"},
    // Out of range.
    {"[light]", "[[house]]\nat = [1e8, 80]\n[light]", 16, "house.at is not a place"},
    {"[light]", "[[house]]\nat = [80, 80]\nheading = 361\n[light]", 17, "house.heading"},
    {"[light]", "[[road]]\npoints = [[8, 9]]\n[light]", 16, "road.points has 1 places; 2 to 200"},
    {"[light]", "[[road]]\npoints = [[8, 9], [8, 9]]\n[light]", 16, "road.points has the same place twice"},
    {"[light]", "[[road]]\npoints = [[8, 9], [18, 9]]\nwidth = 1\n[light]", 17, "road.width"},
    {"[light]", "[[lift]]\nfrom = [10, 10]\nto = [10, 11]\n[light]", 17, "lift.to is 1 m away; 60 to 5000 m"},
    {"[light]", "[trees]\ndensity = -1\n[light]", 16, "trees.density"},
    {"[light]", "[trees]\ndensity = 1000001\n[light]", 16, "trees.density"},
    {"[light]", "[trees]\ndensity = 100\ntree_line = 9001\n[light]", 17, "trees.tree_line"},
    {"[light]", "[trees]\ndensity = 100\nseed = -1\n[light]", 17, "trees.seed"},
    {"[light]", "[wind]\nfrom = 1\nspeed = 1000\n[light]", 17, "wind.speed"},
    {"[light]", "[wind]\nfrom = 1\nspeed = -1\n[light]", 17, "wind.speed"},
    {"[light]", "[wind]\nfrom = 1\nspeed = nan\n[light]", 17, "wind.speed"},
    {"[light]", "[wind]\nfrom = 361\nspeed = 1\n[light]", 16, "wind.from"},
    {"[light]", "[trees]\ndensity = 100\npolygon = [[1, 2], [3, 4]]\n[light]", 17, "trees.polygon"},
    {"[light]", "[trees]\ndensity = 100\npolygon = [[1, 2], [3, 4], [5]]\n[light]", 17,
     "trees.polygon is not a list of places"},
    {"[light]", "[trees]\ndensity = 100\npolygon = [[1, 2], [3, 4], [5, nan]]\n[light]", 17,
     "trees.polygon is not a list of places"},
    {"[light]", "[trees]\ndensity = 9\npolygon = [[0, 0], [9, 9], [9, 0], [0, 9]]\n[light]", 17,
     "trees.polygon crosses itself"},
    {"grid = 16", "grid = 7", 4, "terrain.grid"},
    {"grid = 16", "grid = 4097", 4, "terrain.grid"},
    {"grid = 16", "grid = 16\nsteep = 46", 5, "terrain.steep"},
    {"borders = \"open\"", "borders = \"open\"\ncourant = 0.6", 10, "physics.courant"},
    {"borders = \"open\"", "borders = \"open\"\ncourant = nan", 10, "physics.courant"},
    {"borders = \"open\"", "borders = \"open\"\nstop_angle = 85", 10, "physics.stop_angle"},
    {"at = 1.5", "at = -1", 11, "command.at"},
    {"radius = 9", "radius = -9", 12, "pour.radius"},
    {"rate = 38", "rate = inf", 12, "pour.rate"},
    {"azimuth = 255", "elevation = -19", 16, "light.elevation"},
    {"azimuth = 255", "time = 1899-12-31T23:59:59Z", 16,
     "light.time is in the year 1899, outside 1900 to 2100"},
    {"azimuth = 255", "time = 2101-01-01T00:00:00Z", 16,
     "light.time is in the year 2101, outside 1900 to 2100"},
    {"azimuth = 255", "latitude = 90.1\nlongitude = 11\ntime = 2026-02-14T08:30:00Z", 16, "light.latitude"},
    {"azimuth = 255", "latitude = 47\nlongitude = 181\ntime = 2026-02-14T08:30:00Z", 17, "light.longitude"},
    // The sun by place and time.
    {"azimuth = 255", "time = \"noon\"", 16, "light.time is not a date and time"},
    {"azimuth = 255", "time = 2026-02-14", 16, "light.time is not a date and time"},
    {"azimuth = 255", "time = 2026-02-14T08:30:00", 16, "light.time has no offset"},
    {"azimuth = 255", "time = 2026-02-29T08:30:00Z", 16, ""},  // no such day
    {"azimuth = 255", "time = 2026-13-01T08:30:00Z", 16, ""},
    {"azimuth = 255", "time = 2026-02-14T24:30:00Z", 16, ""},
    {"azimuth = 255", "azimuth = 255\ntime = 2026-02-14T08:30:00Z", 16, "light.azimuth is given beside"},
    {"azimuth = 255", "elevation = 9\ntime = 2026-02-14T08:30:00Z", 16, "light.elevation is given beside"},
    {"azimuth = 255", "latitude = 47\nlongitude = 11", 16, "light.latitude is given without light.time"},
    {"azimuth = 255", "latitude = 47\ntime = 2026-02-14T08:30:00Z", 16, "light.latitude needs both"},
    {"azimuth = 255", "longitude = 11\ntime = 2026-02-14T08:30:00Z", 16, "light.longitude needs both"},
    {"azimuth = 255", "time = 2026-02-14T08:30:00Z", 15, "light needs latitude and longitude"},
    // Unknown names.
    {"\"slope-of-soil\"", "\"the-moon\"", 3, "terrain.generator"},
    {"\"soil\"", "\"cheese\"", 6, "cover.material"},
    {"\"bcre-inertial\"", "\"newton\"", 8, "physics.model"},
    {"\"open\"", "\"ajar\"", 9, "physics.borders"},
    {"\"open\"", "\"open\"\nscheme = \"upwind\"", 10, "physics.scheme"},
    {"[light]", "[look]\ndate = \"02-30\"\n[light]", 16,
     "look.date is no day of a year; write month and day, such as \"07-15\""},
    {"[light]", "[look]\ndate = \"7-15\"\n[light]", 16, "look.date is no day of a year"},
    {"[light]", "[look]\nstyle = \"cubist\"\n[light]", 16, "look.style is neither landscape nor model"},
    {"duration = 1", "duration = 1, as = \"flying\"", 12, "pour.as"},
    {"duration = 1", "duration = 1, profile = \"star\"", 12, "pour.profile"},
    // Missing.
    {"[light]", "[[house]]\nheading = 3\n[light]", 15, "house needs `at`"},
    {"[light]", "[[road]]\nwidth = 3\n[light]", 15, "road needs points"},
    {"[light]", "[[lift]]\nfrom = [8, 9]\n[light]", 15, "lift needs `from` and `to`"},
    {"[light]", "[trees]\nseed = 3\n[light]", 15, "trees needs a density"},
    {"[light]", "[wind]\nfrom = 3\n[light]", 15, "wind needs a speed"},
    {"[light]", "[wind]\nspeed = 3\n[light]", 15, "wind needs `from`"},
    {"grid = 16\n", "", 2, "terrain.grid"},
    {"generator = \"slope-of-soil\"\n", "", 2, "terrain needs"},
    {"material = \"soil\"\n", "", 5, "cover needs a material"},
    {"at = 1.5\n", "", 10, "command needs `at`"},
    {", rate = 38", "", 12, "pour needs rate"},
    {"pour = { x = 80, y = 138, radius = 9, rate = 38, duration = 1 }\n", "", 10,
     "command needs exactly one"},
    {"target = [80, 72, -48]\n", "", 13, "camera needs a target"},
    {"generator = \"slope-of-soil\"", "generator = \"slope-of-soil\"\nfile = \"x.asc\"", 2,
     "terrain needs either"},
    // Not TOML.
    {"grid = 16", "grid = ", 4, ""},
    {"[cover]", "[cover", 5, ""},
    {"grid = 16", "grid = 16\ngrid = 17", 5, ""},
};

TEST_F(SceneFile, with_a_fault_is_refused_with_file_line_and_key) {
    for (const Fault& fault : kFaults) {
        SCOPED_TRACE(std::string(fault.old_text) + " -> " + fault.new_text);
        const auto scene = load(with(fault.old_text, fault.new_text));
        if (scene) {
            ADD_FAILURE() << "accepted";
            continue;
        }
        EXPECT_EQ(scene.error().status, Failure::kUnusable);
        const std::string scenario = path_.string() + ":" + std::to_string(fault.line) + ": " + fault.key;
        EXPECT_EQ(scene.error().sentence.rfind(scenario, 0), 0u)
            << scene.error().sentence << "\nexpected " << scenario;
    }
}

TEST_F(SceneFile, without_a_section_is_refused_by_name) {
    const std::pair<const char*, const char*> sections[] = {
        {"[terrain]\ngenerator = \"slope-of-soil\"\ngrid = 16\n", "has no [terrain]"},
        {"[cover]\nmaterial = \"soil\"\n", "has no [cover]"},
        {"[physics]\nmodel = \"bcre-inertial\"\nborders = \"open\"\n", "has no [physics]"}};
    for (const auto& [section, fact] : sections) {
        const auto scene = load(with(section, ""));
        ASSERT_FALSE(scene);
        EXPECT_EQ(scene.error().sentence, path_.string() + ":1: " + fact);
    }
}

TEST_F(SceneFile, with_inconsistent_parameters_is_refused) {
    const auto scene = load(with("borders = \"open\"", "borders = \"open\"\nfriction = 1.5"));
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().sentence.rfind(path_.string() + ": ", 0), 0u) << scene.error().sentence;
    EXPECT_NE(scene.error().sentence.find("friction_thin"), std::string::npos) << scene.error().sentence;
}

TEST_F(SceneFile, finds_its_terrain_beside_it_and_applies_its_cover_rule) {
    std::string asc = "ncols 9\nnrows 9\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column)
            asc += std::to_string(1000 + 2 * (8 - row)) + (column == 8 ? "\n" : " ");
    write_bytes(folder_.path() / "hill.asc", asc);
    const std::string file = "file = \"hill.asc\"";
    const std::string rule = "material = \"soil\"\ndepth = 0.5\nabove = 1008\nfade = 0.5";
    std::string text = with("generator = \"slope-of-soil\"", file);
    text.replace(text.find("material = \"soil\""), 17, rule);
    text.replace(text.find("grid = 16"), 9, "grid = 8 ");
    const auto scene = load(text);
    ASSERT_TRUE(scene) << scene.error().sentence;
    const Scenario& scenario = scene->scenario;
    EXPECT_EQ(scenario.grid.nx, 9);
    EXPECT_EQ(scenario.depth[4], 0.f);                          // the south edge, at 1000 m
    EXPECT_EQ(scenario.depth[scenario.grid.size() - 5], 0.5f);  // the north edge, at 1016 m
    EXPECT_NEAR(scenario.datum + static_cast<double>(scenario.bedrock[scenario.grid.size() - 5]), 1016 - 0.5,
                1e-3);
}

constexpr const char* kPlace = "latitude = 39.742476\nlongitude = -105.1786\n";

// The example of the Solar Position Algorithm, see tests/render/sun_position.cpp.
TEST_F(SceneFile, lights_its_ground_by_place_and_time) {
    for (const char* time :
         {"2003-10-17T12:30:30-07:00", "2003-10-17T19:30:30Z", "2003-10-18T01:00:30.0+05:30"}) {
        const auto scene = load(with("azimuth = 255", std::string(kPlace) + "time = " + time));
        ASSERT_TRUE(scene) << scene.error().sentence;
        EXPECT_NEAR(scene->scenario.light.elevation_deg, 90 - 50.11162, 0.01) << time;
        EXPECT_NEAR(scene->scenario.light.azimuth_deg, 194.34024, 0.01) << time;
    }
}

TEST_F(SceneFile, of_a_flow_is_lit_by_place_and_time_too) {
    const std::string flow = "[flow]\nkind = \"disc\"\n[light]\ntime = 2003-10-17T12:30:30-07:00\n";
    const auto scene = load(flow + kPlace);
    ASSERT_TRUE(scene) << scene.error().sentence;
    EXPECT_NEAR(scene->scenario.light.azimuth_deg, 194.34024, 0.01);
    const auto nowhere = load(flow);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().sentence.rfind(path_.string() + ":3: light needs latitude", 0), 0u)
        << nowhere.error().sentence;
}

TEST_F(SceneFile, has_the_lowest_sun_at_any_time_of_a_deeper_night) {
    const auto scene = load(with("azimuth = 255", std::string(kPlace) + "time = 2003-10-17T00:30:00-07:00"));
    ASSERT_TRUE(scene) << scene.error().sentence;
    EXPECT_EQ(scene->scenario.light.elevation_deg, -18);
}

// The grid of a projected map is turned from north by the convergence of its meridians: here
// (11.416° − 9°) · sin 47.321°.
TEST_F(SceneFile, finds_the_place_of_its_sun_by_its_terrain) {
    std::string asc = "ncols 9\nnrows 9\nxllcorner 682563\nyllcorner 5243665\ncellsize 10\n";
    for (int row = 0; row < 9; ++row) asc += "1000 1000 1000 1000 1000 1000 1000 1000 1000\n";
    write_bytes(folder_.path() / "plain.asc", asc);
    write_bytes(folder_.path() / "plain.prj", terrains::test::utm_32n());
    std::string text = with("generator = \"slope-of-soil\"", "file = \"plain.asc\"");
    text.replace(text.find("grid = 16"), 9, "grid = 8 ");
    const std::string time = "time = 2026-02-14T08:30:00+01:00\n";
    const std::string by_terrain = text.replace(text.find("azimuth = 255"), 13, time);
    const auto here = load(by_terrain);
    ASSERT_TRUE(here) << here.error().sentence;
    const auto same = load(by_terrain + "latitude = 47.32137\nlongitude = 11.41665\n");
    ASSERT_TRUE(same) << same.error().sentence;
    const auto elsewhere = load(with("azimuth = 255", time + "latitude = 47.32137\nlongitude = 11.41665\n"));
    ASSERT_TRUE(elsewhere) << elsewhere.error().sentence;
    const render::Light sun = elsewhere->scenario.light;
    for (const auto& scene : {*here, *same}) {
        EXPECT_NEAR(scene.scenario.light.elevation_deg, sun.elevation_deg, 1e-3);
        EXPECT_NEAR(scene.scenario.light.azimuth_deg, sun.azimuth_deg - 1.777, 0.01);
    }
}

TEST_F(SceneFile, that_is_not_a_file_is_reported_as_such) {
    for (const char* name : {"no-such-scene", "no/such/scene.toml"}) {
        const auto scene = load_scene(name, {});
        ASSERT_FALSE(scene);
        EXPECT_EQ(scene.error().status, Failure::kUnusable);
        EXPECT_NE(scene.error().sentence.find(name), std::string::npos) << scene.error().sentence;
    }
    EXPECT_NE(load_scene("no-such-scene", {}).error().sentence.find("landslide"), std::string::npos);
}

}  // namespace
}  // namespace game::test
