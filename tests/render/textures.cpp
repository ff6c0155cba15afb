#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "assets/shaders/slots.glsl"
#include "render/textures/gaussian.h"
#include "render/textures/texture_recipes.h"
#include "render/textures/tree_pictures.h"
#include "tests/support/places.h"

namespace render {
namespace {

// One test compares the shipped images with the recipes' output. All others check the shipped images.
Picture shipped(const std::string& file) {
    const auto path = support::source_dir() / "assets" / "textures" / file;
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) return {};
    const OIIO::ImageSpec& spec = input->spec();
    Picture picture{spec.width, spec.height, {}, spec.nchannels};
    picture.pixels.resize(static_cast<std::size_t>(spec.image_bytes()));
    input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, picture.pixels.data());
    return picture;
}

Picture shipped(const TextureRecipe& recipe, const char* ending) {
    return shipped(recipe.name + std::string(ending));
}

std::size_t index(const Picture& picture, int x, int y, int channel) {
    const auto wrap = [](int v, int size) { return static_cast<std::size_t>((v + size) % size); };
    const auto width = static_cast<std::size_t>(picture.width),
               channels = static_cast<std::size_t>(picture.channels);
    return (wrap(y, picture.height) * width + wrap(x, picture.width)) * channels +
           static_cast<std::size_t>(channel);
}

int at(const Picture& picture, int x, int y, int channel) {
    return picture.pixels[index(picture, x, y, channel)];
}

class Textures : public testing::TestWithParam<TextureRecipe> {};
class StochasticTextures : public Textures {};

std::vector<TextureRecipe> recipes(bool all) {
    std::vector<TextureRecipe> chosen;
    for (const TextureRecipe& recipe : texture_recipes())
        if (all || recipe.kind == TextureKind::kStochastic) chosen.push_back(recipe);
    return chosen;
}

std::string name_of(const testing::TestParamInfo<TextureRecipe>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Of, Textures, testing::ValuesIn(recipes(true)), name_of);
INSTANTIATE_TEST_SUITE_P(Of, StochasticTextures, testing::ValuesIn(recipes(false)), name_of);

TEST_P(Textures, are_shipped_bit_identical_to_their_recipes) {
    const auto made = make_pictures(GetParam());
    EXPECT_EQ(made.size(), GetParam().kind == TextureKind::kStochastic ? 4u : 3u);
    for (const auto& [file, picture] : made) {
        const Picture found = shipped(file);
        ASSERT_EQ(found.width, picture.width) << file;
        ASSERT_EQ(found.height, picture.height) << file;
        ASSERT_EQ(found.channels, picture.channels) << file;
        EXPECT_TRUE(found.pixels == picture.pixels) << file << " differs from the output of make_textures";
    }
}

// Root mean square of the steps from column to column (down: from row to row). The last step crosses the
// seam.
std::vector<double> steps(const Picture& picture, bool down) {
    std::vector<double> steps;
    const int count = down ? picture.height : picture.width, length = down ? picture.width : picture.height;
    for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (int j = 0; j < length; ++j) {
            for (int c = 0; c < picture.channels; ++c) {
                const double step = down ? at(picture, j, i + 1, c) - at(picture, j, i, c)
                                         : at(picture, i + 1, j, c) - at(picture, i, j, c);
                sum += step * step;
            }
        }
        steps.push_back(std::sqrt(sum / length));
    }
    return steps;
}

bool has_a_seam(const Picture& picture, bool down) {
    const std::vector<double> found = steps(picture, down);
    return found.back() > *std::max_element(found.begin(), found.end() - 1);
}

TEST_P(Textures, have_no_larger_step_at_the_seam_than_inside) {
    for (const char* ending : {".png", "-height.png", "-normal.png"}) {
        const Picture picture = shipped(GetParam(), ending);
        ASSERT_EQ(picture.width, kTextureSize);
        EXPECT_FALSE(has_a_seam(picture, false)) << ending;
        EXPECT_FALSE(has_a_seam(picture, true)) << ending;
    }
}

// Checks that the test above can detect a seam.
TEST(Seam, is_detected_in_a_texture_with_a_tenth_cut_off) {
    for (const char* file :
         {"stones-height.png", "perlin-height.png", "snow-height.png", "soil-height.png"}) {
        const Picture whole = shipped(file);
        Picture cut{whole.width * 9 / 10, whole.height, {}, 1};
        for (int y = 0; y < cut.height; ++y) {
            for (int x = 0; x < cut.width; ++x) cut.pixels.push_back(whole.pixels[index(whole, x, y, 0)]);
        }
        EXPECT_TRUE(has_a_seam(cut, false)) << file;
    }
}

