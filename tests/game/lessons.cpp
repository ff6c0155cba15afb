#include "game/scene/lesson.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "game/analysis/headless.h"
#include "game/analysis/lesson_figures.h"
#include "game/app/lesson_run.h"
#include "game/files/assets.h"
#include "game/scene/surface.h"
#include "game/session/loaded_world.h"
#include "sim/core/angle.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLesson = R"(title = "A trial"
recording = "trial.couloir"
[[stop]]
time = 0
heading = "Before"
text = "Look."
guess = "runout"
[[stop]]
time = 2.5
heading = "After"
text = "It ran {runout} and fell {drop}."
camera = [10, 20, 180, 30, 400]
question = "Why?"
answers = ["It is steep", "It is white"]
right = 2
why = "{speed}"
)";

class LessonFile : public testing::Test {
  protected:
    Outcome<Lesson> read(const std::string& text) const {
        write_bytes(path_, text);
        return read_lesson(path_);
    }
    static std::string with(const std::string& old_text, const std::string& new_text) {
        std::string text = kLesson;
        const auto at = text.find(old_text);
        EXPECT_NE(at, std::string::npos) << old_text;
        return text.replace(at, old_text.size(), new_text);
    }
    // What is wrong, without the folder of the file.
    std::string fault(const std::string& text) const {
        const auto lesson = read(text);
        if (lesson) return "nothing";
        EXPECT_EQ(lesson.error().status, Failure::kUnusable);
        const std::string& sentence = lesson.error().sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos);
        return sentence.substr(std::min(sentence.find("trial.toml:"), sentence.size()));
    }

    support::TemporaryFolder folder_;
    fs::path path_ = folder_.path() / "trial.toml";
};

TEST_F(LessonFile, has_stops_with_questions_guesses_and_cameras) {
    const auto lesson = read(kLesson);
    ASSERT_TRUE(lesson) << lesson.error().sentence;
    EXPECT_EQ(lesson->title, "A trial");
    EXPECT_EQ(lesson->recording, folder_.path() / "trial.couloir");
    ASSERT_EQ(lesson->stops.size(), 2u);
    EXPECT_TRUE(lesson->stops[0].asks_guess);
    EXPECT_FALSE(lesson->stops[0].question);
    const Lesson::Stop& last = lesson->stops[1];
    EXPECT_EQ(last.time_s, 2.5);
    ASSERT_TRUE(last.camera);
    EXPECT_EQ(last.camera->distance_m, 400);
    ASSERT_TRUE(last.question);
    EXPECT_EQ(last.question->right, 1u);
    EXPECT_EQ(last.question->answers[1], "It is white");
}

