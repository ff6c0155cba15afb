#include "game/bench/canvas.h"

#include <fmt/format.h>

#include "game/files/assets.h"
#include "game/scene/mountains.h"
#include "render/context.h"
#include "render/frame.h"
#include "render/overview.h"

namespace game {

struct Canvas::Parts {
    render::HeadlessContext context;  // first, because the renderer's GL names live in it
    render::Renderer renderer;
    PictureSize size;
    std::optional<render::Camera> camera = std::nullopt;
    render::Light light = {};
    render::Look look = {};
    std::vector<float> first_depth = {};  // m
    render::Surroundings surroundings = {};
    render::Woods woods = {};
    render::Wind wind = {};
};

Outcome<Canvas> Canvas::open(PictureSize size, const std::string& gl) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    auto context = render::HeadlessContext::create(gl);
    if (!context) return machine_fails(context.error());
    auto renderer = render::Renderer::create(*assets, render::Quality::kFast);
    if (!renderer) return machine_fails(renderer.error());
    renderer->time_stages(render::suitable_timing());
    return Canvas(std::make_unique<Parts>(Parts{std::move(*context), std::move(*renderer), size}));
}

Canvas::Canvas(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

Outcome<void> Canvas::show(const Scenario& scenario) {
    if (scenario.look.flow)
        if (auto loaded = parts_->renderer.load(scenario.look.flow->pattern); !loaded)
            return machine_fails(loaded.error());
    parts_->camera = scenario.camera;
    parts_->light = scenario.light;
    parts_->look = scenario.look;
    parts_->first_depth = scenario.depth;
    parts_->surroundings = scenario.model ? render::Surroundings() : mountains_around(scenario);
    parts_->wind = scenario.wind;
    parts_->woods = woods_on(scenario, parts_->surroundings);
    return {};
}

render::DrawTimes Canvas::draw(const Session& session) {
    Parts& p = *parts_;
    const sim::View world = session.view();
    if (!p.camera) p.camera = render::overview(world);
    p.renderer.draw({.world = world,
                     .camera = *p.camera,
                     .light = p.light,
                     .look = p.look,
                     .flow = session.fronts(),
                     .width = p.size.width,
                     .height = p.size.height,
                     .first_depth = p.first_depth,
                     .surroundings = &p.surroundings,
                     .powder = session.powder(),
                     .woods = &p.woods,
                     .flow_so_far = session.flow_so_far(),
                     .structures = &session.structures(),
                     .wind = p.wind,
                     .seconds = session.seconds()});
    return *p.renderer.stage_times();
}

render::DrawnBy Canvas::drawn_by() const {
    return {parts_->context.renderer_name(),
            fmt::format("{}x{} pixels, one sample each", parts_->size.width, parts_->size.height),
            render::suitable_timing()};
}

}  // namespace game
