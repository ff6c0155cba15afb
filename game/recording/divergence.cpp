#include "game/recording/divergence.h"

#include <algorithm>
#include <barrier>
#include <bit>
#include <cstring>
#include <thread>

#include "sim/named_fields.h"
#include "sim/world/command.h"

namespace game {
namespace {

using sim::Field, sim::NamedField;

// First and last vertices that are compared. A step leaves nothing meaningful in a state's halo, but a
// stage's fields have faces there.
struct Vertices {
    int x0, x1, y0, y1;
};
Vertices inside(const Field<float>& field) {
    return {0, field.nx(), 0, field.ny()};
}
Vertices with_halo(const Field<float>& field) {
    return {-1, field.nx() + 1, -1, field.ny() + 1};
}

bool same_row(const Field<float>& a, const Field<float>& b, const Vertices& range, int y) {
    return std::memcmp(a.row(y) + range.x0, b.row(y) + range.x0,
                       sizeof(float) * static_cast<std::size_t>(range.x1 - range.x0)) == 0;
}

std::optional<FieldDifference> difference(const std::string& name, const Field<float>& a,
                                          const Field<float>& b, const Vertices& range) {
    FieldDifference found;
    for (int y = range.y0; y < range.y1; ++y) {
        if (same_row(a, b, range, y)) continue;
        for (int x = range.x0; x < range.x1; ++x) {
            const float one = a(x, y), other = b(x, y);
            const auto bits = std::bit_cast<std::uint32_t>(one),
                       other_bits = std::bit_cast<std::uint32_t>(other);
            if (bits == other_bits) continue;
            if (found.count++ > 0) continue;
            found.field = name, found.x = x, found.y = y;
            found.values = {FieldDifference::Value{bits, one}, FieldDifference::Value{other_bits, other}};
            found.ulps = ulps_between(one, other);
        }
    }
    if (found.count == 0) return std::nullopt;
    return found;
}

template <class RangeOf>
void add_differences(const std::vector<NamedField>& a, const std::vector<NamedField>& b, const RangeOf& range,
                     std::vector<FieldDifference>& found) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()) && a[i].name == b[i].name; ++i)
        if (auto different = difference(a[i].name, *a[i].values, *b[i].values, range(*a[i].values)))
            found.push_back(std::move(*different));
}

// The fields of two states. If only one world has things, the other one is dry.
struct BothFields {
    BothFields(const sim::State& a, const sim::State& b) : one(sim::fields_of(a)), other(sim::fields_of(b)) {
        if (a.things.has_value() == b.things.has_value()) return;
        dry = Field<float>(a.grid);
        (a.things ? other : one).push_back({"water", &dry});
    }
    Field<float> dry;
    std::vector<NamedField> one, other;
};

std::vector<FieldDifference> differences(const sim::State& a, const sim::State& b) {
    std::vector<FieldDifference> found;
    const BothFields fields(a, b);
    add_differences(fields.one, fields.other, inside, found);
    return found;
}

bool same_rest(const sim::State& a, const sim::State& b) {
    return a.running_commands == b.running_commands && a.ledger == b.ledger &&
           a.mixture.has_value() == b.mixture.has_value() &&
           (!a.mixture || a.mixture->ledger == b.mixture->ledger);
}

std::vector<std::uint8_t> cells_that_differ(const sim::State& a, const sim::State& b) {
    const BothFields both(a, b);
    const auto &fields = both.one, &others = both.other;
    std::vector<std::uint8_t> cells(a.grid.size());
    for (std::size_t i = 0; i < std::min(fields.size(), others.size()); ++i) {
        std::size_t cell = 0;
        for (int y = 0; y < a.grid.ny; ++y)
            for (int x = 0; x < a.grid.nx; ++x, ++cell)
                if (std::bit_cast<std::uint32_t>((*fields[i].values)(x, y)) !=
                    std::bit_cast<std::uint32_t>((*others[i].values)(x, y)))
                    cells[cell] = 1;
    }
    return cells;
}

