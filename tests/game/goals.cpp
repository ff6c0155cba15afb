// Challenges: the [goal] of a scene, its rules, and scores that a recording alone proves.
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/analysis/played_run.h"
#include "game/analysis/score.h"
#include "game/recording/recording_file.h"
#include "game/scene/goal.h"
#include "game/scene/scene.h"
#include "game/session/sandbox.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/game/unpacked_page.h"
#include "tests/support/places.h"
#include "tests/support/slope_scene.h"

namespace game::test {
namespace {

const std::string kSlope =
    support::slope_scene("A trial", 24) + "[camera]\ntarget = [80, 72, -48]\n[light]\nazimuth = 255\n";
constexpr const char* kGoal = R"([goal]
say = "Let two heaps go."
learn = "Heaps go."
zone = { box = [20, 90, 140, 150] }
base = 10
medals = [11, 20, 200]
latest = 60
[[goal.tool]]
command = "blast"
count = 2
radius = [5, 12]
depth = 1
[[goal.tool]]
command = "pour"
total = 100
as = "standing"
[[goal.need]]
measure = "run_out"
least = 1
[[goal.score]]
measure = "eroded"
[[goal.score]]
measure = "unused"
of = "blast"
times = 100
)";

// An event that changes nothing, but from which the time of a try counts.
const std::string kEvent = "[[command]]\nat = 0\nsettle = { x = 80, y = 20, radius = 5 }\n";

sim::Command blast_at(double x, double y) {
    sim::Command blast;
    blast.kind = sim::CommandKind::kBlast;
    blast.x = x, blast.y = y;
    blast.radius = 10, blast.depth = 1;
    return blast;
}

class Challenge : public testing::Test {
  protected:
    Outcome<Scene> load(const std::string& goal) {
        write_bytes(scene_path_, kSlope + goal);
        return load_scene(scene_path_.string(), {});
    }
    Scene scene() { return load(kGoal).value(); }

    // Plays a try by hand and records it; nothing is done if the place is outside the zone.
    void play(double x, double y) {
        LoadedWorld loaded;
        loaded.scene = scene();
        auto recorder = record_into(path_, loaded.scene.scenario);
        Sandbox sandbox = Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::move(*recorder)).value();
        const sim::Command blast = blast_at(x, y);
        sandbox.begin_action("blast");
        ASSERT_TRUE(sandbox.tick({&blast, 1}));
        while (sandbox.session().try_ended_at() != sandbox.session().state().tick)
            ASSERT_TRUE(sandbox.tick({}));
        score_ = score_now(sandbox.scenario(), sandbox.session(), sandbox.commands_so_far());
        ASSERT_TRUE(sandbox.claim(score_.claim()));
        for (int i = 0; i < 20; ++i) ASSERT_TRUE(sandbox.tick({}));
        ASSERT_TRUE(sandbox.finish());
    }

    support::TemporaryFolder folder_;
    std::filesystem::path scene_path_ = folder_.path() / "trial.toml", path_ = folder_.path() / "try.couloir";
    Score score_;
};

TEST_F(Challenge, is_read_from_a_scene_and_kept_in_a_recording) {
    const auto loaded = load(kGoal);
    ASSERT_TRUE(loaded) << loaded.error().sentence;
    const Goal& goal = *loaded->scenario.goal;
    EXPECT_EQ(goal.say, "Let two heaps go.");
    EXPECT_EQ(goal.medals, (std::array<std::int64_t, 3>{11, 20, 200}));
    ASSERT_EQ(goal.tools.size(), 2u);
    EXPECT_EQ(goal.tools[0].limits, (std::vector<Goal::Limit>{{"radius", 5, 12}, {"depth", 1, 1}}));
    record(path_, loaded->scenario, 10, {});
    EXPECT_EQ(read_recording(path_)->header.scenario.goal, goal);
}

