#include "game/recording/format.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/base/number.h"
#include "game/base/one_line.h"
#include "game/base/version.h"
#include "game/recording/command_json.h"
#include "game/recording/goal_json.h"
#include "game/recording/ground_data.h"
#include "game/recording/things_json.h"
#include "game/scene/date.h"
#include "game/scene/flow_kinds.h"
#include "game/scene/shown_numbers.h"
#include "game/scene/standing.h"

namespace game {
namespace {

constexpr std::string_view kFormatName = "couloir";
// The name of formats 1.0 to 1.9, which no release had, and the last program that reads them.
constexpr std::string_view kFormatBeforeRelease = "couloir recording", kReaderBeforeRelease = "141cf62";
constexpr std::int64_t kMostTicks = std::int64_t{1} << 40;
constexpr int kMostMedal = 3;  // gold

// The readers below throw the fact; the public functions return it as a value.
using values::add_numbers;
using values::list;
using values::member;
using values::named;
using values::number;
using values::numbers;
using values::numbers_from;
using values::numbers_json;
using values::place_from;
using values::place_json;
using values::refuse;
using values::text;
using values::triple;
using values::whole;

std::uint64_t hash_of(const Json& json, const char* key) {
    const auto value = from_hex(text(json, key));
    if (!value) refuse(fmt::format("{} is not 16 hexadecimal digits", key));
    return *value;
}

Json params_json(const sim::Params& params) {
    Json json;
    for (const sim::ParamInfo& info : sim::kParams)
        json[std::string(info.name)] = shortest(params.*info.value);
    return json;
}

Json physics_json(const sim::Params& params) {
    Json json{{"model", sim::to_string(params.model)},
              {"scheme", sim::to_string(params.scheme)},
              {"law", sim::to_string(params.law)}};
    for (std::size_t side = 0; side < sim::kSides.size(); ++side)
        json["borders"][std::string(sim::kSides[side])] = sim::to_string(params.borders[side]);
    json.update(params_json(params));
    return json;
}

void params_from(const Json& json, int minor, sim::Params& params) {
    for (const sim::ParamInfo& info : sim::kParams)
        if (info.since <= minor)
            params.*info.value =
                static_cast<float>(number(json, info.name.data(), info.least - 1e-6, info.most + 1e-6));
    if (const auto wrong = sim::fault_of(params)) refuse(*wrong);
}

sim::Params physics_from(const Json& json, int minor) {
    sim::Params params;
    params.model = named(json, "model", sim::model_from);
    params.scheme = named(json, "scheme", sim::scheme_from);
    params.law = named(json, "law", sim::law_from);
    for (std::size_t side = 0; side < sim::kSides.size(); ++side)
        params.borders[side] = named(member(json, "borders"), sim::kSides[side].data(), sim::border_from);
    params_from(json, minor, params);
    return params;
}

std::optional<double> density_from(const Json& json) {
    if (!json.contains("density")) return std::nullopt;
    return number(json, "density", kLeastDensity, kGreatestDensity);
}

Scenario::Lower lower_from(const Json& json, int minor, const sim::Params& world) {
    Scenario::Lower lower{text(json, "material"), world, {}, density_from(json), {}, {}};
    params_from(member(json, "physics"), minor, lower.params);
    sim::take_choices(world, lower.params);
    return lower;
}

// Where the materials are mixed at tick 0.
Json mixed_json(const Scenario::Lower& lower) {
    Json json;
    if (!lower.settled.empty()) json["settled"] = pack_metres(lower.settled);
    if (!lower.rolling.empty()) json["rolling"] = pack_metres(lower.rolling);
    return json;
}

// After the ground, whose layers bound them.
void mixed_from(const Json& json, Scenario& scenario) {
    const auto read = [&](const char* key, std::vector<float>& part) {
        if (!json.contains(key)) return;
        auto metres = unpack_metres(text(json, key), scenario.grid.size());
        if (!metres) refuse(fmt::format("mixed: {}: {}", key, metres.error()));
        part = std::move(*metres);
    };
    if (!json.is_object()) refuse("mixed is not an object");
    read("settled", scenario.lower->settled);
    read("rolling", scenario.lower->rolling);
    if (const auto wrong = fault_of_mixed(scenario)) refuse("mixed: " + *wrong);
}

Json ground_json(const Scenario& scenario) {
    Json json{{"name", scenario.terrain},
              {"licence", scenario.licence},
              {"nx", scenario.grid.nx},
              {"ny", scenario.grid.ny},
              {"dx", shortest(scenario.grid.dx)},
              {"datum", scenario.datum},
              {"hash", hex(ground_hash(scenario))}};
    if (scenario.georeference.has_coordinates())
        json["georeference"] = {{"wkt", scenario.georeference.wkt()},
                                {"x", scenario.georeference.origin_x()},
                                {"y", scenario.georeference.origin_y()}};
    json["data"] = pack_ground(scenario);
    return json;
}

void ground_from(const Json& json, const Memory& memory, bool has_things, Scenario& scenario) {
    scenario.terrain = text(json, "name");
    scenario.licence = text(json, "licence");
    scenario.grid.nx = static_cast<int>(whole(json, "nx", 3, kMostVertices));
    scenario.grid.ny = static_cast<int>(whole(json, "ny", 3, kMostVertices));
    scenario.grid.dx =
        static_cast<float>(number(json, "dx", terrains::kSmallestCell, terrains::kLargestCell));
    if (const auto allowed = memory.allows(scenario.grid, scenario.lower.has_value(), has_things); !allowed)
        refuse(allowed.error());
    scenario.datum = number(json, "datum", -2e4, 2e4);
    if (json.contains("georeference")) {
        const Json& place = member(json, "georeference");
        const std::string wkt = text(place, "wkt");
        const double x = number(place, "x", -1e9, 1e9), y = number(place, "y", -1e9, 1e9);
        scenario.georeference = wkt.empty() ? terrains::Georeference::unnamed(x, y)
                                            : terrains::Georeference::projected(wkt, x, y);
    }
    if (!member(json, "data").is_string()) refuse("data is not a string");
    if (const auto unpacked = unpack_ground(member(json, "data").get_ref<const std::string&>(), scenario);
        !unpacked)
        refuse(unpacked.error());
    if (ground_hash(scenario) != hash_of(json, "hash"))
        refuse(fmt::format("its terrain is not the '{}' that it was recorded on: the hash is {}, not {}",
                           scenario.terrain, hex(ground_hash(scenario)), text(json, "hash")));
}

// A flow scene; this includes how it is viewed.
Json flow_json(const Scenario::Flow& flow, const render::FlowLook& look) {
    Json json{{"kind", kFlowKinds[static_cast<std::size_t>(flow.flow.kind)]},
              {"angle_rad", flow.flow.angle},
              {"through", {{"x", flow.flow.through.x}, {"y", flow.flow.through.y}}}};
    add_numbers(kFlowNumbers, flow.numbers, json);
    json["source"] = sim::front::to_string(flow.numbers.source);
    add_numbers(kFlowLookNumbers, look, json);
    return json;
}

void flow_from(const Json& json, Scenario& scenario) {
    const auto kind = std::find(kFlowKinds.begin(), kFlowKinds.end(), text(json, "kind"));
    const auto source = sim::front::source_named(text(json, "source"));
    if (kind == kFlowKinds.end()) refuse(fmt::format("flow: unknown kind '{}'", text(json, "kind")));
    if (!source || *source == sim::front::PointSource::kLevel)
        refuse(fmt::format("flow: unknown source '{}'", text(json, "source")));
    if (!scenario.look.flow) refuse("flow: the look has no texture");
    if (scenario.grid.nx != scenario.grid.ny || scenario.grid.nx > kMostFlowSquares + 1)
        refuse(fmt::format("flow: the ground is not square, or has more than {} squares along a side",
                           kMostFlowSquares));
    Scenario::Flow flow;
    flow.flow.kind = static_cast<sim::fields::TestFlow::Kind>(kind - kFlowKinds.begin());
    flow.flow.angle = number(json, "angle_rad", -10, 10);
    const Json& through = member(json, "through");
    flow.flow.through = {number(through, "x", 0, 1), number(through, "y", 0, 1)};
    numbers_from(json, kFlowNumbers, flow.numbers);
    flow.numbers.source = *source;
    scenario.flow = flow;
    scenario.look.flow->everywhere = true;
    numbers_from(json, kFlowLookNumbers, *scenario.look.flow);
}

Json trees_json(const render::TreeRules& trees) {
    Json json = numbers_json(kTreeNumbers, trees);
    json["seed"] = trees.seed;
    for (const glm::dvec2& corner : trees.polygon) json["polygon"].push_back(place_json(corner));
    if (!trees.shares.empty()) json["shares"] = pack_bytes(trees.shares);
    return json;
}

// After the ground, of whose vertices the shares are.
render::TreeRules trees_from(const Json& json, const sim::Grid& grid) {
    render::TreeRules trees;
    numbers_from(json, kTreeNumbers, trees);
    trees.seed = static_cast<std::uint32_t>(whole(json, "seed", 0, 1'000'000));
    for (const Json& corner : list(json, "polygon", kMostTreeCorners))
        trees.polygon.push_back(place_from(corner));
    if (json.contains("polygon") && trees.polygon.size() < kFewestTreeCorners)
        refuse(fmt::format("trees: polygon has fewer than {} corners", kFewestTreeCorners));
    if (json.contains("shares")) {
        auto shares = unpack_bytes(text(json, "shares"), grid.size());
        if (!shares) refuse("trees: " + shares.error());
        trees.shares = std::move(*shares);
    }
    return trees;
}

void add_camera(const render::Camera& camera, Json& json) {
    json["target"] = numbers({camera.target.x, camera.target.y, camera.target.z});
    add_numbers(kCameraNumbers, camera, json);
}

Json view_json(const Scenario& scenario) {
    const render::Look& look = scenario.look;
    const auto colour = [](const glm::vec3& c) {
        return numbers({shortest(c.x), shortest(c.y), shortest(c.z)});
    };
    Json json;
    json["look"] = {{"rock", colour(look.rock)},
                    {"meadow", colour(look.meadow)},
                    {"standing", colour(look.standing)},
                    {"rolling", colour(look.rolling)}};
    add_numbers(kLookNumbers, look, json["look"]);
    if (scenario.lower) {
        json["look"]["lower_standing"] = colour(look.lower_standing);
        json["look"]["lower_rolling"] = colour(look.lower_rolling);
    }
    if (look.turf) json["look"]["turf"] = colour(*look.turf);
    if (look.lower_turf) json["look"]["lower_turf"] = colour(*look.lower_turf);
    const auto powder = [&](const char* key, const render::PowderLook& of) {
        if (of.strength <= 0) return;
        json["look"][key] = numbers_json(kPowderNumbers, of);
        json["look"][key]["colour"] = colour(of.colour);
    };
    powder("powder", look.powder);
    if (scenario.lower) powder("lower_powder", look.lower_powder);
    if (scenario.model) json["look"]["style"] = "model";
    if (look.date) json["look"]["date"] = to_string(*look.date);
    if (scenario.trees.density > 0) json["trees"] = trees_json(scenario.trees);
    if (scenario.wind.speed > 0) json["wind"] = numbers_json(kWindNumbers, scenario.wind);
    if (look.flow) json["look"]["texture"] = to_string(look.flow->pattern);
    if (scenario.flow) json["flow"] = flow_json(*scenario.flow, *look.flow);
    json["light"] = numbers_json(kLightNumbers, scenario.light);
    if (scenario.camera) add_camera(*scenario.camera, json["camera"]);
    for (const CameraKey& key : scenario.camera_path) {
        Json row{{"time_s", key.time_s}};
        add_camera(key.camera, row);
        json["camera_path"].push_back(std::move(row));
    }
    return json;
}

render::Camera camera_from(const Json& json) {
    render::Camera camera;
    camera.target = triple(json, "target", -kFarthestTarget, kFarthestTarget);
    numbers_from(json, kCameraNumbers, camera);
    return camera;
}

void camera_path_from(const Json& json, std::vector<CameraKey>& path) {
    for (const Json& row : list(json, "camera_path", kMostCameraKeys)) {
        const double time = number(row, "time_s", 0, CameraKey::kLatest);
        if (!path.empty() && time <= path.back().time_s)
            refuse(fmt::format("camera_path: {} s is not later than {} s", time, path.back().time_s));
        path.push_back({time, camera_from(row)});
    }
    if (!path.empty() && path.size() < kFewestCameraKeys)
        refuse(fmt::format("camera_path has fewer than {} keys", kFewestCameraKeys));
}

void view_from(const Json& json, Scenario& scenario) {
    const Json& look = member(json, "look");
    scenario.look.rock = triple(look, "rock", 0, 1);
    scenario.look.meadow = triple(look, "meadow", 0, 1);
    scenario.look.standing = triple(look, "standing", 0, 1);
    scenario.look.rolling = triple(look, "rolling", 0, 1);
    if (scenario.lower) {
        scenario.look.lower_standing = triple(look, "lower_standing", 0, 1);
        scenario.look.lower_rolling = triple(look, "lower_rolling", 0, 1);
    }
    if (look.contains("turf")) scenario.look.turf = glm::vec3(triple(look, "turf", 0, 1));
    if (look.contains("lower_turf")) scenario.look.lower_turf = glm::vec3(triple(look, "lower_turf", 0, 1));
    const auto powder = [&](const char* key, render::PowderLook& of) {
        if (!look.contains(key)) return;
        const Json& from = member(look, key);
        numbers_from(from, kPowderNumbers, of);
        of.colour = triple(from, "colour", 0, 1);
    };
    powder("powder", scenario.look.powder);
    powder("lower_powder", scenario.look.lower_powder);
    numbers_from(look, kLookNumbers, scenario.look);
    if (look.contains("style")) {
        scenario.model = text(look, "style") == "model";
        if (!scenario.model) refuse(fmt::format("look: unknown style '{}'", text(look, "style")));
    }
    if (look.contains("date")) {
        scenario.look.date = date_from(text(look, "date"));
        if (!scenario.look.date) refuse(fmt::format("look: '{}' is no day of a year", text(look, "date")));
    }
    if (look.contains("texture")) {
        const auto pattern = render::flow_pattern_named(text(look, "texture"));
        if (!pattern) refuse(fmt::format("look: unknown texture '{}'", text(look, "texture")));
        scenario.look.flow = render::FlowLook{*pattern};
    }
    if (json.contains("wind")) numbers_from(member(json, "wind"), kWindNumbers, scenario.wind);
    if (json.contains("flow")) flow_from(member(json, "flow"), scenario);
    numbers_from(member(json, "light"), kLightNumbers, scenario.light);
    if (json.contains("camera")) scenario.camera = camera_from(member(json, "camera"));
    camera_path_from(json, scenario.camera_path);
}

// Returns the minor version.
int version_from(const Json& json) {
    const Json& version = member(json, "version");
    if (!version.is_array() || version.size() != 2 || !version[0].is_number_integer() ||
        !version[1].is_number_integer())
        refuse("version is not two whole numbers");
    const auto major = version[0].get<std::int64_t>(), minor = version[1].get<std::int64_t>();
    if (major > kFormatMajor)
        refuse(fmt::format("recorded in format {}.{}, and this program reads up to {}.x: use a newer couloir",
                           major, minor, kFormatMajor));
    if (major < 1 || minor < 0) refuse(fmt::format("format {}.{} does not exist", major, minor));
    return static_cast<int>(std::min<std::int64_t>(minor, 1 << 20));
}

int read_version(const Json& json) {
    const bool named = json.is_object() && json.contains("format");
    if (named && json.at("format") == kFormatBeforeRelease)
        refuse(
            fmt::format("recorded before Couloir 0.1.0, in another format: the program of commit {} reads it",
                        kReaderBeforeRelease));
    if (!named || json.at("format") != kFormatName) refuse("not a couloir recording");
    return version_from(json);
}

Parent parent_from(const Json& json) {
    return {text(json, "name"), whole(json, "tick", 0, kMostTicks),
            json.contains("change") ? text(json, "change") : ""};
}

Origin origin_from(const Json& json) {
    return {version_from(json), static_cast<int>(whole(json, "physics_version", 1, 1 << 20)),
            text(json, "program")};
}

Json weather_json(const sim::Calendar& calendar) {
    Json json = Json::object();
    for (const sim::CalendarNumber& number : sim::kCalendarNumbers)
        json[std::string(number.name)] = calendar.*number.value;
    return json;
}

sim::Calendar weather_from(const Json& json, const Scenario& scenario) {
    if (!json.is_object()) refuse("weather is not an object");
    sim::Calendar calendar;
    for (const sim::CalendarNumber& number : sim::kCalendarNumbers)
        calendar.*number.value =
            values::number(json, std::string(number.name).c_str(), number.least, number.most);
    if (const auto wrong = sim::fault_of(calendar, scenario.params, scenario.density.value_or(0),
                                         scenario.lower.has_value()))
        refuse(*wrong);
    return calendar;
}

Header read_header(const Json& json, int minor, const Memory& memory) {
    Header header;
    header.minor = minor;
    if (json.contains("parent")) header.parent = parent_from(json.at("parent"));
    if (json.contains("rewritten_from")) header.rewritten_from = origin_from(json.at("rewritten_from"));
    header.program = text(json, "program");
    header.physics_version = static_cast<int>(whole(json, "physics_version", 1, 1 << 20));
    header.ticks_per_state = static_cast<int>(whole(json, "ticks_per_state", 1, kMostTicksPerState));
    Scenario& scenario = header.scenario;
    scenario.scene = text(json, "scene");
    scenario.title = text(json, "title");
    scenario.material = text(json, "material");
    scenario.density = density_from(json);
    scenario.params = physics_from(member(json, "physics"), minor);
    if (json.contains("lower")) scenario.lower = lower_from(json.at("lower"), minor, scenario.params);
    view_from(member(json, "view"), scenario);
    ground_from(member(json, "terrain"), memory, json.contains("things") || json.contains("weather"),
                scenario);
    if (scenario.lower && json.at("lower").contains("mixed"))
        mixed_from(json.at("lower").at("mixed"), scenario);
    if (const Json& view = member(json, "view"); view.contains("trees"))
        scenario.trees = trees_from(member(view, "trees"), scenario.grid);
    if (json.contains("things")) values::things_from(json.at("things"), scenario);
    if (json.contains("weather")) scenario.weather = weather_from(json.at("weather"), scenario);
    if (json.contains("goal")) scenario.goal = values::goal_from(json.at("goal"));
    return header;
}

std::vector<std::uint64_t> hashes_before(const Json& state) {
    std::vector<std::uint64_t> hashes;
    if (!state.contains("before")) return hashes;
    if (!state.at("before").is_array()) refuse("before is not a list");
    for (const Json& each : state.at("before")) {
        const auto hash = each.is_string() ? from_hex(each.get_ref<const std::string&>()) : std::nullopt;
        if (!hash) refuse("before has a value that is not 16 hexadecimal digits");
        hashes.push_back(*hash);
    }
    if (static_cast<std::int64_t>(hashes.size()) > whole(state, "tick", 0, kMostTicks))
        refuse("before goes back beyond tick 0");
    return hashes;
}

Line read_line(const Json& json) {
    if (!json.is_object()) refuse("not an object");
    if (json.contains("end")) return EndLine{whole(json, "end", 0, kMostTicks)};
    if (json.contains("hash")) {
        const Json& mass = member(json, "mass");
        const auto quanta = [&](const char* key) { return whole(mass, key, INT64_MIN / 8, INT64_MAX / 8); };
        return StateLine{
            whole(json, "tick", 0, kMostTicks),
            hash_of(json, "hash"),
            hashes_before(json),
            {0, quanta("standing"), quanta("rolling"), quanta("out"), quanta("poured"), quanta("dug"),
             mass.contains("fallen") ? quanta("fallen") : 0, mass.contains("melted") ? quanta("melted") : 0}};
    }
    if (json.contains("score"))
        return ClaimLine{whole(json, "tick", 0, kMostTicks),
                         whole(json, "score", INT64_MIN / 8, INT64_MAX / 8),
                         static_cast<int>(whole(json, "medal", 0, kMostMedal))};
    const sim::CommandInfo* const info = values::kind_in(json);
    if (!info) refuse("a line of unknown kind");
    const std::int64_t tick = whole(json, "tick", 0, kMostTicks);
    return TimedCommand{tick, values::command_from(json, *info)};
}

}  // namespace

Json to_json(const Header& header) {
    const Scenario& scenario = header.scenario;
    Json json{{"format", kFormatName},
              {"version", {kFormatMajor, kFormatMinor}},
              {"physics_version", header.physics_version},
              {"program", kProgram},
              {"scene", scenario.scene},
              {"title", scenario.title},
              {"material", scenario.material},
              {"ticks_per_state", header.ticks_per_state},
              {"physics", physics_json(scenario.params)},
              {"view", view_json(scenario)}};
    if (scenario.density) json["density"] = *scenario.density;
    if (const auto& parent = header.parent) {
        json["parent"] = {{"name", parent->name}, {"tick", parent->tick}};
        if (!parent->change.empty()) json["parent"]["change"] = parent->change;
    }
    if (const auto& origin = header.rewritten_from)
        json["rewritten_from"] = {{"version", {kFormatMajor, origin->minor}},
                                  {"physics_version", origin->physics_version},
                                  {"program", origin->program}};
    if (scenario.lower)
        json["lower"] = {{"material", scenario.lower->material},
                         {"physics", params_json(scenario.lower->params)}};
    if (scenario.lower && scenario.lower->density) json["lower"]["density"] = *scenario.lower->density;
    if (scenario.lower)
        if (Json mixed = mixed_json(*scenario.lower); !mixed.empty())
            json["lower"]["mixed"] = std::move(mixed);
    json["terrain"] = ground_json(scenario);
    if (!scenario.standing.empty()) json["things"] = values::things_json(scenario);
    if (scenario.weather) json["weather"] = weather_json(*scenario.weather);
    if (scenario.goal) json["goal"] = values::goal_json(*scenario.goal);
    return json;
}

tl::expected<void, std::string> check_format(const Json& json) try {
    read_version(json);
    return {};
} catch (const std::exception& wrong) {
    return tl::unexpected(std::string(wrong.what()));
}

tl::expected<Header, std::string> header_from(const Json& json, const Memory& memory) {
    int minor = 0;
    try {
        minor = read_version(json);
        return read_header(json, minor, memory);
    } catch (const std::exception& wrong) {
        return tl::unexpected(noting_newer(wrong.what(), minor));
    }
}

void take_numbers(const sim::Params& from, sim::Params& to) {
    for (const sim::ParamInfo& info : sim::kParams)
        if (!info.fixed) to.*info.value = from.*info.value;
}

bool is_comparable(const Header& header) {
    return header.physics_version == kPhysicsVersion;
}

std::string noting_newer(std::string fact, int minor) {
    if (minor <= kFormatMinor) return fact;
    return fmt::format("{}; recorded in format {}.{}, and this program knows {}.{}: use a newer couloir",
                       fact, kFormatMajor, minor, kFormatMajor, kFormatMinor);
}

void write(const TimedCommand& timed, std::string& line) {
    fmt::format_to(std::back_inserter(line), R"({{"tick":{},)", timed.tick);
    values::write(timed.command, line);
    line += '}';
}

void write(const StateLine& state, std::string& line) {
    const sim::Ledger& mass = state.ledger;
    const auto out = std::back_inserter(line);
    fmt::format_to(out, R"({{"tick":{},)", state.tick);
    if (!state.before.empty()) {
        line += R"("before":[)";
        for (const std::uint64_t hash : state.before) fmt::format_to(out, R"("{:016x}",)", hash);
        line.back() = ']';
        line += ',';
    }
    fmt::format_to(out,
                   R"("hash":"{:016x}","mass":{{"standing":{},"rolling":{},"out":{},"poured":{},"dug":{})",
                   state.hash, mass.standing, mass.rolling, mass.out, mass.poured, mass.dug);
    if (mass.fallen != 0) fmt::format_to(out, R"(,"fallen":{})", mass.fallen);
    if (mass.melted != 0) fmt::format_to(out, R"(,"melted":{})", mass.melted);
    line += "}}";
}

void write(const ClaimLine& claim, std::string& line) {
    fmt::format_to(std::back_inserter(line), R"({{"tick":{},"score":{},"medal":{}}})", claim.tick,
                   claim.score, claim.medal);
}

void write(const EndLine& end, std::string& line) {
    fmt::format_to(std::back_inserter(line), R"({{"end":{}}})", end.tick);
}

tl::expected<Line, std::string> line_from(const Json& json) try {
    return read_line(json);
} catch (const std::exception& wrong) {
    return tl::unexpected(std::string(wrong.what()));
}

std::string printed(const Json& json) {
    return printable_json(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string hex(std::uint64_t value) {
    return fmt::format("{:016x}", value);
}

std::optional<std::uint64_t> from_hex(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (text.size() != 16 || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace game
