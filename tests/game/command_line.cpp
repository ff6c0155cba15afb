#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/recording/format.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

using Arguments = std::vector<std::string>;

// Ends with this status and one line for the person, which holds `told`.
void expect_failure(const Arguments& arguments, int status, const std::string& told) {
    std::string said = "couloir";
    for (const std::string& argument : arguments) said += " " + argument;
    SCOPED_TRACE(said);
    const Finished finished = couloir(arguments);
    EXPECT_EQ(finished.status, status);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
    EXPECT_EQ(finished.err.rfind("couloir: ", 0), 0u) << finished.err;
    EXPECT_NE(finished.err.find(told), std::string::npos) << finished.err;
}

// A run that is over in a moment.
Arguments short_run(const Arguments& more = {}) {
    Arguments arguments{"run", "landslide", "--grid", "16", "--seconds", "0.5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(CommandLine, that_is_wrong_ends_with_2_and_one_line) {
    const std::pair<Arguments, const char*> wrong[] = {
        {{"ski"}, "ski"},
        {{"play", "nowhere"}, "nowhere"},
        {{"play", "landslide", "--scheme", "lax-friedrichs"}, "--scheme"},
        {{"play", "--quality", "fine"}, "'fine' is not one of: fast, balanced, full"},
        {{"--frobnicate"}, "--frobnicate"},
        {short_run({"--frobnicate"}), "--frobnicate"},
        {short_run({"--grid"}), "--grid"},
        {{"run", "landslide", "--grid", "7", "--seconds", "1"}, "--grid"},
        {{"run", "landslide", "--grid", "4097", "--seconds", "1"}, "--grid"},
        {{"run", "landslide", "--grid", "many", "--seconds", "1"}, "--grid"},
        {{"run", "landslide", "--grid", "16.5", "--seconds", "1"}, "--grid"},
        {{"run", "landslide", "--seconds", "-1"}, "--seconds"},
        {{"run", "landslide", "--seconds", "nan"}, "--seconds"},
        {{"run", "landslide", "--seconds", "soon"}, "--seconds"},
        {short_run({"--threads", "0"}), "--threads"},
        {short_run({"--threads", "65"}), "--threads"},
        {short_run({"--every", "0"}), "--every"},
        {short_run({"--size", "1280"}), "--size"},
        {short_run({"--size", "8x8"}), "--size"},
        {short_run({"--size", "1280x720x3"}), "--size"},
        {short_run({"--model", "newton"}), "--model"},
        {short_run({"--scheme", "upwind"}), "--scheme"},
        {short_run({"--scheme", "lax-friedrichs", "--model", "bcre-inertial"}), "--scheme"},
        {short_run({"--scheme", "lax-friedrichs"}), "--scheme"},  // the scene's model has its own
        {short_run({"--gl", "moon", "--frames", "never-made"}), "moon"},
        {{"replay", "/"}, "is a folder"},
        {short_run({"--material", "cheese"}), "cheese"},
        {short_run({"--release", "x.geojson"}), "--release"},
        {{"run", "--terrain", "x.asc", "--thickness", "normal"}, "--thickness"},
        {{"run", "--terrain", "x.asc", "--release", "y.asc", "--thickness", "up"}, "vertical, normal"},
        {short_run({"--terrain", "x.asc"}), "--terrain"},
        {short_run({"--reference", "nothing.geojson"}), "nothing.geojson"},
        {short_run({"another"}), "another"},
        {{"run", "--until-rest"}, "scene"},
        {{"run", "landslide"}, "--until-rest"},
        {{"run", "--terrain", "x.asc", "--until-rest"}, "--release"},
        {{"run", "--terrain", "x.asc", "--release", "y.geojson", "--until-rest"}, "x.asc"},
        {{"run", "nothing", "--until-rest"}, "nothing"},
        {{"run", "nothing.toml", "--until-rest"}, "nothing.toml"},
        {{"replay"}, "recording is required"},
        {{"replay", "nothing"}, "nothing"},
        {{"replay", "nothing.couloir"}, "nothing.couloir"},
        {{"replay", "nothing", "--until", "-1"}, "--until"},
        {{"list", "everything"}, "everything"},
    };
    for (const auto& [arguments, told] : wrong) expect_failure(arguments, 2, told);
}

TEST(CommandLine, that_asks_for_files_where_none_can_be_ends_with_3_and_one_line) {
    const support::TemporaryFolder folder;
    write_bytes(folder.path() / "file", "kept");
    const std::string below = (folder.path() / "file" / "x").string();
    for (const char* option : {"--record", "--web", "--export", "--frames", "--perf", "--summary", "--trace"})
        expect_failure(short_run({option, below}), 3, (folder.path() / "file").string());
    EXPECT_EQ(read_bytes(folder.path() / "file"), "kept");
}

TEST(CommandLine, finds_out_that_a_file_cannot_be_written_before_it_runs) {
    const support::TemporaryFolder folder;
    write_bytes(folder.path() / "file", "kept");
    const std::string below = (folder.path() / "file" / "x").string();
    const auto recording = folder.path() / "part.couloir";
    for (const char* option : {"--web", "--perf", "--summary", "--trace"}) {
        expect_failure(short_run({"--record", recording.string(), option, below}), 3,
                       below.substr(0, below.size() - 2));
        EXPECT_EQ(read_bytes(recording).find("\"end\""), std::string::npos)
            << option << ": ran to the end first";
    }
}

TEST(CommandLine, takes_over_only_from_what_somebody_did_in_a_recording) {
    const support::TemporaryFolder folder;
    const std::string small = (folder.path() / "small.couloir").string();
    const std::string flow = (folder.path() / "flow.couloir").string();
    record(small, small_scenario(), 20, {});
    EXPECT_EQ(couloir({"run", "flow-disc", "--grid", "16", "--seconds", "0.5", "--record", flow}).status, 0);
    expect_failure({"play", "landslide", "--until", "3"}, 2, "--until");
    expect_failure({"play", small, "--until", "21"}, 2, "ends at tick 20, before 21");
    expect_failure({"play", flow, "--until", "3"}, 2, "--until");
}

TEST(CommandLine, replays_up_to_any_tick_of_a_recording_and_no_further) {
    const support::TemporaryFolder folder;
    const std::string small = (folder.path() / "small.couloir").string();
    record(small, small_scenario(), 20, {});
    EXPECT_EQ(couloir({"replay", small, "--until", "20"}).status, 0);
    expect_failure({"replay", small, "--until", "21", "--frames", (folder.path() / "pictures").string()}, 2,
                   "ends at tick 20, before 21");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "pictures"));
}

