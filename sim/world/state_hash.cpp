#include "sim/world/state_hash.h"

#if defined(__x86_64__)
#include <xxh_x86dispatch.h>  // the lanes of the machine that it runs on
#endif
#define XXH_STATIC_LINKING_ONLY  // for a digest on the stack
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>
#include <span>
#include <utility>

#include "sim/core/workers.h"
#include "sim/world/state.h"

namespace sim {
namespace {

// Of the hash, not of the work: the same whatever tiles a step goes by.
constexpr int kBlockWidth = 64, kBlockHeight = 32;

struct Blocks {
    explicit Blocks(const Grid& of)
        : grid(of),
          columns((of.nx + kBlockWidth - 1) / kBlockWidth),
          rows((of.ny + kBlockHeight - 1) / kBlockHeight) {}
    const Grid& grid;
    int columns, rows;
    // Where a block stands in what follows.
    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    std::size_t count() const { return number(0, rows); }
};

// The vertices of a block, field after field.
std::uint64_t block_hash(const Blocks& blocks, std::size_t block,
                         std::initializer_list<const Field<float>*> fields) {
    constexpr int kMostFields = 9;
    CHECK(fields.size() <= kMostFields);
    float values[kMostFields * kBlockWidth * kBlockHeight];
    const auto columns = static_cast<std::size_t>(blocks.columns);
    const int x0 = static_cast<int>(block % columns) * kBlockWidth,
              x1 = std::min(x0 + kBlockWidth, blocks.grid.nx);
    const int y0 = static_cast<int>(block / columns) * kBlockHeight,
              y1 = std::min(y0 + kBlockHeight, blocks.grid.ny);
    float* end = values;
    for (const Field<float>* field : fields)
        for (int y = y0; y < y1; ++y) end = std::copy(field->row(y) + x0, field->row(y) + x1, end);
    return XXH3_64bits(values, sizeof(float) * static_cast<std::size_t>(end - values));
}

std::uint64_t moving_hash(const State& s, const Blocks& blocks, std::size_t block) {
    if (const auto& m = s.mixture)
        return block_hash(
            blocks, block,
            {&s.depth, &s.rolling, &s.velocity_x, &s.velocity_y, &m->rolling, &m->settled, &m->untouched});
    if (const auto& w = s.weather)
        return block_hash(blocks, block,
                          {&s.depth, &s.rolling, &s.velocity_x, &s.velocity_y, &w->base, &w->strength,
                           &w->water, &w->surface, &w->undisturbed});
    return block_hash(blocks, block, {&s.depth, &s.rolling, &s.velocity_x, &s.velocity_y});
}

class Digest {
  public:
    Digest() { XXH3_64bits_reset(&state_); }
    template <class T>
    void add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T>, "padding would be hashed");
        XXH3_64bits_update(&state_, &value, sizeof value);
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    template <class T>
    void add(std::span<const T> values) {
        XXH3_64bits_update(&state_, values.data(), values.size_bytes());
    }
    std::uint64_t value() const { return XXH3_64bits_digest(&state_); }