TEST_F(Challenge, whose_goal_is_wrong_is_refused_with_its_line) {
    struct Wrong {
        const char *part, *instead, *fact;
    };
    for (const Wrong& wrong : {
             Wrong{"say = \"Let two heaps go.\"\n", "", "says nothing"},
             {"medals = [11, 20, 200]\n", "", "needs medals"},
             {"medals = [11, 20, 200]\n", "medals = [11, 9, 12]\n", "medals that do not rise"},
             {"command = \"blast\"", "command = \"bang\"", "is not the name of a command"},
             {"command = \"pour\"\ntotal = 100\nas = \"standing\"", "command = \"blast\"",
              "the tool blast twice"},
             {"total = 100", "total = -1", "is -1, outside 0"},
             {"radius = [5, 12]", "radius = [12, 5]", "is not two rising numbers"},
             {"depth = 1\n", "depth = 1\ntotal = 5\n", "which only a count can limit"},
             {"measure = \"run_out\"", "measure = \"fun\"", "is not one of run_out, drop"},
             {"least = 1\n", "", "not one of `least` and `most`"},
             {"of = \"blast\"", "of = \"dig\"", "which is no tool of it"},
             {"zone = { box = [20, 90, 140, 150] }", "zone = { box = [140, 90, 20, 150] }", "west, south"},
             {"zone = { box = [20, 90, 140, 150] }", "zone = { disc = [1, 2] }",
              "zone.disc is not a known key"},
             {"latest = 60\n", "latest = 60\nluck = 1\n", "luck"},
             {"base = 10\n", "combine = \"largest\"\n", "is neither sum nor smallest"},
         }) {
        std::string goal = kGoal;
        const auto at = goal.find(wrong.part);
        ASSERT_NE(at, std::string::npos) << wrong.part;
        const auto loaded = load(goal.replace(at, std::string(wrong.part).size(), wrong.instead));
        ASSERT_FALSE(loaded) << wrong.fact;
        EXPECT_EQ(loaded.error().status, Failure::kUnusable);
        EXPECT_EQ(loaded.error().sentence.rfind(scene_path_.string() + ":", 0), 0u)
            << loaded.error().sentence;
        EXPECT_NE(loaded.error().sentence.find(wrong.fact), std::string::npos) << loaded.error().sentence;
    }
}

// One goal of each kind that no try can reach, on a slope with two houses, 40 m of road and a budget of earth.
TEST_F(Challenge, that_no_try_can_win_is_refused_with_its_line) {
    const std::string things = R"([[house]]
at = [60, 40]
[[house]]
at = [100, 40]
[[road]]
points = [[60, 20], [100, 20]]
width = 5
[earth]
budget = 500
)";
    const auto goal = [&](const std::string& rest, const std::string& medals = "[1, 2, 3]") {
        return things + "[goal]\nsay = \"Try.\"\nmedals = " + medals + "\n" + rest;
    };
    const std::string eroded = "[[goal.score]]\nmeasure = \"eroded\"\n";
    const std::string blast = "[[goal.tool]]\ncommand = \"blast\"\ncount = 2\n";
    const auto need = [&](const std::string& what) {
        return goal(eroded + blast + "[[goal.need]]\n" + what);
    };
    const auto score = [&](const std::string& what, const std::string& medals = "[1, 2, 3]") {
        return goal(blast + "[[goal.score]]\n" + what, medals);
    };
    struct Goals {
        std::string text;
        const char *place, *fact;
    };
    for (const Goals& wrong : {
             Goals{need("measure = \"load\"\nmost = -1\n"), "most", "load is never below 0"},
             {need("measure = \"removed\"\nleast = 101\n"), "least", "100 %"},
             {need("measure = \"unused\"\nof = \"blast\"\nleast = 3\n"), "least", "there are 2 in all"},
             {need("measure = \"blocked\"\nleast = 41\n"), "least", "at most 40 m of road"},
             {need("measure = \"destroyed\"\nleast = 3\n"), "least", "is 3, and at most 2 houses"},
             {need("measure = \"broken\"\nleast = 0.1\n"), "least", "0.00 ha of forest"},
             {need("measure = \"earth\"\nleast = 501\n"), "least", "the budget of earth is 500 m3"},
             {need("measure = \"eroded\"\nleast = 1e8\n"), "least", "m3 lie there"},
             {need("measure = \"run_out\"\nleast = 300\n"), "least", "the terrain is 226 m across"},
             {need("measure = \"drop\"\nleast = 300\n"), "least", "m of relief"},
             {need("measure = \"deposit\"\narea = { box = [200, 0, 300, 50] }\nleast = 1\n"), "area",
              "has no vertex of the grid inside"},
             {score("measure = \"deposit\"\narea = { ellipse = [-50, 0, 20, 20] }\n"), "area",
              "has no vertex of the grid inside"},
             {goal("zone = { box = [-90, 0, -10, 50] }\n" + eroded), "zone", "lies beside the grid"},
             {goal("zone = { ellipse = [200, 80, 30, 30] }\n" + eroded), "zone", "lies beside the grid"},
             {score("measure = \"destroyed\"\n"), "medals", "go up to 3, and no try can score more than 2"},
             {score("measure = \"destroyed\"\ntimes = -1\n", "[-2, -1, 1]"), "medals", "more than 0"},
             {score("measure = \"removed\"\n", "[50, 90, 110]"), "medals", "more than 100"},
         }) {
        const auto loaded = load(wrong.text);
        ASSERT_FALSE(loaded) << wrong.text;
        const std::string& said = loaded.error().sentence;
        EXPECT_EQ(loaded.error().status, Failure::kUnusable);
        EXPECT_EQ(said.rfind(scene_path_.string() + ":", 0), 0u) << said;
        EXPECT_NE(said.find(wrong.place), std::string::npos) << said;
        EXPECT_NE(said.find(wrong.fact), std::string::npos) << said;
    }
    for (const std::string& sound :
         {need("measure = \"load\"\nmost = 0\n"), need("measure = \"removed\"\nleast = 100\n"),
          need("measure = \"unused\"\nof = \"blast\"\nleast = 2\n"),
          need("measure = \"blocked\"\nleast = 40\n"), need("measure = \"destroyed\"\nleast = 2\n"),
          need("measure = \"earth\"\nleast = 500\n"), need("measure = \"run_out\"\nleast = 226\n"),
          score("measure = \"destroyed\"\n", "[0, 1, 2]"),
          need("measure = \"deposit\"\narea = { box = [150, 0, 300, 50] }\nleast = 1\n"),
          goal("zone = { ellipse = [180, 80, 30, 30] }\n" + eroded),
          need("measure = \"destroyed\"\nleast = 5\n[[goal.tool]]\ncommand = \"house\"\ncount = 3\n"),
          need("measure = \"broken\"\nleast = 0.1\n[[goal.tool]]\ncommand = \"plant\"\ntotal = 1\n")})
        EXPECT_TRUE(load(sound)) << load(sound).error().sentence;
}

