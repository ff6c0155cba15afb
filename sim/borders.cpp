#include "sim/borders.h"

#include "sim/params.h"
#include "sim/scratch.h"
#include "sim/state.h"

namespace sim {
namespace {

// One halo vertex from the border vertex beside it. `across` is the velocity component through the border.
void fill(State& s, Border border, int hx, int hy, int x, int y, Field<float>& across, Field<float>& along) {
    const bool wall = border == Border::kWall;
    s.depth(hx, hy) = border == Border::kSink ? 0.f : s.depth(x, y);
    s.rolling(hx, hy) = wall ? s.rolling(x, y) : 0.f;
    across(hx, hy) = wall ? -across(x, y) : 0.f;
    along(hx, hy) = wall ? along(x, y) : 0.f;
}

}  // namespace

void fill_borders(State& s, const Params& params) {
    const int nx = s.grid.nx, ny = s.grid.ny;
    Field<float>&u = s.velocity_x, &v = s.velocity_y;
    for (int y = 0; y < ny; ++y) {
        fill(s, params.borders[kWest], -1, y, 0, y, u, v);
        fill(s, params.borders[kEast], nx, y, nx - 1, y, u, v);
    }
    for (int x = 0; x < nx; ++x) {
        fill(s, params.borders[kSouth], x, -1, x, 0, v, u);
        fill(s, params.borders[kNorth], x, ny, x, ny - 1, v, u);
    }
}

void drain(State& s, const Scratch& scratch) {
    for (const DrainFace& face : scratch.drain_faces) {
        const float flux = (face.along_x ? scratch.flux_x : scratch.flux_y)(face.x, face.y);
        s.ledger.out += face.sign * static_cast<std::int64_t>(flux / kQuantum);
    }
    for (const auto& [x, y] : scratch.drain_vertices) {
        s.rolling(x, y) = 0;
        s.velocity_x(x, y) = s.velocity_y(x, y) = 0;
    }
}

}  // namespace sim
