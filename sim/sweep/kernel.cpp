#include "sim/bcre/stages.h"
#include "sim/momentum/stages.h"
#include "sim/sweep/sweep.h"

// The sweep, for any number of lanes. Runs the stages of the plain step (bcre/stages.h) row by row over a job.
// A stage runs as soon as the rows that it reads are done. Only the last few rows of its results are kept, so
// that they are still in a near cache when the next stage reads them.
//
//     drops (t)  ─►  slope_dx (t − 1)  ─►  outflow (t − 1)  ─►  fluxes (t − 1)  ─►  d, R (t − 2)
//
// A row of the layers is overwritten when no stage reads its old values any more. Stages also run on rows
// outside the job (`beside`), as many as later stages read: the last on none, the first on all that kApron
// covers. Two adjacent jobs compute bit-identical values there.

namespace sim::sweep {

// Hands out work rows one after the other.
class WorkRows {
  public:
    WorkRows(float* first, std::ptrdiff_t stride) : next_(first), stride_(stride) {}

    // Visits the fields of a list and keeps the last `count` rows of each. Does not loop over pointers to
    // fields, because the compiler keeps a field in registers only if nothing points to it.
    auto keep(int count) {
        return [ this, count ](std::string_view, Rows<float> & field) __attribute__((always_inline)) {
            field = {next_, stride_, count};
            next_ += count * stride_;
        };
    }

  private:
    float* next_;
    std::ptrdiff_t stride_;
};

template <class Lanes>
class Kernel {
  public:
    Kernel(const Ground& ground, const Job& job)
        : g_(ground), job_(job), tile_end_(job.y0 + ground.tile_height) {}

    template <Scheme scheme>
    [[gnu::flatten]] Booked first_order(float* work, std::uint8_t* active) {
        using namespace bcre;
        StageRows<float> w = begun<StageRows<float>>(g_.bcre);
        WorkRows rows(work, g_.stride);
        StateRows<float>& u0 = w.u0;
        each_rate(rows.keep(2), u0);
        each_transfer(rows.keep(2), w);
        const auto outflow = [&](int y) {
            if constexpr (scheme == Scheme::kLaxFriedrichs)
                return find_quarter_outflow<Lanes>(w, w.outflow, u0, y);
            else
                return find_outflow<Lanes>(w, w.outflow, y);
        };
        const auto fluxes = [&](int y) {
            if constexpr (scheme == Scheme::kLaxFriedrichs)
                return find_quarter_fluxes<Lanes>(w, w.flux_x, w.flux_y, y);
            else
                return find_split_fluxes<Lanes>(w, w.flux_x, w.flux_y, y);
        };
        for (int t = job_.y0 - 1; t < job_.y1 + 2; ++t) {
            if (is_row(t, 2)) fill_halo<Lanes>(w, u0, t, wide());
            if (is_face(t, 1)) run(find_drops<Lanes>(w, u0, u0.drop_x, u0.drop_y, t));
            if (is_row(t - 1, 1)) run(find_slope_dx<Lanes>(u0, u0.slope_dx, t - 1), fetch(w.bedrock, t + 1));
            if (is_row(t - 1, 1)) run(outflow(t - 1));
            if (is_near(t - 1, 1)) end_outflow<Lanes>(w, w.outflow, u0, t - 1, wide());
            if (is_face(t - 1, 0)) run(fluxes(t - 1), fetch(u0.depth, t + 1));
            if (scheme == Scheme::kLaxFriedrichs && is_face(t - 1, 0))
                close_walls<Lanes>(w, w.flux_x, w.flux_y, t - 1, wide());
            if (is_row(t - 2, 0)) finish<scheme>(w, t - 2, active, fetch(u0.rolling, t + 1));
        }
        return booked_;
    }