// A recording of one is read: it tells what happened. But the challenge does not begin from it.
TEST_F(Challenge, that_no_try_can_win_is_read_from_a_recording_and_does_not_begin) {
    record(path_, scene().scenario, 0, {});
    ASSERT_TRUE(open_anything(path_.string(), {})) << open_anything(path_.string(), {}).error().sentence;
    auto bodies = bodies_of(read_bytes(path_));
    Json header = json_of(bodies[0]);
    header["goal"]["needs"][0]["least"] = 5000;
    bodies[0] = body_of(header);
    write_bytes(path_, chained(bodies));
    EXPECT_TRUE(read_recording(path_)) << read_recording(path_).error().sentence;
    const auto refused = open_anything(path_.string(), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Failure::kUnusable);
    EXPECT_NE(
        refused.error().sentence.find("the goal: need 1: least is 5000, and the terrain is 226 m across"),
        std::string::npos)
        << refused.error().sentence;
}

TEST_F(Challenge, allows_its_tools_within_their_limits_and_budgets_alone) {
    const Scene of = scene();
    GoalUse use(*of.scenario.goal);
    const float tick_s = of.scenario.params.tick_s;
    const auto refused = [&](const sim::Command& command) {
        return use.take({5, command}, tick_s).value_or("");
    };
    sim::Command dig = blast_at(80, 120), far = blast_at(80, 20), large = blast_at(80, 120),
                 pour = blast_at(80, 120);
    dig.kind = sim::CommandKind::kDig;
    large.radius = 13;
    pour.kind = sim::CommandKind::kPour, pour.layer = sim::Layer::kStanding;
    pour.rate = 60, pour.duration = 1, pour.depth = 0;
    EXPECT_EQ(refused(dig), "dig is no tool of this challenge");
    EXPECT_EQ(refused(far), "(80, 20) is outside the zone of this challenge");
    EXPECT_EQ(refused(large), "the radius of a blast is 13 m, outside 5 to 12");
    EXPECT_EQ(refused(blast_at(80, 120)), "");
    EXPECT_EQ(refused(blast_at(80, 120)), "");
    EXPECT_EQ(refused(blast_at(80, 120)), "no blast is left: this challenge has 2");
    EXPECT_EQ(refused(pour), "");
    EXPECT_EQ(refused(pour), "the budget of pour is 100 m3, and 40.0 m3 are left");
    pour.rate = 40;
    EXPECT_EQ(refused(pour), "");  // to the last grain
    EXPECT_EQ(use.left(of.scenario.goal->tools[1]), 0);
    pour.layer = sim::Layer::kRolling;
    EXPECT_EQ(refused(pour), "a pour must be as standing");
}

