#include "render/passes/structures_pass.h"

#include <cmath>
#include <tuple>
#include <utility>

#include "assets/shaders/slots.glsl"
#include "render/passes/scoped_state.h"
#include "render/program.h"
#include "render/ramp.h"

namespace render {
namespace {

// 1 if a material of this colour is snow.
float snowy(const glm::vec3& standing) {
    return ramp(0.55f, 0.75f, standing.g);
}

}  // namespace

tl::expected<StructuresPass, std::string> StructuresPass::create(const std::filesystem::path& shaders) {
    StructuresPass pass;
    const std::vector<std::string_view> lit{"slots.glsl", "frame.glsl", "light.glsl", "sun_ceiling.glsl"};
    const auto with = [&](std::initializer_list<std::string_view> more) {
        std::vector<std::string_view> files = lit;
        files.insert(files.end(), more.begin(), more.end());
        return files;
    };
    for (auto& [program, stages] :
         {std::tuple{
              &pass.faces_program_,
              std::vector<ShaderStage>{{GL_VERTEX_SHADER, with({"triangle_height.glsl", "structure.vert"})},
                                       {GL_FRAGMENT_SHADER, {"slots.glsl", "frame.glsl", "structure.frag"}}}},
          {&pass.ropes_program_,
           {{GL_VERTEX_SHADER, with({"rope.vert"})}, {GL_FRAGMENT_SHADER, {"rope.frag"}}}},
          {&pass.shadows_program_,
           {{GL_VERTEX_SHADER, with({"triangle_height.glsl", "structure_shadow.vert"})},
            {GL_FRAGMENT_SHADER, {"structure_shadow.frag"}}}}}) {
        auto linked = link_program(shaders, stages);
        if (!linked) return tl::unexpected(linked.error());
        *program = std::move(*linked);
    }
    for (const auto& [vertices, attributes] :
         {std::pair{&pass.faces_, 4}, std::pair{&pass.ropes_, 2}, std::pair{&pass.shadows_, 2}}) {
        vertices->buffer = make_buffer();
        vertices->array = make_vertex_array();
        const GLuint array = vertices->array.name();
        const GLsizei size = attributes * static_cast<GLsizei>(sizeof(glm::vec4));
        glVertexArrayVertexBuffer(array, 0, vertices->buffer.name(), 0, size);
        for (GLuint location = 0; location < static_cast<GLuint>(attributes); ++location) {
            glEnableVertexArrayAttrib(array, location);
            glVertexArrayAttribFormat(array, location, 4, GL_FLOAT, GL_FALSE,
                                      location * static_cast<GLuint>(sizeof(glm::vec4)));
            glVertexArrayAttribBinding(array, location, 0);
        }
    }
    return pass;
}

bool StructuresPass::find(const FrameInput& input, const FrameBlock& frame, bool new_terrain) {
    if (!input.structures || input.structures->empty()) return false;
    const glm::vec2 snow(snowy(input.look.standing), snowy(input.look.lower_standing));
    const std::uint64_t around = input.surroundings ? input.surroundings->fingerprint() : 0;
    if (new_terrain || around != known_around_ || snow != known_snowy_ || frame.sun != known_sun_ ||
        *input.structures != known_) {
        known_ = *input.structures;
        known_sun_ = frame.sun;
        known_snowy_ = snow;
        known_around_ = around;
        const std::span<const glm::vec2> cover =
            input.surroundings ? input.surroundings->cover() : std::span<const glm::vec2>();
        send(structure_mesh(known_, {input.world, input.first_depth, cover, snow}, glm::vec3(frame.sun)));
    }
    find_parts_in_view(frame);
    return !firsts_.empty();
}

void StructuresPass::find_parts_in_view(const FrameBlock& frame) {
    constexpr float kDetails = 0.9f;  // m; where a sample is larger, a part is drawn without them
    const glm::vec3 eye(frame.eye);
    const float wide = glm::length(glm::vec3(frame.ray_right)), high = glm::length(glm::vec3(frame.ray_up));
    firsts_.clear();
    counts_.clear();
    for (const StructurePart& part : parts_) {
        const glm::vec4 clip = frame.clip_from_world * glm::vec4(part.middle, 1);
        // A ball reaches beyond the image's edge by more than its radius where that is seen at an angle.
        const float right = part.radius * std::sqrt(1 + 1 / (wide * wide)),
                    up = part.radius * std::sqrt(1 + 1 / (high * high));
        if (clip.w < -part.radius || std::abs(clip.x) > clip.w + right || std::abs(clip.y) > clip.w + up)
            continue;
        const bool far = glm::distance(part.middle, eye) * frame.material.y > kDetails;
        const StructurePart::Range& range = far ? part.far : part.near;
        if (range.count == 0) continue;
        firsts_.push_back(static_cast<GLint>(range.first));
        counts_.push_back(static_cast<GLsizei>(range.count));
    }
}

void StructuresPass::send(const StructureMesh& mesh) {
    const auto fill = [](Vertices& into, const auto& vertices) {
        into.count = static_cast<GLsizei>(vertices.size());
        glNamedBufferData(into.buffer.name(), static_cast<GLsizeiptr>(vertices.size() * sizeof vertices[0]),
                          vertices.data(), GL_DYNAMIC_DRAW);
    };
    fill(faces_, mesh.faces);
    parts_ = mesh.parts;
    firsts_.reserve(parts_.size());
    counts_.reserve(parts_.size());
    fill(ropes_, mesh.ropes);
    fill(shadows_, mesh.shadows);
}

void StructuresPass::draw() const {
    const Enabled depth_test(GL_DEPTH_TEST);
    const auto draw = [](const ProgramName& program, const Vertices& vertices) {
        glUseProgram(program.name());
        glBindVertexArray(vertices.array.name());
        glDrawArrays(GL_TRIANGLES, 0, vertices.count);
    };
    glUseProgram(faces_program_.name());
    glBindVertexArray(faces_.array.name());
    glMultiDrawArrays(GL_TRIANGLES, firsts_.data(), counts_.data(), static_cast<GLsizei>(firsts_.size()));
    const Enabled blend(GL_BLEND);
    glDepthMask(GL_FALSE);
    {
        // A shadow lies on the ground as triangles, which are a little above it everywhere.
        const Enabled offset(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 256);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        draw(shadows_program_, shadows_);
        glPolygonOffset(0, 0);
    }
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw(ropes_program_, ropes_);
    glBlendFunc(GL_ONE, GL_ZERO);
    glDepthMask(GL_TRUE);
}

}  // namespace render
