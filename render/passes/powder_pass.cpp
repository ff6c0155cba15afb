#include "render/passes/powder_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "render/gl/scissor.h"

namespace render {
namespace {

// As in powder.glsl, std140.
struct PowderBlock {
    glm::vec4 colour;  // w: mean radius of a puff, m
    glm::vec4 lower_colour;
    glm::vec4 across, up;  // of the shade map
    glm::ivec4 divisor;
    glm::vec4 coarse, lit, shadow;
};

constexpr double kLeastBudget = 30000, kBudgetPerSample = 0.07;  // pixels of puffs
constexpr int kFinest = 2, kCoarsest = 6;                        // divisors of the resolution
// Pixels around the box of the cloud. Each that is laid over the frame lies between coarse ones that were drawn.
constexpr int kRim = 1, kCoarseRim = 3;
constexpr std::array<GLenum, 2> kBoth{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
constexpr GLfloat kNothing[4] = {0, 0, 0, 0};

// The pixels of a target of `width` by `height` that lie in `box`, and `rim` more.
Rectangle pixels(const glm::vec4& box, float width, float height, int rim) {
    const auto pixel = [](float at, float size) {
        return static_cast<int>(std::floor((0.5f + 0.5f * at) * size));
    };
    return {pixel(box.x, width) - rim, pixel(box.y, height) - rim, pixel(box.z, width) + rim + 1,
            pixel(box.w, height) + rim + 1};
}

}  // namespace

tl::expected<PowderPass, std::string> PowderPass::create(const std::filesystem::path& shaders) {
    PowderPass pass;
    std::string error;
    const auto link = [&](ProgramName& program, const std::vector<ShaderStage>& stages) {
        auto linked = link_program(shaders, stages);
        if (linked)
            program = std::move(*linked);
        else if (error.empty())
            error = linked.error();
    };
    link(pass.reach_,
         {{GL_VERTEX_SHADER, {"fullscreen.vert"}},
          {GL_FRAGMENT_SHADER,
           {"slots.glsl", "frame.glsl", "powder.glsl", "scene_depth.glsl", "powder_reach.frag"}}});
    link(pass.puffs_,
         {{GL_VERTEX_SHADER, {"slots.glsl", "frame.glsl", "sun_ceiling.glsl", "powder.glsl", "powder.vert"}},
          {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "powder.glsl", "powder.frag"}}});
    link(pass.light_, {{GL_VERTEX_SHADER, {"fullscreen.vert"}},
                       {GL_FRAGMENT_SHADER,
                        {"slots.glsl", "frame.glsl", "light.glsl", "sun_ceiling.glsl", "powder.glsl",
                         "powder_light.frag"}}});
    link(pass.over_, {{GL_VERTEX_SHADER, {"fullscreen.vert"}},
                      {GL_FRAGMENT_SHADER,
                       {"slots.glsl", "frame.glsl", "powder.glsl", "scene_depth.glsl", "powder_over.frag"}}});
    if (!error.empty()) return tl::unexpected(error);

