#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/bench/against.h"
#include "game/bench/report.h"
#include "game/ensemble/journal.h"
#include "game/files/array_file.h"
#include "game/files/mesh_file.h"
#include "game/files/toml_table.h"
#include "game/recording/recording_file.h"
#include "game/scene/scene.h"
#include "terrains/coverage.h"
#include "terrains/dem_gdal.h"
#include "terrains/geojson.h"
#include "terrains/heightmap_image.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/readers/quadratic.h"
#include "tests/readers/work.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;
using ::test::work;
using ::test::Work;

std::string repeated(int n, const std::function<std::string(int)>& each, const char* between = ",") {
    std::string text;
    for (int i = 0; i < n; ++i) {
        if (i > 0) text += between;
        text += each(i);
    }
    return text;
}

// Recordings.

Scenario ground_of(int nx, int ny) {
    Scenario scenario = small_scenario();
    scenario.grid = {nx, ny, 2.f};
    const std::size_t vertices = scenario.grid.size();
    scenario.bedrock.resize(vertices), scenario.depth.assign(vertices, 0.5f),
        scenario.rolling.assign(vertices, 0.f);
    for (std::size_t i = 0; i < vertices; ++i)
        scenario.bedrock[i] = static_cast<float>(i % 17) * 0.3f + static_cast<float>(i * i % 101) * 0.01f;
    scenario.has_data.assign(vertices, 1);
    return scenario;
}

std::string header_body(const Scenario& scenario, const std::string& more = "") {
    Header header;
    header.scenario = scenario;
    return body_of(to_json(header)) + more;
}

std::string header_with(const std::string& unknown) {
    return chained({header_body(small_scenario(), ",\"unknown\":" + unknown)});
}

std::string with_lines(int n, bool commands) {
    std::vector<std::string> bodies{header_body(small_scenario())};
    std::string line;
    for (int i = 0; i < n; ++i) {
        StateLine state;
        state.tick = 6 * i;
        for (int k = 0; i > 0 && k < 5; ++k) state.before.push_back(static_cast<std::uint64_t>(i * k));
        write(state, line);
        line.pop_back();
        bodies.push_back(std::exchange(line, {}));
        if (!commands) continue;
        TimedCommand pour = some_commands()[0];
        pour.tick = 6 * i;
        write(pour, line);
        line.pop_back();
        bodies.push_back(std::exchange(line, {}));
    }
    bodies.push_back(fmt::format("{{\"end\":{}", 6 * (n - 1)));
    return chained(bodies);
}

// GeoJSON.

std::string ring(int points, double x) {
    return "[" +
           repeated(points,
                    [&](int i) {
                        const double turn = 6.283185307179586 * (i % (points - 1)) / (points - 1);
                        return fmt::format("[{:.9f},{:.9f}]", x + 0.001 * std::cos(turn),
                                           47 + 0.001 * std::sin(turn));
                    }) +
           "]";
}
std::string feature(int points, double x, const std::string& properties = R"("thickness":1.5)") {
    return fmt::format(
        R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"Polygon","coordinates":[{}]}}}})",
        properties, ring(points, x));
}
std::string collection(const std::string& features, const std::string& more = "") {
    return R"({"type":"FeatureCollection")" + more + R"(,"features":[)" + features + "]}";
}

// Other formats.

std::string strip_of_triangles(int n) {
    std::string text;
    for (int i = 0; i < n + 2; ++i) text += fmt::format("v {} {} 0\n", i / 2, i % 2);
    for (int i = 1; i <= n; ++i) text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
    return text;
}

std::string npy(const std::string& shape, std::size_t floats, int spaces) {
    std::string header = fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': {}, }}{}\n", shape,
                                     std::string(static_cast<std::size_t>(spaces), ' '));
    std::string text("\x93NUMPY\x02\x00", 8);
    for (int byte = 0; byte < 4; ++byte) text += static_cast<char>(header.size() >> (8 * byte) & 255);
    return text + header + std::string(floats * sizeof(float), '\0');
}

