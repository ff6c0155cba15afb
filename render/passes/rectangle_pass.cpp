#include "render/passes/rectangle_pass.h"

#include "render/gl/program.h"
#include "render/gl/scissor.h"

namespace render {

void Rectangles::send(std::span<const Rectangle> rectangles, int width, int height) {
    corners_.clear();
    const glm::vec2 per_sample(2.f / static_cast<float>(width), 2.f / static_cast<float>(height));
    for (const Rectangle& r : rectangles)
        corners_.emplace_back(glm::vec2(r.left, r.bottom) * per_sample - 1.f,
                              glm::vec2(r.right, r.top) * per_sample - 1.f);
    if (corners_.size() > room_) {
        room_ = 2 * corners_.size();
        corners_.reserve(room_);
        buffer_ = make_buffer();
        glNamedBufferStorage(buffer_.name(), static_cast<GLsizeiptr>(room_ * sizeof(glm::vec4)), nullptr,
                             GL_DYNAMIC_STORAGE_BIT);
        vertex_array_ = make_vertex_array();
        const GLuint array = vertex_array_.name();
        glVertexArrayVertexBuffer(array, 0, buffer_.name(), 0, sizeof(glm::vec4));
        glVertexArrayBindingDivisor(array, 0, 1);
        glEnableVertexArrayAttrib(array, 0);
        glVertexArrayAttribFormat(array, 0, 4, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayAttribBinding(array, 0, 0);
    }
    if (!corners_.empty())
        glNamedBufferSubData(buffer_.name(), 0, static_cast<GLsizeiptr>(corners_.size() * sizeof(glm::vec4)),
                             corners_.data());
}

void Rectangles::draw() const {
    if (corners_.empty()) return;
    glBindVertexArray(vertex_array_.name());
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(corners_.size()));
}

tl::expected<RectanglePass, std::string> RectanglePass::create(
    const std::filesystem::path& shaders, const std::vector<std::string_view>& fragment_files) {
    auto program = link_program(
        shaders, {{GL_VERTEX_SHADER, {"rectangles.vert"}}, {GL_FRAGMENT_SHADER, fragment_files}});
    if (!program) return tl::unexpected(program.error());
    RectanglePass pass;
    pass.program_ = std::move(*program);
    return pass;
}

void RectanglePass::draw_on(const Rectangles& rectangles, std::span<const Rectangle> parts) const {
    const Enabled depth_test(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    glUseProgram(program_.name());
    within(parts, [&] { rectangles.draw(); });
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_TRUE);
}

}  // namespace render
