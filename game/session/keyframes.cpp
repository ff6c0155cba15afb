#include "game/session/keyframes.h"

#include <algorithm>
#include <utility>

#include "sim/core/check.h"

namespace game {
namespace {

bool is_after(std::int64_t tick, const Session::Checkpoint& moment) {
    return tick < moment.world.tick;
}

template <class T, class Allocator>
std::size_t bytes_of(const std::vector<T, Allocator>& values) {
    return values.capacity() * sizeof(T);
}

// With its halo and the padding of its rows.
template <class T>
std::size_t bytes_of(const sim::Field<T>& field) {
    return static_cast<std::size_t>(field.stride()) * static_cast<std::size_t>(field.ny() + 2) * sizeof(T);
}

template <class... Parts>
std::size_t bytes_of_all(const Parts&... parts) {
    return (... + bytes_of(parts));
}

std::size_t bytes_of(const std::vector<Session::Checkpoint>& moments) {
    std::size_t bytes = 0;
    for (const Session::Checkpoint& moment : moments) bytes += game::bytes_of(moment);
    return bytes;
}

}  // namespace

std::size_t bytes_of(const Session::Checkpoint& moment) {
    const sim::Snapshot& w = moment.world;
    std::size_t bytes = sizeof(moment) +
                        bytes_of_all(w.depth, w.rolling, w.velocity_x, w.velocity_y, w.first_depth,
                                     w.smooth_depth, w.running_commands) +
                        bytes_of_all(moment.peaks.depth, moment.peaks.speed_plan, moment.peaks.speed_slope,
                                     moment.peaks.pressure, moment.peaks.arrival, moment.powder,
                                     moment.carried, moment.line.before);
    if (w.mixture) bytes += bytes_of_all(w.mixture->rolling, w.mixture->settled, w.mixture->untouched);
    if (w.things)
        bytes += bytes_of_all(w.things->earth, w.things->first_slope, w.things->forest, w.things->water,
                              w.things->list);
    if (w.weather)
        bytes += bytes_of_all(w.weather->base, w.weather->strength, w.weather->water, w.weather->surface,
                              w.weather->undisturbed, w.weather->program);
    if (const auto& t = moment.textures)
        bytes += bytes_of_all(t->offset, t->mix, t->deformation, t->moving, t->beside, t->gradient);
    return bytes;
}

void Keyframes::pass(const Session& session) {
    const std::int64_t tick = session.state().tick;
    // Ticks before the last keyframe were kept already, or were dropped on purpose.
    if (tick % spacing_ != 0 || (!moments_.empty() && moments_.back().world.tick >= tick)) return;
    Session::Checkpoint moment = session.moment();
    const std::size_t bytes = bytes_of(moment);
    while (moments_.size() > 1 && bytes_ + bytes > most_) {
        thin_out();
        if (tick % spacing_ != 0) return;
    }
    moments_.push_back(std::move(moment));
    bytes_ += bytes;
}

void Keyframes::thin_out() {
    spacing_ *= 2;
    std::erase_if(moments_, [this](const auto& moment) { return moment.world.tick % spacing_ != 0; });
    bytes_ = bytes_of(moments_);
}

const Session::Checkpoint& Keyframes::before(std::int64_t tick) const {
    const auto after = std::upper_bound(moments_.begin(), moments_.end(), tick, is_after);
    CHECK(after != moments_.begin());
    return *(after - 1);
}

void Keyframes::forget_after(std::int64_t tick) {
    moments_.erase(std::upper_bound(moments_.begin(), moments_.end(), tick, is_after), moments_.end());
    bytes_ = bytes_of(moments_);
}

}  // namespace game
