// The cases of ISeeSnow (github.com/avaframe/ISeeSnow), run from the command line on its own files, and measured
// as its participants' results were: docs/results/iseesnow.md. Needs the data that COULOIR_DEM_DIR names.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

// A raster as ISeeSnow writes it. Rows from north to south.
struct Raster {
    std::map<std::string, std::string> header;  // keys in lower case
    int columns = 0, rows = 0;
    double west = 0, south = 0, cell = 0;  // of the centre of the south-west pixel
    std::vector<double> values;

    static Raster read(const fs::path& path) {
        std::ifstream file(path);
        Raster raster;
        std::string key, value;
        for (int i = 0; i < 6; ++i) {
            file >> key >> value;
            std::transform(key.begin(), key.end(), key.begin(), [](char c) { return std::tolower(c); });
            raster.header[key] = value;
        }
        const auto number = [&](const char* name) { return std::stod(raster.header.at(name)); };
        raster.columns = static_cast<int>(number("ncols")), raster.rows = static_cast<int>(number("nrows"));
        raster.west = number("xllcenter"), raster.south = number("yllcenter");
        raster.cell = number("cellsize");
        while (file >> value)
            raster.values.push_back(value == "nan" ? std::numeric_limits<double>::quiet_NaN()
                                                   : std::stod(value));
        return raster;
    }
    double x(int column) const { return west + cell * column; }
    double y(int row) const { return south + cell * (rows - 1 - row); }
    double at(int column, int row) const {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
    // Bilinear.
    double between(double px, double py) const {
        const double c = (px - west) / cell, r = rows - 1 - (py - south) / cell;
        const int i = std::clamp(static_cast<int>(c), 0, columns - 2),
                  j = std::clamp(static_cast<int>(r), 0, rows - 2);
        const double u = c - i, v = r - j;
        return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
               v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
    }
    double greatest() const {
        double most = 0;
        for (const double value : values) most = std::max(most, std::isnan(value) ? 0 : value);
        return most;
    }
};

struct Point {
    double x, y;
};

// The first polyline of a shapefile.
std::vector<Point> read_path(const fs::path& path) {
    const std::string bytes = read_bytes(path);
    const auto number = [&]<class T>(std::size_t at, T value) {
        std::memcpy(&value, bytes.data() + at, sizeof value);
        return value;
    };
    constexpr std::size_t kRecord = 100 + 8;  // after the file's and the record's header
    const auto parts = number(kRecord + 36, std::int32_t{}), points = number(kRecord + 40, std::int32_t{});
    std::vector<Point> line;
    for (int i = 0; i < points; ++i) {
        const std::size_t at =
            kRecord + 44 + 4 * static_cast<std::size_t>(parts) + 16 * static_cast<std::size_t>(i);
        line.push_back({number(at, 0.), number(at + 8, 0.)});
    }
    return line;
}

// The farthest station along the path, m in plan, of a pixel that reaches `least` within 700 m of the path.
double run_out(const Raster& raster, const std::vector<Point>& path, double least) {
    constexpr double kWidth = 700;
    double farthest = 0;
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column) {
            if (!(raster.at(column, row) >= least)) continue;
            double nearest = kWidth, station = 0, passed = 0;
            for (std::size_t i = 1; i < path.size(); ++i) {
                const double dx = path[i].x - path[i - 1].x, dy = path[i].y - path[i - 1].y;
                const double length = std::hypot(dx, dy);
                const double px = raster.x(column) - path[i - 1].x, py = raster.y(row) - path[i - 1].y;
                const double along = std::clamp((px * dx + py * dy) / length, 0., length);
                const double away = std::hypot(px - dx * along / length, py - dy * along / length);
                if (away <= nearest) nearest = away, station = passed + along;
                passed += length;
            }
            if (nearest < kWidth) farthest = std::max(farthest, station);
        }
    return farthest;
}

Point place_at(const std::vector<Point>& path, double station) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double length = std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
        if (station <= length || i + 1 == path.size()) {
            const double share = station / length;
            return {path[i - 1].x + share * (path[i].x - path[i - 1].x),
                    path[i - 1].y + share * (path[i].y - path[i - 1].y)};
        }
        station -= length;
    }
    return path.front();
}

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
