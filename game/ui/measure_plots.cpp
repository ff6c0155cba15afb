#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <span>

#include "game/ui/graph.h"
#include "game/ui/walls.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

using Sample = SlideHistory::Sample;

constexpr float kPlotHeight = 2.8f;  // em
constexpr double kHeadroom = 1.6;    // of an axis over the largest value, for the words there
constexpr double kLeastTime = 10;    // s, along the axis
constexpr double kLeastRunOut = 50, kLeastVolume = 100, kLeastSpeedInTime = 5,
                 kLeastPressure = 5;  // at the tops of the axes: m, m³, m/s, kPa

struct Plot {
    const char* name;  // of the value, and of the widget
    const char* unit;
    const char* format;  // of the value
    double least;        // at the top of the axis
    ImU32 colour;
    std::span<const Wall> walls = {};  // that a pressure breaks
};

double seconds_of(const Facts& facts, std::int64_t tick) {
    return static_cast<double>(tick) * static_cast<double>(facts.state.params.tick_s);
}

// The last sample until `seconds`; null if there is none.
const Sample* sample_at(const Facts& facts, double seconds) {
    const Sample* found = nullptr;
    for (const Sample& sample : facts.history->samples())
        if (seconds_of(facts, sample.tick) <= seconds) found = &sample;
    return found;
}

// In the plot: its name on the left; on the right the value at the pointed or the current time.
template <class Value>
void plot_title(Desk& desk, const Facts& facts, const Plot& plot, const Graph& graph, const Value& value) {
    ImFont* const letters = desk.widgets.letters.small;
    const float edge = 0.35f * desk.em(), y = graph.top() + 0.2f * desk.em();
    graph.list().AddText(letters, letters->FontSize, {graph.left() + edge, y}, palette().dim_text,
                         tr(plot.name));
    const Sample* const at = sample_at(facts, desk.pointed_s.value_or(seconds_of(facts, facts.state.tick)));
    if (!at) return;
    std::array<char, 40> text;
    write_number(text, plot.format, value(*at));
    const float wide = letters->CalcTextSizeA(letters->FontSize, FLT_MAX, 0, text.data()).x;
    graph.list().AddText(letters, letters->FontSize, {graph.right() - edge - wide, y}, palette().text,
                         text.data());
}

// Asks for the time under the cursor while it is held. Returns that time.
std::optional<double> seek(const Facts& facts, const Graph& graph, Actions& actions) {
    const auto pointed = graph.pointed();
    if (pointed && graph.held() && facts.timeline.can_go_back) {
        const std::int64_t tick = std::llround(*pointed / static_cast<double>(facts.state.params.tick_s));
        actions.emplace_back(SeekTick{std::clamp<std::int64_t>(tick, 0, facts.timeline.known_until)});
    }
    return pointed;
}

// The pressure that breaks a wall, if the axis reaches as far.
void wall_line(Desk& desk, const Graph& graph, const Wall& wall, const Range& seconds) {
    const float y = graph.y(wall.pressure);
    ImFont* const letters = desk.widgets.letters.small;
    if (y < graph.top() + 2.2f * letters->FontSize) return;
    graph.line(seconds.least, wall.pressure, seconds.most, wall.pressure, faded(palette().dim_text, 0.5f),
               0.06f * desk.em());
    const char* const words = tr(wall.what);
    const float wide = letters->CalcTextSizeA(letters->FontSize, FLT_MAX, 0, words).x;
    graph.list().AddText(letters, letters->FontSize,
                         {graph.right() - 0.35f * desk.em() - wide, y - letters->FontSize},
                         palette().dim_text, words);
}

struct OverTime {
    Range seconds;
    bool is_last;  // its numbers are told
};

// Returns the pointed time.
template <class Value>
std::optional<double> draw_plot(Desk& desk, const Facts& facts, const Plot& plot, const OverTime& over,
                                Actions& actions, const Value& value) {
    double most = 0;
    for (const Sample& sample : facts.history->samples()) most = std::max(most, value(sample));
    const Graph graph(desk, plot.name, kPlotHeight, {over.seconds, "s", over.is_last},
                      {from_zero_to(kHeadroom * most, plot.least), plot.unit},
                      facts.timeline.can_go_back ? "A click goes to that time." : nullptr);
    const auto samples = facts.history->samples();
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double x0 = seconds_of(facts, samples[i].tick), x1 = seconds_of(facts, samples[i + 1].tick),
                     y0 = value(samples[i]), y1 = value(samples[i + 1]);
        graph.fill(x0, x1, {0, y0}, {0, y1}, faded(plot.colour, 0.2f));
        graph.line(x0, y0, x1, y1, plot.colour, 0.1f * desk.em());
    }
    for (const Wall& wall : plot.walls) wall_line(desk, graph, wall, over.seconds);
    graph.upright(seconds_of(facts, facts.state.tick), kAccent);
    plot_title(desk, facts, plot, graph, value);
    if (desk.pointed_s) graph.upright(*desk.pointed_s, palette().text);
    return seek(facts, graph, actions);
}

