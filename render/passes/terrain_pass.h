#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/frame/marks.h"
#include "render/frame/redrawn.h"
#include "render/frame/slide_tiles.h"
#include "render/frame/what_changed.h"
#include "render/gl/gl_handle.h"
#include "render/mountain/ground_mesh.h"
#include "render/passes/rectangle_pass.h"
#include "render/passes/target.h"
#include "render/view/ground_kind.h"
#include "render/view/on_screen.h"

namespace render {

// Draws the block of terrain. Its surface is drawn as depth first and shaded once per pixel from that,
// because most shading of triangles a few pixels wide would be discarded. Its few walls are drawn and shaded
// in one pass.
class TerrainPass {
  public:
    static tl::expected<TerrainPass, std::string> create(const std::filesystem::path& shaders);
    // Compiles what shade() needs for ground of this kind, if it has not yet. Errors as in create().
    tl::expected<void, std::string> load(const std::filesystem::path& shaders, GroundKind kind);

    void send_mesh(const GroundMesh& mesh);
    // Finds where blocks of the ground appear; unless everything is drawn anew, those that rose or sank. Marks nothing.
    void find(const Redraw& redraw);
    // The following draw parts of `target`.
    void draw_depth(Target::Parts parts);  // reads SLOT_RELIEF
    // Reads SLOT_SCENE_DEPTH, SLOT_RELIEF, SLOT_LAYERS, SLOT_MEASURE, SLOT_SUN_CEILING, SLOT_DETAIL, SLOT_EARTH.
    void shade(const Marks& marks, const SlideTiles& tiles, GroundKind kind, const Target& target,
               Target::Parts parts);
    void draw_walls(
        Target::Parts parts) const;  // reads SLOT_RELIEF, SLOT_SITE, SLOT_SUN_CEILING, SLOT_DETAIL

  private:
    void find_runs(const Rectangle& part);
    std::size_t place_number(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(along_x_) + static_cast<std::size_t>(x);
    }

    // Indexed triangles without attributes: heights come from textures, positions from the index.
    struct Indexed {
        VertexArray vertices;
        Buffer indices;
        GLsizei count = 0;

        void send(const std::vector<std::uint32_t>& values);
        void draw() const;
    };

    ProgramName depth_program_, wall_program_;
    // Variants, because shader code costs time even if its branch is not taken.
    struct Shading {
        RectanglePass with_earth, with_walls, with_slides, without;
    };
    struct Shadings {
        Shading plain, marked, overlaid;
    };
    static tl::expected<Shadings, std::string> make_shadings(const std::filesystem::path& shaders,
                                                             GroundKind kind);
    OfGroundKind<Shadings> shadings_;
    Rectangles with_earth_, with_walls_, with_slides_, without_;
    Indexed surface_, walls_;
    Texture detail_texture_;
    std::vector<GroundMesh::Block> blocks_;
    std::vector<Rectangle> seen_;      // where each block appears
    std::vector<int> at_;              // number of a block by its place, −1: empty
    int along_x_ = 0, along_y_ = 0;    // places of blocks
    std::vector<std::uint8_t> rises_;  // per block, of one frame
    std::vector<GLsizei> counts_;      // of runs of blocks in one part
    std::vector<const void*> firsts_;
};

}  // namespace render
