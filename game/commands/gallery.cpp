#include <chrono>
#include <map>
#include <thread>

#include <fmt/format.h>

#include "game/analysis/headless.h"
#include "game/base/print.h"
#include "game/base/process.h"
#include "game/base/version.h"
#include "game/commands/commands.h"
#include "game/figures/gallery_page.h"
#include "game/figures/gallery_views.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/recording/format.h"
#include "game/scene/mountains.h"
#include "game/session/loaded_world.h"
#include "render/frame.h"
#include "render/mountain/overview.h"

namespace game {
namespace {

constexpr const char* kNoTerrain = "There is no view of a real hill, because there is no --terrain.";
constexpr int kReloadSeconds = 2;  // of the page in a browser, while the program holds
constexpr std::chrono::milliseconds kLookEvery{500};

using Scenes = std::map<std::string, Scene>;

Outcome<Scenes> load_scenes(const GalleryOptions& options, std::span<const GalleryView> views) {
    Overrides overrides;
    overrides.memory = options.memory;
    overrides.memory.use.draws = true;
    // At most: the state that each view keeps is smaller than a session.
    overrides.memory.use.sessions = static_cast<int>(views.size());
    overrides.memory.use.frames = {options.size.width, options.size.height};
    Scenes scenes;
    for (const GalleryView& view : views) {
        const std::string name = view.scene;
        if (scenes.contains(name)) continue;
        auto scene = name.empty() ? scene_of_terrain(*options.terrain, std::nullopt, overrides)
                                  : load_scene(name, overrides);
        if (!scene) return tl::unexpected(scene.error());
        if (name.empty()) scene->scenario.trees = woods_of_hill(scene->scenario);
        scenes.emplace(name, std::move(*scene));
    }
    return scenes;
}

// The world of a scene, which all views of the scene share.
struct World {
    const Scene* scene;
    Session session;
    Backdrop backdrop;
};
using Worlds = std::map<std::string, World>;

// A view and the state of its world, so that it can be drawn again without simulating.
struct Moment {
    GalleryView view;
    World* world;
    Session::Checkpoint state;
    bool still_moving;
};

Outcome<Worlds> begin_worlds(const Scenes& scenes, const GalleryOptions& options) {
    Worlds worlds;
    for (const auto& [name, scene] : scenes) {
        auto session = Session::begin(scene.scenario, options.step_options, std::nullopt);
        if (!session) return tl::unexpected(session.error());
        session->follow_fronts(scene.scenario);
        session->follow_powder(scene.scenario);
        session->follow_carried(scene.scenario);
        auto backdrop = backdrop_of(scene.scenario);
        if (const std::string notice = woods_notice(scene.scenario, backdrop.woods); !notice.empty())
            print_line(stderr, "couloir: {}", notice);
        worlds.emplace(name, World{&scene, std::move(*session), std::move(backdrop)});
    }
    return worlds;
}

// Simulates each world to the tick of each of its views.
Outcome<std::vector<Moment>> simulate(std::span<const GalleryView> views, Worlds& worlds) {
    std::vector<Moment> moments;
    for (const GalleryView& view : views) {
        World& world = worlds.at(view.scene);
        const std::vector<TimedCommand>& commands = world.scene->commands;
        const std::int64_t last_command = commands.empty() ? 0 : commands.back().tick;
        const Until until = view.tick ? Until::after(*view.tick) : Until::still(last_command);
        const auto stopped = play_headless(world.session, commands, until, {}, world.scene->scenario.scene);
        if (!stopped) return tl::unexpected(stopped.error());
        moments.push_back({view, &world, world.session.moment(), *stopped == Ended::kLimit});
    }
    return moments;
}

// Compiles the shaders of the assets and loads what the scenes need.
Outcome<render::Renderer> make_renderer(const std::filesystem::path& assets, const Scenes& scenes) {
    auto renderer = render::Renderer::create(assets);
    if (!renderer) return machine_fails(renderer.error());
    for (const auto& [name, scene] : scenes)
        if (auto loaded = renderer->load(scene.scenario.look, scene.scenario.lower.has_value()); !loaded)
            return machine_fails(loaded.error());
    // Nothing else runs in this process while a frame is drawn, so that processor time is the frame's own.
    renderer->time_stages(render::comparable_timing());
    return std::move(*renderer);
}

// Draws all of `input` twice, so that the second frame has no first-time costs, and returns the times of that one.
render::DrawTimes timed(render::Renderer& renderer, const render::FrameInput& input,
                        render::Quality quality) {
    renderer.set_quality(quality);
    renderer.draw(input);
    renderer.forget();
    renderer.draw(input);
    return *renderer.stage_times();
}

// Draws one view and writes its image. The files of all views are fine, and drawn last.
Outcome<DrawnView> draw(render::Renderer& renderer, const Moment& moment, const GalleryOptions& options) {
    Session& session = moment.world->session;
    if (auto gone = session.go_to(moment.state); !gone) return tl::unexpected(gone.error());
    const Scenario& scenario = moment.world->scene->scenario;
    const render::Camera own =
        scenario.camera ? *scenario.camera : render::overview(sim::view(session.state()));
    DrawnView drawn;
    drawn.file = fmt::format("{}.png", moment.view.name);
    drawn.title = moment.view.title;
    drawn.scene = scenario.scene;
    drawn.tick = session.state().tick;
    drawn.still_moving = moment.still_moving;
    drawn.state_hash = hex(session.state_line().hash);
    drawn.camera = moment.view.camera.value_or(own);
    drawn.light = moment.view.light;
    render::Look look = scenario.look;
    if (moment.view.date) look.date = moment.view.date;
    const render::FrameInput input{
        .world = session.view(),
        .camera = drawn.camera,
        .light = drawn.light,
        .look = look,
        .flow = session.fronts(),
        .width = options.size.width,
        .height = options.size.height,
        .first_depth = scenario.depth,
        .surroundings = scenario.model ? nullptr : &moment.world->backdrop.mountains,
        .land = &moment.world->backdrop.land,
        .powder = session.powder(),
        .carried = session.carried(),
        .woods = &moment.world->backdrop.woods,
        .flow_so_far = session.flow_so_far(),
        .structures = &session.structures(),
        .wind = scenario.wind,
        .seconds = session.seconds()};
    drawn.moving = timed(renderer, input, render::Quality::kMoving);
    drawn.fast = timed(renderer, input, render::Quality::kFast);
    drawn.fine = timed(renderer, input, render::Quality::kFine);
    if (auto written = render::write_png(renderer.read_back(), options.folder / drawn.file); !written)
        return machine_fails(written.error());
    return drawn;
}

std::filesystem::path page_of(const GalleryOptions& options) {
    return options.folder / "index.html";
}

// Draws all views, with their images, and then the page. If interrupted it leaves the last page.
Outcome<void> draw_page(render::Renderer& renderer, std::span<const Moment> moments,
                        const std::string& renderer_name, const GalleryOptions& options) {
    std::vector<DrawnView> all;
    for (const Moment& moment : moments) {
        if (interrupted()) return {};
        auto drawn = draw(renderer, moment, options);
        if (!drawn) return tl::unexpected(drawn.error());
        all.push_back(std::move(*drawn));
        print_line(stderr, "couloir: {} of {}: {}", all.size(), moments.size(), moment.view.title);
    }
    const render::DrawnBy drawn_by{renderer_name,
                                   fmt::format("{}x{} pixels", options.size.width, options.size.height),
                                   render::comparable_timing()};
    return write_text(page_of(options),
                      gallery_page(all, drawn_by, options.terrain ? "" : kNoTerrain,
                                   fmt::format("{}, commit {}", kProgram, kCommit),
                                   options.hold ? std::optional(kReloadSeconds) : std::nullopt));
}

using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;

// When each shader and texture was last changed.
Times times_of_assets() {
    Times times;
    std::error_code error;
    for (const auto& file : drawing_assets()) times[file] = std::filesystem::last_write_time(file, error);
    return times;
}

// Draws the page again after each change of a shader or texture, until Ctrl+C. `seen`: the times of those that
// `renderer` was made from.
Outcome<void> hold(render::Renderer& renderer, Times seen, const std::filesystem::path& assets,
                   const Scenes& scenes, std::span<const Moment> moments, const std::string& renderer_name,
                   const GalleryOptions& options) {
    print_line(stderr, "couloir: {}: draws again when a shader or texture changes; Ctrl+C ends",
               assets.string());
    while (!interrupted()) {
        std::this_thread::sleep_for(kLookEvery);
        Times now = times_of_assets();
        if (now == seen) continue;
        seen = std::move(now);
        auto changed = make_renderer(assets, scenes);
        if (!changed) {
            print_line(stderr, "couloir: {}; the last page stays", changed.error().sentence);
            continue;
        }
        renderer = std::move(*changed);
        if (auto drawn = draw_page(renderer, moments, renderer_name, options); !drawn) return drawn;
    }
    return {};
}

}  // namespace

Outcome<int> gallery(const GalleryOptions& options) {
    std::vector<GalleryView> views = gallery_views();
    if (!options.terrain) std::erase_if(views, [](const GalleryView& view) { return !*view.scene; });
    const auto scenes = load_scenes(options, views);
    if (!scenes) return tl::unexpected(scenes.error());
    FileUse use;
    use.reads(drawing_assets());
    for (const auto& [name, scene] : *scenes) use.reads(scene.files);
    std::vector<std::string> names{"index.html"};
    for (const GalleryView& view : views) names.push_back(fmt::format("{}.png", view.name));
    use.writes_into("--out", options.folder, names);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    if (auto made = make_folder(options.folder); !made) return tl::unexpected(made.error());

    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    const auto context = render::HeadlessContext::create(options.gl);
    if (!context) return machine_fails(context.error());
    Times seen = times_of_assets();
    auto renderer = make_renderer(*assets, *scenes);
    if (!renderer) return tl::unexpected(renderer.error());
    auto worlds = begin_worlds(*scenes, options);
    if (!worlds) return tl::unexpected(worlds.error());
    const auto moments = simulate(views, *worlds);
    if (!moments) return tl::unexpected(moments.error());
    if (auto drawn = draw_page(*renderer, *moments, context->renderer_name(), options); !drawn)
        return tl::unexpected(drawn.error());
    if (!options.terrain) print_line(stderr, "couloir: {}", kNoTerrain);
    print_line(stdout, "{}", page_of(options).string());
    if (!options.hold) return 0;

    // The path of the page is for whoever opens it now.
    if (auto printed = finish_standard_output(); !printed) return tl::unexpected(printed.error());
    note_interrupts();
    if (auto held =
            hold(*renderer, std::move(seen), *assets, *scenes, *moments, context->renderer_name(), options);
        !held)
        return tl::unexpected(held.error());
    return 0;
}

}  // namespace game
