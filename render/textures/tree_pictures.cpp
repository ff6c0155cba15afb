#include "render/textures/tree_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/broad_leaved.h"
#include "render/base/conifer.h"

namespace render {
namespace {

constexpr int kFine = 3;  // samples along the edge of a texel
constexpr std::array<float, TREE_ROWS> kSines{TREE_ROW_SINES};

struct Kind {
    TreeModel tree;
    float radius;
    float
        least;  // coverage from which a texel of the first level shows the tree: twigs may be thinner than a texel
};

Kind kind_of(int column) {
    switch (column) {
        case TREE_COLUMN_GREEN_LARCH:
            return {grow_green_larch(27), kConiferRadius, 0.34f};
        case TREE_COLUMN_BEECH:
            return {grow_beech(51, 0.1f, Foliage::kLeaves), kBeechRadius, 0.42f};
        case TREE_COLUMN_BEECH + 1:
            return {grow_beech(52, 0.9f, Foliage::kLeaves), kBeechRadius, 0.42f};
        case TREE_COLUMN_BIRCH:
            return {grow_birch(61), kBirchRadius, 0.40f};
        case TREE_COLUMN_BUSH:
            return {grow_bush(71), kBushRadius, 0.42f};
        case TREE_COLUMN_LEAVES:
            return {grow_broad_leaved_group(81, Foliage::kLeaves), kGroupRadius, 0.42f};
        case TREE_COLUMN_BARE:
            return {grow_beech(53, 0.4f, Foliage::kBare), kBeechRadius, 0.36f};
        case TREE_COLUMN_BARE_GROUP:
            return {grow_broad_leaved_group(82, Foliage::kBare), kGroupRadius, 0.45f};
        case TREE_COLUMN_BROKEN:
            return {grow_spruce(17, 0.5f, 0.62f), kConiferRadius, 0.42f};
        case TREE_COLUMN_LARCH:
            return {grow_larch(25), kConiferRadius, 0.30f};
        case TREE_COLUMN_PINE:
            return {grow_dwarf_pine(31), kCushionRadius, 0.42f};
        case TREE_COLUMN_GROUP:
            return {grow_group(41), kGroupRadius, 0.42f};
        default: {
            constexpr std::array kSnowy{0.18f, 0.45f, 0.68f, 0.90f};
            static_assert(kSnowy.size() == TREE_SPRUCES);
            return {grow_spruce(static_cast<std::uint32_t>(11 + column),
                                kSnowy[static_cast<std::size_t>(column)]),
                    kConiferRadius, 0.42f};
        }
    }
}

// A part of a picture: sums of across, snow and light over what is covered, and how much that is, 0 to 1.
struct Level {
    int width = 0, height = 0;
    std::vector<glm::vec4> texels;

    Level(int w, int h)
        : width(w),
          height(h),
          texels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), glm::vec4(0)) {}
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    glm::vec4& at(int x, int y) { return texels[index(x, y)]; }
    const glm::vec4& at(int x, int y) const { return texels[index(x, y)]; }
};

// A corner as it appears: texel samples right and up, nearness.
struct Seen {
    glm::vec3 a, b, c;
};

// What a sample shows: across, snow, light, 1; or nothing.
struct Sample {
    float near = -1e9f;
    glm::vec4 shows{0};
};

void draw_face(const TreeFace& face, const Seen& seen, int width, int height, std::vector<Sample>& samples) {
    const auto& [a, b, c] = seen;
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (std::abs(area) < 1e-4f) return;
    const auto low = glm::max(glm::ivec2(glm::min(a, glm::min(b, c))), glm::ivec2(0));
    const auto high = glm::min(glm::ivec2(glm::max(a, glm::max(b, c))) + 1, glm::ivec2(width, height) - 1);
    const glm::vec4 shows(0.5f + 0.5f * face.normal.x, face.other, std::min(face.light, 1.f), 1);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            const float px = static_cast<float>(x) + 0.5f - a.x, py = static_cast<float>(y) + 0.5f - a.y;
            const float v = (px * (c.y - a.y) - py * (c.x - a.x)) / area;
            const float w = ((b.x - a.x) * py - (b.y - a.y) * px) / area;
            if (v < -0.02f || w < -0.02f || v + w > 1.02f) continue;
            const float near = a.z + v * (b.z - a.z) + w * (c.z - a.z);
            Sample& sample = samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(x)];
            if (near > sample.near) sample = {near, shows};
        }
}

