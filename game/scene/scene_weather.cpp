#include "game/scene/scene_weather.h"

#include <optional>

#include <fmt/format.h>

#include "game/scene/date.h"
#include "game/scene/scene_commands.h"
#include "sim/world/weather.h"

namespace game {
namespace {

// Reads the events of the program, in the order of the manifest and then of the file.
std::vector<sim::Command> read_program(TomlTable& table, const sim::Weather& weather) {
    std::vector<sim::Command> program;
    for (const sim::CommandKind kind :
         {sim::CommandKind::kStorm, sim::CommandKind::kWind, sim::CommandKind::kTemperature})
        for (TomlTable& event : table.tables(sim::info_of(kind).name)) {
            program.push_back(read_command(event, sim::info_of(kind), false));
            std::optional<std::string> wrong = sim::fault_of(program.back());
            if (!wrong)
                if (const auto fault = sim::fault_of_weather(&weather, program)) wrong = fault->fact;
            if (!wrong) continue;
            event.blame("", *wrong);
            return program;
        }
    if (program.size() > sim::kMostCommandsPerTick)
        table.blame("", fmt::format("has {} events; at most {} are allowed", program.size(),
                                    sim::kMostCommandsPerTick));
    return program;
}

}  // namespace

sim::Calendar read_weather(TomlTable& table, const Scenario& scenario, std::vector<TimedCommand>& commands) {
    sim::Calendar calendar;
    if (const auto days = table.whole("days", 1, 366))
        calendar.hours = 24 * static_cast<double>(*days);
    else
        table.blame("", "needs a number of days");
    if (const auto text = table.text("date")) {
        const auto date = date_from(*text);
        if (!date) table.blame("date", "is no day of a year; write month and day, such as \"12-01\"");
        if (date) calendar.first_day = render::day_of_year(*date) - 1;
    }
    for (const sim::CalendarNumber& number : sim::kCalendarNumbers) {
        if (number.value == &sim::Calendar::hours || number.value == &sim::Calendar::first_day) continue;
        if (const auto value = table.number(number.name, number.least, number.most))
            calendar.*number.value = *value;
    }
    if (const auto wrong = sim::fault_of(calendar, scenario.params, scenario.density.value_or(0),
                                         scenario.lower.has_value())) {
        table.blame("", *wrong);
        return calendar;
    }
    const std::vector<sim::Command> program =
        read_program(table, sim::Weather(calendar, sim::Field<float>()));
    std::vector<TimedCommand> first;
    first.reserve(program.size());
    for (const sim::Command& command : program) first.push_back({0, command});
    commands.insert(commands.begin(), first.begin(), first.end());
    table.finish();
    return calendar;
}

void place_weather(TomlTable& table, Scenario& scenario) {
    sim::Calendar& calendar = *scenario.weather;
    if (!table.has("reference")) calendar.reference = scenario.datum;
    const sim::Grid& grid = scenario.grid;
    const terrains::LocalPoint middle{0.5 * static_cast<double>(grid.nx - 1) * static_cast<double>(grid.dx),
                                      0.5 * static_cast<double>(grid.ny - 1) * static_cast<double>(grid.dx)};
    const auto place = scenario.georeference.to_lat_lon(middle);
    if (!table.has("latitude") && place) calendar.latitude = place->latitude;
    if (const auto wrong = sim::fault_of(calendar, scenario.params, scenario.density.value_or(0),
                                         scenario.lower.has_value()))
        table.blame("", *wrong);
}

}  // namespace game
