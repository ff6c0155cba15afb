#include "render/passes/surface_pass.h"

#include <algorithm>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"

namespace render {
namespace {

constexpr GLint kFirstGroup = 0;  // location in openness.comp

GLuint groups(int vertices) {
    return static_cast<GLuint>((vertices + GROUP_SQUARE - 1) / GROUP_SQUARE);
}

}  // namespace

tl::expected<SurfacePass, std::string> SurfacePass::create(const std::filesystem::path& shaders) {
    auto surface = link_program(
        shaders,
        {{GL_COMPUTE_SHADER, {"slots.glsl", "frame.glsl", "cover.glsl", "surface.glsl", "surface.comp"}}});
    if (!surface) return tl::unexpected(surface.error());
    auto openness = link_program(
        shaders, {{GL_COMPUTE_SHADER, {"slots.glsl", "frame.glsl", "openness.glsl", "openness.comp"}}});
    if (!openness) return tl::unexpected(openness.error());
    SurfacePass pass;
    pass.surface_ = std::move(*surface);
    pass.openness_ = std::move(*openness);
    return pass;
}

void SurfacePass::resize(const sim::Grid& grid) {
    if (grid == grid_) return;
    grid_ = grid;
    groups_ = make_storage(sizeof(std::int32_t) * groups(grid.nx) * groups(grid.ny));
    relief_texture_ = make_texture(GL_RGBA32F, grid.nx, grid.ny, GL_LINEAR);
    layers_texture_ = make_texture(GL_RGBA8, grid.nx, grid.ny, GL_LINEAR);
    measure_texture_ = make_texture(GL_RG32F, grid.nx, grid.ny, GL_LINEAR);
    openness_texture_ = make_texture(GL_R16F, grid.nx, grid.ny, GL_NEAREST);
}

int SurfacePass::openness_reach(const sim::Grid& grid) {
    constexpr double kReach = 0.25;  // of the longer side, as in openness.glsl
    constexpr int kLeast = 4;        // of its hollows
    return std::max(kLeast, static_cast<int>(kReach * std::max(grid.nx, grid.ny))) + 1;
}

void SurfacePass::survey_terrain(glm::ivec2 low, glm::ivec2 high) const {
    const glm::ivec2 first = low / GROUP_SQUARE, count = high / GROUP_SQUARE - first + 1;
    glUseProgram(openness_.name());
    glUniform2i(kFirstGroup, first.x, first.y);
    glBindImageTexture(IMAGE_OPENNESS, openness_texture_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R16F);
    glDispatchCompute(static_cast<GLuint>(count.x), static_cast<GLuint>(count.y), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SurfacePass::run(std::span<const std::int32_t> list) const {
    if (list.empty()) return;
    glNamedBufferSubData(groups_.name(), 0, static_cast<GLsizeiptr>(list.size_bytes()), list.data());
    // The listed part, so that the shader can read its length.
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, SLOT_SURFACE_GROUPS, groups_.name(), 0,
                      static_cast<GLsizeiptr>(list.size_bytes()));
    glUseProgram(surface_.name());
    glBindTextureUnit(SLOT_OPENNESS, openness_texture_.name());
    glBindImageTexture(IMAGE_RELIEF, relief_texture_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(IMAGE_LAYERS, layers_texture_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    glBindImageTexture(IMAGE_MEASURE, measure_texture_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    constexpr std::size_t kMostAcross = 65535;  // of groups, in any OpenGL
    glDispatchCompute(static_cast<GLuint>(std::min(list.size(), kMostAcross)),
                      static_cast<GLuint>((list.size() + kMostAcross - 1) / kMostAcross), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SurfacePass::bind() const {
    glBindTextureUnit(SLOT_RELIEF, relief_texture_.name());
    glBindTextureUnit(SLOT_LAYERS, layers_texture_.name());
    glBindTextureUnit(SLOT_MEASURE, measure_texture_.name());
}

}  // namespace render
