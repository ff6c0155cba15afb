#pragma once

#include <algorithm>
#include <cmath>

namespace sim {
class Workers;
struct State;
}  // namespace sim

namespace sim::weather {

struct Sky;
struct Work;

// Lets one hour of weather pass over a world in which nothing rolls: snow, rain, drift, melt, and what they do to the weak
// layers. Books what came and went; counts no mass.
void pass_hour(State& state, Work& work, Workers& workers);

// Carries snow along the wind, vertex by vertex from where it comes from. The gradient and the wind of `work` are those of
// the hour.
void drift(State& state, const Sky& sky, Work& work);

// Finds the gradient of the surface, of rows first … last-1.
void find_gradient(const State& state, Work& work, int first, int last);

inline constexpr float kDriftFrom = 7, kStrongestWind = 20;  // m/s near the ground

// m/s near the ground, at a height above the calendar's reference.
inline float wind_near_ground(float high_above, float factor, float height) {
    const float exposed = height <= 0 ? 0 : height >= 800 ? 1 : height / 800;
    const float wind = high_above * (0.5f + 0.5f * exposed) * factor;
    return wind < kStrongestWind ? wind : kStrongestWind;
}

// d of a vertex changes, m, and what it would be without slides with it. Fresh snow hides twice its depth of a difference.
inline void change_depth(float& d, float& undisturbed, float change) {
    const float slid = d - undisturbed, hidden = 2 * std::max(change, 0.f);
    d += change;
    undisturbed = std::max(d - std::copysign(std::max(std::abs(slid) - hidden, 0.f), slid), 0.f);
}

}  // namespace sim::weather
