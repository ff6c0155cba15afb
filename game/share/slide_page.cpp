#include "game/share/slide_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "assets/shaders/slots.glsl"
#include "game/analysis/measures.h"
#include "game/analysis/summary.h"
#include "game/base/one_line.h"
#include "game/base/version.h"
#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/pages/table.h"
#include "game/recording/base64.h"
#include "game/recording/live_mark.h"
#include "game/recording/recorder.h"
#include "game/share/filled.h"
#include "game/share/in_order.h"
#include "game/share/packed_motion.h"
#include "game/share/packed_stream.h"
#include "game/share/puff_paths.h"
#include "game/share/scenery.h"
#include "game/share/scripts.h"
#include "render/frame/make_frame_block.h"
#include "render/frame/marks.h"
#include "render/mountain/bare_ground.h"
#include "render/mountain/drawn_mixture.h"
#include "render/mountain/height_range.h"
#include "render/mountain/overview.h"
#include "render/pictures/png.h"
#include "render/view/wind.h"

namespace game {
namespace {

namespace fs = std::filesystem;
using enum Packing::Predict;

constexpr int kPageFormat = 1;
constexpr double kDepthQuantum = 0.01, kSpeedQuantum = 0.125, kShareQuantum = 1.0 / 255;  // m, m/s
constexpr double kGroundQuantum = 0.01;                                                   // m
constexpr std::size_t kMostWaiting = 8,
                      kWaitingBytes = std::size_t{32} << 20;  // moments that wait to be packed
constexpr std::size_t kBytesAtOnce = std::size_t{4} << 20;    // kept in memory until they are compressed
constexpr int kWidth = 1280, kHeight = 720;  // of the picture whose uniforms the page begins with

// The program of the page, in the order in which it is joined.
constexpr std::array kScripts{"fields.js",  "camera.js",       "gpu.js",         "frame_block.js",
                              "shaders.js", "small_relief.js", "slide_tiles.js", "trees.js",
                              "debris.js",  "powder.js",       "cloud.js",       "scenery.js",
                              "draw.js",    "words.js",        "resolution.js",  "hands.js",
                              "live.js",    "lesson.js",       "page.js"};
constexpr const char* kModule = "couloir.wasm";  // and the program of the thread that it runs in
constexpr const char* kWorker = "live_worker.js";

// "1.5 MB", so that a small limit does not read 0.0 MB.
std::string size_text(std::uint64_t bytes) {
    if (bytes < 1000) return fmt::format("{} bytes", bytes);
    const auto size = static_cast<double>(bytes);
    return bytes < 1'000'000 ? fmt::format("{:.1f} kB", size / 1e3) : fmt::format("{:.1f} MB", size / 1e6);
}

// The files of assets/web and assets/shaders that make a page.
struct PageFiles {
    std::string frame, style, program;
    Json shaders = Json::object();                            // text by name: those that the program names
    std::vector<std::uint32_t> tree_pictures, trees_in_leaf;  // the latter if a day of the year is stated
    std::string module, worker;                               // of a page that plays
};

// The pictures of trees without their largest level, one number per texel, lowest row first: 4, 4 and 5 bits of its parts.
Outcome<std::vector<std::uint32_t>> read_tree_pictures(const fs::path& file) {
    const auto texels = render::read_png(file, 3);
    if (!texels) return machine_fails(texels.error());
    std::vector<std::uint32_t> pictures;
    int above = texels->height;  // the levels are below each other, the largest on top
    for (int level = 0; level < TREE_LEVELS; ++level) {
        const int width = TREE_COLUMNS * TREE_TILE_WIDTH >> level,
                  height = TREE_ROWS * TREE_TILE_HEIGHT >> level;
        above -= height;
        if (level < TREE_FINEST_IN_PAGES) continue;
        for (int y = above; y < above + height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::uint8_t* texel =
                    &texels
                         ->values[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(texels->width) +
                                       static_cast<std::size_t>(x))];
                const auto part = [&](int i, unsigned most) { return (texel[i] * most + 127u) / 255u; };
                pictures.push_back(part(0, 15) << 9 | part(1, 15) << 5 | part(2, 31));
            }
    }
    return pictures;
}

Outcome<PageFiles> read_page_files(bool plays, bool has_date) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    PageFiles files;
    const auto read = [&](const char* name, std::string& into) -> Outcome<void> {
        auto text = read_text(*assets / "web" / name);
        if (!text) return tl::unexpected(text.error());
        into += *text;
        return {};
    };
    if (auto done = read("page.html", files.frame); !done) return tl::unexpected(done.error());
    if (auto done = read("page.css", files.style); !done) return tl::unexpected(done.error());
    for (const char* name : kScripts)
        if (auto done = read(name, files.program); !done) return tl::unexpected(done.error());
    if (plays) {
        if (auto done = read(kModule, files.module); !done) return tl::unexpected(done.error());
        if (auto done = read(kWorker, files.worker); !done) return tl::unexpected(done.error());
        if (files.module.find(kLiveMark) == std::string::npos)
            return machine_fails(
                fmt::format("{}: computes another version of the physics than this program; renew it with "
                            ".ci/wasm --renew, or use --watch-only",
                            (*assets / "web" / kModule).string()));
    }
    std::map<std::string, fs::path> shaders;  // in one order everywhere
    for (const fs::path& path : page_assets()) {
        const std::string name = path.filename().string(), kind = path.extension().string();
        if ((kind == ".glsl" || kind == ".vert" || kind == ".frag") &&
            files.program.find("'" + name + "'") != std::string::npos)
            shaders[name] = path;
    }
    for (const auto& [name, path] : shaders) {
        auto text = read_text(path);
        if (!text) return tl::unexpected(text.error());
        files.shaders[name] = std::move(*text);
    }
    auto pictures = read_tree_pictures(*assets / "textures" / "conifers.png");
    if (!pictures) return tl::unexpected(pictures.error());
    files.tree_pictures = std::move(*pictures);
    if (!has_date) return files;
    auto in_leaf = read_tree_pictures(*assets / "textures" / "trees-in-leaf.png");
    if (!in_leaf) return tl::unexpected(in_leaf.error());
    files.trees_in_leaf = std::move(*in_leaf);
    return files;
}