TEST(CommandLine, refuses_a_recording_with_a_changed_byte) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "small.couloir";
    record(path, small_scenario(), 20, {});
    std::string bytes = read_bytes(path);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_bytes(path, bytes);
    expect_failure({"replay", path.string(), "--verify"}, 2, path.string() + ":1: ");
}

TEST(CommandLine, verifying_tells_a_state_that_was_never_reached) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "small.couloir";
    record(path, small_scenario(), 20, {});
    auto bodies = bodies_of(read_bytes(path));
    Json state = json_of(bodies[3]);  // tick 12
    state["hash"] = "0123456789abcdef";
    bodies[3] = body_of(state);
    write_bytes(path, chained(bodies));
    EXPECT_EQ(couloir({"replay", path.string()}).status, 0);
    const Finished verified = couloir({"replay", path.string(), "--verify"});
    EXPECT_EQ(verified.status, 1);
    EXPECT_NE(verified.out.find("at tick 12 the state's hash is"), std::string::npos) << verified.out;

    state = json_of(bodies_of(read_bytes(path))[2]);
    state["mass"]["rolling"] = state["mass"]["rolling"].get<std::int64_t>() + 1;
    bodies[2] = body_of(state);
    write_bytes(path, chained(bodies));
    const Json summary = Json::parse(couloir({"replay", path.string(), "--verify", "--json"}).out);
    EXPECT_EQ(summary["verified"]["parted"], "at tick 6 the mass ledger is not the recorded one");
    EXPECT_EQ(summary["verified"]["proven_tick"], 5);
}

