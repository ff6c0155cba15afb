#include "render/passes/terrain_pass.h"

#include <algorithm>
#include <future>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "render/gl/scissor.h"
#include "render/mountain/detail.h"
#include "sim/core/check.h"

namespace render {
namespace {

constexpr int kDetailLevels = 10;  // kDetailSize = 2⁹
static_assert(1 << (kDetailLevels - 1) == kDetailSize);

Texture detail_texture_of(const std::vector<std::uint8_t>& texels) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    Texture texture(name);
    glTextureStorage3D(name, kDetailLevels, GL_RGBA8, kDetailSize, kDetailSize, DETAIL_LAYERS);
    glTextureSubImage3D(name, 0, 0, 0, 0, kDetailSize, kDetailSize, DETAIL_LAYERS, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
    glGenerateTextureMipmap(name);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    return texture;
}

// Creates the surface's shading with the files that define slides and marks.
tl::expected<RectanglePass, std::string> make_shading(const std::filesystem::path& shaders, GroundKind kind,
                                                      const std::vector<std::string_view>& variant) {
    std::vector<std::string_view> files{"slots.glsl",
                                        "frame.glsl",
                                        kind.dated ? "dated.glsl" : "undated.glsl",
                                        "light.glsl",
                                        "sun_ceiling.glsl",
                                        "ground.glsl",
                                        "plants.glsl",
                                        "tone_curve.glsl",
                                        "spline.glsl",
                                        "scene_depth.glsl",
                                        "surface_place.glsl",
                                        "terrain.frag",
                                        kind.two_materials ? "materials_two.glsl" : "materials_one.glsl"};
    files.insert(files.end(), variant.begin(), variant.end());
    return RectanglePass::create(shaders, files);
}

}  // namespace

tl::expected<TerrainPass::Shadings, std::string> TerrainPass::make_shadings(
    const std::filesystem::path& shaders, GroundKind kind) {
    struct Marking {
        Shading Shadings::*to;
        std::vector<std::string_view> files;
    };
    struct Variant {
        RectanglePass Shading::*to;
        std::vector<std::string_view> files;
    };
    const Marking markings[] = {{&Shadings::plain, {"marks_none.glsl"}},
                                {&Shadings::marked, {"marks.glsl", "overlay_none.glsl"}},
                                {&Shadings::overlaid, {"marks.glsl", "overlay.glsl"}}};
    const Variant variants[] = {
        {&Shading::with_earth, {"earth.glsl", "wet.glsl", "slides.glsl", "crown.glsl"}},
        {&Shading::with_walls, {"earth_none.glsl", "wet_none.glsl", "slides.glsl", "crown.glsl"}},
        {&Shading::with_slides, {"earth_none.glsl", "wet_none.glsl", "slides.glsl", "crown_none.glsl"}},
        {&Shading::without, {"earth_none.glsl", "wet_none.glsl", "slides_none.glsl", "crown_none.glsl"}}};
    Shadings shadings;
    for (const Marking& marking : markings)
        for (const Variant& variant : variants) {
            std::vector<std::string_view> files = variant.files;
            files.insert(files.end(), marking.files.begin(), marking.files.end());
            auto shading = make_shading(shaders, kind, files);
            if (!shading) return tl::unexpected(shading.error());
            (shadings.*marking.to).*variant.to = std::move(*shading);
        }
    return shadings;
}

tl::expected<TerrainPass, std::string> TerrainPass::create(const std::filesystem::path& shaders) {
    auto detail = std::async(std::launch::async, make_detail);  // beside the shaders, which take as long
    const ShaderStage vertex{GL_VERTEX_SHADER, {"slots.glsl", "frame.glsl", "terrain.vert"}};
    auto depth = link_program(shaders, {vertex, {GL_FRAGMENT_SHADER, {"depth.frag"}}});
    if (!depth) return tl::unexpected(depth.error());
    auto walls = link_program(
        shaders,
        {vertex,
         {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "light.glsl", "sun_ceiling.glsl", "walls.frag"}}});
    if (!walls) return tl::unexpected(walls.error());
    TerrainPass pass;
    pass.depth_program_ = std::move(*depth);
    pass.wall_program_ = std::move(*walls);
    pass.detail_texture_ = detail_texture_of(detail.get());
    return pass;
}

tl::expected<void, std::string> TerrainPass::load(const std::filesystem::path& shaders, GroundKind kind) {
    if (shadings_[kind]) return {};
    auto shadings = make_shadings(shaders, kind);
    if (!shadings) return tl::unexpected(shadings.error());
    shadings_[kind] = std::move(*shadings);
    return {};
}

void TerrainPass::Indexed::send(const std::vector<std::uint32_t>& values) {
    count = static_cast<GLsizei>(values.size());
    vertices = make_vertex_array();
    indices = make_buffer();
    glNamedBufferData(indices.name(), static_cast<GLsizeiptr>(sizeof(std::uint32_t) * values.size()),
                      values.data(), GL_STATIC_DRAW);
    glVertexArrayElementBuffer(vertices.name(), indices.name());
}

