#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/base/number.h"
#include "game/files/array_file.h"
#include "game/files/mesh_file.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

using namespace std::string_literals;

constexpr int kSquares = 12, kRow = kSquares + 1, kVertices = kRow * kRow;

// A unit square divided into squares, each of two triangles.
std::string square_obj() {
    std::string text = "# made by a test\nmtllib none.mtl\n";
    for (int v = 0; v < kVertices; ++v)
        text += fmt::format("v {:.6f} {:.6f} {}\n", 1.0 * (v % kRow) / kSquares, 1.0 * (v / kRow) / kSquares,
                            v % 7);
    for (int y = 0; y < kSquares; ++y)
        for (int x = 0; x < kSquares; ++x) {
            const int v = y * kRow + x + 1;
            text += fmt::format("f {} {}/1 {}//2\r\n", v, v + 1, v + kRow + 1);
            text += fmt::format("f {} {} {}\n", v - kVertices - 1, v + kRow - kVertices,
                                v + kRow - 1 - kVertices);
        }
    return text;
}

std::string npy(const std::string& header, const std::string& data) {
    std::string padded = header;
    while ((padded.size() + 11) % 64 != 0) padded += ' ';
    padded += '\n';
    return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(padded.size() & 255) +
           static_cast<char>(padded.size() >> 8) + padded + data;
}
std::string header_of(const std::string& type, const std::string& shape, const char* fortran = "False") {
    return fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}", type, fortran, shape);
}
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

class Track : public testing::Test {
  protected:
    std::string put(const std::string& name, const std::string& bytes) const {
        write_bytes(folder_.path() / name, bytes);
        return (folder_.path() / name).string();
    }
    std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
    std::string mesh() const { return put("mesh.obj", square_obj()); }

    // Opposed flows on either side of y = `height(frame)`.
    std::string lines(int frames, const std::function<double(int)>& height) const {
        std::vector<double> numbers;
        for (int frame = 0; frame < frames; ++frame)
            for (int v = 0; v < kVertices; ++v) {
                numbers.push_back(1.0 * (v / kRow) / kSquares < height(frame) ? 0.2 : -0.2);
                numbers.push_back(0);
            }
        return put("v.npy",
                   npy(header_of("<f8", fmt::format("({}, {}, 2)", frames, kVertices)), bytes_of(numbers)));
    }

  private:
    support::TemporaryFolder folder_;
};

struct Line {
    int frame, i, j;
    double time, f, x, y, w;
};
std::vector<Line> lines_of(const std::string& csv) {
    std::istringstream text(csv);
    std::string row;
    std::getline(text, row);
    EXPECT_EQ(row, "frame,time_s,i,j,f,x,y,w");
    std::vector<Line> lines;
    while (std::getline(text, row)) {
        std::vector<double> cells;
        std::istringstream texts(row);
        for (std::string cell; std::getline(texts, cell, ',');) {
            const auto number = number_from<double>(cell);
            EXPECT_TRUE(number) << cell << " in " << row;
            cells.push_back(number.value_or(-1));
        }
        EXPECT_EQ(cells.size(), 8u) << row;
        cells.resize(8);
        lines.push_back({static_cast<int>(cells[0]), static_cast<int>(cells[2]), static_cast<int>(cells[3]),
                         cells[1], cells[4], cells[5], cells[6], cells[7]});
    }
    return lines;
}