TEST(GoalCosts, of_water_are_what_falls_on_the_disc) {
    sim::Command wet;
    wet.kind = sim::CommandKind::kWet;
    wet.radius = 10, wet.rate = 0.05, wet.duration = 2;
    EXPECT_NEAR(cost_of(wet, 1.f / 60), 31.416, 1e-3);
    wet.profile = sim::Profile::kCone;
    EXPECT_NEAR(cost_of(wet, 1.f / 60), 10.472, 1e-3);
    EXPECT_EQ(unit_of(sim::CommandKind::kDrain), "m3");
}

TEST_F(Challenge, brings_what_a_hand_does_into_its_limits) {
    const Scene of = scene();
    sim::Command blast = blast_at(80, 120);
    blast.radius = 40, blast.depth = 0.2;
    const sim::Command fitted = fitted_to(*of.scenario.goal, blast);
    EXPECT_EQ(fitted.radius, 12);
    EXPECT_EQ(fitted.depth, 1);
}

TEST_F(Challenge, refuses_a_hand_that_breaks_its_rules_and_goes_on) {
    LoadedWorld loaded;
    loaded.scene = scene();
    Sandbox sandbox = Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::nullopt).value();
    const sim::Command far = blast_at(80, 20), near = blast_at(80, 120);
    sandbox.begin_action("blast");
    const auto done = sandbox.tick({&far, 1});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().sentence, "Not done: (80, 20) is outside the zone of this challenge");
    EXPECT_EQ(sandbox.session().state().tick, 1);
    EXPECT_FALSE(sandbox.was_touched());
    sandbox.begin_action("blast");
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(sandbox.tick({&near, 1}));  // a stroke ends where the budget does, and nothing is said
    EXPECT_EQ(sandbox.commands_so_far().size(), 2u);
    sandbox.begin_action("blast");
    ASSERT_FALSE(sandbox.tick({&near, 1}));
    EXPECT_EQ(sandbox.goal_use().left(sandbox.scenario().goal->tools[0]), 0);
    ASSERT_TRUE(sandbox.undo());  // both: they were one action
    EXPECT_EQ(sandbox.goal_use().left(sandbox.scenario().goal->tools[0]), 2);
}

TEST_F(Challenge, that_was_played_is_scored_from_its_recording) {
    play(80, 120);
    EXPECT_TRUE(score_.won());
    EXPECT_GE(score_.medal, 2);
    const Finished said = couloir({"replay", path_.string(), "--score", "--verify"});
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_NE(said.out.find(fmt::format("challenge: Won: {}", medal_name(score_.medal))), std::string::npos)
        << said.out;
    EXPECT_NE(said.out.find(fmt::format("score {};", score_.points)), std::string::npos) << said.out;
    for (const char* kernel : {"plain", "x86-64-v2"})
        for (const char* threads : {"1", "8"}) {
            const Finished same = couloir(
                {"replay", path_.string(), "--score", "--json", "--kernel", kernel, "--threads", threads});
            const Json json = Json::parse(same.out);
            EXPECT_EQ(json.at("challenge").at("score"), score_.points) << kernel << threads;
            EXPECT_EQ(json.at("challenge").at("tick"), score_.tick) << kernel << threads;
        }
}

