#include "game/session/run_extent.h"

#include <algorithm>

namespace game {

void RunExtent::see(const sim::State& state) {
    const std::int64_t after = std::max<std::int64_t>(state.tick - from_, 0);
    const auto step = static_cast<Step>(std::min<std::int64_t>((after + kStep - 1) / kStep, kNever - 1));
    auto reached = reached_.begin();
    for (int y = 0; y < state.grid.ny; ++y)
        for (int x = 0; x < state.grid.nx; ++x, ++reached)
            if (*reached == kNever && state.rolling(x, y) >= kReached) *reached = step;
}

void RunExtent::at(std::int64_t ticks, std::vector<std::uint8_t>& inside) const {
    constexpr std::uint8_t kInside = 255;
    inside.resize(reached_.size());
    const std::int64_t step = ticks < 0 ? -1 : ticks / kStep;
    std::ranges::transform(reached_, inside.begin(), [&](Step reached) {
        return reached != kNever && reached <= step ? kInside : std::uint8_t{0};
    });
}

}  // namespace game
