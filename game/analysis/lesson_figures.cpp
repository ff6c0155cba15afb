#include "game/analysis/lesson_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "game/analysis/measures.h"
#include "game/base/limits.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr double kKmPerHour = 3.6;

// Takes parts of a text as long as there is room.
class RoomForText {
  public:
    explicit RoomForText(std::span<char> text) : left_(text) {}
    void add(std::string_view part) {
        part = part.substr(0, left_.size() - 1);
        std::ranges::copy(part, left_.begin());
        left_ = left_.subspan(part.size());
        left_.front() = 0;
    }

  private:
    std::span<char> left_;
};

// 160,453
std::string_view with_commas(std::span<char, 32> text, double value) {
    std::array<char, 24> digits;
    const auto end = fmt::format_to_n(digits.data(), digits.size(), "{:.0f}", std::max(value, 0.0)).out;
    const auto count = end - digits.data();
    std::size_t size = 0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        if (i > 0 && (count - i) % 3 == 0) text[size++] = ',';
        text[size++] = digits[static_cast<std::size_t>(i)];
    }
    return {text.data(), size};
}

void add_figure(RoomForText& to, LessonFigure figure, const LessonFigures& of) {
    std::array<char, 64> text;
    const auto add = [&](fmt::string_view format, auto... values) {
        const auto end =
            fmt::vformat_to_n(text.data(), text.size(), format, fmt::make_format_args(values...)).out;
        to.add({text.data(), static_cast<std::size_t>(end - text.data())});
    };
    switch (figure) {
        case LessonFigure::kSpeed:
            return add("{:.0f} m/s ({:.0f} km/h)", of.speed, kKmPerHour * of.speed);
        case LessonFigure::kVolume: {
            std::array<char, 32> digits;
            to.add(with_commas(digits, of.volume));
            return to.add(" m3");
        }
        case LessonFigure::kRunOut:
            return add("{:.0f} m", of.run_out);
        case LessonFigure::kDrop:
            return add("{:.0f} m", of.drop);
        case LessonFigure::kReach:
            return add("{:.1f}°", of.reach_deg);
        case LessonFigure::kPressure:
            return of.pressure ? add("{:.0f} kPa", *of.pressure) : to.add(tr("a pressure that is not known"));
    }
}

}  // namespace

LessonFigures lesson_figures(const Scenario& scenario, const Session& session,
                             std::span<const TimedCommand> commands) {
    const Measures measures = measure(scenario, session, release_area(scenario, commands), {});
    LessonFigures figures{.speed = measures.peak_speed_slope,
                          .volume = measures.eroded,
                          .run_out = measures.run_out,
                          .drop = measures.fall,
                          .reach_deg = measures.reach_deg,
                          .pressure = measures.peak_pressure,
                          .toe = {}};
    if (measures.run_out > 0) figures.toe.emplace(measures.toe.x, measures.toe.y);
    return figures;
}

const char* write_filled(std::span<char> text, std::string_view from, const LessonFigures& figures) {
    RoomForText to(text);
    to.add("");
    each_part_of(
        from, [&](std::string_view words) { to.add(words); },
        [&](LessonFigure figure) { add_figure(to, figure, figures); });
    return text.data();
}

std::string with_figures(std::string_view text, const LessonFigures& figures) {
    std::array<char, 2048> room;
    static_assert(room.size() > 2 * kMostLessonText);
    return write_filled(room, text, figures);
}

}  // namespace game