// Whether it was there at the last sample and still is.
bool stands(const Facts& facts, const SlideHistory::House& house) {
    return house.thing && facts.state.things && *house.thing < facts.state.things->list.size();
}

// The house with the largest pressure of all known time, whatever time is looked at; nothing without houses.
std::optional<std::size_t> most_pressed(const Facts& facts) {
    std::optional<std::size_t> found;
    float largest = -1;
    for (const Sample& sample : facts.history->samples())
        for (std::size_t i = 0; i < facts.history->houses().size(); ++i)
            if (sample.pressure[i] > largest) largest = sample.pressure[i], found = i;
    return found;
}

using HouseName = std::array<char, 24>;

// "House 3"
const char* write_house(HouseName& text, std::size_t house) {
    std::snprintf(text.data(), text.size(), tr("House %zu"), house + 1);
    return text.data();
}

// Which house, and what became of it. Nothing without houses.
std::optional<std::size_t> choose_house(Desk& desk, const Facts& facts) {
    const auto houses = facts.history->houses();
    if (houses.empty()) return std::nullopt;
    HouseName text;
    const auto name = [&](int i) {
        return i == 0 ? "with the largest pressure" : write_house(text, static_cast<std::size_t>(i - 1));
    };
    int chosen = desk.house && *desk.house < houses.size() ? static_cast<int>(*desk.house) + 1 : 0;
    desk.widgets.row("Which house");
    if (desk.widgets.choice("Which house", chosen, static_cast<int>(houses.size()) + 1,
                            "The house at which the pressure is measured. Its number stands on the mountain.",
                            name))
        desk.house = chosen == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(chosen - 1));
    if (facts.history->lacks_houses())
        desk.widgets.dim("Only the first %zu houses are measured.", SlideHistory::kMostHouses);
    return chosen > 0 ? std::optional(static_cast<std::size_t>(chosen - 1)) : most_pressed(facts);
}

void tell_house(Desk& desk, const Facts& facts, std::size_t house) {
    HouseName name;
    write_house(name, house);
    const SlideHistory::House& at = facts.history->houses()[house];
    if (!stands(facts, at)) return desk.widgets.dim("%s does not stand at this time.", name.data());
    const sim::Thing& thing = facts.state.things->list[*at.thing];
    desk.widgets.dim("%s: greatest load %.1f kPa, strength %.0f kPa, %s", name.data(),
                     static_cast<double>(thing.load) / 1000, thing.strength,
                     tr(thing.destroyed() ? "destroyed"
                        : thing.damaged() ? "damaged"
                                          : "intact"));
}

}  // namespace

void plots_over_time(Desk& desk, const Facts& facts, Actions& actions) {
    const SlideHistory* const history = facts.history;
    if (!history || !history->since()) return;
    const OverTime over{{0, std::max(seconds_of(facts, facts.timeline.known_until), kLeastTime)}, false};
    std::optional<double> pointed;
    const auto draw = [&](const Plot& plot, bool is_last, const auto& value) {
        if (const auto at = draw_plot(desk, facts, plot, {over.seconds, is_last}, actions, value))
            pointed = at;
    };
    const bool has_houses = !history->houses().empty();
    draw({"Run-out so far", "m", "%.0f m", kLeastRunOut, palette().text}, false,
         [](const Sample& s) { return s.run_out; });
    draw({"Moving volume", "m³", "%.0f m³", kLeastVolume, kStandingColour}, false,
         [](const Sample& s) { return s.volume; });
    draw({"Largest speed", "m/s", "%.1f m/s", kLeastSpeedInTime, kFlowColour}, !has_houses,
         [](const Sample& s) { return s.speed; });
    desk.told_house = choose_house(desk, facts);
    if (const auto house = desk.told_house) {
        draw({"Pressure at the house", "kPa", "%.1f kPa", kLeastPressure, kDanger, kWalls}, true,
             [&](const Sample& s) { return static_cast<double>(s.pressure.at(*house)); });
        tell_house(desk, facts, *house);
    }
    desk.pointed_s = pointed;
    desk.widgets.dim("Every %.1f s since %.1f s, when this was first opened.",
                     seconds_of(facts, history->step()), seconds_of(facts, *history->since()));
    desk.widgets.note("Since");
}

}  // namespace game::ui