    [[gnu::flatten]] Booked second_order(float* work, std::uint8_t* active) {
        using namespace bcre;
        StageRows<float> w = begun<StageRows<float>>(g_.bcre);
        WorkRows rows(work, g_.stride);
        StateRows<float>&u0 = w.u0, &u1 = w.u1;
        each_layer(rows.keep(8), u1);
        each_transfer(rows.keep(8), w);
        each_rate(rows.keep(4), u0), each_rate(rows.keep(4), u1);
        bool limits_outflow[2] = {};  // whether a vertex limits its outflow, in either of the last two rows
        // Computes the rates of a state, beginning with the drops of row y.
        const auto find_rates = [&](StateRows<float>& u, int y, int beside) {
            if (is_face(y, beside + 1)) run(find_drops<Lanes>(w, u, u.drop_x, u.drop_y, y));
            if (is_face(y, beside + 1)) end_drops<Lanes>(w, u.drop_x, y);
            if (is_face(y - 1, beside + 1))
                run(find_curvature<Lanes>(w, u, u.curvature_x, u.curvature_y, y - 1),
                    find_central_velocity<Lanes>(w, u, u.velocity_x, u.velocity_y, y - 1));
            if (is_row(y - 1, beside + 1)) end_velocity<Lanes>(w, u.velocity_x, y - 1);
        };
        for (int t = job_.y0 - 5; t < job_.y1 + 5; ++t) {
            if (is_row(t, 5)) fill_halo<Lanes>(w, u0, t, wide());
            find_rates(u0, t, 3);
            if (is_face(t - 1, 3))
                run(find_limited_slope_dx<Lanes>(u0, u0.slope_dx, t - 2),
                    find_muscl_fluxes<Lanes, RkStage::kFirst>(w, w.flux_x, w.flux_y, t - 1),
                    fetch(w.bedrock, t + 1));
            if (is_face(t - 1, 3)) close_walls<Lanes>(w, w.flux_x, w.flux_y, t - 1, wide());
            if (is_row(t - 2, 3)) run(predict<Lanes>(w, w.exchanged, u1, t - 2));
            if (is_row(t - 2, 3)) {
                clear_drains<Lanes>(u1, g_.outlets, t - 2, wide());
                fill_halo<Lanes>(w, u1, t - 2, wide());
            }
            find_rates(u1, t - 2, 1);
            if (is_face(t - 3, 1))
                run(find_limited_slope_dx<Lanes>(u1, u1.slope_dx, t - 4),
                    find_muscl_fluxes<Lanes, RkStage::kSecond>(w, w.flux_x, w.flux_y, t - 3),
                    fetch(u0.depth, t + 1));
            if (is_face(t - 3, 1)) close_walls<Lanes>(w, w.flux_x, w.flux_y, t - 3, wide());
            if (is_row(t - 4, 1)) {
                limits_outflow[t & 1] = false;
                run(find_share<Lanes>(w, w.share, t - 4, &limits_outflow[t & 1]));
            }
            if (is_near(t - 4, 1)) end_share<Lanes>(w, w.share, t - 4, wide());
            if (is_face(t - 4, 0) && (limits_outflow[0] || limits_outflow[1]))
                run(share_fluxes<Lanes>(w, w.flux_x, w.flux_y, t - 4));
            if (is_face(t - 4, 0)) run(quantise_fluxes<Lanes>(w, w.flux_x, w.flux_y, t - 4));
            if (is_row(t - 5, 0)) finish<Scheme::kMuscl>(w, t - 5, active, fetch(u0.rolling, t + 1));
        }
        return booked_;
    }

