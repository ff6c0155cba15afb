#include "game/python/world.h"

#include <cmath>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "game/analysis/headless.h"
#include "game/recording/format.h"
#include "game/recording/recording_file.h"
#include "game/session/loaded_world.h"
#include "sim/named_fields.h"
#include "terrains/limits.h"

namespace game::python {
namespace {

constexpr std::int64_t kMostTicks = 1'000'000'000;  // of one call
constexpr double kMostSeconds = 1e6;                // of the world, the same
constexpr const char* kStepped = "this world is being stepped by another thread";

Session session_of(const Scene& scene, int threads) {
    sim::StepOptions options;
    options.threads = checked_threads(threads);
    if (scene.scenario.flow)
        throw refusal("a flow demo has no material, so there is nothing to step; choose another scene");
    return value_of(Session::begin(scene.scenario, options, std::nullopt));
}

}  // namespace

World::World(Scene scene, int threads) : scene_(std::move(scene)), session_(session_of(scene_, threads)) {
    value_of(check_ahead(session_.state(), scene_.commands));
}

const Session& World::session() const {
    if (is_stepped_) throw refusal(kStepped);
    return session_;
}

void World::give(const sim::Command& command) {
    const sim::State& state = session().state();
    const TimedCommand timed{state.tick, command};
    value_of(check_ahead(state, {&timed, 1}));
    given_.push_back(command);
}

void World::advance() {
    source_.begin(session_.state());
    source_.add_known(scene_.commands);
    std::vector<sim::Command> commands(source_.commands().begin(), source_.commands().end());
    commands.insert(commands.end(), given_.begin(), given_.end());
    given_.clear();
    value_of(session_.advance(commands));
}

void World::step(std::int64_t ticks, const std::function<void(const Session&)>& after_tick) {
    checked(ticks, {0, kMostTicks}, "ticks");
    const Busy busy(is_stepped_, kStepped);
    if (!after_tick && session_.recorder() == nullptr) session_.hash_when_asked();
    WhilePythonRuns running;
    for (; ticks > 0; --ticks) {
        advance();
        if (after_tick) after_tick(session_);
        running.look();
    }
}

std::string World::run_until_rest(double most_seconds) {
    checked(most_seconds, {0, kMostSeconds, "s"}, "most_seconds");
    const Busy busy(is_stepped_, kStepped);
    if (session_.recorder() == nullptr) session_.hash_when_asked();
    WhilePythonRuns running;
    Until until;
    until.rest = Until::Rest::kEnergy;
    until.most_ticks =
        session_.state().tick + std::llrint(most_seconds / static_cast<double>(scenario().params.tick_s));
    if (!given_.empty()) advance();
    Watchers watchers;
    watchers.keep = [&](const Session&) -> Outcome<void> {
        running.look();
        return {};
    };
    return std::string(to_string(value_of(play_headless(session_, scene_.commands, until, watchers, ""))));
}

void World::record(const std::filesystem::path& file) {
    if (session().state().tick != 0)
        throw refusal("a recording begins with its world: record() comes before the first step");
    if (session_.recorder() != nullptr)
        throw refusal(fmt::format("it is recorded already, in {}", session_.recorder()->name()));
    value_of(session_.record_from_start(value_of(record_into(file, scenario()))));
}

void World::finish() {
    if (session().recorder() == nullptr) return;
    value_of(session_.finish());
    session_.stop_recording();
}

std::string World::hash() {
    static_cast<void>(session());
    return hex(session_.hash_now());
}

namespace {

using Heights = Numbers<float>;

// One number for each vertex, or the same for all.
std::vector<float> values_on(const sim::Grid& grid, const Heights& values, const char* name) {
    if (values.ndim() == 0) return std::vector<float>(grid.size(), *values.data());
    if (values.ndim() != 2 || values.shape(0) != grid.ny || values.shape(1) != grid.nx)
        throw refusal(fmt::format("{} has not the shape of heights, ({}, {})", name, grid.ny, grid.nx));
    return {values.data(), values.data() + values.size()};
}

World world_of_heights(const Heights& heights, double cell, const Heights& cover, const Heights& rolling,
                       const std::string& name, const OpeningArguments& arguments) {
    if (heights.ndim() != 2)
        throw refusal(fmt::format("heights has {} axes, not 2: rows and columns", heights.ndim()));
    if (std::max(heights.shape(0), heights.shape(1)) > terrains::kMostSquares + 1)
        throw refusal(fmt::format("heights has {} rows and {} columns; at most {} are allowed",
                                  heights.shape(0), heights.shape(1), terrains::kMostSquares + 1));
    terrains::Terrain terrain;
    terrain.name = name;
    terrain.grid = {static_cast<int>(heights.shape(1)), static_cast<int>(heights.shape(0)),
                    static_cast<float>(cell)};
    terrain.surface = values_on(terrain.grid, heights, "heights");
    terrain.cover = values_on(terrain.grid, cover, "cover");
    terrain.has_data.reserve(terrain.surface.size());
    for (const float height : terrain.surface) terrain.has_data.push_back(std::isnan(height) ? 0 : 1);
    std::vector<float> release = values_on(terrain.grid, rolling, "rolling");
    return {value_of(scene_of_heights(std::move(terrain), std::move(release), overrides_from(arguments))),
            arguments.threads};
}

py::dict ledger_of(const World& world) {
    const Session& session = world.session();
    const sim::Ledger& ledger = session.state().ledger;
    const auto volume = [&](std::int64_t quanta) { return session.cubic_metres(quanta); };
    return py::dict(py::arg("initial") = volume(ledger.initial),
                    py::arg("standing") = volume(ledger.standing),
                    py::arg("rolling") = volume(ledger.rolling), py::arg("out") = volume(ledger.out),
                    py::arg("poured") = volume(ledger.poured), py::arg("dug") = volume(ledger.dug),
                    py::arg("fallen") = volume(ledger.fallen), py::arg("melted") = volume(ledger.melted),
                    py::arg("error") = volume(ledger.mass_error()));
}

const World& world_of(const py::object& self) {
    return py::cast<const World&>(self);
}

py::array field_named(const py::object& self, const std::string& name) {
    const sim::State& state = world_of(self).session().state();
    std::string names;
    for (const sim::NamedField& field : sim::fields_of(state)) {
        if (field.name == name && field.values->nx() > 0) return array_of(*field.values, self);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", field.name);
    }
    throw refusal(fmt::format("no field is named '{}'; there are {}", name, names));
}

}  // namespace

void add_worlds(py::module_& module) {
    py::class_<World> world(module, "World");
    world.def(py::init([](const std::filesystem::path& source, std::optional<int> grid,
                          std::optional<std::string> material, std::optional<std::string> model,
                          std::optional<std::string> size_class, std::optional<py::dict> set,
                          std::optional<std::string> crs, int threads) {
                  LoadedWorld loaded = value_of(open_anything(
                      source.string(),
                      overrides_from({grid, std::move(material), std::move(model), std::move(size_class),
                                      std::move(crs), std::move(set), threads})));
                  return World(std::move(loaded.scene), threads);
              }),
              py::arg("source"), py::kw_only(), py::arg("grid") = py::none(),
              py::arg("material") = py::none(), py::arg("model") = py::none(),
              py::arg("size_class") = py::none(), py::arg("set") = py::none(), py::arg("crs") = py::none(),
              py::arg("threads") = 1);
    world.def_static(
        "of_heights",
        [](const Heights& heights, double cell, const Heights& cover, const Heights& rolling,
           std::optional<std::string> material, std::optional<std::string> model,
           std::optional<std::string> size_class, std::optional<py::dict> set, const std::string& name,
           int threads) {
            return world_of_heights(heights, cell, cover, rolling, name,
                                    {std::nullopt, std::move(material), std::move(model),
                                     std::move(size_class), std::nullopt, std::move(set), threads});
        },
        py::arg("heights"), py::arg("cell"), py::kw_only(), py::arg("cover") = 0.f, py::arg("rolling") = 0.f,
        py::arg("material") = py::none(), py::arg("model") = py::none(), py::arg("size_class") = py::none(),
        py::arg("set") = py::none(), py::arg("name") = "heights", py::arg("threads") = 1);
    world.def(
        "step", [](World& self, std::int64_t ticks) { self.step(ticks); }, py::arg("ticks") = 1);
    world.def("run_until_rest", &World::run_until_rest, py::arg("most_seconds") = 3600.0);
    world.def("record", &World::record, py::arg("file"));
    world.def("finish", &World::finish);
    for (const sim::CommandInfo& info : sim::kCommands)
        world.def(
            std::string(info.name).c_str(),
            [&info](World& self, const py::kwargs& arguments) { self.give(command_from(info, arguments)); },
            help_of(info).c_str());

    world.def_property_readonly("title", [](const World& self) { return self.scenario().title; });
    world.def_property_readonly("material", [](const World& self) { return self.scenario().material; });
    world.def_property_readonly("warnings", &World::warnings);
    world.def_property_readonly("shape", [](const World& self) {
        return py::make_tuple(self.scenario().grid.ny, self.scenario().grid.nx);
    });
    world.def_property_readonly("cell", [](const World& self) { return self.scenario().grid.dx; });
    world.def_property_readonly("datum", [](const World& self) { return self.scenario().datum; });
    world.def_property_readonly("tick_s", [](const World& self) { return self.scenario().params.tick_s; });
    world.def_property_readonly("tick", [](const World& self) { return self.session().state().tick; });
    world.def_property_readonly("seconds", [](const World& self) { return self.session().seconds(); });
    world.def_property_readonly("is_at_rest",
                                [](const World& self) { return sim::at_rest(self.session().state()); });
    world.def_property_readonly("hash", &World::hash);
    world.def_property_readonly("volumes", &ledger_of);
    world.def_property_readonly("parameters", [](const World& self) {
        const sim::Params& params = self.session().state().params;
        py::dict all;
        for (const sim::ParamInfo& info : sim::kParams)
            if (sim::is_used_by(info, params.model))
                all[py::str(std::string(info.name))] = shortest(params.*info.value);
        return all;
    });

    world.def("field", &field_named, py::arg("name"));
    for (const char* name : {"bedrock", "depth", "rolling", "velocity_x", "velocity_y"})
        world.def_property_readonly(name, [name](const py::object& self) { return field_named(self, name); });
    const auto add_peak = [&](const char* name, std::vector<float> Peaks::*values) {
        world.def_property_readonly(name, [values](const py::object& self) -> py::object {
            const Session& session = world_of(self).session();
            const std::vector<float>& peak = session.peaks().*values;
            if (peak.empty()) return py::none();
            return array_of(session.state().grid, peak.data(), self);
        });
    };
    add_peak("peak_rolling", &Peaks::depth);
    add_peak("peak_speed", &Peaks::speed_slope);
    add_peak("peak_pressure", &Peaks::pressure);
    world.def_property_readonly("arrival", [](const py::object& self) {
        const Session& session = world_of(self).session();
        Numbers<float> seconds({session.state().grid.ny, session.state().grid.nx});
        const double tick_s = session.state().params.tick_s;
        float* out = seconds.mutable_data();
        for (const std::uint32_t ticks : session.peaks().arrival)
            *out++ = ticks == Peaks::kNever ? NAN : static_cast<float>(static_cast<double>(ticks) * tick_s);
        return seconds;
    });
    world.def("__repr__", [](const World& self) {
        return fmt::format("<couloir.World '{}', {} by {} vertices of {} m>", self.scenario().title,
                           self.scenario().grid.ny, self.scenario().grid.nx, self.scenario().grid.dx);
    });
}

}  // namespace game::python
