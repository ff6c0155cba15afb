#include "render/gl/gl_handle.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace render {

namespace {

bool spoils = false;

void spoil(const Texture& texture, GLenum format) {
    static int number = 0;
    const bool is_nan = number++ % 3 == 0;
    const float wrong =
        is_nan ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::lowest();
    const std::array wrongs{wrong, wrong, wrong, wrong};
    constexpr std::array kShares{0.9f, 0.1f, 0.6f, 0.3f};
    constexpr std::uint8_t kByte = 0xab;
    const auto clear = [&](GLenum layout, GLenum type, const void* value) {
        glClearTexImage(texture.name(), 0, layout, type, value);
    };
    switch (format) {
        case GL_R8UI:
            return clear(GL_RED_INTEGER, GL_UNSIGNED_BYTE, &kByte);
        case GL_STENCIL_INDEX8:
            return clear(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &kByte);
        case GL_DEPTH_COMPONENT32F:
            return clear(GL_DEPTH_COMPONENT, GL_FLOAT, kShares.data());
        case GL_R8:
        case GL_RG8:
        case GL_RGBA8:
        case GL_SRGB8_ALPHA8:
            return clear(GL_RGBA, GL_FLOAT, kShares.data());
        default:
            return clear(GL_RGBA, GL_FLOAT, wrongs.data());
    }
}

void set_sampling(GLuint name, GLint filter) {
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

void spoil_new_memory() {
    spoils = true;
}

Texture make_texture(GLenum format, int width, int height, GLint filter) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, format, width, height);
    set_sampling(name, filter);
    Texture texture(name);
    if (spoils) spoil(texture, format);
    return texture;
}

Texture make_view(const Texture& texture, GLenum format, GLint filter) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glTextureView(name, GL_TEXTURE_2D, texture.name(), format, 0, 1, 0, 1);
    set_sampling(name, filter);
    return Texture(name);
}

Buffer make_buffer() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return Buffer(name);
}

Buffer make_storage(std::size_t bytes, const void* data) {
    Buffer buffer = make_buffer();
    // Handed over rather than cleared: on a GPU trees that were sent after a clear were not drawn.
    constexpr std::uint8_t kNan = 0xff;
    const std::vector<std::uint8_t> wrong(spoils && !data ? bytes : 0, kNan);
    glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(bytes), wrong.empty() ? data : wrong.data(),
                         GL_DYNAMIC_STORAGE_BIT);
    return buffer;
}

void bind_storage(GLuint slot, const Buffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, slot, buffer.name());
}

VertexArray make_vertex_array() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return VertexArray(name);
}

Framebuffer make_framebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return Framebuffer(name);
}

Query make_time_stamp() {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    return Query(name);
}

const void* in_buffer(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace render
