#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/buildings/structure_mesh.h"
#include "render/frame/frame_input.h"
#include "render/frame/redrawn.h"
#include "render/frame/what_changed.h"
#include "render/gl/gl_handle.h"
#include "render/view/frame_block.h"

namespace render {

// Draws what people have built, and its shadows on the ground.
class StructuresPass {
  public:
    static tl::expected<StructuresPass, std::string> create(const std::filesystem::path& shaders);

    // Makes the mesh anew if anything that it depends on has changed: a few milliseconds. `new_terrain`: this frame's
    // terrain is not that of the last one; `moved`: the vertices whose bedrock is another one.
    void build(const FrameInput& input, const FrameBlock& frame, bool new_terrain,
               std::span<const glm::ivec2> moved);
    // Finds what a camera sees and, if only the world changed, marks what stands on ground that moved, or in another
    // light; after the mesh was made anew, whatever it and the last one show.
    void find(const FrameInput& input, const Redraw& redraw);
    bool any() const { return !in_view_.empty() || (!known_.nets.empty() && !ropes_seen_.empty()); }
    // Draws colour and depth over what is drawn, in parts of the frame.
    void draw(std::span<const Rectangle> parts);

  private:
    void send(const StructureMesh& mesh);
    void find_parts_in_view(const FrameInput& input, const Redraw& redraw);
    void mark_all(ScreenTiles& tiles) const;
    Rectangle shadow_box(std::size_t first, const Redraw& redraw) const;

    // Vertices of one kind, as they lie on the GPU.
    struct Vertices {
        Buffer buffer;
        VertexArray array;
        GLsizei count = 0;
    };

    ProgramName faces_program_, ropes_program_, shadows_program_;
    Vertices faces_, ropes_, shadows_;
    std::vector<StructurePart> parts_;
    // Of the parts that this frame shows: where, and in which vertices of faces_; of those in one part of it.
    std::vector<const StructurePart*> in_view_;
    std::vector<Rectangle> seen_;
    std::vector<StructurePart::Range> ranges_;
    std::vector<GLint> firsts_;
    std::vector<GLsizei> counts_;
    std::vector<StructureShadowVertex> shadow_vertices_;
    glm::vec3 ropes_lowest_{0}, ropes_highest_{0};
    Rectangle shadows_seen_, ropes_seen_;
    bool rebuilt_ = false;  // in this frame
    Structures known_;      // of the mesh
    glm::vec4 known_sun_{0};
    glm::vec2 known_snowy_{0};
    std::uint64_t known_around_ = 0;  // fingerprint of the surroundings
};

}  // namespace render