TEST_F(Challenge, whose_file_was_edited_is_told_from_an_honest_one) {
    play(80, 120);
    const std::vector<std::string> honest = bodies_of(read_bytes(path_));
    const auto edited = [&](const std::string& part, const std::string& instead) {
        std::vector<std::string> bodies = honest;
        bool found = false;
        for (std::string& body : bodies)
            if (const auto at = body.find(part); at != std::string::npos && !found) {
                body.replace(at, part.size(), instead);
                found = true;
            }
        EXPECT_TRUE(found) << part;
        write_bytes(path_, chained(bodies));
        return couloir({"replay", path_.string(), "--score"});
    };
    Finished said = edited(fmt::format(R"("score":{})", score_.points), R"("score":999999)");
    EXPECT_EQ(said.status, 1);
    EXPECT_NE(said.err.find("it claims a score of 999999"), std::string::npos) << said.err;
    EXPECT_NE(said.err.find(fmt::format("its commands give {}", score_.points)), std::string::npos)
        << said.err;

    said = edited(R"("y":120.0,"radius":10.0)", R"("y":20.0,"radius":10.0)");
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find("tick 0: (80, 20) is outside the zone"), std::string::npos) << said.err;

    said = edited(R"("medals":[11,)", R"("medals":[1,)");  // an easier challenge is not the shipped one
    EXPECT_NE(said.err.find("a challenge of its own"), std::string::npos) << said.err;

    said = edited(R"("medals":[11,)", R"("medals":[true,)");
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find(":1: medals is not three whole numbers"), std::string::npos) << said.err;

    std::vector<std::string> cut(honest.begin(), honest.begin() + 4);
    write_bytes(path_, chained(cut));
    said = couloir({"replay", path_.string(), "--score"});
    EXPECT_EQ(said.status, 1);
    EXPECT_NE(said.err.find("the try at the challenge has not ended"), std::string::npos) << said.err;
}

TEST_F(Challenge, that_a_friend_has_played_is_kept_among_the_best_runs_with_its_origin) {
    const std::string data = (folder_.path() / "data").string();
    const auto keep = [&](const std::filesystem::path& file) {
        return couloir({"replay", file.string(), "--score", "--keep"},
                       {.environment = {{"XDG_DATA_HOME", data}}});
    };
    const auto kept_ones = [&] {
        std::vector<std::filesystem::path> files;
        if (!std::filesystem::exists(data)) return files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(data))
            if (entry.is_regular_file()) files.push_back(entry.path());
        return files;
    };
    play(80, 120);
    ASSERT_TRUE(score_.meets_needs());
    const Finished done = keep(path_);
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_NE(done.err.find("number 1 of the best runs here"), std::string::npos) << done.err;
    ASSERT_EQ(kept_ones().size(), 1u);
    const Recording kept = read_recording(kept_ones().front()).value();
    EXPECT_EQ(kept.header.parent, (Parent{"try", score_.tick}));
    EXPECT_EQ(kept.claim, score_.claim());
    EXPECT_EQ(kept.last_tick(), score_.tick) << "it ends where the try ended";
    EXPECT_EQ(couloir({"replay", kept_ones().front().string(), "--verify", "--score"}).status, 0);
    EXPECT_EQ(keep(path_).status, 0);
    EXPECT_EQ(kept_ones().size(), 1u) << "each run once";
    const std::filesystem::path page = folder_.path() / "page.html";
    const Finished shared = couloir({"share", scene_path_.string(), "--out", page.string()},
                                    {.environment = {{"XDG_DATA_HOME", data}}});
    EXPECT_EQ(shared.status, 0) << shared.err;
    // A page asks to beat it, and has where it was when.
    const UnpackedPage unpacked(read_bytes(page));
    EXPECT_EQ(unpacked.info()["goal"]["to_beat"], score_.points);
    EXPECT_EQ(unpacked.info()["goal"]["ghost_step"], RunExtent::kStep);
    const PlayedRun played =
        play_run(kept_ones().front(), challenge_id(kept.header.scenario), {}, std::atomic<bool>(false))
            .value();
    const std::vector<double> ghost = unpacked.array("ghost");
    ASSERT_EQ(ghost.size(), played.extent.reached().size());
    for (std::size_t i = 0; i < ghost.size(); ++i) {
        const RunExtent::Step step = played.extent.reached()[i];
        ASSERT_EQ(ghost[i], step == RunExtent::kNever ? 0 : step + 1) << i;
    }
    EXPECT_GT(std::ranges::count_if(ghost, [](double step) { return step > 0; }), 10);

    // One whose name claims more is left out, with a sentence.
    const std::filesystem::path claims =
        kept_ones().front().parent_path() / "99999_gold_2026-11-29_12-00-00_0123456789abcdef.couloir";
    write_bytes(claims, read_bytes(kept_ones().front()));
    const Finished doubted = couloir({"share", scene_path_.string(), "--out", page.string()},
                                     {.environment = {{"XDG_DATA_HOME", data}}});
    EXPECT_EQ(doubted.status, 0);
    EXPECT_NE(doubted.err.find("its name claims a score of 99999"), std::string::npos) << doubted.err;
    EXPECT_EQ(UnpackedPage(read_bytes(page)).info()["goal"]["to_beat"], score_.points);

    // Another score than its commands give.
    Recording recording = read_recording(path_).value();
    const std::filesystem::path lie = folder_.path() / "lie.couloir";
    {
        auto recorder = record_into(lie, recording.header.scenario).value();
        for (const StateLine& state : recording.states) {
            for (const TimedCommand& command : recording.commands)
                if (command.tick < state.tick && command.tick >= state.tick - kTicksPerState) {
                    ASSERT_TRUE(recorder.command(command));
                }
            ASSERT_TRUE(recorder.state(state));
            if (state.tick >= score_.tick && recording.claim) {
                ASSERT_TRUE(recorder.claim({state.tick, 9999, 3}));
                recording.claim.reset();
            }
        }
        ASSERT_TRUE(recorder.end(recording.last_tick()));
    }
    std::filesystem::remove_all(data);
    const Finished refused = keep(lie);
    EXPECT_EQ(refused.status, 1) << refused.err;
    EXPECT_NE(refused.err.find("claims a score of 9999"), std::string::npos) << refused.err;
    EXPECT_TRUE(kept_ones().empty());
}