void TerrainPass::Indexed::draw() const {
    glBindVertexArray(vertices.name());
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
}

void TerrainPass::send_mesh(const GroundMesh& mesh) {
    surface_.send(mesh.surface);
    walls_.send(mesh.walls);
    blocks_ = mesh.blocks;
    along_x_ = along_y_ = 0;
    for (const GroundMesh::Block& block : blocks_) {
        along_x_ = std::max(along_x_, block.lowest.x / GroundMesh::kBlock + 1);
        along_y_ = std::max(along_y_, block.lowest.y / GroundMesh::kBlock + 1);
    }
    at_.assign(static_cast<std::size_t>(along_x_) * static_cast<std::size_t>(along_y_), -1);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const glm::ivec2 place = blocks_[i].lowest / GroundMesh::kBlock;
        at_[place_number(place.x, place.y)] = static_cast<int>(i);
    }
    seen_.assign(blocks_.size(), {});
    rises_.assign(blocks_.size(), 0);
    counts_.reserve(blocks_.size());
    firsts_.reserve(blocks_.size());
}

void TerrainPass::find(const Redraw& redraw) {
    std::fill(rises_.begin(), rises_.end(), static_cast<std::uint8_t>(redraw.everything));
    if (!redraw.everything)
        for (const glm::ivec2 v : redraw.changed.moved())
            // A vertex on a border belongs to the blocks on both sides.
            for (int y = std::max(v.y - 1, 0) / GroundMesh::kBlock;
                 y <= std::min(v.y / GroundMesh::kBlock, along_y_ - 1); ++y)
                for (int x = std::max(v.x - 1, 0) / GroundMesh::kBlock;
                     x <= std::min(v.x / GroundMesh::kBlock, along_x_ - 1); ++x)
                    if (const int block = at_[place_number(x, y)]; block >= 0)
                        rises_[static_cast<std::size_t>(block)] = 1;
    const float dx = redraw.changed.grid().dx;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (rises_[i] == 0) continue;
        const glm::vec2 low(blocks_[i].lowest), high(blocks_[i].highest);
        const glm::vec2 heights = redraw.changed.heights_between(blocks_[i].lowest, blocks_[i].highest);
        seen_[i] = redraw.screen.box({dx * low, heights.x}, {dx * high, heights.y});
    }
}

void TerrainPass::draw_depth(Target::Parts parts) {
    const Enabled depth_test(GL_DEPTH_TEST), cull_face(GL_CULL_FACE), scissors(GL_SCISSOR_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glUseProgram(depth_program_.name());
    glBindVertexArray(surface_.vertices.name());
    for (const Rectangle& part : parts) {
        find_runs(part);
        scissor(part);
        glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, firsts_.data(),
                            static_cast<GLsizei>(counts_.size()));
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Finds the runs of blocks that a part of the frame may show.
void TerrainPass::find_runs(const Rectangle& part) {
    counts_.clear();
    firsts_.clear();
    std::uint32_t end = 0;  // of the last run
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (!part.meets(seen_[i])) continue;
        const GroundMesh::Block& block = blocks_[i];
        if (counts_.empty() || end != block.first) {
            counts_.push_back(0);
            firsts_.push_back(in_buffer(block.first * sizeof(std::uint32_t)));
        }
        counts_.back() += static_cast<GLsizei>(block.count);
        end = block.first + block.count;
    }
}

void TerrainPass::shade(const Marks& marks, const SlideTiles& tiles, GroundKind kind, const Target& target,
                        Target::Parts parts) {
    CHECK(shadings_[kind]);
    glBindTextureUnit(SLOT_DETAIL, detail_texture_.name());
    const Shadings& shadings = *shadings_[kind];
    const Shading& shading = marks.overlay != Overlay::kNone ? shadings.overlaid
                             : marks.has_lines()             ? shadings.marked
                                                             : shadings.plain;
    const int across = target.samples_across(), up = target.samples_up();
    with_earth_.send(tiles.with_earth(), across, up);
    with_walls_.send(tiles.with_walls(), across, up);
    with_slides_.send(tiles.with_slides(), across, up);
    without_.send(tiles.without(), across, up);
    shading.with_earth.draw_on(with_earth_, parts);
    shading.with_walls.draw_on(with_walls_, parts);
    shading.with_slides.draw_on(with_slides_, parts);
    shading.without.draw_on(without_, parts);
}

void TerrainPass::draw_walls(Target::Parts parts) const {
    const Enabled depth_test(GL_DEPTH_TEST), cull_face(GL_CULL_FACE);
    glBindTextureUnit(SLOT_DETAIL, detail_texture_.name());
    glUseProgram(wall_program_.name());
    within(parts, [&] { walls_.draw(); });
}

}  // namespace render
