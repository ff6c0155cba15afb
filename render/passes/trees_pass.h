#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/frame/redrawn.h"
#include "render/gl/gl_handle.h"
#include "render/view/frame_block.h"
#include "render/view/ground_kind.h"
#include "render/view/screen_tiles.h"
#include "render/woods/followed_woods.h"
#include "render/woods/trees_in_view.h"
#include "render/woods/woods.h"

namespace render {

// Draws trees and their shadows on the ground.
class TreesPass {
  public:
    // Errors, in one sentence with the file: those of a shader, and pictures of trees that cannot be read or have another size.
    static tl::expected<TreesPass, std::string> create(const std::filesystem::path& assets);
    // Compiles what draw() needs in a world of this kind, if it has not yet. Errors: those of a shader.
    tl::expected<void, std::string> load(const std::filesystem::path& shaders, GroundKind kind);

    // Makes the trees those of woods and of the world's forest. New ones, and a light from another side, take a few
    // hundredths of a second. As FollowedWoods::follow().
    FollowedWoods::Change follow(const Woods* woods, const Surroundings* around, const sim::View& world,
                                 std::span<const float> first_depth, const glm::vec4& sun, bool new_ground);
    bool any() const { return !woods_.trees().tiles.empty(); }
    // Finds the trees of a frame and, if only the world changed, marks those that fell, sank or rose, and those of tiles
    // with other trees than before.
    void find(const FrameInput& input, const Redraw& redraw);
    // Draws colour and depth over what is drawn, in parts of the frame.
    void draw(GroundKind kind, std::span<const Rectangle> parts);

  private:
    void list(std::span<const Rectangle> parts);

    ProgramName shadow_;
    OfGroundKind<ProgramName> pictures_of_;
    Texture pictures_;
    VertexArray no_vertices_;
    Buffer instances_;
    FollowedWoods woods_;
    TreesInView trees_;
    std::vector<Rectangle> seen_;  // of each drawn tree, once a part of a frame is drawn
    OnScreen screen_;
    // The trees of each part, one after the other, as they are on the GPU.
    struct Part {
        Rectangle part;
        std::size_t first, with_shadow, all;
    };
    std::vector<DrawnTree> listed_;
    std::vector<Part> parts_;
    std::size_t room_ = 0;  // trees that instances_ can hold
};

}  // namespace render
