// Worlds that are saved as they stand and begun again.
#include "game/session/world_now.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/files/shelf.h"
#include "game/recording/ground_data.h"
#include "game/recording/recording_file.h"
#include "game/session/loaded_world.h"
#include "game/session/sandbox.h"
#include "sim/world/quanta.h"
#include "tests/game/full_disk.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

Scenario read_back(const std::string& text) {
    std::istringstream stream(text);
    auto recording = read_recording(stream, "saved.couloir");
    EXPECT_TRUE(recording) << recording.error().sentence;
    if (!recording) return {};
    EXPECT_FALSE(recording->warning);
    EXPECT_TRUE(is_world(*recording));
    return recording->header.scenario;
}

// An object without what a new world forgets, to a millimetre.
std::string printed(sim::Thing thing) {
    std::ostringstream text;
    text << to_string(thing.kind);
    for (const double number : {thing.x, thing.y, thing.to_x, thing.to_y, thing.front_x, thing.front_y,
                                thing.length, thing.width, thing.height, thing.strength})
        text << ' ' << std::llrint(1000 * number);
    return text.str();
}

std::vector<std::string> objects_of(const sim::State& state, bool standing) {
    std::vector<std::string> objects;
    if (!state.things) return objects;
    for (const sim::Thing& thing : state.things->list)
        if (!standing || !thing.destroyed()) objects.push_back(printed(thing));
    return objects;
}

template <class Value>
bool same(const sim::Field<Value>& a, const sim::Field<Value>& b) {
    for (int y = 0; y < a.ny(); ++y)
        if (!std::equal(a.row(y), a.row(y) + a.nx(), b.row(y))) return false;
    return true;
}

// Saves a state, reads the file, and compares the world that it begins.
void expect_saved(const Scenario& initial, const sim::State& now) {
    const auto scenario = scenario_of_now(initial, now);
    ASSERT_TRUE(scenario) << scenario.error().sentence;
    const Scenario read = read_back(recording_of(*scenario));
    const sim::State begun = sim::make_state(initial_state_of(read), read.params);
    EXPECT_TRUE(same(begun.depth, now.depth));
    EXPECT_TRUE(same(begun.rolling, now.rolling));
    EXPECT_EQ(begun.ledger.initial, now.ledger.standing + now.ledger.rolling);
    EXPECT_EQ(begun.ledger.standing, now.ledger.standing);
    EXPECT_EQ(begun.ledger.mass_error(), 0);
    sim::Params params = begun.params;
    EXPECT_EQ(params, now.params);
    ASSERT_EQ(begun.mixture.has_value(), now.mixture.has_value());
    if (now.mixture) {
        EXPECT_TRUE(same(begun.mixture->untouched, now.mixture->untouched));
        EXPECT_TRUE(same(begun.mixture->settled, now.mixture->settled));
        EXPECT_TRUE(same(begun.mixture->rolling, now.mixture->rolling));
        EXPECT_EQ(begun.mixture->ledger.standing, now.mixture->ledger.standing);
        EXPECT_EQ(begun.mixture->ledger.rolling, now.mixture->ledger.rolling);
        EXPECT_EQ(begun.mixture->ledger.mass_error(), 0);
        EXPECT_EQ(begun.mixture->lower, now.mixture->lower);
    }
    const bool any_destroyed = now.things && std::ranges::any_of(now.things->list, &sim::Thing::destroyed);
    if (!any_destroyed) {
        EXPECT_TRUE(same(begun.bedrock, now.bedrock));
        EXPECT_EQ(objects_of(begun, false), objects_of(now, false));
    }
    if (!now.things) return;
    if (begun.things) {
        EXPECT_TRUE(same(begun.things->forest, now.things->forest));
        EXPECT_TRUE(same(begun.things->earth, now.things->earth));
        EXPECT_TRUE(same(begun.things->water, now.things->water));
        EXPECT_EQ(begun.things->budget, now.things->budget);
        EXPECT_EQ(sim::earth_used(*begun.things), sim::earth_used(*now.things));
        if (!any_destroyed) {
            EXPECT_TRUE(same(begun.things->wall_x, now.things->wall_x));
            EXPECT_TRUE(same(begun.things->drag, now.things->drag));
            for (std::size_t i = 0; i < now.things->list.size(); ++i) {
                EXPECT_EQ(begun.things->list[i].front_x, now.things->list[i].front_x) << i;
                EXPECT_EQ(begun.things->list[i].front_y, now.things->list[i].front_y) << i;
            }
        }
    } else {
        EXPECT_TRUE(now.things->list.empty());
    }
}

