#include <map>

#include <fmt/format.h>

#include "game/analysis/headless.h"
#include "game/base/print.h"
#include "game/base/version.h"
#include "game/commands/commands.h"
#include "game/figures/gallery_page.h"
#include "game/figures/gallery_views.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/recording/format.h"
#include "game/scene/mountains.h"
#include "render/frame.h"
#include "render/overview.h"

namespace game {
namespace {

constexpr const char* kNoTerrain = "There is no view of a real hill, because there is no --terrain.";

using Scenes = std::map<std::string, Scene>;

Outcome<Scenes> load_scenes(const GalleryOptions& options, std::span<const GalleryView> views) {
    Overrides overrides;
    overrides.memory = options.memory;
    overrides.memory.use.draws = true;
    overrides.memory.use.frames = {options.size.width, options.size.height};
    Scenes scenes;
    for (const GalleryView& view : views) {
        const std::string name = view.scene;
        if (scenes.contains(name)) continue;
        auto scene = name.empty() ? scene_of_terrain(*options.terrain, std::nullopt, overrides)
                                  : load_scene(name, overrides);
        if (!scene) return tl::unexpected(scene.error());
        scenes.emplace(name, std::move(*scene));
    }
    return scenes;
}

// Draws `input` twice, so that the second frame has no first-time costs, and returns the times of that one.
render::DrawTimes timed(render::Renderer& renderer, const render::FrameInput& input,
                        render::Quality quality) {
    renderer.set_quality(quality);
    renderer.draw(input);
    renderer.draw(input);
    return *renderer.stage_times();
}

// Draws one view of the session and writes its image. The files of all views are fine, and drawn last.
Outcome<DrawnView> draw(render::Renderer& renderer, const GalleryView& view, const Scene& scene,
                        const Session& session, const render::Surroundings& mountains,
                        const GalleryOptions& options) {
    const Scenario& scenario = scene.scenario;
    const render::Camera own =
        scenario.camera ? *scenario.camera : render::overview(sim::view(session.state()));
    DrawnView drawn;
    drawn.file = fmt::format("{}.png", view.name);
    drawn.title = view.title;
    drawn.scene = scenario.scene;
    drawn.tick = session.state().tick;
    drawn.state_hash = hex(session.state_line().hash);
    drawn.camera = view.camera.value_or(own);
    drawn.light = view.light;
    const render::FrameInput input{.world = session.view(),
                                   .camera = drawn.camera,
                                   .light = drawn.light,
                                   .look = scenario.look,
                                   .flow = session.fronts(),
                                   .width = options.size.width,
                                   .height = options.size.height,
                                   .first_depth = scenario.depth,
                                   .surroundings = scenario.model ? nullptr : &mountains};
    drawn.fast = timed(renderer, input, render::Quality::kFast);
    drawn.fine = timed(renderer, input, render::Quality::kFine);
    if (auto written = render::write_png(renderer.read_back(), options.folder / drawn.file); !written)
        return machine_fails(written.error());
    return drawn;
}

Outcome<void> advance(Session& session, const Scene& scene, const GalleryView& view) {
    const std::int64_t last_command = scene.commands.empty() ? 0 : scene.commands.back().tick;
    const Until until = view.tick ? Until::after(*view.tick) : Until::at_rest(last_command);
    const auto played = play_headless(session, scene.commands, until, {}, scene.scenario.scene);
    if (!played) return tl::unexpected(played.error());
    return {};
}

Outcome<std::vector<DrawnView>> draw_all(std::span<const GalleryView> views, const Scenes& scenes,
                                         render::Renderer& renderer, const GalleryOptions& options) {
    std::vector<DrawnView> all;
    std::optional<Session> session;
    std::string playing;
    render::Surroundings mountains;
    for (const GalleryView& view : views) {
        const Scene& scene = scenes.at(view.scene);
        if (!session || playing != view.scene) {
            if (scene.scenario.look.flow)
                if (auto loaded = renderer.load(scene.scenario.look.flow->pattern); !loaded)
                    return machine_fails(loaded.error());
            auto begun = Session::begin(scene.scenario, options.step_options, std::nullopt);
            if (!begun) return tl::unexpected(begun.error());
            session.emplace(std::move(*begun));
            session->follow_fronts(scene.scenario);
            playing = view.scene;
            mountains = mountains_around(scene.scenario);
        }
        if (auto advanced = advance(*session, scene, view); !advanced)
            return tl::unexpected(advanced.error());
        auto drawn = draw(renderer, view, scene, *session, mountains, options);
        if (!drawn) return tl::unexpected(drawn.error());
        all.push_back(std::move(*drawn));
        print_line(stderr, "couloir: {} of {}: {}", all.size(), views.size(), view.title);
    }
    return all;
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
    auto renderer = render::Renderer::create(*assets);
    if (!renderer) return machine_fails(renderer.error());
    // Nothing else runs in this process while a frame is drawn, so that processor time is the frame's own.
    renderer->time_stages(render::comparable_timing());
    const auto drawn = draw_all(views, *scenes, *renderer, options);
    if (!drawn) return tl::unexpected(drawn.error());

    const render::DrawnBy drawn_by{context->renderer_name(),
                                   fmt::format("{}x{} pixels", options.size.width, options.size.height),
                                   render::comparable_timing()};
    const auto page = options.folder / "index.html";
    if (auto written = write_text(page, gallery_page(*drawn, drawn_by, options.terrain ? "" : kNoTerrain,
                                                     fmt::format("{}, commit {}", kProgram, kCommit)));
        !written)
        return tl::unexpected(written.error());
    if (!options.terrain) print_line(stderr, "couloir: {}", kNoTerrain);
    print_line(stdout, "{}", page.string());
    return 0;
}

}  // namespace game
