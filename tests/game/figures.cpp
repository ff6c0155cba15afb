#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/base/number.h"
#include "game/figures/field_figure.h"
#include "game/figures/gallery_page.h"
#include "game/figures/level_flow.h"
#include "game/figures/mosaic.h"
#include "game/figures/numbers.h"
#include "game/figures/page.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

// Tests of the paper's figures that need no GL; gl_figures.cpp has the others.

namespace game::test {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
    if (!text.empty() && text.back() == at && at == ',') parts.emplace_back();
    return parts;
}

// Scores of each scene on 10×10 squares, invented, all within their limits.
std::vector<FlowScores> invented() {
    std::vector<FlowScores> numbers;
    for (int scene = 0; scene < static_cast<int>(flow_scenes().size()); ++scene) {
        numbers.push_back({scene, 10, {}, {}});
        for (auto& front : numbers.back().front) front.rms = 0.04, front.p95 = 0.08;
        for (auto& texture : numbers.back().texture) texture.stretch_p95 = 1.5, texture.stretched = 0.0005;
    }
    return numbers;
}

TEST(FigureNumbers, fill_every_cell_of_their_csv) {
    const auto lines = split(csv_of(invented()), '\n');
    ASSERT_EQ(lines.size(), 1 + flow_scenes().size());
    const auto names = split(lines[0], ',');
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const auto cells = split(lines[i], ',');
        ASSERT_EQ(cells.size(), names.size()) << lines[i];
        EXPECT_EQ(cells[0], flow_scenes()[i - 1].name);
        EXPECT_EQ(cells[1], "10");
        for (std::size_t c = 2; c < cells.size(); ++c)
            EXPECT_TRUE(number_from<double>(cells[c])) << names[c] << " is '" << cells[c] << "'";
    }
}

TEST(FigureNumbers, keep_their_bounds_and_show_what_the_method_is_worth) {
    const auto numbers = measure_flows(std::vector{10}, 2);
    EXPECT_EQ(first_miss(numbers), std::nullopt);
    for (const FlowScores& row : numbers) {
        EXPECT_LT(row.front[2].rms, row.front[0].rms) << row.scene;
        EXPECT_GT(row.texture[1].stretch_p95, 5 * row.texture[3].stretch_p95) << row.scene;
        EXPECT_GT(row.texture[2].stretch_p95, 5 * row.texture[3].stretch_p95) << row.scene;
    }
}

TEST(FigureNumbers, are_the_same_on_any_number_of_threads) {
    const std::vector squares{5};
    EXPECT_EQ(csv_of(measure_flows(squares, 1)), csv_of(measure_flows(squares, 3)));
}

TEST(FigureNumbers, stand_in_the_order_of_scenes_and_grids) {
    const auto numbers = measure_flows(std::vector{5, 4}, 3);
    ASSERT_EQ(numbers.size(), 2 * flow_scenes().size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        EXPECT_EQ(numbers[i].scene, static_cast<int>(i / 2));
        EXPECT_EQ(numbers[i].squares, i % 2 ? 4 : 5);
    }
}

TEST(FigureNumbers, name_the_first_that_misses_its_bound) {
    EXPECT_EQ(first_miss(invented()), std::nullopt);
    auto worse = invented();
    worse[2].front[2].rms = 0.3;
    EXPECT_NE(first_miss(worse).value_or("").find("0.300 cells"), std::string::npos);
    worse = invented();
    worse[1].texture[0].stretch_p95 = 1.2, worse[1].texture[3].stretch_p95 = 1.33;
    EXPECT_NE(first_miss(worse).value_or("").find("1.33"), std::string::npos);
    worse = invented();
    worse[3].texture[3].stretched = 0.0123;
    EXPECT_NE(first_miss(worse).value_or("").find("1.23 %"), std::string::npos);
    worse = invented();
    worse[2].texture[3].slip_near = 0.12;
    EXPECT_NE(first_miss(worse).value_or("").find("0.120"), std::string::npos);
    worse = invented();
    worse[3].texture[3].drift_p95 = 0.26;
    EXPECT_NE(first_miss(worse).value_or("").find("0.26 cells"), std::string::npos);
    worse = invented();
    worse[0].front[2].rms = std::nan("");
    EXPECT_NE(first_miss(worse), std::nullopt);
}

