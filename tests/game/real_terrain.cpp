// The command line on a real mountain, from the trial data that COULOIR_DEM_DIR names.
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

// Metres between two places a few kilometres apart at most.
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
        EXPECT_EQ(summary["at_rest"], true);
        EXPECT_EQ(summary["mass"]["error_quanta"], 0);
        EXPECT_EQ(summary["mass"]["rolling_m3"], 0);
        EXPECT_GT(summary["measures"]["run_out_m"], 2000);
        EXPECT_LT(summary["measures"]["run_out_m"], 3000);
        toes.push_back(summary["measures"]["toe"]);
    }
    EXPECT_LT(metres_between(toes[0], toes[1]), 150);
    EXPECT_LT(metres_between(toes[0], toes[2]), 150);
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

}  // namespace
}  // namespace game::test