LoadedWorld loaded(Scene scene) {
    LoadedWorld world;
    world.scene = std::move(scene);
    return world;
}

Outcome<Scene> small(const char* name) {
    Overrides overrides;
    overrides.squares = 40;
    return load_scene(name, overrides);
}

class SavedWorld : public testing::TestWithParam<const char*> {};

TEST_P(SavedWorld, of_a_shipped_scene_is_the_state_that_was_saved) {
    auto scene = small(GetParam());
    ASSERT_TRUE(scene) << scene.error().sentence;
    auto sandbox = Sandbox::begin(loaded(*scene), {}, std::nullopt);
    ASSERT_TRUE(sandbox) << sandbox.error().sentence;
    expect_saved(sandbox->scenario(), sandbox->session().state());
    for (int tick = 0; tick < 300; ++tick) ASSERT_TRUE(sandbox->tick({}));
    EXPECT_GT(sandbox->session().state().tick, 0);
    expect_saved(sandbox->scenario(), sandbox->session().state());
}
INSTANTIATE_TEST_SUITE_P(Scenes, SavedWorld,
                         testing::Values("alpine-valley", "landslide", "protection", "snow-avalanche",
                                         "snow-on-soil", "winter-avalanche", "winter-valley", "three-charges",
                                         "the-dam", "open-at-five", "plant-the-forest"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

// Random work on a mountain: whatever cannot be done is left out.
class Worker {
  public:
    Worker(unsigned seed, const sim::Grid& grid, bool two_materials)
        : random_(seed),
          east_((grid.nx - 1) * static_cast<double>(grid.dx)),
          north_((grid.ny - 1) * static_cast<double>(grid.dx)),
          cell_(static_cast<double>(grid.dx)),
          two_materials_(two_materials) {}

    sim::Command next() {
        constexpr sim::CommandKind kKinds[] = {
            sim::CommandKind::kPour,   sim::CommandKind::kDig,    sim::CommandKind::kBlast,
            sim::CommandKind::kSculpt, sim::CommandKind::kSculpt, sim::CommandKind::kSmooth,
            sim::CommandKind::kPlant,  sim::CommandKind::kFell,   sim::CommandKind::kHouse,
            sim::CommandKind::kLift,   sim::CommandKind::kNet,    sim::CommandKind::kRoad,
            sim::CommandKind::kRemove, sim::CommandKind::kSet,    sim::CommandKind::kWet,
            sim::CommandKind::kWet,    sim::CommandKind::kDrain};
        sim::Command c;
        c.kind = kKinds[random_() % std::size(kKinds)];
        c.x = real(0, east_), c.y = real(0, north_), c.radius = real(cell_, 5 * cell_);
        c.to_x = std::clamp(c.x + real(-15, 15) * cell_, 0.0, east_);
        c.to_y = std::clamp(c.y + real(-15, 15) * cell_, 0.0, north_);
        const bool of_water = c.kind == sim::CommandKind::kWet || c.kind == sim::CommandKind::kDrain;
        c.rate = c.kind == sim::CommandKind::kPour ? 100 * cell_ : of_water ? sim::kMostRain : 1;
        c.duration = 0.5, c.depth = 2;
        c.layer = random_() % 2 ? sim::Layer::kStanding : sim::Layer::kRolling;
        c.profile = random_() % 2 ? sim::Profile::kCone : sim::Profile::kDisc;
        if (two_materials_ && random_() % 2) c.of = sim::Part::kLower;
        c.rise = c.kind == sim::CommandKind::kSculpt ? real(-6, 6) : 2;
        c.stems = std::rint(real(1, 2000)), c.diameter = real(0.1, 0.6);
        c.length = real(3, 30), c.width = real(3, 25), c.turn = real(-360, 360), c.strength = real(0.5, 20);
        c.height = c.kind == sim::CommandKind::kNet ? real(2, 6) : real(5, 30);
        c.param = sim::param_from("start_slope").value(), c.value = 0.72;
        return support::of_its_kind(c);
    }

  private:
    double real(double least, double most) {
        return least + (most - least) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    std::mt19937_64 random_;
    double east_, north_, cell_;
    bool two_materials_;
};

TEST(SavedWorlds, are_the_state_that_was_saved_after_random_work) {
    std::size_t objects = 0, destroyed = 0, woods = 0, wet = 0;
    std::int64_t earth = 0, mixed = 0;
    for (const char* name : {"winter-valley", "protection", "snow-on-soil", "landslide"})
        for (unsigned seed = 1; seed <= 3; ++seed) {
            SCOPED_TRACE(name + std::to_string(seed));
            auto scene = small(name);
            ASSERT_TRUE(scene) << scene.error().sentence;
            auto sandbox = Sandbox::begin(loaded(std::move(*scene)), {}, std::nullopt);
            ASSERT_TRUE(sandbox) << sandbox.error().sentence;
            Worker worker(seed, sandbox->scenario().grid, sandbox->scenario().lower.has_value());
            for (int tick = 0; tick < 240; ++tick) {
                const sim::Command command = worker.next();
                const auto done = sandbox->tick({&command, tick % 2 == 0 ? 1u : 0u});
                ASSERT_TRUE(done || done.error().status != Failure::kBadAnswer) << done.error().sentence;
                if (tick % 80 == 79) expect_saved(sandbox->scenario(), sandbox->session().state());
            }
            const sim::State& state = sandbox->session().state();
            ASSERT_TRUE(state.things);
            objects += state.things->list.size(), woods += state.things->wooded.size();
            destroyed +=
                static_cast<std::size_t>(std::ranges::count_if(state.things->list, &sim::Thing::destroyed));
            earth += sim::earth_used(*state.things), wet += !state.things->dry();
            if (state.mixture) mixed += state.mixture->ledger.rolling;
            // A saved world can be saved again, and that is the same file.
            const auto once = scenario_of_now(sandbox->scenario(), sandbox->session().state());
            ASSERT_TRUE(once) << once.error().sentence;
            const Scenario read = read_back(recording_of(*once));
            const auto twice = scenario_of_now(read, sim::make_state(initial_state_of(read), read.params));
            ASSERT_TRUE(twice) << twice.error().sentence;
            EXPECT_EQ(recording_of(*twice), recording_of(*once));
        }
    EXPECT_GT(objects, 0u);
    EXPECT_GT(destroyed, 0u);
    EXPECT_GT(woods, 0u);
    EXPECT_GT(earth, 0);
    EXPECT_GT(mixed, 0);
    EXPECT_EQ(wet, 3u) << "in the soil of each landslide, and in no snow";
}

TEST(SavedWorlds, play_the_same_hashes_for_the_same_commands) {
    auto scene = small("protection");
    ASSERT_TRUE(scene) << scene.error().sentence;
    auto sandbox = Sandbox::begin(loaded(*scene), {}, std::nullopt);
    for (int tick = 0; tick < 200; ++tick) ASSERT_TRUE(sandbox->tick({}));
    const auto now = scenario_of_now(sandbox->scenario(), sandbox->session().state());
    ASSERT_TRUE(now) << now.error().sentence;
    std::vector<StateLine> lines;
    for (const int threads : {1, 3}) {
        const Scenario read = read_back(recording_of(*now));
        auto session = Session::begin(read, {.threads = threads}, std::nullopt);
        ASSERT_TRUE(session);
        sim::Command blast;
        blast.kind = sim::CommandKind::kBlast;
        blast.x = 400, blast.y = 900, blast.radius = 40, blast.depth = 2;
        ASSERT_TRUE(session->advance({&blast, 1}));
        for (int tick = 0; tick < 120; ++tick) ASSERT_TRUE(session->advance({}));
        lines.push_back(session->state_line());
    }
    EXPECT_EQ(lines[0], lines[1]);
}

// A house of glass, a wooden one, a row of nets and a lift under a release.
TEST(SavedWorlds, clear_away_what_was_destroyed_and_mend_what_was_damaged) {
    Scenario scenario = small_scenario();
    const auto command = [](sim::CommandKind kind, double x, double y) {
        sim::Command of;
        of.kind = kind, of.x = x, of.y = y;
        return of;
    };
    sim::Command house = command(sim::CommandKind::kHouse, 9, 6),
                 net = command(sim::CommandKind::kNet, 4, 14);
    house.length = 5, house.width = 4.5, house.height = 3, house.strength = 5, house.turn = 33;
    sim::Command other = house;
    other.x = 18;
    net.to_x = 20, net.to_y = 14, net.height = 3, net.strength = 30;
    scenario.standing.placed = {house, other, net};
    sim::State state = sim::make_state(initial_state_of(scenario), scenario.params);
    ASSERT_GE(state.things->list.size(), 6u);
    ASSERT_EQ(state.things->list[1].kind, sim::ThingKind::kHouse);
    state.things->list[0].load = 6000;    // Pa: destroyed
    state.things->list[1].load = 3000;    // damaged
    state.things->list[4].load = 40'000;  // a piece in the middle of the row
    EXPECT_EQ(not_kept(state),
              ". What moves starts again from rest. 2 destroyed objects are cleared away. A "
              "damaged object is whole again");
    const auto now = scenario_of_now(scenario, state);
    ASSERT_TRUE(now) << now.error().sentence;
    ASSERT_EQ(now->standing.placed.size(), 3u);
    EXPECT_EQ(now->standing.placed[0].x, 18);
    EXPECT_EQ(now->standing.placed[0].turn, 33);
    EXPECT_EQ(now->standing.placed[1].kind, sim::CommandKind::kNet);
    EXPECT_NEAR(now->standing.placed[1].to_x, state.things->list[4].x, 1e-9);
    EXPECT_NEAR(now->standing.placed[2].x, state.things->list[4].to_x, 1e-9);
    const sim::State begun = sim::make_state(initial_state_of(*now), now->params);
    EXPECT_EQ(objects_of(begun, true), objects_of(state, true));
    for (const sim::Thing& thing : begun.things->list) EXPECT_EQ(thing.load, 0);
}

TEST(SavedWorlds, have_layers_that_a_start_may_have) {
    const Scenario scenario = small_scenario();
    sim::State state = sim::make_state(initial_state_of(scenario), scenario.params);
    state.depth(5, 5) = 64.5f;
    const auto now = scenario_of_now(scenario, state);
    ASSERT_FALSE(now);
    EXPECT_EQ(now.error().status, Failure::kUnusable);
    EXPECT_NE(now.error().sentence.find("64.5 m"), std::string::npos) << now.error().sentence;
}

// What is wrong with a header after a change; nothing if it can be read.
std::string fault_with(const Scenario& scenario, const char* where, const Json& what) {
    Header header;
    header.scenario = scenario;
    Json json = to_json(header);
    json[Json::json_pointer(where)] = what;
    const auto read = header_from(json);
    return read ? "" : read.error();
}

TEST(SavedWorlds, have_earth_that_sculpting_can_make) {
    Scenario scenario = small_scenario();
    const std::size_t vertices = scenario.grid.size();
    const auto one = [&](float metres) {
        std::vector<float> earth(vertices);
        earth[20] = metres;
        return pack_metres(earth);
    };
    const char* const kEarth = "/things/earth";
    EXPECT_EQ(fault_with(scenario, kEarth, one(1.5f)), "");
    EXPECT_EQ(fault_with(scenario, kEarth, one(-30)), "");
    const auto bare = std::ranges::find(scenario.has_data, 0);
    ASSERT_NE(bare, scenario.has_data.end());
    std::vector<float> beyond(vertices);
    beyond[static_cast<std::size_t>(bare - scenario.has_data.begin())] = 1;
    for (const Json& wrong : {Json(7), Json("AAAA"), Json(one(0.1f)), Json(one(30.5f)), Json(one(-31)),
                              Json(one(NAN)), Json(one(INFINITY)),
                              Json(pack_metres(std::vector<float>(vertices - 1))), Json(pack_metres(beyond))})
        EXPECT_FALSE(fault_with(scenario, kEarth, wrong).empty()) << wrong;
    scenario.standing.earth_budget = 0.5;  // m³; a metre on a cell of 2 m has more
    EXPECT_NE(fault_with(scenario, kEarth, one(1.5f)).find("budget"), std::string::npos);
    EXPECT_NE(fault_with(scenario, kEarth, one(30.5f)).find("30.5 m at vertex 20"), std::string::npos);
}

TEST(SavedWorlds, have_no_more_of_the_lower_material_than_their_layers) {
    Scenario scenario = small_scenario();
    const std::size_t vertices = scenario.grid.size();
    scenario.lower = Scenario::Lower{"soil", scenario.params, std::vector<float>(vertices), {}, {}, {}};
    const auto all = [&](float metres) { return pack_metres(std::vector<float>(vertices, metres)); };
    EXPECT_EQ(fault_with(scenario, "/lower/mixed", Json{{"settled", all(0)}, {"rolling", all(0)}}), "");
    for (const Json& wrong :
         {Json(7), Json{{"settled", 7}}, Json{{"settled", all(60)}}, Json{{"rolling", all(60)}},
          Json{{"rolling", all(-1)}}, Json{{"rolling", all(NAN)}}, Json{{"settled", all(0.1f)}}})
        EXPECT_FALSE(fault_with(scenario, "/lower/mixed", wrong).empty()) << wrong;
}

class OwnWorlds : public testing::Test {
  protected:
    OwnWorlds() { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }
    support::TemporaryFolder folder_;
};

TEST_F(OwnWorlds, are_files_with_the_names_that_they_are_given) {
    const auto first = keep_on_shelf(ShelfKind::kWorld, "Größer, 2 m", "one");
    const auto second = keep_on_shelf(ShelfKind::kWorld, "Größer, 2 m", "two");
    const auto third = keep_on_shelf(ShelfKind::kChallenge, shelf_name("A hill / mine?"), "three");
    ASSERT_TRUE(first && second && third);
    EXPECT_EQ(*first, folder_.path() / "couloir/scenes/Größer, 2 m.couloir");
    EXPECT_EQ(*second, folder_.path() / "couloir/scenes/Größer, 2 m-2.couloir");
    EXPECT_EQ(*third, folder_.path() / "couloir/challenges/A hill - mine-.couloir");
    EXPECT_EQ(shelf(ShelfKind::kWorld, 8).size(), 2u);
    EXPECT_EQ(shelf(ShelfKind::kChallenge, 8).size(), 1u);
    for (const std::string& none : {std::string(" "), std::string("../c"), std::string(201, 'c')})
        EXPECT_EQ(keep_on_shelf(ShelfKind::kWorld, none, "x").error().status, Failure::kUnusable) << none;
    for (const std::string& title : {std::string(), std::string("../c"), std::string("..."),
                                     std::string(99, '/'), "a" + std::string(300, '\xc3')})
        EXPECT_TRUE(keep_on_shelf(ShelfKind::kWorld, shelf_name(title), "x")) << title;
}

TEST_F(OwnWorlds, leave_nothing_if_the_disk_is_full) {
    const std::string text(100'000, 'x');
    std::filesystem::create_directories(folder_.path() / "couloir/scenes");
    const FullDisk full(1000);
    const auto kept = keep_on_shelf(ShelfKind::kWorld, "hill", text);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().status, Failure::kMachine);
    EXPECT_NE(kept.error().sentence.find("hill"), std::string::npos) << kept.error().sentence;
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "couloir/scenes"));
}

TEST_F(OwnWorlds, open_as_scenes_that_are_called_by_their_file) {
    auto scene = small("winter-valley");
    ASSERT_TRUE(scene) << scene.error().sentence;
    const auto path = keep_on_shelf(ShelfKind::kWorld, "hill", recording_of(scene->scenario));
    ASSERT_TRUE(path) << path.error().sentence;
    const auto world = open_anything(path->string(), {});
    ASSERT_TRUE(world) << world.error().sentence;
    EXPECT_FALSE(world->watched);
    EXPECT_TRUE(world->scene.commands.empty());
    EXPECT_EQ(world->scene.scenario.scene, path->stem().string());
    EXPECT_EQ(world->scene.scenario.title, scene->scenario.title);
    EXPECT_EQ(world->scene.scenario.depth, scene->scenario.depth);
}

}  // namespace
}  // namespace game::test
