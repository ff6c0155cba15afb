#include "render/passes/trees_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "render/gl/scissor.h"
#include "render/pictures/png.h"

namespace render {

namespace {

// The files with pictures of trees, side by side in one texture.
constexpr std::array kPictures{"conifers.png", "trees-in-leaf.png"};

// Loads one of them. Its levels are below each other in the file.
tl::expected<void, std::string> load_pictures(const std::filesystem::path& file, int left,
                                              const Texture& into) {
    constexpr int kWidth = TREE_COLUMNS * TREE_TILE_WIDTH, kHeight = TREE_ROWS * TREE_TILE_HEIGHT;
    const auto texels = read_png(file, 3);
    if (!texels) return tl::unexpected(texels.error());
    int height = 0;
    for (int level = 0; level < TREE_LEVELS; ++level) height += kHeight >> level;
    if (texels->width != kWidth || texels->height != height)
        return tl::unexpected(fmt::format("{}: is {} x {} pixels; pictures of trees are {} x {}",
                                          file.string(), texels->width, texels->height, kWidth, height));
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, kWidth);
    for (int level = 0, rows = height; level < TREE_LEVELS; ++level) {
        rows -= kHeight >> level;
        glTextureSubImage2D(into.name(), level, left >> level, 0, kWidth >> level, kHeight >> level, GL_RGB,
                            GL_UNSIGNED_BYTE, &texels->values[3 * static_cast<std::size_t>(rows) * kWidth]);
    }
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return {};
}

tl::expected<Texture, std::string> load_all_pictures(const std::filesystem::path& folder) {
    constexpr int kWidth = TREE_COLUMNS * TREE_TILE_WIDTH, kFiles = kPictures.size();
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    Texture pictures(name);
    glTextureStorage2D(name, TREE_LEVELS, GL_RGBA8, kFiles * kWidth, TREE_ROWS * TREE_TILE_HEIGHT);
    for (int i = 0; i < kFiles; ++i)
        if (auto loaded =
                load_pictures(folder / kPictures[static_cast<std::size_t>(i)], i * kWidth, pictures);
            !loaded)
            return tl::unexpected(loaded.error());
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return pictures;
}

// A program that draws trees by their numbers.
auto link_trees(const std::filesystem::path& shaders, std::string_view vertex,
                std::vector<std::string_view> fragment) {
    return link_program(
        shaders, {{GL_VERTEX_SHADER,
                   {"slots.glsl", "frame.glsl", "light.glsl", "tree.glsl", "tree_buffer.glsl", vertex}},
                  {GL_FRAGMENT_SHADER, std::move(fragment)}});
}

}  // namespace

tl::expected<TreesPass, std::string> TreesPass::create(const std::filesystem::path& assets) {
    TreesPass pass;
    pass.no_vertices_ = make_vertex_array();
    auto shadow = link_trees(assets / "shaders", "tree_shadow.vert",
                             {"slots.glsl", "tree_covered.glsl", "tree_shadow.frag"});
    if (!shadow) return tl::unexpected(shadow.error());
    pass.shadow_ = std::move(*shadow);
    auto pictures = load_all_pictures(assets / "textures");
    if (!pictures) return tl::unexpected(pictures.error());
    pass.pictures_ = std::move(*pictures);
    return pass;
}

tl::expected<void, std::string> TreesPass::load(const std::filesystem::path& shaders, GroundKind kind) {
    if (pictures_of_[kind]) return {};
    auto program = link_trees(
        shaders, "tree_picture.vert",
        {"slots.glsl", kind.dated ? "dated.glsl" : "undated.glsl", "tree_covered.glsl", "tree_picture.frag"});
    if (!program) return tl::unexpected(program.error());
    pictures_of_[kind] = std::move(*program);
    return {};
}

FollowedWoods::Change TreesPass::follow(const Woods* woods, const Surroundings* around,
                                        const sim::View& world, std::span<const float> first_depth,
                                        const glm::vec4& sun, bool new_ground) {
    const auto change = woods_.follow(woods, around, world, first_depth, glm::vec3(sun), new_ground);
    if (change == FollowedWoods::Change::kNone) return change;
    const LitTrees all = woods_.trees();
    trees_.reserve(all.trees.size());
    seen_.reserve(all.trees.size());
    listed_.reserve(all.trees.size());
    return change;
}

