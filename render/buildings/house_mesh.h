#pragma once

#include <vector>

#include "render/buildings/structure_builder.h"

namespace render {

// A house of the size, material and state of its structure. `simple`: with few windows and little debris.
void add_house(const BuildingSite& site, std::vector<StructureVertex>& faces, OpenPart& part, bool simple);

// The two windows of a station's side. `middle`: of the side; `right`: unit vector along it.
void add_station_windows(const BuildingSite& site, StructureBuilder& into, vec3 middle, vec3 right);

}  // namespace render