Json camera_json(const render::Camera& camera) {
    return {{"target", {camera.target.x, camera.target.y, camera.target.z}},
            {"azimuth_deg", camera.azimuth_deg},
            {"elevation_deg", camera.elevation_deg},
            {"distance_m", camera.distance_m},
            {"field_of_view_deg", camera.field_of_view_deg}};
}

Json colour_json(const glm::vec3& colour) {
    return {colour.r, colour.g, colour.b};
}

// Where the grid's corners are on Earth: south-west, south-east, north-west, north-east. Null if unknown.
Json place_json(const Scenario& scenario) {
    const terrains::Georeference& earth = scenario.georeference;
    if (!earth.placed()) return nullptr;
    const double east = (scenario.grid.nx - 1) * static_cast<double>(scenario.grid.dx),
                 north = (scenario.grid.ny - 1) * static_cast<double>(scenario.grid.dx);
    Json corners = Json::array();
    for (const terrains::LocalPoint corner :
         {terrains::LocalPoint{0, 0}, {east, 0}, {0, north}, {east, north}}) {
        const auto place = earth.to_lat_lon(corner);
        if (!place) return nullptr;
        corners.push_back({place->latitude, place->longitude});
    }
    return {{"corners", std::move(corners)}, {"south_west", earth.describe({0, 0})}};
}

Json stops_json(std::span<const render::LegendStop> stops) {
    Json json = Json::array();
    for (const render::LegendStop& stop : stops)
        json.push_back({stop.value, stop.colour.r, stop.colour.g, stop.colour.b});
    return json;
}

