#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "game/scene/lesson.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"

namespace game {

// What a slide has come to by the time of a stop, as Measures has it.
struct LessonFigures {
    double speed = 0;                // m/s along the slope, the largest
    double volume = 0;               // m³ swept along
    double run_out = 0, drop = 0;    // m
    double reach_deg = 0;            // °
    std::optional<double> pressure;  // kPa, the largest; nothing if a density is unknown
    std::optional<glm::dvec2> toe;   // m, the run-out point; nothing: nothing ran
};
LessonFigures lesson_figures(const Scenario& scenario, const Session& session,
                             std::span<const TimedCommand> commands);

// A text of a lesson with its figures, in the language of the window: "38 m/s (137 km/h)". Writes into `text`, cut to fit, and returns it.
// A volume is written as "160,453 m3".
const char* write_filled(std::span<char> text, std::string_view from, const LessonFigures& figures);
std::string with_figures(std::string_view text, const LessonFigures& figures);

}  // namespace game
