#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/frame_block.h"
#include "render/gl_handle.h"
#include "render/structure_mesh.h"

namespace render {

// Draws what people have built, and its shadows on the ground.
class StructuresPass {
  public:
    static tl::expected<StructuresPass, std::string> create(const std::filesystem::path& shaders);

    // Makes the mesh anew if anything that it depends on has changed: a few milliseconds. Returns false if nothing
    // is to be drawn. `new_terrain`: this frame's terrain is not that of the last one.
    bool find(const FrameInput& input, const FrameBlock& frame, bool new_terrain);
    // Draws colour and depth over what is drawn.
    void draw() const;

  private:
    void send(const StructureMesh& mesh);
    void find_parts_in_view(const FrameBlock& frame);

    // Vertices of one kind, as they lie on the GPU.
    struct Vertices {
        Buffer buffer;
        VertexArray array;
        GLsizei count = 0;
    };

    ProgramName faces_program_, ropes_program_, shadows_program_;
    Vertices faces_, ropes_, shadows_;
    std::vector<StructurePart> parts_;
    std::vector<GLint> firsts_;  // of the parts that this frame shows, in faces_
    std::vector<GLsizei> counts_;
    Structures known_;  // of the mesh
    glm::vec4 known_sun_{0};
    glm::vec2 known_snowy_{0};
    std::uint64_t known_around_ = 0;  // fingerprint of the surroundings
};

}  // namespace render