TEST(CommandLine, help_of_every_subcommand_names_every_option) {
    const std::pair<const char*, Arguments> options[] = {
        {"run", {"SCENE",        "--terrain",    "--release",    "--thickness",   "--reference",
                 "--material",   "--model",      "--size-class", "--scheme",      "--grid",
                 "--until-rest", "--seconds",    "--record",     "--export",      "--frames",
                 "--every",      "--size",       "--gl",         "--perf",        "--summary",
                 "--trace",      "--json",       "--threads",    "bcre-inertial", "local-lax-friedrichs",
                 "--web",        "--size-limit", "--camera"}},
        {"replay",
         {"RECORDING", "--until", "--verify", "--frames", "--every", "--size", "--gl", "--no-render",
          "--perf", "--summary", "--trace", "--json", "--threads", "--web", "--size-limit", "--camera"}},
        {"bench", {"RECORDING", "--grid",      "--physics", "--scaling", "--repeats",
                   "--ticks",   "--every",     "--size",    "--gl",      "--no-render",
                   "--perf",    "--summary",   "--json",    "--page",    "--trace",
                   "--against", "--tolerance", "--threads", "--kernel",  "local-lax-friedrichs"}},
        {"figures", {"--out", "--quick", "--only", "--pixels", "--gl", "--threads"}},
        {"gallery", {"--out", "--terrain", "--size", "--gl", "--max-memory", "--threads"}},
        {"terrain", {"generate"}},
        {"list", {"--json"}}};
    const Finished all = couloir({"--help"});
    EXPECT_EQ(all.status, 0);
    EXPECT_NE(all.out.find("Exit status"), std::string::npos);
    for (const auto& [subcommand, names] : options) {
        EXPECT_NE(all.out.find(subcommand), std::string::npos);
        const Finished help = couloir({subcommand, "--help"});
        EXPECT_EQ(help.status, 0);
        EXPECT_EQ(help.err, "");
        for (const std::string& name : names)
            EXPECT_NE(help.out.find(name), std::string::npos) << subcommand << " " << name;
    }
}

TEST(CommandLine, version_is_one_line) {
    const Finished finished = couloir({"--version"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out.rfind("couloir ", 0), 0u) << finished.out;
    EXPECT_EQ(std::count(finished.out.begin(), finished.out.end(), '\n'), 1);
}

TEST(CommandLine, lists_what_ships_for_people_and_as_json) {
    const Finished text = couloir({"list"});
    EXPECT_NE(text.out.find("winter-avalanche       An avalanche"), std::string::npos) << text.out;
    EXPECT_EQ(text.status, 0);
    const Json json = Json::parse(couloir({"list", "--json"}).out);
    for (const char* shelf : {"scenes", "materials", "recordings", "lessons", "terrains"}) {
        ASSERT_TRUE(json[shelf].is_array()) << shelf;
        for (const Json& each : json[shelf])
            EXPECT_NE(text.out.find(each["name"].get<std::string>()), std::string::npos) << shelf;
    }
    EXPECT_GE(json["scenes"].size(), 2u);
    EXPECT_GE(json["materials"].size(), 3u);
}

// Before a window opens.
TEST(CommandLine, refuses_a_lesson_that_it_cannot_give) {
    const support::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "broken.toml";
    write_bytes(file, "title = \"A\"\nrecording = \"none.couloir\"\n");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"play", "--lesson", file.string()},
          {"share", "--lesson", file.string(), "--out", (folder.path() / "page.html").string()},
          {"play", "--lesson", "no-such-lesson"},
          {"play", "winter-valley", "--lesson", "where-will-it-stop"},
          {"share", "--out", (folder.path() / "page.html").string()},
          {"share", "--lesson", "where-will-it-stop", "--beside", "landslide.couloir", "--out",
           (folder.path() / "page.html").string()},
          {"share", "landslide.couloir", "--lesson", "where-will-it-stop", "--out",
           (folder.path() / "page.html").string()}}) {
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, 2) << arguments[0];
        EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
    }
    EXPECT_NE(couloir({"play", "--lesson", file.string()}).err.find("broken.toml:1: stop"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "page.html"));
}

TEST(CommandLine, run_tells_the_same_as_json_on_screen_and_in_the_file) {
    const support::TemporaryFolder folder;
    const auto file = folder.path() / "summary.json";
    const Finished finished = couloir(short_run({"--json", "--summary", file.string()}));
    ASSERT_EQ(finished.status, 0) << finished.err;
    const Json summary = Json::parse(finished.out);
    EXPECT_EQ(finished.out, read_bytes(file));
    for (const char* field : {"program", "scene", "terrain", "material", "model", "squares", "cell_m",
                              "ticks", "seconds", "state_hash", "mass", "measures", "performance"})
        EXPECT_TRUE(summary.contains(field)) << field;
    for (const char* field :
         {"run_out_m", "fall_m", "reach_deg", "extent_ha", "peak_depth_m", "peak_thickness_m",
          "peak_speed_slope_m_s", "peak_speed_plan_m_s", "top", "toe"})
        EXPECT_TRUE(summary["measures"].contains(field)) << field;
    EXPECT_EQ(summary["scene"], "landslide");
    EXPECT_EQ(summary["ticks"], 30);
    EXPECT_EQ(summary["squares"], Json({16, 16}));
    EXPECT_EQ(summary["mass"]["error_quanta"], 0);
    EXPECT_EQ(summary["ended"], "time");
}