TEST(FigureNumbers, have_a_bound_in_every_cell_of_the_table) {
    for (int scene = 0; scene < static_cast<int>(flow_scenes().size()); ++scene) {
        for (const int squares : {10, 20, 30, 80, 160}) {
            EXPECT_GT(fit_bound(scene, squares).value_or(0), 0.02);
            EXPECT_LT(fit_bound(scene, squares).value_or(1), 0.2);
        }
        EXPECT_EQ(fit_bound(scene, 11), std::nullopt);
    }
}

TEST(FigureTables, have_a_cell_under_every_head_and_lines_of_one_width) {
    for (const Table& table : tables_of(invented())) {
        EXPECT_EQ(table.rows.size(), flow_scenes().size());
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.head.size()) << table.title;
    }
    EXPECT_EQ(as_text({"Of two", {"a", "bb"}, {{"45°", "1"}, {"x", "333"}}}),
              "Of two\n"
              "  a     bb\n"
              "  45°    1\n"
              "  x    333\n");
    EXPECT_EQ(as_html({"<", {"a"}, {{"&"}}}),
              "<h3>&lt;</h3>\n<div class=\"wide\"><table>\n<thead><tr><th "
              "class=\"left\">a</th></tr>\n</thead>\n<tbody>\n"
              "<tr><td class=\"left\">&amp;</td></tr>\n</tbody></table></div>\n");
}

TEST(FigurePage, shows_what_it_is_given_and_nothing_from_elsewhere) {
    const PageFigure figures[] = {{6, "a < b", "more & more", {{"six.png", "one"}, {"6b.png", "two"}}}};
    const std::string page = page_of(figures, tables_of(invented()), "us");
    for (const char* told : {"src=\"six.png\"", "src=\"6b.png\"", "Figure 6: a &lt; b", "more &amp; more",
                             "numbers.csv", "pinwheel", "Made by us."})
        EXPECT_NE(page.find(told), std::string::npos) << told;
    for (const char* alien : {"<script", "http", "@import", "url(", "<link"})
        EXPECT_EQ(page.find(alien), std::string::npos) << alien;
    EXPECT_EQ(page_of(figures, {}, "us").find("numbers.csv"), std::string::npos);
}

TEST(LevelFlow, stretches_along_a_front_only_if_the_mesh_is_not_cut) {
    sim::Workers workers(1);
    const auto line = sim::fields::opposed(0.1, 0.5);
    LevelFlow without(10, false), with(10, true);
    without.advance(line, 4, workers), with.advance(line, 4, workers);
    EXPECT_GT(without.drawn_out(), 0.1);  // one row in ten
    EXPECT_LT(without.drawn_out(), 0.4);
    EXPECT_EQ(with.drawn_out(), 0);
}

// Number of pixels in the front's colour.
std::vector<glm::dvec2> of_the_front(const render::Picture& picture) {
    std::vector<glm::dvec2> places;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* pixel = &picture.pixels[3ul * static_cast<unsigned>(y * picture.width + x)];
            if (pixel[0] == 213 && pixel[1] == 94 && pixel[2] == 0)
                places.emplace_back((x + 0.5) / picture.width, 1 - (y + 0.5) / picture.height);
        }
    return places;
}

TEST(FieldPicture, has_dashes_along_the_fronts_and_nowhere_else) {
    for (const auto& flow : {sim::fields::opposed(0.05, 0.5), sim::fields::swinging(45),
                             sim::fields::pinwheel(), sim::fields::disc(), sim::fields::drops()}) {
        constexpr int kPixels = 400;
        const auto front = of_the_front(field_picture(flow, 1, kPixels));
        for (const glm::dvec2& at : front) EXPECT_LT(flow.distance(at, 1), 0.006);
        int along = 0, dashed = 0;
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x) {
                const glm::dvec2 at((x + 0.5) / kPixels, (y + 0.5) / kPixels);
                if (flow.distance(at, 1) > 0.5 / kPixels) continue;
                ++along;
                dashed += std::any_of(front.begin(), front.end(), [&](const glm::dvec2& other) {
                    return std::hypot(other.x - at.x, other.y - at.y) < 2.0 / kPixels;
                });
            }
        EXPECT_GT(dashed, along / 2);
        EXPECT_LT(dashed, along * 9 / 10);
    }
}

