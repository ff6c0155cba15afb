#include "render/passes/terrain_pass.h"

#include <initializer_list>
#include <utility>

#include "assets/shaders/slots.glsl"
#include "render/detail.h"
#include "render/passes/scoped_state.h"
#include "render/program.h"

namespace render {
namespace {

constexpr int kDetailLevels = 10;  // kDetailSize = 2⁹
static_assert(1 << (kDetailLevels - 1) == kDetailSize);

Texture make_detail_texture() {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    Texture texture(name);
    glTextureStorage3D(name, kDetailLevels, GL_RGBA8, kDetailSize, kDetailSize, DETAIL_LAYERS);
    const std::vector<std::uint8_t> texels = make_detail();
    glTextureSubImage3D(name, 0, 0, 0, 0, kDetailSize, kDetailSize, DETAIL_LAYERS, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
    glGenerateTextureMipmap(name);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    return texture;
}

// Creates the surface's shading with the files that define materials, slides and marks.
tl::expected<RectanglePass, std::string> make_shading(const std::filesystem::path& shaders,
                                                      std::initializer_list<std::string_view> variant) {
    std::vector<std::string_view> files{"slots.glsl",  "frame.glsl",      "light.glsl",  "sun_ceiling.glsl",
                                        "ground.glsl", "tone_curve.glsl", "spline.glsl", "terrain.frag"};
    files.insert(files.end(), variant);
    return RectanglePass::create(shaders, files);
}

}  // namespace

tl::expected<TerrainPass, std::string> TerrainPass::create(const std::filesystem::path& shaders) {
    const ShaderStage vertex{GL_VERTEX_SHADER, {"slots.glsl", "frame.glsl", "terrain.vert"}};
    auto depth = link_program(shaders, {vertex, {GL_FRAGMENT_SHADER, {"depth.frag"}}});
    if (!depth) return tl::unexpected(depth.error());
    auto walls = link_program(
        shaders,
        {vertex,
         {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "light.glsl", "sun_ceiling.glsl", "walls.frag"}}});
    if (!walls) return tl::unexpected(walls.error());
    TerrainPass pass;
    struct Variant {
        RectanglePass& to;
        std::initializer_list<std::string_view> files;
    };
    for (const bool two : {false, true}) {
        Shadings& to = two ? pass.two_materials_ : pass.one_material_;
        const std::string_view materials = two ? "materials_two.glsl" : "materials_one.glsl";
        for (const Variant& variant : {
                 Variant{to.plain.with_walls, {materials, "slides.glsl", "crown.glsl", "marks_none.glsl"}},
                 Variant{to.plain.with_slides,
                         {materials, "slides.glsl", "crown_none.glsl", "marks_none.glsl"}},
                 Variant{to.plain.without,
                         {materials, "slides_none.glsl", "crown_none.glsl", "marks_none.glsl"}},
                 Variant{to.marked.with_walls,
                         {materials, "slides.glsl", "crown.glsl", "marks.glsl", "overlay_none.glsl"}},
                 Variant{to.marked.with_slides,
                         {materials, "slides.glsl", "crown_none.glsl", "marks.glsl", "overlay_none.glsl"}},
                 Variant{
                     to.marked.without,
                     {materials, "slides_none.glsl", "crown_none.glsl", "marks.glsl", "overlay_none.glsl"}},
                 Variant{to.overlaid.with_walls,
                         {materials, "slides.glsl", "crown.glsl", "marks.glsl", "overlay.glsl"}},
                 Variant{to.overlaid.with_slides,
                         {materials, "slides.glsl", "crown_none.glsl", "marks.glsl", "overlay.glsl"}},
                 Variant{to.overlaid.without,
                         {materials, "slides_none.glsl", "crown_none.glsl", "marks.glsl", "overlay.glsl"}},
             }) {
            auto shading = make_shading(shaders, variant.files);
            if (!shading) return tl::unexpected(shading.error());
            variant.to = std::move(*shading);
        }
    }
    pass.depth_program_ = std::move(*depth);
    pass.wall_program_ = std::move(*walls);
    pass.detail_texture_ = make_detail_texture();
    return pass;
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
}

void TerrainPass::draw_depth() const {
    const Enabled depth_test(GL_DEPTH_TEST), cull_face(GL_CULL_FACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glUseProgram(depth_program_.name());
    surface_.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void TerrainPass::shade(const Marks& marks, const SlideTiles& tiles, bool two_materials, int width,
                        int height) {
    glBindTextureUnit(SLOT_DETAIL, detail_texture_.name());
    const bool lines = marks.contours || marks.ring;
    const Shadings& shadings = two_materials ? two_materials_ : one_material_;
    const Shading& shading = marks.overlay != Overlay::kNone ? shadings.overlaid
                             : lines                         ? shadings.marked
                                                             : shadings.plain;
    with_walls_.send(tiles.with_walls(), width, height);
    with_slides_.send(tiles.with_slides(), width, height);
    without_.send(tiles.without(), width, height);
    shading.with_walls.draw_on(with_walls_);
    shading.with_slides.draw_on(with_slides_);
    shading.without.draw_on(without_);
}

void TerrainPass::draw_walls() const {
    const Enabled depth_test(GL_DEPTH_TEST), cull_face(GL_CULL_FACE);
    glBindTextureUnit(SLOT_DETAIL, detail_texture_.name());
    glUseProgram(wall_program_.name());
    walls_.draw();
}

}  // namespace render
