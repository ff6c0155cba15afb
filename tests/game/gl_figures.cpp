#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "game/figures/gallery_views.h"
#include "tests/game/program.h"
#include "tests/support/places.h"
#include "tests/window/child.h"

// The paper's figures, drawn with GL.

namespace game::test {
namespace {

constexpr int kPixels = 96, kGap = 2;

std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = read_bytes(entry.path());
    return files;
}

Finished draw(const std::filesystem::path& folder, const std::string& only, const std::string& threads) {
    return couloir({"figures", "--only", only, "--pixels", std::to_string(kPixels), "--threads", threads,
                    "--out", folder.string()});
}

// The squares of a figure: texture without and with cuts, and the stretch of each.
struct Squares {
    std::vector<std::uint8_t> pixels;
    int width = 0;
    const std::uint8_t* at(int column, int row, int x, int y) const {
        return &pixels[3ul * static_cast<unsigned>((row * (kPixels + kGap) + y) * width +
                                                   column * (kPixels + kGap) + x)];
    }
    // The share of a square in dark red or darker: a stretch above 2.
    double drawn_out(int column) const {
        int count = 0;
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x) {
                const std::uint8_t* pixel = at(column, 1, x, y);
                count += pixel[0] < 200 && pixel[1] < 60;
            }
        return 1.0 * count / (kPixels * kPixels);
    }
    double differ() const {
        int count = 0;
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x) count += std::abs(at(0, 0, x, y)[0] - at(1, 0, x, y)[0]) > 32;
        return 1.0 * count / (kPixels * kPixels);
    }
};
Squares read_squares(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    EXPECT_TRUE(input) << path;
    if (!input) return {};
    const auto& spec = input->spec();
    EXPECT_EQ(spec.width, 2 * kPixels + kGap);
    EXPECT_EQ(spec.height, 2 * kPixels + kGap);
    Squares squares;
    squares.width = spec.width;
    squares.pixels.resize(3ul * static_cast<unsigned>(spec.width) * static_cast<unsigned>(spec.height));
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, squares.pixels.data()));
    return squares;
}

TEST(DrawnFigures, show_stretched_textures_only_without_the_method) {
    const support::TemporaryFolder folder;
    const Finished done = draw(folder.path(), "1,7,8,9", "1");
    ASSERT_EQ(done.status, 0) << done.err;
    for (const char* name : {"figure-01.png", "figure-07.png", "figure-08.png", "figure-09.png"}) {
        const Squares squares = read_squares(folder.path() / name);
        EXPECT_GT(squares.differ(), 0.02) << name;
        EXPECT_GT(squares.drawn_out(0), 0.03) << name;
        EXPECT_LT(squares.drawn_out(1), 0.01) << name;
    }
}

TEST(DrawnFigures, are_the_same_files_again_on_any_number_of_threads) {
    const support::TemporaryFolder folder;
    ASSERT_EQ(draw(folder.path() / "a", "6,8", "1").status, 0);
    ASSERT_EQ(draw(folder.path() / "b", "6,8", "3").status, 0);
    const auto a = files_of(folder.path() / "a"), b = files_of(folder.path() / "b");
    EXPECT_EQ(a.size(), 4u);
    EXPECT_TRUE(a == b);
}

TEST(DrawnFigures, are_all_on_the_page) {
    const support::TemporaryFolder folder;
    ASSERT_EQ(draw(folder.path(), "6,8,11", "2").status, 0);
    auto files = files_of(folder.path());
    const std::string page = files["index.html"];
    files.erase("index.html");
    std::size_t shown = 0;
    for (std::size_t at = 0; (at = page.find("src=\"", at)) != std::string::npos; ++shown) {
        at += 5;
        const std::string file = page.substr(at, page.find('"', at) - at);
        EXPECT_EQ(files.count(file), 1u) << file;
    }
    EXPECT_EQ(shown, files.size());
    EXPECT_EQ(shown, 6u);
}

