// The cases of ISeeSnow (github.com/avaframe/ISeeSnow), run from the command line on its own files, and measured
// as its participants' results were: docs/results/iseesnow.md. Needs the data that COULOIR_DEM_DIR names.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/game/iseesnow_files.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

using iseesnow::place_at;
using iseesnow::Point;
using iseesnow::Raster;
using iseesnow::read_path;
using iseesnow::run_out;

// What the participants submitted, without this program: least, median and greatest.
struct Band {
    double least, median, greatest;
};
struct Case {
    const char *name, *id, *set;
    Band run_out_velocity, run_out_thickness, angle, area, velocity, thickness;
};
constexpr Case kCases[] = {{"CoulombOnly",
                            "03CoulombOnly",
                            "friction=0.4,drag=1000000",
                            {2950, 3195, 3610},
                            {2910, 3130, 3610},
                            {22.2, 24.7, 26.5},
                            {38, 45.8, 65.1},
                            {90.5, 103.1, 322.6},
                            {4, 6, 10}},
                           {"IdealizedTopo",
                            "01IdealizedTopo",
                            "friction=0.4,drag=2000",
                            {2265, 2285, 2400},
                            {2280, 2300, 2400},
                            {31.5, 32.8, 33},
                            {16.5, 22.9, 41.2},
                            {10.9, 37.9, 41.6},
                            {4.6, 8, 27.1}}};

class Iseesnow : public testing::TestWithParam<Case> {
  protected:
    void SetUp() override {
        if (!support::dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
        if (!fs::exists(*support::dem_dir() / "iseesnow"))
            GTEST_SKIP() << "COULOIR_DEM_DIR has no folder iseesnow";
    }
};

TEST_P(Iseesnow, result_lies_within_the_band_of_the_participants) {
    const Case& each = GetParam();
    const fs::path inputs = *support::dem_dir() / "iseesnow" / each.name;
    const fs::path dem = inputs / (std::string("DEM_") + each.name + ".asc");
    const support::TemporaryFolder folder;
    const std::string name = std::string("release1HS_") + each.id;
    const Finished finished = couloir({"run",
                                       "--terrain",
                                       dem.string(),
                                       "--release",
                                       (inputs / "release1HSField5m.asc").string(),
                                       "--thickness",
                                       "normal",
                                       "--model",
                                       "voellmy",
                                       "--set",
                                       each.set,
                                       "--seconds",
                                       "200",
                                       "--export",
                                       folder.path().string(),
                                       "--export-format",
                                       "iseesnow",
                                       "--export-name",
                                       name,
                                       "--threads",
                                       "2",
                                       "--json"});
    ASSERT_EQ(finished.status, 0) << finished.err;
    const auto raster = [&](const char* what) {
        return Raster::read(folder.path() / fmt::format("{}_null_couloir_{}.asc", name, what));
    };
    const Raster ground = Raster::read(dem), velocity = raster("pfv"), thickness = raster("pft"),
                 pressure = raster("ppr");
    for (const Raster* result : {&velocity, &thickness, &pressure}) {
        EXPECT_EQ(result->columns, ground.columns);
        EXPECT_EQ(result->rows, ground.rows);
        EXPECT_EQ(result->west, ground.west);
        EXPECT_EQ(result->south, ground.south);
        EXPECT_EQ(result->cell, ground.cell);
        EXPECT_EQ(result->header.at("nodata_value"), "nan");
        ASSERT_EQ(result->values.size(), ground.values.size());
    }
    EXPECT_NEAR(pressure.greatest(), 0.2 * std::pow(velocity.greatest(), 2), 1e-4 * pressure.greatest());

    const std::vector<Point> path = read_path(inputs / "LINES" / "path_aimec.shp");
    const double by_velocity = run_out(velocity, path, 1), by_thickness = run_out(thickness, path, 0.1);
    const Point top = path.front(), toe = place_at(path, by_velocity);
    const double angle =
        std::atan2(ground.between(top.x, top.y) - ground.between(toe.x, toe.y), by_velocity) * 180 /
        3.14159265358979323846;
    const auto area = [](const Raster& of, double least) {
        const auto count =
            std::count_if(of.values.begin(), of.values.end(), [&](double value) { return value >= least; });
        return static_cast<double>(count) * of.cell * of.cell / 1e4;
    };
    fmt::print("{}: area by velocity {:.1f} ha, by thickness {:.1f} ha\n", each.name, area(velocity, 1),
               area(thickness, 0.1));
    const struct {
        const char* what;
        double ours;
        Band band;
    } rows[] = {{"run-out by velocity, m", by_velocity, each.run_out_velocity},
                {"run-out by thickness, m", by_thickness, each.run_out_thickness},
                {"angle, deg", angle, each.angle},
                {"area, ha", area(thickness, 0.1), each.area},
                {"peak velocity, m/s", velocity.greatest(), each.velocity},
                {"peak thickness, m", thickness.greatest(), each.thickness}};
    fmt::print("{:<26}{:>10}{:>10}{:>10}{:>10}\n", each.name, "couloir", "least", "median", "greatest");
    for (const auto& row : rows) {
        fmt::print("{:<26}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}\n", row.what, row.ours, row.band.least,
                   row.band.median, row.band.greatest);
        EXPECT_GE(row.ours, row.band.least) << row.what;
        EXPECT_LE(row.ours, row.band.greatest) << row.what;
    }
}

INSTANTIATE_TEST_SUITE_P(Case, Iseesnow, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace game::test
