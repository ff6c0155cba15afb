#pragma once

namespace render {

// Triangles of a mesh from `first` to before `last`.
struct TriangleRun {
    int first, last;
};

}  // namespace render