TEST_F(Track, prints_where_a_front_crosses_the_edges_and_how_fast) {
    const auto height = [](int frame) { return 0.1 + 0.2 * frame / 60; };
    const std::string velocities = lines(120, height);
    const Finished done = couloir({"track", mesh(), velocities, "--jump", "0.1"});
    ASSERT_EQ(done.status, 0) << done.err;
    const std::vector<Line> points = lines_of(done.out);
    ASSERT_GT(points.size(), 120u * kSquares);
    for (const Line& point : points) {
        EXPECT_LT(point.i, point.j);
        EXPECT_NEAR(point.time, point.frame / 60.0, 1e-6);
        const double from = 1.0 * (point.i / kRow) / kSquares, to = 1.0 * (point.j / kRow) / kSquares;
        EXPECT_NEAR(point.y, from + point.f * (to - from), 1e-5);
        if (point.frame < 80) continue;
        EXPECT_NEAR(point.y, height(point.frame), 0.15 / kSquares);
        const double length = point.j % kRow == point.i % kRow ? 1 : std::sqrt(2.0);
        EXPECT_NEAR(point.w, 0.2 * length, 0.04 * length);
    }
    EXPECT_NE(done.err.find("120 frames of 169 vertices"), std::string::npos) << done.err;
    EXPECT_EQ(done.err.find("warning"), std::string::npos) << done.err;
}

TEST_F(Track, holds_points_behind_their_front_if_requested) {
    // Twice as fast from frame 90 on, so that its points are late at the next vertices.
    const auto height = [](int frame) { return 0.1 + 0.1 * (frame + std::max(0, frame - 90)) / 60; };
    const std::string obj = mesh(), velocities = lines(120, height);
    const auto edges_left_behind = [&](const std::vector<std::string>& options) {
        std::vector<std::string> all{"track", obj, velocities, "--jump", "0.1", "--source", "paper"};
        all.insert(all.end(), options.begin(), options.end());
        const Finished done = couloir(all);
        EXPECT_EQ(done.status, 0) << done.err;
        const std::vector<Line> points = lines_of(done.out);
        return std::count_if(points.begin(), points.end(), [&](const Line& point) {
            return 1.0 * (point.j / kRow) / kSquares < height(point.frame);
        });
    };
    EXPECT_EQ(edges_left_behind({}), 0);
    EXPECT_GT(edges_left_behind({"--hold"}), kSquares);
}

TEST_F(Track, follows_a_level) {
    std::vector<float> scalar;
    for (int frame = 0; frame < 10; ++frame)
        for (int v = 0; v < kVertices; ++v)
            scalar.push_back(static_cast<float>(1.0 * (v / kRow) / kSquares - 0.31 - 0.01 * frame));
    const std::string level =
        put("r.npy", npy(header_of("<f4", fmt::format("(10, {})", kVertices)), bytes_of(scalar)));
    const Finished done = couloir({"track", mesh(), lines(10, [](int) { return 2.0; }), "--source", "level",
                                   "--scalar", level, "--level", "0", "--dt", "0.5"});
    ASSERT_EQ(done.status, 0) << done.err;
    const std::vector<Line> points = lines_of(done.out);
    EXPECT_EQ(points.size(), 10u * (kRow + kSquares));
    for (const Line& point : points) {
        EXPECT_NEAR(point.y, 0.31 + 0.01 * point.frame, 1e-5);
        EXPECT_NEAR(point.time, 0.5 * point.frame, 1e-6);
    }
}

TEST_F(Track, warns_of_fronts_that_outrun_the_steps) {
    const std::string velocities = lines(60, [](int frame) { return 0.7 * frame / kSquares; });
    const Finished fast = couloir({"track", mesh(), velocities, "--jump", "0.1"});
    EXPECT_EQ(fast.status, 0);
    EXPECT_NE(fast.err.find("warning: in "), std::string::npos) << fast.err;
    const std::string slower = lines(60, [](int frame) { return 0.3 * frame / kSquares; });
    const Finished slow = couloir({"track", mesh(), slower, "--jump", "0.1"});
    EXPECT_EQ(slow.err.find("warning"), std::string::npos) << slow.err;
}

TEST_F(Track, writes_a_whole_file_and_pictures) {
    const Finished done =
        couloir({"track", mesh(), lines(20, [](int) { return 0.52; }), "--jump", "0.1", "--out",
                 at("new/points.csv"), "--frames", at("pictures"), "--every", "10", "--size", "64x48"});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(lines_of(read_bytes(at("new/points.csv"))).size(), 20u * (kRow + kSquares));
    for (const char* name : {"pictures/front_000000.png", "pictures/front_000010.png"})
        EXPECT_EQ(read_bytes(at(name)).substr(1, 3), "PNG");
    EXPECT_EQ(read_bytes(at("pictures/front_000001.png")), "");
}