Side plainly(Side side) {
    side.options.plain = true;
    return side;
}

bool same_stages(const sim::State& a, const sim::State& b) {
    return a.params.model == b.params.model && a.params.scheme == b.params.scheme &&
           a.mixture.has_value() == b.mixture.has_value() &&
           sim::substeps_of(a).count == sim::substeps_of(b).count;
}

}  // namespace

std::uint64_t ulps_between(float a, float b) {
    // Ordered by value, from -NaN to NaN; minus zero is below zero.
    const auto place = [](float value) {
        const auto bits = std::int64_t{std::bit_cast<std::int32_t>(value)};
        return bits >= 0 ? bits : -(bits & 0x7fffffff) - 1;
    };
    const std::int64_t apart = place(a) - place(b);
    return static_cast<std::uint64_t>(apart < 0 ? -apart : apart);
}

Run::Run(const Side& side)
    : side_(side),
      state_(sim::make_state(initial_state_of(side.scenario), side.scenario.params)),
      engine_(state_, side.options) {
    if (!side_.tamper || !engine_.scratch) return;
    engine_.watch.look = [this](int substep, int number, std::string_view stage) {
        side_.tamper({state_.tick, substep, number, stage, state_, &*engine_.scratch});
    };
}

Outcome<void> Run::advance() {
    const std::int64_t tick = state_.tick;
    auto advanced = advance_world(state_, due(), engine_);
    if (advanced && side_.tamper && engine_.sweeper) side_.tamper({tick, 0, 0, "sweep", state_, nullptr});
    return advanced;
}

// Does one tick of two runs by the plain step, each in its own thread,
// and compares the results whenever both have finished a stage.
class StageByStage {
  public:
    StageByStage(const Side& a, const sim::Snapshot& before_a, const Side& b, const sim::Snapshot& before_b)
        : a_(plainly(a)), b_(plainly(b)) {
        sim::restore(before_a, a_.state_);
        sim::restore(before_b, b_.state_);
    }

    bool possible() {
        // A tick's number of sub-steps depends on the parameters that its commands set.
        sim::State with_a = a_.state_, with_b = b_.state_;
        sim::apply_commands(with_a, a_.due());
        sim::apply_commands(with_b, b_.due());
        return same_stages(with_a, with_b);
    }

    // The first stage after which they differ; only the fields known at that stage are set.
    std::optional<Divergence> find() {
        std::optional<Divergence> found;
        struct Place {
            int substep = 0, number = 0;
            std::string_view stage;
        } place;
        const auto compare = [&]() noexcept {
            if (found) return;
            auto fields = differences_now();
            if (fields.empty() && a_.state_.running_commands == b_.state_.running_commands) return;
            found.emplace();
            found->substep = place.substep, found->stage = place.number;
            found->name = place.stage;
            found->fields = std::move(fields);
        };
        std::barrier meet(2, compare);
        const auto watch = [&](Run& run, bool keeps_place) {
            run.engine_.watch.look = [&, keeps_place, tamper = run.engine_.watch.look](
                                         int substep, int number, std::string_view stage) {
                if (tamper) tamper(substep, number, stage);
                if (keeps_place) place = {substep, number, stage};
                meet.arrive_and_wait();
            };
        };
        watch(a_, true), watch(b_, false);
        // Both have done this tick before, so its commands are fit for it.
        Outcome<void> first, second;
        std::thread other([&] { second = b_.advance(); });
        first = a_.advance();
        other.join();
        CHECK(first && second);
        return found;
    }

    const sim::State& result() const { return a_.state_; }
    int substeps() const { return sim::substeps_of(a_.state_).count; }

