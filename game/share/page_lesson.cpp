#include "game/share/page_lesson.h"

#include <string>

#include "game/analysis/lesson_figures.h"
#include "game/pages/table.h"

namespace game {

PageLesson::PageLesson(const Lesson& lesson, double tick_s, std::span<const TimedCommand> commands)
    : lesson_(&lesson), ticks_(ticks_of(lesson, tick_s)), commands_(commands) {
    json_ = {{"title", lesson.title}, {"stops", Json::array()}};
}

void PageLesson::see(const Scenario& scenario, const Session& session) {
    if (next_ == ticks_.size() || session.state().tick != ticks_[next_]) return;
    const Lesson::Stop& stop = lesson_->stops[next_++];
    const LessonFigures figures = lesson_figures(scenario, session, commands_);
    const auto text = [&](const std::string& from) { return with_signs(with_figures(from, figures)); };
    Json json{{"tick", session.state().tick},
              {"heading", stop.heading},
              {"text", text(stop.text)},
              {"guess", stop.asks_guess},
              {"last", next_ == ticks_.size()}};
    if (stop.camera)
        json["camera"] = {{"place", {stop.camera->east, stop.camera->north}},
                          {"azimuth", stop.camera->azimuth_deg},
                          {"elevation", stop.camera->elevation_deg},
                          {"distance", stop.camera->distance_m}};
    if (const auto& question = stop.question)
        json["question"] = {{"asks", text(question->asks)},
                            {"answers", question->answers},
                            {"right", question->right},
                            {"why", text(question->why)}};
    if (next_ == ticks_.size() && figures.toe) json["toe"] = {figures.toe->x, figures.toe->y};
    json_["stops"].push_back(std::move(json));
}

}  // namespace game