// Change of the standing layer: red where it was eroded, blue where more lies (ColorBrewer RdBu, as the maps of
// `compare`).
constexpr std::array<render::LegendStop, 8> kChange{{{-2, {0.698f, 0.094f, 0.169f}},
                                                     {-0.5f, {0.839f, 0.376f, 0.302f}},
                                                     {-0.1f, {0.957f, 0.647f, 0.510f}},
                                                     {-0.03f, {0.992f, 0.859f, 0.780f}},
                                                     {0.03f, {0.820f, 0.898f, 0.941f}},
                                                     {0.1f, {0.573f, 0.773f, 0.871f}},
                                                     {0.5f, {0.263f, 0.576f, 0.765f}},
                                                     {2, {0.129f, 0.400f, 0.675f}}}};

Json overlays_json() {
    const auto of = [](const char* key, const char* name, const char* field, render::Overlay overlay) {
        const render::Legend legend = render::legend_of(overlay);
        return Json{{"key", key},
                    {"name", name},
                    {"field", field},
                    {"unit", legend.unit},
                    {"stepped", legend.stepped},
                    {"stops", stops_json(legend.stops)}};
    };
    return {of("speed", "Speed", "s", render::Overlay::kSpeed),
            of("moving", "Moving depth", "R", render::Overlay::kRolling),
            of("lying", "Lying depth", "d", render::Overlay::kStanding),
            Json{{"key", "change"},
                 {"name", "Change of the lying layer"},
                 {"field", "change"},
                 {"unit", "m"},
                 {"stepped", false},
                 {"stops", stops_json(kChange)}},
            of("peak_depth", "Greatest depth", "peak_depth", render::Overlay::kRolling),
            of("peak_speed", "Greatest speed", "peak_speed", render::Overlay::kSpeed)};
}

// Whether trees may come to stand in a page that has none.
bool may_plant(const Scenario& scenario, const PageOptions& options) {
    const auto plants = [](const Goal::Tool& tool) { return tool.kind == sim::CommandKind::kPlant; };
    return options.plays && !scenario.model &&
           (!scenario.goal || std::ranges::any_of(scenario.goal->tools, plants));
}

// A slide in a line: material, time, how far, how fast. Of a world in which nothing happened, its material.
std::string about(const Scenario& scenario, const Measures& measures, double seconds) {
    std::string words = asset_title(AssetKind::kMaterial, scenario.material);
    if (scenario.lower) words += " on " + asset_title(AssetKind::kMaterial, scenario.lower->material);
    if (seconds > 0) words += fmt::format(", {} s", grouped(seconds));
    if (measures.run_out > 0)
        words += fmt::format(", run-out {} m, up to {} m/s", grouped(measures.run_out),
                             grouped(measures.peak_speed_slope, 1));
    return words;
}

std::vector<double> to_doubles(std::span<const float> values) {
    return {values.begin(), values.end()};
}

// What a page takes of a world at a tick.
struct Moment {
    static constexpr std::size_t kPerVertex = 28;  // bytes, about

    std::int64_t tick = 0;
    double volume = 0;                         // m³ that move
    std::vector<float> depth, rolling, speed;  // per vertex, row 0 the south
    std::vector<std::uint8_t> mixture;         // as drawn_mixture() makes it
    std::vector<float> peak_depth, peak_speed;
    std::vector<sim::powder::Puff> puffs;
    render::Structures structures;
    std::vector<sim::Stems> forest;  // per vertex, if there is any at tick 0; else none

    Moment(const Session& session, bool has_forest)
        : tick(session.state().tick),
          volume(session.cubic_metres(session.state().ledger.rolling)),
          peak_depth(session.peaks().depth),
          peak_speed(session.peaks().speed_plan),
          puffs(session.powder().begin(), session.powder().end()),
          structures(session.structures()) {
        const sim::View world = session.view();
        const auto nx = static_cast<std::size_t>(world.grid.nx);
        for (std::vector<float>* field : {&depth, &rolling, &speed}) field->resize(world.grid.size());
        for (int y = 0; y < world.grid.ny; ++y) {
            const std::size_t row = static_cast<std::size_t>(y) * nx;
            const float *d = world.depth.row(y), *r = world.rolling.row(y), *vx = world.velocity_x.row(y),
                        *vy = world.velocity_y.row(y);
            for (std::size_t x = 0; x < nx; ++x) {
                depth[row + x] = d[x];
                rolling[row + x] = r[x];
                speed[row + x] = r[x] >= Peaks::kVisible ? std::sqrt(vx[x] * vx[x] + vy[x] * vy[x]) : 0.f;
            }
        }
        render::drawn_mixture(world, mixture);
        if (!has_forest) return;
        for (int y = 0; y < world.grid.ny; ++y)
            forest.insert(forest.end(), world.things->forest.row(y), world.things->forest.row(y) + nx);
    }