TEST_F(Track, leaves_no_output_if_its_input_ends_in_damage) {
    std::vector<float> numbers(static_cast<std::size_t>(3) * 2 * kVertices, 0.f);
    numbers[(static_cast<std::size_t>(2) * kVertices + 17) * 2 + 1] = std::numeric_limits<float>::quiet_NaN();
    const std::string velocities =
        put("v.npy", npy(header_of("<f4", fmt::format("(3, {}, 2)", kVertices)), bytes_of(numbers)));
    const Finished done = couloir({"track", mesh(), velocities, "--jump", "0.1", "--out", at("points.csv")});
    EXPECT_EQ(done.status, 2);
    EXPECT_EQ(done.err, "couloir: " + velocities + ": frame 2, vertex 17: not a finite number\n");
    EXPECT_FALSE(std::filesystem::exists(at("points.csv")));
    EXPECT_FALSE(std::filesystem::exists(at("points.csv.part")));
}

TEST_F(Track, refuses_inconsistent_inputs) {
    const std::string obj = mesh(), velocities = lines(3, [](int) { return 0.5; });
    const std::string other = put("w.npy", npy(header_of("<f4", "(3, 7, 2)"), std::string(168, '\0')));
    const std::string scalar = put(
        "r.npy", npy(header_of("<f4", fmt::format("(4, {})", kVertices)), std::string(16 * kVertices, '\0')));
    const std::pair<std::vector<std::string>, const char*> wrong[] = {
        {{obj, velocities}, "--jump or --threshold"},
        {{obj, velocities, "--jump", "0"}, "--jump"},
        {{obj, velocities, "--jump", "nan"}, "--jump"},
        {{obj, velocities, "--jump", "1", "--dt", "-1"}, "--dt"},
        {{obj, velocities, "--jump", "1", "--dt", "inf"}, "--dt"},
        {{obj, velocities, "--jump", "1", "--source", "third"}, "--source"},
        {{obj, velocities, "--jump", "1", "--rule", "level"}, "--rule"},
        {{obj, velocities, "--rule", "relative", "--threshold", "1"}, "--threshold"},
        {{obj, velocities, "--jump", "1", "--hold"}, "--hold"},
        {{obj, velocities, "--jump", "1", "--level", "1"}, "--source level"},
        {{obj, velocities, "--source", "level", "--level", "1"}, "--scalar"},
        {{obj, velocities, "--source", "level", "--scalar", scalar}, "--level"},
        {{obj, velocities, "--source", "level", "--scalar", scalar, "--level", "nan"}, "--level"},
        {{obj, velocities, "--source", "level", "--scalar", scalar, "--level", "1"}, "has 3 frames and"},
        {{obj, other, "--jump", "1"}, "(3, 7, 2)"},
        {{obj, scalar, "--jump", "1"}, "frames × 169 vertices × 2"},
        {{obj, at("none.npy"), "--jump", "1"}, "none.npy: there is no such file"},
        {{at("none.obj"), velocities, "--jump", "1"}, "none.obj: there is no such file"},
    };
    for (const auto& [arguments, told] : wrong) {
        std::vector<std::string> all{"track"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Finished done = couloir(all);
        EXPECT_EQ(done.status, 2) << told;
        EXPECT_EQ(done.out, "") << told;
        EXPECT_NE(done.err.find(told), std::string::npos) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    }
}

TEST_F(Track, quotes_any_file_in_one_line) {
    const std::string velocities = put("v.npy", npy("{'descr': '\n\x1b[31m\r\0<f4', 'fortran_order'"s, ""));
    const Finished done = couloir({"track", mesh(), velocities, "--jump", "1"});
    EXPECT_EQ(done.status, 2);
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_EQ(std::count_if(done.err.begin(), done.err.end(), [](char c) { return c >= 0 && c < ' '; }), 1);
    EXPECT_NE(done.err.find("<f4"), std::string::npos) << done.err;
}

TEST_F(Track, prints_finite_numbers_only_whatever_the_velocities_and_times) {
    std::size_t printed = 0;
    for (const double speed : {1e-38, 1e-9, 1.0, 1e18, 3e38}) {
        std::vector<float> numbers;
        for (int frame = 0; frame < 3; ++frame)
            for (int v = 0; v < kVertices; ++v) {
                numbers.push_back(static_cast<float>(v / kRow < 5 + frame ? speed : -speed));
                numbers.push_back(0);
            }
        const std::string velocities =
            put("v.npy", npy(header_of("<f4", fmt::format("(3, {}, 2)", kVertices)), bytes_of(numbers)));
        for (const char* source : {"half", "paper", "fit"})
            for (const char* dt : {"1e-6", "1", "1e6"})
                for (const char* jump : {"1e-300", "0.1", "1e300"}) {
                    const Finished done = couloir(
                        {"track", mesh(), velocities, "--jump", jump, "--dt", dt, "--source", source});
                    SCOPED_TRACE(
                        fmt::format("{}, speed {}, dt {}, jump {}: {}", source, speed, dt, jump, done.err));
                    ASSERT_TRUE(done.status == 0 || done.status == 2);
                    if (done.status == 0) printed += lines_of(done.out).size();
                }
    }
    EXPECT_GT(printed, 0u);
}

TEST_F(Track, names_the_line_of_a_damaged_mesh) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const std::pair<std::string, const char*> wrong[] = {
        {corners + "f 1 2 4 3\n", ":5: a face with 4 corners"},
        {corners + "f 1 2\n", ":5: a face with 2 corners"},
        {corners + "f 1 2 5\n", ":5: a triangle with a vertex"},
        {corners + "f 1 2 -5\n", ":5: a triangle with a vertex"},
        {corners + "f 1 2 0\n", ":5: '0' is not a vertex index"},
        {corners + "f 1 2 x\n", ":5: 'x' is not a vertex index"},
        {corners + "f 1 2 99999999999\n", ":5: '99999999999' is not a vertex index"},
        {corners + "f 1 2 2\n", ":5: a triangle"},
        {corners + "f 1 2 3\nf 1 2 4\nf 2 1 4\n", ":7: "},
        {corners + "v 1e-31 0 0\nv 0 1e-31 0\nf 1 5 6\n", ":7: a triangle"},
        {corners + "v 1e30 0 0\nf 1 5 3\n", ":6: a triangle"},
        {corners + "v 2 nan 0\nf 1 2 3\n", ":5: 'nan' is not a coordinate"},
        {corners + "v 2 1e99 0\nf 1 2 3\n", ":5: '1e99' is not a coordinate"},
        {corners + "v 2 two 0\nf 1 2 3\n", ":5: 'two' is not a coordinate"},
        {corners + "v 2 3\nf 1 2 3\n", ":5: a vertex"},
        {corners + "# " + std::string(70000, 'x') + "\nf 1 2 3\n", ":5: longer than 65536 characters"},
        {corners, ": has no triangles"},
        {"", ": has no triangles"},
    };
    for (const auto& [text, told] : wrong) {
        const auto read = read_obj(put("bad.obj", text));
        ASSERT_FALSE(read) << told;
        EXPECT_EQ(read.error().status, Failure::kUnusable);
        EXPECT_EQ(read.error().sentence.rfind(at("bad.obj") + told, 0), 0u) << read.error().sentence;
    }
}

