#include "sim/state_hash.h"

#define XXH_STATIC_LINKING_ONLY  // for a digest on the stack
#include <xxhash.h>

#include <bit>

#include "sim/state.h"

namespace sim {
namespace {

class Digest {
  public:
    Digest() { XXH3_64bits_reset(&state_); }
    template <class T>
    void add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T>, "padding would be hashed");
        XXH3_64bits_update(&state_, &value, sizeof value);
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const Field<float>& field) {
        for (int y = 0; y < field.ny(); ++y)
            XXH3_64bits_update(&state_, field.row(y), sizeof(float) * static_cast<std::size_t>(field.nx()));
    }
    std::uint64_t value() const { return XXH3_64bits_digest(&state_); }

  private:
    XXH3_state_t state_;
};

}  // namespace

std::uint64_t state_hash(const State& state) {
    Digest digest;
    for (const Field<float>* field :
         {&state.bedrock, &state.depth, &state.rolling, &state.velocity_x, &state.velocity_y})
        digest.add(*field);
    if (const auto& m = state.mixture)
        for (const Field<float>* field : {&m->rolling, &m->settled, &m->untouched}) digest.add(*field);
    digest.add(state.tick);
    for (const Source& source : state.sources) {
        const Command& c = source.command;
        digest.add(c.kind);
        for (const double number : {c.x, c.y, c.radius, c.rate, c.duration, c.depth}) digest.add(number);
        digest.add(c.layer);
        digest.add(c.profile);
        if (c.of != Part::kUpper) digest.add(c.of);
        digest.add(source.first_tick);
    }
    digest.add(state.seed);
    return digest.value();
}

}  // namespace sim