    // Shares of the lower material: 0 at the surface of the standing layer, 1 in the rolling layer.
    std::vector<float> shares(std::size_t which) const {
        std::vector<float> shares(mixture.size() / 2);
        for (std::size_t i = 0; i < shares.size(); ++i)
            shares[i] = static_cast<float>(mixture[2 * i + which]) * static_cast<float>(kShareQuantum);
        return shares;
    }
};

// Whether something is so of the things at any vertex.
template <class Is>
bool any_of(const sim::State& state, const Is& is) {
    if (!state.things) return false;
    for (int y = 0; y < state.grid.ny; ++y)
        for (int x = 0; x < state.grid.nx; ++x)
            if (is(*state.things, x, y)) return true;
    return false;
}

std::vector<double> by_vertex(const sim::Field<float>& field) {
    std::vector<double> values;
    for (int y = 0; y < field.ny(); ++y) values.insert(values.end(), field.row(y), field.row(y) + field.nx());
    return values;
}

// What a page cannot show of the things of a world; nothing if it shows all. Its ground is that of tick 0, and its trees only
// fall.
std::optional<std::string> beyond_pages(const sim::State& first, const sim::State& now) {
    if (!now.things) return std::nullopt;
    for (int y = 0; y < now.grid.ny; ++y)
        for (int x = 0; x < now.grid.nx; ++x) {
            if (now.things->earth(x, y) != (first.things ? first.things->earth(x, y) : 0))
                return "ground that is sculpted during the slide";
            const sim::Stems stems = now.things->forest(x, y);
            const sim::Stems begun = first.things ? first.things->forest(x, y) : sim::Stems();
            if (stems.standing + stems.lying > begun.standing + begun.lying)
                return "forest that is planted during the slide";
        }
    return std::nullopt;
}

}  // namespace

struct SlidePage::Parts {
    const Scenario& scenario;
    std::string proof;
    PageOptions options;
    PageFiles files;
    render::Camera camera;
    render::FrameBlock frame{};
    const sim::State first;  // at tick 0
    render::BareGround bare_ground;
    std::int64_t given = -1;           // tick of the last moment that was given
    std::int64_t things_changed = -1;  // as in the state of the last moment
    const bool has_forest, has_earth;  // at tick 0
    std::optional<Scenery> scenery;
    PackedStream stream;
    PackedMotion depth, rolling, speed, lower_depth, lower_rolling;
    PuffPaths puffs;
    std::int64_t frames = 0, last_tick = 0;
    std::vector<double> volumes;  // m³ that move, by frame
    double ground_quantum = 0;
    Json lesson;                    // null: none
    std::vector<StateLine> states;  // of the recording of a page that plays
    InOrder packing;                // last, because its thread uses the others

    Parts(const Scenario& of, const sim::State& at_first, std::string with_proof, const PageOptions& with)
        : scenario(of),
          proof(std::move(with_proof)),
          options(with),
          first(at_first),
          has_forest(any_of(first,
                            [](const sim::Things& things, int x, int y) {
                                return things.forest(x, y).standing + things.forest(x, y).lying > 0;
                            })),
          has_earth(
              any_of(first, [](const sim::Things& things, int x, int y) { return things.earth(x, y) != 0; })),
          depth("d", of.grid.nx, of.grid.ny, kDepthQuantum),
          rolling("R", of.grid.nx, of.grid.ny, kDepthQuantum),
          speed("s", of.grid.nx, of.grid.ny, kSpeedQuantum),
          lower_depth("lower_d", of.grid.nx, of.grid.ny, kShareQuantum),
          lower_rolling("lower_R", of.grid.nx, of.grid.ny, kShareQuantum),
          packing(std::clamp<std::size_t>(kWaitingBytes / (Moment::kPerVertex * of.grid.size()), 1,
                                          kMostWaiting)) {}

