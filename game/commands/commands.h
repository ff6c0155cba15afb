#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/analysis/gallery.h"
#include "game/analysis/summary.h"
#include "game/analysis/track_rule.h"
#include "game/app/filmed_session.h"
#include "game/base/outcome.h"
#include "game/bench/canvas.h"
#include "game/bench/measure.h"
#include "game/compare/edit.h"
#include "game/controls/tier.h"
#include "game/scene/memory.h"
#include "game/scene/scene.h"
#include "game/scene/viewpoint.h"
#include "game/share/slide_page.h"
#include "sim/engine.h"
#include "terrains/release_areas.h"

namespace game {

// Options of each subcommand, as parsed from the command line, and the functions that run them. Results go to
// standard output. Each function returns its exit status, or the reason why it ended early.

// Ticks between two images unless --every says otherwise: of --frames, and of --export without --frames.
inline constexpr std::int64_t kTicksPerPicture = 60;

struct PictureOptions {
    std::optional<std::filesystem::path> folder;
    std::optional<std::int64_t> every;  // ticks; none: the subcommand's default
    PictureSize size;
    std::string gl = "auto";
};

// The page of a slide.
struct WebOptions {
    std::optional<std::filesystem::path> file;
    std::uint64_t most_bytes = PageOptions().most_bytes;
    bool watch_only = false;
};
inline PageOptions page_options(const WebOptions& web, const PictureOptions& pictures) {
    return {pictures.every.value_or(PageOptions::kEvery), web.most_bytes, std::nullopt, !web.watch_only};
}

// What `run` and `replay` write of the session that they play.
struct OutputOptions {
    PictureOptions pictures;
    WebOptions web;
    FilmOptions film;
    ResultOptions results;
};

struct RunOptions : OutputOptions {
    std::string scene;  // empty if there is a terrain
    std::optional<std::filesystem::path> terrain, release, reference;
    std::optional<terrains::Thickness> thickness;  // how the release is measured
    bool accept_loss = false;                      // of more than 1 % of the release
    Overrides overrides;
    bool until_rest = false, until_still = false;
    std::optional<double> seconds;
    std::optional<std::filesystem::path> record, save_world, export_folder;
    bool iseesnow = false;                   // export in ISeeSnow's format
    std::optional<std::string> export_name;  // of its files
    std::optional<Viewpoint> view;           // none: the scene's camera
    sim::StepOptions step_options;
};
Outcome<int> run(const RunOptions& options);

struct ReplayOptions : OutputOptions {
    std::string recording;  // name or file
    std::optional<std::int64_t> until;
    bool verify = false, paranoid = false, score = false;
    bool keep = false;  // a try that was scored, among the best runs
    LookFrom look = LookFrom::kShipped;
    std::optional<Viewpoint> view;  // none: the recording's camera
    std::optional<std::filesystem::path> audio;
    std::optional<std::filesystem::path> poster;
    sim::StepOptions step_options;
    Memory memory;
};
Outcome<int> replay(const ReplayOptions& options);

struct SiteOptions {
    std::filesystem::path folder;
    std::vector<std::string> worlds;  // names or files; empty: all shipped scenes and challenges
    Memory memory;
};
// Writes a folder that any static host serves: a page per world, and an index.
Outcome<int> site(const SiteOptions& options);

struct CompareOptions {
    std::string first, second;         // names or files
    std::optional<std::int64_t> tick;  // none: the last tick of each
    std::optional<std::filesystem::path> maps;
    bool json = false;
    sim::StepOptions step_options;
    Memory memory;
};
// Compares two recordings on the same terrain: the difference at the end, and where they first differ.
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
// Changes one command of a recording, runs it again, and compares the result with the original.
Outcome<int> edit(const EditOptions& options);

struct EnsembleOptions {
    std::filesystem::path spec;
    std::optional<std::filesystem::path> folder;  // set unless `member` is
    std::optional<std::int64_t> member;           // play this one alone
    std::optional<std::filesystem::path> record;  // of it
    Overrides overrides;
    int threads = 0;  // 0: one per processor
    bool json = false;
};
// Plays the members of an ensemble and maps probabilities; 1 if any could not run, or after Ctrl+C.
Outcome<int> ensemble(const EnsembleOptions& options);

struct ReleaseOptions {
    std::filesystem::path ground;  // a DEM, or a scene by its name or file
    std::optional<std::filesystem::path> out, map, forest;
    terrains::ReleaseRules rules;
    double thickness = 1;  // m normal to the slope
    Overrides overrides;
    bool json = false;
};
// Finds where slabs of snow may let go on a DEM or in a scene; 1 if nowhere.
Outcome<int> release(const ReleaseOptions& options);

struct GenerateOptions {
    std::string generator;  // its name
    std::filesystem::path out;
    std::optional<std::filesystem::path> layers;  // folder for what else the generator knows
    std::uint64_t seed = 1;
    std::optional<int> squares;
    std::vector<std::string> settings;  // "relief=800"
    bool json = false;
};
// Makes a mountain by a generator and writes its heights as GeoTIFF or ESRI ASCII.
Outcome<int> generate_terrain(const GenerateOptions& options);

struct NormaliseOptions {
    std::string recording;  // name or file
    std::filesystem::path out;
    sim::StepOptions step_options;
    Memory memory;
};
// Rewrites a recording in the newest format, with states computed by this version of the physics. Returns 1
// if the recording is of this version and the states differ.
Outcome<int> normalise(const NormaliseOptions& options);

struct ShareOptions {
    std::string world;  // name of a scene or of a recording, or a file; empty if there is a lesson
    std::optional<std::string> lesson;  // name or file
    std::optional<std::string> beside;  // another world, in the right half
    std::filesystem::path out;
    std::optional<Viewpoint> view;
    std::uint64_t most_bytes = PageOptions().most_bytes;
    bool watch_only = false;
    Memory memory;
};
// Writes a scene, a challenge or a recording as a web page that plays.
Outcome<int> share(const ShareOptions& options);

struct PlayOptions {
    std::string program;                // argv[0]
    std::string what;                   // scene, terrain file or recording; empty: the first scene
    std::optional<std::string> lesson;  // name or file; `what` is empty then
    std::optional<std::int64_t> until;  // take over a recording at this tick
    std::optional<std::filesystem::path> ensemble;  // folder of results; `what` is their file
    Overrides overrides;
    std::optional<std::filesystem::path> record;
    std::optional<PictureSize> size;  // none: as it was left
    std::optional<Tier> tier;         // none: as chosen before, else measured
    bool safe = false;                // without the settings that were kept
    sim::StepOptions step_options;
};
Outcome<int> play(const PlayOptions& options);

struct ListOptions {
    bool json = false;
};
Outcome<int> list(const ListOptions& options);

struct TrackOptions {
    std::filesystem::path mesh, velocities;
    double dt = 1.0 / 60;  // s
    TrackRule rule;        // complete
    std::optional<std::filesystem::path> scalar;
    std::optional<std::filesystem::path> out;  // none: standard output
    std::optional<std::filesystem::path> pictures;
    std::int64_t every = 1;  // frames
    PictureSize size{800, 800};
    int threads = 1;
};
// Tracks the fronts of a velocity field on a triangle mesh, both read from files.
Outcome<int> track(const TrackOptions& options);

struct FiguresOptions {
    std::filesystem::path folder;
    std::vector<std::string> only;  // names in parts_of_figures(); empty: all
    bool quick = false;             // measure on grids of at most 30 squares
    int pixels = 640;               // side of a square image, 16 to 4096
    std::string gl = "auto";
    int threads = 0;  // 0: one per processor
};
// Parts that --only accepts: the figure numbers, and "numbers".
const std::vector<std::string>& parts_of_figures();
// Draws and measures the paper's figures, as images, a page and a CSV; 1 if a tolerance is exceeded.
Outcome<int> figures(const FiguresOptions& options);

struct GalleryOptions {
    std::filesystem::path folder;
    std::optional<std::filesystem::path> terrain;  // of the view of a real hill; none: without this view
    PictureSize size;
    std::string gl = "auto";
    sim::StepOptions step_options;
    Memory memory;
    bool hold = false;  // stay, and draw again when a shader or texture changes
};
// Draws the fixed views (figures/gallery_views.h) as images and a page, with the time of each pass. With `hold`
// it returns after Ctrl+C.
Outcome<int> gallery(const GalleryOptions& options);

struct BenchOptions {
    std::vector<std::string> recordings;  // names or files; empty: all shipped ones, or one with `scaling`
    std::vector<int> squares;             // empty: 80 and 160, or kScalingSquares with `scaling`
    std::vector<std::string> physics;  // of kBenchPhysics; empty: all, or the recording's own with `scaling`
    bool scaling = false;
    MeasureOptions measure;
    bool draws = true;
    CanvasOptions canvas;
    std::optional<std::filesystem::path> perf, summary, page, trace, against;
    double tolerance = 0.25;  // relative increase allowed in the time of a stage
    bool json = false;        // instead of tables
};
// Measures the time of recordings by stage; 1 if a state is not the recorded one, or if a stage is slower
// than in `against` by more than the tolerance.
Outcome<int> bench(const BenchOptions& options);

// Prints the table of errors and orders; 1 if a tolerance is exceeded.
Outcome<int> verify_physics();

}  // namespace game
