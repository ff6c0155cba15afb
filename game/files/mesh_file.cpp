#include "game/files/mesh_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "files/input.h"
#include "game/base/limits.h"
#include "game/base/number.h"

// An own reader, because tinyobjloader, the usual one, splits polygons into triangles, accepts malformed
// numbers and keeps no line numbers.

namespace game {
namespace {

using sim::front::Mesh;
using sim::front::MeshFault;

// Takes the next word off a line; empty at the end.
std::string_view take_word(std::string_view& line) {
    constexpr std::string_view kBlank = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(kBlank));
    line.remove_prefix(word.size());
    return word;
}

// Collects vertices and faces. Each function takes a line
// without its keyword and returns what is wrong with it.
class Triangles {
  public:
    std::optional<std::string> vertex(std::string_view line, int number) {
        float xyz[3];
        for (float& coordinate : xyz) {
            const std::string_view word = take_word(line);
            const auto value = number_from<float>(word);
            if (word.empty()) return "a vertex with fewer than three coordinates";
            if (!value) return fmt::format("'{}' is not a coordinate", word);
            coordinate = *value;
        }
        if (position.size() == kMostMeshParts) return fmt::format("more than {} vertices", kMostMeshParts);
        position.emplace_back(xyz[0], xyz[1]);
        vertex_line.push_back(number);
        return std::nullopt;
    }

    std::optional<std::string> face(std::string_view line, int number) {
        std::array<int, 3> corners{};
        std::size_t count = 0;
        for (std::string_view word = take_word(line); !word.empty(); word = take_word(line), ++count) {
            const std::string_view index = word.substr(0, word.find('/'));
            const auto value = number_from<int>(index);
            if (!value || *value == 0) return fmt::format("'{}' is not a vertex index", word);
            // Counted from 1, or backward from the last one.
            if (count < 3)
                corners[count] = *value > 0 ? *value - 1 : static_cast<int>(position.size()) + *value;
        }
        if (count != 3) return fmt::format("a face with {} corners; only triangles are supported", count);
        if (triangle.size() == kMostMeshParts) return fmt::format("more than {} triangles", kMostMeshParts);
        triangle.push_back(corners);
        triangle_line.push_back(number);
        return std::nullopt;
    }

    // The line of a fault.
    int line_of(const MeshFault& fault) const {
        return fault.kind == MeshFault::Kind::kNotFinite ? vertex_line[fault.where]
                                                         : triangle_line[fault.where];
    }

    std::vector<glm::vec2> position;
    std::vector<std::array<int, 3>> triangle;
    std::vector<int> vertex_line, triangle_line;
};

}  // namespace

const char* fact_of(MeshFault::Kind kind) {
    switch (kind) {
        case MeshFault::Kind::kNotFinite:
            return "a vertex that is not finite";
        case MeshFault::Kind::kNoSuchVertex:
            return "a triangle with a vertex that does not exist";
        case MeshFault::Kind::kDegenerate:
            return "a triangle with no area seen from above, or with an edge outside 1e-6 to 1e9 m";
        case MeshFault::Kind::kTooManyTriangles:
            return "a third triangle on the same edge";
    }
    return "";
}

Outcome<Mesh> read_obj(const std::filesystem::path& path) {
    const auto bad = [&](const std::string& what) {
        return unusable(fmt::format("{}: {}", path.string(), what));
    };
    const auto bad_line = [&](int number, const std::string& what) {
        return unusable(fmt::format("{}:{}: {}", path.string(), number, what));
    };
    auto opened = files::open_input(path);
    if (!opened) return unusable(opened.error());
    std::ifstream& file = *opened;
    Triangles triangles;
    std::string line(kLongestMeshLine + 1, '\0');
    for (int number = 1; file.peek() != std::ifstream::traits_type::eof(); ++number) {
        file.getline(line.data(), static_cast<std::streamsize>(line.size()));
        if (file.fail()) return bad_line(number, fmt::format("longer than {} characters", kLongestMeshLine));
        std::string_view rest(line.data());
        const std::string_view keyword = take_word(rest);
        std::optional<std::string> wrong;
        if (keyword == "v") wrong = triangles.vertex(rest, number);
        if (keyword == "f") wrong = triangles.face(rest, number);
        if (wrong) return bad_line(number, *wrong);
    }
    if (file.bad()) return bad("cannot be read to the end");
    if (triangles.triangle.empty()) return bad("has no triangles ('f' lines of an OBJ file)");
    auto made = sim::front::mesh_of(triangles.position, triangles.triangle);
    if (const auto* fault = std::get_if<MeshFault>(&made))
        return bad_line(triangles.line_of(*fault), fact_of(fault->kind));
    return std::get<Mesh>(std::move(made));
}

}  // namespace game
