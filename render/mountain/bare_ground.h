#pragma once

#include "sim/world/state.h"

namespace render {

// Bedrock without the buildings that are a part of it, and without their rubble.
class BareGround {
  public:
    // Null if no building is a part of the bedrock. Valid until the next call, and as long as the view.
    const sim::Field<float>* find(const sim::View& world);

  private:
    sim::Field<float> ground_;
};

}  // namespace render