    template <bool exchanges, bool has_things>
    [[gnu::flatten]] Booked momentum(float* work, std::uint8_t* active) {
        using namespace sim::momentum;
        WorkRows rows(work, g_.stride);
        StageRows<float> w = begun<StageRows<float>>(g_.momentum);
        LayerRows<float>& u0 = w.u0;
        u0.velocity_x = beside_job(g_.velocity_x, job_.velocity_x);
        u0.velocity_y = beside_job(g_.velocity_y, job_.velocity_y);
        w.smooth_depth = Rows<float>(g_.smooth_depth, g_.stride);
        w.first_slope = Rows<float>(g_.first_slope, g_.stride);
        w.first_depth = Rows<float>(g_.first_depth, g_.stride);
        if constexpr (has_things)
            w.things = {of_world(g_.things.natural),
                        of_world(g_.things.drag),
                        of_world(g_.things.detrain),
                        of_world(g_.things.hold),
                        of_world(g_.things.net_depth),
                        of_world(g_.things.wall_x),
                        of_world(g_.things.wall_y),
                        of_world(g_.things.water),
                        Rows<float>(g_.things.floor, g_.things.floor_stride)};
        each_field(rows.keep(4), w);
        // The row beyond the border is written with the last one.
        for (Rows<float>* early : {&w.driven_u, &w.driven_v, &w.fed}) rows.keep(8)({}, *early);
        if constexpr (!exchanges) w.exchange_nothing();
        constexpr int kMore = exchanges ? 1 : 0;  // start and rest read the neighbours after transport
        bool limits_outflow[2] = {};  // whether a vertex limits its outflow, in either of the last two rows
        for (int t = job_.y0 - 4 - kMore; t < job_.y1 + 4 + kMore; ++t) {
            if (is_row(t, 4 + kMore)) fill_halo<Lanes>(w, u0, t, wide());
            if (is_row(t - 1, 3 + kMore))
                run(find_ground<Lanes, has_things>(w, w, t - 1), fetch(u0.rolling, t + 1));
            if (is_near(t - 1, 3 + kMore)) end_ground<Lanes>(w, w, t - 1, wide());
            if (is_row(t - 1, 3 + kMore)) {
                run(drive<Lanes, exchanges, has_things>(w, w, t - 1), fetch(w.bedrock, t + 1));
                if constexpr (exchanges) {
                    run(exchange<Lanes, has_things>(w, w, t - 1));
                    end_exchange<Lanes>(w, w, t - 1, wide());
                }
                end_drive<Lanes>(w, w, t - 1, wide());
            }
            if (is_row(t - 2, 2 + kMore)) run(reconstruct<Lanes>(w, w, t - 2), fetch(u0.depth, t + 1));
            if (is_near(t - 2, 2 + kMore)) end_reconstruct<Lanes>(w, w, t - 2, wide());
            if (is_face(t - 2, 1 + kMore)) run(find_fluxes_x<Lanes, has_things>(w, w, t - 2));
            if (is_face(t - 2, 1 + kMore))
                run(find_fluxes_y<Lanes, has_things>(w, w, t - 2), fetch(u0.velocity_x, t));
            if (is_face(t - 2, 1 + kMore)) end_fluxes<Lanes>(w, w, t - 2, wide());
            if (is_row(t - 3, 1 + kMore)) {
                limits_outflow[t & 1] = false;
                run(find_share<Lanes>(w, w.share, t - 3, &limits_outflow[t & 1]));
            }
            if (is_near(t - 3, 1 + kMore)) end_share<Lanes>(w, w.share, t - 3, wide());
            if (is_face(t - 3, kMore) && (limits_outflow[0] || limits_outflow[1]))
                run(share_fluxes<Lanes>(w, w, t - 3));
            if (is_face(t - 3, kMore)) run(quantise_fluxes<Lanes>(w, w, t - 3), fetch(u0.velocity_y, t));
            if constexpr (exchanges) {
                if (is_row(t - 4, 1)) {
                    finish_beside(w, t - 4);
                    end_finish<Lanes>(w, w, t - 4, wide());
                    run(find_quiet<Lanes>(w, w, t - 4));
                    LayerRows<float> moved = w.moved();
                    clear_drains<Lanes>(moved, g_.outlets, t - 4, wide());
                    fill_halo<Lanes>(w, moved, t - 4, wide());
                }
                if (is_near(t - 4, 1)) end_quiet<Lanes>(w, w, t - 4, wide());
                if (is_row(t - 5, 0)) {
                    along<Lanes>(narrow(), yield<Lanes, has_things>(w, u0, t - 5, job_.x1, active));
                    end_row(u0, w, t - 5, active);
                }
            } else if (is_row(t - 4, 0)) {
                along<Lanes>(narrow(),
                             sim::momentum::finish<Lanes>(w, w, t - 4, job_.x1, &booked_.limited, active));
                end_finish<Lanes>(w, w, t - 4, narrow());
                end_row(u0, w, t - 4, active);
            }
        }
        return booked_;
    }

    // Computes the velocity for views at the end of a tick.
    void find_velocity(float* work) {
        WorkRows rows(work, g_.stride);
        bcre::StageRows<float> w = begun<bcre::StageRows<float>>(g_.bcre);
        w.u0.depth = Rows<float>(g_.depth, g_.stride);  // nothing changes it now
        each_rate(rows.keep(2), w.u0);
        w.u0.velocity_x = Rows<float>(g_.velocity_x, g_.stride);
        w.u0.velocity_y = Rows<float>(g_.velocity_y, g_.stride);
        for (int t = job_.y0; t <= job_.y1; ++t) {
            if (t < job_.y1) fill_halo<Lanes>(w, w.u0, t, narrow());
            along<Lanes>(narrow().faces(), find_drops<Lanes>(w, w.u0, w.u0.drop_x, w.u0.drop_y, t),
                         fetch(w.bedrock, t + 1), fetch(w.u0.depth, t + 1));
            if (t > job_.y0)
                along<Lanes>(narrow(),
                             bcre::find_velocity<Lanes>(w, w.u0.velocity_x, w.u0.velocity_y, t - 1, job_.x1),
                             fetch(w.u0.velocity_x, t), fetch(w.u0.velocity_y, t));
        }
    }

