#include "render/flow/flow_triangles.h"

#include <algorithm>

#include "sim/core/check.h"

namespace render {
namespace {

constexpr float kLeastDeposit = 0.001f;  // m, above which flow.vert shows a deposit
constexpr int kLongestGap = 64;          // triangles

}  // namespace

void FlowTriangles::find(const sim::View& world, std::span<const float> undisturbed,
                         std::span<const FlowVertex> vertices, const Look& look) {
    const sim::Grid& grid = world.grid;
    CHECK(look.flow && vertices.size() == grid.size());
    CHECK(undisturbed.empty() || undisturbed.size() == grid.size());
    const auto squares = static_cast<std::size_t>(grid.nx - 1) * static_cast<std::size_t>(grid.ny - 1);
    constexpr std::uint8_t kBoth = kLowerRight | kUpperLeft;
    if (grid_ != grid) {
        grid_ = grid;
        seen_.resize(grid.size());
        shown_.assign(squares, kBoth);
        shown_before_.reserve(squares);
        runs_.reserve(2 * squares / kLongestGap + 1);
    }
    shown_before_ = shown_;
    if (look.flow->everywhere) {
        std::fill(shown_.begin(), shown_.end(), kBoth);
        runs_ = {TriangleRun{0, 2 * static_cast<int>(squares)}};
        return;
    }
    for (int y = 0; y < grid.ny; ++y) mark_row(world, undisturbed, vertices, look.rolling_visible_m, y);
    for (int y = 0; y + 1 < grid.ny; ++y) {
        const std::uint8_t* low =
            seen_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx);
        const std::uint8_t* high = low + grid.nx;
        std::uint8_t* to =
            shown_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx - 1);
        for (int x = 0; x + 1 < grid.nx; ++x) {
            const int ends = low[x] | high[x + 1];
            to[x] =
                static_cast<std::uint8_t>((ends | low[x + 1]) * kLowerRight | (ends | high[x]) * kUpperLeft);
        }
    }
    find_runs();
}

// Marks the vertices of a row that may be seen.
void FlowTriangles::mark_row(const sim::View& world, std::span<const float> undisturbed,
                             std::span<const FlowVertex> vertices, float visible, int y) {
    const int nx = world.grid.nx;
    const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(nx);
    std::uint8_t* seen = seen_.data() + first;
    const float *rolling = world.rolling.row(y), *depth = world.depth.row(y);
    const FlowVertex* vertex = vertices.data() + first;
    for (int x = 0; x < nx; ++x)
        seen[x] = static_cast<std::uint8_t>((rolling[x] > visible) | (vertex[x].deposit > kLeastDeposit));
    if (undisturbed.empty()) return;
    const float* before = undisturbed.data() + first;
    for (int x = 0; x < nx; ++x) seen[x] |= static_cast<std::uint8_t>(depth[x] - before[x] > kLeastRise);
}

void FlowTriangles::find_runs() {
    runs_.clear();
    for (int square = 0; square < static_cast<int>(shown_.size()); ++square) {
        const std::uint8_t shown = shown_[square];
        if (shown == 0) continue;
        if ((shown & kLowerRight) != 0) append(runs_, {2 * square, 2 * square + 1});
        if ((shown & kUpperLeft) != 0) append(runs_, {2 * square + 1, 2 * square + 2});
    }
}

void FlowTriangles::append(std::vector<TriangleRun>& runs, const TriangleRun& more) {
    if (!runs.empty() && more.first - runs.back().last <= kLongestGap)
        runs.back().last = more.last;
    else
        runs.push_back(more);
}

}  // namespace render
