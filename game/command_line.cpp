#include "game/command_line.h"

#include <algorithm>
#include <array>
#include <cerrno>  // program_invocation_name
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "game/analysis/export_iseesnow.h"
#include "game/base/number.h"
#include "game/base/process.h"
#include "game/base/version.h"
#include "game/commands/commands.h"
#include "game/ensemble/spec.h"
#include "sim/world/command.h"
#include "sim/world/params.h"
#include "terrains/generators.h"

namespace game {
namespace {

// The only translation unit that includes CLI11, which takes seconds to compile.

constexpr Range<int> kThreads{1, kMostThreads};
constexpr Range<int> kSquares{8, 4096, "squares"};
constexpr Range<double> kSlopes{0, 90, "degrees"};
constexpr Range<int> kPixels{16, 8192, "pixels"};
constexpr Range<int> kFps{1, 120};
constexpr Range<int> kDevices{0, 255};
constexpr Range<std::int64_t> kTicks{0, 1'000'000'000, "ticks"};
constexpr Range<std::int64_t> kStride{1, 1'000'000, "ticks"};
constexpr Range<double> kSeconds{0, 86'400, "s"}, kDelay{-1e7, 1e7, "s"};
// Of --camera: east, north, azimuth, elevation, distance.
constexpr std::array<Range<double>, 5> kViewpoint{
    {{0, sim::kFarthest, "m"}, {0, sim::kFarthest, "m"}, {-360, 360, "deg"}, {2, 89, "deg"}, {1, 1e6, "m"}}};
constexpr Range<double> kMove{-2 * sim::kFarthest, 2 * sim::kFarthest, "m"};

// The --help text of a number: its meaning, its range, and its default in brackets.
template <class Number>
std::string described(std::string_view help, const Range<Number>& range, std::string_view usually) {
    return fmt::format("{}, {}{}", help, to_text(range),
                       usually.empty() ? "" : fmt::format(" [{}]", usually));
}

// The number in `text`. Throws its error message as a CLI11 exception.
template <class Number>
Number number_of(const char* option, std::string_view text, const Range<Number>& range) {
    const auto number = number_from(text, range);
    if (!number) throw CLI::ValidationError(option, number.error());
    return *number;
}

// Adds an option that takes one number. `value` is a number or an optional number. Every number goes through
// here or through number_of(), because CLI11's own parser accepts hexadecimal and octal and truncates to the
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

// The numbers of comma-separated lists; at least one.
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

// Two numbers separated by `between`.
template <class Number>
std::pair<Number, Number> pair_of(const char* option, std::string_view text, char between,
                                  const Range<Number>& range) {
    const std::size_t at = text.find(between);
    if (at == std::string_view::npos)
        throw CLI::ValidationError(option,
                                   fmt::format("'{}' is not two numbers separated by '{}'", text, between));
    return {number_of(option, text.substr(0, at), range), number_of(option, text.substr(at + 1), range)};
}

// "plain", then every instruction set in the build, separated by commas.
std::string kernel_names() {
    std::string names = "plain";
    for (const auto set : sim::kInstructionSets) names += fmt::format(", {}", sim::to_string(set));
    return names;
}

void add_step_options(CLI::App& app, sim::StepOptions& step_options) {
    add_number(app, "--threads", "N", step_options.threads, kThreads,
               "use N simulation threads (results are bit-identical)", "1");
    app.add_option_function<std::string>(
           "--kernel",
           [&step_options](const std::string& text) {
               step_options.plain = text == "plain";
               if (step_options.plain) return;
               for (const auto set : sim::kInstructionSets)
                   if (text == sim::to_string(set)) {
                       if (!sim::has(set))
                           throw CLI::ValidationError("--kernel", "this machine does not support " + text);
                       step_options.instruction_set = set;
                       return;
                   }
               throw CLI::ValidationError("--kernel", "'" + text + "' is not one of: " + kernel_names());
           },
           std::string("compute kernel (results are bit-identical): ") + kernel_names() +
               " [the newest that this machine supports]")
        ->type_name("NAME");
}

template <class Enum>
void add_named(CLI::App& app, const char* option, std::optional<Enum>& value,
               std::optional<Enum> (*from)(std::string_view), const char* names, const char* help) {
    app.add_option_function<std::string>(
           option,
           [=, &value](const std::string& text) {
               value = from(text);
               if (!value) throw CLI::ValidationError(option, "'" + text + "' is not one of: " + names);
           },
           std::string(help) + ": " + names)
        ->type_name("NAME");
}

// Adds an option that takes a size. `such_as`: examples for the error message.
void add_bytes(CLI::App& app, const char* option, std::uint64_t& bytes, const char* such_as,
               const char* help) {
    app.add_option_function<std::string>(
           option,
           [=, &bytes](const std::string& text) {
               const auto given = bytes_from(text);
               if (!given)
                   throw CLI::ValidationError(option,
                                              "'" + text + "' is not a size in bytes, such as " + such_as);
               bytes = *given;
           },
           help)
        ->type_name("BYTES");
}

// Added to every subcommand that builds a world.
void add_memory(CLI::App& app, Memory& memory) {
    add_bytes(app, "--max-memory", memory.most, "4G, 512M or 1073741824",
              "refuse a grid and images whose estimated memory exceeds this many bytes; suffixes K, M, G, T "
              "[half of the machine's memory]");
}

template <class Size>
void add_size(CLI::App& app, Size& size, const char* of_what, const char* usually) {
    app.add_option_function<std::string>(
           "--size",
           [&size](const std::string& text) {
               const auto [width, height] = pair_of("--size", text, 'x', kPixels);
               size = PictureSize{width, height};
           },
           described(of_what, kPixels, usually))
        ->type_name("WxH");
}

void add_grid(CLI::App& app, Overrides& overrides) {
    add_number(app, "--grid", "N", overrides.squares, kSquares,
               "set the resolution along the longer side (default: the scene's own)");
}

CLI::Option* add_crs(CLI::App& app, Overrides& overrides) {
    return app
        .add_option("--crs", overrides.crs,
                    "coordinate system of a DEM that names none: EPSG:31287, EPSG:31287+5778, or WKT of a "
                    "system in metres")
        ->type_name("SYSTEM");
}

void add_references(CLI::App& app, Overrides& overrides) {
    app.add_flag_callback(
        "--allow-references", [&overrides] { overrides.references = terrains::References::kAllowed; },
        "allow virtual rasters (VRT) to read the files they name, and scenes to read terrain and materials "
        "outside their folder; the network is never used");
}

void add_material_and_model(CLI::App& app, Overrides& overrides) {
    app.add_option("--material", overrides.material,
                   "use this material: a name from `couloir list`, or a material file")
        ->type_name("NAME");
    app.add_option("--size-class", overrides.size_class,
                   "use the friction that the material has in avalanches of this class, for example small "
                   "[by the volume of --release]")
        ->type_name("NAME");
    add_named(app, "--model", overrides.model, sim::model_from, "bcre, bcre-inertial, voellmy",
              "use this physics model");
    add_named(app, "--scheme", overrides.scheme, sim::scheme_from,
              "lax-friedrichs, local-lax-friedrichs, muscl",
              "transport the rolling layer of bcre with this scheme");
    add_named(app, "--law", overrides.law, sim::law_from, "constant, slope, shear",
              "compute the speed of the rolling layer of bcre by this law");
    add_grid(app, overrides);
}

// A parameter of the physics, as NAME=VALUE. Throws its error message as a CLI11 exception.
Overrides::Set set_from(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw CLI::ValidationError("--set", "'" + text + "' is not NAME=VALUE; numbers have a decimal point");
    const std::string name = text.substr(0, equals);
    for (const sim::ParamInfo& info : sim::kParams) {
        if (info.name != name) continue;
        const Range<double> range{static_cast<double>(info.least), static_cast<double>(info.most), info.unit};
        const auto value = number_from(std::string_view(text).substr(equals + 1), range);
        if (!value) throw CLI::ValidationError("--set", name + ": " + value.error());
        return {&info, static_cast<float>(*value)};
    }
    throw CLI::ValidationError("--set", "'" + name + "' is not a parameter; docs/scenes.md has all of them");
}

void add_set(CLI::App& app, Overrides& overrides) {
    app.add_option_function<std::string>(
           "--set",
           [&overrides](const std::string& all) {
               for (std::size_t from = 0; from <= all.size();) {
                   const std::size_t to = std::min(all.find(',', from), all.size());
                   overrides.set.push_back(set_from(all.substr(from, to - from)));
                   from = to + 1;
               }
           },
           "give parameters of the physics these values: friction=0.4,drag=2000")
        ->join(',')
        ->type_name("NAME=VALUE,...");
}

void add_look(CLI::App& app, LookFrom& look) {
    app.add_option_function<std::string>(
           "--look",
           [&look](const std::string& from) {
               if (from != "shipped" && from != "recorded")
                   throw CLI::ValidationError("--look", "'" + from + "' is not one of: shipped, recorded");
               look = from == "recorded" ? LookFrom::kRecorded : LookFrom::kShipped;
           },
           "draw a recording with the colours of: shipped (its materials as they ship now), recorded "
           "[shipped]")
        ->type_name("FROM");
}

void add_play(CLI::App& app, PlayOptions& options) {
    options.program = program_invocation_name;
    app.add_option(
           "what", options.what,
           "name of a scene, or a file: a scene (.toml), a recording to watch and continue (.couloir), or an "
           "elevation raster [couloir]")
        ->type_name("SCENE");
    app.add_option("--lesson", options.lesson, "give this lesson: a name from `couloir list`, or a file")
        ->type_name("LESSON");
    add_number(app, "--until", "TICK", options.until, kTicks,
               "take over the recording at this tick, not at its end");
    app.add_option(
           "--record", options.record,
           "write the recording to this file [a new file in couloir/recordings in the XDG data folder]")
        ->type_name("FILE.couloir");
    app.add_option(
           "--ensemble", options.ensemble,
           "SCENE is the file of an ensemble: show its results, which are in this folder, as probability "
           "and end points; a click on one opens its run")
        ->type_name("DIR");
    add_material_and_model(app, options.overrides);
    add_references(app, options.overrides);
    add_look(app, options.overrides.look);
    add_size(app, options.size, "set the size of the window", "as it was left, at first 1280x720");
    add_named(app, "--quality", options.tier, tier_from, "fast, balanced, full",
              "draw moving images in this quality [as chosen before, else measured at the start]");
    app.add_flag("--safe", options.safe, "start with the usual settings, and keep none");
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
                   throw CLI::ValidationError(
                       "--gl", "'" + way + "' is not one of: auto, surfaceless, device, device:N");
               gl = way;
           },
           described("draw on: auto (a hardware device if there is one), surfaceless (software), or the EGL "
                     "device with this number: device, device:N",
                     kDevices, gl))
        ->type_name("WAY");
}

void add_pictures(CLI::App& app, PictureOptions& options, const char* where, std::string_view usually) {
    app.add_option("--frames", options.folder, where)->type_name("DIR");
    add_number(app, "--every", "TICKS", options.every, kStride,
               "write an image every so many ticks, 60 per simulated second", usually);
    add_size(app, options.size, "set the size of the images", "1280x720");
    add_gl(app, options.gl);
}

// Throws its error message as a CLI11 exception.
Viewpoint viewpoint_from(const std::string& text) {
    std::array<double, kViewpoint.size()> numbers{};
    std::string_view rest = text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t comma = rest.find(',');
        if ((comma == rest.npos) != (i + 1 == numbers.size()))
            throw CLI::ValidationError("--camera", "'" + text + "' is not five numbers separated by ','");
        numbers[i] = number_of("--camera", rest.substr(0, comma), kViewpoint[i]);
        rest.remove_prefix(std::min(comma, rest.size() - 1) + 1);
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
}

// `film`: of a film, whose camera may move; null if there is none.
void add_camera(CLI::App& app, std::optional<Viewpoint>& view, FilmView* film) {
    std::string help =
        "look at the place EAST,NORTH (m) from this azimuth (0 north, 90 east; deg), height above the "
        "horizon (2 to 89 deg) and distance (m) [the scene's camera]";
    if (film)
        help +=
            "; a film also: chase (stays ahead of the front), front (looks up from where the slide comes to "
            "rest), top (sees all from above), path (along the camera path of the scene), scene";
    app.add_option_function<std::string>(
           "--camera",
           [&view, film](const std::string& text) {
               const auto named = film ? film_view_from(text) : std::nullopt;
               if (named)
                   *film = *named;
               else
                   view = viewpoint_from(text);
           },
           help)
        ->type_name("EAST,NORTH,AZIMUTH,ELEVATION,DISTANCE");
}

// What a page has, and from where pictures and page are seen.
template <class Options>
void add_page(CLI::App& app, Options& options, std::optional<Viewpoint>& view, FilmView* film = nullptr) {
    app.add_flag("--watch-only", options.watch_only,
                 "leave the world out of the page: nobody can take over, and it is 0.7 MB smaller or more");
    add_bytes(app, "--size-limit", options.most_bytes, "8M",
              "refuse a page that is larger; suffixes K, M, G, T [32000000]");
    add_camera(app, view, film);
}

void add_web(CLI::App& app, WebOptions& options, std::optional<Viewpoint>& view, FilmView* film = nullptr) {
    app.add_option("--web", options.file,
                   "write one page that plays the slide in any browser, with its numbers, and lets a person "
                   "take it over "
                   "there; --every is 6 ticks there unless given")
        ->type_name("FILE.html");
    add_page(app, options, view, film);
}

void add_results(CLI::App& app, ResultOptions& options) {
    app.add_option("--perf", options.perf, "write a performance log, one line per tick")
        ->type_name("FILE.csv");
    app.add_option("--trace", options.trace,
                   "write a trace of each frame for ui.perfetto.dev or chrome://tracing")
        ->type_name("FILE.json");
    app.add_option("--summary", options.summary, "write the full summary as JSON")->type_name("FILE.json");
    app.add_flag("--json", options.json, "print the summary as JSON");
}

CLI::Option* add_thickness(CLI::App& app, std::optional<terrains::Thickness>& thickness) {
    return app
        .add_option_function<std::string>(
            "--thickness",
            [&thickness](const std::string& measured) {
                if (measured != "vertical" && measured != "normal")
                    throw CLI::ValidationError("--thickness",
                                               "'" + measured + "' is not one of: vertical, normal");
                thickness =
                    measured == "normal" ? terrains::Thickness::kNormal : terrains::Thickness::kVertical;
            },
            "how the raster of --release, or `thickness` of its polygons, is measured: vertical, normal (to "
            "the "
            "slope, as AvaFrame and RAMMS measure) [vertical]")
        ->type_name("DIRECTION");
}

// A page and a film, and from where both are seen.
void add_page_and_film(CLI::App& app, OutputOptions& outputs, std::optional<Viewpoint>& view) {
    FilmOptions& options = outputs.film;
    add_web(app, outputs.web, view, &options.view);
    auto* video = app.add_option("--video", options.file,
                                 "write a film of the slide with its sound, through the program ffmpeg: .mp4 "
                                 "(H.264), .webm (VP9) or .mkv (AV1), in the size of --size, which is even")
                      ->type_name("FILE.mp4");
    add_number(app, "--fps", "N", options.fps, kFps, "show so many images per second in the film", "60")
        ->needs(video);
    app.add_option_function<std::string>(
           "--camera-path",
           [&options](const std::string& file) {
               options.path_file = file;
               options.view = FilmView::kPath;
           },
           "move the camera of the film along the keys of this file, as the Film panel saves it "
           "(docs/film.md)")
        ->type_name("FILE.toml")
        ->needs(video)
        ->excludes("--camera");
    app.add_flag("--silent", options.silent, "make the film without sound");
}

void add_run(CLI::App& app, RunOptions& options) {
    app.add_option("scene", options.scene, "name from `couloir list`, or a scene file")->type_name("SCENE");
    auto* terrain =
        app.add_option("--terrain", options.terrain, "use a DEM instead of a scene: GeoTIFF, ESRI ASCII, …")
            ->type_name("DEM");
    auto* release =
        app.add_option("--release", options.release,
                       "release this material on it: a depth raster, or GeoJSON polygons with a vertical "
                       "`thickness` in m or a `thickness_normal` to the slope")
            ->type_name("FILE")
            ->needs(terrain);
    add_thickness(app, options.thickness)->needs(release);
    app.add_flag("--accept-loss", options.accept_loss,
                 "exit with 0 even if over 1 % of the release is lost: outside the grid, where the terrain "
                 "has no data, "
                 "or where polygons overlap");
    add_crs(app, options.overrides)->needs(terrain);
    app.add_option("--reference", options.reference,
                   "compare with observations: a GeoJSON extent, or a raster of the change of height; the "
                   "summary reports the overlap, and for a raster the transport distance")
        ->type_name("FILE");
    add_material_and_model(app, options.overrides);
    add_set(app, options.overrides);
    add_references(app, options.overrides);
    app.add_flag(
        "--until-rest", options.until_rest,
        "stop when the kinetic energy has fallen to 1 % of its greatest since the last command, as com1DFA "
        "does, or nothing moves, or after --seconds [3600], whichever is first");
    app.add_flag("--until-still", options.until_still,
                 "stop only when nothing moves any more, not even a creep, or after --seconds [3600]");
    add_number(app, "--seconds", "S", options.seconds, kSeconds, "simulate this much time");
    app.add_option("--record", options.record, "write the recording to this file")->type_name("FILE.couloir");
    app.add_option("--save-world", options.save_world,
                   "write the world as it stands in the end to this file, to play in")
        ->type_name("FILE.couloir");
    app.add_option("--export", options.export_folder,
                   "write deposit, peak depth and speeds, extent and summary here, for a GIS")
        ->type_name("DIR");
    auto* format =
        app.add_option_function<std::string>(
               "--export-format",
               [&options](const std::string& name) {
                   if (name != "couloir" && name != "iseesnow")
                       throw CLI::ValidationError("--export-format",
                                                  "'" + name + "' is not one of: couloir, iseesnow");
                   options.iseesnow = name == "iseesnow";
               },
               "what --export writes: couloir; iseesnow: peak flow thickness, velocity and pressure "
               "and a configuration, named and measured as in that intercomparison, on the DEM's own "
               "grid [couloir]")
            ->type_name("NAME");
    app.add_option("--export-name", options.export_name,
                   "with --export-format iseesnow: first parts of the names of its files, such as "
                   "release1HS_01IdealizedTopo [names of release and DEM]")
        ->type_name("RELEASE_ID")
        ->needs(format);
    add_pictures(app, options.pictures, "write images here, and maps of the extent and the final state",
                 fmt::format("{}", kTicksPerPicture));
    add_page_and_film(app, options, options.view);
    add_results(app, options.results);
    add_memory(app, options.overrides.memory);
    add_step_options(app, options.step_options);
}

void add_replay(CLI::App& app, ReplayOptions& options) {
    app.add_option("recording", options.recording, "name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    add_number(app, "--until", "TICK", options.until, kTicks, "stop at this tick", "its last tick");
    app.add_flag(
        "--verify", options.verify,
        "compare every recorded state hash and mass ledger; exit status 0 only if at least one is compared "
        "and all are equal, else 1");
    app.add_flag(
        "--score", options.score,
        "score the try at the challenge from its commands and states alone; exit with status 1 if it "
        "has not ended or the recording claims another score, and 2 if a command broke a rule");
    app.add_flag_callback(
        "--keep", [&options] { options.keep = options.score = true; },
        "as --score, and keep the try among the best runs of its challenge on this machine, with where it "
        "came "
        "from, if it meets every need and belongs there");
    app.add_flag("--paranoid", options.paranoid,
                 "compute every tick twice, with different threads and tiles, and compare; if they differ, "
                 "exit with status 1, report where, and with --frames write desync.png");
    add_pictures(app, options.pictures, "write images here", fmt::format("{}", kTicksPerPicture));
    add_page_and_film(app, options, options.view);
    app.add_option(
           "--audio", options.audio,
           "write what is heard at the camera to this file: as long as the replay, two channels, 16 bits")
        ->type_name("FILE.wav");
    app.add_option(
           "--poster", options.poster,
           "draw a page for the wall here: the slide at the end of the replay, its map and its numbers")
        ->type_name("FILE.png");
    add_look(app, options.look);
    app.add_flag_callback(
        "--no-render",
        [&options] { options.pictures.folder.reset(), options.film = {}, options.poster.reset(); },
        "disable rendering (overrides --frames, --video and --poster)");
    add_results(app, options.results);
    add_memory(app, options.memory);
    add_step_options(app, options.step_options);
}

// Where the maps of a comparison go, and how its result is printed.
template <class Options>
void add_telling(CLI::App& app, Options& options, const char* maps) {
    app.add_option(
           maps, options.maps,
           "write difference.tif and .png here (deposit of the second minus the first), the same for peak "
           "depth, and desync.png, the point of divergence")
        ->type_name("DIR");
    app.add_flag("--json", options.json, "print the comparison as JSON");
    add_memory(app, options.memory);
    add_step_options(app, options.step_options);
}

void add_ensemble(CLI::App& app, EnsembleOptions& options) {
    app.add_option("spec", options.spec, "the ensemble: what varies, and how (docs/ensembles.md)")
        ->type_name("SPEC.toml")
        ->required();
    auto* out = app.add_option("--out", options.folder,
                               "write journal, table and maps here; what an earlier call left there goes on")
                    ->type_name("DIR");
    auto* member =
        add_number(app, "--member", "K", options.member, Range<std::int64_t>{1, EnsembleSpec::kMostMembers},
                   "play this member alone, to the same state");
    app.add_option("--record", options.record, "with --member: write its recording to this file")
        ->type_name("FILE.couloir")
        ->needs(member);
    member->excludes(out);
    app.add_flag("--json", options.json, "print the results as JSON");
    add_references(app, options.overrides);
    add_memory(app, options.overrides.memory);
    add_number(app, "--threads", "N", options.threads, kThreads,
               "play N members at a time (results are bit-identical)",
               "one per processor; under mpirun, one per process");
}

void add_release(CLI::App& app, ReleaseOptions& options) {
    terrains::ReleaseRules& rules = options.rules;
    app.add_option("ground", options.ground, "a DEM (GeoTIFF, ESRI ASCII, …), or a scene from `couloir list`")
        ->type_name("DEM|SCENE")
        ->required();
    app.add_option("--out", options.out, "write the areas to this file, for a GIS and for `run --release`")
        ->type_name("FILE.geojson");
    app.add_option("--map", options.map, "draw a map of them")->type_name("FILE.png");
    app.add_option(
           "--forest", options.forest,
           "leave out forest: a raster of the same extent with the share of a cell under crowns, 0 to 1")
        ->type_name("FILE");
    app.add_option_function<std::string>(
           "--slope",
           [&rules](const std::string& text) {
               std::tie(rules.least_slope, rules.most_slope) = pair_of("--slope", text, ':', kSlopes);
           },
           described("least and greatest slope", kSlopes, "28:55"))
        ->type_name("LEAST:MOST");
    add_number(app, "--ruggedness", "NUMBER", rules.most_ruggedness, Range<double>{0, 1},
               "greatest ruggedness of 3 × 3 cells (Sappington and others 2007)", "0.01");
    add_number(app, "--curvature", "NUMBER", rules.most_curvature, Range<double>{0, 1000},
               "greatest curvature of a contour line, rad per 100 m", "6");
    add_number(app, "--crowns", "NUMBER", rules.most_forest, Range<double>{0, 1},
               "with --forest: greatest share of a cell under crowns", "0.3");
    add_number(app, "--least-area", "NUMBER", rules.least_area, Range<double>{0, 1e9}, "least area in plan",
               "2500");
    add_number(app, "--most-area", "NUMBER", rules.most_area, Range<double>{1, 1e9},
               "greatest area in plan: larger ones are cut at ribs", "100000");
    add_number(app, "--thickness", "NUMBER", options.thickness, Range<double>{0.01, 10},
               "thickness normal to the slope, for volumes and for `run`", "1");
    add_crs(app, options.overrides);
    add_number(app, "--grid", "N", options.overrides.squares, kSquares, "squares along the longer side",
               "the DEM's own");
    app.add_flag("--json", options.json, "print the areas as JSON");
    add_references(app, options.overrides);
    add_memory(app, options.overrides.memory);
}

void add_compare(CLI::App& app, CompareOptions& options) {
    app.add_option("first", options.first, "name from `couloir list`, or a file")->type_name("A")->required();
    app.add_option("second", options.second, "name or file of the other")->type_name("B")->required();
    add_number(app, "--tick", "TICK", options.tick, kTicks,
               "compare both at this tick, which both must contain", "the last tick of each");
    add_telling(app, options, "--out");
}

void add_edit(CLI::App& app, EditOptions& options) {
    app.add_option("recording", options.recording, "name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    add_number(app, "--tick", "TICK", options.edit.tick, kTicks, "tick of the command to edit")->required();
    add_number(app, "--command", "K", options.edit.which, Range<int>{1, 1'000'000},
               "choose among several commands in that tick");
    auto* change = app.add_option_group("change", "exactly one of these");
    change
        ->add_option_function<std::string>(
            "--set", [&](const std::string& text) { options.edit.change = Edit::Set{text}; },
            "set members of the command, named as in the recording: x=80,rate=400,as=standing")
        ->type_name("NAME=VALUE,...");
    change->add_flag_callback(
        "--delete", [&] { options.edit.change = Edit::Delete{}; }, "delete the command");
    change
        ->add_option_function<std::string>(
            "--move",
            [&](const std::string& text) {
                const auto [east, north] = pair_of("--move", text, ',', kMove);
                options.edit.change = Edit::Move{{east, north}};
            },
            described("move the command east and north", kMove, ""))
        ->type_name("EAST,NORTH");
    change
        ->add_option_function<std::string>(
            "--delay",
            [&](const std::string& text) {
                options.edit.change = Edit::Delay{number_of("--delay", text, kDelay)};
            },
            described("delay the command, rounded to whole ticks; negative is earlier", kDelay, ""))
        ->type_name("S");
    change->require_option(1);
    app.add_option("--out", options.out, "write the new recording to this file")
        ->type_name("NEW.couloir")
        ->required();
    add_telling(app, options, "--maps");
}

void add_share(CLI::App& app, ShareOptions& options) {
    app.add_option("world", options.world,
                   "scene, challenge or recording: a name from `couloir list`, or a file")
        ->type_name("WORLD");
    app.add_option("--lesson", options.lesson,
                   "give this lesson in the page: a name from `couloir list`, or a file")
        ->type_name("LESSON");
    app.add_option("--beside", options.beside,
                   "show another scene or recording beside it, with the same time and view: a name or a file")
        ->type_name("WORLD");
    app.add_option("--out", options.out, "write the page to this file")->type_name("FILE.html")->required();
    add_page(app, options, options.view);
    add_memory(app, options.memory);
}

void add_site(CLI::App& app, SiteOptions& options) {
    app.add_option("worlds", options.worlds,
                   "scenes, challenges or recordings: names from `couloir list`, or files; else all shipped "
                   "scenes and "
                   "challenges")
        ->type_name("WORLD");
    app.add_option("--out", options.folder,
                   "write index.html, a page per world and what belongs to them here")
        ->type_name("DIR")
        ->required();
    add_memory(app, options.memory);
}

void add_normalise(CLI::App& app, NormaliseOptions& options) {
    app.add_option("recording", options.recording, "name from `couloir list`, or a file")
        ->type_name("RECORDING")
        ->required();
    app.add_option("--out", options.out, "write the new recording to this file")
        ->type_name("NEW.couloir")
        ->required();
    add_memory(app, options.memory);
    add_step_options(app, options.step_options);
}

void add_track(CLI::App& app, TrackOptions& options) {
    app.add_option("mesh", options.mesh,
                   "triangle mesh as a Wavefront OBJ file; fronts are tracked in its x, y plane")
        ->type_name("MESH.obj")
        ->required();
    app.add_option("velocities", options.velocities,
                   "array of frames × vertices × 2 from numpy.save(), little-endian f4 or f8, m/s")
        ->type_name("VELOCITIES.npy")
        ->required();
    add_number(app, "--dt", "S", options.dt,
               Range<double>{TrackRule::kShortestStep, TrackRule::kLongestStep, "s"},
               "set the time between frames", "1/60");
    add_named(app, "--source", options.rule.source, sim::front::source_named, "half, paper, fit, level",
              "method that locates a point on its edge [fit]");
    app.add_flag("--hold", options.rule.hold,
                 "with --source paper: move points whose front is ahead of them on to the vertex through "
                 "which it left (Section 3.3)");
    add_named(
        app, "--rule", options.rule.rule, track_rule_named, "paper, relative",
        "cut the edges on which the velocity changes: paper, by --threshold per metre and by --jump; "
        "relative, by --jump and by 0.7 of both speeds, as next to a layer at rest [paper; with --source "
        "level, the edges on which the scalar crosses the level]");
    add_number(app, "--threshold", "NUMBER", options.rule.threshold,
               Range<double>{TrackRule::kLeast, TrackRule::kMost, "1/s"},
               "set the paper's M, the least velocity gradient", "jump / 1.5 cells");
    add_number(app, "--jump", "NUMBER", options.rule.jump,
               Range<double>{TrackRule::kLeast, TrackRule::kMost, "m/s"},
               "set the least velocity jump that cuts an edge", "0.3 with rule relative");
    app.add_option("--scalar", options.scalar,
                   "with --source level: read the scalar from an array of frames × vertices")
        ->type_name("R.npy");
    add_number(app, "--level", "NUMBER", options.rule.level,
               Range<double>{-TrackRule::kFarthestLevel, TrackRule::kFarthestLevel},
               "with --source level: set the level of the scalar");
    app.add_option("--out", options.out, "write the points to this file, not to standard output")
        ->type_name("FILE.csv");
    app.add_option("--frames", options.pictures, "write images here")->type_name("DIR");
    add_number(app, "--every", "FRAMES", options.every, Range<std::int64_t>{1, 1'000'000, "frames"},
               "write an image every so many frames", "1");
    add_size(app, options.size, "set the size of the images", "800x800");
    add_number(app, "--threads", "N", options.threads, kThreads, "use N threads (results are bit-identical)",
               "1");
    app.footer(
        "Prints one line per point and frame: frame,time_s,i,j,f,x,y,w. The front crosses the edge between\n"
        "vertices i < j, counted from 0, at x, y, the fraction f of the edge from i. w is its speed along "
        "the\n"
        "edge from i to j, m/s.\n");
}

void add_figures(CLI::App& app, FiguresOptions& options) {
    app.add_option("--out", options.folder, "write images, index.html and numbers.csv here")
        ->type_name("DIR")
        ->required();
    app.add_flag("--quick", options.quick,
                 "measure on grids of at most 30 squares: takes about a minute instead of about five");
    app.add_option(
           "--only", options.only,
           fmt::format("make only these parts, separated by commas: {}", fmt::join(parts_of_figures(), ", ")))
        ->delimiter(',')
        ->check(
            [](const std::string& part) {
                const auto& parts = parts_of_figures();
                const bool known = std::find(parts.begin(), parts.end(), part) != parts.end();
                return known ? "" : fmt::format("'{}' is not one of: {}", part, fmt::join(parts, ", "));
            },
            "")
        ->type_name("LIST");
    add_number(app, "--pixels", "N", options.pixels, Range<int>{16, 4096, "pixels"},
               "set the side of a square image", "640");
    add_gl(app, options.gl);
    add_number(app, "--threads", "N", options.threads, kThreads, "use N threads (results are identical)",
               "one per processor");
}

void add_gallery(CLI::App& app, GalleryOptions& options) {
    app.add_option("--out", options.folder, "write images and index.html here")->type_name("DIR")->required();
    app.add_option("--terrain", options.terrain, "draw this hill too: GeoTIFF, ESRI ASCII, …")
        ->type_name("DEM");
    app.add_flag(
        "--hold", options.hold,
        "stay, and draw again when a shader or texture changes, until Ctrl+C; the page reloads itself");
    add_size(app, options.size, "set the size of the images", "1280x720");
    add_gl(app, options.gl);
    add_memory(app, options.memory);
    add_step_options(app, options.step_options);
    app.footer(
        "Draws twenty views, and with --terrain one more: a valley at four times of day, a slide, its "
        "deposit,\n"
        "a landslide, two materials, a valley in summer with a slide, and a debris flow. The page has the\n"
        "time of each pass, the camera and the state hash.\n");
}

void add_bench(CLI::App& app, BenchOptions& options) {
    app.add_option(
           "recordings", options.recordings,
           "names from `couloir list`, or files [all shipped recordings; snow-avalanche with --scaling]")
        ->type_name("RECORDING");
    app.add_option_function<std::vector<std::string>>(
           "--grid",
           [&options](const std::vector<std::string>& lists) {
               options.squares = numbers_of("--grid", lists, kSquares);
           },
           described("set the resolution along the longer side; separate several by commas", kSquares,
                     "80,160; 40 to 2048 with --scaling"))
        ->type_name("N");
    app.add_option("--physics", options.physics,
                   fmt::format("run with these physics; separate several by commas: {} [all; the recording's "
                               "own with --scaling]",
                               bench_physics_names()))
        ->delimiter(',')
        ->check(
            [](const std::string& name) {
                return bench_physics_named(name)
                           ? ""
                           : fmt::format("'{}' is not one of: {}", name, bench_physics_names());
            },
            "")
        ->type_name("NAME");
    app.add_flag(
        "--scaling", options.scaling,
        "measure how the cost of each part grows with grid size and front length: one avalanche on a series "
        "of grids");
    add_number(app, "--repeats", "N", options.measure.repeats, Range<int>{1, 1000},
               "run each recording N times after a warm-up; ignored with --scaling", "3");
    add_number(app, "--ticks", "N", options.measure.ticks, Range<std::int64_t>{1, kTicks.most, "ticks"},
               "run at most N ticks of each recording", "all");
    add_number(app, "--every", "TICKS", options.measure.every, kStride,
               "draw a frame every so many ticks, 60 per simulated second", "120");
    add_size(app, options.canvas.size, "set the size of the frames", "640x360");
    add_number(
        app, "--samples", "N", options.canvas.samples, Range<int>{1, 2},
        "draw with so many samples along the edge of a pixel: 1 as in the tiers fast and balanced, 2 as in "
        "full",
        "1");
    app.add_flag(
        "--turn", options.canvas.turns,
        "turn the camera a little from frame to frame, so that all of each is new, and with one sample is "
        "drawn as the window draws a moving camera; else only what changed is drawn");
    add_gl(app, options.canvas.gl);
    app.add_flag_callback(
        "--no-render", [&options] { options.draws = false; }, "disable rendering");
    app.add_option("--perf", options.perf, "write one line per tick, or per table row with --scaling")
        ->type_name("FILE.csv");
    app.add_option("--summary", options.summary, "write the report as JSON, for --against")
        ->type_name("FILE.json");
    app.add_flag("--json", options.json, "print the report as JSON instead of tables");
    app.add_option("--page", options.page, "write tables and plots as one self-contained page")
        ->type_name("FILE.html");
    app.add_option("--trace", options.trace,
                   "write a trace of the last repeats for ui.perfetto.dev or chrome://tracing")
        ->type_name("FILE.json");
    app.add_option(
           "--against", options.against,
           "compare with an earlier report; exit with status 1 if a stage is slower by more than --tolerance")
        ->type_name("FILE.json");
    add_number(app, "--tolerance", "NUMBER", options.tolerance, Range<double>{1e-6, 1e6},
               "accept this relative increase in time", "0.25");
    add_memory(app, options.measure.memory);
    add_step_options(app, options.measure.step);
    app.footer(
        "Exit status 1 also if a recording does not end in its golden states, or if repeats differ. Such "
        "times are invalid.\n");
}

void add_list(CLI::App& app, ListOptions& options) {
    app.add_flag("--json", options.json, "print as JSON");
}

// "massif: a mountain side …", and a line for each of its numbers.
std::string described(const terrains::Generator& generator) {
    std::string text =
        fmt::format("\n{}: {}; {} squares\n", generator.name, generator.meaning, generator.squares);
    for (const auto& number : generator.numbers)
        text += fmt::format("  {:<20}{}, {} [{}]\n", number.name, number.meaning,
                            to_text(Range<double>{number.lowest, number.highest, number.unit}), number.usual);
    return text;
}

void add_generate(CLI::App& app, GenerateOptions& options) {
    app.add_option("generator", options.generator, terrains::generator_names())
        ->type_name("GENERATOR")
        ->required();
    app.add_option("--out", options.out, "write the heights, with snow or soil on top")
        ->type_name("FILE.tif|FILE.asc")
        ->required();
    app.add_option(
           "--layers", options.layers,
           "write into this folder what else the generator knows of the ground, on the same grid: cover.tif, "
           "and of massif hardness.tif, talus.tif and drainage.tif")
        ->type_name("DIR");
    add_number(app, "--seed", "N", options.seed,
               Range<std::uint64_t>{0, std::numeric_limits<std::uint64_t>::max()},
               "of massif: another seed, another mountain", "1");
    add_number(app, "--grid", "N", options.squares, kSquares, "squares along a side", "the generator's own");
    app.add_option("--set", options.settings, "set a parameter of the generator, as listed below")
        ->type_name("NAME=VALUE");
    app.add_flag("--json", options.json, "print what was made as JSON");
    std::string footer = "Parameters, with range and default:\n";
    for (const terrains::Generator& each : terrains::generators()) footer += described(each);
    app.footer(footer);
}

// Checks the options of `track` against each other and sets the defaults that depend on others.
Outcome<void> check(TrackOptions& options) {
    return complete(options.rule, options.scalar.has_value(), "--");
}

// Checks the options of `run` against each other and sets the defaults that depend on others.
Outcome<void> check_film(const OutputOptions& options) {
    if (!options.film.file && (options.film.view != FilmView::kScene || options.film.silent))
        return unusable("--silent, and a name for --camera, are of a film: add --video FILE.mp4");
    return {};
}

Outcome<void> check(RunOptions& options) {
    if (!options.scene.empty() && options.terrain)
        return unusable("run accepts a scene or --terrain DEM, not both");
    if (options.scene.empty() && !options.terrain)
        return unusable(
            "run needs a scene, or --terrain DEM with --release FILE; `couloir list` prints the scenes");
    if (options.accept_loss && !options.release)
        return unusable("--accept-loss needs --release FILE, of which something may be lost");
    if (options.terrain && !options.release)
        return unusable("--terrain needs --release FILE; without it no material would move");
    if (options.until_rest && options.until_still)
        return unusable("run accepts --until-rest or --until-still, not both");
    if (!options.until_rest && !options.until_still && !options.seconds)
        return unusable("run needs --until-rest, --until-still or --seconds S");
    if (options.iseesnow) {
        if (!options.export_folder) return unusable("--export-format needs --export DIR");
        if (!options.terrain)
            return unusable("--export-format iseesnow needs --terrain DEM, whose grid its files have");
        if (options.overrides.squares)
            return unusable(
                "--export-format iseesnow writes on the DEM's own grid, and a run with --grid has another "
                "one; "
                "leave out --grid");
        options.overrides.own_grid = true;
        if (!options.export_name) options.export_name = iseesnow_name(*options.release, *options.terrain);
    }
    if (options.export_name && !options.iseesnow)
        return unusable("--export-name needs --export-format iseesnow");
    if (options.export_name && !is_iseesnow_name(*options.export_name))
        return unusable(fmt::format(
            "--export-name: '{}' is not two parts of letters and digits, separated by one underscore",
            *options.export_name));
    return check_film(options);
}

Outcome<void> check(const ReplayOptions& options) {
    return check_film(options);
}

Outcome<void> check(const EnsembleOptions& options) {
    if (!options.folder && !options.member) return unusable("give --out DIR, or --member K");
    return {};
}

Outcome<void> check(const BenchOptions& options) {
    if (options.scaling && options.trace) return unusable("--trace cannot be used with --scaling");
    return {};
}

// A subcommand: adds its options, and returns what runs it with them.
struct Subcommand {
    const char* name;
    const char* help;
    std::function<std::function<Outcome<int>()>(CLI::App&)> add;
};

// `add` says which options it has. If there is a check() of them, it comes first.
template <class Options>
auto with(void (*add)(CLI::App&, Options&), Outcome<int> (*command)(const Options&)) {
    return [add, command](CLI::App& app) -> std::function<Outcome<int>()> {
        const auto options = std::make_shared<Options>();
        add(app, *options);
        return [options, command]() -> Outcome<int> {
            if constexpr (requires { check(*options); })
                if (const auto sound = check(*options); !sound) return tl::unexpected(sound.error());
            return command(*options);
        };
    };
}

// In the order of --help. The first one is run if none is named.
const auto& subcommands() {
    static const std::array kSubcommands{
        Subcommand{"play", "open the sandbox in a window (default without a subcommand)",
                   with(add_play, play)},
        Subcommand{"run", "run a scene or real terrain without a window", with(add_run, run)},
        Subcommand{"replay", "replay a recording bit for bit", with(add_replay, replay)},
        Subcommand{"share", "write a scene, a challenge or a recording as a web page that others play",
                   with(add_share, share)},
        Subcommand{
            "site",
            "write a folder for any web server: a page per scene and challenge, which installs as an app",
            with(add_site, site)},
        Subcommand{"list", "list the shipped scenes, materials, recordings and terrains",
                   with(add_list, list)},
        Subcommand{
            "track",
            "track discontinuities in your own velocity field; print where they cross mesh edges, as CSV",
            with(add_track, track)},
        Subcommand{
            "figures",
            "draw the paper's figures, with and without its method, and measure errors; exit status 1 if a "
            "tolerance is exceeded",
            with(add_figures, figures)},
        Subcommand{"gallery", "draw fixed views of the shipped scenes as a page, with the time of each pass",
                   with(add_gallery, gallery)},
        Subcommand{
            "compare",
            "compare two recordings on the same terrain: the difference at the end, and the first tick, "
            "stage, field and cell that differ",
            with(add_compare, compare)},
        Subcommand{"ensemble",
                   "run a world many times with other numbers, and map how likely it is that a place is hit",
                   with(add_ensemble, ensemble)},
        Subcommand{"release", "find where slabs of snow may let go on a mountain",
                   with(add_release, release)},
        Subcommand{"terrain", "make terrain: couloir terrain generate",
                   [](CLI::App& app) {
                       app.require_subcommand(1);
                       CLI::App* const generate = app.add_subcommand(
                           "generate", "make a mountain by a generator, as a file for a GIS and for scenes");
                       return with(add_generate, generate_terrain)(*generate);
                   }},
        Subcommand{"edit", "change one command of a recording, run it again, and compare the results",
                   with(add_edit, edit)},
        Subcommand{
            "normalise",
            "rewrite a recording in the newest format, with states computed by this version of the physics",
            with(add_normalise, normalise)},
        Subcommand{"bench",
                   "measure the time of recordings by stage, on several grids and with several physics",
                   with(add_bench, bench)},
        Subcommand{
            "verify-physics",
            "compare the solver with exact solutions: errors and orders; exit status 1 if a tolerance is "
            "exceeded",
            [](CLI::App&) { return verify_physics; }},
    };
    return kSubcommands;
}

}  // namespace

Outcome<int> run_command_line(int argc, char** argv) {
    CLI::App app{
        "Couloir: a sandbox for avalanches and landslides.\n"
        "Exit status: 0 success; 1 ran, but a check failed; 2 invalid arguments or input; 3 system failure "
        "(memory, disk, OpenGL).\n"
        "No output replaces an input or another output. Standard output is for what is printed: no other "
        "output\n"
        "may go there, unless it is a terminal or /dev/null. To pipe JSON, use --json.",
        "couloir"};
    app.set_version_flag("--version", fmt::format("{}, commit {}", kProgram, kCommit));
    app.get_formatter()->column_width(34);

    std::vector<std::pair<CLI::App*, std::function<Outcome<int>()>>> commands;
    for (const Subcommand& each : subcommands()) {
        CLI::App* const subcommand = app.add_subcommand(each.name, each.help);
        commands.emplace_back(subcommand, each.add(*subcommand));
    }

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        return app.exit(asked);
    } catch (const CLI::ParseError& wrong) {
        return unusable(
            fmt::format("{} (see couloir {}--help)", wrong.what(),
                        app.get_subcommands().empty() ? "" : app.get_subcommands()[0]->get_name() + " "));
    }
    for (const auto& [subcommand, command] : commands)
        if (subcommand->parsed()) return command();
    return commands.front().second();
}

}  // namespace game