  private:
    // Runs a stage over the job and its margin. Most stages have a loop of their own: a processor looks ahead
    // over some hundred operations, which are many vertices of a short stage but hardly two of a long one. A
    // stage that waits for the divider shares a loop with an independent one that does not divide; both run on
    // all rows that either needs.
    template <class... Stages>
    void run(const Stages&... stages) const {
        const bool at_border = wide().last == g_.nx;  // elsewhere no stage reads that far
        along<Lanes>(at_border ? wide().faces() : wide(), stages...);
    }
    // Prefetches a row that will be read next, in the loop of another stage. One row for each stage, because a
    // core can wait for only about a dozen cache lines.
    auto fetch(const Rows<float>& rows, int y) const {
        return [row = rows[std::clamp(y, job_.y0, job_.y1 - 1)]](int i) { __builtin_prefetch(row + i); };
    }

    // Columns of the job; `wide` has its margin too, whose results the job reads.
    Span narrow() const { return {job_.x0, job_.x1}; }
    Span wide() const { return {std::max(job_.x0 - kBeside, 0), std::min(job_.x1 + kBeside, g_.nx)}; }

    // Whether y is a row, or a face, of the job or of `beside` rows outside it. is_near() includes the halo.
    bool is_row(int y, int beside) const {
        return y >= std::max(job_.y0 - beside, 0) && y < std::min(job_.y1 + beside, g_.ny);
    }
    bool is_near(int y, int beside) const {
        return y >= std::max(job_.y0 - beside, -1) && y < std::min(job_.y1 + beside, g_.ny + 1);
    }
    bool is_face(int y, int beside) const {
        return y >= std::max(job_.y0 - beside, 0) && y <= std::min(job_.y1 + beside, g_.ny);
    }

    // Returns the layers as before the sub-step. Rows outside the job are read from copies, because another
    // job may have changed them.
    template <class Work, class Constants>
    Work begun(const Constants& constants) const {
        Work w{};
        w.nx = g_.nx, w.ny = g_.ny;
        w.borders = g_.borders;
        w.c = constants;
        w.bedrock = Rows<float>(g_.bedrock, g_.stride);
        w.u0.depth = beside_job(g_.depth, job_.depth);
        w.u0.rolling = beside_job(g_.rolling, job_.rolling);
        return w;
    }
    Rows<float> of_world(float* field) const { return Rows<float>(field, g_.stride); }
    Rows<float> beside_job(float* field, const Job::Apron& apron) const {
        return Rows<float>(field, g_.stride)
            .beside(job_.y0, job_.y0 > 0 ? apron.below : field + job_.y0 * g_.stride, job_.y1,
                    job_.y1 < g_.ny ? apron.above : field + job_.y1 * g_.stride);
    }

    template <Scheme scheme, class Fetch>
    void finish(bcre::StageRows<float>& w, int y, std::uint8_t* active, Fetch fetch) {
        along<Lanes>(narrow(), bcre::settle<Lanes, scheme>(w, w.u0, y, job_.x1, active), fetch);
        end_row(w.u0, w, y, active);
    }
    // Transport ends on a row of the job, and beside it, where limited vertices are another job's to count.
    void finish_beside(momentum::StageRows<float>& w, int y) {
        const Span all = wide();
        const auto finish = [&](Span x, std::int64_t* limited) {
            if (x.first < x.last) along<Lanes>(x, momentum::finish<Lanes>(w, w, y, x.last, limited));
        };
        finish({all.first, job_.x0}, nullptr);
        finish({job_.x0, job_.x1}, y >= job_.y0 && y < job_.y1 ? &booked_.limited : nullptr);
        finish({job_.x1, all.last}, nullptr);
    }
    // `through`: the fluxes.
    template <class State, class Fluxes>
    void end_row(State& u0, const Fluxes& through, int y, std::uint8_t* active) {
        booked_.drained += drained<Lanes>(through, g_.outlets, y, narrow());
        clear_drains<Lanes>(u0, g_.outlets, y, narrow());
        const bool ends_tiles = y + 1 == tile_end_ || y + 1 == job_.y1;
        if (ends_tiles || edges_at(y + 1) != edges_at(y)) tell_active(edges_at(y), y, active);
        if (ends_tiles) tile_end_ += g_.tile_height;
    }

