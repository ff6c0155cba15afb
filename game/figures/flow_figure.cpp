#include "game/figures/flow_figure.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "game/assets.h"
#include "game/figures/mosaic.h"
#include "render/context.h"
#include "render/frame.h"
#include "render/front_picture.h"
#include "sim/front/flow_view.h"

namespace game {
namespace {

constexpr double kStepsPerSecond = 60;
constexpr float kJump = 0.05f;  // m/s; across the fronts it is at least 0.14
constexpr float kNever = 1e9f;  // m/s, is no jump

sim::front::Rule rule_of(float cell, bool cut) {
    return sim::front::gradient_rule(cut ? kJump : kNever, cell);
}

// Level ground that flows, and how its textures lie when they have travelled for so long.
class Carried {
  public:
    Carried(const FlowFigure& figure, bool cut, sim::Workers& workers)
        : grid_{figure.squares + 1, figure.squares + 1, 1.f / static_cast<float>(figure.squares)},
          mesh_(sim::front::mesh_of(grid_)),
          view_(mesh_, rule_of(grid_.dx, cut), sim::front::Source::kFit, {}),
          ground_(level(grid_)) {
        std::vector<glm::vec2> velocity(mesh_.position.size());
        const auto steps = std::lround(figure.seconds * kStepsPerSecond);
        for (int step = 1; step <= steps; ++step) {
            for (std::size_t v = 0; v < velocity.size(); ++v)
                velocity[v] = figure.flow.velocity(glm::dvec2(mesh_.position[v]), step / kStepsPerSecond);
            view_.advance({velocity, {}}, 1 / kStepsPerSecond, workers);
        }
    }
    Carried(const Carried&) = delete;  // the view refers to the mesh
    Carried& operator=(const Carried&) = delete;

    sim::View ground() const { return sim::view(ground_); }
    const sim::front::FlowView& view() const { return view_; }

  private:
    static sim::State level(const sim::Grid& grid) {
        const std::vector<float> nothing(grid.size(), 0.f);
        const std::vector<std::uint8_t> has_data(grid.size(), 1);
        return sim::make_state({grid, 0, nothing, nothing, nothing, has_data}, sim::Params{});
    }

    sim::Grid grid_;
    sim::front::Mesh mesh_;
    sim::front::FlowView view_;
    sim::State ground_;
};

// A square of the ground from straight above, north up.
struct Window {
    glm::dvec2 middle{0.5, 0.5};
    double side = 1;  // m
};

render::Camera camera_of(const Window& window) {
    render::Camera camera;
    camera.target = {window.middle, 0};
    camera.azimuth_deg = 180;
    camera.elevation_deg = 89.9;
    camera.field_of_view_deg = 30;  // level ground looks the same from anywhere: near enough for no haze
    const double half = camera.field_of_view_deg / 2 * std::numbers::pi / 180;
    constexpr double kNearer =
        0.996;  // so that no border is seen, for it does not stand quite straight above
    camera.distance_m = kNearer * window.side / 2 / std::tan(half);
    return camera;
}

// Where the front passes nearest to the middle of the square.
Window detail_of(const FlowFigure& figure) {
    constexpr double kSide = 0.3, kStep = 1.0 / 128;
    Window window{{0.5, 0.5}, kSide};
    double nearest = std::numeric_limits<double>::max();
    for (double y = kSide / 2; y <= 1 - kSide / 2; y += kStep)
        for (double x = kSide / 2; x <= 1 - kSide / 2; x += kStep) {
            const glm::dvec2 at(x, y), from = at - 0.5;
            const double worth =
                figure.flow.distance(at, figure.seconds) + 0.1 * (from.x * from.x + from.y * from.y);
            if (worth < nearest) nearest = worth, window.middle = at;
        }
    return window;
}

std::string caption_of(const FlowFigure& figure) {
    return fmt::format(
        "{0}×{0} squares, after {1:g} s at 60 steps per second; texture {2}. Above what is seen, below how "
        "much it is drawn out. Points by the source fit.",
        figure.squares, figure.seconds, to_string(figure.pattern));
}

}  // namespace

std::vector<FlowFigure> flow_figures() {
    using render::FlowPattern;
    constexpr int kSquares = 20;
    const auto line = sim::fields::opposed(1.0 / kSquares, 0.5);
    return {
        {1, "a front at rest between opposed flows, stones", line, kSquares, 6, FlowPattern::kStones, 3},
        {7, "a front at rest between opposed flows", line, kSquares, 6, FlowPattern::kCheckerboard, 2},
        {8, "opposed flows and a diagonal front that swings", sim::fields::swinging(45), kSquares, 7,
         FlowPattern::kCheckerboard, 2, true},
        {9, "four flows and two fronts that spin about their crossing", sim::fields::pinwheel(), kSquares, 6,
         FlowPattern::kCheckerboard, 2},
        {10, "a disc that moves round in a flow straight down", sim::fields::disc(), 160, 6,
         FlowPattern::kPerlin, 3},
    };
}

struct Studio::Parts {
    render::HeadlessContext context;  // first: the renderer's GL names live in it
    render::Renderer renderer;

    Parts(render::HeadlessContext&& gl, render::Renderer&& with)
        : context(std::move(gl)), renderer(std::move(with)) {}

    render::Picture draw(const FlowFigure& figure, const Carried& flow, const render::Marks& marks,
                         const Window& window, int pixels) {
        render::Look look;
        look.flow = render::FlowLook{figure.pattern, figure.repeats, true};
        look.detail = 0;
        render::Light light;
        light.azimuth_deg = 315, light.elevation_deg = 50;
        renderer.draw(flow.ground(), camera_of(window), light, look, marks, pixels, pixels, &flow.view());
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
    if (auto loaded = parts_->renderer.load(figure.pattern); !loaded) return machine_fails(loaded.error());
    const Carried without(figure, false, workers), with(figure, true, workers);
    render::Marks stretch, mesh;
    stretch.overlay = render::Overlay::kStretch;
    mesh.flow_mesh = true;

    PageFigure shown{figure.number, figure.title, caption_of(figure), {}, true};
    const auto write = [&](const render::Picture& picture, const char* suffix, const char* note) {
        const std::string file = fmt::format("figure-{:02}{}.png", figure.number, suffix);
        shown.pictures.push_back({file, note});
        return render::write_png(picture, folder / file);
    };
    std::vector<render::Picture> pictures;
    for (const render::Marks& marks : {render::Marks{}, stretch})
        for (const Carried* flow : {&without, &with})
            pictures.push_back(parts_->draw(figure, *flow, marks, {}, pixels));
    auto written = write(mosaic(pictures, 2), "", "without and with cuts");
    if (written && figure.detail) {
        const render::Picture meshes[] = {render::front_picture(with.view().tracker(), pixels, pixels),
                                          parts_->draw(figure, with, mesh, detail_of(figure), pixels)};
        written =
            write(mosaic(meshes, 2), "-mesh",
                  "the mesh with the triangles that are cut, the front and its points; from near, as it "
                  "is drawn");
    }
    if (!written) return machine_fails(written.error());
    return shown;
}

std::string Studio::renderer_name() const {
    return parts_->context.renderer_name();
}

}  // namespace game
