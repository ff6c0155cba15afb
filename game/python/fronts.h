#pragma once

#include "game/python/convert.h"

namespace game::python {

// Adds Mesh, Tracker and track().
void add_fronts(py::module_& module);

}  // namespace game::python