// A release of 3200 m3 on a plane of 45 degrees, 20 m wide.
TEST(CommandLine, run_takes_the_friction_of_the_class_of_its_release) {
    const support::TemporaryFolder folder;
    const auto file = [&](const char* name, const std::string& text) {
        write_bytes(folder.path() / name, text);
        return (folder.path() / name).string();
    };
    const std::string header = "ncols 16\nnrows 24\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    std::string heights = header, depths = header;
    for (int row = 0; row < 24; ++row)
        for (int column = 0; column < 16; ++column) {
            heights += fmt::format("{} ", 10 * (23 - row));
            depths += row > 2 && row < 7 && column > 4 && column < 9 ? "2 " : "0 ";
        }
    const std::string material = file("mine.toml",
                                      "[voellmy]\nfriction = 0.3\n[[size]]\nname = \"tiny\"\nbelow = 1000\n"
                                      "friction = 0.5\n[[size]]\nname = \"other\"\nfriction = 0.1\n");
    const std::vector<std::string> usual{"run",
                                         "--terrain",
                                         file("hill.asc", heights),
                                         "--release",
                                         file("release.asc", depths),
                                         "--material",
                                         material,
                                         "--model",
                                         "voellmy",
                                         "--seconds",
                                         "1",
                                         "--json"};
    const auto run = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = usual;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return couloir(arguments);
    };
    const Json by_volume = Json::parse(run({}).out), chosen = Json::parse(run({"--size-class", "tiny"}).out),
               set = Json::parse(run({"--set", "friction=0.5"}).out);
    EXPECT_EQ(by_volume["size_class"]["name"], "other");
    EXPECT_NEAR(by_volume["size_class"]["released_m3"].get<double>(), 3200, 1);
    EXPECT_EQ(chosen["size_class"], Json({{"name", "tiny"}}));
    EXPECT_EQ(chosen["state_hash"], set["state_hash"]) << "--set goes over the class";
    EXPECT_NE(chosen["state_hash"], by_volume["state_hash"]);
    const Finished refused = run({"--size-class", "huge"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("mine has tiny, other"), std::string::npos) << refused.err;
}

// The energy is summed by tiles, so its end must not depend on how many threads swept them.
TEST(CommandLine, run_ends_when_the_energy_is_spent_or_when_nothing_moves) {
    const auto run = [](const std::vector<std::string>& until) {
        std::vector<std::string> arguments{"run", "landslide", "--grid", "48", "--json"};
        arguments.insert(arguments.end(), until.begin(), until.end());
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return Json::parse(finished.out);
    };
    const Json spent = run({"--until-rest"}), still = run({"--until-still"});
    EXPECT_EQ(spent["ended"], "energy");
    EXPECT_GT(spent["mass"]["rolling_m3"], 0);
    EXPECT_EQ(still["ended"], "rest");
    EXPECT_EQ(still["mass"]["rolling_m3"], 0);
    EXPECT_LT(spent["ticks"].get<int>(), still["ticks"].get<int>());
    const Json by_two = run({"--until-rest", "--threads", "2"});
    EXPECT_EQ(by_two["ticks"], spent["ticks"]);
    EXPECT_EQ(by_two["state_hash"], spent["state_hash"]);
    const Finished late = couloir({"run", "landslide", "--grid", "48", "--until-rest", "--seconds", "2"});
    EXPECT_EQ(late.status, 1);
    EXPECT_NE(late.out.find("NOT yet at rest"), std::string::npos) << late.out;
    EXPECT_EQ(couloir({"run", "landslide", "--until-rest", "--until-still"}).status, 2);
}

