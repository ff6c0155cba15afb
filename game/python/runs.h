#pragma once

#include "game/python/convert.h"

namespace game::python {

// Adds replay() with what it returns, and ensemble() with its members.
void add_recordings(py::module_& module);
void add_ensembles(py::module_& module);

}  // namespace game::python
