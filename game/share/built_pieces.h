#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "game/share/packed_stream.h"
#include "render/buildings/structure_mesh.h"

namespace game {

// Triangles of what people have built, as long as each stands: a page draws those of its moment.
class BuiltPieces {
  public:
    // The structures as they are from a frame on. `until`: the frame at which they change.
    void add(const render::StructureMesh& mesh, std::int64_t from, std::int64_t until);
    bool empty() const { return faces_.pieces.empty() && ropes_.pieces.empty(); }
    void pack(PackedStream& into) const;

  private:
    struct Piece {
        std::int64_t first, count, from, until;  // vertices; frames
    };
    // Vertices of one kind. A piece that goes on as it was is kept once.
    template <class Vertex>
    struct Kind {
        std::vector<Vertex> vertices;
        std::vector<Piece> pieces;

        void add(std::span<const Vertex> piece, std::int64_t from, std::int64_t until);
    };

    Kind<render::StructureVertex> faces_;
    Kind<render::RopeVertex> ropes_;
    Kind<render::StructureShadowVertex> shadows_;
};

}  // namespace game
