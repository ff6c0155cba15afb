#include "render/frame.h"

#include <utility>

#include <glm/common.hpp>

#include "assets/shaders/slots.glsl"
#include "render/flow/flow_triangles.h"
#include "render/frame/make_frame_block.h"
#include "render/frame/redrawn.h"
#include "render/frame/slide_tiles.h"
#include "render/gl/scoped_state.h"
#include "render/gl/stage_clock.h"
#include "render/mountain/ground_mesh.h"
#include "render/mountain/sun_sweep.h"
#include "render/mountain/without_buildings.h"
#include "render/passes/drawn_extent.h"
#include "render/passes/fields_to_gpu.h"
#include "render/passes/flow_pass.h"
#include "render/passes/fullscreen_pass.h"
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
bool drifts(const FrameInput& input) {
    return input.surroundings && !input.surroundings->empty() && input.wind.speed > 0 &&
           is_dry_snow(input.look) && input.marks.overlay == Overlay::kNone;
}

}  // namespace

struct Renderer::Parts {
    WithoutBuildings without_buildings;
    FieldsToGpu fields;
    Buffer frame_block;
    SurfacePass surface;
    SunSweep sweep;
    ShadowPass shadow;
    TerrainPass terrain;
    SlideTiles tiles;
    FlowPass flow;
    FlowTriangles triangles;
    SurroundingsPass surroundings;
    FullscreenPass sky, day_lights, night_lights;
    StructuresPass structures;
    TreesPass trees;
    SpindriftPass spindrift;
    PowderPass powder;
    FullscreenPass tone;
    FullscreenPass edge_marks, edges;
    Target target;
    Quality quality;
    std::filesystem::path assets;
    StageClock clock;
    Redrawn redrawn;
    RedrawRules rules;
    DrawnExtent extent;

    // The factor for the colours of a flow's texture. A rolling layer keeps its own mean colour.
    glm::vec3 flow_tint(const Look& look, const Marks& marks) const {
        if (look.flow->everywhere || marks.overlay == Overlay::kStretch) return glm::vec3(1);
        return look.rolling / flow.mean_colour(look.flow->pattern);
    }
};

