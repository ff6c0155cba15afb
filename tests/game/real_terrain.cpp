// The command line on a real mountain, with the test data that COULOIR_DEM_DIR names.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/recording/format.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

class RealTerrain : public testing::Test {
  protected:
    void SetUp() override {
        if (!support::dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
    }
    static std::string file(const std::string& name) { return (*support::dem_dir() / "alr" / name).string(); }

    static Json run_to_rest(const std::string& dem) {
        const Finished finished =
            couloir({"run", "--terrain", file(dem), "--release", file("release.geojson"), "--grid", "96",
                     "--until-rest", "--threads", "2", "--json"});
        EXPECT_EQ(finished.status, 0) << finished.err;
        return finished.status == 0 ? Json::parse(finished.out) : Json();
    }

    static void expect_refused(const std::filesystem::path& dem) {
        SCOPED_TRACE(dem.filename().string());
        const Finished finished = couloir({"run", "--terrain", dem.string(), "--release",
                                           file("release.geojson"), "--grid", "32", "--seconds", "1"});
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
        EXPECT_NE(finished.err.find(dem.string()), std::string::npos) << finished.err;
    }
};

// Metres between two places that are at most a few kilometres apart.
double metres_between(const Json& a, const Json& b) {
    const double metres_per_degree = 111200, shrink = std::cos(47.3 * 3.14159265358979323846 / 180);
    return metres_per_degree *
           std::hypot(a["latitude"].get<double>() - b["latitude"].get<double>(),
                      shrink * (a["longitude"].get<double>() - b["longitude"].get<double>()));
}

TEST_F(RealTerrain, runs_the_same_avalanche_from_three_coordinate_systems) {
    std::vector<Json> toes;
    for (const char* dem : {"alr_utm32n.tif", "alr_wgs84.tif", "alr.asc"}) {
        SCOPED_TRACE(dem);
        const Json summary = run_to_rest(dem);
        ASSERT_FALSE(summary.is_null());
        EXPECT_EQ(summary["ended"], "energy");
        EXPECT_EQ(summary["mass"]["error_quanta"], 0);
        EXPECT_GT(summary["measures"]["run_out_m"], 2000);
        EXPECT_LT(summary["measures"]["run_out_m"], 3000);
        toes.push_back(summary["measures"]["toe"]);
    }
    constexpr double kApart = 200;  // m, eight cells
    EXPECT_LT(metres_between(toes[0], toes[1]), kApart);
    EXPECT_LT(metres_between(toes[0], toes[2]), kApart);
}

// A DEM as AvaFrame ships it, without a .prj, and a release in degrees.
TEST_F(RealTerrain, that_names_no_coordinate_system_takes_that_of_the_command_line) {
    const support::TemporaryFolder folder;
    const auto bare = folder.path() / "bare.asc";
    std::filesystem::copy_file(file("alr.asc"), bare);
    const auto top_with = [&](std::vector<std::string> more, const std::filesystem::path& dem) {
        std::vector<std::string> arguments{
            "run",    "--terrain", dem.string(), "--release", file("release.geojson"),
            "--grid", "96",        "--seconds",  "5",         "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished finished = couloir(arguments);
        return finished.status == 0 ? Json::parse(finished.out)["measures"]["top"] : Json(finished.err);
    };
    EXPECT_NE(top_with({}, bare).dump().find("degrees"), std::string::npos) << top_with({}, bare);
    const Json known = top_with({}, file("alr.asc")), named = top_with({"--crs", "31287"}, bare);
    ASSERT_TRUE(known.is_object() && named.is_object()) << known << named;
    EXPECT_LT(metres_between(known, named), 1);
    for (const char* wrong : {"EPSG:4326", "EPSG:", "EPSG:0", "EPSG:31287x", "EPSG:999999", "", "Tyrol",
                              "/etc/passwd", "EPSG:3857"}) {
        const Json refused = top_with({"--crs", wrong}, bare);
        ASSERT_TRUE(refused.is_string()) << wrong;
        EXPECT_NE(refused.dump().find("bare.asc"), std::string::npos) << refused;
    }
    EXPECT_NE(top_with({"--crs", "EPSG:31287"}, file("alr.asc")).dump().find("leave out --crs"),
              std::string::npos);
}

TEST_F(RealTerrain, that_is_damaged_is_refused_in_one_line_that_names_the_file) {
    const support::TemporaryFolder folder;
    for (const char* name : {"alr_utm32n.tif", "alr.asc"}) {
        const std::string whole = read_bytes(file(name));
        ASSERT_GT(whole.size(), 1000u);
        const auto cut = folder.path() / (std::string("cut_") + name);
        write_bytes(cut, whole.substr(0, whole.size() / 2));
        expect_refused(cut);
    }
    const auto empty = folder.path() / "nothing_known.asc";
    std::string text = "ncols 20\nnrows 20\nxllcorner 0\nyllcorner 0\ncellsize 5\nNODATA_value -9999\n";
    for (int row = 0; row < 20; ++row) {
        for (int column = 0; column < 20; ++column) text += "-9999 ";
        text += "\n";
    }
    write_bytes(empty, text);
    expect_refused(empty);
    const auto boast = folder.path() / "boast.asc";
    write_bytes(boast, "ncols 1000000\nnrows 1000000\nxllcorner 0\nyllcorner 0\ncellsize 5\n1 2 3\n");
    expect_refused(boast);
}

// A real landslide near Mount St Helens, compared with the
// observed change of height. Only `mud` with bcre was fitted to it. The soil was wet.
TEST_F(RealTerrain, carries_a_landslide_as_far_as_it_went) {
    const auto landslide = *support::dem_dir() / "landslide";
    const struct {
        const char *material, *model;
        double least_overlap, most_apart, least_carried;  // m
    } trials[] = {{"soil", "bcre-inertial", 0.36, 200, 200},
                  {"mud", "bcre-inertial", 0.39, 170, 200},
                  {"wet-soil", "bcre-inertial", 0.36, 80, 0.9 * 345},
                  {"mud", "bcre", 0.32, 140, 260}};
    for (const auto& trial : trials) {
        SCOPED_TRACE(std::string(trial.material) + ", " + trial.model);
        const Finished finished =
            couloir({"run", "--terrain", (landslide / "pre_runout_DEM.asc").string(), "--release",
                     (landslide / "landslide_depth.asc").string(), "--reference",
                     (landslide / "DEM_of_Difference.asc").string(), "--material", trial.material, "--model",
                     trial.model, "--grid", "122", "--until-still", "--json"});
        ASSERT_EQ(finished.status, 0) << finished.err;
        const Json measures = Json::parse(finished.out)["measures"];
        const Json change = measures["change"];
        EXPECT_NEAR(change["observed"]["carried_m"].get<double>(), 345, 2);
        EXPECT_NEAR(change["observed"]["raised_m3"].get<double>(), 21200, 300);
        EXPECT_GE(measures["overlap"].get<double>(), trial.least_overlap);
        EXPECT_GE(change["here"]["carried_m"].get<double>(), trial.least_carried);
        EXPECT_LE(change["here"]["carried_m"].get<double>(), 1.1 * 345);
        EXPECT_LE(change["apart_m"].get<double>(), trial.most_apart);
        EXPECT_NEAR(change["here"]["raised_m3"].get<double>(), 22200, 400);
    }
}

}  // namespace
}  // namespace game::test