    // The world at tick 0 on the ground of the page, which has no buildings: they are drawn by their mesh.
    sim::View at_first() {
        const sim::View w = sim::view(first);
        const sim::Field<float>* ground = bare_ground.find(w);
        return ground ? sim::on_bedrock(w, *ground) : w;
    }

    std::vector<PackedMotion*> moving() {
        std::vector<PackedMotion*> all{&depth, &rolling, &speed};
        if (scenario.lower) all.insert(all.end(), {&lower_depth, &lower_rolling});
        return all;
    }

    Outcome<void> beyond(const PackedMotion& motion, const std::string& fact) const {
        const char* what = &motion == &speed ? "a speed, m/s" : "a depth, m";
        return unusable(fmt::format(
            "--web: at {:.1f} s there is {} of {}",
            static_cast<double>(last_tick) * static_cast<double>(scenario.params.tick_s), what, fact));
    }

    // The state lines of a recording, the last one once.
    void keep_state(const Session& session) {
        if (!options.plays) return;
        if (states.empty() || states.back().tick != session.state().tick)
            states.push_back(session.state_line());
    }

    Outcome<void> check_things(const sim::State& now) {
        if (!now.things || now.things->changed == things_changed) return {};
        things_changed = now.things->changed;
        if (const auto what = beyond_pages(first, now))
            return unusable(fmt::format("--web: a page cannot show {} yet; --frames draws it", *what));
        return {};
    }

    // Has a moment packed, after all before it, while the world goes on.
    template <class Pack>
    Outcome<void> give(const Session& session, const Pack& pack) {
        if (auto shown = check_things(session.state()); !shown) return shown;
        given = session.state().tick;
        return packing.give(
            [pack, moment = std::make_shared<const Moment>(session, has_forest)] { return pack(*moment); });
    }
    Outcome<void> pack_start(const Moment& moment);
    Outcome<void> add_frame(const Moment& moment);
    Outcome<void> flush();
    std::uint64_t bytes_so_far() const;
    std::string title() const {
        return lesson.is_null() ? scenario.title : lesson["title"].get<std::string>();
    }
    Json info(const Session& session, std::span<const TimedCommand> commands) const;
    Outcome<std::string> recording(std::span<const TimedCommand> commands) const;
    Outcome<std::pair<std::string, Json>> world(std::span<const TimedCommand> commands) const;
};

// What is known before the first frame.
Outcome<void> SlidePage::Parts::pack_start(const Moment& moment) {
    scenery.emplace(scenario, at_first(), moment.structures, frame);
    frame = scenery->frame();
    ground_quantum =
        stream.add("bed", by_vertex(at_first().bedrock), {kGroundQuantum, 2, kPlane}, scenario.grid.nx);
    if (has_earth)
        stream.add("earth", by_vertex(first.things->earth), {kGroundQuantum, 2, kPlane}, scenario.grid.nx);
    std::vector<double> holes;
    for (const std::uint8_t known : scenario.has_data) holes.push_back(known ? 0 : 1);
    stream.add("site", holes, {1, 1, kNone});
    if (auto begun = depth.begin_with(moment.depth); !begun) return beyond(depth, begun.error());
    stream.add("d0", depth.quanta(), 0, depth.step(), 2, kPlane, scenario.grid.nx);
    if (scenario.lower) {
        if (auto begun = lower_depth.begin_with(moment.shares(0)); !begun)
            return beyond(lower_depth, begun.error());
        stream.add("lower0", lower_depth.quanta(), 0, lower_depth.step(), 1, kPlane, scenario.grid.nx);
    }
    scenery->pack(stream);
    if (scenery->has_trees() || may_plant(scenario, options)) {
        stream.add("trees.pictures", files.tree_pictures, 0, 1, 2, kNone);
        if (!files.trees_in_leaf.empty()) stream.add("trees.in_leaf", files.trees_in_leaf, 0, 1, 2, kNone);
    }
    stream.add("files", std::string_view(files.shaders.dump()));
    return {};
}

