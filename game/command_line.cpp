#include "game/command_line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "game/commands/commands.h"
#include "game/version.h"
#include "sim/command.h"
#include "sim/params.h"

namespace game {
namespace {

// CLI11 costs seconds per translation unit: this is the only one.

constexpr int kMostThreads = 64;

constexpr const char* kKernels = "plain, x86-64-v2, x86-64-v3, x86-64-v4";

void add_how(CLI::App& app, sim::How& how) {
    app.add_option("--threads", how.threads, "for the simulation; any number gives the same bits")
        ->check(CLI::Range(1, kMostThreads))
        ->capture_default_str();
    app.add_option_function<std::string>(
           "--kernel",
           [&how](const std::string& text) {
               how.plain = text == "plain";
               if (how.plain) return;
               for (const auto set : sim::kInstructionSets)
                   if (text == sim::to_string(set)) {
                       if (!sim::has(set))
                           throw CLI::ValidationError("--kernel", "this machine lacks " + text);
                       how.instruction_set = set;
                       return;
                   }
               throw CLI::ValidationError("--kernel", "'" + text + "' is none of " + kKernels);
           },
           std::string("how the simulation is reckoned, to the same bits: ") + kKernels +
               " [the newest that this machine has]")
        ->type_name("NAME");
}

std::optional<sim::front::Rule::Kind> rule_named(std::string_view name) {
    if (name == "paper") return sim::front::Rule::Kind::kGradient;
    if (name == "relative") return sim::front::Rule::Kind::kRelative;
    return std::nullopt;
}

template <class Enum>
void add_named(CLI::App& app, const char* option, std::optional<Enum>& value,
               std::optional<Enum> (*from)(std::string_view), const char* names, const char* help) {
    app.add_option_function<std::string>(
           option,
           [=, &value](const std::string& text) {
               value = from(text);
               if (!value) throw CLI::ValidationError(option, "'" + text + "' is none of " + names);
           },
           std::string(help) + ": " + names)
        ->type_name("NAME");
}

void add_size(CLI::App& app, PictureSize& size, const char* of_what) {
    app.add_option_function<std::string>(
           "--size",
           [&size](const std::string& text) {
               char rest = 0;
               if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 ||
                   size.width < 16 || size.height < 16 || size.width > 8192 || size.height > 8192)
                   throw CLI::ValidationError("--size",
                                              "'" + text + "' is not WIDTHxHEIGHT, each 16 to 8192 pixels");
           },
           of_what)
        ->type_name("WxH");
}

void add_grid(CLI::App& app, Wishes& wishes) {
    app.add_option_function<std::string>(
           "--grid",
           [&wishes](const std::string& text) {
               int squares = 0;
               char rest = 0;
               if (std::sscanf(text.c_str(), "%d%c", &squares, &rest) != 1 || squares < 8 || squares > 4096)
                   throw CLI::ValidationError("--grid",
                                              "'" + text + "' is not a number of squares, 8 to 4096");
               wishes.squares = squares;
           },
           "squares along the longer side")
        ->type_name("N");
}

void add_material_and_model(CLI::App& app, Wishes& wishes) {
    app.add_option("--material", wishes.material, "a name from `couloir list`, or a material file")
        ->type_name("NAME");
    add_named(app, "--model", wishes.model, sim::model_from, "bcre, bcre-inertial", "physics");
    add_named(app, "--scheme", wishes.scheme, sim::scheme_from, "lax-friedrichs, local-lax-friedrichs, muscl",
              "how bcre carries its rolling layer");
    add_named(app, "--law", wishes.law, sim::law_from, "constant, slope, shear",
              "how fast the rolling layer of bcre is");
    add_grid(app, wishes);
}

void add_play(CLI::App& app, PlayOptions& options) {
    app.add_option(
           "what", options.what,
           "a scene by name, or a file: scene (.toml), recording to watch and take over (.couloir), or "
           "elevation raster [alpine-valley]")
        ->type_name("SCENE");
    app.add_option("--until", options.until, "of a recording: take over at this tick instead of at its end")
        ->check(CLI::NonNegativeNumber)
        ->type_name("TICK");
    app.add_option("--record", options.record,
                   "record the session here [a new file in couloir/recordings in the XDG data folder]")
        ->type_name("FILE.couloir");
    add_material_and_model(app, options.wishes);
    add_size(app, options.size, "of the window, in pixels [1280x720]");
    add_how(app, options.how);
}

void add_gl(CLI::App& app, std::string& gl) {
    app.add_option("--gl", gl,
                   "where to draw: auto (a hardware device if there is one), surfaceless (software), device "
                   "or device:N")
        ->check(
            [](const std::string& way) {
                int number = 0;
                char rest = 0;
                const bool numbered =
                    std::sscanf(way.c_str(), "device:%d%c", &number, &rest) == 1 && number >= 0;
                const bool known = way == "auto" || way == "surfaceless" || way == "device" || numbered;
                return known ? "" : "'" + way + "' is none of auto, surfaceless, device, device:N";
            },
            "")
        ->capture_default_str();
}

void add_pictures(CLI::App& app, PictureOptions& options, const char* where) {
    app.add_option("--frames", options.folder, where)->type_name("DIR");
    app.add_option("--every", options.every, "ticks between two pictures (60 ticks are a second)")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("TICKS")
        ->capture_default_str();
    add_size(app, options.size, "of the pictures, in pixels [1280x720]");
    add_gl(app, options.gl);
}

void add_results(CLI::App& app, ResultOptions& options) {
    app.add_option("--perf", options.perf, "write the performance log, a line per tick")
        ->type_name("FILE.csv");
    app.add_option("--trace", options.trace,
                   "write what each frame did, for ui.perfetto.dev or chrome://tracing")
        ->type_name("FILE.json");
    app.add_option("--summary", options.summary, "write what is printed in the end, and more, as JSON")
        ->type_name("FILE.json");
    app.add_flag("--json", options.json, "print the summary as JSON");
}

void add_run(CLI::App& app, RunOptions& options) {
    app.add_option("scene", options.scene, "a name from `couloir list`, or a scene file")->type_name("SCENE");
    auto* terrain =
        app.add_option("--terrain", options.terrain, "a DEM instead of a scene: GeoTIFF, ESRI ASCII, …")
            ->type_name("DEM");
    app.add_option(
           "--release", options.release,
           "what starts on it: a depth raster, or GeoJSON polygons with `thickness` in vertical metres")
        ->type_name("FILE")
        ->needs(terrain);
    app.add_option("--reference", options.reference,
                   "what to compare with: a GeoJSON extent, or a raster of the observed change of height; "
                   "the summary "
                   "tells the overlap, and how far material was carried")
        ->type_name("FILE");
    add_material_and_model(app, options.wishes);
    app.add_flag("--until-rest", options.until_rest,
                 "stop when nothing moves; with --seconds, by then at the latest [3600]");
    app.add_option("--seconds", options.seconds, "simulated time")
        ->check(CLI::Range(0.0, 86400.0))
        ->check(
            [](const std::string& text) {
                return std::isnan(std::strtod(text.c_str(), nullptr)) ? "not a number" : "";
            },
            "")
        ->type_name("S");
    app.add_option("--record", options.record, "write the recording here")->type_name("FILE.couloir");
    app.add_option("--export", options.export_folder,
                   "write deposit, peak depth and speed, extent, summary, and pictures into DIR/frames")
        ->type_name("DIR");
    add_pictures(app, options.pictures, "write pictures here, and maps of extent and end");
    add_results(app, options.results);
    add_how(app, options.how);
}

void add_replay(CLI::App& app, ReplayOptions& options) {
    app.add_option("recording", options.recording, "a name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    app.add_flag_callback(
        "--headless", [] {}, "without a window (replay never opens one)");
    app.add_option("--until", options.until, "stop after this many ticks [where it ends]")
        ->check(CLI::Range(0, 1 << 30))
        ->type_name("TICK");
    app.add_flag("--verify", options.verify,
                 "compare every recorded state hash and mass ledger; status 1 if one differs");
    app.add_flag("--paranoid", options.paranoid,
                 "do every tick twice, with other threads and tiles, and compare; status 1 with a report of "
                 "where they "
                 "part, and with --frames its picture, desync.png");
    add_pictures(app, options.pictures, "write pictures here");
    app.add_flag_callback(
        "--no-render", [&options] { options.pictures.folder.reset(); },
        "draw nothing, whatever else is said");
    add_results(app, options.results);
    add_how(app, options.how);
}

// Where the maps of a comparison go, and how it is told.
template <class Options>
void add_telling(CLI::App& app, Options& options, const char* maps) {
    app.add_option(
           maps, options.maps,
           "write difference.tif and .png here: deposit, the second less the first; the same of peak depth; "
           "and desync.png, where they part")
        ->type_name("DIR");
    app.add_flag("--json", options.json, "print it as JSON");
    add_how(app, options.how);
}

void add_compare(CLI::App& app, CompareOptions& options) {
    app.add_option("first", options.first, "a name from `couloir list`, or a file")
        ->type_name("A")
        ->required();
    app.add_option("second", options.second, "the same")->type_name("B")->required();
    app.add_option("--tick", options.tick,
                   "compare them after so many ticks, which both must have [where each ends]")
        ->check(CLI::Range(0, 1 << 30))
        ->type_name("TICK");
    add_telling(app, options, "--out");
}

// Two numbers, "20,-5".
std::optional<glm::dvec2> pair_from(const std::string& text) {
    glm::dvec2 pair;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf%c", &pair.x, &pair.y, &rest) != 2) return std::nullopt;
    if (!std::isfinite(pair.x) || !std::isfinite(pair.y)) return std::nullopt;
    return pair;
}

void add_edit(CLI::App& app, EditOptions& options) {
    app.add_option("recording", options.recording, "a name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    app.add_option("--tick", options.edit.tick, "that the command was given in")
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 40))
        ->type_name("TICK")
        ->required();
    app.add_option("--command", options.edit.which, "which of several commands in that tick, from 1")
        ->type_name("K");
    auto* change = app.add_option_group("change", "one of these");
    change
        ->add_option_function<std::string>(
            "--set", [&](const std::string& text) { options.edit.change = Edit::Set{text}; },
            "members of the command, as the recording names them: x=80,rate=400,as=standing")
        ->type_name("NAME=VALUE,...");
    change->add_flag_callback(
        "--delete", [&] { options.edit.change = Edit::Delete{}; }, "leave the command out");
    change
        ->add_option_function<std::string>(
            "--move",
            [&](const std::string& text) {
                const auto by = pair_from(text);
                if (!by) throw CLI::ValidationError("--move", "'" + text + "' is not EAST,NORTH in metres");
                options.edit.change = Edit::Move{*by};
            },
            "metres to the east and to the north")
        ->type_name("EAST,NORTH");
    change
        ->add_option_function<double>(
            "--delay", [&](const double& seconds) { options.edit.change = Edit::Delay{seconds}; },
            "seconds later, earlier where negative, to whole ticks")
        ->type_name("S");
    change->require_option(1);
    app.add_option("--out", options.out, "record what comes of it here")
        ->type_name("NEW.couloir")
        ->required();
    add_telling(app, options, "--maps");
}

