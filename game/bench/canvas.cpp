#include "game/bench/canvas.h"

#include <utility>

#include <fmt/format.h>

#include "game/files/assets.h"
#include "game/scene/mountains.h"
#include "render/frame.h"
#include "render/gl/context.h"
#include "render/mountain/overview.h"

namespace game {
namespace {

constexpr double kTurn = 0.3;  // degrees, there and back, so that each frame shows about the same

}  // namespace

struct Canvas::Parts {
    render::HeadlessContext context;  // first, because the renderer's GL names live in it
    render::Renderer renderer;
    CanvasOptions options;
    std::optional<render::Camera> camera = std::nullopt;
    render::Light light = {};
    render::Look look = {};
    std::vector<float> first_depth = {};  // m
    Backdrop backdrop = {};
    render::Wind wind = {};
    bool turned = false;
};

Outcome<Canvas> Canvas::open(const CanvasOptions& options) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    auto context = render::HeadlessContext::create(options.gl);
    if (!context) return machine_fails(context.error());
    const render::Quality quality = options.samples > 1 ? render::Quality::kFine
                                    : options.turns     ? render::Quality::kMoving
                                                        : render::Quality::kFast;
    auto renderer = render::Renderer::create(*assets, quality);
    if (!renderer) return machine_fails(renderer.error());
    renderer->time_stages(render::suitable_timing());
    return Canvas(std::make_unique<Parts>(Parts{std::move(*context), std::move(*renderer), options}));
}

Canvas::Canvas(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

Outcome<void> Canvas::show(const Scenario& scenario) {
    if (auto loaded = parts_->renderer.load(scenario.look, scenario.lower.has_value()); !loaded)
        return machine_fails(loaded.error());
    parts_->camera = scenario.camera;
    parts_->light = scenario.light;
    parts_->look = scenario.look;
    parts_->first_depth = scenario.depth;
    parts_->backdrop = scenario.model ? Backdrop() : backdrop_of(scenario);
    parts_->wind = scenario.wind;
    return {};
}

render::DrawTimes Canvas::draw(const Session& session) {
    Parts& p = *parts_;
    const sim::View world = session.view();
    if (!p.camera) p.camera = render::overview(world);
    render::Camera camera = *p.camera;
    if (p.options.turns && std::exchange(p.turned, !p.turned)) camera.azimuth_deg += kTurn;
    p.renderer.draw({.world = world,
                     .camera = camera,
                     .light = p.light,
                     .look = p.look,
                     .flow = session.fronts(),
                     .width = p.options.size.width,
                     .height = p.options.size.height,
                     .first_depth = p.first_depth,
                     .surroundings = &p.backdrop.mountains,
                     .land = &p.backdrop.land,
                     .powder = session.powder(),
                     .carried = session.carried(),
                     .woods = &p.backdrop.woods,
                     .flow_so_far = session.flow_so_far(),
                     .structures = &session.structures(),
                     .wind = p.wind,
                     .seconds = session.seconds()});
    return *p.renderer.stage_times();
}

render::DrawnBy Canvas::drawn_by() const {
    const CanvasOptions& options = parts_->options;
    return {parts_->context.renderer_name(),
            fmt::format("{}x{} pixels, {}, {}", options.size.width, options.size.height,
                        options.samples == 1 ? "one sample each" : "two by two samples each",
                        options.turns ? "a turning camera" : "a still camera"),
            render::suitable_timing()};
}

}  // namespace game