TEST(CommandLine, run_takes_parameters_and_refuses_what_is_none) {
    const auto hash = [](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"run", "landslide", "--grid", "16", "--seconds", "3"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return Json::parse(finished.out)["state_hash"];
    };
    const Json usual = hash({"--json"});
    EXPECT_NE(hash({"--json", "--set", "drag=20"}), usual);
    EXPECT_EQ(hash({"--json", "--set", "drag=20,erosion_rate=0.5"}),
              hash({"--json", "--set", "erosion_rate=0.5", "--set", "drag=20"}));
    for (const auto& [set, fact] : {std::pair{"start_depth", "NAME=VALUE"},
                                    {"", "NAME=VALUE"},
                                    {"depth=3", "'depth' is not a parameter"},
                                    {"start_depth=11", "0 to 10 m"},
                                    {"start_depth=-1", "0 to 10 m"},
                                    {"start_depth=nan", "0 to 10 m"},
                                    {"rolling_speed=2", "does not use it"},
                                    {"friction=1.9", "friction is above friction_thin"}}) {
        const Finished finished = couloir(short_run({"--set", set}));
        EXPECT_EQ(finished.status, 2) << set;
        EXPECT_NE(finished.err.find("--set"), std::string::npos) << finished.err;
        EXPECT_NE(finished.err.find(fact), std::string::npos) << finished.err;
    }
}

// A hill of 45°, with a pit that is no ground, and a depth raster of 1 m of which half lies beyond it.
TEST(CommandLine, run_says_what_is_lost_of_a_release_and_that_its_hill_has_a_pit) {
    const support::TemporaryFolder folder;
    const auto dem = folder.path() / "hill.asc", release = folder.path() / "release.asc";
    const auto grid = [](double west, const char* usual, const char* first) {
        std::string text = fmt::format("ncols 21\nnrows 21\nxllcenter {}\nyllcenter 0\ncellsize 10\n", west);
        for (int row = 0; row < 21; ++row)
            for (int column = 0; column < 21; ++column)
                text += std::string(row + column == 0 ? first : usual) + (column == 20 ? "\n" : " ");
        return text;
    };
    write_bytes(dem, grid(0, "900", "-99"));
    write_bytes(release, grid(100, "1", "1"));
    const std::vector<std::string> run{"run",       "--terrain", dem.string(), "--release", release.string(),
                                       "--seconds", "0.1"};
    const Finished lossy = couloir(run);
    EXPECT_EQ(lossy.status, 1) << lossy.err;
    EXPECT_NE(lossy.err.find("hill.asc: row 1, column 2 is 900 m high"), std::string::npos) << lossy.err;
    EXPECT_NE(lossy.out.find("release: thickness taken vertically; 44100.0 m3 in the file"),
              std::string::npos)
        << lossy.out;
    EXPECT_NE(lossy.out.find("release: LOST "), std::string::npos) << lossy.out;

    auto accepted = run;
    accepted.insert(accepted.end(), {"--accept-loss", "--json", "--thickness", "normal"});
    const Finished json = couloir(accepted);
    ASSERT_EQ(json.status, 0) << json.err;
    const auto told = Json::parse(json.out)["release"];
    EXPECT_EQ(told["thickness"], "normal");
    EXPECT_GT(told["lost_m3"]["outside"].get<double>(), 0.3 * told["file_m3"].get<double>());
    EXPECT_NEAR(told["ground_m3"].get<double>() + told["lost_m3"]["outside"].get<double>() +
                    told["lost_m3"]["no_data"].get<double>(),
                told["file_m3"].get<double>(), 1);
}