std::string ascii_grid(int columns, int rows) {
    std::string text =
        fmt::format("ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize 5\n", columns, rows);
    for (int i = 0; i < columns * rows; ++i)
        text += fmt::format("{}{}", 1000 + i % 97, (i + 1) % columns ? ' ' : '\n');
    return text;
}

std::string grey_picture(int columns, int rows) {
    std::string text = fmt::format("P5\n{} {}\n255\n", columns, rows);
    for (int i = 0; i < columns * rows; ++i) text += static_cast<char>(i % 251);
    return text;
}

std::string scene_with(const std::string& more) {
    return R"([terrain]
generator = "slope-of-soil"
grid = 8
[cover]
material = "soil"
[physics]
borders = "wall"
)" + more;
}

// A reader, and a file that grows with n. `accepts`: whether
// the reader accepts the file; a refusal must be as cheap.
struct Growing {
    const char* name;
    int n;  // at 10 n too the file keeps within the limits; 8 or 9 times a power of two, as lists grow in
            // powers
    std::function<std::string(int)> text;
    std::function<bool(const fs::path&)> accepted;
    bool accepts = true;
    const char* ending = ".txt";
};

bool reads_recording(const fs::path& path) {
    return read_recording(path).has_value();
}
bool reads_areas(const fs::path& path) {
    const auto place = terrains::Georeference::local({47, 11}, 0, 0);
    return terrains::read_areas(path, place, terrains::ThicknessNames()).has_value();
}
bool reads_toml(const fs::path& path) {
    return parse_toml(path).has_value();
}
bool reads_scene(const fs::path& path) {
    return load_scene(path.string(), {}).has_value();
}
bool reads_ensemble(const fs::path& path) {
    return read_ensemble_spec(path, {}).has_value();
}
bool reads_journal(const fs::path& path) {
    EnsembleSpec spec;
    spec.identity = "0123456789abcdef";
    spec.variables.emplace_back().of = Variable::Of::kDensity;
    return Journal::open(path, spec).has_value();
}
bool reads_report(const fs::path& path) {
    return read_report(path).has_value();
}
bool reads_array(const fs::path& path) {
    auto array = ArrayFile::open(path);
    if (!array) return false;
    const auto& shape = array->shape();
    std::vector<float> frame(static_cast<std::size_t>(shape.size() > 1 ? shape[1] : 1));
    for (std::int64_t i = 0; i < shape[0]; ++i)
        if (!array->read_frame(frame)) return false;
    return true;
}