tl::expected<Renderer, std::string> Renderer::create(const std::filesystem::path& assets, Quality quality) {
    const std::filesystem::path shaders = assets / "shaders";
    auto surface = SurfacePass::create(shaders);
    if (!surface) return tl::unexpected(surface.error());
    auto terrain = TerrainPass::create(shaders);
    if (!terrain) return tl::unexpected(terrain.error());
    auto flow = FlowPass::create(shaders);
    if (!flow) return tl::unexpected(flow.error());
    auto surroundings = SurroundingsPass::create(shaders);
    if (!surroundings) return tl::unexpected(surroundings.error());
    auto sky = FullscreenPass::create(shaders, {"slots.glsl", "frame.glsl", "light.glsl", "sky.frag"});
    if (!sky) return tl::unexpected(sky.error());
    auto day_lights =
        FullscreenPass::create(shaders, {"slots.glsl", "frame.glsl", "sky_lights.frag", "stars_none.glsl"});
    if (!day_lights) return tl::unexpected(day_lights.error());
    auto night_lights =
        FullscreenPass::create(shaders, {"slots.glsl", "frame.glsl", "sky_lights.frag", "stars.glsl"});
    if (!night_lights) return tl::unexpected(night_lights.error());
    auto structures = StructuresPass::create(shaders);
    if (!structures) return tl::unexpected(structures.error());
    auto trees = TreesPass::create(shaders);
    if (!trees) return tl::unexpected(trees.error());
    auto spindrift = SpindriftPass::create(shaders);
    if (!spindrift) return tl::unexpected(spindrift.error());
    auto powder = PowderPass::create(shaders);
    if (!powder) return tl::unexpected(powder.error());
    auto tone = FullscreenPass::create(shaders, {"slots.glsl", "tone_curve.glsl", "tone.frag"});
    if (!tone) return tl::unexpected(tone.error());
    auto edge_marks = FullscreenPass::create(shaders, {"slots.glsl", "edges_mark.frag"});
    if (!edge_marks) return tl::unexpected(edge_marks.error());
    auto edges = FullscreenPass::create(shaders, {"slots.glsl", "edges.frag"});
    if (!edges) return tl::unexpected(edges.error());

    Buffer frame_block = make_buffer();
    glNamedBufferStorage(frame_block.name(), sizeof(FrameBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    return Renderer(std::make_unique<Parts>(Parts{WithoutBuildings(),
                                                  FieldsToGpu(),
                                                  std::move(frame_block),
                                                  std::move(*surface),
                                                  SunSweep(),
                                                  ShadowPass(),
                                                  std::move(*terrain),
                                                  SlideTiles(),
                                                  std::move(*flow),
                                                  FlowTriangles(),
                                                  std::move(*surroundings),
                                                  std::move(*sky),
                                                  std::move(*day_lights),
                                                  std::move(*night_lights),
                                                  std::move(*structures),
                                                  std::move(*trees),
                                                  std::move(*spindrift),
                                                  std::move(*powder),
                                                  std::move(*tone),
                                                  std::move(*edge_marks),
                                                  std::move(*edges),
                                                  Target(),
                                                  quality,
                                                  assets,
                                                  StageClock(),
                                                  Redrawn(),
                                                  RedrawRules(),
                                                  DrawnExtent()}));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

tl::expected<void, std::string> Renderer::load(FlowPattern pattern) {
    return parts_->flow.load(parts_->assets, pattern);
}

void Renderer::set_quality(Quality quality) {
    parts_->quality = quality;
}

void Renderer::forget() {
    parts_->redrawn.steady.reset();
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
    const sim::Field<float>* ground = parts_->without_buildings.find(input.world);
    if (!ground) {
        draw_ground(input);
        return;
    }
    const sim::View& w = input.world;
    draw_ground({.world = {w.grid, *ground, w.depth, w.rolling, w.velocity_x, w.velocity_y, w.site,
                           w.smooth_depth, w.mixture, w.things, w.tiles, w.datum, w.tick},
                 .camera = input.camera,
                 .light = input.light,
                 .look = input.look,
                 .marks = input.marks,
                 .flow = input.flow,
                 .width = input.width,
                 .height = input.height,
                 .first_depth = input.first_depth,
                 .surroundings = input.surroundings,
                 .powder = input.powder,
                 .powder_strength = input.powder_strength,
                 .woods = input.woods,
                 .flow_so_far = input.flow_so_far,
                 .structures = input.structures,
                 .wind = input.wind,
                 .seconds = input.seconds,
                 .extent = input.extent});
}

void Renderer::draw_ground(const FrameInput& input) {
    Parts& p = *parts_;
    const sim::View& world = input.world;
    const Marks& marks = input.marks;
    const Surroundings* const around = input.surroundings;
    const int samples = samples_of(p.quality);
    const ScopedState state;                           // restores the state for other users of the context
    const bool flows = input.look.flow && input.flow;  // the advected texture is visible
    const bool has_surroundings = around && !around->empty();
    Redrawn& redrawn = p.redrawn;
    p.clock.begin();

    // Find out first whether more than the world changed: then all is drawn anew.
    const FieldsToGpu::Ground ground = p.fields.upload_ground(world, input.first_depth);
    const FrameBlock frame =
        make_frame_block(input, p.fields.heights(), samples,
                         flows ? std::optional(p.flow_tint(input.look, marks)) : std::nullopt);
    const Steady steady = steady_of(input, frame);
    const bool resized = p.target.resize(input.width, input.height, samples);
    p.structures.build(input, frame, ground.terrain, ground.moved);
    const bool new_world = ground.terrain || ground.first_depth || !redrawn.steady ||
                           !same_surface(redrawn.steady->block, frame);
    const bool has_trees = marks.overlay == Overlay::kNone;  // they would hide its values
    const auto trees =
        has_trees
            ? p.trees.follow(has_surroundings ? input.woods : nullptr, has_surroundings ? around : nullptr,
                             world, input.first_depth, frame.sun, ground.terrain || ground.first_depth)
            : FollowedWoods::Change::kNone;
    const bool everything = trees == FollowedWoods::Change::kAll || new_world || resized || marks.flow_mesh ||
                            redrawn.steady != steady;

    // Upload what changed of the world: everything below reads these textures, and only they change with the state.
    WhatChanged& changed = redrawn.world;
    const int openness_reach = SurfacePass::openness_reach(world.grid);
    changed.compare(world, p.fields.find_mixture(world), input.first_depth,
                    has_surroundings ? std::nullopt : std::optional(frame.ground.y), p.rules, new_world,
                    {ground.moved, openness_reach});
    p.fields.upload_layers(world, changed.first_row(), changed.last_row());
    glNamedBufferSubData(p.frame_block.name(), 0, sizeof frame, &frame);
    glBindBufferBase(GL_UNIFORM_BUFFER, SLOT_FRAME, p.frame_block.name());
    p.fields.bind();
    if (flows) p.flow.send(*input.flow);
    p.clock.mark(Pass::kUpload);

    // Apply what changed along the fronts since the last frame.
    if (flows) {
        p.flow.cut(*input.flow, world.grid);
        p.triangles.find(world, input.first_depth, p.flow.coordinates().vertices(), input.look);
        p.flow.find_changes(p.triangles, changed);
    }
    p.clock.mark(Pass::kRemesh);

    // Data that depends only on the bedrock is computed here, once per terrain and around what changed of it, because
    // it needs the fields and the frame block.
    const glm::ivec2 last_vertex(world.grid.nx - 1, world.grid.ny - 1);
    if (ground.terrain) {
        p.terrain.send_mesh(ground_mesh(world.grid, world.site));
        p.surface.resize(world.grid);
        p.shadow.resize(world.grid);
        p.surface.survey_terrain({0, 0}, last_vertex);
    } else if (!ground.moved.empty()) {
        glm::ivec2 low = ground.moved.front(), high = low;
        for (const glm::ivec2 v : ground.moved) low = glm::min(low, v), high = glm::max(high, v);
        p.surface.survey_terrain(glm::max(low - openness_reach, 0),
                                 glm::min(high + openness_reach, last_vertex));
    }

    // Compute heights, slopes and shares of the layers once per vertex, before the two passes that read them.
    p.surface.run(changed.groups());
    p.surface.bind();
    p.clock.mark(Pass::kSurface);

    // What lies around the block casts shadows on it.
    if (has_surroundings) {
        p.surroundings.survey(*around, frame);
        p.surroundings.bind();
    }

    // Heaps cast shadows too.
    p.sweep.run(world, around, frame);
    p.shadow.upload(p.sweep);
    p.shadow.bind();
    changed.add_shadows(p.sweep, frame);
    changed.add_ring(redrawn.ring, marks.ring, frame);
    changed.add_outline(redrawn.outline, marks.outline, frame);
    if (marks.extent != 0) changed.add_extent(p.extent.send(input.extent, world.grid));
    p.clock.mark(Pass::kShadow);

    // Find where the frame differs from the last one.
    const OnScreen screen(frame.clip_from_world, p.target.samples_across(), p.target.samples_up());
    ScreenTiles& tiles = redrawn.scene_tiles;
    for (ScreenTiles* each : {&tiles, &redrawn.forgotten_tiles})
        each->begin(p.target.samples_across(), p.target.samples_up(), p.rules.tile);
    if (everything)
        tiles.mark_all();
    else
        changed.mark(screen, tiles);
    ScreenTiles& with_things = p.rules.things ? tiles : redrawn.forgotten_tiles;
    const Redraw redraw{frame, changed, screen, everything, with_things};
    p.terrain.find(redraw);
    p.tiles.find(input, screen);
    p.tiles.mark_changes(tiles);
    if (has_surroundings) p.surroundings.find(redraw);
    p.structures.find(input, redraw);
    const bool wooded = has_trees && p.trees.any();
    if (wooded) p.trees.find(input, redraw);
    const bool powdery = p.powder.find(input.powder, frame, input.look, input.powder_strength,
                                       p.target.samples_across(), p.target.samples_up());
    const bool drifting =
        drifts(input) && p.spindrift.find(*around, input.wind, input.seconds, frame, screen);
    redrawn.find(input.width, input.height, samples, p.rules, powdery ? p.powder.seen() : kNowhere,
                 drifting ? p.spindrift.seen() : kNowhere);
    p.clock.mark(Pass::kChanges);

    // Draw depth first, because shading is expensive.
    p.target.begin_scene(redrawn.scene);
    p.terrain.draw_depth(redrawn.scene);
    p.clock.mark(Pass::kDepth);

    // Draw the visible colours of the flow unlit, so that terrain and flow are lit together.
    if (flows)
        p.flow.draw(input.look.flow->pattern, marks.overlay, p.target, redrawn.scene, p.triangles.runs(),
                    changed, screen);
    p.clock.mark(Pass::kFlow);

    // Shade each pixel once, whatever the number of triangles under it.
    p.target.begin_shading();
    if (marks.extent != 0) p.extent.bind();
    p.terrain.shade(marks, p.tiles, world.mixture != nullptr, p.target, redrawn.scene);
    p.clock.mark(Pass::kTerrain);

    if (flows && marks.flow_mesh) {
        p.flow.draw_mesh(samples);
        p.clock.mark(Pass::kFlow);
    }

    // Draw what stands around the surface: mountains or the walls of a block.
    if (has_surroundings)
        p.surroundings.draw(frame, redrawn.scene);
    else
        p.terrain.draw_walls(redrawn.scene);
    p.clock.mark(Pass::kSurroundings);

    // Powder is drawn into coarse pixels of its own, which must know how far the ground is behind them, not the trees
    // in front: their outlines are finer.
    p.target.keep_ground(redrawn.scene);
    if (powdery) p.powder.draw();
    p.clock.mark(Pass::kPowder);

    // The sky is drawn where nothing is. It is smooth, so that a sixteenth of its pixels are enough; sun, moon and
    // stars are not.
    if (everything) {
        p.target.begin_sky();
        p.sky.draw();
    }
    p.target.begin_backdrop();
    (frame.above.w > 0 ? p.night_lights : p.day_lights).draw_behind(redrawn.scene);
    p.clock.mark(Pass::kSky);

    // What people have built stands before ground and sky.
    if (p.structures.any()) p.structures.draw(redrawn.scene);
    p.clock.mark(Pass::kStructures);

    // Trees stand before ground and sky, with a jagged outline. Their shadows darken the ground that is drawn.
    if (wooded) p.trees.draw(redrawn.scene);
    p.clock.mark(Pass::kTrees);

    // What floats in the air lies over everything that is not nearer, and casts a shadow on the ground.
    if (powdery || drifting) p.target.begin_air(redrawn.air);
    if (drifting) p.spindrift.draw();
    if (powdery) p.powder.lay_over();
    p.clock.mark(Pass::kPowder);

    // Tone mapping is last, because light adds up only while it is linear.
    p.target.begin_picture(redrawn.shown, powdery || drifting);
    p.tone.draw_encoded(redrawn.shown);
    p.clock.mark(Pass::kTone);

    // With one sample per pixel edges have stairs. Smooth them last of all, in the colours that the screen
    // shows, because what looks like an edge is decided there.
    if (samples == 1) {
        p.target.begin_edges(redrawn.smoothed);
        p.edge_marks.draw_marks(redrawn.smoothed);
        p.edges.draw_on_marks(redrawn.smoothed);
    }
    p.clock.mark(Pass::kEdges);

    changed.finish();
    redrawn.steady = steady;
    redrawn.ring = marks.ring;
    redrawn.outline = marks.outline;
    CHECK(glGetError() == GL_NO_ERROR);
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
