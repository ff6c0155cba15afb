#include "game/share/built_pieces.h"

#include <algorithm>
#include <array>
#include <span>

#include <glm/gtc/type_ptr.hpp>

namespace game {
namespace {

using enum Packing::Predict;

// A column of a table of vertices: its name, and how it is packed.
struct Column {
    const char* name;
    Packing packing;
};
constexpr Packing kPlace{0.01, 2, kLast}, kUnit{0.01, 1, kLast}, kPart{1.0 / 255, 1, kLast},
    kWhole{1, 1, kLast};

constexpr std::array<Column, 16> kFaces{{{"x", kPlace},
                                         {"y", kPlace},
                                         {"z", kPlace},
                                         {"material", kWhole},
                                         {"normal_x", kUnit},
                                         {"normal_y", kUnit},
                                         {"normal_z", kUnit},
                                         {"number", kPart},
                                         {"across", kPlace},
                                         {"up", kPlace},
                                         {"light", kPart},
                                         {"own", kPart},
                                         {"rests_x", kPlace},
                                         {"rests_y", kPlace},
                                         {"rests_z", kPlace},
                                         {"rests", kWhole}}};
constexpr std::array<Column, 8> kRopes{{{"x", kPlace},
                                        {"y", kPlace},
                                        {"z", kPlace},
                                        {"side", kWhole},
                                        {"along_x", kUnit},
                                        {"along_y", kUnit},
                                        {"along_z", kUnit},
                                        {"half", {0.001, 1, kLast}}}};
constexpr std::array<Column, 8> kShadows{{{"x", kPlace},
                                          {"y", kPlace},
                                          {"z", kPlace},
                                          {"strength", kPart},
                                          {"foot_x", kPlace},
                                          {"foot_y", kPlace},
                                          {"foot_z", kPlace},
                                          {"is_light", kWhole}}};

// The numbers of a vertex, in the order of its members.
std::array<glm::vec4, 4> rows(const render::StructureVertex& v) {
    return {v.at, v.normal, v.face, v.rests};
}
std::array<glm::vec4, 2> rows(const render::RopeVertex& v) {
    return {v.at, v.along};
}
std::array<glm::vec4, 2> rows(const render::StructureShadowVertex& v) {
    return {v.at, v.foot};
}

template <class Vertices, std::size_t n>
void pack_vertices(PackedStream& into, const std::string& table, const Vertices& vertices,
                   const std::array<Column, n>& columns) {
    std::vector<double> column(vertices.size());
    for (std::size_t k = 0; k < n; ++k) {
        std::transform(vertices.begin(), vertices.end(), column.begin(), [&](const auto& v) {
            return static_cast<double>(rows(v)[k / 4][static_cast<int>(k % 4)]);
        });
        into.add(table + "." + columns[k].name, column, columns[k].packing);
    }
}

template <class Pieces>
void pack_pieces(PackedStream& into, const std::string& table, const Pieces& pieces) {
    std::vector<std::uint32_t> column(pieces.size());
    const auto add = [&](const char* name, auto&& value) {
        std::transform(pieces.begin(), pieces.end(), column.begin(),
                       [&](const auto& piece) { return static_cast<std::uint32_t>(value(piece)); });
        into.add(table + "." + name, column, 0, 1, 3, kNone);
    };
    add("first", [](const auto& p) { return p.first; });
    add("count", [](const auto& p) { return p.count; });
    add("from", [](const auto& p) { return p.from; });
    add("until", [](const auto& p) { return p.until; });
}

}  // namespace

template <class Vertex>
void BuiltPieces::Kind<Vertex>::add(std::span<const Vertex> piece, std::int64_t from, std::int64_t until) {
    if (piece.empty()) return;
    for (Piece& known : pieces) {
        const auto begin = vertices.begin() + known.first;
        if (known.until != from || known.count != std::ssize(piece) ||
            !std::equal(piece.begin(), piece.end(), begin,
                        [](const Vertex& a, const Vertex& b) { return rows(a) == rows(b); }))
            continue;
        known.until = until;
        return;
    }
    pieces.push_back({std::ssize(vertices), std::ssize(piece), from, until});
    vertices.insert(vertices.end(), piece.begin(), piece.end());
}

void BuiltPieces::add(const render::StructureMesh& mesh, std::int64_t from, std::int64_t until) {
    const std::span<const render::StructureVertex> faces(mesh.faces);
    for (const render::StructurePart& part : mesh.parts)
        faces_.add(faces.subspan(part.near.first, part.near.count), from, until);
    ropes_.add(mesh.ropes, from, until);
    shadows_.add(mesh.shadows, from, until);
}

void BuiltPieces::pack(PackedStream& into) const {
    pack_vertices(into, "built", faces_.vertices, kFaces);
    pack_pieces(into, "built", faces_.pieces);
    pack_vertices(into, "ropes", ropes_.vertices, kRopes);
    pack_pieces(into, "ropes", ropes_.pieces);
    pack_vertices(into, "shadows", shadows_.vertices, kShadows);
    pack_pieces(into, "shadows", shadows_.pieces);
}

}  // namespace game