TEST_F(LessonFile, is_refused_with_its_line_if_anything_in_it_is_wrong) {
    EXPECT_EQ(fault(with("title = \"A trial\"", "titel = \"A trial\"")), "trial.toml:1: has no title");
    EXPECT_EQ(fault(with("heading = \"Before\"", "heading = \"\"")), "trial.toml:5: stop.heading is empty");
    EXPECT_EQ(fault(with("time = 2.5", "time = 0.05")),
              "trial.toml:9: stop.time is 0.05; it must be at least 0.1 s after the stop before it");
    EXPECT_EQ(fault(with("time = 2.5", "")), "trial.toml:8: stop has no time");
    EXPECT_EQ(fault(with("{runout}", "{width}")),
              "trial.toml:11: stop.text has {width}, which is none of {speed}, {volume}, {runout}, {drop}, "
              "{reach}, {pressure}");
    EXPECT_NE(fault(with("{runout}", "{runout")), "nothing");
    EXPECT_EQ(fault(with("right = 2", "right = 3")), "trial.toml:15: stop.right is 3, outside 1 to 2");
    EXPECT_EQ(fault(with("right = 2", "")),
              "trial.toml:13: stop.question has no right answer; write right = 1");
    EXPECT_EQ(fault(with(", \"It is white\"", "")),
              "trial.toml:14: stop.answers is not a list of 2 to 4 strings in quotes");
    EXPECT_EQ(fault(with("It is white", "It is steep")),
              "trial.toml:14: stop.answers has the same one twice");
    EXPECT_EQ(fault(with("guess = \"runout\"", "guess = \"speed\"")),
              "trial.toml:7: stop.guess is not \"runout\"");
    EXPECT_EQ(fault(with("question = \"Why?\"", "guess = \"runout\"\nquestion = \"Why?\"")),
              "trial.toml:13: stop.guess is asked by an earlier stop already");
    EXPECT_EQ(fault(with("400]", "0]")), "trial.toml:12: stop.camera has distance 0, outside 1 to 1000000");
    EXPECT_NE(fault(with("trial.couloir", "../trial.couloir")), "nothing");
    EXPECT_NE(fault(with("trial.couloir", "trial.toml")), "nothing");
    EXPECT_NE(fault(with("\"Look.\"", "\"\\u202ELook.\"")), "nothing");
    EXPECT_NE(fault(with("\"Look.\"", "\"" + std::string(700, 'a') + "\"")), "nothing");
    EXPECT_NE(fault(with("guess = \"runout\"", "gues = \"runout\"")), "nothing");
    EXPECT_NE(fault(std::string(kLesson).substr(0, std::string(kLesson).find("[[stop]]\ntime = 2.5"))),
              "nothing");
    std::string many = kLesson;
    for (int i = 3; i < 14; ++i)
        many += "[[stop]]\ntime = " + std::to_string(i) + "\nheading = \"a\"\ntext = \"b\"\n";
    EXPECT_EQ(fault(many), "trial.toml:3: stop is there 13 times; 2 to 12 are allowed");
    EXPECT_NE(fault(std::string(70'000, '#')), "nothing");
}

TEST_F(LessonFile, is_opened_with_the_recording_beside_it) {
    const auto text = [](const std::string& time, const std::string& camera) {
        return "title = \"A trial\"\nrecording = \"trial.couloir\"\n[[stop]]\ntime = 0\nheading = \"a\"\n"
               "text = \"b\"\n[[stop]]\ntime = " +
               time + "\nheading = \"a\"\ntext = \"b\"\n" + camera;
    };
    const auto fault = [&](const std::string& lesson) {
        write_bytes(path_, lesson);
        const auto opened = open_lesson(path_.string(), {});
        EXPECT_FALSE(opened);
        if (opened) return std::string("nothing");
        EXPECT_EQ(opened.error().status, Failure::kUnusable);
        return opened.error().sentence.substr(opened.error().sentence.find("trial.toml:"));
    };
    EXPECT_EQ(fault(text("1", "")).substr(0, 24), "trial.toml:2: recording:");
    fs::copy_file(find_asset(AssetKind::kLesson, "where-will-it-stop")->replace_extension(".couloir"),
                  folder_.path() / "trial.couloir");
    EXPECT_EQ(fault(text("57", "")),
              "trial.toml:7: stop.time is 57, after the end of the recording at 56.00 s");
    EXPECT_EQ(fault(text("5", "camera = [10, 2100, 0, 30, 400]\n")),
              "trial.toml:7: stop.camera looks at a place outside the terrain of 2000 by 2000 m");
    write_bytes(path_, text("56", ""));
    EXPECT_TRUE(is_lesson(path_));
    EXPECT_FALSE(is_lesson(find_asset(AssetKind::kScene, "winter-valley").value()));
    const auto opened = open_anything(path_.string(), {});
    ASSERT_TRUE(opened) << opened.error().sentence;
    EXPECT_TRUE(opened->watched);
    ASSERT_TRUE(opened->lesson);
    EXPECT_EQ(opened->lesson->stops.size(), 2u);
}

TEST(LessonTexts, have_the_figures_that_the_program_measures) {
    LessonFigures figures;
    figures.speed = 38.2, figures.volume = 1'160'453.4, figures.run_out = 1528, figures.reach_deg = 27.63;
    EXPECT_EQ(with_figures("v {speed}, {volume}.", figures), "v 38 m/s (138 km/h), 1,160,453 m3.");
    EXPECT_EQ(with_figures("{runout} {drop} {reach}", figures), "1528 m 0 m 27.6°");
    EXPECT_EQ(with_figures("{pressure}", figures), "a pressure that is not known");
    figures.pressure = 288.9;
    EXPECT_EQ(with_figures("{pressure}", figures), "289 kPa");
    EXPECT_EQ(with_figures("", figures), "");
    std::array<char, 8> small;
    EXPECT_STREQ(write_filled(small, "{speed}{volume}", figures), "38 m/s ");
}

class LessonUnderWay : public testing::Test {
  protected:
    LessonUnderWay() {
        for (const double time : {0.0, 1.0, 2.0}) {
            Lesson::Stop stop;
            stop.time_s = time;
            lesson_.stops.push_back(stop);
        }
        lesson_.stops[1].asks_guess = true;
        lesson_.stops[1].question = Lesson::Question{};
    }
    Lesson lesson_;
};

TEST_F(LessonUnderWay, lets_time_stand_still_at_each_stop_until_it_is_told_to_go_on) {
    LessonRun run(lesson_, 0.01);
    EXPECT_EQ(run.ticks_to_stop(0), 0);
    EXPECT_FALSE(run.open());
    EXPECT_TRUE(run.see(0));
    EXPECT_EQ(run.open(), &lesson_.stops[0]);
    EXPECT_EQ(run.go_on(), 0);
    EXPECT_FALSE(run.see(0)) << "it is left";
    EXPECT_EQ(run.ticks_to_stop(0), 100);
    EXPECT_FALSE(run.see(40));
    EXPECT_EQ(run.ticks_to_stop(40), 60);
    EXPECT_TRUE(run.see(100));
    EXPECT_FALSE(run.see(30)) << "scrubbed";
    EXPECT_EQ(run.open(), &lesson_.stops[1]) << "its card stays";
    EXPECT_EQ(run.go_on(), 100) << "where time goes on";
    EXPECT_FALSE(run.go_on());
    EXPECT_FALSE(run.see(100));
    EXPECT_FALSE(run.see(50));
    EXPECT_TRUE(run.see(100)) << "a second time";
    EXPECT_TRUE(run.see(0)) << "another card";
    EXPECT_EQ(run.open(), &lesson_.stops[0]);
    EXPECT_GT(run.ticks_to_stop(201), 1000);
}

TEST_F(LessonUnderWay, keeps_the_first_answer_and_says_how_far_off_the_guess_was) {
    LessonRun run(lesson_, 0.01);
    EXPECT_FALSE(run.note());
    EXPECT_TRUE(run.see(100));
    EXPECT_TRUE(run.lacks_figures());
    LessonFigures figures;
    figures.toe = glm::dvec2(30, 40);
    run.take(figures);
    EXPECT_FALSE(run.lacks_figures());
    EXPECT_TRUE(run.asks_guess());
    run.answer(1);
    run.answer(0);
    EXPECT_EQ(run.note()->answer, 1u);
    run.guess({0, 0});
    EXPECT_TRUE(run.note()->has_guess);
    EXPECT_FALSE(run.note()->tells_guess);
    EXPECT_FALSE(run.toe()) << "not yet";
    run.go_on();
    EXPECT_TRUE(run.see(200));
    run.take(figures);
    EXPECT_FALSE(run.asks_guess());
    EXPECT_EQ(run.note()->guess_off, 50);
    EXPECT_EQ(run.toe(), glm::dvec2(30, 40));
}

// What its texts say besides their figures.
TEST(ShippedLesson, says_what_is_true_of_its_recording) {
    const auto loaded = open_lesson("where-will-it-stop", {});
    ASSERT_TRUE(loaded) << loaded.error().sentence;
    const Scenario& scenario = loaded->scene.scenario;
    const Recording& recording = *loaded->watched;
    EXPECT_LT(fs::file_size(loaded->lesson->recording), 200'000u);
    ASSERT_EQ(loaded->lesson->stops.size(), 4u);

    auto session = Session::begin(scenario, {}, std::nullopt).value();
    const sim::View view = session.view();
    for (const TimedCommand& blast : recording.commands) {
        const Square at = square_under(view.grid, {blast.command.x, blast.command.y});
        const glm::dvec2 slope(ground_slope(view, at.x, at.y));
        const double degrees = sim::degrees_of_slope(glm::length(slope), 1);
        EXPECT_GT(degrees, 30) << "in the bowls it is 30 to 45° steep";
        EXPECT_LT(degrees, 45);
    }
    const auto figures_at = [&](double time_s) {
        const auto tick = std::llround(time_s / static_cast<double>(scenario.params.tick_s));
        EXPECT_TRUE(play_headless(session, recording.commands, Until::after(tick), {}, ""));
        return lesson_figures(scenario, session, recording.commands);
    };
    const auto houses_hit = [&] {
        return std::ranges::count_if(session.structures().all, [](const render::Structure& each) {
            return each.state != render::StructureState::kIntact;
        });
    };
    const LessonFigures released = figures_at(loaded->lesson->stops[1].time_s);
    EXPECT_GT(released.volume, 0);
    const LessonFigures running = figures_at(loaded->lesson->stops[2].time_s);
    EXPECT_EQ(houses_hit(), 0) << "the hamlet is still ahead";
    EXPECT_GT(*running.pressure, 30);
    const LessonFigures end = figures_at(loaded->lesson->stops[3].time_s);
    EXPECT_EQ(session.state().tick, recording.last_tick());
    EXPECT_LT(released.run_out, end.run_out / 3) << "just after the release";
    EXPECT_GT(end.run_out, running.run_out + 100);
    EXPECT_GT(houses_hit(), 0);
    const LessonFigures later = figures_at(75);
    EXPECT_EQ(later.run_out, end.run_out) << "the front has stopped";
}

}  // namespace
}  // namespace game::test
