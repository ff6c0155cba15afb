#pragma once

#include "sim/core/ramp.h"

namespace render {

using sim::ramp;

}  // namespace render