const std::vector<Growing>& all_growing() {
    static const std::vector<Growing> kAll{
        {"header_of_empty_objects", 800,
         [](int n) { return header_with("[" + repeated(n, [](int) { return "{}"; }) + "]"); },
         reads_recording},
        {"header_of_empty_lists", 800,
         [](int n) { return header_with("[" + repeated(n, [](int) { return "[]"; }) + "]"); },
         reads_recording},
        {"header_of_objects_of_many_members", 10,
         [](int n) {
             return header_with(
                 "[" +
                 repeated(n,
                          [](int) {
                              return "{" + repeated(90, [](int i) { return fmt::format("\"k{}\":1", i); }) +
                                     "}";
                          }) +
                 "]");
         },
         reads_recording},
        {"header_of_a_long_text", 50'000,
         [](int n) { return header_with("\"" + std::string(static_cast<std::size_t>(n), 'x') + "\""); },
         reads_recording},
        {"header_of_ever_more_depth", 1000,
         [](int n) {
             return header_with(repeated(
                 n, [](int) { return "["; }, ""));
         },
         reads_recording, false},
        {"header_of_too_many_values", 100'000,
         [](int n) { return header_with("[" + repeated(n, [](int) { return "{}"; }) + "]"); },
         reads_recording, false},
        {"header_with_a_large_ground", 40, [](int n) { return chained({header_body(ground_of(n, 100))}); },
         reads_recording},
        {"header_of_things", 150,
         [](int n) {
             Scenario scenario = small_scenario();
             sim::Command fell;
             fell.kind = sim::CommandKind::kFell;
             scenario.standing.placed.assign(static_cast<std::size_t>(n), fell);
             return chained({header_body(scenario)});
         },
         reads_recording},
        {"header_with_a_large_forest", 40,
         [](int n) {
             Scenario scenario = ground_of(n, 100);
             for (std::size_t i = 0; i < scenario.grid.size(); ++i)
                 scenario.standing.forest.push_back(
                     {static_cast<std::uint16_t>(1 + i * i % 1999), 0, 30, 22});
             return chained({header_body(scenario)});
         },
         reads_recording},
        {"state_lines", 400, [](int n) { return with_lines(n, false); }, reads_recording},
        {"commands", 400, [](int n) { return with_lines(n, true); }, reads_recording},
        {"line_of_many_values", 150,
         [](int n) {
             return chained({header_body(small_scenario()),
                             "{\"x\":[" + repeated(n, [](int) { return "{}"; }) + "],\"end\":0"});
         },
         reads_recording},
        // The capacity of a vector of ten times as many is 8 times as large; from 2000 on it would be 16 times.
        {"commands_in_one_tick", 1600,
         [](int n) {
             std::vector<std::string> bodies{header_body(small_scenario())};
             std::string line;
             write(TimedCommand{0, {.kind = sim::CommandKind::kSettle, .radius = 1e5}}, line);
             line.pop_back();
             bodies.insert(bodies.end(), static_cast<std::size_t>(n), line);
             return chained(bodies);
         },
         reads_recording, false},

        {"geojson_of_polygons", 100,
         [](int n) { return collection(repeated(n, [](int i) { return feature(8, 11 + i * 1e-5); })); },
         reads_areas},
        {"geojson_of_one_polygon", 800, [](int n) { return collection(feature(n, 11)); }, reads_areas},
        {"geojson_of_empty_objects", 1000,
         [](int n) {
             return collection(feature(8, 11), ",\"x\":[" + repeated(n, [](int) { return "{}"; }) + "]");
         },
         reads_areas},
        {"geojson_of_properties", 90,
         [](int n) {
             return collection(feature(8, 11, R"("thickness":1,)" + repeated(n, [](int i) {
                                                  return fmt::format("\"p{}\":{}", i, i);
                                              })));
         },
         reads_areas},
        {"geojson_of_rings", 200,
         [](int n) {
             return fmt::format(
                 R"({{"type":"MultiPolygon","thickness":1,"properties":{{"thickness":1}},"coordinates":[[{}]]}})",
                 repeated(n, [](int i) { return ring(5, 11 + i * 1e-5); }));
         },
         reads_areas},

        {"scene_of_commands", 100,
         [](int n) {
             return scene_with(repeated(
                 n,
                 [](int i) {
                     return fmt::format("[[command]]\nat = {}\nsettle = {{ x = 1, y = 2, radius = 3 }}", i);
                 },
                 "\n"));
         },
         reads_scene, true, ".toml"},
        {"scene_of_forests", 100,
         [](int n) {
             return scene_with(repeated(
                 n, [](int) { return "[[forest]]\npolygon = [[10, 10], [90, 10], [50, 90]]"; }, "\n"));
         },
         reads_scene, true, ".toml"},
        {"scene_of_unknown_keys", 400,
         [](int n) {
             return scene_with(repeated(
                 n, [](int i) { return fmt::format("k{} = {}", i, i); }, "\n"));
         },
         reads_scene, false, ".toml"},
        {"ensemble_of_values", 90,
         [](int n) {
             return fmt::format(
                 "scene = \"landslide\"\nmembers = 3\n[[variable]]\nof = \"friction\"\nlist = [{}]",
                 repeated(n, [](int i) { return fmt::format("0.2{}", i); }));
         },
         reads_ensemble, true, ".toml"},
        {"ensemble_of_variables", 100,
         [](int n) {
             return "scene = \"landslide\"\nmembers = 3\n" +
                    repeated(
                        n, [](int) { return "[[variable]]\nof = \"friction\"\nuniform = [0.2, 0.3]"; }, "\n");
         },
         reads_ensemble, false, ".toml"},
        {"journal_of_members", 800,
         [](int n) {
             return R"({"couloir":"ensemble","format":1,"ensemble":"0123456789abcdef","variables":["density"]})"
                    "\n" +
                    repeated(
                        n,
                        [](int i) {
                            return fmt::format(R"({{"fault":"none","member":{},"sample":[1]}})", i + 1);
                        },
                        "\n");
         },
         reads_journal, true, ".jsonl"},
        {"toml_of_tables", 100,
         [](int n) {
             return repeated(
                 n, [](int i) { return fmt::format("[t{}]\na = 1", i); }, "\n");
         },
         reads_toml},
        {"toml_of_lists_of_tables", 100,
         [](int n) {
             return repeated(
                 n, [](int i) { return fmt::format("[[t{}]]\na = 1", i); }, "\n");
         },
         reads_toml},
        {"toml_of_dotted_keys", 80,
         [](int n) {
             return repeated(
                 n, [](int i) { return fmt::format("a.b{}.c = 1", i); }, "\n");
         },
         reads_toml},
        {"toml_of_dotted_headers", 80,
         [](int n) {
             return repeated(
                 n, [](int i) { return fmt::format("[a.b{}.c]", i); }, "\n");
         },
         reads_toml},
        {"toml_of_a_long_key", 2000,
         [](int n) {
             return repeated(
                        n, [](int) { return "a"; }, ".") +
                    " = 1\n";
         },
         reads_toml, false},
        {"toml_of_depth", 1000, [](int n) { return "a = " + std::string(static_cast<std::size_t>(n), '['); },
         reads_toml, false},
        {"toml_of_numbers", 1000,
         [](int n) { return "a = [" + repeated(n, [](int i) { return fmt::format("{}.5", i); }) + "]\n"; },
         reads_toml},
        {"toml_of_a_long_text", 20'000,
         [](int n) {
             return "a = \"" + std::string(static_cast<std::size_t>(n), '.') + "\" # " +
                    std::string(static_cast<std::size_t>(n), '.') + "\n";
         },
         reads_toml},

        {"report_of_cases", 100,
         [](int n) {
             return fmt::format(
                 R"({{"format":"{}","version":{},"cases":[{}]}})", kBenchFormat, kBenchVersion,
                 repeated(n, [](int i) {
                     return fmt::format(
                         R"({{"recording":"r{}","squares":8,"physics":"p","end_hash":"","stages":{{"draw":{{"count":0}}}}}})",
                         i);
                 }));
         },
         reads_report},
        {"report_of_empty_objects", 800,
         [](int n) { return R"({"x":[)" + repeated(n, [](int) { return "{}"; }) + "]}"; }, reads_report,
         false},

        {"obj_of_triangles", 400, strip_of_triangles,
         [](const fs::path& path) { return read_obj(path).has_value(); }},
        {"obj_of_comments", 1000,
         [](int n) {
             return strip_of_triangles(1) +
                    repeated(
                        n, [](int) { return "# -"; }, "\n") +
                    "\n";
         },
         [](const fs::path& path) { return read_obj(path).has_value(); }},
        {"obj_of_a_fan", 400,
         [](int n) {
             std::string text = "v 0 0 0\n";
             for (int i = 0; i <= n; ++i) {
                 const double turn = 6 * i / static_cast<double>(n);
                 text += fmt::format("v {} {} 0\n", 1000 * std::cos(turn), 1000 * std::sin(turn));
             }
             for (int i = 2; i < n + 2; ++i) text += fmt::format("f 1 {} {}\n", i, i + 1);
             return text;
         },
         [](const fs::path& path) { return read_obj(path).has_value(); }},

        {"npy_of_frames", 100,
         [](int n) { return npy(fmt::format("({}, 50)", n), static_cast<std::size_t>(50 * n), 0); },
         reads_array},
        {"npy_of_a_long_header", 6000, [](int n) { return npy("(1,)", 1, n); }, reads_array},
        {"npy_of_axes", 6000,
         [](int n) { return npy("(" + repeated(n, [](int) { return "1"; }) + ")", 1, 0); }, reads_array,
         false},

        {"dem_of_pixels", 40, [](int n) { return ascii_grid(100, n); },
         [](const fs::path& path) { return terrains::read_dem(path, 16).has_value(); }, true, ".asc"},
        {"picture_of_pixels", 40, [](int n) { return grey_picture(100, n); },
         [](const fs::path& path) {
             return terrains::read_heightmap(path, {.cell = 5, .lowest = 0, .highest = 100}, 16).has_value();
         },
         true, ".pgm"},
    };
    return kAll;
}

