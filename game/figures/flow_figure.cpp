#include "game/figures/flow_figure.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "game/figures/level_flow.h"
#include "game/figures/mosaic.h"
#include "game/files/assets.h"
#include "render/frame.h"
#include "render/gl/context.h"
#include "render/pictures/front_picture.h"

namespace game {
namespace {

// A square of the ground from straight above, north up.
struct Cutout {
    glm::dvec2 middle{0.5, 0.5};
    double side = 1;  // m
};

render::Camera camera_of(const Cutout& cutout) {
    render::Camera camera;
    camera.target = {cutout.middle, 0};
    camera.azimuth_deg = 180;
    camera.elevation_deg = 89.9;
    camera.field_of_view_deg =
        30;  // level ground looks the same from any distance; this one is close enough to avoid haze
    const double half = camera.field_of_view_deg / 2 * std::numbers::pi / 180;
    constexpr double kNearer =
        0.996;  // so that no border is seen, for it does not stand quite straight above
    camera.distance_m = kNearer * cutout.side / 2 / std::tan(half);
    return camera;
}

// Finds where the front passes closest to the middle of the square.
Cutout detail_of(const FlowFigure& figure) {
    constexpr double kSide = 0.3;
    constexpr int kPlaces = 128;  // candidate places along each side
    Cutout cutout{{0.5, 0.5}, kSide};
    double nearest = std::numeric_limits<double>::max();
    for (int y = 0; y <= kPlaces; ++y)
        for (int x = 0; x <= kPlaces; ++x) {
            const glm::dvec2 at = kSide / 2 + (1 - kSide) / kPlaces * glm::dvec2(x, y), from = at - 0.5;
            const double worth =
                figure.flow.distance(at, figure.seconds) + 0.1 * (from.x * from.x + from.y * from.y);
            if (worth < nearest) nearest = worth, cutout.middle = at;
        }
    return cutout;
}

std::string caption_of(const FlowFigure& figure) {
    return fmt::format(
        "{0}×{0} squares, after {1:g} s at 60 steps per second; texture {2}. Above, the texture as seen; "
        "below, its stretch. Points by the source fit.",
        figure.squares, figure.seconds, to_string(figure.pattern));
}

}  // namespace

std::vector<FlowFigure> flow_figures() {
    using render::FlowPattern;
    constexpr int kSquares = 20;
    const auto line = sim::fields::opposed(1.0 / kSquares, 0.5);
    return {
        {1, "stationary front between opposed flows, stones", line, kSquares, 6, FlowPattern::kStones, 3},
        {7, "stationary front between opposed flows", line, kSquares, 6, FlowPattern::kCheckerboard, 2},
        {8, "opposed flows with a swinging diagonal front", sim::fields::swinging(45), kSquares, 7,
         FlowPattern::kCheckerboard, 2, true},
        {9, "four flows with two fronts rotating about their crossing", sim::fields::pinwheel(), kSquares, 6,
         FlowPattern::kCheckerboard, 2},
        {10, "a disc circling in a downward flow", sim::fields::disc(), 160, 6, FlowPattern::kPerlin, 3},
    };
}

struct Studio::Parts {
    render::HeadlessContext context;  // first, because the renderer's GL names live in it
    render::Renderer renderer;

    Parts(render::HeadlessContext&& gl, render::Renderer&& with)
        : context(std::move(gl)), renderer(std::move(with)) {}

    render::Picture draw(const FlowFigure& figure, const LevelFlow& flow, const render::Marks& marks,
                         const Cutout& cutout, int pixels) {
        render::Look look;
        look.flow = render::FlowLook{figure.pattern, figure.repeats, true};
        look.detail = 0;
        render::Light light;
        light.azimuth_deg = 315, light.elevation_deg = 50;
        renderer.draw({.world = flow.ground(),
                       .camera = camera_of(cutout),
                       .light = light,
                       .look = look,
                       .marks = marks,
                       .flow = &flow.view(),
                       .width = pixels,
                       .height = pixels});
        return renderer.read_back();
    }
};

Outcome<Studio> Studio::open(const std::string& gl) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    auto context = render::HeadlessContext::create(gl);
    if (!context) return machine_fails(context.error());
    auto renderer = render::Renderer::create(*assets);
    if (!renderer) return machine_fails(renderer.error());
    return Studio(std::make_unique<Parts>(std::move(*context), std::move(*renderer)));
}

Studio::Studio(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Studio::~Studio() = default;
Studio::Studio(Studio&&) noexcept = default;
Studio& Studio::operator=(Studio&&) noexcept = default;

Outcome<PageFigure> Studio::draw(const FlowFigure& figure, const std::filesystem::path& folder, int pixels,
                                 sim::Workers& workers) {
    render::Look look;
    look.flow = render::FlowLook{figure.pattern};
    if (auto loaded = parts_->renderer.load(look, false); !loaded) return machine_fails(loaded.error());
    LevelFlow without(figure.squares, false), with(figure.squares, true);
    for (LevelFlow* flow : {&without, &with}) flow->advance(figure.flow, figure.seconds, workers);
    render::Marks stretch, mesh;
    stretch.overlay = render::Overlay::kStretch;
    mesh.flow_mesh = true;

    PageFigure shown{figure.number, figure.title, caption_of(figure), {}, true};
    const auto write = [&](const render::Picture& picture, const char* suffix, const std::string& note) {
        const std::string file = fmt::format("figure-{:02}{}.png", figure.number, suffix);
        shown.pictures.push_back({file, note});
        return render::write_png(picture, folder / file);
    };
    std::vector<render::Picture> pictures;
    for (const render::Marks& marks : {render::Marks{}, stretch})
        for (const LevelFlow* flow : {&without, &with})
            pictures.push_back(parts_->draw(figure, *flow, marks, {}, pixels));
    auto written = write(mosaic(pictures, 2), "",
                         fmt::format("stretch above 2: without cuts {:.1f} % of the area, with cuts {:.1f} %",
                                     100 * without.drawn_out(), 100 * with.drawn_out()));
    if (written && figure.detail) {
        const render::Picture meshes[] = {render::front_picture(with.view().tracker(), pixels, pixels),
                                          parts_->draw(figure, with, mesh, detail_of(figure), pixels)};
        written = write(mosaic(meshes, 2), "-mesh",
                        "the mesh with its cut triangles, the front and its points; close up");
    }
    if (!written) return machine_fails(written.error());
    return shown;
}

std::string Studio::renderer_name() const {
    return parts_->context.renderer_name();
}

}  // namespace game
