#include "render/frame.h"

#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "assets/shaders/slots.glsl"
#include "render/flow/flow_triangles.h"
#include "render/frame/make_frame_block.h"
#include "render/frame/redrawn.h"
#include "render/frame/slide_tiles.h"
#include "render/gl/scoped_state.h"
#include "render/gl/stage_clock.h"
#include "render/mountain/bare_ground.h"
#include "render/mountain/ground_mesh.h"
#include "render/mountain/sun_sweep.h"
#include "render/passes/carried_pass.h"
#include "render/passes/coarse_ground.h"
#include "render/passes/drawn_extent.h"
#include "render/passes/drawn_land.h"
#include "render/passes/drawn_probability.h"
#include "render/passes/drawn_water.h"
#include "render/passes/fields_to_gpu.h"
#include "render/passes/flow_pass.h"
#include "render/passes/fullscreen_pass.h"
#include "render/passes/lens_pass.h"
#include "render/passes/powder_pass.h"
#include "render/passes/shadow_pass.h"
#include "render/passes/spindrift_pass.h"
#include "render/passes/structures_pass.h"
#include "render/passes/surface_pass.h"
#include "render/passes/surroundings_pass.h"
#include "render/passes/target.h"
#include "render/passes/terrain_pass.h"
#include "render/passes/trees_pass.h"
#include "render/view/on_screen.h"
#include "sim/core/check.h"

namespace render {
namespace {

int samples_of(Quality quality) {
    return quality == Quality::kFine ? 2 : 1;
}

constexpr std::span<const Rectangle> kNowhere;

// Wind blows snow off ridges, as far as there is any.
bool may_drift(const FrameInput& input) {
    return input.surrounded() && input.wind.speed > 0 && is_dry_snow(input.look) &&
           input.marks.overlay == Overlay::kNone;
}

// A frame on its way through the passes.
struct Frame {
    const FrameInput& input;
    FieldsToGpu::Ground ground;         // what changed of it
    std::span<const glm::ivec2> water;  // vertices where what is shown of it changed
    FrameBlock block = {};
    FrameBlock coarse_block = {};  // of its ground, if that is coarse
    FrameKey key = {};
    bool new_world = false;
    bool everything = false;                                 // is drawn anew
    bool wooded = false, powdery = false, drifting = false;  // with any of that in view
};

}  // namespace

struct Renderer::Parts {
    BareGround bare_ground;
    FieldsToGpu fields;
    Buffer frame_block, coarse_block;
    SurfacePass surface;
    SunSweep sweep;
    ShadowPass shadow;
    TerrainPass terrain;
    CoarseGround coarse_ground;
    SlideTiles tiles;
    FlowPass flow;
    FlowTriangles triangles;
    SurroundingsPass surroundings;
    FullscreenPass sky, day_lights, night_lights;
    StructuresPass structures;
    CarriedPass carried;
    TreesPass trees;
    SpindriftPass spindrift;
    PowderPass powder;
    LensPass lens;
    FullscreenPass tone;
    FullscreenPass edge_marks, edges;
    Target target;
    Quality quality = Quality::kFine;
    std::filesystem::path assets;
    StageClock clock;
    Redrawn redrawn;
    RedrawRules rules;
    DrawnExtent extent;
    DrawnLand land;
    DrawnProbability probability;
    DrawnWater water;

    // The stages of a frame, in order.
    Frame begin(const FrameInput& input);
    void upload(const Frame& frame);
    void remesh(const Frame& frame);
    void compute(const Frame& frame);
    void find(Frame& frame);
    void draw(const Frame& frame);
    void shade_ground(const Frame& frame, const Target& on, const Marks& marks, Target::Parts parts);
    void shade_coarse_ground(const Frame& frame);

    bool is_coarse() const { return quality == Quality::kMoving; }

