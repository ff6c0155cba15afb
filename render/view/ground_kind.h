#pragma once

#include <array>
#include <optional>

namespace render {

// What the shaders of ground differ by, each being a program of its own, because code that is not taken costs time too. A
// world is of one kind as long as it has a date or none.
struct GroundKind {
    bool dated = false, two_materials = false;
};

// A T of each kind that was loaded.
template <class T>
class OfGroundKind {
  public:
    std::optional<T>& operator[](GroundKind kind) { return all_[kind.dated][kind.two_materials]; }
    const std::optional<T>& operator[](GroundKind kind) const { return all_[kind.dated][kind.two_materials]; }

  private:
    std::array<std::array<std::optional<T>, 2>, 2> all_;
};

}  // namespace render