// Every accepted mesh has cell sizes that floats can represent, whatever its unit.
TEST_F(Track, accepts_or_refuses_a_mesh_of_any_scale) {
    for (int power = -45; power <= 38; ++power) {
        const std::string side = fmt::format("1e{}", power);
        const std::string obj =
            put("scaled.obj", fmt::format("v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nf 1 2 3\n", side));
        const std::string still =
            put("still.npy", npy(header_of("<f4", "(3, 3, 2)"), std::string(3 * 3 * 2 * 4, '\0')));
        const auto mesh = read_obj(obj);
        EXPECT_EQ(mesh.has_value(), power > -6 && power < 9) << side;
        if (mesh) {
            for (const float cell : mesh->cell) EXPECT_TRUE(cell > 0 && std::isfinite(cell)) << side;
        }
        if (power % 10 == 0) {
            const int status = couloir({"track", obj, still, "--jump", "0.1"}).status;
            EXPECT_EQ(status, mesh ? 0 : 2) << side;
        }
    }
}

TEST_F(Track, refuses_a_time_step_that_floats_cannot_represent) {
    const std::string still =
        put("still.npy", npy(header_of("<f4", fmt::format("(3, {}, 2)", kVertices)),
                             std::string(static_cast<std::size_t>(3 * kVertices) * 2 * sizeof(float), '\0')));
    for (const char* dt : {"1e-300", "1e-40", "1e-7", "1e7", "1e300"})
        EXPECT_EQ(couloir({"track", mesh(), still, "--jump", "0.1", "--dt", dt}).status, 2) << dt;
}