TEST(FieldPicture, differs_at_another_time) {
    EXPECT_NE(field_picture(sim::fields::disc(), 1, 200).pixels,
              field_picture(sim::fields::disc(), 2, 200).pixels);
}

TEST(Mosaic, lays_pictures_in_rows_with_white_between) {
    std::vector<render::Picture> pictures(3);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        pictures[i] = {4, 2, std::vector<std::uint8_t>(24, static_cast<std::uint8_t>(i + 1)), 3};
    const render::Picture whole = mosaic(pictures, 2);
    ASSERT_EQ(whole.width, 10);
    ASSERT_EQ(whole.height, 6);
    const auto at = [&](int x, int y) { return whole.pixels[3ul * static_cast<unsigned>(y * 10 + x)]; };
    EXPECT_EQ(at(3, 1), 1);
    EXPECT_EQ(at(4, 1), 255);
    EXPECT_EQ(at(6, 0), 2);
    EXPECT_EQ(at(0, 3), 255);
    EXPECT_EQ(at(0, 4), 3);
    EXPECT_EQ(at(6, 4), 255);
}

TEST(Figures, refuse_what_they_cannot_make) {
    const support::TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const std::pair<std::vector<std::string>, const char*> wrong[] = {
        {{"figures"}, "--out"},
        {{"figures", "--out", out, "--only", "2"}, "'2' is not one of: 1, 6, 7, 8, 9, 10, 11, 12, numbers"},
        {{"figures", "--out", out, "--only", "6,all"}, "'all'"},
        {{"figures", "--out", out, "--pixels", "8"}, "--pixels"},
        {{"figures", "--out", out, "--gl", "moon"}, "moon"},
        {{"figures", "--out", out, "--threads", "0"}, "--threads"},
        {{"figures", "--out", out, "--fast"}, "--fast"},
    };
    for (const auto& [arguments, told] : wrong) {
        const Finished done = couloir(arguments);
        EXPECT_EQ(done.status, 2) << told;
        EXPECT_NE(done.err.find(told), std::string::npos) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    }
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Figures, end_with_3_if_their_folder_cannot_be_created) {
    const support::TemporaryFolder folder;
    write_bytes(folder.path() / "file", "kept");
    const Finished done = couloir({"figures", "--only", "6", "--out", (folder.path() / "file").string()});
    EXPECT_EQ(done.status, 3);
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_EQ(read_bytes(folder.path() / "file"), "kept");
    // A folder has the name of an image.
    std::filesystem::create_directories(folder.path() / "out" / "figure-06.png" / "x");
    EXPECT_EQ(couloir({"figures", "--only", "6", "--out", (folder.path() / "out").string()}).status, 3);
}

TEST(Figures, make_only_what_is_requested) {
    const support::TemporaryFolder folder;
    const Finished done =
        couloir({"figures", "--only", "6", "--pixels", "64", "--out", (folder.path() / "a").string()});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(done.out, (folder.path() / "a" / "index.html").string() + "\n");
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "a"))
        files.insert(entry.path().filename().string());
    EXPECT_EQ(files, (std::set<std::string>{"figure-06.png", "index.html"}));
}

TEST(GalleryPage, marks_a_view_that_did_not_come_to_rest_and_reloads_itself_only_on_request) {
    DrawnView view;
    view.file = "deposit.png";
    view.tick = 216000;
    const std::string resting = gallery_page(std::span(&view, 1), {}, "", "a test");
    view.still_moving = true;
    const std::string moving = gallery_page(std::span(&view, 1), {}, "", "a test", 3);
    EXPECT_NE(resting.find("tick 216000, state"), std::string::npos);
    EXPECT_NE(moving.find("tick 216000, still moving after an hour, state"), std::string::npos);
    EXPECT_EQ(resting.find("refresh"), std::string::npos);
    EXPECT_NE(moving.find("<meta http-equiv=\"refresh\" content=\"3\">"), std::string::npos);
}

}  // namespace
}  // namespace game::test
