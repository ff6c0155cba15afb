#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "game/app/goal_lines.h"
#include "game/session/loaded_world.h"
#include "game/ui/facts.h"
#include "render/view/camera.h"

namespace game {

// Many runs of one world with other numbers, as a window shows them: how likely places were hit, and where runs ended.
struct Runs {
    LoadedWorld world;  // whose numbers are those of the files
    struct Map {
        std::string words;               // "pressure of 1 kPa and more"
        std::vector<float> probability;  // of each vertex, 0 to 1; NaN where there is no ground
    };
    std::vector<Map> maps;  // at least one
    struct Run {
        std::int64_t number = 0;
        glm::dvec2 end{0};  // m, the farthest place that it reached
        std::string words;  // what it was given, and what it came to
    };
    std::vector<Run> ended;  // those that moved, ascending
    // The world of a run, at its start. Errors: it could not run.
    std::function<Outcome<LoadedWorld>(std::int64_t)> world_of;
};

// The runs over the world in the window.
class ShownRuns {
  public:
    explicit ShownRuns(Runs runs);

    // The world of a run.
    Outcome<LoadedWorld> world_of(std::int64_t run) const { return runs_.world_of(run); }
    // Whether a world has this ground.
    bool is_of(const Scenario& scenario) const;

    // Shows another probability, from 0; nothing happens if it is shown already, or there is none.
    void choose(std::size_t map);
    std::span<const float> probability() const { return runs_.maps[chosen_].probability; }
    std::int32_t version() const { return version_; }  // of it, from 1
    // A camera from the side of `home` that has all places that were hit in its view, and the slope above them.
    render::Camera view(const render::Camera& home, const sim::View& world) const;

    // Finds where the ends are on the screen, if the view is another; `seen` as in GoalLines::trace().
    void trace(const GoalLines::View& view, const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen);
    // The cursor, px from the top left; over no dot, or nowhere.
    void point_at(glm::dvec2 cursor);
    void point_nowhere() { under_.reset(); }
    // The run that a click there opens: of those that ended there, the one after the open one.
    std::optional<std::int64_t> pointed_at() const;
    // The run whose world is open.
    void open(std::int64_t run);

    // `ground`: the place under the cursor, m.
    ui::RunsNote note(std::optional<glm::dvec2> ground) const;

  private:
    // Runs that ended at about one place.
    struct End {
        glm::dvec2 at{0};               // m, or px of a dot on the screen
        std::vector<std::size_t> runs;  // of runs_.ended, ascending
    };
    static std::vector<End> together(const std::vector<End>& ends, double side);
    std::size_t next_of(const End& end) const;
    std::string told_of(const End& end) const;

    Runs runs_;
    std::size_t chosen_ = 0;
    std::int32_t version_ = 1;
    std::vector<End> ends_;
    std::optional<std::int64_t> open_run_;

    std::optional<GoalLines::View> view_;
    std::vector<End> dots_;             // on the screen: ends that are beside one another there share one
    std::vector<ui::RunEnd> to_draw_;   // the same
    std::optional<std::size_t> under_;  // of them
    std::string under_words_;
};

}  // namespace game
