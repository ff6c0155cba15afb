#include "game/analysis/gallery.h"

#include <cmath>

#include <fmt/format.h>

#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/scene/mountains.h"
#include "render/frame.h"
#include "render/gl/context.h"
#include "render/mountain/overview.h"
#include "render/pictures/frame_writer.h"

namespace game {

struct Gallery::Parts {
    render::HeadlessContext context;  // first, because the renderer's GL names live in it
    render::Renderer renderer;
    std::optional<render::FrameWriter> writer;  // none without a folder
    std::filesystem::path folder;
    PictureSize size;
    std::optional<render::Camera> camera;
    render::Light light;
    render::Look look;
    std::vector<float> first_depth;  // m
    Backdrop backdrop;
    render::Wind wind;
    std::string notice;
    int pictures = 0;

    Parts(render::HeadlessContext&& gl, render::Renderer&& with)
        : context(std::move(gl)), renderer(std::move(with)) {}

    // Adds what all frames have in common to what `input` shows.
    render::Picture image(render::FrameInput input) {
        input.light = light;
        input.look = look;
        input.width = size.width;
        input.height = size.height;
        input.first_depth = first_depth;
        renderer.draw(input);
        return renderer.read_back();
    }
    render::DrawTimes draw(const render::FrameInput& input, const std::string& name) {
        writer.value().submit(image(input), folder / (name + ".png"));
        ++pictures;
        return *renderer.stage_times();
    }
    render::FrameInput input_of(const Session& session, const render::Camera& from) const {
        return {.world = session.view(),
                .camera = from,
                .flow = session.fronts(),
                .undisturbed = session.undisturbed(),
                .surroundings = &backdrop.mountains,
                .land = &backdrop.land,
                .powder = session.powder(),
                .carried = session.carried(),
                .woods = &backdrop.woods,
                .flow_so_far = session.flow_so_far(),
                .structures = &session.structures(),
                .wind = wind,
                .seconds = session.seconds()};
    }
};

render::Camera map_camera(const sim::View& world, double aspect) {
    const double width = (world.grid.nx - 1) * static_cast<double>(world.grid.dx);
    const double height = (world.grid.ny - 1) * static_cast<double>(world.grid.dx);
    double lowest = 1e30, highest = -1e30;
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x) {
            lowest = std::min(lowest, static_cast<double>(world.bedrock(x, y)));
            highest = std::max(highest, static_cast<double>(world.bedrock(x, y)));
        }
    render::Camera camera;
    camera.field_of_view_deg = 28;  // narrow enough to be nearly the plan, close enough to avoid haze
    const double half = std::max(height, width / aspect) * 0.53;
    camera.target = {width / 2, height / 2, world.datum + (lowest + highest) / 2};
    camera.azimuth_deg = 180;  // the camera is in the south, so north is up
    camera.elevation_deg = 89.9;
    camera.distance_m =
        half / std::tan(camera.field_of_view_deg / 2 * 3.14159265358979323846 / 180) + (highest - lowest) / 2;
    return camera;
}

Outcome<Gallery> Gallery::open(const std::optional<std::filesystem::path>& folder, PictureSize size,
                               const std::string& gl, const Scenario& scenario) {
    if (folder)
        if (auto made = make_folder(*folder); !made) return tl::unexpected(made.error());
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    auto context = render::HeadlessContext::create(gl);
    if (!context) return machine_fails(context.error());
    auto renderer = render::Renderer::create(*assets);
    if (!renderer) return machine_fails(renderer.error());
    if (auto loaded = renderer->load(scenario.look, scenario.lower.has_value()); !loaded)
        return machine_fails(loaded.error());

    renderer->time_stages(render::suitable_timing());
    auto parts = std::make_unique<Parts>(std::move(*context), std::move(*renderer));
    if (folder) parts->writer.emplace(), parts->folder = *folder;
    parts->size = size;
    parts->camera = scenario.camera;
    parts->light = scenario.light;
    parts->look = scenario.look;
    parts->first_depth = scenario.depth;
    parts->wind = scenario.wind;
    if (!scenario.model) {
        parts->backdrop = backdrop_of(scenario);
        parts->notice = woods_notice(scenario, parts->backdrop.woods);
    }
    return Gallery(std::move(parts));
}

Gallery::Gallery(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Gallery::~Gallery() = default;
Gallery::Gallery(Gallery&&) noexcept = default;
Gallery& Gallery::operator=(Gallery&&) noexcept = default;

render::DrawTimes Gallery::draw(const Session& session, const std::string& name) {
    if (!parts_->camera) parts_->camera = render::overview(session.view());
    return parts_->draw(parts_->input_of(session, *parts_->camera), name);
}

render::Picture Gallery::image(const Session& session, const render::Camera& camera) {
    return parts_->image(parts_->input_of(session, camera));
}

// A map ends at its border.
render::DrawTimes Gallery::draw_map(const sim::View& world, const std::string& name) {
    const double aspect = static_cast<double>(parts_->size.width) / parts_->size.height;
    return parts_->draw({.world = world, .camera = map_camera(world, aspect)}, name);
}

std::string Gallery::notice() const {
    return parts_->notice;
}

Outcome<void> Gallery::close() {
    if (parts_->writer)
        if (auto written = parts_->writer->finish(); !written) return machine_fails(written.error());
    return {};
}

std::string Gallery::renderer_name() const {
    return parts_->context.renderer_name();
}
render::DrawnBy Gallery::drawn_by() const {
    return {renderer_name(),
            fmt::format("{}x{} pixels, four samples each", parts_->size.width, parts_->size.height),
            render::suitable_timing()};
}
int Gallery::pictures() const {
    return parts_->pictures;
}
PictureSize Gallery::size() const {
    return parts_->size;
}
const render::Surroundings& Gallery::surroundings() const {
    return parts_->backdrop.mountains;
}

}  // namespace game