  private:
    std::vector<FieldDifference> differences_now() {
        std::vector<FieldDifference> found;
        add_differences(sim::fields_of(*a_.engine_.scratch), sim::fields_of(*b_.engine_.scratch), with_halo,
                        found);
        const BothFields fields(a_.state_, b_.state_);
        add_differences(fields.one, fields.other, inside, found);
        return found;
    }

    Run a_, b_;
};

namespace {

// Finds why the last tick ended differently for `a` and `b`.
Divergence located(const Side& first, const sim::Snapshot& before_a, const sim::State& a, const Side& second,
                   const sim::Snapshot& before_b, const sim::State& b) {
    Divergence parted;
    StageByStage stages(first, before_a, second, before_b);
    const bool possible = stages.possible();
    if (auto found = possible ? stages.find() : std::nullopt) {
        parted = std::move(*found);
    } else {
        parted.fields = differences(a, b);
        const bool swept[] = {!first.options.plain && !a.mixture, !second.options.plain && !b.mixture};
        parted.where = !possible              ? Divergence::Where::kElse
                       : swept[0] || swept[1] ? Divergence::Where::kSweep
                                              : Divergence::Where::kLost;
        const auto leaves = [&](const sim::State& state) {
            return !differences(stages.result(), state).empty() || !same_rest(stages.result(), state);
        };
        if (parted.where == Divergence::Where::kSweep && leaves(a) != leaves(b))
            parted.wrong_side = leaves(a) ? 0 : 1;
    }
    parted.substeps = stages.substeps();
    parted.tick = before_a.tick;
    return parted;
}

Divergence refused(const Run& run, int side, const Failure& failure) {
    Divergence parted;
    parted.where = Divergence::Where::kRefused;
    parted.tick = run.state().tick;
    parted.wrong_side = side;
    parted.name = failure.sentence;
    parted.cells.resize(run.state().grid.size());
    return parted;
}

void place_in_tiles(const sim::State& state, Divergence& parted) {
    parted.tile_width = state.tiles.width, parted.tile_height = state.tiles.height;
    if (parted.fields.empty()) return;
    const FieldDifference& first = parted.fields.front();
    parted.tile_x = std::clamp(first.x, 0, state.grid.nx - 1) / parted.tile_width;
    parted.tile_y = std::clamp(first.y, 0, state.grid.ny - 1) / parted.tile_height;
}

}  // namespace

LockstepRun::LockstepRun(const Side& first, const Side& second)
    : first_(first), second_side_(second), second_(second) {
    CHECK(first.scenario.grid == second.scenario.grid);
}
LockstepRun::~LockstepRun() = default;

std::optional<Divergence> LockstepRun::follow(const sim::State& first) {
    const bool begins = first.tick == second_.state().tick;
    if (!begins)
        if (const auto advanced = second_.advance(); !advanced) return refused(second_, 1, advanced.error());
    const sim::State& second = second_.state();
    CHECK(first.tick == second.tick);

    std::optional<Divergence> parted;
    if (auto fields = differences(first, second); !fields.empty() || !same_rest(first, second)) {
        if (begins) {
            parted.emplace();
            parted->where = Divergence::Where::kStart;
            parted->fields = std::move(fields);
        } else {
            parted = located(first_, before_first_, first, second_side_, before_second_, second);
        }
        parted->cells = cells_that_differ(first, second);
        place_in_tiles(first, *parted);
        return parted;
    }
    before_first_ = sim::take_snapshot(first);
    before_second_ = sim::take_snapshot(second);
    return std::nullopt;
}

std::optional<Divergence> first_divergence(const Side& a, const Side& b, std::int64_t ticks,
                                           const std::function<void(std::int64_t)>& after_tick) {
    Run first(a);
    LockstepRun lockstep(a, b);
    for (;;) {
        if (auto parted = lockstep.follow(first.state()); parted || first.state().tick >= ticks)
            return parted;
        if (const auto advanced = first.advance(); !advanced) return refused(first, 0, advanced.error());
        if (after_tick) after_tick(first.state().tick);
    }
}

}  // namespace game
