// The module's functions, for a page (assets/web/live_worker.js calls them). Numbers go in and
// out as they are; text goes in through in_buffer(), and comes out at out_at(), out_size() bytes of UTF-8. A call that fails
// returns a negative number and leaves its sentence there. Without an open world nothing but open() may be called.
#include <cstdint>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "game/base/limits.h"
#include "game/live/live_world.h"
#include "game/live/page.h"
#include "game/live/picture.h"
#include "game/recording/live_mark.h"
#include "sim/core/float_environment.h"
#include "terrains/json_reader.h"

#define EXPORTED(name) extern "C" __attribute__((export_name(#name), used))

namespace game {
namespace {

constexpr int kDone = 1, kNot = 0, kFailed = -1;
constexpr terrains::JsonLimits kQuestion{.depth = 4, .values = 64, .members = 16};

std::string given, told;  // the texts that came in and go out
std::optional<LiveWorld> world;
LivePicture picture;
const render::FlowMesh* flow_mesh = nullptr;                          // made last
static_assert(sizeof(render::FlowMeshVertex) == 20 * sizeof(float));  // as Picture.drawFlow() has them
static_assert(sizeof(LivePicture::Planted) == 10 * sizeof(float));    // as TreesInView.plant() has them

int fails(std::string sentence) {
    told = std::move(sentence);
    return kFailed;
}
int fails(const Failure& failure) {
    return fails(failure.sentence);
}
int says(std::string text) {
    told = std::move(text);
    return kDone;
}
int says(const Json& json) {
    return says(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

const sim::State& state() {
    return world->state();
}

}  // namespace

EXPORTED(in_buffer) char* in_buffer(std::size_t size) {
    given.assign(size, '\0');
    return given.data();
}
EXPORTED(out_at) const char* out_at() {
    return told.data();
}
EXPORTED(out_size) std::size_t out_size() {
    return told.size();
}

// In: a name, a line break, and a recording. Out: what stays the same (LiveWorld::facts()), or what is wrong with it.
EXPORTED(open) int open_recording() {
    std::set_new_handler([] {
        constexpr std::string_view kWords = "no memory is left";
        page_ended(kWords.data(), kWords.size());
    });
    if (const auto fault = sim::float_environment_fault())
        return fails("In this browser " + std::string(*fault) + ", so that it would compute another slide");
    const std::size_t end = given.find('\n');
    if (end == std::string::npos) return fails("no name");
    std::string name = given.substr(0, end);
    given.erase(0, end + 1);
    world.reset();
    picture = {};
    auto opened = LiveWorld::open(given, std::move(name));
    given = {};
    if (!opened) return fails(opened.error());
    world.emplace(std::move(*opened));
    return says(world->facts());
}

// Out: what is known now (LiveWorld::status()).
EXPORTED(status) int status() {
    return says(world->status());
}
// Returns how many ticks were done. Out: a sentence if something was refused, else nothing.
EXPORTED(advance) int advance(int ticks) {
    const LiveWorld::Advanced done = world->advance(ticks);
    told = done.told ? done.told->sentence : std::string();
    return done.ticks;
}
// 1: it is there; 0: not yet.
EXPORTED(seek) int seek(double tick, int most_ticks) {
    const auto there = world->seek(static_cast<std::int64_t>(tick), most_ticks);
    if (!there) return fails(there.error());
    return *there ? kDone : kNot;
}
EXPORTED(take_over) int take_over() {
    const auto taken = world->take_over();
    return taken ? kDone : fails(taken.error());
}

EXPORTED(press) void press(int shift, int control, double x, double y) {
    world->press({.shift = shift != 0, .control = control != 0}, {x, y});
}
EXPORTED(move) void move(double x, double y) {
    world->move_to(glm::dvec2(x, y));
}
EXPORTED(leave) void leave() {
    world->move_to(std::nullopt);
}
EXPORTED(release) void release() {
    world->release();
}
EXPORTED(would_act) int would_act() {
    return world->would_act() ? kDone : kNot;
}
// In: as LiveWorld::set_brush().
EXPORTED(brush) int brush() {
    const auto json = terrains::read_json<Json>(given, kQuestion);
    if (!json) return fails(json.error());
    const auto set = world->set_brush(*json);
    return set ? kDone : fails(set.error());
}
// Out: the name of the action.
EXPORTED(undo) int undo() {
    auto name = world->undo();
    return name ? says(std::move(*name)) : fails(name.error());
}
EXPORTED(redo) int redo() {
    auto name = world->redo();
    return name ? says(std::move(*name)) : fails(name.error());
}
// Out: the recording, as if it ended here.
EXPORTED(recorded) int recorded() {
    auto text = world->recorded();
    return text ? says(std::move(*text)) : fails(text.error());
}
// What is left to save of a world that has ended: these two may be called then, and nothing else.
EXPORTED(remains_at) const char* remains_at() {
    return world ? world->recorded_in_place().data() : nullptr;
}
EXPORTED(remains_size) std::size_t remains_size() {
    return world ? world->recorded_in_place().size() : 0;
}

// How the replay has compared with what is watched: 1 exact so far, 0 not proven. Out, if it differs: where.
EXPORTED(verdict) int verdict() {
    const auto found = world->sandbox().verdict();
    if (!found) return fails("nothing is watched");
    if (found->parted) return fails(*found->parted);
    return found->kind() == Verdict::Kind::kExact ? kDone : kNot;
}
// How many ticks have been compared, and until which every recorded state is equal; −1: none.
EXPORTED(compared) double compared() {
    const auto found = world->sandbox().verdict();
    return found ? static_cast<double>(found->compared) : 0;
}
EXPORTED(proven_until) double proven_until() {
    const auto found = world->sandbox().verdict();
    return found ? static_cast<double>(found->proven_tick) : -1;
}

// What tells a program that this module is its own.
EXPORTED(mark) const char* mark() {
    return kLiveMark.data();
}

// Fields, the ground without buildings first, and last the earth by which it was raised, which may be null: rows of `stride` floats from vertex (0, 0) on, row 0 the south. Memory may move at any call.
EXPORTED(columns) int columns() {
    return state().grid.nx;
}
EXPORTED(rows) int rows() {
    return state().grid.ny;
}
EXPORTED(stride) int stride() {
    return static_cast<int>(state().bedrock.stride());
}
EXPORTED(field) const float* field(int which) {
    const sim::State& s = state();
    const sim::Field<float>* const fields[] = {which == 0 ? &picture.ground(*world) : &s.bedrock,
                                               &s.depth,
                                               &s.rolling,
                                               &s.velocity_x,
                                               &s.velocity_y,
                                               s.things ? &s.things->earth : nullptr};
    return fields[which] ? fields[which]->row(0) : nullptr;
}
// One value per vertex, without gaps: greatest depth and speed in plan.
EXPORTED(peak) const float* peak(int which) {
    const Peaks& peaks = world->sandbox().session().peaks();
    return which == 0 ? peaks.depth.data() : peaks.speed_plan.data();
}
// Two bytes per vertex of a world with two materials; what has become of the forest; or null.
EXPORTED(mixture) const std::uint8_t* mixture() {
    return picture.mixture(*world).empty() ? nullptr : picture.mixture(*world).data();
}
EXPORTED(stands) const std::uint8_t* stands() {
    return picture.stands(*world).empty() ? nullptr : picture.stands(*world).data();
}
// What people have built, as triangles. First the page fills the cover of tick 0 (LivePicture::cover()): two floats a vertex.
EXPORTED(cover) glm::vec2* cover(std::size_t vertices) {
    picture.cover().assign(vertices, glm::vec2(0));
    return picture.cover().data();
}
// 1 if it has changed since the last call. The direction of the light is a unit vector.
EXPORTED(build) int build(double x, double y, double z) {
    return picture.build(*world, glm::vec3(x, y, z)) ? kDone : kNot;
}
// Floats of faces (0), ropes (1) and shadows (2), vertex after vertex.
EXPORTED(built) int built(int which) {
    const std::size_t bytes = which == 0   ? std::span(picture.faces()).size_bytes()
                              : which == 1 ? std::span(picture.ropes()).size_bytes()
                                           : std::span(picture.shadows()).size_bytes();
    return static_cast<int>(bytes / sizeof(float));
}
EXPORTED(built_at) const void* built_at(int which) {
    return which == 0   ? static_cast<const void*>(picture.faces().data())
           : which == 1 ? static_cast<const void*>(picture.ropes().data())
                        : static_cast<const void*>(picture.shadows().data());
}
// Triangles of debris (LivePicture::flow()): makes them; how many floats its vertices have, or −1: none.
EXPORTED(flow) int flow() {
    flow_mesh = picture.flow(*world);
    return flow_mesh ? static_cast<int>(flow_mesh->vertices().size_bytes() / sizeof(float)) : -1;
}
EXPORTED(flow_vertices) const void* flow_vertices() {
    return flow_mesh->vertices().data();
}
EXPORTED(flow_indices) const std::uint32_t* flow_indices() {
    return flow_mesh->indices().data();
}
EXPORTED(flow_count) int flow_count() {
    return static_cast<int>(flow_mesh->indices().size());
}
// Trees that people have planted (LivePicture::plant()): 1 if they have changed since the last call; ten floats each.
EXPORTED(plant) int plant() {
    return picture.plant(*world) ? kDone : kNot;
}
EXPORTED(planted) int planted() {
    return static_cast<int>(picture.planted().size());
}
EXPORTED(planted_at) const void* planted_at() {
    return picture.planted().data();
}
EXPORTED(planted_tiles) int planted_tiles() {
    return static_cast<int>(picture.planted_counts().size());
}
EXPORTED(planted_counts) const std::uint32_t* planted_counts() {
    return picture.planted_counts().data();
}
// sim::powder::Puff, one after the other.
EXPORTED(puffs) int puffs() {
    return static_cast<int>(world->sandbox().session().powder().size());
}
EXPORTED(puffs_at) const void* puffs_at() {
    return world->sandbox().session().powder().data();
}

}  // namespace game