  private:
    XXH3_state_t state_;
};

// All members that the command's kind uses. Every kind hashes the members of the first physics version, used or
// not; any other member only the kinds that use it, as kCommands says. So a new member or kind changes no hash
// of an older command.
void add_command(Digest& digest, const Command& c) {
    constexpr std::array kAlways{&Command::x,    &Command::y,        &Command::radius,
                                 &Command::rate, &Command::duration, &Command::depth};
    const CommandInfo& info = info_of(c.kind);
    digest.add(c.kind);
    for (const auto member : kAlways) digest.add(c.*member);
    digest.add(c.layer);
    digest.add(c.profile);
    // Younger than the first physics version.
    if (c.of != Part::kUpper) digest.add(c.of);
    if (c.least_slope != Command::kNoLeast || c.most_slope != Command::kNoMost) {
        digest.add(c.least_slope);
        digest.add(c.most_slope);
    }
    for (const CommandNumber& number : info.numbers)
        if (std::find(kAlways.begin(), kAlways.end(), number.value) == kAlways.end())
            digest.add(c.*number.value);
    if (info.has_param) digest.add(static_cast<std::uint64_t>(c.param));
}

// Of the hashes of all blocks, row by row: hash(i) is that of block i.
template <class Hash>
std::uint64_t hash_of_blocks(const Blocks& blocks, const Hash& hash) {
    Digest digest;
    for (std::size_t i = 0; i < blocks.count(); ++i) digest.add(hash(i));
    return digest.value();
}

std::uint64_t bedrock_hash(const State& s, const Blocks& blocks) {
    return hash_of_blocks(blocks, [&](std::size_t i) { return block_hash(blocks, i, {&s.bedrock}); });
}

// The fields of things, which change only by commands and where something breaks; none if nothing is there.
std::optional<std::uint64_t> fields_hash(const Things& t) {
    if (t.empty()) return std::nullopt;
    Digest digest;
    for (int y = 0; y < t.earth.ny(); ++y) {
        digest.add(std::span(t.earth.row(y), static_cast<std::size_t>(t.earth.nx())));
        digest.add(std::span(t.forest.row(y), static_cast<std::size_t>(t.earth.nx())));
    }
    if (!t.dry())  // younger than the hashes of worlds with things
        for (int y = 0; y < t.water.ny(); ++y)
            digest.add(std::span(t.water.row(y), static_cast<std::size_t>(t.water.nx())));
    return digest.value();
}

void add_things(Digest& digest, const Things& t, std::uint64_t fields) {
    digest.add(fields);
    digest.add(t.budget);
    for (const Thing& thing : t.list) {
        digest.add(thing.kind);
        for (const double number : {thing.x, thing.y, thing.to_x, thing.to_y, thing.front_x, thing.front_y,
                                    thing.length, thing.width, thing.height, thing.strength})
            digest.add(number);
        for (const std::int64_t number : {thing.group, thing.load, thing.buried}) digest.add(number);
    }
}

void add_weather(Digest& digest, const Weather& w) {
    digest.add(w.hours);
    for (const WeatherEvent& event : w.program) {
        add_command(digest, event.command);
        digest.add(event.until);
    }
    for (const std::int64_t number : {std::int64_t{w.anchored}, w.stirred, w.greatest_motion})
        digest.add(number);
}

std::uint64_t whole_hash(const State& s, std::uint64_t bedrock, std::uint64_t moving,
                         std::optional<std::uint64_t> things) {
    Digest digest;
    digest.add(bedrock);
    digest.add(moving);
    digest.add(s.tick);
    for (const RunningCommand& source : s.running_commands) {
        add_command(digest, source.command);
        digest.add(source.first_tick);
    }
    digest.add(std::uint64_t{0});  // of no meaning: without it every hash that was ever recorded would change
    if (things) add_things(digest, *s.things, *things);
    if (s.weather) add_weather(digest, *s.weather);
    return digest.value();
}

// Blocks under what a tile covers.
void mark(const Tiles& tiles, int column, int row, const Blocks& blocks, std::vector<std::uint8_t>& stale) {
    const int x0 = column * tiles.width, x1 = std::min(x0 + tiles.width, blocks.grid.nx) - 1;
    const int y0 = row * tiles.height, y1 = std::min(y0 + tiles.height, blocks.grid.ny) - 1;
    for (int y = y0 / kBlockHeight; y <= y1 / kBlockHeight; ++y)
        for (int x = x0 / kBlockWidth; x <= x1 / kBlockWidth; ++x) stale[blocks.number(x, y)] = 1;
}

}  // namespace

std::uint64_t state_hash(const State& state) {
    const Blocks blocks(state.grid);
    const auto moving = [&](std::size_t i) { return moving_hash(state, blocks, i); };
    return whole_hash(state, bedrock_hash(state, blocks), hash_of_blocks(blocks, moving),
                      state.things ? fields_hash(*state.things) : std::nullopt);
}

std::uint64_t update_state_hash(State& state, Workers& workers) {
    const Blocks blocks(state.grid);
    BlockHashes& known = state.block_hashes;
    if (known.moving.empty())
        known = {bedrock_hash(state, blocks), false, std::vector<std::uint64_t>(blocks.count()),
                 std::vector<std::uint8_t>(blocks.count(), 1)};
    if (std::exchange(known.bedrock_is_stale, false)) known.bedrock = bedrock_hash(state, blocks);
    if (state.things && std::exchange(state.things->unhashed, false))
        state.things->hash = fields_hash(*state.things);
    Tiles& tiles = state.tiles;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column)
            if (std::exchange(tiles.unhashed[tiles.number(column, row)], std::uint8_t{0}))
                mark(tiles, column, row, blocks, known.stale);
    workers.each_band(blocks.rows, [&](int first, int last) {
        for (std::size_t i = blocks.number(0, first); i < blocks.number(0, last); ++i)
            if (std::exchange(known.stale[i], std::uint8_t{0}))
                known.moving[i] = moving_hash(state, blocks, i);
    });
    return whole_hash(state, known.bedrock,
                      hash_of_blocks(blocks, [&](std::size_t i) { return known.moving[i]; }),
                      state.things ? state.things->hash : std::nullopt);
}

}  // namespace sim