    pass.no_vertices_ = make_vertex_array();
    pass.vertex_array_ = make_vertex_array();
    pass.instances_ = make_buffer();
    constexpr std::size_t kRoom = sim::powder::Cloud::kMost * sizeof(DrawnPuff);
    glNamedBufferStorage(pass.instances_.name(), kRoom, nullptr, GL_DYNAMIC_STORAGE_BIT);
    const GLuint array = pass.vertex_array_.name();
    glVertexArrayVertexBuffer(array, 0, pass.instances_.name(), 0, sizeof(DrawnPuff));
    glVertexArrayBindingDivisor(array, 0, 1);
    for (const auto& [location, offset] : {std::pair<GLuint, std::size_t>{0, offsetof(DrawnPuff, at)},
                                           std::pair<GLuint, std::size_t>{1, offsetof(DrawnPuff, look)},
                                           std::pair<GLuint, std::size_t>{2, offsetof(DrawnPuff, life)}}) {
        glEnableVertexArrayAttrib(array, location);
        glVertexArrayAttribFormat(array, location, 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(array, location, 0);
    }
    pass.block_ = make_buffer();
    glNamedBufferStorage(pass.block_.name(), sizeof(PowderBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    pass.shade_map_ = make_texture(GL_RG32F, ShadeMap::kSide, ShadeMap::kSide, GL_LINEAR);
    return pass;
}

bool PowderPass::find(std::span<const sim::powder::Puff> puffs, const FrameBlock& frame, const Look& look,
                      float strength, int width, int height, bool is_part) {
    seen_.clear();
    cloud_.find(puffs.first(std::min(puffs.size(), sim::powder::Cloud::kMost)), frame, strength, width,
                height, is_part);
    if (cloud_.empty()) return false;
    const double samples = static_cast<double>(width) * height;
    const double too_many =
        static_cast<double>(cloud_.covered()) * samples / (kLeastBudget + kBudgetPerSample * samples);
    divisor_ =
        is_part ? kFinest : std::clamp(static_cast<int>(std::ceil(std::sqrt(too_many))), kFinest, kCoarsest);
    resize(width, height);
    const Rectangle box = pixels(cloud_.box(), static_cast<float>(width), static_cast<float>(height), kRim);
    for (const Rectangle& part : cloud_.parts())
        if (const Rectangle seen = common_part(part, box); !seen.empty()) seen_.push_back(seen);

    PowderBlock block;
    block.colour = {look.powder.colour, cloud_.mean_radius()};
    block.lower_colour = {look.lower_powder.colour, cloud_.mixed() ? 1 : 0};
    block.across = cloud_.shade().across();
    block.up = cloud_.shade().up();
    block.divisor = glm::ivec4(divisor_);
    const glm::vec2 coarse = glm::vec2(width, height) / static_cast<float>(divisor_);
    const glm::vec2 texel = 1.f / glm::vec2(across(), up());
    block.coarse = {coarse, 1 / static_cast<float>(divisor_), 0};
    block.lit = {texel, (glm::ceil(coarse) - 0.5f) * texel};
    const glm::vec3 sun = glm::vec3(frame.lamp) * frame.sun.z, all = sun + glm::vec3(frame.above);
    const glm::vec3 lost = sun / all;
    block.shadow = {lost.r - lost, lost.r};
    glNamedBufferSubData(block_.name(), 0, sizeof block, &block);
    glNamedBufferSubData(instances_.name(), 0, static_cast<GLsizeiptr>(cloud_.drawn().size_bytes()),
                         cloud_.drawn().data());
    glTextureSubImage2D(shade_map_.name(), 0, 0, 0, ShadeMap::kSide, ShadeMap::kSide, GL_RG, GL_FLOAT,
                        cloud_.shade().cells().data());
    return true;
}

// The textures have room for the finest resolution, so that a change of it allocates nothing.
void PowderPass::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    farthest_ = make_texture(GL_R32F, across(), up(), GL_NEAREST);
    thick_ = make_texture(GL_RGBA16F, across(), up(), GL_NEAREST);
    lower_ = make_texture(GL_R16F, across(), up(), GL_NEAREST);
    glClearTexImage(lower_.name(), 0, GL_RED, GL_FLOAT,
                    kNothing);  // read, but not drawn to, with one material
    lit_ = make_texture(GL_RGBA16F, across(), up(), GL_LINEAR);
    hidden_ = make_texture(GL_RGBA32F, across(), up(), GL_NEAREST);
    farthest_frame_ = make_framebuffer();
    thick_frame_ = make_framebuffer();
    lit_frame_ = make_framebuffer();
    glNamedFramebufferTexture(farthest_frame_.name(), GL_COLOR_ATTACHMENT0, farthest_.name(), 0);
    glNamedFramebufferTexture(thick_frame_.name(), GL_COLOR_ATTACHMENT0, thick_.name(), 0);
    glNamedFramebufferTexture(thick_frame_.name(), GL_COLOR_ATTACHMENT1, lower_.name(), 0);
    glNamedFramebufferTexture(lit_frame_.name(), GL_COLOR_ATTACHMENT0, lit_.name(), 0);
    glNamedFramebufferTexture(lit_frame_.name(), GL_COLOR_ATTACHMENT1, hidden_.name(), 0);
    glNamedFramebufferDrawBuffers(lit_frame_.name(), 2, kBoth.data());
}

int PowderPass::across() const {
    return (width_ + kFinest - 1) / kFinest;
}

int PowderPass::up() const {
    return (height_ + kFinest - 1) / kFinest;
}

void PowderPass::draw() const {
    // A frame may end within a coarse pixel.
    const float wide = static_cast<float>(width_) / static_cast<float>(divisor_);
    const float high = static_cast<float>(height_) / static_cast<float>(divisor_);
    const Enabled scissors(GL_SCISSOR_TEST);
    scissor(pixels(cloud_.box(), wide, high, kCoarseRim));
    glBindBufferBase(GL_UNIFORM_BUFFER, SLOT_POWDER, block_.name());
    glViewportIndexedf(0, 0, 0, wide, high);

    glBindFramebuffer(GL_FRAMEBUFFER, farthest_frame_.name());
    fill(reach_);
    glBindTextureUnit(SLOT_POWDER_REACH, farthest_.name());

    glBindFramebuffer(GL_FRAMEBUFFER, thick_frame_.name());
    glDrawBuffers(cloud_.mixed() ? 2 : 1, kBoth.data());  // one material has one colour
    glClearBufferfv(GL_COLOR, 0, kNothing);
    if (cloud_.mixed()) glClearBufferfv(GL_COLOR, 1, kNothing);
    {
        const Enabled blend(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glUseProgram(puffs_.name());
        glBindVertexArray(vertex_array_.name());
        glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(cloud_.drawn().size()));
        glBlendFunc(GL_ONE, GL_ZERO);
    }
    glBindTextureUnit(SLOT_POWDER_THICK, thick_.name());
    glBindTextureUnit(SLOT_POWDER_LOWER, lower_.name());
    glBindTextureUnit(SLOT_POWDER_SHADE, shade_map_.name());

    glBindFramebuffer(GL_FRAMEBUFFER, lit_frame_.name());
    fill(light_);
    glBindTextureUnit(SLOT_POWDER_LIT, lit_.name());
    glBindTextureUnit(SLOT_POWDER_HIDDEN, hidden_.name());
}

void PowderPass::lay_over() const {
    const Enabled blend(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC1_COLOR);
    within(seen_, [&] { fill(over_); });
    glBlendFunc(GL_ONE, GL_ZERO);
}

void PowderPass::fill(const ProgramName& program) const {
    glUseProgram(program.name());
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace render
