#pragma once

#include <string>
#include <vector>

namespace game::test {

// Names of the shipped scenes that are challenges; found once.
const std::vector<std::string>& challenges();

}  // namespace game::test