// A plane of 45° in the dialect of ISeeSnow, with a hole, and a release of 1 m normal to it.
TEST(CommandLine, run_exports_what_iseesnow_asks_for) {
    const support::TemporaryFolder folder;
    const auto dem = folder.path() / "DEM_a.asc", release = folder.path() / "rel_1.asc";
    const std::string header = "ncols 20\nnrows 30\nxllcenter 1000.00\nyllcenter -500.00\ncellsize 5.00\n";
    std::string heights = header + "nodata_value -9999.00\n", thickness = header + "nodata_value nan\n";
    for (int row = 0; row < 30; ++row)
        for (int column = 0; column < 20; ++column) {
            heights += row == 0 && column < 2 ? "-9999 " : fmt::format("{} ", 5 * (29 - row));
            thickness += row == 29 ? "nan " : row > 4 && row < 9 && column > 6 && column < 12 ? "1 " : "0 ";
        }
    write_bytes(dem, heights), write_bytes(release, thickness);
    const auto out = folder.path() / "out";
    const std::vector<std::string> run{
        "run",         "--terrain", dem.string(), "--release",       release.string(),
        "--thickness", "normal",    "--model",    "voellmy",         "--seconds",
        "3",           "--export",  out.string(), "--export-format", "iseesnow"};
    const Finished finished = couloir(run);
    ASSERT_EQ(finished.status, 0) << finished.err;
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(out)) names.insert(entry.path().filename());
    EXPECT_EQ(names, (std::set<std::string>{"rel1_DEMa_null_couloir.txt", "rel1_DEMa_null_couloir_pft.asc",
                                            "rel1_DEMa_null_couloir_pfv.asc",
                                            "rel1_DEMa_null_couloir_ppr.asc", "simulationResultTable.csv"}));
    const std::string pft = read_bytes(out / "rel1_DEMa_null_couloir_pft.asc");
    EXPECT_EQ(
        pft.rfind("ncols 20\nnrows 30\nxllcenter 1000\nyllcenter -500\ncellsize 5\nNODATA_value nan\n", 0),
        0u)
        << pft.substr(0, 100);
    std::vector<std::string> rows;
    std::istringstream lines(pft);
    for (std::string line; std::getline(lines, line);) rows.push_back(line);
    ASSERT_EQ(rows.size(), 36u);
    const auto value = [&](int row, int column) {
        std::istringstream line(rows[static_cast<std::size_t>(6 + row)]);
        std::string text;
        for (int i = 0; i <= column; ++i) line >> text;
        return text;
    };
    EXPECT_EQ(value(0, 1), "nan");
    EXPECT_EQ(value(0, 5), "0");
    EXPECT_NEAR(std::stod(value(6, 9)), 1, 5e-3) << "the release is 1 m thick, normal to the slope";
    EXPECT_EQ(couloir({"run", "--terrain", dem.string(), "--release",
                       (out / "rel1_DEMa_null_couloir_pft.asc").string(), "--seconds", "0.1"})
                  .status,
              0)
        << "what it wrote can be read, although it begins with nan";
    const std::string text = read_bytes(out / "rel1_DEMa_null_couloir.txt");
    for (const char* line : {"[MODEL]\n", "model = voellmy\n", "friction = 0.22\n", "drag = 1500\n",
                             "density = 200\n", "cell_m = 5\n", "release = rel_1.asc\n", "flow_time_s = 3"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;

    for (const auto& more : std::vector<std::vector<std::string>>{{"--grid", "20"},
                                                                  {"--export-name", "two_under_scores"},
                                                                  {"--export-name", "none"},
                                                                  {"--export-name", "_"},
                                                                  {"--export-name", "a/b_c"}}) {
        auto wrong = run;
        wrong.insert(wrong.end(), more.begin(), more.end());
        EXPECT_EQ(couloir(wrong).status, 2) << more.back();
    }
    EXPECT_EQ(couloir({"run", "landslide", "--seconds", "1", "--export", out.string(), "--export-format",
                       "iseesnow"})
                  .status,
              2)
        << "a scene has no DEM";
    EXPECT_EQ(couloir({"run", "landslide", "--seconds", "1", "--export-format", "iseesnow"}).status, 2);
    EXPECT_EQ(
        couloir({"run", "landslide", "--seconds", "1", "--export", out.string(), "--export-format", "csv"})
            .status,
        2);
}

TEST(CommandLine, run_and_verified_replay_agree_with_any_number_of_threads) {
    const support::TemporaryFolder folder;
    const auto recording = folder.path() / "slide.couloir";
    const auto hash_of = [](const Arguments& arguments) {
        const Finished finished = couloir(arguments);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return Json::parse(finished.out)["state_hash"].get<std::string>();
    };
    const Arguments run{"run", "landslide", "--grid", "24", "--seconds", "4", "--json"};
    Arguments recorded = run, two = run;
    recorded.insert(recorded.end(), {"--record", recording.string()});
    two.insert(two.end(), {"--threads", "2"});
    const std::string hash = hash_of(recorded);
    EXPECT_EQ(hash_of(two), hash);
    for (const char* threads : {"1", "2", "5"})
        EXPECT_EQ(hash_of({"replay", recording.string(), "--verify", "--json", "--threads", threads}), hash);
    EXPECT_NE(hash_of({"replay", recording.string(), "--until", "200", "--json"}), hash);
}

TEST(CommandLine, a_run_longer_than_an_hour_runs_as_long_as_it_says) {
    const support::TemporaryFolder folder;
    const auto scene = folder.path() / "slow.toml";
    write_bytes(scene,
                "[terrain]\ngenerator = \"slope-of-soil\"\ngrid = 8\n[cover]\nmaterial = "
                "\"soil\"\n[physics]\ntick_s = 0.1\n");
    const Finished finished = couloir({"run", scene.string(), "--seconds", "21601", "--json"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(Json::parse(finished.out)["ticks"], 216010);
}

}  // namespace
}  // namespace game::test