TEST_F(Track, keeps_the_vertex_order_of_a_mesh_file) {
    const auto read = read_obj(mesh());
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->vertices(), kVertices);
    EXPECT_EQ(read->triangle.size(), 2u * kSquares * kSquares);
    EXPECT_NEAR(read->position[14].x, 1.0 / kSquares, 1e-6);
    EXPECT_NEAR(read->position[14].y, 1.0 / kSquares, 1e-6);
}

TEST_F(Track, refuses_a_damaged_array) {
    const std::string data(48, '\0');  // (3, 2, 2) of f4
    const std::string good = npy(header_of("<f4", "(3, 2, 2)"), data);
    const std::pair<std::string, const char*> wrong[] = {
        {"", ": is not a NumPy array"},
        {"MATLAB 5.0 MAT-file", ": is not a NumPy array"},
        {npy(header_of(">f4", "(3, 2, 2)"), data), ": its numbers are '>f4'"},
        {npy(header_of("<i4", "(3, 2, 2)"), data), ": its numbers are '<i4'"},
        {npy(header_of("<f4", "(3, 2, 2)", "True"), data), ": it is in Fortran order"},
        {npy(header_of("<f4", "(3, -2, 2)"), data), ": its header has no shape"},
        {npy(header_of("<f4", "()"), data), ": its header has no shape"},
        {npy(header_of("<f4", "(3, 2"), data), ": its header has no shape"},
        {npy(header_of("<f4", "(4000000000, 4000000000, 4000000000)"), data), ": its shape"},
        {npy(header_of("<f4", "(3, 2, 2)"), data + "x"),
         ": holds 49 bytes of data; its shape (3, 2, 2) needs 48"},
        {npy("{'descr': '<f4'}", data), ": it is in Fortran order"},
        {npy("", data), ": its numbers are "},
        {"\x93NUMPY\x09" + good.substr(7), ": NPY version 9"},
    };
    for (const auto& [bytes, told] : wrong) {
        const auto opened = ArrayFile::open(put("bad.npy", bytes));
        ASSERT_FALSE(opened) << told;
        EXPECT_EQ(opened.error().status, Failure::kUnusable);
        EXPECT_EQ(opened.error().sentence.rfind(at("bad.npy") + told, 0), 0u) << opened.error().sentence;
    }
    ASSERT_TRUE(ArrayFile::open(put("good.npy", good)));
    for (std::size_t length = 0; length < good.size(); ++length)
        EXPECT_FALSE(ArrayFile::open(put("short.npy", good.substr(0, length)))) << length;
}

}  // namespace
}  // namespace game::test