void TreesPass::find(const FrameInput& input, const Redraw& redraw) {
    if (redraw.everything) {
        trees_.find(woods_.trees(), redraw.frame, redraw.screen);
        screen_ = redraw.screen;
        seen_.clear();
    }
    const bool again = !redraw.everything && !woods_.changed_tiles().empty();
    if (again) {
        trees_.find_again(woods_.trees(), woods_.changed_tiles(), redraw.frame, redraw.screen);
        seen_.clear();
        for (const DrawnTree& tree : trees_.gone()) redraw.tiles.mark(TreesInView::seen(tree, redraw.screen));
    }
    const bool carried_off = input.may_have_carried() && !input.carried.empty();
    trees_.settle(woods_.trees().trees, input.world, input.flow_so_far, carried_off);
    if (redraw.everything) return;
    if (again)
        for (const std::size_t number : trees_.grown())
            redraw.tiles.mark(TreesInView::seen(trees_.drawn()[number], redraw.screen));
    for (const auto& [number, before] : trees_.moved()) {
        const Rectangle now = TreesInView::seen(trees_.drawn()[number], redraw.screen);
        redraw.tiles.mark(TreesInView::seen(before, redraw.screen));
        redraw.tiles.mark(now);
        if (number < seen_.size()) seen_[number] = now;
    }
}

// Lists the trees of each part in their order, so that they hide each other as in a whole frame.
void TreesPass::list(std::span<const Rectangle> parts) {
    const auto trees = trees_.drawn();
    const bool all = parts.size() == 1 && parts[0] == screen_.all();
    if (!all && seen_.size() != trees.size()) {
        seen_.clear();
        for (const DrawnTree& tree : trees) seen_.push_back(TreesInView::seen(tree, screen_));
    }
    listed_.clear();
    parts_.clear();
    for (const Rectangle& part : parts) {
        Part& listed = parts_.emplace_back(Part{part, listed_.size(), 0, 0});
        for (std::size_t i = 0; i < trees.size(); ++i) {
            if (!all && !part.meets(seen_[i])) continue;
            listed_.push_back(trees[i]);
            ++listed.all;
            if (i < trees_.with_shadow()) ++listed.with_shadow;
        }
    }
    if (listed_.size() > room_) {
        room_ = std::max(2 * room_, std::max(listed_.size(), woods_.trees().trees.size()));
        instances_ = make_storage(room_ * sizeof(DrawnTree), nullptr);
    }
    glNamedBufferSubData(instances_.name(), 0, static_cast<GLsizeiptr>(listed_.size() * sizeof(DrawnTree)),
                         listed_.data());
}

// Trees are no instances: a software renderer starts anew for each of these. A vertex finds its tree by its
// number.
void TreesPass::draw(GroundKind kind, std::span<const Rectangle> parts) {
    if (trees_.drawn().empty()) return;
    list(parts);
    if (listed_.empty()) return;
    const Enabled depth_test(GL_DEPTH_TEST), scissors(GL_SCISSOR_TEST);
    bind_storage(SLOT_TREES, instances_);
    glBindVertexArray(no_vertices_.name());
    const auto draw = [&](const ProgramName& program, auto&& count) {
        glUseProgram(program.name());
        for (const Part& part : parts_) {
            if (count(part) == 0) continue;
            scissor(part.part);
            glDrawArrays(GL_TRIANGLES, 3 * static_cast<GLint>(part.first),
                         3 * static_cast<GLsizei>(count(part)));
        }
    };
    glBindTextureUnit(SLOT_TREE_PICTURES, pictures_.name());
    {
        // A shadow lies on the ground as a triangle, which is a little above it everywhere.
        const Enabled blend(GL_BLEND), offset(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 256);
        glDepthMask(GL_FALSE);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        draw(shadow_, [](const Part& p) { return p.with_shadow; });
        glBlendFunc(GL_ONE, GL_ZERO);
        glDepthMask(GL_TRUE);
        glPolygonOffset(0, 0);
    }
    draw(*pictures_of_[kind], [](const Part& p) { return p.all; });
}

}  // namespace render