void add_normalise(CLI::App& app, NormaliseOptions& options) {
    app.add_option("recording", options.recording, "a name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    app.add_option("--out", options.out, "write it here")->type_name("NEW.couloir")->required();
    add_how(app, options.how);
}

// Into a double, or an optional one.
template <class Number>
void add_positive(CLI::App& app, const char* option, Number& number, const char* help) {
    app.add_option_function<std::string>(
           option,
           [option, &number](const std::string& text) {
               char* end = nullptr;
               const double value = std::strtod(text.c_str(), &end);
               if (text.empty() || *end || !std::isfinite(value) || value <= 0)
                   throw CLI::ValidationError(option, "'" + text + "' is not a number above 0");
               number = value;
           },
           help)
        ->type_name("NUMBER");
}

void add_track(CLI::App& app, TrackOptions& options) {
    app.add_option("mesh", options.mesh, "triangles as a Wavefront OBJ file; followed in its x, y plane")
        ->type_name("MESH.obj")
        ->required();
    app.add_option("velocities", options.velocities,
                   "array of frames × vertices × 2 as numpy.save() writes it, little-endian f4 or f8")
        ->type_name("VELOCITIES.npy")
        ->required();
    add_positive(app, "--dt", options.dt, "time from frame to frame, s [1/60]");
    add_named(app, "--source", options.source, sim::front::source_named, "half, paper, fit, level",
              "where on its edge a point lies [fit]");
    app.add_flag("--hold", options.hold,
                 "of --source paper: points whose front is ahead of them go on to the vertex that it left "
                 "through (Section 3.3)");
    add_named(
        app, "--rule", options.rule, rule_named, "paper, relative",
        "which edges are cut: paper, where velocity changes by --threshold per metre and by --jump; "
        "relative, by --jump and by 0.7 of both speeds, as beside rest [paper; with --source level where "
        "the scalar crosses the level]");
    add_positive(app, "--threshold", options.threshold, "M of the paper, 1/s [jump / 1.5 cells]");
    add_positive(app, "--jump", options.jump,
                 "least jump of velocity that cuts an edge, m/s [of rule relative 0.3]");
    app.add_option("--scalar", options.scalar, "for --source level: array of frames × vertices")
        ->type_name("R.npy");
    app.add_option("--level", options.level, "for --source level: the level of the scalar")
        ->type_name("NUMBER");
    app.add_option("--out", options.out, "write the points here instead of to standard output")
        ->type_name("FILE.csv");
    app.add_option("--frames", options.pictures, "write pictures here")->type_name("DIR");
    app.add_option("--every", options.every, "frames between two pictures")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("FRAMES")
        ->capture_default_str();
    add_size(app, options.size, "of the pictures, in pixels [800x800]");
    app.add_option("--threads", options.threads, "any number gives the same bits")
        ->check(CLI::Range(1, kMostThreads))
        ->capture_default_str();
    app.footer(
        "Prints a line for each point of each frame: frame,time_s,i,j,f,x,y,w. The front crosses the edge "
        "between vertices\n"
        "i < j, counted from 0, at the share f of the way from i, at x, y; w is its speed along the edge "
        "from "
        "i to j, m/s.\n");
}

void add_figures(CLI::App& app, FiguresOptions& options) {
    app.add_option("--out", options.folder, "write pictures, index.html and numbers.csv here")
        ->type_name("DIR")
        ->required();
    app.add_flag("--quick", options.quick,
                 "numbers on grids of 30 squares at most: half a minute instead of some five");
    app.add_option(
           "--only", options.only,
           fmt::format("make these alone, with commas between: {}", fmt::join(parts_of_figures(), ", ")))
        ->delimiter(',')
        ->check(
            [](const std::string& part) {
                const auto& parts = parts_of_figures();
                const bool known = std::find(parts.begin(), parts.end(), part) != parts.end();
                return known ? "" : fmt::format("'{}' is none of {}", part, fmt::join(parts, ", "));
            },
            "")
        ->type_name("LIST");
    app.add_option("--pixels", options.pixels, "side of a square picture")
        ->check(CLI::Range(16, 4096))
        ->type_name("N")
        ->capture_default_str();
    add_gl(app, options.gl);
    app.add_option("--threads", options.threads,
                   "any number gives the same figures and numbers [as many as there are]")
        ->check(CLI::Range(1, kMostThreads));
}

void add_bench(CLI::App& app, BenchOptions& options) {
    app.add_option("recordings", options.recordings,
                   "names from `couloir list`, or files [all that ship; with --scaling snow-avalanche]")
        ->type_name("RECORDING");
    app.add_option(
           "--grid", options.squares,
           "squares along the longer side, several with commas between [80,160; with --scaling 40 to 2048]")
        ->delimiter(',')
        ->check(CLI::Range(8, 4096))
        ->type_name("N");
    app.add_option("--physics", options.physics,
                   fmt::format("several with commas between: {} [all; with --scaling the recording's own]",
                               bench_physics_names()))
        ->delimiter(',')
        ->check(
            [](const std::string& name) {
                return bench_physics_named(name)
                           ? ""
                           : fmt::format("'{}' is none of {}", name, bench_physics_names());
            },
            "")
        ->type_name("NAME");
    app.add_flag(
        "--scaling", options.scaling,
        "how the cost of every part grows with the grid and with the length of the front: one avalanche "
        "on grid after grid");
    app.add_option("--repeats", options.how.repeats, "of each recording, after a warm-up; not of --scaling")
        ->check(CLI::Range(1, 1000))
        ->type_name("N")
        ->capture_default_str();
    app.add_option("--ticks", options.how.ticks, "of each recording at most [all]")
        ->check(CLI::Range(1, 1 << 30))
        ->type_name("N");
    app.add_option("--every", options.how.every,
                   "ticks from one drawn frame to the next (60 ticks are a second)")
        ->check(CLI::Range(1, 1 << 20))
        ->type_name("TICKS")
        ->capture_default_str();
    add_size(app, options.size, "of the frames, in pixels [640x360]");
    add_gl(app, options.gl);
    app.add_flag_callback(
        "--no-render", [&options] { options.draws = false; }, "draw nothing");
    app.add_option("--perf", options.perf, "write a line per tick, or per row of --scaling")
        ->type_name("FILE.csv");
    app.add_option("--summary", options.summary, "write the report as JSON, to compare with later")
        ->type_name("FILE.json");
    app.add_flag("--json", options.json, "print the report as JSON instead of tables");
    app.add_option("--page", options.page, "write tables and plots as one page that needs nothing else")
        ->type_name("FILE.html");
    app.add_option("--trace", options.trace,
                   "write the last repeats, for ui.perfetto.dev or chrome://tracing")
        ->type_name("FILE.json");
    app.add_option(
           "--against", options.against,
           "compare with an earlier report; status 1 where a stage takes longer by more than --tolerance")
        ->type_name("FILE.json");
    add_positive(app, "--tolerance", options.tolerance, "as a share [0.25]");
    add_how(app, options.how.how);
    app.footer(
        "Status 1 too where a recording does not end in its golden states, or repeats differ: such times "
        "count for "
        "nothing.\n");
}

// What the options of a track must add up to; says what was left to us.
Outcome<void> check(TrackOptions& options) {
    using sim::front::Rule, sim::front::Source;
    options.source = options.source.value_or(Source::kFit);
    const bool by_level = options.source == Source::kLevel;
    options.rule = options.rule.value_or(by_level ? Rule::Kind::kLevel : Rule::Kind::kGradient);
    if (by_level && (!options.scalar || !options.level))
        return unusable("--source level needs --scalar R.npy and --level NUMBER");
    if (!by_level && (options.scalar || options.level))
        return unusable("--scalar and --level are for --source level");
    if (options.hold && options.source != Source::kPaper) return unusable("--hold is for --source paper");
    if (options.level && !std::isfinite(*options.level)) return unusable("--level must be finite");
    if (options.rule == Rule::Kind::kGradient && !options.jump && !options.threshold)
        return unusable("track needs --jump or --threshold: what cuts an edge");
    if (options.rule != Rule::Kind::kGradient && options.threshold)
        return unusable("--threshold is for --rule paper");
    return {};
}

// What the options of a run must add up to.
Outcome<void> check(RunOptions& options) {
    if (!options.scene.empty() && options.terrain)
        return unusable("run takes a scene or --terrain DEM, not both");
    if (options.scene.empty() && !options.terrain)
        return unusable(
            "run needs a scene, or --terrain DEM with --release FILE; `couloir list` tells the scenes");
    if (options.terrain && !options.release)
        return unusable("--terrain needs --release FILE: without it nothing would start");
    if (!options.until_rest && !options.seconds) return unusable("run needs --until-rest or --seconds S");
    if (options.export_folder && !options.pictures.folder) {
        options.pictures.folder = *options.export_folder / "frames";
        options.pictures.every = std::max<std::int64_t>(options.pictures.every, 600);
    }
    return {};
}

}  // namespace