Outcome<void> SlidePage::Parts::add_frame(const Moment& moment) {
    last_tick = moment.tick;
    const auto add = [&](PackedMotion& motion, const std::vector<float>& values) -> Outcome<void> {
        if (auto added = motion.add(values); !added) return beyond(motion, added.error());
        return {};
    };
    if (auto added = add(depth, moment.depth); !added) return added;
    if (auto added = add(rolling, moment.rolling); !added) return added;
    if (auto added = add(speed, moment.speed); !added) return added;
    if (scenario.lower) {
        if (auto added = add(lower_depth, moment.shares(0)); !added) return added;
        if (auto added = add(lower_rolling, moment.shares(1)); !added) return added;
    }
    volumes.push_back(moment.volume);
    puffs.see(moment.puffs, moment.tick, static_cast<double>(scenario.params.tick_s));
    scenery->see({moment.peak_depth, moment.peak_speed}, moment.forest, moment.structures, frames);
    ++frames;
    std::size_t waiting = 0;
    for (const PackedMotion* motion : moving()) waiting += motion->waiting();
    return waiting >= kBytesAtOnce ? flush() : Outcome<void>();
}

Outcome<void> SlidePage::Parts::flush() {
    for (PackedMotion* motion : moving()) motion->flush(stream);
    if (bytes_so_far() > options.most_bytes)
        return unusable(
            fmt::format("--web: after {:.0f} s of the slide the page is larger than {}. Use a larger "
                        "--every or --size-limit",
                        static_cast<double>(last_tick) * static_cast<double>(scenario.params.tick_s),
                        size_text(options.most_bytes)));
    return {};
}

std::uint64_t SlidePage::Parts::bytes_so_far() const {
    return files.frame.size() + files.style.size() + files.program.size() + (stream.compressed() + 2) / 3 * 4;
}

Json SlidePage::Parts::info(const Session& session, std::span<const TimedCommand> commands) const {
    const Measures measures = measure(scenario, session, release_area(scenario, commands), {});
    const Json summary = to_json(Summary{scenario, session, measures, nullptr, std::nullopt, std::nullopt});
    const glm::vec2 wind = render::velocity(scenario.wind);
    const auto look = [](const render::PowderLook& powder) {
        return Json{
            {"strength", powder.strength}, {"speed", powder.speed}, {"colour", colour_json(powder.colour)}};
    };
    const std::string block = to_base64({reinterpret_cast<const char*>(&frame), sizeof frame});
    const auto quanta = [](const PackedMotion& motion) { return Json{{"zero", 0}, {"step", motion.step()}}; };
    Json moves{{"d", quanta(depth)}, {"R", quanta(rolling)}, {"s", quanta(speed)}};
    if (scenario.lower) {
        moves["lower_d"] = quanta(lower_depth);
        moves["lower_R"] = quanta(lower_rolling);
    }
    Json json{{"format", kPageFormat},
              {"program", kProgram},
              {"title", title()},
              {"about",
               about(scenario, measures, static_cast<double>(last_tick) * shortest(scenario.params.tick_s))},
              {"scene", scenario.scene},
              {"material", scenario.material},
              {"terrain", scenario.terrain},
              {"licence", scenario.licence},
              {"grid",
               {{"nx", scenario.grid.nx},
                {"ny", scenario.grid.ny},
                {"dx", static_cast<double>(scenario.grid.dx)},
                {"datum", scenario.datum}}},
              {"georeference", place_json(scenario)},
              {"tick_s", shortest(scenario.params.tick_s)},
              {"every", options.every},
              {"last", last_tick},
              {"frames", frames},
              {"error",
               {{"ground", ground_quantum / 2},
                {"depth", depth.most_error()},
                {"moving", rolling.most_error()},
                {"speed", speed.most_error()}}},
              {"parts", stream.parts()},
              {"arrays", stream.arrays()},
              {"moving", std::move(moves)},
              {"hash", hex(session.state_line().hash)},
              {"command", proof},
              {"measures", summary["measures"]},
              {"mass", summary["mass"]},
              {"volume", volumes},
              {"camera", camera_json(camera)},
              {"frame", block},
              {"texture", scenario.look.flow ? Json(to_string(scenario.look.flow->pattern)) : Json(nullptr)},
              {"wind", {wind.x, wind.y}},  // where it blows to, m/s
              {"powder", look(scenario.look.powder)},
              {"lower_powder", look(scenario.look.lower_powder)},
              {"overlays", overlays_json()},
              {"two", scenario.lower.has_value()},
              {"surroundings", !scenery->surroundings().empty()}};
    if (scenario.goal) {
        json["goal"] = {{"say", with_signs(scenario.goal->say)}};
        if (options.to_beat) {
            json["goal"]["to_beat"] = options.to_beat->score.points;
            json["goal"]["ghost_step"] = RunExtent::kStep;
        }
    }
    if (!lesson.is_null()) json["lesson"] = lesson;
    if (scenario.lower) json["lower_material"] = scenario.lower->material;
    if (options.site_name) json["site"] = {{"index", "index.html"}, {"name", *options.site_name}};
    return json;
}