// Uses the definition of a normal: the surface falls in the direction in which the normal leans.
TEST_P(Textures, have_normals_perpendicular_to_the_raw_heights) {
    const Picture normals = shipped(GetParam(), "-normal.png");
    const Tile heights = GetParam().make().heights;
    double worst = 0, steepest = 0;
    for (int y = 0; y < kTextureSize; ++y) {
        for (int x = 0; x < kTextureSize; ++x) {
            std::array<double, 3> n{};
            for (int c = 0; c < 3; ++c) n[static_cast<std::size_t>(c)] = (at(normals, x, y, c) - 128) / 127.;
            EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 0.02) << x << ", " << y;
            // Chords of the surface, rightward and toward the row above, in tile edges.
            const double chord = 2. / kTextureSize;
            const double rise_x = GetParam().relief * (heights.at(x + 1, y) - heights.at(x - 1, y));
            const double rise_y = GetParam().relief * (heights.at(x, y - 1) - heights.at(x, y + 1));
            worst = std::max(worst, std::abs(n[0] * chord + n[2] * rise_x) / std::hypot(chord, rise_x));
            worst = std::max(worst, std::abs(n[1] * chord + n[2] * rise_y) / std::hypot(chord, rise_y));
            steepest = std::max(steepest, std::abs(rise_x) / chord);
        }
    }
    EXPECT_LT(worst, 0.006);  // cosine of the angle to the chord: half a byte of two channels
    EXPECT_GT(steepest, 0.2);
}

TEST_P(StochasticTextures, have_gaussian_heights) {
    const Picture heights = shipped(GetParam(), "-height.png");
    std::vector<double> sorted;
    for (const std::uint8_t byte : heights.pixels) sorted.push_back(byte / 255.);
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    double mean = 0, variance = 0;
    for (const double height : sorted) mean += height / count;
    for (const double height : sorted) variance += (height - mean) * (height - mean) / count;
    EXPECT_NEAR(mean, 0.5, 0.001);
    EXPECT_NEAR(std::sqrt(variance), 1. / 6, 0.001);
    // Standard normal quantiles from tables.
    for (const auto& [share, deviations] : {std::pair{0.01, -2.3263},
                                            {0.1, -1.2816},
                                            {0.25, -0.6745},
                                            {0.5, 0.},
                                            {0.75, 0.6745},
                                            {0.9, 1.2816},
                                            {0.99, 2.3263}})
        EXPECT_NEAR(sorted[static_cast<std::size_t>(share * count)], 0.5 + deviations / 6, 0.6 / 255)
            << share;
}

TEST_P(StochasticTextures, look_like_their_heights_in_their_colours) {
    const Picture heights = shipped(GetParam(), "-height.png"), colours = shipped(GetParam(), "-colours.png"),
                  seen = shipped(GetParam(), ".png");
    ASSERT_EQ(colours.width, 256);
    ASSERT_EQ(colours.height, 1);
    ASSERT_EQ(heights.channels, 1);
    int different = 0;
    for (int y = 0; y < kTextureSize; ++y) {
        for (int x = 0; x < kTextureSize; ++x) {
            for (int c = 0; c < 3; ++c)
                different += at(seen, x, y, c) != at(colours, at(heights, x, y, 0), 0, c);
        }
    }
    EXPECT_EQ(different, 0);
}

// The heights rise with the raw ones, so a colour stands for the same height before and after.
TEST_P(StochasticTextures, keep_the_order_of_their_raw_heights) {
    const Tile raw = GetParam().make().heights;
    const Gaussian gaussian = gaussianise(raw);
    std::map<float, int> byte_of;
    for (std::size_t i = 0; i < raw.heights.size(); ++i) byte_of[raw.heights[i]] = gaussian.bytes[i];
    EXPECT_TRUE(std::is_sorted(byte_of.begin(), byte_of.end(),
                               [](const auto& a, const auto& b) { return a.second < b.second; }));
    EXPECT_TRUE(std::is_sorted(gaussian.raw.begin(), gaussian.raw.end()));
}