class Growth : public testing::TestWithParam<int> {
  protected:
    struct Read {
        double size;  // of the file, bytes
        Work work;
    };
    Read read(const Growing& growing, int n) const {
        const fs::path path = folder_.path() / (std::to_string(n) + growing.ending);
        write_bytes(path, growing.text(n));
        EXPECT_EQ(growing.accepted(path), growing.accepts)
            << n;  // a first run, because libraries allocate caches in it
        const Work before = work();
        growing.accepted(path);
        return {static_cast<double>(fs::file_size(path)), work() - before};
    }
    support::TemporaryFolder folder_;
};

constexpr double kMostGrowth = 11;

// Ten times the input may cost at most eleven times the steps and bytes. A file that grows more than tenfold,
// because its numbers and names get longer, may cost accordingly more. Steps are basic blocks of our own
// sources and their header-only parsers; work inside a library shows only in its bytes.
TEST_P(Growth, is_at_most_linear_in_steps_and_in_bytes) {
    const Growing& growing = all_growing()[static_cast<std::size_t>(GetParam())];
    const Read small = read(growing, growing.n), large = read(growing, 10 * growing.n);
    const double most = kMostGrowth * std::max(1.0, large.size / small.size / 10);
    EXPECT_GT(small.work.steps, 0);
    EXPECT_LE(large.work.steps, most * static_cast<double>(small.work.steps)) << small.work.steps;
    EXPECT_LE(large.work.bytes, most * static_cast<double>(small.work.bytes)) << small.work.bytes;
    RecordProperty("steps", fmt::format("{} {}", small.work.steps, large.work.steps));
    RecordProperty("bytes", fmt::format("{} {}", small.work.bytes, large.work.bytes));
}

