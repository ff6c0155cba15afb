#include "game/command_line.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "game/base/number.h"
#include "game/base/version.h"
#include "game/commands/commands.h"
#include "sim/world/command.h"
#include "sim/world/params.h"

namespace game {
namespace {

// CLI11 costs seconds per translation unit: this is the only one.

constexpr Range<int> kThreads{1, 64};
constexpr Range<int> kSquares{8, 4096, "squares"};
constexpr Range<int> kPixels{16, 8192, "pixels"};
constexpr Range<int> kDevices{0, 255};
constexpr Range<std::int64_t> kTicks{0, 1'000'000'000, "ticks"};
constexpr Range<std::int64_t> kStride{1, 1'000'000, "ticks"};
constexpr Range<double> kSeconds{0, 86'400, "s"}, kDelay{-1e7, 1e7, "s"};
constexpr Range<double> kMove{-2 * sim::kFarthest, 2 * sim::kFarthest, "m"};

// What --help says of a number: what it is, its range, and in brackets what it is without the option.
template <class Number>
std::string described(std::string_view help, const Range<Number>& range, std::string_view usually) {
    return fmt::format("{}, {}{}", help, to_text(range),
                       usually.empty() ? "" : fmt::format(" [{}]", usually));
}

// The number in `text`. Throws the sentence as CLI11 wants it.
template <class Number>
Number number_of(const char* option, std::string_view text, const Range<Number>& range) {
    const auto number = number_from(text, range);
    if (!number) throw CLI::ValidationError(option, number.error());
    return *number;
}

// An option that is one number, kept in a number or an optional one. Every number comes through here or
// number_of(): what CLI11 itself takes for a number may be hexadecimal, octal, or cut to the bits of its
// type.
template <class Number, class Value>
CLI::Option* add_number(CLI::App& app, const char* option, const char* type, Value& value,
                        const Range<Number>& range, std::string_view help, std::string_view usually = {}) {
    return app
        .add_option_function<std::string>(
            option,
            [option, &value, range](const std::string& text) { value = number_of(option, text, range); },
            described(help, range, usually))
        ->type_name(type);
}

// The numbers of lists with commas between; at least one.
template <class Number>
std::vector<Number> numbers_of(const char* option, const std::vector<std::string>& lists,
                               const Range<Number>& range) {
    std::vector<Number> numbers;
    for (std::string_view rest : lists) {
        for (auto comma = rest.find(','); comma != rest.npos; comma = rest.find(',')) {
            numbers.push_back(number_of(option, rest.substr(0, comma), range));
            rest.remove_prefix(comma + 1);
        }
        numbers.push_back(number_of(option, rest, range));
    }
    if (numbers.empty()) number_of(option, "", range);  // throws
    return numbers;
}

// Two numbers with `between` in the middle.
template <class Number>
std::pair<Number, Number> pair_of(const char* option, std::string_view text, char between,
                                  const Range<Number>& range) {
    const std::size_t at = text.find(between);
    if (at == std::string_view::npos)
        throw CLI::ValidationError(
            option, fmt::format("'{}' is not two numbers with '{}' between them", text, between));
    return {number_of(option, text.substr(0, at), range), number_of(option, text.substr(at + 1), range)};
}

// "plain", and what kernels there are on this processor.
std::string kernel_names() {
    std::string names = "plain";
    for (const auto set : sim::kInstructionSets) names += fmt::format(", {}", sim::to_string(set));
    return names;
}

void add_step_options(CLI::App& app, sim::StepOptions& step_options) {
    add_number(app, "--threads", "N", step_options.threads, kThreads,
               "for the simulation; any number gives the same bits", "1");
    app.add_option_function<std::string>(
           "--kernel",
           [&step_options](const std::string& text) {
               step_options.plain = text == "plain";
               if (step_options.plain) return;
               for (const auto set : sim::kInstructionSets)
                   if (text == sim::to_string(set)) {
                       if (!sim::has(set))
                           throw CLI::ValidationError("--kernel", "this machine lacks " + text);
                       step_options.instruction_set = set;
                       return;
                   }
               throw CLI::ValidationError("--kernel", "'" + text + "' is none of " + kernel_names());
           },
           std::string("how the simulation is reckoned, to the same bits: ") + kernel_names() +
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

// Of every subcommand that builds a world.
void add_memory(CLI::App& app, Memory& memory) {
    app.add_option_function<std::string>(
           "--max-memory",
           [&memory](const std::string& text) {
               const auto bytes = bytes_from(text);
               if (!bytes)
                   throw CLI::ValidationError("--max-memory",
                                              "'" + text + "' is not bytes, as 4G, 512M or 1073741824");
               memory.most = *bytes;
           },
           "refuse a grid that is expected to take more memory than this: bytes, or with K, M, G or T [half "
           "of "
           "the machine's]")
        ->type_name("BYTES");
}

void add_size(CLI::App& app, PictureSize& size, const char* of_what, const char* usually) {
    app.add_option_function<std::string>(
           "--size",
           [&size](const std::string& text) {
               std::tie(size.width, size.height) = pair_of("--size", text, 'x', kPixels);
           },
           described(of_what, kPixels, usually))
        ->type_name("WxH");
}

void add_grid(CLI::App& app, Overrides& overrides) {
    add_number(app, "--grid", "N", overrides.squares, kSquares, "along the longer side");
}

void add_references(CLI::App& app, Overrides& overrides) {
    app.add_flag_callback(
        "--allow-references", [&overrides] { overrides.references = terrains::References::kAllowed; },
        "let virtual rasters (VRT) read the files they name, and a scene a terrain outside its folder; never "
        "the network");
}

void add_material_and_model(CLI::App& app, Overrides& overrides) {
    app.add_option("--material", overrides.material, "a name from `couloir list`, or a material file")
        ->type_name("NAME");
    add_named(app, "--model", overrides.model, sim::model_from, "bcre, bcre-inertial", "physics");
    add_named(app, "--scheme", overrides.scheme, sim::scheme_from,
              "lax-friedrichs, local-lax-friedrichs, muscl", "how bcre carries its rolling layer");
    add_named(app, "--law", overrides.law, sim::law_from, "constant, slope, shear",
              "how fast the rolling layer of bcre is");
    add_grid(app, overrides);
}

void add_play(CLI::App& app, PlayOptions& options) {
    app.add_option(
           "what", options.what,
           "a scene by name, or a file: scene (.toml), recording to watch and take over (.couloir), or "
           "elevation raster [alpine-valley]")
        ->type_name("SCENE");
    add_number(app, "--until", "TICK", options.until, kTicks,
               "of a recording: take over at this tick instead of at its end");
    app.add_option("--record", options.record,
                   "record the session here [a new file in couloir/recordings in the XDG data folder]")
        ->type_name("FILE.couloir");
    add_material_and_model(app, options.overrides);
    add_references(app, options.overrides);
    add_size(app, options.size, "of the window", "1280x720");
    add_memory(app, options.overrides.memory);
    add_step_options(app, options.step_options);
}

void add_gl(CLI::App& app, std::string& gl) {
    app.add_option_function<std::string>(
           "--gl",
           [&gl](const std::string& way) {
               constexpr std::string_view kNumbered = "device:";
               if (std::string_view(way).starts_with(kNumbered))
                   number_of("--gl", std::string_view(way).substr(kNumbered.size()), kDevices);
               else if (way != "auto" && way != "surfaceless" && way != "device")
                   throw CLI::ValidationError("--gl",
                                              "'" + way + "' is none of auto, surfaceless, device, device:N");
               gl = way;
           },
           described("where to draw: auto (a hardware device if there is one), surfaceless (software), or a "
                     "device by its number: device, device:N",
                     kDevices, gl))
        ->type_name("WAY");
}

void add_pictures(CLI::App& app, PictureOptions& options, const char* where) {
    app.add_option("--frames", options.folder, where)->type_name("DIR");
    add_number(app, "--every", "TICKS", options.every, kStride, "between two pictures, 60 in a second", "60");
    add_size(app, options.size, "of the pictures", "1280x720");
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
    add_material_and_model(app, options.overrides);
    add_references(app, options.overrides);
    app.add_flag("--until-rest", options.until_rest,
                 "stop when nothing moves; with --seconds, by then at the latest [3600]");
    add_number(app, "--seconds", "S", options.seconds, kSeconds, "simulated time");
    app.add_option("--record", options.record, "write the recording here")->type_name("FILE.couloir");
    app.add_option("--export", options.export_folder,
                   "write deposit, peak depth and speed, extent, summary, and pictures into DIR/frames")
        ->type_name("DIR");
    add_pictures(app, options.pictures, "write pictures here, and maps of extent and end");
    add_results(app, options.results);
    add_memory(app, options.overrides.memory);
    add_step_options(app, options.step_options);
}

void add_replay(CLI::App& app, ReplayOptions& options) {
    app.add_option("recording", options.recording, "a name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    app.add_flag_callback(
        "--headless", [] {}, "without a window (replay never opens one)");
    add_number(app, "--until", "TICK", options.until, kTicks, "stop after so many", "where it ends");
    app.add_flag(
        "--verify", options.verify,
        "compare every recorded state hash and mass ledger; status 0 only if there is one and all are "
        "equal, else 1");
    app.add_flag("--paranoid", options.paranoid,
                 "do every tick twice, with other threads and tiles, and compare; status 1 with a report of "
                 "where they "
                 "part, and with --frames its picture, desync.png");
    add_pictures(app, options.pictures, "write pictures here");
    app.add_flag_callback(
        "--no-render", [&options] { options.pictures.folder.reset(); },
        "draw nothing, whatever else is said");
    add_results(app, options.results);
    add_memory(app, options.memory);
    add_step_options(app, options.step_options);
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
    add_memory(app, options.memory);
    add_step_options(app, options.step_options);
}

void add_compare(CLI::App& app, CompareOptions& options) {
    app.add_option("first", options.first, "a name from `couloir list`, or a file")
        ->type_name("A")
        ->required();
    app.add_option("second", options.second, "the same")->type_name("B")->required();
    add_number(app, "--tick", "TICK", options.tick, kTicks,
               "compare them after so many, which both must have", "where each ends");
    add_telling(app, options, "--out");
}

void add_edit(CLI::App& app, EditOptions& options) {
    app.add_option("recording", options.recording, "a name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    add_number(app, "--tick", "TICK", options.edit.tick, kTicks, "that the command was given in")->required();
    add_number(app, "--command", "K", options.edit.which, Range<int>{1, 1'000'000},
               "which of several commands in that tick");
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
                const auto [east, north] = pair_of("--move", text, ',', kMove);
                options.edit.change = Edit::Move{{east, north}};
            },
            described("to the east and to the north", kMove, ""))
        ->type_name("EAST,NORTH");
    change
        ->add_option_function<std::string>(
            "--delay",
            [&](const std::string& text) {
                options.edit.change = Edit::Delay{number_of("--delay", text, kDelay)};
            },
            described("later, or earlier if negative, to whole ticks", kDelay, ""))
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
    add_memory(app, options.memory);
    add_step_options(app, options.step_options);
}

void add_track(CLI::App& app, TrackOptions& options) {
    app.add_option("mesh", options.mesh, "triangles as a Wavefront OBJ file; followed in its x, y plane")
        ->type_name("MESH.obj")
        ->required();
    app.add_option("velocities", options.velocities,
                   "array of frames × vertices × 2 as numpy.save() writes it, little-endian f4 or f8")
        ->type_name("VELOCITIES.npy")
        ->required();
    add_number(app, "--dt", "S", options.dt, Range<double>{1e-6, 1e6, "s"}, "time from frame to frame",
               "1/60");
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
    add_number(app, "--threshold", "NUMBER", options.threshold, Range<double>{1e-9, 1e9, "1/s"},
               "M of the paper", "jump / 1.5 cells");
    add_number(app, "--jump", "NUMBER", options.jump, Range<double>{1e-9, 1e9, "m/s"},
               "least jump of velocity that cuts an edge", "of rule relative 0.3");
    app.add_option("--scalar", options.scalar, "for --source level: array of frames × vertices")
        ->type_name("R.npy");
    add_number(app, "--level", "NUMBER", options.level, Range<double>{-1e30, 1e30},
               "for --source level: the level of the scalar");
    app.add_option("--out", options.out, "write the points here instead of to standard output")
        ->type_name("FILE.csv");
    app.add_option("--frames", options.pictures, "write pictures here")->type_name("DIR");
    add_number(app, "--every", "FRAMES", options.every, Range<std::int64_t>{1, 1'000'000, "frames"},
               "between two pictures", "1");
    add_size(app, options.size, "of the pictures", "800x800");
    add_number(app, "--threads", "N", options.threads, kThreads, "any number gives the same bits", "1");
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
    add_number(app, "--pixels", "N", options.pixels, Range<int>{16, 4096, "pixels"},
               "side of a square picture", "640");
    add_gl(app, options.gl);
    add_number(app, "--threads", "N", options.threads, kThreads,
               "any number gives the same figures and numbers", "as many as there are");
}

void add_bench(CLI::App& app, BenchOptions& options) {
    app.add_option("recordings", options.recordings,
                   "names from `couloir list`, or files [all that ship; with --scaling snow-avalanche]")
        ->type_name("RECORDING");
    app.add_option_function<std::vector<std::string>>(
           "--grid",
           [&options](const std::vector<std::string>& lists) {
               options.squares = numbers_of("--grid", lists, kSquares);
           },
           described("along the longer side, several with commas between", kSquares,
                     "80,160; with --scaling 40 to 2048"))
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
    add_number(app, "--repeats", "N", options.measure.repeats, Range<int>{1, 1000},
               "of each recording, after a warm-up; not of --scaling", "3");
    add_number(app, "--ticks", "N", options.measure.ticks, Range<std::int64_t>{1, kTicks.most, "ticks"},
               "of each recording at most", "all");
    add_number(app, "--every", "TICKS", options.measure.every, kStride,
               "from one drawn frame to the next, 60 in a second", "120");
    add_size(app, options.size, "of the frames", "640x360");
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
    add_number(app, "--tolerance", "NUMBER", options.tolerance, Range<double>{1e-6, 1e6}, "as a share",
               "0.25");
    add_memory(app, options.measure.memory);
    add_step_options(app, options.measure.step);
    app.footer(
        "Status 1 too where a recording does not end in its golden states, or repeats differ: such times "
        "count for "
        "nothing.\n");
}

// What the options of a track must add up to; says what was left to us.
Outcome<void> check(TrackOptions& options) {
    using sim::front::Rule, sim::front::PointSource;
    options.source = options.source.value_or(PointSource::kFit);
    const bool by_level = options.source == PointSource::kLevel;
    options.rule = options.rule.value_or(by_level ? Rule::Kind::kLevel : Rule::Kind::kGradient);
    if (by_level && (!options.scalar || !options.level))
        return unusable("--source level needs --scalar R.npy and --level NUMBER");
    if (!by_level && (options.scalar || options.level))
        return unusable("--scalar and --level are for --source level");
    if (options.hold && options.source != PointSource::kPaper)
        return unusable("--hold is for --source paper");
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
