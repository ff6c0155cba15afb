#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"
#include "game/words/words.h"

// The card of a stop in a lesson, and what its lesson marks on the terrain.

namespace game::ui {
namespace {

constexpr float kLessonWidth = 24, kLeastLesson = 10, kLeastLessonText = 2.2f;  // em
constexpr std::size_t kLongestFilled = 1024;                                    // bytes, with its figures

// A text of the lesson in the language of the window, with its figures.
void told(Desk& desk, const std::string& text, const LessonFigures& figures) {
    std::array<char, kLongestFilled> filled, written;
    write_filled(filled, tr(std::string_view(text)), figures);
    desk.widgets.plain("%s", write_with_volumes(written, filled.data()));
}

void in_accent(Desk& desk, const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    desk.widgets.plain("%s", text);
    ImGui::PopStyleColor();
}

void question_of_stop(Desk& desk, const LessonNote& note, Actions& actions) {
    const Lesson::Question& question = *note.stop.question;
    ImGui::Dummy({0, desk.em() * 0.2f});
    told(desk, question.asks, note.figures);
    desk.widgets.note("Question");
    for (std::size_t i = 0; i < question.answers.size(); ++i) {
        ImGui::BeginDisabled(note.answer && i != *note.answer && i != question.right);
        if (desk.widgets.long_button(question.answers[i].c_str(), note.answer && i == question.right) &&
            !note.answer)
            actions.emplace_back(LessonWish{i});
        ImGui::EndDisabled();
    }
    if (!note.answer) return;
    in_accent(desk, tr(*note.answer == question.right ? "Right." : "Not quite."));
    desk.widgets.note("Verdict");
    told(desk, question.why, note.figures);
}

void guess_of_stop(Desk& desk, const LessonNote& note) {
    if (note.stop.asks_guess) {
        in_accent(desk, tr(note.has_guess ? "Your guess is marked. Click elsewhere to change it."
                                          : "Click on the mountain where you think the front will stop."));
        desk.widgets.note("Guess");
    }
    if (!note.tells_guess) return;
    std::array<char, 160> text;
    std::array<char, 40> metres;
    if (note.guess_off)
        std::snprintf(text.data(), text.size(), tr("Your guess was %s from where the front stopped."),
                      write_number(metres, "%.0f m", *note.guess_off));
    else
        std::snprintf(text.data(), text.size(), "%s", tr("You made no guess."));
    in_accent(desk, text.data());
    desk.widgets.note("Guess");
}

void buttons_of_stop(Desk& desk, const LessonNote& note, const Facts& facts, Actions& actions) {
    const float all = ImGui::GetContentRegionAvail().x, half = (all - ImGui::GetStyle().ItemSpacing.x) / 2;
    std::array<char, 160> tooltip;
    if (note.number < note.stops) {
        std::snprintf(tooltip.data(), tooltip.size(), tr("%s: time runs on to the next stop."),
                      name_of(facts.keys, Verb::kPauseOrGoOn).c_str());
        if (desk.widgets.button("Go on", tooltip.data(), true, all)) actions.emplace_back(LessonWish{});
        return;
    }
    if (desk.widgets.button("Start again", "Begins the lesson anew.", false, half))
        actions.emplace_back(Verb::kReset);
    ImGui::SameLine();
    if (desk.widgets.button("Take over", "Ends the lesson: tools work from here on, in a new recording.",
                            true, half))
        actions.emplace_back(Verb::kTakeOver);
    if (desk.widgets.button("Look around", "Closes this card; the mountain stays as it is.", false, all))
        actions.emplace_back(LessonWish{});
}

// A pin with a word above it, or below.
void pin(Desk& desk, const LessonMark& mark) {
    const float em = desk.em(), edge = 0.4f * em, far = (mark.is_guess ? -2.6f : 1.2f) * em;
    const ImU32 colour = mark.is_guess ? kAccent : medal_colour(3);
    const ImVec2 at{static_cast<float>(mark.at.x), static_cast<float>(mark.at.y)};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine(at, {at.x, at.y + far}, faded(kAccentText, 0.7f), 0.3f * em);
    list.AddLine(at, {at.x, at.y + far}, colour, 0.14f * em);
    list.AddCircleFilled(at, 0.5f * em, faded(kAccentText, 0.7f));
    list.AddCircleFilled(at, 0.36f * em, colour);
    const char* const words = tr(mark.is_guess ? "Your guess" : "Stopped here");
    const ImVec2 size = ImGui::CalcTextSize(words);
    const ImVec2 from{at.x - size.x / 2, mark.is_guess ? at.y + far - size.y - edge / 2 : at.y + far};
    list.AddRectFilled({from.x - edge, from.y - edge / 2},
                       {from.x + size.x + edge, from.y + size.y + edge / 2}, palette().panel, edge);
    list.AddText(from, colour, words);
    desk.widgets.note(mark.is_guess ? "Your guess" : "Stopped here", from,
                      {from.x + size.x, from.y + size.y});
}

// A line between the guess and what came of it, where both are seen.
void lesson_marks(Desk& desk, std::span<const LessonMark> marks) {
    const auto px = [](glm::dvec2 at) { return ImVec2{static_cast<float>(at.x), static_cast<float>(at.y)}; };
    if (marks.size() == 2) {
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddLine(px(marks[0].at), px(marks[1].at), faded(kAccentText, 0.7f), 0.24f * desk.em());
        list.AddLine(px(marks[0].at), px(marks[1].at), palette().text, 0.1f * desk.em());
    }
    for (const LessonMark& mark : marks) pin(desk, mark);
}

}  // namespace

void lesson_card(Desk& desk, const Facts& facts, Actions& actions) {
    lesson_marks(desk, facts.lesson_marks);
    if (!facts.lesson) return;
    const LessonNote& note = *facts.lesson;
    const float em = desk.em(), width = std::min(kLessonWidth * em, desk.size.x - 2 * desk.margin());
    const float right = desk.size.x - desk.margin() - (desk.narrow() ? 0 : desk.right_column);
    // Between the bars. The text scrolls if that is not enough; the buttons stay.
    const float top = desk.toolbar_bottom + desk.margin(),
                room = std::max(desk.time_bar_top - desk.margin() - top, kLeastLesson * em);
    ImGui::SetNextWindowPos({right, top}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, room});
    ImGui::SetNextWindowBgAlpha(0.93f);
    ImGui::Begin("Lesson", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    desk.widgets.dim("%s   %d of %d", tr(note.title), static_cast<int>(note.number),
                     static_cast<int>(note.stops));
    in_accent(desk, tr(note.stop.heading.c_str()));
    desk.widgets.note("Stop");
    const float above = ImGui::GetCursorPosY(), least = kLeastLessonText * em;
    const float height =
        std::clamp(desk.lesson_text, least, std::max(room - above - desk.lesson_below, least));
    ImGui::BeginChild("Lesson text", {0, height});
    told(desk, note.stop.text, note.figures);
    if (note.stop.question) question_of_stop(desk, note, actions);
    guess_of_stop(desk, note);
    desk.lesson_text = ImGui::GetCursorPosY();
    ImGui::EndChild();
    const float text_end = ImGui::GetCursorPosY();
    buttons_of_stop(desk, note, facts, actions);
    desk.lesson_below = ImGui::GetCursorPosY() - text_end + 2 * ImGui::GetStyle().WindowPadding.y;
    desk.widgets.keep_window_clear("Lesson");
    ImGui::End();
}

}  // namespace game::ui