// Whether an image has more than one colour.
bool shows_something(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) return false;
    const auto& spec = input->spec();
    std::vector<std::uint8_t> pixels(spec.image_pixels() * static_cast<unsigned>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data())) return false;
    return std::any_of(pixels.begin(), pixels.end(),
                       [&](std::uint8_t each) { return std::abs(each - pixels[0]) > 8; });
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(DrawnGallery, has_every_view_with_its_image_and_its_times) {
    const support::TemporaryFolder in, out;
    std::string hill = "ncols 17\nnrows 17\nxllcorner 500000\nyllcorner 5200000\ncellsize 5\n";
    for (int row = 0; row < 17; ++row)
        for (int column = 0; column < 17; ++column) hill += std::to_string(1000 + 3 * row + column % 3) + " ";
    write_bytes(in.path() / "hill.asc", hill);
    write_bytes(in.path() / "hill.prj",
                R"(PROJCS["WGS_1984_UTM_Zone_32N",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",)"
                R"(SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],)"
                R"(UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
                R"(PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],)"
                R"(PARAMETER["Central_Meridian",9.0],PARAMETER["Scale_Factor",0.9996],)"
                R"(PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]])");
    const Finished finished = couloir({"gallery", "--size", "64x36", "--out", out.path().string(),
                                       "--terrain", (in.path() / "hill.asc").string()});
    ASSERT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(finished.out, (out.path() / "index.html").string() + "\n");
    const std::string page = read_bytes(out.path() / "index.html");
    const std::size_t views = gallery_views().size();
    EXPECT_EQ(count(page, "<img "), views);
    EXPECT_EQ(count(page, "<table"), views);
    EXPECT_EQ(count(page, "://"), 0u) << "the page needs nothing from elsewhere";
    std::size_t images = 0;
    for (const auto& [name, bytes] : files_of(out.path())) {
        if (name == "index.html") continue;
        ++images;
        EXPECT_EQ(count(page, "<img src=\"" + name + "\""), 1u) << name;
        EXPECT_TRUE(shows_something(out.path() / name)) << name;
    }
    EXPECT_EQ(images, views);
}

// A fault in a shader is reported and the page stays; the next change draws it again.
TEST(DrawnGallery, is_drawn_again_when_a_shader_changes_until_it_is_interrupted) {
    const support::TemporaryFolder folder;
    const auto assets = folder.path() / "assets", out = folder.path() / "out", page = out / "index.html",
               image = out / "valley-noon.png", shader = assets / "shaders" / "tone.frag",
               err = folder.path() / "err";
    std::filesystem::copy(support::source_dir() / "assets", assets, std::filesystem::copy_options::recursive);
    Child held({support::program().string(), "gallery", "--hold", "--size", "64x36", "--out", out.string()},
               {{"COULOIR_ASSETS", assets.string()}}, folder.path() / "printed", err);
    const auto says = [&](const std::string& part) { return count(read_bytes(err), part) > 0; };
    ASSERT_TRUE(within(240, [&] { return says("Ctrl+C"); })) << read_bytes(err);
    const auto first = std::filesystem::last_write_time(page);
    const std::string first_image = read_bytes(image), sound = read_bytes(shader);
    EXPECT_EQ(count(read_bytes(page), "http-equiv=\"refresh\""), 1u);
    EXPECT_EQ(count(read_bytes(page), "<img "), gallery_views().size() - 1) << "no hill of one's own";
    EXPECT_EQ(read_bytes(folder.path() / "printed"), page.string() + "\n");

    write_bytes(shader, sound + "fault\n");
    ASSERT_TRUE(within(60, [&] { return says(shader.string() + ":"); })) << read_bytes(err);
    EXPECT_FALSE(held.ended());
    EXPECT_EQ(std::filesystem::last_write_time(page), first);

    // A sound shader that paints all black.
    const std::size_t end = sound.rfind('}');
    ASSERT_NE(end, std::string::npos);
    write_bytes(shader, sound.substr(0, end) + "    colour = vec4(0, 0, 0, 1);\n}\n");
    ASSERT_TRUE(within(120, [&] { return std::filesystem::last_write_time(page) > first; }))
        << read_bytes(err);
    EXPECT_NE(read_bytes(image), first_image);
    EXPECT_FALSE(shows_something(image));

    held.signal(SIGINT);
    EXPECT_EQ(held.wait(60), 0);
}

}  // namespace
}  // namespace game::test
