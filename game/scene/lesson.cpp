#include "game/scene/lesson.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "game/base/limits.h"
#include "game/base/one_line.h"
#include "game/files/assets.h"
#include "game/files/toml_table.h"
#include "sim/world/command.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr const char *kStop = "stop", *kRecording = "recording";
constexpr double kLongestLesson = 86'400, kLeastApart = 0.1;  // s

// A text that must be there, unless it is `optional`; empty after a fault.
std::string text_of(TomlTable& table, std::string_view key, std::size_t most, bool optional = false) {
    auto text = table.text(key);
    if (!text && !table.has(key) && !optional) table.blame("", fmt::format("has no {}", key));
    if (!text) return "";
    if (text->size() > most)
        table.blame(key, fmt::format("has {} bytes; {} are allowed", text->size(), most));
    else if (text->find_first_not_of(" \t\n") == text->npos)
        table.blame(key, "is empty");
    else if (printable(*text) != *text)
        table.blame(key, "has signs that cannot be seen");
    return std::move(*text);
}

// The same for one with placeholders.
std::string text_with_figures(TomlTable& table, std::string_view key, std::size_t most) {
    std::string text = text_of(table, key, most);
    const auto nothing = [](const auto&) {};
    if (const auto unknown = each_part_of(text, nothing, nothing))
        table.blame(key, fmt::format("has {{{}}}, which is none of {{{}}}", one_line(std::string(*unknown)),
                                     fmt::join(kLessonFigures, "}, {")));
    return text;
}

std::optional<Viewpoint> viewpoint_of(TomlTable& stop) {
    struct Part {
        const char* name;
        double least, most;
    };
    constexpr std::array kParts{Part{"east", 0, sim::kFarthest}, Part{"north", 0, sim::kFarthest},
                                Part{"azimuth", -360, 360}, Part{"elevation", 2, 89},
                                Part{"distance", 1, 1e6}};
    const auto numbers = stop.numbers("camera", kParts.size());
    if (!numbers) return std::nullopt;
    for (std::size_t i = 0; i < kParts.size(); ++i) {
        const Part& part = kParts[i];
        const double value = (*numbers)[i];
        if (value < part.least || value > part.most)
            stop.blame("camera",
                       fmt::format("has {} {}, outside {} to {}", part.name, value, part.least, part.most));
    }
    return Viewpoint{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3], (*numbers)[4]};
}

std::optional<Lesson::Question> question_of(TomlTable& stop) {
    if (!stop.has("question")) return std::nullopt;
    Lesson::Question question;
    question.asks = text_with_figures(stop, "question", kMostLessonQuestion);
    question.answers = stop.texts("answers", kFewestAnswers, kMostAnswers).value_or(question.answers);
    if (!stop.has("answers")) stop.blame("question", "has no answers");
    for (const std::string& answer : question.answers)
        if (answer.empty() || answer.size() > kMostLessonAnswer || one_line(answer) != answer)
            stop.blame("answers", fmt::format("has one that is empty, has more than {} bytes, or signs that "
                                              "cannot be seen",
                                              kMostLessonAnswer));
    for (auto one = question.answers.begin(); one != question.answers.end(); ++one)
        if (std::find(question.answers.begin(), one, *one) != one)
            stop.blame("answers", "has the same one twice");
    const auto last = static_cast<std::int64_t>(std::max<std::size_t>(question.answers.size(), 1));
    const auto right = stop.whole("right", 1, last);
    if (!right && !stop.has("right")) stop.blame("question", "has no right answer; write right = 1");
    question.right = static_cast<std::size_t>(right.value_or(1) - 1);
    question.why = text_with_figures(stop, "why", kMostLessonWhy);
    return question;
}

Lesson::Stop stop_of(TomlTable& table) {
    Lesson::Stop stop;
    stop.line = table.line();
    if (const auto time = table.number("time", 0, kLongestLesson))
        stop.time_s = *time;
    else if (!table.has("time"))
        table.blame("", "has no time");
    stop.heading = text_of(table, "heading", kMostLessonHeading);
    stop.text = text_with_figures(table, "text", kMostLessonText);
    stop.camera = viewpoint_of(table);
    stop.question = question_of(table);
    if (const auto guess = table.text("guess")) {
        if (*guess != "runout") table.blame("guess", "is not \"runout\"");
        stop.asks_guess = true;
    }
    table.finish();
    return stop;
}

void take_stops(TomlTable& root, Lesson& lesson) {
    auto tables = root.tables(kStop);
    if (tables.size() < kFewestStops || tables.size() > kMostStops)
        root.blame(kStop, fmt::format("is there {} times; {} to {} are allowed", tables.size(), kFewestStops,
                                      kMostStops));
    bool guessed = false;
    for (std::size_t i = 0; i < std::min(tables.size(), kMostStops); ++i) {
        Lesson::Stop stop = stop_of(tables[i]);
        if (i > 0 && stop.time_s < lesson.stops.back().time_s + kLeastApart)
            tables[i].blame("time", fmt::format("is {}; it must be at least {} s after the stop before it",
                                                stop.time_s, kLeastApart));
        if (stop.asks_guess && guessed) tables[i].blame("guess", "is asked by an earlier stop already");
        if (stop.asks_guess && i + 1 == tables.size())
            tables[i].blame("guess", "is of the last stop, which is to say how far it was off");
        guessed |= stop.asks_guess;
        lesson.stops.push_back(std::move(stop));
    }
}

// A file in the folder of the lesson.
void take_recording(TomlTable& root, const fs::path& file, Lesson& lesson) {
    const std::string name = text_of(root, kRecording, kMostLessonHeading);
    lesson.recording_line = root.line_of(kRecording);
    if (fs::path(name).extension() != ".couloir" || fs::path(name).filename() != name)
        root.blame(kRecording, "is not the name of a recording (.couloir) beside this file");
    lesson.recording = file.parent_path() / name;
}

}  // namespace

std::vector<std::int64_t> ticks_of(const Lesson& lesson, double tick_s) {
    std::vector<std::int64_t> ticks;
    for (const Lesson::Stop& stop : lesson.stops) ticks.push_back(std::llround(stop.time_s / tick_s));
    return ticks;
}

bool is_lesson(const fs::path& file) {
    std::error_code error;
    if (fs::file_size(file, error) > kMostLessonBytes || error) return false;
    const auto document = parse_toml(file);
    return document && (document->contains(kStop) || document->contains(kRecording));
}

Outcome<Lesson> read_lesson(const fs::path& file) {
    std::error_code error;
    if (const auto size = fs::file_size(file, error); !error && size > kMostLessonBytes)
        return unusable(
            fmt::format("{}: has {} bytes; a lesson may have {}", file.string(), size, kMostLessonBytes));
    const auto document = parse_toml(file);
    if (!document) return tl::unexpected(document.error());
    Lesson lesson;
    TomlFault fault;
    TomlTable root(*document, "", file.string(), fault);
    lesson.title = text_of(root, "title", kMostLessonHeading);
    lesson.about = text_of(root, "about", kMostLessonAbout, true);
    take_recording(root, file, lesson);
    take_stops(root, lesson);
    root.finish();
    if (fault) return unusable(*fault);
    return lesson;
}

}  // namespace game
