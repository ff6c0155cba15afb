#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/base/outcome.h"
#include "game/scene/viewpoint.h"

namespace game {

// A lesson as written: a recording that is watched, and stops at which time stands still and a card is shown.
struct Lesson {
    struct Question {
        std::string asks;
        std::vector<std::string> answers;
        std::size_t right = 0;  // index of an answer
        std::string why;        // that one is right
    };
    struct Stop {
        double time_s = 0;                      // of the recording
        int line = 0;                           // of the file
        std::string heading, text;              // the text may have placeholders
        std::optional<Viewpoint> camera = {};   // none: the view stays
        std::optional<Question> question = {};  // it asks and says why with placeholders too
        bool asks_guess = false;                // of the place where the front will stop
    };
    std::string title, about;
    std::filesystem::path recording;
    int recording_line = 0;
    std::vector<Stop> stops;  // by time
};

// What the program measures of a slide and fills into a text where it says {NAME}.
enum class LessonFigure { kSpeed, kVolume, kRunOut, kDrop, kReach, kPressure };
inline constexpr std::array<std::string_view, 6> kLessonFigures{"speed", "volume", "runout",
                                                                "drop",  "reach",  "pressure"};

// Calls `words` for each part between placeholders and `figure` for each placeholder, in order, up to the end or to a name
// that is no figure. Returns that name.
template <class Words, class Figure>
std::optional<std::string_view> each_part_of(std::string_view text, const Words& words,
                                             const Figure& figure) {
    while (!text.empty()) {
        const std::size_t begin = text.find('{');
        if (begin > 0) words(text.substr(0, begin));
        if (begin == text.npos) break;
        const std::size_t end = text.find('}', begin);
        const std::string_view name = text.substr(begin + 1, end == text.npos ? text.npos : end - begin - 1);
        std::size_t i = 0;
        while (i < kLessonFigures.size() && kLessonFigures[i] != name) ++i;
        if (i == kLessonFigures.size() || end == text.npos) return name;
        figure(static_cast<LessonFigure>(i));
        text.remove_prefix(end + 1);
    }
    return std::nullopt;
}

// The ticks of its stops.
std::vector<std::int64_t> ticks_of(const Lesson& lesson, double tick_s);

// Whether a file is written as a lesson: TOML with a [[stop]] or a recording. Files that cannot be read are not.
bool is_lesson(const std::filesystem::path& file);

// Errors (status 2): the file cannot be read or is larger than game/base/limits.h allows, a key is unknown, missing or out of
// range, or a text has a placeholder that is none. The recording is not looked at.
Outcome<Lesson> read_lesson(const std::filesystem::path& file);

}  // namespace game
