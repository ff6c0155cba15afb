#include "sim/world/weather.h"

#include <algorithm>
#include <cmath>

#include "sim/core/number_text.h"
#include "sim/world/params.h"

namespace sim {
namespace {

constexpr float kOldInterface = 2000, kBareSurface = 680;  // Pa

std::int64_t begin_of(const WeatherEvent& event) {
    return static_cast<std::int64_t>(event.command.at);
}

// mm/h of water that falls in an hour at the calendar's reference.
double precipitation(std::span<const WeatherEvent> program, std::int64_t hour) {
    double sum = 0;
    for (const WeatherEvent& event : program)
        if (hour >= begin_of(event) && hour < event.until)
            sum += event.command.precipitation / event.command.hours;
    return sum;
}

using Program = std::vector<WeatherEvent>;

std::optional<std::string> fault_of_event(const Weather& w, const Program& program, const Command& c) {
    const auto at = static_cast<std::int64_t>(c.at);
    if (at < w.hours) return "hour " + std::to_string(at) + " is over";
    if (c.at >= w.calendar.hours)
        return "hour " + std::to_string(at) + " is beyond the calendar of " +
               number_text(w.calendar.hours, "h");
    if (program.size() >= kMostWeatherEvents)
        return "there are " + std::to_string(kMostWeatherEvents) + " events already, which is the most";
    if (c.kind != CommandKind::kStorm) return std::nullopt;
    // The sum is greatest where one of them begins.
    const auto too_much = [&](std::int64_t hour) {
        return precipitation(program, hour) + c.precipitation / c.hours > kMostPrecipitation;
    };
    const std::int64_t until = at + static_cast<std::int64_t>(c.hours);
    std::optional<std::int64_t> hour = too_much(at) ? std::optional(at) : std::nullopt;
    for (const WeatherEvent& event : program) {
        const std::int64_t begins = begin_of(event);
        if (!hour && begins > at && begins < until && too_much(begins)) hour = begins;
    }
    if (!hour) return std::nullopt;
    return "over " + number_text(kMostPrecipitation, "mm") + " of water would fall in hour " +
           std::to_string(*hour);
}

std::optional<std::string> fault_of_cancel(const Weather& w, const Program& program, const Command& c) {
    const auto number = static_cast<std::size_t>(c.event);
    if (number > program.size())
        return "there is no event " + std::to_string(number) + ", of " + std::to_string(program.size());
    if (program[number - 1].until <= std::max(w.hours, begin_of(program[number - 1])))
        return "event " + std::to_string(number) + " is over";
    return std::nullopt;
}

void change(Program& program, std::int64_t hours, const Command& c) {
    if (c.kind == CommandKind::kCancel) {
        WeatherEvent& event = program[static_cast<std::size_t>(c.event) - 1];
        event.until = std::max(hours, begin_of(event));
    } else {
        program.push_back({c, static_cast<std::int64_t>(c.at + c.hours)});
    }
}

}  // namespace

std::optional<std::string> fault_of(const Calendar& calendar, const Params& params, double density,
                                    bool has_lower) {
    if (params.model != Model::kBcreInertial)
        return "weather needs model bcre-inertial: in " + std::string(to_string(params.model)) +
               (params.model == Model::kVoellmy ? " nothing is deposited" : " erosion knows no weak layer");
    if (has_lower) return "weather needs a world of one material";
    if (!(density >= kLeastSnowDensity))
        return "weather needs a material whose density is known and at least " +
               number_text(kLeastSnowDensity, "kg/m3");
    for (const CalendarNumber& number : kCalendarNumbers) {
        const double value = calendar.*number.value;
        if (!(value >= number.least && value <= number.most))  // NaN too
            return "weather's " + std::string(number.name) + " is " + number_text(value, number.unit) +
                   ", outside " + number_text(number.least) + " to " + number_text(number.most);
        if (number.whole && value != std::floor(value))
            return "weather's " + std::string(number.name) + " is " + number_text(value, number.unit) +
                   ", not a whole number";
    }
    return std::nullopt;
}

bool is_of_weather(const Command& c) {
    return c.kind >= CommandKind::kStorm && c.kind <= CommandKind::kCancel;
}

Weather::Weather(const Calendar& its_calendar, const Field<float>& depth)
    : calendar(its_calendar), base(depth), strength(depth), water(depth), surface(depth), undisturbed(depth) {
    strength.fill(kOldInterface);
    water.fill(0);
    surface.fill(kBareSurface);
}

void change_program(Weather& weather, const Command& command) {
    CHECK(!fault_of_weather(&weather, {&command, 1}));
    change(weather.program, weather.hours, command);
}

std::optional<WeatherFault> fault_of_weather(const Weather* weather, std::span<const Command> commands) {
    if (std::none_of(commands.begin(), commands.end(), is_of_weather)) return std::nullopt;
    const auto refused = [&](std::size_t i, const std::string& fact) {
        return WeatherFault{i, std::string(info_of(commands[i].kind).name) + ": " + fact};
    };
    Program after;
    if (weather) after = weather->program;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& c = commands[i];
        if (!is_of_weather(c)) continue;
        if (!weather) return refused(i, "this world has no weather");
        const auto fault = c.kind == CommandKind::kCancel ? fault_of_cancel(*weather, after, c)
                                                          : fault_of_event(*weather, after, c);
        if (fault) return refused(i, *fault);
        change(after, weather->hours, c);
    }
    return std::nullopt;
}

}  // namespace sim
