#include "game/app/lesson_run.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace game {

LessonRun::LessonRun(const Lesson& lesson, double tick_s)
    : lesson_(&lesson), ticks_(ticks_of(lesson, tick_s)), answers_(lesson.stops.size()) {}

std::int64_t LessonRun::ticks_to_stop(std::int64_t tick) const {
    for (std::size_t i = 0; i < ticks_.size(); ++i)
        if (ticks_[i] > tick || (ticks_[i] == tick && passed_ != i && open_ != i)) return ticks_[i] - tick;
    return std::numeric_limits<std::int64_t>::max();
}

bool LessonRun::see(std::int64_t tick) {
    const auto stop = std::ranges::find(ticks_, tick);
    if (stop == ticks_.end()) {
        passed_.reset();
        return false;
    }
    const auto index = static_cast<std::size_t>(stop - ticks_.begin());
    if (passed_ == index) return false;
    open_ = index;
    return true;
}

void LessonRun::take(const LessonFigures& figures) {
    figures_ = figures;
    measured_ = open_;
}

std::optional<std::int64_t> LessonRun::go_on() {
    if (!open_) return std::nullopt;
    passed_ = std::exchange(open_, std::nullopt);
    measured_.reset();
    return ticks_[*passed_];
}

void LessonRun::answer(std::size_t answer) {
    if (open_ && !answers_[*open_]) answers_[*open_] = answer;
}

std::optional<glm::dvec2> LessonRun::toe() const {
    return is_last() ? figures_.toe : std::nullopt;
}

std::optional<ui::LessonNote> LessonRun::note() const {
    if (!open_) return std::nullopt;
    const bool asked = std::ranges::any_of(lesson_->stops, &Lesson::Stop::asks_guess);
    ui::LessonNote note{.title = lesson_->title.c_str(),
                        .stop = lesson_->stops[*open_],
                        .figures = figures_,
                        .number = *open_ + 1,
                        .stops = ticks_.size(),
                        .answer = answers_[*open_],
                        .has_guess = guess_.has_value(),
                        .tells_guess = is_last() && asked};
    if (note.tells_guess && guess_ && figures_.toe) note.guess_off = glm::distance(*guess_, *figures_.toe);
    return note;
}

}  // namespace game
