#include "tests/fuzz/try_reader.h"

#include "game/analysis/lesson_figures.h"
#include "game/base/limits.h"
#include "game/scene/lesson.h"

namespace game::test {
namespace {

Outcome<void> try_lesson(const std::filesystem::path& file) {
    const auto lesson = read_lesson(file);
    if (!lesson) return tl::unexpected(lesson.error());
    if (lesson->stops.size() < kFewestStops || lesson->stops.size() > kMostStops)
        return broken("a wrong number of stops");
    double before = -1;
    for (const Lesson::Stop& stop : lesson->stops) {
        if (!(stop.time_s > before)) return broken("stops out of order");
        before = stop.time_s;
        if (stop.text.empty() || stop.heading.empty()) return broken("a stop that says nothing");
        if (stop.question && stop.question->right >= stop.question->answers.size())
            return broken("a right answer that is none");
        if (with_figures(stop.text, {}).find('{') != std::string::npos)
            return broken("a placeholder is left");
    }
    if (lesson->recording.parent_path() != file.parent_path()) return broken("a recording in another folder");
    return {};
}

}  // namespace

const TriedReader kTriedLesson{"lesson", "x.toml", try_lesson};

}  // namespace game::test
