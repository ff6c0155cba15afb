#include "render/gl/scoped_state.h"

#include "assets/shaders/slots.glsl"

namespace render {
namespace {

// An overlay may have left these on. Every pass assumes that they are off.
constexpr std::array<GLenum, 5> kOff{GL_BLEND, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_DEPTH_TEST};

}  // namespace

ScopedState::ScopedState() {
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_);
    glGetIntegerv(GL_CLIP_ORIGIN, &clip_origin_);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &clip_depth_);
    glGetIntegerv(GL_DEPTH_FUNC, &depth_function_);
    for (std::size_t i = 0; i < kOff.size(); ++i) {
        switches_[i] = glIsEnabled(kOff[i]);
        glDisable(kOff[i]);
    }
    // Reversed depth keeps its precision only if clip space is not stretched to −1 … 1 first.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDepthFunc(GL_GEQUAL);
}

ScopedState::~ScopedState() {
    glBindTextures(0, SLOT_UNITS, nullptr);
    for (std::size_t i = 0; i < kOff.size(); ++i) {
        if (switches_[i] == GL_TRUE) glEnable(kOff[i]);
    }
    glDepthFunc(static_cast<GLenum>(depth_function_));
    glClipControl(static_cast<GLenum>(clip_origin_), static_cast<GLenum>(clip_depth_));
    glBindVertexArray(static_cast<GLuint>(vertex_array_));
    glUseProgram(static_cast<GLuint>(program_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_framebuffer_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_framebuffer_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

}  // namespace render