// The tree in its tile, from an eye far away whose height has this sine.
Level drawn(const Kind& kind, float sine) {
    constexpr int kWidth = TREE_TILE_WIDTH * kFine, kHeight = TREE_TILE_HEIGHT * kFine;
    const float cosine = std::sqrt(1 - sine * sine), wide = static_cast<float>(TREE_SPARE) * kind.radius;
    const float low = -wide * sine, high = static_cast<float>(TREE_ABOVE) * cosine + wide * sine * sine;
    const auto seen = [&](glm::vec3 p) {
        return glm::vec3((0.5f * p.x / wide + 0.5f) * kWidth,
                         (p.y * sine + p.z * cosine - low) / (high - low) * kHeight,
                         p.z * sine - p.y * cosine);
    };
    std::vector<Sample> samples(static_cast<std::size_t>(kWidth) * kHeight);
    for (const TreeFace& face : kind.tree)
        draw_face(face, {seen(face.a), seen(face.b), seen(face.c)}, kWidth, kHeight, samples);
    Level level(TREE_TILE_WIDTH, TREE_TILE_HEIGHT);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            level.at(x / kFine, y / kFine) +=
                samples[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)].shows /
                static_cast<float>(kFine * kFine);
    return level;
}

Level halved(const Level& level) {
    Level half(level.width / 2, level.height / 2);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            half.at(x, y) = 0.25f * (level.at(2 * x, 2 * y) + level.at(2 * x + 1, 2 * y) +
                                     level.at(2 * x, 2 * y + 1) + level.at(2 * x + 1, 2 * y + 1));
    return half;
}

// Which texels show the tree: those that it covers most, so many that their share is that wanted.
std::vector<bool> shown(const Level& level, double share) {
    std::vector<std::size_t> order(level.texels.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, [&](std::size_t i, std::size_t k) {
        return level.texels[i].w != level.texels[k].w ? level.texels[i].w > level.texels[k].w : i < k;
    });
    std::vector<bool> shows(order.size());
    const auto most = static_cast<std::size_t>(std::lround(share * static_cast<double>(order.size())));
    for (std::size_t k = 0; k < most; ++k) shows[order[k]] = level.texels[order[k]].w > 0;
    return shows;
}

// Means over what is shown: light, and light from snow.
glm::vec2 means(const Level& level, const std::vector<bool>& shows) {
    glm::dvec2 sum(0);
    double count = 0;
    for (std::size_t i = 0; i < shows.size(); ++i) {
        if (!shows[i]) continue;
        const glm::vec4 texel = level.texels[i] / level.texels[i].w;
        sum += glm::dvec2(texel.z, texel.z * texel.y);
        ++count;
    }
    return glm::vec2(sum / std::max(count, 1.0));
}

// Fewer shades are told apart than a byte has, and compress to half.
std::uint8_t in_steps(float share, int steps) {
    const float whole = std::round(std::clamp(share, 0.f, 1.f) * static_cast<float>(steps));
    return static_cast<std::uint8_t>(std::lround(255 * whole / static_cast<float>(steps)));
}

// Writes what a level shows into the picture, with its lower left corner at a column, and at a row from the top.
void write(const Level& level, const std::vector<bool>& shows, glm::vec2 brighter, int left, int bottom,
           Picture& into) {
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            if (!shows[level.index(x, y)]) continue;
            const glm::vec4 texel = level.at(x, y) / level.at(x, y).w;
            const auto to = 3 * (static_cast<std::size_t>(bottom - y) * static_cast<std::size_t>(into.width) +
                                 static_cast<std::size_t>(left + x));
            into.pixels[to] = in_steps(texel.x, 15);
            into.pixels[to + 1] = in_steps(texel.y * brighter.y, 15);
            into.pixels[to + 2] = std::max<std::uint8_t>(in_steps(texel.z * brighter.x, 31), 1);
        }
}

// Those of TREE_COLUMNS trees from a first one on.
Picture pictures_from(int first_column) {
    constexpr int kHeight = TREE_ROWS * TREE_TILE_HEIGHT;
    Picture picture{TREE_COLUMNS * TREE_TILE_WIDTH, 0, {}};
    for (int level = 0; level < TREE_LEVELS; ++level) picture.height += kHeight >> level;
    picture.pixels.resize(3 * static_cast<std::size_t>(picture.width) *
                          static_cast<std::size_t>(picture.height));
    for (int column = 0; column < TREE_COLUMNS; ++column) {
        const Kind kind = kind_of(first_column + column);
        for (int row = 0; row < TREE_ROWS; ++row) {
            Level level = drawn(kind, kSines[static_cast<std::size_t>(row)]);
            const auto covers = [&](const glm::vec4& texel) { return texel.w > kind.least; };
            const double share = static_cast<double>(std::ranges::count_if(level.texels, covers)) /
                                 static_cast<double>(level.texels.size());
            glm::vec2 first{0};  // means of the first level
            for (int k = 0, top = 0; k < TREE_LEVELS; ++k) {
                const std::vector<bool> shows = shown(level, share);
                const glm::vec2 here = means(level, shows);
                if (k == 0) first = here;
                const float brighter = first.x / here.x;
                write(level, shows, {brighter, first.y / here.y / brighter}, column * level.width,
                      top + (kHeight >> k) - 1 - row * level.height, picture);
                top += kHeight >> k;
                level = halved(level);
            }
        }
    }
    return picture;
}

}  // namespace

Picture conifer_pictures() {
    return pictures_from(0);
}

Picture leaf_pictures() {
    return pictures_from(TREE_COLUMNS);
}

}  // namespace render