TEST(Checkerboard, has_two_colours_in_equal_area) {
    const Picture board = shipped("checkerboard.png");
    std::map<std::array<int, 3>, int> area;
    for (int y = 0; y < board.height; ++y) {
        for (int x = 0; x < board.width; ++x)
            ++area[{at(board, x, y, 0), at(board, x, y, 1), at(board, x, y, 2)}];
    }
    ASSERT_EQ(area.size(), 2u);
    EXPECT_EQ(area.begin()->second, area.rbegin()->second);
}

TEST(NormalShare, matches_published_tables) {
    for (const auto& [x, share] : {std::pair{0., 0.5},
                                   {1., 0.8413447460685429},
                                   {-1., 0.15865525393145705},
                                   {2., 0.9772498680518208},
                                   {3., 0.9986501019683699},
                                   {-4., 3.16712418331e-05}})
        EXPECT_NEAR(normal_share_below(x), share, 1e-10) << x;
}

// ---- pictures of trees ----

// What a tile of a level shows: share that is covered, and means of its light and of the share of it that is white.
struct Shown {
    double covered = 0, light = 0, white = 0;
};
Shown shown(const Picture& pictures, int level, int column, int row) {
    const int width = TREE_TILE_WIDTH >> level, height = TREE_TILE_HEIGHT >> level;
    int top = 0;
    for (int k = 0; k < level; ++k) top += TREE_ROWS * TREE_TILE_HEIGHT >> k;
    top += (TREE_ROWS - 1 - row) * height;
    Shown sum;
    for (int y = top; y < top + height; ++y)
        for (int x = column * width; x < (column + 1) * width; ++x) {
            const int light = at(pictures, x, y, 2);
            sum.covered += light > 0;
            sum.light += light / 255.0;
            sum.white += light / 255.0 * at(pictures, x, y, 1) / 255.0;
        }
    return {sum.covered / (width * height), sum.light / sum.covered, sum.white / sum.covered};
}

// A file with pictures of trees, and what makes it.
struct TreeFile {
    const char* name;
    Picture (*make)();
};
class PicturesOfTrees : public testing::TestWithParam<TreeFile> {};
INSTANTIATE_TEST_SUITE_P(All, PicturesOfTrees,
                         testing::Values(TreeFile{"conifers.png", conifer_pictures},
                                         TreeFile{"trees-in-leaf.png", leaf_pictures}),
                         [](const auto& info) { return info.index == 0 ? "conifers" : "trees_in_leaf"; });

TEST_P(PicturesOfTrees, are_shipped_bit_identical_to_their_recipe) {
    const Picture made = GetParam().make(), found = shipped(GetParam().name);
    ASSERT_EQ(found.width, made.width);
    ASSERT_EQ(found.height, made.height);
    ASSERT_EQ(found.channels, made.channels);
    EXPECT_TRUE(found.pixels == made.pixels)
        << GetParam().name << " differs from the output of make_textures";
}

TEST_P(PicturesOfTrees, cover_as_much_and_are_as_bright_and_white_at_every_level) {
    const Picture pictures = shipped(GetParam().name);
    for (int column = 0; column < TREE_COLUMNS; ++column)
        for (int row = 0; row < TREE_ROWS; ++row) {
            const Shown first = shown(pictures, 0, column, row);
            EXPECT_GT(first.covered, 0.05);
            for (int level = 1; level < TREE_LEVELS; ++level) {
                const Shown here = shown(pictures, level, column, row);
                const double texel = 1.0 / ((TREE_TILE_WIDTH >> level) * (TREE_TILE_HEIGHT >> level));
                EXPECT_NEAR(here.covered, first.covered, 0.03 * first.covered + texel)
                    << column << row << level;
                EXPECT_NEAR(here.light, first.light, 0.03) << column << row << level;
                EXPECT_NEAR(here.white, first.white, 0.03) << column << row << level;
            }
        }
}

TEST_P(PicturesOfTrees, touch_no_edge_of_their_tiles_but_the_foot) {
    const Picture pictures = shipped(GetParam().name);
    for (int x = 0; x < TREE_COLUMNS * TREE_TILE_WIDTH; ++x)
        for (int y = 0; y < TREE_ROWS * TREE_TILE_HEIGHT; ++y) {
            const int right = x % TREE_TILE_WIDTH, down = y % TREE_TILE_HEIGHT;
            if (right > 0 && right < TREE_TILE_WIDTH - 1 && down > 0) continue;
            EXPECT_EQ(at(pictures, x, y, 2), 0) << x << " " << y;
        }
}

}  // namespace
}  // namespace render