Outcome<int> run_command_line(int argc, char** argv) {
    CLI::App app{
        "Couloir: a sandbox for avalanches and landslides.\n"
        "Exit status: 0 done; 1 ran, but the answer is bad; 2 unusable arguments or input; 3 the machine "
        "fails.",
        "couloir"};
    app.set_version_flag("--version", fmt::format("{}, commit {}", kProgram, kCommit));
    app.get_formatter()->column_width(34);

    PlayOptions play_options;
    play_options.program = argv[0];
    RunOptions run_options;
    ReplayOptions replay_options;
    ListOptions list_options;
    TrackOptions track_options;
    CLI::App* play_app =
        app.add_subcommand("play", "open the sandbox in a window (what couloir does without a subcommand)");
    CLI::App* run_app = app.add_subcommand("run", "run a scene or a real hill without a window");
    CLI::App* replay_app = app.add_subcommand("replay", "run a recording again, bit for bit");
    CLI::App* list_app = app.add_subcommand("list", "what ships: scenes, materials, recordings, terrains");
    CLI::App* track_app = app.add_subcommand(
        "track", "follow the fronts in anybody's velocities: where they cross the edges of a mesh, as CSV");
    add_play(*play_app, play_options);
    add_track(*track_app, track_options);
    add_run(*run_app, run_options);
    add_replay(*replay_app, replay_options);
    FiguresOptions figures_options;
    CLI::App* figures_app = app.add_subcommand("figures",
                                               "the paper's figures, without and with its method, and a "
                                               "table of numbers; 1 where one misses its bound");
    add_figures(*figures_app, figures_options);
    CompareOptions compare_options;
    CLI::App* compare_app = app.add_subcommand(
        "compare",
        "two recordings on one ground: what differs in the end, and the first tick, stage, field and cell in "
        "which they part");
    add_compare(*compare_app, compare_options);
    EditOptions edit_options;
    CLI::App* edit_app = app.add_subcommand(
        "edit", "change one command of a recording, run it again, and compare what comes of it");
    add_edit(*edit_app, edit_options);
    NormaliseOptions normalise_options;
    CLI::App* normalise_app = app.add_subcommand(
        "normalise",
        "rewrite a recording in the newest format, with the states of this version of the physics");
    add_normalise(*normalise_app, normalise_options);
    BenchOptions bench_options;
    CLI::App* bench_app = app.add_subcommand(
        "bench", "what recordings cost, stage by stage, on several grids and in several physics");
    add_bench(*bench_app, bench_options);
    CLI::App* verify_app = app.add_subcommand(
        "verify-physics",
        "compare the solver with exact answers: errors and orders; 1 where one misses its bound");
    list_app->add_flag("--json", list_options.json, "as JSON");

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        return app.exit(asked);
    } catch (const CLI::ParseError& wrong) {
        return unusable(
            fmt::format("{} (couloir {}--help tells more)", wrong.what(),
                        app.get_subcommands().empty() ? "" : app.get_subcommands()[0]->get_name() + " "));
    }
    if (app.get_subcommands().empty() || play_app->parsed()) return play(play_options);
    if (run_app->parsed()) {
        if (auto sound = check(run_options); !sound) return tl::unexpected(sound.error());
        return run(run_options);
    }
    if (track_app->parsed()) {
        if (auto sound = check(track_options); !sound) return tl::unexpected(sound.error());
        return track(track_options);
    }
    if (figures_app->parsed()) return figures(figures_options);
    if (compare_app->parsed()) return compare(compare_options);
    if (edit_app->parsed()) return edit(edit_options);
    if (normalise_app->parsed()) return normalise(normalise_options);
    if (bench_app->parsed()) {
        if (bench_options.scaling && bench_options.trace) return unusable("--trace is not for --scaling");
        return bench(bench_options);
    }
    if (verify_app->parsed()) return verify_physics();
    return replay_app->parsed() ? replay(replay_options) : list(list_options);
}

}  // namespace game
