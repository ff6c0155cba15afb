#include "sim/sweep/sweep.h"

#include <algorithm>
#include <numeric>

#include "sim/core/workers.h"
#include "sim/sweep/sweeper.h"
#include "sim/world/state.h"

namespace sim::sweep {
namespace {

constexpr int kAproned = 4;             // fields that a job changes while adjacent jobs read them
constexpr int kApronRows = kApron + 1;  // of each field on each side; one more for the halo at a border

Ground::Things pointers_to(State& s) {
    Things& t = *s.things;
    return {t.natural.row(0),
            t.drag.row(0),
            t.detrain.row(0),
            t.hold.row(0),
            t.net_depth.row(0),
            t.wall_x.row(0),
            t.wall_y.row(0),
            t.water.row(0),
            s.weather ? s.weather->base.row(0) : t.no_floor.row(0),
            s.weather ? s.weather->base.stride() : 0};
}

}  // namespace

Sweeper::Sweeper(const State& s, int threads, bool last_tile_first)
    : last_tile_first_(last_tile_first),
      outlets_(s.grid, s.site),
      stride_(s.depth.stride()),
      aprons_(static_cast<std::size_t>(s.tiles.rows) * kAproned * 2 * kApronRows *
              static_cast<std::size_t>(stride_)),
      work_(static_cast<std::size_t>(threads) * kWorkRows * static_cast<std::size_t>(stride_)),
      row_active_(static_cast<std::size_t>(threads) * static_cast<std::size_t>(stride_)),
      active_(s.tiles.awake.size()),
      stale_(active_.size()) {
    jobs_.reserve(active_.size());
    booked_.reserve(active_.size());
}

// Splits the marked tiles into rectangles: runs along x, over consecutive rows with equal runs, but few enough
// rows that each thread gets a job.
void Sweeper::find_jobs(const Grid& grid, Tiles& tiles, const std::vector<std::uint8_t>& marked,
                        int threads) {
    jobs_.clear();
    const int most_rows = std::max(1, (tiles.rows + threads - 1) / threads);
    const auto row_of = [&](int row) { return marked.begin() + row * tiles.columns; };
    for (int row = 0; row < tiles.rows;) {
        int end = row + 1;
        while (end < tiles.rows && end - row < most_rows &&
               std::equal(row_of(row), row_of(row + 1), row_of(end)))
            ++end;
        const auto apron = [&](int field) -> Job::Apron {
            float* rows = aprons_.data() + (row * kAproned + field) * 2 * kApronRows * stride_ + kRowPadding;
            return {rows + kApronRows * stride_, rows + kApronRows * stride_};
        };
        for (int column = 0; column < tiles.columns; ++column) {
            if (!row_of(row)[column]) continue;
            const int first = column;
            while (column < tiles.columns && row_of(row)[column]) ++column;
            jobs_.push_back({first * tiles.width, std::min(column * tiles.width, grid.nx), row * tiles.height,
                             std::min(end * tiles.height, grid.ny), apron(0), apron(1), apron(2), apron(3)});
            tiles.open(first, column - 1, row, end - 1);
        }
        row = end;
    }
    if (last_tile_first_) std::reverse(jobs_.begin(), jobs_.end());
    booked_.assign(jobs_.size(), Booked{});
}

// Copies the rows outside a job before any job changes them.
void Sweeper::copy_aprons(const State& s, const Job& job) const {
    const int from = std::max(job.x0 - kBeside, -1), to = std::min(job.x1 + kBeside, s.grid.nx + 1);
    const auto copy = [&](const Field<float>& field, const Job::Apron& apron) {
        const auto copy_rows = [&](int first, float* row, int beside) {
            for (int y = std::max(first, -1); y < std::min(first + kApron, s.grid.ny + 1); ++y)
                std::copy(field.row(y) + from, field.row(y) + to, row + (y - beside) * stride_ + from);
        };
        if (job.y0 > 0) copy_rows(job.y0 - kApron, apron.below, job.y0);
        if (job.y1 < s.grid.ny) copy_rows(job.y1, apron.above, job.y1);
    };
    copy(s.depth, job.depth);
    copy(s.rolling, job.rolling);
    if (s.params.model == Model::kBcre) return;
    copy(s.velocity_x, job.velocity_x);
    copy(s.velocity_y, job.velocity_y);
}

float* Sweeper::work_of(int member) {
    return work_.data() + member * kWorkRows * stride_ + kRowPadding;
}

Ground Sweeper::ground_of(State& s, Substep<float> sub) {
    return {.nx = s.grid.nx,
            .ny = s.grid.ny,
            .stride = stride_,
            .bedrock = s.bedrock.row(0),
            .depth = s.depth.row(0),
            .rolling = s.rolling.row(0),
            .velocity_x = s.velocity_x.row(0),
            .velocity_y = s.velocity_y.row(0),
            .first_slope = s.first_slope.row(0),
            .first_depth = s.first_depth.row(0),
            .smooth_depth = s.smooth_depth.row(0),
            .has_things = s.things.has_value(),
            .things = s.things ? pointers_to(s) : Ground::Things{},
            .borders = s.params.borders,
            .outlets = outlets_.view(),
            .model = s.params.model,
            .scheme = s.params.scheme,
            .bcre = bcre::constants_of(s.params, s.grid.dx, sub),
            .momentum = momentum::constants_of(s.params, s.grid.dx, sub),
            .tile_width = s.tiles.width,
            .tile_height = s.tiles.height,
            .tile_columns = s.tiles.columns,
            .active = active_.data()};
}

Ground Sweeper::open(State& s, const std::vector<std::uint8_t>& marked, int threads, Substep<float> sub) {
    find_jobs(s.grid, s.tiles, marked, threads);
    return ground_of(s, sub);
}

Booked Sweeper::substep(State& s, Workers& workers, InstructionSet set, Substep<float> sub) {
    const Ground ground = open(s, s.tiles.awake, workers.threads(), sub);
    if (jobs_.empty()) return {};

    const auto sweep = kernels_for(set).sweep;
    const int count = static_cast<int>(jobs_.size());
    workers.each_band(count, [&](int first, int last) {
        for (int i = first; i < last; ++i) copy_aprons(s, jobs_[static_cast<std::size_t>(i)]);
    });
    std::fill(active_.begin(), active_.end(), std::uint8_t{0});
    workers.each_member(count, [&](int member, int first, int last) {
        for (int i = first; i < last; ++i) {
            const auto job = static_cast<std::size_t>(i);
            booked_[job] = sweep(ground, jobs_[job], work_of(member), row_active_.data() + member * stride_);
        }
    });
    s.tiles.keep_awake(active_);
    Booked all;
    for (const Booked& each : booked_) all.drained += each.drained, all.limited += each.limited;
    return all;
}

void Sweeper::find_velocity(State& s, Workers& workers, InstructionSet set) {
    if (s.params.model != Model::kBcre) return;  // velocity is state there and already known
    // Tiles written in this tick and their neighbours, because velocity depends on the slope.
    std::transform(s.tiles.awake.begin(), s.tiles.awake.end(), s.tiles.uncounted.begin(), stale_.begin(),
                   [](std::uint8_t awake, std::uint8_t written) { return std::uint8_t(awake | written); });
    const Ground ground = open(s, stale_, workers.threads(), {});
    if (jobs_.empty()) return;
    const auto velocity = kernels_for(set).velocity;
    workers.each_member(static_cast<int>(jobs_.size()), [&](int member, int first, int last) {
        for (int i = first; i < last; ++i)
            velocity(ground, jobs_[static_cast<std::size_t>(i)], work_of(member));
    });
}

}  // namespace sim::sweep