TEST_F(Challenge, may_be_claimed_again_but_not_differently) {
    play(80, 120);
    const std::vector<std::string> honest = bodies_of(read_bytes(path_));
    const auto claim = std::ranges::find_if(honest, [](const std::string& body) {
        return body.find("\"medal\":") != std::string::npos && body.find("\"score\":") < 20;
    });
    ASSERT_NE(claim, honest.end());
    const auto with_more = [&](const std::string& body, std::ptrdiff_t after) {
        std::vector<std::string> bodies = honest;
        bodies.insert(bodies.begin() + (claim - honest.begin()) + after, body);
        write_bytes(path_, chained(bodies));
        return couloir({"replay", path_.string(), "--score"});
    };
    const Finished same = with_more(*claim, 0);
    EXPECT_EQ(same.status, 0) << same.err;
    const std::string points = fmt::format(R"("score":{})", score_.points);
    const auto instead = [&](const std::string& score) {
        return std::string(*claim).replace(claim->find(points), points.size(), score);
    };
    for (const std::ptrdiff_t after : {0, 1}) {  // a false one before or after the true one
        const Finished said = with_more(instead(R"("score":999999)"), after);
        EXPECT_EQ(said.status, 2) << said.err;
        EXPECT_NE(said.err.find("999999"), std::string::npos) << said.err;
    }
    for (const char* beyond : {"9223372036854775808", "18446744073709551615"}) {
        std::vector<std::string> bodies = honest;
        bodies[static_cast<std::size_t>(claim - honest.begin())] =
            instead(fmt::format(R"("score":{})", beyond));
        write_bytes(path_, chained(bodies));
        const Finished said = couloir({"replay", path_.string(), "--score"});
        EXPECT_EQ(said.status, 2) << said.err;
        EXPECT_NE(said.err.find(beyond), std::string::npos) << said.err;
    }
}

TEST_F(Challenge, is_needed_for_a_score) {
    record(path_, small_scenario(), 20, {});
    const Finished said = couloir({"replay", path_.string(), "--score"});
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find("its scene has no goal"), std::string::npos) << said.err;
}

TEST_F(Challenge, of_which_nothing_is_done_does_not_end) {
    const Finished said = couloir({"run", (scene(), scene_path_.string()), "--seconds", "61", "--json"});
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_FALSE(Json::parse(said.out).contains("challenge"));
}

TEST_F(Challenge, counts_its_time_from_the_first_command) {
    const auto ended_at = [&](const std::string& event, const std::string& limits) {
        std::string goal = kGoal;
        load(event + goal.replace(goal.find("latest = 60\n"), 12, limits)).value();
        const Finished said = couloir({"run", scene_path_.string(), "--seconds", "90", "--json"});
        return Json::parse(said.out).at("challenge").at("tick").get<int>();
    };
    const std::string blast = "[[command]]\nat = 20\nblast = { x = 80, y = 120, radius = 10, depth = 1 }\n";
    EXPECT_EQ(ended_at(blast, "latest = 2\n"), 22 * 60);
    EXPECT_EQ(ended_at(blast, "earliest = 40\nlatest = 60\n"), 60 * 60);
    EXPECT_EQ(ended_at(kEvent, ""), 5 * 60 + 1) << "nothing moved";
    EXPECT_EQ(ended_at(kEvent + blast, "latest = 30\n"), 30 * 60);
    EXPECT_EQ(ended_at(kEvent + blast, "latest = 10\n"), 10 * 60) << "whatever comes";
}