INSTANTIATE_TEST_SUITE_P(Readers, Growth, testing::Range(0, static_cast<int>(all_growing().size())),
                         [](const auto& info) {
                             return std::string(all_growing()[static_cast<std::size_t>(info.param)].name);
                         });

// Overlapping areas cost as much as their description, not as much again as all that they cover.
TEST(Coverage, takes_hardly_longer_for_a_hundred_areas_than_for_one) {
    const sim::Grid grid{257, 257, 10.f};
    const terrains::Area everywhere{{{{-10, -10}, {3000, -10}, {3000, 3000}, {-10, 3000}}}, 1};
    const auto steps_of = [&](std::size_t areas) {
        const std::int64_t before = work().steps;
        EXPECT_TRUE(terrains::cover(grid, std::vector(areas, everywhere)).has_value());
        return work().steps - before;
    };
    EXPECT_LT(steps_of(100), 6 * steps_of(1));
}

// The step counter must detect a quadratic reader.
TEST(Work, sees_a_scan_that_takes_no_memory) {
    const auto steps_of = [](int n) {
        const std::string text = "[" + repeated(n, [](int) { return "{}"; }) + "]";
        const std::int64_t before = work().steps;
        ::test::parse_with_callback(text);
        return work().steps - before;
    };
    EXPECT_GT(steps_of(2000), 50 * steps_of(200));
}

}  // namespace
}  // namespace game::test
