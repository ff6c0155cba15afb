#pragma once

#include <cstdint>
#include <vector>

namespace sim {

template <class T>
class Field;
enum class Site : std::uint8_t;
struct Grid;

enum class Way : std::uint8_t { kEast, kWest, kNorth, kSouth };

// Where material leaves the world: ground beside a drain, by rows.
struct Outlets {
    struct Face {
        int x, y;  // the ground vertex
        Way way;   // toward the drain
    };

    Outlets() = default;
    Outlets(const Grid& grid, const Field<Site>& site);

    std::vector<Face> faces;
    std::vector<int> first_face;  // of each row, and one more: the end
    std::vector<int> drains;      // x of no-data vertices beside ground
    std::vector<int> first_drain;

    struct View {
        const Face* faces;
        const int* first_face;
        const int* drains;
        const int* first_drain;
    };
    View view() const { return {faces.data(), first_face.data(), drains.data(), first_drain.data()}; }
};

}  // namespace sim
