#include "game/python/convert.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "game/base/process.h"
#include "game/recording/command_json.h"
#include "terrains/limits.h"

namespace game::python {
namespace {

// An argument as it would stand in a recording.
Json json_of(const py::handle& value, const std::string& name) {
    if (py::isinstance<py::str>(value)) return py::cast<std::string>(value);
    if (PyNumber_Check(value.ptr()) != 0 && !py::isinstance<py::array>(value))
        return py::cast<double>(py::float_(py::reinterpret_borrow<py::object>(value)));
    if (!py::isinstance<py::sequence>(value))
        throw refusal(fmt::format("{} is neither a number, a name nor a pair", name));
    Json list = Json::array();
    for (const py::handle each : py::reinterpret_borrow<py::sequence>(value))
        list.push_back(py::cast<double>(each));
    return list;
}

std::vector<std::string> arguments_of(const sim::CommandInfo& info) {
    std::vector<std::string> names;
    if (info.has_param) names.emplace_back("param");
    for (const sim::CommandNumber& number : info.numbers) names.emplace_back(number.name);
    if (info.has_layer) names.emplace_back("layer");
    if (info.has_profile) names.emplace_back("profile");
    if (info.has_part) names.emplace_back("of");
    if (info.has_slope) names.emplace_back("slope");
    return names;
}

}  // namespace

py::array read_only(py::array array) {
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

py::array array_of(const sim::Field<float>& field, const py::object& owner) {
    constexpr py::ssize_t kBytes = sizeof(float);
    return read_only({py::dtype::of<float>(),
                      {field.ny(), field.nx()},
                      {kBytes * field.stride(), kBytes},
                      field.row(0),
                      owner});
}

sim::Command command_from(const sim::CommandInfo& info, const py::kwargs& arguments) {
    const std::vector<std::string> names = arguments_of(info);
    Json members = Json::object();
    const sim::Command usual = sim::usual_command(info.kind);
    for (const sim::CommandNumber& number : info.numbers)
        if (number.usual != 0) members[std::string(number.name)] = usual.*number.value;
    if (info.has_layer) members["as"] = sim::to_string(usual.layer);
    if (info.has_profile) members["profile"] = sim::to_string(usual.profile);
    for (const auto& [key, value] : arguments) {
        const auto name = py::cast<std::string>(key);
        if (std::ranges::find(names, name) == names.end())
            throw refusal(fmt::format("{} has no {}; it has {}", info.name, name, fmt::join(names, ", ")));
        members[name == "layer" ? "as" : name] = json_of(value, name);
    }
    try {
        return values::command_from(Json{{std::string(info.name), members}}, info);
    } catch (const std::runtime_error& thrown) {
        throw refusal(fmt::format("{}: {}", info.name, thrown.what()));
    }
}

std::string help_of(const sim::CommandInfo& info) {
    std::string help = fmt::format("{}({})\n\nNext tick, {}.\n", info.name,
                                   fmt::join(arguments_of(info), ", "), info.meaning);
    for (const sim::CommandNumber& number : info.numbers)
        help += fmt::format("\n{}: {}, {} to {}{}: {}", number.name, number.unit, number.least, number.most,
                            number.usual != 0 ? fmt::format(" [{}]", number.usual) : "", number.meaning);
    if (info.has_param) help += "\nparam: the name of a parameter";
    if (info.has_layer) help += "\nlayer: rolling, standing [rolling]";
    if (info.has_profile) help += "\nprofile: disc, cone [disc]";
    if (info.has_part) help += "\nof: upper, or lower in a world of two materials [upper]";
    if (info.has_slope)
        help += "\nslope: the least and the greatest, degrees, of the ground that it acts on [all]";
    return help;
}

int checked_threads(int threads) {
    return checked(threads, {1, kMostThreads}, "threads");
}

Overrides overrides_from(const OpeningArguments& arguments) {
    Overrides overrides;
    if (arguments.grid)
        checked(*arguments.grid, {terrains::kFewestSquares, terrains::kMostSquares, "squares"}, "grid");
    overrides.squares = arguments.grid;
    overrides.material = arguments.material;
    overrides.size_class = arguments.size_class;
    overrides.crs = arguments.crs;
    if (arguments.model) {
        overrides.model = sim::model_from(*arguments.model);
        if (!overrides.model)
            throw refusal(
                fmt::format("model is '{}', not one of bcre, bcre-inertial, voellmy", *arguments.model));
    }
    if (!arguments.set) return overrides;
    for (const auto& [key, value] : *arguments.set) {
        const auto name = py::cast<std::string>(key);
        const auto info = std::ranges::find(sim::kParams, name, &sim::ParamInfo::name);
        if (info == std::end(sim::kParams))
            throw refusal(fmt::format("'{}' is not a parameter; docs/scenes.md has all of them", name));
        const double number =
            checked(py::cast<double>(value),
                    {static_cast<double>(info->least), static_cast<double>(info->most), info->unit}, name);
        overrides.set.push_back({&*info, static_cast<float>(number)});
    }
    return overrides;
}

void WhilePythonRuns::look() {
    const auto now = std::chrono::steady_clock::now();
    if (now - looked_ < std::chrono::milliseconds(100)) return;
    looked_ = now;
    const py::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace game::python