// The slide as a recording, from its own states.
Outcome<std::string> SlidePage::Parts::recording(std::span<const TimedCommand> commands) const {
    Header header;
    header.scenario = scenario;
    auto recorder = Recorder::create(in_memory(scenario.scene), header);
    if (!recorder) return tl::unexpected(recorder.error());
    auto command = commands.begin();
    for (const StateLine& state : states) {
        // A command applies at the start of its tick, so it follows that tick's state line.
        for (; command != commands.end() && command->tick < state.tick; ++command)
            if (auto written = recorder->command(*command); !written) return tl::unexpected(written.error());
        if (auto written = recorder->state(state); !written) return tl::unexpected(written.error());
    }
    return recorder->copy_ended_at(states.back().tick, nullptr);
}

// What a page that plays has besides: module, program of its thread and recording, and how they follow each other.
Outcome<std::pair<std::string, Json>> SlidePage::Parts::world(std::span<const TimedCommand> commands) const {
    if (!options.plays) return std::pair(std::string(), Json(nullptr));
    const auto text = recording(commands);
    if (!text) return tl::unexpected(text.error());
    PackedStream packed;
    packed.add("module", std::string_view(files.module));
    packed.add("worker", std::string_view(files.worker));
    packed.add("recording", std::string_view(*text));
    std::string bytes = to_base64(packed.finish());
    return std::pair(std::move(bytes), Json{{"name", one_line(scenario.scene)}, {"parts", packed.parts()}});
}

