#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace render {

// Owns a GL name and deletes it. Move-only, empty after a move. The context that created the name must be
// current when the handle is destroyed.
template <class Delete>
class GlHandle {
  public:
    GlHandle() = default;
    explicit GlHandle(GLuint name) : name_(name) {}
    ~GlHandle() { reset(); }
    GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }

    GLuint name() const { return name_; }  // 0 when empty

  private:
    void reset() {
        if (name_ != 0) Delete{}(name_);
        name_ = 0;
    }

    GLuint name_ = 0;
};

struct DeleteTexture {
    void operator()(GLuint name) const { glDeleteTextures(1, &name); }
};
struct DeleteBuffer {
    void operator()(GLuint name) const { glDeleteBuffers(1, &name); }
};
struct DeleteVertexArray {
    void operator()(GLuint name) const { glDeleteVertexArrays(1, &name); }
};
struct DeleteFramebuffer {
    void operator()(GLuint name) const { glDeleteFramebuffers(1, &name); }
};
struct DeleteRenderbuffer {
    void operator()(GLuint name) const { glDeleteRenderbuffers(1, &name); }
};
struct DeleteShader {
    void operator()(GLuint name) const { glDeleteShader(name); }
};
struct DeleteQuery {
    void operator()(GLuint name) const { glDeleteQueries(1, &name); }
};
struct DeleteProgram {
    void operator()(GLuint name) const { glDeleteProgram(name); }
};

using Query = GlHandle<DeleteQuery>;
using Texture = GlHandle<DeleteTexture>;
using Buffer = GlHandle<DeleteBuffer>;
using VertexArray = GlHandle<DeleteVertexArray>;
using Framebuffer = GlHandle<DeleteFramebuffer>;
using Renderbuffer = GlHandle<DeleteRenderbuffer>;
using ShaderName = GlHandle<DeleteShader>;
using ProgramName = GlHandle<DeleteProgram>;

// For tests: from now on fills what OpenGL leaves undefined in new textures and buffers with numbers that show, some with NaN
// and most with the lowest number where a format has those. Mesa's drivers clear such memory; on a GPU, which does not, a
// read of it shows as blotches.
void spoil_new_memory();

// Creates a 2D texture of one level, clamped to its edge. `filter` is GL_NEAREST or GL_LINEAR. Its texels are undefined.
Texture make_texture(GLenum format, int width, int height, GLint filter);
// Creates another name for the texels of `texture`, read in `format`, which has as many bits.
Texture make_view(const Texture& texture, GLenum format, GLint filter);
Buffer make_buffer();
// Creates a storage buffer of a fixed size in bytes, bound for shaders. Without `data` its contents are
// undefined.
Buffer make_storage(std::size_t bytes, const void* data = nullptr);
void bind_storage(GLuint slot, const Buffer& buffer);
VertexArray make_vertex_array();
Framebuffer make_framebuffer();
Query make_time_stamp();
// A place in the bound index buffer, bytes from its start, as OpenGL takes it.
const void* in_buffer(std::size_t bytes);

}  // namespace render