TEST_F(Challenge, scores_the_smallest_of_its_terms_if_it_says_so) {
    const auto scored = [&](const std::string& combine) {
        std::string goal = kGoal;
        goal.replace(goal.find("base = 10\n"), 10, "base = 10\n" + combine);
        const auto loaded = load(kEvent + goal);
        EXPECT_TRUE(loaded) << loaded.error().sentence;
        record(path_, loaded->scenario, 10, {});
        EXPECT_EQ(read_recording(path_)->header.scenario.goal, loaded->scenario.goal);
        const Finished said = couloir({"run", scene_path_.string(), "--seconds", "61", "--json"});
        return Json::parse(said.out).at("challenge").at("score").get<int>();
    };
    EXPECT_EQ(scored(""), 10 + 0 + 200);
    EXPECT_EQ(scored("combine = \"sum\"\n"), 10 + 0 + 200);
    EXPECT_EQ(scored("combine = \"smallest\"\n"), 10 + 0);
}

TEST_F(Challenge, counts_the_earth_that_is_in_use) {
    const std::string dam = "[[dam]]\npoints = [[60, 40], [100, 40]]\nradius = 12\nrise = 3\n";
    std::string goal = kGoal;
    goal.replace(goal.find("measure = \"eroded\""), 18, "measure = \"earth\"\ntimes = -1");
    write_bytes(scene_path_, kSlope + dam + kEvent + goal);
    const Finished said = couloir({"run", scene_path_.string(), "--seconds", "61", "--json"});
    ASSERT_EQ(said.status, 0) << said.err;
    const Json json = Json::parse(said.out);
    const double used = json.at("things").at("earth").at("used_m3").get<double>();
    EXPECT_GT(used, 500);
    EXPECT_NEAR(json.at("challenge").at("score").get<double>(), 10 - used + 200, 0.51);
}

TEST_F(Challenge, goes_on_with_the_events_of_its_scene_in_a_branch) {
    const std::string event = "[[command]]\nat = 1\nblast = { x = 80, y = 120, radius = 10, depth = 1 }\n";
    write_bytes(scene_path_, kSlope + event + kGoal);
    LoadedWorld loaded;
    loaded.scene = load_scene(scene_path_.string(), {}).value();
    record(path_, loaded.scene.scenario, 30, {});
    LoadedWorld again;
    again.watched = read_recording(path_).value();
    again.scene = {again.watched->header.scenario, again.watched->commands};
    again.name = "try";
    Sandbox sandbox = Sandbox::begin(std::move(again), sim::StepOptions{}, std::nullopt).value();
    for (int i = 0; i < 12; ++i) ASSERT_TRUE(sandbox.tick({}));
    ASSERT_TRUE(sandbox.take_over(into_file(folder_.path() / "branch.couloir")));
    for (int i = 0; i < 60; ++i) ASSERT_TRUE(sandbox.tick({}));
    ASSERT_EQ(sandbox.commands_so_far().size(), 1u);
    EXPECT_EQ(sandbox.commands_so_far()[0], sandbox.scenario().goal->events[0]);
}

TEST(Need, that_was_nearly_met_is_told_with_the_digits_that_tell_it) {
    const auto told = [](double most, std::int64_t value, bool met) {
        Goal::Need need;
        need.quantity.measure = Measure::kLoad;
        need.most = most;
        const NeedText text = text_of(need, {value, met});
        return text.value + ", " + text.bound;
    };
    EXPECT_EQ(told(4.9, 4937, false), "4.94 kPa, at most 4.90 kPa");
    EXPECT_EQ(told(4.9, 4901, false), "4.901 kPa, at most 4.900 kPa");
    EXPECT_EQ(told(4.9, 4900, true), "4.9 kPa, at most 4.9 kPa");
    EXPECT_EQ(told(4.9, 8213, false), "8.2 kPa, at most 4.9 kPa");
    EXPECT_EQ(told(5, 5012, false), "5.01 kPa, at most 5.00 kPa");
    EXPECT_EQ(told(120, 120'400, false), "120.4 kPa, at most 120.0 kPa");
    EXPECT_EQ(told(120, 300'400, false), "300 kPa, at most 120 kPa");
}

}  // namespace
}  // namespace game::test
