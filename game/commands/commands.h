#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/analysis/gallery.h"
#include "game/analysis/summary.h"
#include "game/base/outcome.h"
#include "game/bench/measure.h"
#include "game/compare/edit.h"
#include "game/scene/memory.h"
#include "game/scene/scene.h"
#include "sim/engine.h"
#include "sim/front/tracker.h"

namespace game {

// Options of each subcommand, as the command line gives them, and what runs them. Results go to standard
// output. Each returns its exit status, or why it ended early.

struct PictureOptions {
    std::optional<std::filesystem::path> folder;
    std::int64_t every = 60;  // ticks
    PictureSize size;
    std::string gl = "auto";
};

struct RunOptions {
    std::string scene;  // empty with a terrain
    std::optional<std::filesystem::path> terrain, release, reference;
    Overrides overrides;
    bool until_rest = false;
    std::optional<double> seconds;
    std::optional<std::filesystem::path> record, export_folder;
    PictureOptions pictures;
    ResultOptions results;
    sim::StepOptions step_options;
};
Outcome<int> run(const RunOptions& options);

struct ReplayOptions {
    std::string recording;  // name or file
    std::optional<std::int64_t> until;
    bool verify = false, paranoid = false;
    PictureOptions pictures;
    ResultOptions results;
    sim::StepOptions step_options;
    Memory memory;
};
Outcome<int> replay(const ReplayOptions& options);

struct CompareOptions {
    std::string first, second;         // names or files
    std::optional<std::int64_t> tick;  // none: where each ends
    std::optional<std::filesystem::path> maps;
    bool json = false;
    sim::StepOptions step_options;
    Memory memory;
};
// Two recordings on one ground: what differs in the end, and where they part.
Outcome<int> compare(const CompareOptions& options);

struct EditOptions {
    std::string recording;  // name or file
    Edit edit;
    std::filesystem::path out;
    std::optional<std::filesystem::path> maps;
    bool json = false;
    sim::StepOptions step_options;
    Memory memory;
};
// One command changed, and run again; compared with what it was.
Outcome<int> edit(const EditOptions& options);

struct NormaliseOptions {
    std::string recording;  // name or file
    std::filesystem::path out;
    sim::StepOptions step_options;
    Memory memory;
};
// A recording rewritten in the newest format, with the states of this version of the physics; 1 where it is
// of this version and they are others.
Outcome<int> normalise(const NormaliseOptions& options);

struct PlayOptions {
    std::string program;                // as it was called
    std::string what;                   // scene, terrain file or recording; empty: the first scene
    std::optional<std::int64_t> until;  // tick at which a recording is taken over
    Overrides overrides;
    std::optional<std::filesystem::path> record;
    PictureSize size;
    sim::StepOptions step_options;
};
Outcome<int> play(const PlayOptions& options);

struct ListOptions {
    bool json = false;
};
Outcome<int> list(const ListOptions& options);

struct TrackOptions {
    std::filesystem::path mesh, velocities;
    double dt = 1.0 / 60;                           // s
    std::optional<sim::front::PointSource> source;  // the command line sees to it that there is one,
    std::optional<sim::front::Rule::Kind> rule;     // and one
    bool hold = false;                              // of source paper
    std::optional<double> threshold, jump;          // 1/s, m/s
    std::optional<std::filesystem::path> scalar;
    std::optional<double> level;
    std::optional<std::filesystem::path> out;  // else standard output
    std::optional<std::filesystem::path> pictures;
    std::int64_t every = 1;  // frames
    PictureSize size{800, 800};
    int threads = 1;
};
// Follows the fronts in anybody's velocities on anybody's mesh.
Outcome<int> track(const TrackOptions& options);

struct FiguresOptions {
    std::filesystem::path folder;
    std::vector<std::string> only;  // of parts_of_figures(); empty: all
    bool quick = false;             // numbers on grids of 30 squares at most
    int pixels = 640;               // of a square picture, 16 to 4096
    std::string gl = "auto";
    int threads = 0;  // 0: as many as there are
};
// What can be made alone: the numbers of the figures, and "numbers".
const std::vector<std::string>& parts_of_figures();
// The paper's figures and how they measure, as pictures, a page and a CSV; 1 where a number misses its bound.
Outcome<int> figures(const FiguresOptions& options);

struct BenchOptions {
    std::vector<std::string> recordings;  // names or files; empty: all that ship, or one to scale
    std::vector<int> squares;             // empty: 80 and 160, or those of the scaling study
    std::vector<std::string> physics;     // of kBenchPhysics; empty: all, or the recording's own to scale
    bool scaling = false;
    MeasureOptions measure;
    bool draws = true;
    PictureSize size{640, 360};
    std::string gl = "auto";
    std::optional<std::filesystem::path> perf, summary, page, trace, against;
    double tolerance = 0.25;  // share by which a stage may take longer than then
    bool json = false;        // instead of tables
};
// What recordings cost, stage by stage; 1 where a state is not the one recorded, or a stage is slower than
// `against` by more than the tolerance.
Outcome<int> bench(const BenchOptions& options);

// Prints the table of errors and orders; 1 where one misses its bound.
Outcome<int> verify_physics();

}  // namespace game
