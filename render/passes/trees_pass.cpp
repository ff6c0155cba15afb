#include "render/passes/trees_pass.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "assets/shaders/slots.glsl"
#include "render/passes/scoped_state.h"
#include "render/program.h"

namespace render {

tl::expected<TreesPass, std::string> TreesPass::create(const std::filesystem::path& shaders) {
    const auto link = [&](std::string_view vertex, std::string_view fragment) {
        return link_program(
            shaders, {{GL_VERTEX_SHADER, {"slots.glsl", "frame.glsl", "light.glsl", "tree.glsl", vertex}},
                      {GL_FRAGMENT_SHADER, {"slots.glsl", fragment}}});
    };
    TreesPass pass;
    pass.no_vertices_ = make_vertex_array();
    for (const auto& [program, vertex, fragment] :
         {std::tuple{&pass.shadow_, "tree_shadow.vert", "tree_shadow.frag"},
          std::tuple{&pass.far_, "tree_far.vert", "tree_far.frag"},
          std::tuple{&pass.plain_, "tree_plain.vert", "tree_plain.frag"},
          std::tuple{&pass.near_, "tree_near.vert", "tree_near.frag"}}) {
        auto linked = link(vertex, fragment);
        if (!linked) return tl::unexpected(linked.error());
        *program = std::move(*linked);
    }
    return pass;
}

bool TreesPass::find(const Woods& woods, const Surroundings& around, const sim::View& world,
                     const FlowSoFar& flow, const FrameBlock& frame) {
    const bool is_new = known_ != woods.fingerprint();
    if (is_new) {
        known_ = woods.fingerprint();
        lights_.reserve(woods.trees().size());
        trees_.reserve(woods);
        instances_ =
            make_storage(std::max<std::size_t>(woods.trees().size(), 1) * sizeof(DrawnTree), nullptr);
    }
    if (is_new || known_sun_ != frame.sun) {
        known_sun_ = frame.sun;
        light_trees(woods, around, glm::vec3(frame.sun), lights_);
    }
    trees_.find(woods, lights_, world, flow, frame);
    if (trees_.drawn().empty()) return false;
    glNamedBufferSubData(instances_.name(), 0, static_cast<GLsizeiptr>(trees_.drawn().size_bytes()),
                         trees_.drawn().data());
    return true;
}

// Trees are no instances: a software renderer starts anew for each of these. A vertex finds its tree by its
// number.
void TreesPass::draw() const {
    const Enabled depth_test(GL_DEPTH_TEST);
    const auto all = static_cast<GLsizei>(trees_.drawn().size()), near = static_cast<GLsizei>(trees_.near()),
               far = static_cast<GLsizei>(trees_.far());
    bind_storage(SLOT_TREES, instances_);
    glBindVertexArray(no_vertices_.name());
    {
        // A shadow lies on the ground as a triangle, which is a little above it everywhere.
        const Enabled blend(GL_BLEND), offset(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 256);
        glDepthMask(GL_FALSE);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        glUseProgram(shadow_.name());
        glDrawArrays(GL_TRIANGLES, 0, 3 * static_cast<GLsizei>(trees_.with_shadow()));
        glBlendFunc(GL_ONE, GL_ZERO);
        glDepthMask(GL_TRUE);
        glPolygonOffset(0, 0);
    }
    glUseProgram(near_.name());
    glDrawArrays(GL_TRIANGLES, 0, TREE_VERTICES * near);
    glUseProgram(far_.name());
    glDrawArrays(GL_TRIANGLES, 3 * near, 3 * far);
    glUseProgram(plain_.name());
    glDrawArrays(GL_TRIANGLES, 3 * (near + far), 3 * (all - near - far));
}

}  // namespace render