    // The factor for the colours of a flow's texture. A rolling layer keeps its own mean colour.
    glm::vec3 flow_tint(const Look& look, const Marks& marks) const {
        if (look.flow->everywhere || marks.overlay == Overlay::kStretch) return glm::vec3(1);
        return look.rolling / flow.mean_colour(look.flow->pattern);
    }
};

tl::expected<Renderer, std::string> Renderer::create(const std::filesystem::path& assets, Quality quality) {
    const std::filesystem::path shaders = assets / "shaders";
    std::string error;  // the first
    const auto ready = [&error]<class Pass>(tl::expected<Pass, std::string> pass) {
        if (!pass && error.empty()) error = pass.error();
        return pass ? std::move(*pass) : Pass();
    };
    const auto fullscreen = [&](const std::vector<std::string_view>& files) {
        return ready(FullscreenPass::create(shaders, files));
    };
    auto parts = std::make_unique<Parts>();
    parts->surface = ready(SurfacePass::create(shaders));
    parts->terrain = ready(TerrainPass::create(shaders));
    parts->coarse_ground = ready(CoarseGround::create(shaders));
    parts->flow = ready(FlowPass::create(shaders));
    parts->sky = fullscreen({"slots.glsl", "frame.glsl", "light.glsl", "sky.frag"});
    parts->day_lights = fullscreen({"slots.glsl", "frame.glsl", "sky_lights.frag", "stars_none.glsl"});
    parts->night_lights = fullscreen({"slots.glsl", "frame.glsl", "sky_lights.frag", "stars.glsl"});
    parts->structures = ready(StructuresPass::create(shaders));
    parts->carried = ready(CarriedPass::create(shaders));
    parts->trees = ready(TreesPass::create(assets));
    parts->spindrift = ready(SpindriftPass::create(shaders));
    parts->powder = ready(PowderPass::create(shaders));
    parts->lens = ready(LensPass::create(shaders));
    parts->tone = fullscreen({"slots.glsl", "tone_curve.glsl", "tone.frag"});
    parts->edge_marks = fullscreen({"slots.glsl", "edges_mark.frag"});
    parts->edges = fullscreen({"slots.glsl", "edges.frag"});
    if (!error.empty()) return tl::unexpected(error);

    parts->quality = quality;
    parts->assets = assets;
    parts->frame_block = make_buffer();
    parts->coarse_block = make_buffer();
    for (const Buffer* block : {&parts->frame_block, &parts->coarse_block})
        glNamedBufferStorage(block->name(), sizeof(FrameBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    return Renderer(std::move(parts));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

tl::expected<void, std::string> Renderer::load(const Look& look, bool two_materials) {
    const std::filesystem::path shaders = parts_->assets / "shaders";
    const GroundKind kind{look.date.has_value(), two_materials};
    if (auto ready = parts_->terrain.load(shaders, kind); !ready) return ready;
    if (auto ready = parts_->surroundings.load(shaders, kind); !ready) return ready;
    if (auto ready = parts_->trees.load(shaders, kind); !ready) return ready;
    if (!look.flow) return {};
    return parts_->flow.load(parts_->assets, look.flow->pattern);
}

void Renderer::set_quality(Quality quality) {
    parts_->quality = quality;
}

void Renderer::forget() {
    parts_->redrawn.key.reset();
}

double Renderer::redrawn() const {
    double samples = 0;
    for (const Rectangle& part : parts_->redrawn.scene)
        samples += static_cast<double>(part.width()) * part.height();
    const Target& target = parts_->target;
    return samples / (static_cast<double>(target.samples_across()) * target.samples_up());
}

void Renderer::set_redraw(const RedrawRules& rules) {
    parts_->rules = rules;
}

void Renderer::time_stages(Timing timing) {
    parts_->clock = StageClock(timing);
}

std::optional<DrawTimes> Renderer::stage_times() const {
    return parts_->clock.times();
}

// A building that is a part of the bedrock is drawn by its mesh, on the ground as it is without it.
void Renderer::draw(const FrameInput& input) {
    const sim::Field<float>* ground = parts_->bare_ground.find(input.world);
    if (!ground) return draw_ground(input);
    FrameInput without = input;
    std::construct_at(&without.world, sim::on_bedrock(input.world, *ground));  // a view cannot be assigned
    draw_ground(without);
}

void Renderer::draw_ground(const FrameInput& input) {
    Parts& p = *parts_;
    const ScopedState state;  // restores the state for other users of the context
    p.clock.begin();
    Frame frame = p.begin(input);
    p.upload(frame);
    p.remesh(frame);
    p.compute(frame);
    p.find(frame);
    p.draw(frame);
    CHECK(glGetError() == GL_NO_ERROR);
}

// Finds out first whether more than the world changed: then all is drawn anew.
Frame Renderer::Parts::begin(const FrameInput& input) {
    const int samples = samples_of(quality);
    Frame frame{.input = input,
                .ground = fields.upload_ground(input.world, input.first_depth, input.undisturbed),
                .water = water.send(input)};
    frame.block =
        make_frame_block(input, fields.heights(), samples,
                         input.flows() ? std::optional(flow_tint(input.look, input.marks)) : std::nullopt);
    if (input.shows_wet_soil()) frame.block.overlay.w = water.is_wet();
    frame.key = frame_key_of(input, frame.block);
    frame.key.coarse = is_coarse();
    const bool resized = target.resize(input.width, input.height, samples);
    if (is_coarse()) {
        coarse_ground.resize(target);
        frame.coarse_block = coarse_frame_block(frame.block, target.samples_across(), target.samples_up());
    }
    const bool new_ground = frame.ground.terrain || frame.ground.first_depth;
    frame.new_world = new_ground || frame.ground.undisturbed || !redrawn.key ||
                      !same_surface(redrawn.key->block, frame.block);
    structures.build(input, frame.block, frame.ground.terrain, frame.ground.moved);
    bool new_trees = false;
    if (input.may_have_trees()) {
        const bool around = input.surrounded();
        new_trees =
            trees.follow(around ? input.woods : nullptr, around ? input.surroundings : nullptr, input.world,
                         input.first_depth, frame.block.sun, new_ground) == FollowedWoods::Change::kAll;
    }
    frame.everything = new_trees || frame.new_world || resized || is_coarse() || input.marks.flow_mesh ||
                       input.lens || redrawn.key != frame.key;
    return frame;
}

// What changed of the world: everything below reads these textures, and only they change with the state.
void Renderer::Parts::upload(const Frame& frame) {
    const FrameInput& input = frame.input;
    WhatChanged& changed = redrawn.world;
    changed.compare(input.world, fields.find_mixture(input.world), input.untouched(),
                    input.surrounded() ? std::nullopt : std::optional(frame.block.ground.y), rules,
                    frame.new_world, {frame.ground.moved, SurfacePass::openness_reach(input.world.grid)},
                    frame.water);
    fields.upload_layers(input.world, changed.first_row(), changed.last_row());
    glNamedBufferSubData(frame_block.name(), 0, sizeof frame.block, &frame.block);
    glBindBufferBase(GL_UNIFORM_BUFFER, SLOT_FRAME, frame_block.name());
    fields.bind();
    if (input.flows()) flow.send(*input.flow);
    clock.mark(Pass::kUpload);
}

// Applies what changed along the fronts since the last frame.
void Renderer::Parts::remesh(const Frame& frame) {
    const FrameInput& input = frame.input;
    if (input.flows()) {
        flow.cut(*input.flow, input.world.grid);
        triangles.find(input.world, input.untouched(), flow.coordinates().vertices(), input.look);
        flow.find_changes(triangles, redrawn.world);
    }
    clock.mark(Pass::kRemesh);
}

// Data per vertex, before the passes that read it.
void Renderer::Parts::compute(const Frame& frame) {
    const FrameInput& input = frame.input;
    const sim::Grid& grid = input.world.grid;
    WhatChanged& changed = redrawn.world;

    // What depends only on the bedrock is computed here, once per terrain and around what changed of it, because it
    // needs the fields and the frame block.
    const glm::ivec2 last_vertex(grid.nx - 1, grid.ny - 1);
    if (frame.ground.terrain) {
        terrain.send_mesh(ground_mesh(grid, input.world.site));
        surface.resize(grid);
        shadow.resize(grid);
        surface.survey_terrain({0, 0}, last_vertex);
    } else if (!frame.ground.moved.empty()) {
        glm::ivec2 low = frame.ground.moved.front(), high = low;
        for (const glm::ivec2 v : frame.ground.moved) low = glm::min(low, v), high = glm::max(high, v);
        const int reach = SurfacePass::openness_reach(grid);
        surface.survey_terrain(glm::max(low - reach, 0), glm::min(high + reach, last_vertex));
    }

    // Heights, slopes and shares of the layers.
    if (input.marks.overlay == Overlay::kProbability) probability.bind(input);
    if (input.marks.overlay == Overlay::kWater || input.shows_wet_soil()) water.bind();
    surface.run(changed.groups());
    surface.bind();
    clock.mark(Pass::kSurface);

    // The mountains around cast shadows on the block, and heaps cast shadows too.
    if (input.surrounded()) {
        surroundings.survey(*input.surroundings, frame.block);
        surroundings.bind();
    }
    land.bind(input);
    sweep.run(input.world, input.surroundings, frame.block);
    shadow.upload(sweep);
    shadow.bind();
    changed.add_shadows(sweep, frame.block);
    clock.mark(Pass::kShadow);
}

// Finds what is in view, and where the frame differs from the last one.
void Renderer::Parts::find(Frame& frame) {
    const FrameInput& input = frame.input;
    WhatChanged& changed = redrawn.world;
    changed.add_ring(redrawn.ring, input.marks.ring, frame.block);
    changed.add_outline(redrawn.outline, input.marks.outline, frame.block);
    if (input.marks.extent != 0) changed.add_extent(extent.send(input.extent, input.world.grid));

    const int across = target.samples_across(), up = target.samples_up();
    const OnScreen screen(frame.block.clip_from_world, across, up);
    for (ScreenTiles* each : {&redrawn.scene_tiles, &redrawn.ignored_tiles})
        each->begin(across, up, rules.tile);
    if (frame.everything)
        redrawn.scene_tiles.mark_all();
    else
        changed.mark(screen, redrawn.scene_tiles);
    const Redraw redraw{frame.block, changed, screen, frame.everything,
                        rules.things ? redrawn.scene_tiles : redrawn.ignored_tiles};
    terrain.find(redraw);
    const Rectangle coarse = coarse_ground.target().all();
    const OnScreen ground_screen =
        is_coarse() ? OnScreen(frame.coarse_block.clip_from_world, coarse.right, coarse.top) : screen;
    tiles.find(input, ground_screen, rules.parts_by_kind);
    if (!frame.everything) tiles.mark_changes(redrawn.scene_tiles);
    if (input.surrounded()) surroundings.find(redraw);
    structures.find(input, redraw);
    carried.find(input, redraw);
    frame.wooded = input.may_have_trees() && trees.any();
    if (frame.wooded) trees.find(input, redraw);
    frame.powdery = powder.find(input.powder, frame.block, input.look, input.powder_strength, across, up,
                                input.whole.has_value());
    frame.drifting = may_drift(input) &&
                     spindrift.find(*input.surroundings, input.wind, input.seconds, frame.block, screen);
    redrawn.find(input.width, input.height, target.samples(), rules, frame.powdery ? powder.seen() : kNowhere,
                 frame.drifting ? spindrift.seen() : kNowhere);
    if (input.flows() && !redrawn.scene.empty()) flow.find(triangles.runs(), changed, ground_screen);
    clock.mark(Pass::kChanges);
}

void Renderer::Parts::draw(const Frame& frame) {
    const FrameInput& input = frame.input;
    const Marks& marks = input.marks;

    // Depth comes first, because shading is expensive.
    target.begin_scene(redrawn.scene);
    terrain.draw_depth(redrawn.scene);
    clock.mark(Pass::kDepth);

    if (marks.extent != 0) extent.bind();
    if (is_coarse())
        shade_coarse_ground(frame);
    else
        shade_ground(frame, target, marks, redrawn.scene);
    if (input.flows() && marks.flow_mesh) {
        flow.draw_mesh(target.samples());
        clock.mark(Pass::kFlow);
    }

    // Mountains stand around the surface, or it has walls.
    if (input.surrounded())
        surroundings.draw(input.ground_kind(), redrawn.scene);
    else
        terrain.draw_walls(redrawn.scene);
    clock.mark(Pass::kSurroundings);

    // Powder is drawn into coarse pixels of its own, which must know how far the ground is behind them, not the trees
    // in front: their outlines are finer.
    target.keep_ground(redrawn.scene);
    if (frame.powdery) powder.draw();
    clock.mark(Pass::kPowder);

    // The sky is drawn where nothing is. It is smooth, so that a sixteenth of its pixels are enough; sun, moon and
    // stars are not.
    if (frame.everything) {
        target.begin_sky();
        sky.draw();
    }
    target.begin_backdrop();
    (frame.block.above.w > 0 ? night_lights : day_lights).draw_behind(redrawn.scene);
    clock.mark(Pass::kSky);

    // What people have built stands before ground and sky, and so do trees, with a jagged outline. Their shadows darken
    // the ground that is drawn.
    if (structures.any()) structures.draw(redrawn.scene);
    if (carried.any()) carried.draw(redrawn.scene);
    clock.mark(Pass::kStructures);
    if (frame.wooded) trees.draw(input.ground_kind(), redrawn.scene);
    clock.mark(Pass::kTrees);

    // What floats in the air lies over everything that is not nearer, and casts a shadow on the ground.
    const bool in_air = frame.powdery || frame.drifting;
    if (in_air) target.begin_air(redrawn.air);
    if (frame.drifting) spindrift.draw();
    if (frame.powdery) powder.lay_over();
    clock.mark(Pass::kPowder);

    // A photo takes all light that there is; then tones are mapped, because light adds up only while it is linear.
    GLuint light = target.average(redrawn.shown, in_air);
    if (input.lens)
        light = lens.draw(target, light, *input.lens, input.image().height);
    else
        lens.forget();
    target.begin_picture(light);
    tone.draw_encoded(redrawn.shown);
    clock.mark(Pass::kTone);

    // With one sample per pixel edges have stairs. They are smoothed last of all, in the colours that the screen shows,
    // because what looks like an edge is decided there.
    if (target.samples() == 1) {
        target.begin_edges(redrawn.smoothed);
        edge_marks.draw_marks(redrawn.smoothed);
        edges.draw_on_marks(redrawn.smoothed);
    }
    clock.mark(Pass::kEdges);

    redrawn.world.finish();
    redrawn.key = frame.key;
    redrawn.ring = marks.ring;
    redrawn.outline = marks.outline;
}

void Renderer::Parts::shade_ground(const Frame& frame, const Target& on, const Marks& marks,
                                   Target::Parts parts) {
    const FrameInput& input = frame.input;
    // The visible colours of the flow are drawn unlit, so that terrain and flow are lit together.
    if (input.flows()) flow.draw(input.look, marks.overlay, on, parts);
    clock.mark(Pass::kFlow);

    // Each pixel is shaded once, whatever the number of triangles under it.
    on.begin_shading();
    terrain.shade(marks, tiles, input.ground_kind(), on, parts);
    clock.mark(Pass::kTerrain);
}

// Lines of marks are drawn as they are spread, as fine as the frame.
void Renderer::Parts::shade_coarse_ground(const Frame& frame) {
    const Marks& marks = frame.input.marks;
    Marks overlay;
    overlay.overlay = marks.overlay;
    const Rectangle all = coarse_ground.target().all();
    glNamedBufferSubData(coarse_block.name(), 0, sizeof frame.coarse_block, &frame.coarse_block);
    glBindBufferBase(GL_UNIFORM_BUFFER, SLOT_FRAME, coarse_block.name());
    coarse_ground.begin(target);
    shade_ground(frame, coarse_ground.target(), overlay, {&all, 1});
    glBindBufferBase(GL_UNIFORM_BUFFER, SLOT_FRAME, frame_block.name());
    coarse_ground.spread(target, marks.has_lines());
    clock.mark(Pass::kTerrain);
}

Picture Renderer::read_back() const {
    return parts_->target.read_back();
}

void Renderer::show_on(unsigned framebuffer, int width, int height) const {
    parts_->target.copy_to(framebuffer, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
}

void Renderer::wait() const {
    glFinish();
}

}  // namespace render
