#include "game/app/shown_runs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "game/analysis/measures.h"
#include "game/scene/surface.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr std::size_t kMostEnds = 400;  // places, which are looked for on the screen; more are put together
constexpr double kRoomOfDot = 20;       // px, that a dot has to itself

}  // namespace

ShownRuns::ShownRuns(Runs runs) : runs_(std::move(runs)) {
    std::vector<End> each;
    for (std::size_t i = 0; i < runs_.ended.size(); ++i) each.push_back({runs_.ended[i].end, {i}});
    // By vertex, or by so many vertices that there are few enough.
    for (auto side = static_cast<double>(runs_.world.scene.scenario.grid.dx);
         ends_ = together(each, side), ends_.size() > kMostEnds;)
        side *= 2;
}

// Those that are in one square of this side, at their middle.
std::vector<ShownRuns::End> ShownRuns::together(const std::vector<End>& ends, double side) {
    std::map<std::pair<long, long>, End> by_square;
    for (const End& end : ends) {
        End& all = by_square[{std::lround(end.at.x / side), std::lround(end.at.y / side)}];
        all.at += static_cast<double>(end.runs.size()) * end.at;
        all.runs.insert(all.runs.end(), end.runs.begin(), end.runs.end());
    }
    std::vector<End> found;
    found.reserve(by_square.size());
    for (auto& [square, all] : by_square) {
        all.at /= static_cast<double>(all.runs.size());
        std::ranges::sort(all.runs);
        found.push_back(std::move(all));
    }
    return found;
}

bool ShownRuns::is_of(const Scenario& scenario) const {
    const Scenario& own = runs_.world.scene.scenario;
    return scenario.grid == own.grid && scenario.bedrock == own.bedrock;
}

void ShownRuns::choose(std::size_t map) {
    if (map == chosen_ || map >= runs_.maps.size()) return;
    chosen_ = map;
    ++version_;
}

render::Camera ShownRuns::view(const render::Camera& home, const sim::View& world) const {
    constexpr double kElevation = 45;  // degrees
    constexpr double kAround = 2;      // of the distance that would just do in a window without panels
    const sim::Grid& grid = world.grid;
    glm::dvec2 low(grid.nx, grid.ny), high(0);
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            if (probability()[index_of(grid, x, y)] > 0)
                low = glm::min(low, glm::dvec2(x, y)), high = glm::max(high, glm::dvec2(x, y));
    if (low.x > high.x) return home;
    const auto dx = static_cast<double>(grid.dx);
    const glm::dvec2 middle = dx * (low + high) / 2.0;
    render::Camera camera = home;
    camera.target = {middle, surface_height(world, middle)};
    camera.elevation_deg = kElevation;
    camera.distance_m =
        kAround * dx * glm::distance(low, high) / 2 / std::tan(glm::radians(home.field_of_view_deg) / 2);
    return camera;
}

void ShownRuns::trace(const GoalLines::View& view,
                      const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen) {
    if (view_ == view) return;
    view_ = view;
    under_.reset();
    std::vector<End> on_screen;
    for (const End& end : ends_)
        if (const auto at = seen(end.at)) on_screen.push_back({*at, end.runs});
    dots_ = together(on_screen, kRoomOfDot);
    to_draw_.clear();
    for (const End& dot : dots_)
        to_draw_.push_back({dot.at, dot.runs.size(), std::ranges::any_of(dot.runs, [&](std::size_t run) {
                                return runs_.ended[run].number == open_run_;
                            })});
}

void ShownRuns::point_at(glm::dvec2 cursor) {
    const auto before = std::exchange(under_, std::nullopt);
    double least = kRoomOfDot;
    for (std::size_t i = 0; i < dots_.size(); ++i)
        if (const double away = glm::distance(dots_[i].at, cursor); away <= least) least = away, under_ = i;
    if (under_ && under_ != before) under_words_ = told_of(dots_[*under_]);
}

std::size_t ShownRuns::next_of(const End& end) const {
    const auto after = std::ranges::find_if(
        end.runs, [&](std::size_t run) { return runs_.ended[run].number > open_run_.value_or(0); });
    return after == end.runs.end() ? end.runs.front() : *after;
}

std::string ShownRuns::told_of(const End& end) const {
    const Runs::Run& next = runs_.ended[next_of(end)];
    std::string words;
    if (end.runs.size() > 1) words = said("{} of {} runs ended here\n", end.runs.size(), runs_.ended.size());
    return words + tr(next.number == open_run_ ? "Run " : "Click: run ") + next.words;
}

std::optional<std::int64_t> ShownRuns::pointed_at() const {
    return under_ ? std::optional(runs_.ended[next_of(dots_[*under_])].number) : std::nullopt;
}

void ShownRuns::open(std::int64_t run) {
    open_run_ = run;
    view_.reset();
    if (under_) under_words_ = told_of(dots_[*under_]);
}

ui::RunsNote ShownRuns::note(std::optional<glm::dvec2> ground) const {
    ui::RunsNote note{[this](std::size_t map) { return runs_.maps[map].words.c_str(); }, runs_.maps.size(),
                      chosen_, to_draw_};
    if (under_) note.under = ui::RunsNote::Under{dots_[*under_].at, under_words_};
    if (!ground) return note;
    const sim::Grid& grid = runs_.world.scene.scenario.grid;
    const glm::dvec2 vertex = glm::round(*ground / static_cast<double>(grid.dx));
    const auto x = static_cast<int>(vertex.x), y = static_cast<int>(vertex.y);
    if (!grid.contains(x, y)) return note;
    if (const float share = probability()[index_of(grid, x, y)]; !std::isnan(share)) note.probability = share;
    return note;
}

}  // namespace game
