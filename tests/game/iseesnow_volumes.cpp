// Run-out and top speed of four volumes in the idealised channel of ISeeSnow, beside MoT-Voellmy:
// docs/results/volumes.md. Needs the data that COULOIR_DEM_DIR names.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
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

constexpr std::array kFactors{0.1, 0.25, 1., 4.};  // times the release of ISeeSnow

struct Result {
    std::optional<double> run_out;  // m
    std::optional<double> speed;    // m/s, the greatest along the slope
};
struct Series {
    std::string name, colour;
    std::array<Result, kFactors.size()> results;
};

// MoT-Voellmy (NGI) with the same friction. Its greatest speed with a quarter of the release was not noted.
const Series kReference{
    "MoT-Voellmy", "#333333", {{{2111, 17}, {2286, std::nullopt}, {2411, 41.6}, {2661, 65}}}};

// The release of ISeeSnow with its thickness multiplied.
void write_release(const fs::path& from, double factor, const fs::path& to) {
    std::ifstream in(from);
    std::ofstream out(to);
    std::string line;
    for (int row = 0; std::getline(in, line); ++row) {
        if (row >= 6) {
            std::istringstream words(line);
            line.clear();
            for (std::string word; words >> word;)
                line += fmt::format("{:.6g} ", word == "nan" ? 0. : factor * std::stod(word));
        }
        out << line << '\n';
    }
}

Result result_of(const std::string& model, double factor) {
    const fs::path inputs = *support::dem_dir() / "iseesnow" / "IdealizedTopo";
    const support::TemporaryFolder folder;
    const fs::path release = folder.path() / "release.asc", out = folder.path() / "out";
    write_release(inputs / "release1HSField5m.asc", factor, release);
    const Finished finished = couloir({"run",
                                       "--terrain",
                                       (inputs / "DEM_IdealizedTopo.asc").string(),
                                       "--release",
                                       release.string(),
                                       "--thickness",
                                       "normal",
                                       "--model",
                                       model,
                                       "--material",
                                       "snow-dry",
                                       "--set",
                                       "friction=0.4,drag=2000,cohesion_depth=0",
                                       "--seconds",
                                       "200",
                                       "--export",
                                       out.string(),
                                       "--export-format",
                                       "iseesnow",
                                       "--export-name",
                                       "release1HS_01IdealizedTopo",
                                       "--threads",
                                       "2"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    if (finished.status != 0) return {};
    const auto velocity = iseesnow::Raster::read(out / "release1HS_01IdealizedTopo_null_couloir_pfv.asc");
    const auto path = iseesnow::read_path(inputs / "LINES" / "path_aimec.shp");
    return {iseesnow::run_out(velocity, path, 1), velocity.greatest()};
}

// One panel as SVG, its left edge at `left`: a value of each result over the factors, which are spaced as
// logarithms.
std::string panel(const std::vector<Series>& all, double left, const std::string& label,
                  std::optional<double> Result::*value, double least, double most, double step) {
    constexpr double kWidth = 360, kTop = 50, kHeight = 300;
    const auto x_of = [&](double factor) {
        return left + 20 +
               (kWidth - 40) * std::log(factor / kFactors.front()) /
                   std::log(kFactors.back() / kFactors.front());
    };
    const auto y_of = [&](double y) { return kTop + kHeight * (most - y) / (most - least); };
    std::string svg;
    for (double mark = least; mark <= most; mark += step)
        svg += fmt::format(
            "<line x1='{0}' x2='{1}' y1='{2:.1f}' y2='{2:.1f}' stroke='#dddddd'/>"
            "<text x='{3}' y='{4:.1f}' text-anchor='end'>{5:g}</text>\n",
            left, left + kWidth, y_of(mark), left - 6, y_of(mark) + 4, mark);
    for (const double factor : kFactors)
        svg += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{:g}</text>\n", x_of(factor),
                           kTop + kHeight + 18, factor);
    svg += fmt::format(
        "<text x='{:.1f}' y='{}' text-anchor='middle'>volume, times the release of ISeeSnow</text>\n"
        "<text x='{}' y='{}' font-weight='bold'>{}</text>\n",
        left + kWidth / 2, kTop + kHeight + 38, left, kTop - 12, label);
    for (const Series& series : all) {
        std::string line, dots;
        for (std::size_t i = 0; i < kFactors.size(); ++i) {
            const std::optional<double> y = series.results[i].*value;
            if (!y) continue;
            line += fmt::format("{:.1f},{:.1f} ", x_of(kFactors[i]), y_of(*y));
            dots += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}'/>", x_of(kFactors[i]),
                                y_of(*y), series.colour);
        }
        svg += fmt::format("<polyline points='{}' fill='none' stroke='{}' stroke-width='2'/>{}\n", line,
                           series.colour, dots);
    }
    return svg;
}

// The two panels with a legend, written into the build folder.
void draw(const std::vector<Series>& all) {
    std::ofstream svg(support::build_dir() / "volume-curves.svg");
    svg << "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='430' font-size='13' "
           "font-family='DejaVu Sans'>\n<rect width='900' height='430' fill='white'/>\n"
        << panel(all, 60, "run-out, m", &Result::run_out, 2000, 2800, 100)
        << panel(all, 510, "top speed along the slope, m/s", &Result::speed, 0, 70, 10);
    double x = 60;
    for (const Series& series : all) {
        svg << fmt::format("<circle cx='{}' cy='412' r='5' fill='{}'/><text x='{}' y='417'>{}</text>\n", x,
                           series.colour, x + 11, series.name);
        x += 150;
    }
    svg << "</svg>\n";
}

TEST(IseesnowVolumes, run_out_and_top_speed_grow_with_volume_as_those_of_mot_voellmy) {
    if (!support::dem_dir()) GTEST_SKIP() << "COULOIR_DEM_DIR is not set";
    if (!fs::exists(*support::dem_dir() / "iseesnow"))
        GTEST_SKIP() << "COULOIR_DEM_DIR has no folder iseesnow";
    // bcre-inertial is drawn first: voellmy covers it nearly everywhere.
    std::vector<Series> all{kReference, {"bcre-inertial", "#d55e00", {}}, {"voellmy", "#0072b2", {}}};
    const bool is_long = std::getenv("COULOIR_LONG") != nullptr;
    const std::size_t volumes =
        is_long ? kFactors.size() : kFactors.size() - 2;  // the largest take most of the time
    for (std::size_t which = 1; which < all.size(); ++which) {
        Series& series = all[which];
        for (std::size_t i = 0; i < volumes; ++i) {
            SCOPED_TRACE(fmt::format("{}, volume times {}", series.name, kFactors[i]));
            const Result here = series.results[i] = result_of(series.name, kFactors[i]);
            ASSERT_TRUE(here.run_out && here.speed);
            const Result& reference = kReference.results[i];
            fmt::print("{:<15}{:>6}{:>8.0f} m{:>8.1f} m/s\n", series.name, kFactors[i], *here.run_out,
                       *here.speed);
            EXPECT_NEAR(*here.run_out, *reference.run_out, 0.08 * *reference.run_out);
            if (reference.speed) {
                EXPECT_NEAR(*here.speed, *reference.speed, 0.2 * *reference.speed);
            }
            if (i == 0) continue;
            EXPECT_GT(*here.run_out, *series.results[i - 1].run_out);
            EXPECT_GT(*here.speed, *series.results[i - 1].speed);
        }
    }
    if (is_long) draw(all);
}

}  // namespace
}  // namespace game::test
