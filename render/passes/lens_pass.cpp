#include "render/passes/lens_pass.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "assets/shaders/slots.glsl"
#include "render/view/camera.h"

namespace render {
namespace {

// Pixels between the points of a spiral, and how many of them a largest radius has at most.
constexpr double kBetween = 1.2, kPointsAlong = 24;
// The same of a frame with one sample per pixel, which is on its way.
constexpr double kBetweenFast = 2.2, kPointsAlongFast = 9;

}  // namespace

tl::expected<LensPass, std::string> LensPass::create(const std::filesystem::path& shaders) {
    LensPass pass;
    for (const auto& [program, file] : {std::pair<ProgramName*, const char*>{&pass.expose_, "lens.frag"},
                                        {&pass.circles_, "lens_circles.frag"},
                                        {&pass.reach_, "lens_reach.frag"},
                                        {&pass.near_, "lens_near.frag"},
                                        {&pass.gather_, "lens_gather.frag"}}) {
        auto linked = link_program(
            shaders, {{GL_VERTEX_SHADER, {"fullscreen.vert"}}, {GL_FRAGMENT_SHADER, {"slots.glsl", file}}});
        if (!linked) return tl::unexpected(linked.error());
        *program = std::move(*linked);
    }
    pass.no_vertices_ = make_vertex_array();
    return pass;
}

void LensPass::Layer::resize(GLenum format, int to_width, int to_height) {
    if (width == to_width && height == to_height) return;
    width = to_width, height = to_height;
    texture = make_texture(format, width, height, GL_NEAREST);
    framebuffer = make_framebuffer();
    glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, texture.name(), 0);
}

void LensPass::fill(const Layer& layer) const {
    glBindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer.name());
    glViewport(0, 0, layer.width, layer.height);
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

GLuint LensPass::draw(const Target& frame, GLuint lit, const Lens& lens, int image_height) {
    taken_.resize(GL_RGBA16F, frame.width(), frame.height());
    if (lens.blur > 0) {
        blur(frame, lit, lens, image_height);
    } else {
        for (Layer* layer : {&circle_, &block_, &near_block_}) layer->forget();
        glBindTextureUnit(SLOT_COLOUR, lit);
        glUseProgram(expose_.name());
        glUniform1f(0, static_cast<float>(lens.exposure));
        fill(taken_);
    }
    return taken_.texture.name();
}

void LensPass::blur(const Target& frame, GLuint lit, const Lens& lens, int image_height) {
    const double most = Lens::kMostBlur * image_height;  // pixels
    const auto send = [&] {
        glUniform4f(0, static_cast<float>(lens.blur * image_height), static_cast<float>(most),
                    static_cast<float>(lens.focus_m / kNear), static_cast<float>(frame.samples()));
    };
    const auto blocks = [](int pixels) { return (pixels + LENS_BLOCK - 1) / LENS_BLOCK; };
    circle_.resize(GL_RGBA16F, frame.width(), frame.height());
    for (Layer* layer : {&block_, &near_block_})
        layer->resize(GL_R16F, blocks(frame.width()), blocks(frame.height()));

    frame.bind_depth(SLOT_SCENE_DEPTH);
    glBindTextureUnit(SLOT_COLOUR, lit);
    glUseProgram(circles_.name());
    send();
    fill(circle_);

    glBindTextureUnit(SLOT_COLOUR, circle_.texture.name());
    glUseProgram(reach_.name());
    fill(block_);

    glBindTextureUnit(SLOT_LENS_REACH, block_.texture.name());
    glUseProgram(near_.name());
    send();
    fill(near_block_);

    const bool fast = frame.samples() == 1;
    const double between =
        std::max(fast ? kBetweenFast : kBetween, most / (fast ? kPointsAlongFast : kPointsAlong));
    glBindTextureUnit(SLOT_LENS_REACH, near_block_.texture.name());
    glUseProgram(gather_.name());
    glUniform2f(0, static_cast<float>(lens.exposure), static_cast<float>(between));
    fill(taken_);
}

void LensPass::forget() {
    for (Layer* layer : {&taken_, &circle_, &block_, &near_block_}) layer->forget();
}

}  // namespace render