SlidePage::SlidePage(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SlidePage::~SlidePage() = default;
SlidePage::SlidePage(SlidePage&&) noexcept = default;
SlidePage& SlidePage::operator=(SlidePage&&) noexcept = default;

Outcome<SlidePage> SlidePage::begin(const Scenario& scenario, const Session& session, std::string proof,
                                    const PageOptions& options) {
    if (scenario.flow)
        return unusable(fmt::format(
            "--web: {} shows how fronts are tracked and has no slide; --frames draws it", scenario.scene));
    auto files = read_page_files(options.plays, scenario.look.date.has_value());
    if (!files) return tl::unexpected(files.error());
    const sim::View world = session.view();
    auto parts = std::make_unique<Parts>(scenario, session.state(), std::move(proof), options);
    parts->files = std::move(*files);
    parts->camera = options.camera    ? *options.camera
                    : scenario.camera ? *scenario.camera
                    : scenario.model  ? render::overview(world)
                                      : render::landscape_view(world);
    render::FrameInput input{.world = world,
                             .camera = parts->camera,
                             .light = scenario.light,
                             .look = scenario.look,
                             .width = kWidth,
                             .height = kHeight,
                             .first_depth = scenario.depth,
                             .undisturbed = session.undisturbed()};
    parts->frame = render::make_frame_block(input, render::height_range(world), 1, std::nullopt);
    parts->keep_state(session);
    auto given = parts->give(session, [p = parts.get()](const Moment& moment) -> Outcome<void> {
        if (auto packed = p->pack_start(moment); !packed) return packed;
        return p->add_frame(moment);
    });
    if (!given) return tl::unexpected(given.error());
    return SlidePage(std::move(parts));
}

Outcome<void> SlidePage::see(const Session& session) {
    if (session.state().tick % kTicksPerState == 0) parts_->keep_state(session);
    if (session.state().tick % parts_->options.every != 0) return {};
    return parts_->give(session, [p = parts_.get()](const Moment& moment) { return p->add_frame(moment); });
}

void SlidePage::set_lesson(Json lesson) {
    parts_->lesson = std::move(lesson);
}

Outcome<PageReport> SlidePage::write(const fs::path& file, const Session& session,
                                     std::span<const TimedCommand> commands) {
    return make(session, commands).and_then([&](MadePage&& page) -> Outcome<PageReport> {
        if (auto written = write_text(file, page.text); !written) return tl::unexpected(written.error());
        return std::move(page.report);
    });
}

Outcome<MadePage> SlidePage::make(const Session& session, std::span<const TimedCommand> commands) {
    Parts& p = *parts_;
    p.keep_state(session);
    if (session.state().tick != p.given)
        if (auto given = p.give(session, [&p](const Moment& moment) { return p.add_frame(moment); }); !given)
            return tl::unexpected(given.error());
    if (auto packed = p.packing.finish(); !packed) return tl::unexpected(packed.error());
    if (auto flushed = p.flush(); !flushed) return tl::unexpected(flushed.error());
    const auto add_peak = [&](const char* name, const std::vector<float>& peak, double step) {
        p.stream.add(name, to_doubles(peak), {step, 2, kPlane}, p.scenario.grid.nx);
    };
    add_peak("peak_depth", session.peaks().depth, kDepthQuantum);
    add_peak("peak_speed", session.peaks().speed_plan, kSpeedQuantum);
    if (p.options.to_beat) {  // steps from 1 on; 0: never
        std::vector<double> steps;
        for (const RunExtent::Step step : p.options.to_beat->extent.reached())
            steps.push_back(step == RunExtent::kNever ? 0 : step + 1);
        p.stream.add("ghost", steps, {1, 2, kPlane}, p.scenario.grid.nx);
    }
    p.scenery->pack_ends(p.stream, p.at_first(), p.frames);
    p.puffs.pack(p.stream);
    const std::string fields = to_base64(p.stream.finish());

    const auto world = p.world(commands);
    if (!world) return tl::unexpected(world.error());
    Json info = p.info(session, commands);
    info["live"] = world->second;
    const std::string title = html_text(one_line(p.title())), slide = in_script(info);
    const std::string frame = filled(p.files.frame, {{"@PROGRAM@", p.files.program}}),
                      scripts = names_of_scripts(frame);
    const std::string_view policy =
        p.options.plays ? " 'wasm-unsafe-eval'; worker-src blob:" : std::string_view();
    std::string page = filled(frame, {{"@TITLE@", title},
                                      {"@SCRIPTS@", scripts},
                                      {"@POLICY@", policy},
                                      {"@WORLD@", world->first},
                                      {"@STYLE@", p.files.style},
                                      {"@SLIDE@", slide},
                                      {"@FIELDS@", fields}});
    if (page.size() > p.options.most_bytes)
        return unusable(
            fmt::format("--web: the page has {}, and {} are allowed. Use a larger --every or --size-limit",
                        size_text(page.size()), size_text(p.options.most_bytes)));
    const std::uint64_t bytes = page.size();
    return MadePage{std::move(page), {bytes, p.frames, {}, info["about"]}};
}

}  // namespace game
