#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/grid.h"
#include "sim/world/command.h"

// The weather of a world, hour by hour, and what it makes of the standing layer, which is snow then. Rules with equations
// and sources: docs/weather.md; they act in sim/weather.

namespace sim {

struct Params;

inline constexpr double kMostHours = 366 * 24;
inline constexpr std::size_t kMostWeatherEvents = 1000;
inline constexpr double kMostPrecipitation = 100;  // mm/h of water, of all storms of an hour, at `reference`
inline constexpr double kLeastSnowDensity = 50;    // kg/m³

// Constants of a world with weather. kCalendarNumbers has unit, range and meaning of each.
struct Calendar {
    double hours = 24 * 130;
    double first_day = 334;  // 1 December
    double latitude = 47;
    double reference = 0;
    double mean_temperature = 3.2;
    double seed = 1;
    bool operator==(const Calendar&) const = default;
};

// The manifest that generates the readers and writers of scenes and recordings.
struct CalendarNumber {
    std::string_view name, unit;
    double Calendar::*value;
    double least, most;
    bool whole;
    std::string_view meaning;
};
inline constexpr CalendarNumber kCalendarNumbers[] = {
    {"hours", "h", &Calendar::hours, 1, kMostHours, true, "its length; hour 0 begins at midnight"},
    {"first_day", "d", &Calendar::first_day, 0, 365, true, "day of the year of hour 0; 0 is 1 January"},
    {"latitude", "deg", &Calendar::latitude, -70, 70, false,
     "north positive; south of the equator winter is in July"},
    {"reference", "m", &Calendar::reference, -500, 9000, false,
     "height above the terrain's zero at which amounts and temperatures are those of the events"},
    {"mean_temperature", "degC", &Calendar::mean_temperature, -40, 40, false, "of a year, at the reference"},
    {"seed", "1", &Calendar::seed, 0, 4294967295.0, true, "of how weak layers vary from place to place"},
};

// What is wrong with weather in such a world, as a sentence; nothing if it can have it. `density`: kg/m³ of the material.
std::optional<std::string> fault_of(const Calendar& calendar, const Params& params, double density,
                                    bool has_lower);

// A storm, a wind or a change of temperature, in the hours `command.at` up to `until`.
struct WeatherEvent {
    Command command;
    std::int64_t until = 0;
    bool operator==(const WeatherEvent&) const = default;
};

struct Weather {
    // `depth`: the snow that lies at hour 0, without a weak layer.
    Weather(const Calendar& calendar, const Field<float>& depth);

    Calendar calendar;

    // State. One weak interface at each vertex, the one that matters; the slab is above it.
    std::int64_t hours = 0;             // done
    std::vector<WeatherEvent> program;  // in the order in which they were given; a cancelled one ends early
    Field<float> base;                  // B, m of d below the interface, whole quanta, 0 ≤ B
    Field<float> strength;  // τ, Pa, shear strength of the interface, dry; negative: it bonds slowly
    Field<float> water;     // W, mm of liquid water in the slab, a part of d
    Field<float> surface;   // σ, Pa, what the surface's strength will be once it is buried; negative: hours
                            // since snow came last, negated
    // m, at least 0: d without what slid, was poured or dug, as far as snow has not hidden it since. Views alone read it.
    Field<float> undisturbed;
    // Whether d₀, S₀ and the smoothed ground are those of d. Nothing starts of itself then.
    bool anchored = true;
    // Of the slide that runs: the tick of its release, or of the last command; its greatest motion since.
    std::int64_t stirred = 0, greatest_motion = 0;

    bool is_over() const { return static_cast<double>(hours) >= calendar.hours; }
};

// Whether a command is one of storm, wind, temperature or cancel.
bool is_of_weather(const Command& command);

// What a command of kind storm, wind, temperature or cancel does to the program.
void change_program(Weather& weather, const Command& command);

// What is wrong with the commands of weather in a world with this weather, or none; such as "storm: hour 12 is over". Nothing if
// each can be done, one after another. `command`: the first that cannot.
struct WeatherFault {
    std::size_t command = 0;
    std::string fact;
};
std::optional<WeatherFault> fault_of_weather(const Weather* weather, std::span<const Command> commands);

}  // namespace sim
