#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "game/controls/key_map.h"
#include "game/scene/date.h"
#include "game/ui/panels.h"
#include "game/words/names.h"
#include "game/words/words.h"
#include "sim/weather/sky.h"
#include "sim/world/ledger.h"

namespace game::ui {
namespace {

constexpr float kWidth = 45.5f;  // em
constexpr std::array<const char*, 8> kSpeeds{"1/8 ×", "1/4 ×", "1/2 ×", "1 ×", "2 ×", "4 ×", "8 ×", "16 ×"};
constexpr int kUsual = 3;  // index of 1 ×

// A button for a verb, with the verb's key in the tooltip.
bool verb_button(Desk& desk, const Facts& facts, const char* label, Icon icon, Verb verb, const char* text,
                 bool on = false) {
    std::array<char, 192> tooltip;
    std::snprintf(tooltip.data(), tooltip.size(), "%s: %s", name_of(facts.keys, verb).c_str(), tr(text));
    return desk.widgets.icon_button(label, icon, tooltip.data(), on);
}

void speed(Desk& desk, const Facts& facts, Actions& actions) {
    int chosen = std::clamp(static_cast<int>(std::lround(std::log2(facts.clock.speed()))) + kUsual, 0,
                            static_cast<int>(kSpeeds.size()) - 1);
    if (desk.widgets.choice(
            "Speed", chosen, static_cast<int>(kSpeeds.size()), "Simulated seconds per real second.",
            [](int i) { return kSpeeds[static_cast<std::size_t>(i)]; }, desk.em() * 5))
        actions.emplace_back(SetSpeed{std::exp2(chosen - kUsual)});
}

void undo_and_redo(Desk& desk, const Facts& facts, Actions& actions) {
    std::array<char, 160> text;
    ImGui::BeginDisabled(facts.looks_back() || facts.actions_to_undo == 0);
    std::snprintf(text.data(), text.size(), tr("undoes the last action; %zu can be undone."),
                  facts.actions_to_undo);
    if (verb_button(desk, facts, "Undo", Icon::kUndo, Verb::kUndo, text.data()))
        actions.emplace_back(Verb::kUndo);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(facts.looks_back() || facts.actions_to_redo == 0);
    std::snprintf(text.data(), text.size(), tr("redoes what was undone last; %zu can be redone."),
                  facts.actions_to_redo);
    if (verb_button(desk, facts, "Redo", Icon::kRedo, Verb::kRedo, text.data()))
        actions.emplace_back(Verb::kRedo);
    ImGui::EndDisabled();
}

void controls(Desk& desk, const Facts& facts, Actions& actions) {
    ImGui::BeginDisabled(!facts.timeline.can_go_back);
    if (verb_button(desk, facts, "Rewind", Icon::kBack, Verb::kRunBack, "rewinds, or runs forward again.",
                    facts.clock.runs_back()))
        actions.emplace_back(Verb::kRunBack);
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool paused = facts.clock.paused();
    if (verb_button(desk, facts, paused ? "Resume" : "Pause", paused ? Icon::kPlay : Icon::kPause,
                    Verb::kPauseOrGoOn, paused ? "resumes." : "pauses."))
        actions.emplace_back(Verb::kPauseOrGoOn);
    ImGui::SameLine();
    if (verb_button(desk, facts, "Step", Icon::kStep, Verb::kStepOnce, "runs one tick and pauses."))
        actions.emplace_back(Verb::kStepOnce);
    ImGui::SameLine();
    if (verb_button(desk, facts, "Skip", Icon::kSkip, Verb::kSkip, "runs the slide to its end.", facts.skips))
        actions.emplace_back(Verb::kSkip);
    ImGui::SameLine();
    speed(desk, facts, actions);
    ImGui::SameLine(0, desk.em());
    undo_and_redo(desk, facts, actions);
    ImGui::SameLine();
    if (verb_button(desk, facts, "Reset", Icon::kReset, Verb::kReset, "restarts the scene."))
        actions.emplace_back(Verb::kReset);
    ImGui::SameLine();
    ImGui::BeginDisabled(facts.sharing.has_value());
    if (verb_button(desk, facts, "Share", Icon::kShare, Verb::kShare,
                    "writes this slide as a web page to send to a friend.", facts.slide_ended))
        actions.emplace_back(Verb::kShare);
    ImGui::EndDisabled();
}

// The state of the clock, for the user; empty at normal speed.
struct Pace {
    std::array<char, 32> text{};
    ImU32 colour = palette().dim_text;
};

Pace pace_of(const Facts& facts) {
    Pace pace;
    if (facts.clock.behind()) {
        std::snprintf(pace.text.data(), pace.text.size(), tr("only %.1f ×"), facts.clock.reached_speed());
        pace.colour = kWarning;
    } else if (facts.clock.runs_back() && !facts.clock.paused()) {
        std::snprintf(pace.text.data(), pace.text.size(), tr("rewinding"));
        pace.colour = kAccent;
    } else if (facts.clock.paused()) {
        std::snprintf(pace.text.data(), pace.text.size(), tr("paused"));
    } else if (sim::at_rest(facts.state)) {
        std::snprintf(pace.text.data(), pace.text.size(), tr("at rest"));
    } else if (sim::is_calm(facts.state)) {
        std::snprintf(pace.text.data(), pace.text.size(), tr("weather passes"));
    } else if (facts.clock.pace() != 1) {
        std::snprintf(pace.text.data(), pace.text.size(), "%s: %.3g ×",
                      tr(facts.clock.pace() < 1 ? "slow" : "creep"),
                      facts.clock.speed() * facts.clock.pace());
    }
    return pace;
}

void coloured(const char* text, ImU32 colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

// The hour that begins.
void write_hour(const sim::Weather& weather) {
    const auto day = static_cast<std::int64_t>(weather.calendar.first_day) + weather.hours / 24;
    const render::Date date = date_of(day);
    ImGui::Text("%d %s %02d:00", date.day, tr(month_name(date.month)), static_cast<int>(weather.hours % 24));
}

// Shows the time, and as far as there is room the pace at the right end, and the tick.
void moment(Desk& desk, const Facts& facts) {
    const double seconds =
        static_cast<double>(facts.state.tick) * static_cast<double>(facts.state.params.tick_s);
    const Pace pace = pace_of(facts);
    const float pace_from = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(pace.text.data()).x;

    ImGui::SameLine(0, desk.em());
    if (const sim::Weather* weather = sim::weather_of(facts.state))
        write_hour(*weather);
    else
        ImGui::Text("%.2f s", seconds);
    desk.widgets.note("Time");

    std::array<char, 32> tick;
    std::snprintf(tick.data(), tick.size(), tr("tick %lld"), static_cast<long long>(facts.state.tick));
    const float gap = desk.em() * 0.7f;
    ImGui::SameLine(0, gap);
    if (ImGui::GetCursorPosX() + ImGui::CalcTextSize(tick.data()).x + gap <= pace_from) {
        coloured(tick.data(), palette().dim_text);
        desk.widgets.note("Tick");
        ImGui::SameLine();
    }
    const bool fits = ImGui::GetCursorPosX() <= pace_from;
    ImGui::SetCursorPosX(pace_from);
    coloured(fits ? pace.text.data() : "", pace.colour);
    if (pace.text[0] == 0 || !fits) return;
    desk.widgets.note(pace.text.data());
    if (facts.clock.behind()) desk.widgets.tooltip("The computer cannot keep up with the chosen speed.");
}

// Marks over the bar: a triangle where something was done, a diamond where something was hit, a dot at a stop of a lesson. Returns the one under the
// cursor.
const TimeMark* marks_over(Desk& desk, const Facts& facts, ImVec2 corner, float width, double known) {
    const float em = desk.em(), reach = em * 0.4f, top = corner.y - em * 0.12f, size = em * 0.26f;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const TimeMark* under = nullptr;
    for (const TimeMark& mark : facts.time_marks) {
        const float x = corner.x + width * static_cast<float>(static_cast<double>(mark.tick) / known);
        const bool on = ImGui::IsItemHovered() && std::abs(mouse.x - x) < reach;
        if (on) under = &mark;
        if (mark.kind == TimeMark::Kind::kStop)
            list.AddCircleFilled({x, top}, size, on ? palette().text : kAccent);
        else if (mark.kind == TimeMark::Kind::kHit)
            list.AddQuadFilled({x, top - size}, {x + size, top}, {x, top + size}, {x - size, top}, kDanger);
        else
            list.AddTriangleFilled({x - size, top - size}, {x + size, top - size}, {x, top + size},
                                   on ? palette().text : palette().dim_text);
    }
    return under;
}

// A scrub bar over all known time.
void timeline(Desk& desk, const Facts& facts, Actions& actions) {
    if (!facts.timeline.can_go_back) return;
    const float em = desk.em(), width = ImGui::GetContentRegionAvail().x;
    const auto known = static_cast<double>(std::max<std::int64_t>(facts.timeline.known_until, 1));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##timeline", {width, em * 0.9f});
    desk.widgets.note("Timeline");
    const bool held = ImGui::IsItemActive(), near = held || ImGui::IsItemHovered();
    const double pointed = std::clamp((ImGui::GetIO().MousePos.x - corner.x) / width, 0.f, 1.f) * known;

    const float knob = corner.x + width * static_cast<float>(static_cast<double>(facts.state.tick) / known);
    const float middle = corner.y + em * 0.45f, thick = em * 0.11f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({corner.x, middle - thick}, {corner.x + width, middle + thick}, palette().control_held,
                       thick);
    list.AddRectFilled({corner.x, middle - thick}, {knob, middle + thick}, kAccent, thick);
    list.AddCircleFilled({std::clamp(knob, corner.x + em * 0.3f, corner.x + width - em * 0.3f), middle},
                         em * (near ? 0.36f : 0.28f), near ? palette().text : kAccent);
    const TimeMark* const mark = marks_over(desk, facts, corner, width, known);
    const double to = mark ? static_cast<double>(mark->tick) : pointed;
    if (held) actions.emplace_back(SeekTick{std::llround(to)});
    if (!near) return;
    const auto tick_s = static_cast<double>(facts.state.params.tick_s);
    std::array<char, 64> text;
    const char *word = mark ? tr(mark->word) : "", *colon = mark ? ": " : "";
    if (facts.state.weather)  // some ticks are hours
        std::snprintf(text.data(), text.size(), tr("%s%stick %.0f of %.0f"), word, colon, to, known);
    else
        std::snprintf(text.data(), text.size(), tr("%s%s%.1f s of %.1f s"), word, colon, to * tick_s,
                      known * tick_s);
    desk.widgets.tooltip(text.data());
}

// What the hour brings.
void weather(Desk& desk, const Facts& facts) {
    if (!facts.state.weather) return;
    const sim::weather::Sky sky = sim::weather::sky_of(*facts.state.weather);
    std::array<char, 48> falls{}, blows{};
    if (sky.precipitation > 0)
        std::snprintf(falls.data(), falls.size(),
                      sky.temperature < 1 ? tr("snow %.1f mm/h") : tr("rain %.1f mm/h"),
                      static_cast<double>(sky.precipitation));
    else
        std::snprintf(falls.data(), falls.size(), "%s", tr(sky.cloud < 0.5f ? "clear" : "cloudy"));
    if (sky.wind > 0) {
        const double from = std::atan2(-sky.wind_to.x, -sky.wind_to.y) * 180 / std::numbers::pi;
        std::snprintf(blows.data(), blows.size(), tr("wind %s %.0f m/s"), tr(compass_point(from)),
                      static_cast<double>(sky.wind));
    }
    desk.widgets.dim("%.0f °C   %s   %s", static_cast<double>(sky.temperature), falls.data(), blows.data());
    desk.widgets.note("Weather");
    desk.widgets.tooltip(
        "Of this hour, at the scene's height of reference; the wind is that high above the ground.");
}

void mass(Desk& desk, const Facts& facts) {
    const sim::Ledger& ledger = facts.state.ledger;
    const double quantum = static_cast<double>(sim::kQuantum) * facts.state.grid.cell_area();
    std::array<std::array<char, 40>, 7> text;
    const std::array quanta{ledger.standing, ledger.rolling, ledger.poured, ledger.dug,
                            ledger.out,      ledger.fallen,  ledger.melted};
    for (std::size_t i = 0; i < text.size(); ++i)
        write_volume(text[i], static_cast<double>(quanta[i]) * quantum);
    const bool poured = ledger.poured != 0, dug = ledger.dug != 0;
    if (facts.state.weather)
        desk.widgets.dim("standing %s   rolling %s   fallen %s   melted %s%s%s%s%s   out %s", text[0].data(),
                         text[1].data(), text[5].data(), text[6].data(), poured ? tr("   poured ") : "",
                         poured ? text[2].data() : "", dug ? tr("   dug ") : "", dug ? text[3].data() : "",
                         text[4].data());
    else
        desk.widgets.dim("standing %s   rolling %s   poured %s%s%s   out %s", text[0].data(), text[1].data(),
                         text[2].data(), dug ? tr("   dug ") : "", dug ? text[3].data() : "", text[4].data());
    desk.widgets.note("Mass");
    desk.widgets.tooltip(
        facts.state.weather
            ? "Volume of the standing and rolling layers, and volume that fell, melted, and was lost over "
              "the border."
            : "Volume of the standing and rolling layers, and volume poured, dug, and lost over the border.");
}

}  // namespace

void time_bar(Desk& desk, const Facts& facts, Actions& actions) {
    const float width = std::min(kWidth * desk.em(), desk.size.x - 2 * desk.margin());
    ImGui::SetNextWindowPos({desk.size.x / 2, desk.size.y - desk.margin()}, ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, desk.size.y});
    ImGui::Begin("Time", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    controls(desk, facts, actions);
    moment(desk, facts);
    weather(desk, facts);
    timeline(desk, facts, actions);
    mass(desk, facts);
    desk.time_bar_top = ImGui::GetWindowPos().y;
    desk.time_bar_left = ImGui::GetWindowPos().x;
    desk.widgets.keep_window_clear("Time bar");
    ImGui::End();
}

}  // namespace game::ui