    // Returns kSomewhere and the tile edges that row y is close to.
    std::uint8_t edges_at(int y) const {
        return static_cast<std::uint8_t>(kSomewhere |
                                         (y < tile_end_ - g_.tile_height + kReach ? kNearSouth : 0) |
                                         (y >= tile_end_ - kReach ? kNearNorth : 0));
    }

    // Marks active tiles. Call after the last row y that is close to the same edges.
    void tell_active(std::uint8_t edges, int y, std::uint8_t* active) const {
        std::uint8_t* tiles = g_.active + y / g_.tile_height * g_.tile_columns;
        for (int x = job_.x0; x < job_.x1; x += kLanes<Lanes>) {
            std::uint8_t& here = active[x / kLanes<Lanes>];
            if (!here) continue;
            here = 0;
            const int column = x / g_.tile_width, from_west = x - column * g_.tile_width;
            const int from_east = g_.tile_width - (from_west + kLanes<Lanes>);
            tiles[column] =
                static_cast<std::uint8_t>(tiles[column] | edges | (from_west < kReach ? kNearWest : 0) |
                                          (from_east < kReach ? kNearEast : 0));
        }
    }

    const Ground& g_;
    const Job job_;
    int tile_end_;  // end of the current row of tiles
    Booked booked_;
};

template <class Lanes>
void run_velocity(const Ground& ground, const Job& job, float* work) {
    Kernel<Lanes>(ground, job).find_velocity(work);
}

// A layer is at most 2²⁴ quanta thick, so many values add up in 32 bits, which is faster than in 64.
template <class Lanes>
std::int64_t quanta(const float* first, std::ptrdiff_t stride, int width, int height) {
    using Whole = stdx::rebind_simd_t<std::int32_t, Lanes>;
    constexpr int kTogether = 64;
    std::int64_t sum = 0;
    Whole part = 0;
    int added = 0;
    const auto take_part = [&] {
        for (int lane = 0; lane < kLanes<Lanes>; ++lane) sum += part[lane];
        part = 0, added = 0;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; x += kLanes<Lanes>) {
            const float* row = first + y * stride;
            __builtin_prefetch(row + 2 * stride + x);  // too short a row for the hardware prefetcher
            const Lanes metres = only_before(width, at<Lanes>(row, x), x);
            part += stdx::static_simd_cast<Whole>(metres * (1 / kQuantum));
            if (++added == kTogether) take_part();
        }
    take_part();
    return sum;
}

template <class Lanes>
Booked run(const Ground& ground, const Job& job, float* work, std::uint8_t* active) {
    Kernel<Lanes> kernel(ground, job);
    if (ground.model == Model::kVoellmy)
        return ground.has_things ? kernel.template momentum<false, true>(work, active)
                                 : kernel.template momentum<false, false>(work, active);
    if (ground.model == Model::kBcreInertial)
        return ground.has_things ? kernel.template momentum<true, true>(work, active)
                                 : kernel.template momentum<true, false>(work, active);
    switch (ground.scheme) {
        case Scheme::kLaxFriedrichs:
            return kernel.template first_order<Scheme::kLaxFriedrichs>(work, active);
        case Scheme::kLocalLaxFriedrichs:
            return kernel.template first_order<Scheme::kLocalLaxFriedrichs>(work, active);
        case Scheme::kMuscl:
            break;
    }
    return kernel.second_order(work, active);
}

constexpr InstructionSet kSet = InstructionSet::COULOIR_SET;
using SetLanes = stdx::simd<float, stdx::simd_abi::deduce_t<float, float_lanes(kSet)>>;

template <>
const Kernels& kernels<kSet>() {
    static constexpr Kernels kKernels{run<SetLanes>, run_velocity<SetLanes>, quanta<SetLanes>};
    return kKernels;
}

}  // namespace sim::sweep
