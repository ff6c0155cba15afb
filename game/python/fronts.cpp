#include "game/python/fronts.h"

#include <cmath>
#include <optional>
#include <variant>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "game/analysis/track_rule.h"
#include "game/base/limits.h"
#include "game/files/mesh_file.h"
#include "sim/core/workers.h"
#include "sim/front/tracker.h"

namespace game::python {
namespace {

using sim::front::Mesh;

Mesh mesh_of_arrays(const Numbers<double>& positions, const Numbers<std::int64_t>& triangles) {
    if (positions.ndim() != 2 || positions.shape(1) < 2 || positions.shape(1) > 3)
        throw refusal("positions is no array of vertices × 2, or × 3 of which the third is not used");
    if (triangles.ndim() != 2 || triangles.shape(1) != 3)
        throw refusal("triangles is no array of triangles × 3");
    const auto most = static_cast<py::ssize_t>(kMostMeshParts);
    if (positions.shape(0) > most || triangles.shape(0) > most)
        throw refusal(fmt::format("more than {} vertices or triangles", kMostMeshParts));
    if (triangles.shape(0) == 0) throw refusal("a mesh without triangles");
    std::vector<glm::vec2> position;
    position.reserve(static_cast<std::size_t>(positions.shape(0)));
    for (py::ssize_t i = 0; i < positions.shape(0); ++i)
        position.emplace_back(positions.at(i, 0), positions.at(i, 1));
    std::vector<std::array<int, 3>> triangle;
    triangle.reserve(static_cast<std::size_t>(triangles.shape(0)));
    for (py::ssize_t i = 0; i < triangles.shape(0); ++i) {
        std::array<int, 3> corners{};
        for (py::ssize_t k = 0; k < 3; ++k) {
            const std::int64_t corner = triangles.at(i, k);
            if (corner < 0 || corner >= positions.shape(0))
                throw refusal(fmt::format("triangle {}: there is no vertex {}", i, corner));
            corners[static_cast<std::size_t>(k)] = static_cast<int>(corner);
        }
        triangle.push_back(corners);
    }
    auto made = sim::front::mesh_of(std::move(position), std::move(triangle));
    if (const auto* fault = std::get_if<sim::front::MeshFault>(&made))
        throw refusal(fmt::format(
            "{} {}: {}", fault->kind == sim::front::MeshFault::Kind::kNotFinite ? "vertex" : "triangle",
            fault->where, fact_of(fault->kind)));
    return std::get<Mesh>(std::move(made));
}

Mesh mesh_of_grid(int ny, int nx, double cell) {
    if (std::min(nx, ny) < 3 || std::max(nx, ny) > kMostVertices)
        throw refusal(
            fmt::format("a grid of {} by {} vertices; each side has 3 to {}", ny, nx, kMostVertices));
    if (!(cell >= terrains::kSmallestCell && cell <= terrains::kLargestCell))
        throw refusal(fmt::format("a cell of {} m, outside {} to {} m", cell, terrains::kSmallestCell,
                                  terrains::kLargestCell));
    return sim::front::mesh_of(sim::Grid{nx, ny, static_cast<float>(cell)});
}

// Values at the vertices, `each` of them, all finite.
void check_values(const Numbers<float>& values, const Mesh& mesh, py::ssize_t each, const char* name) {
    if (values.size() != each * mesh.vertices())
        throw refusal(fmt::format("{} has {} numbers, and the mesh needs {} for each of {} vertices", name,
                                  values.size(), each, mesh.vertices()));
    for (py::ssize_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values.data()[i]))
            throw refusal(fmt::format("{}: {} at vertex {} is not finite", name, values.data()[i], i / each));
}

// Follows the fronts of a flow that Python has. It owns its threads.
class FrontTracker {
  public:
    FrontTracker(const Mesh& mesh, const TrackRule& rule, double dt, int threads)
        : tracker_(mesh, rule_of(rule, mesh), *rule.source, rule.hold),
          workers_(checked_threads(threads)),
          dt_(checked(dt, {TrackRule::kShortestStep, TrackRule::kLongestStep, "s"}, "dt")) {}

    py::array advance(const Numbers<float>& velocities, const std::optional<Numbers<float>>& scalar) {
        const Busy busy(is_advancing_, "another thread advances this tracker");
        const Mesh& mesh = tracker_.mesh();
        check_values(velocities, mesh, 2, "velocities");
        if (scalar.has_value() != (tracker_.source() == sim::front::PointSource::kLevel))
            throw refusal("source level, and no other, needs a scalar with every flow");
        if (scalar) check_values(*scalar, mesh, 1, "scalar");
        const auto vertices = static_cast<std::size_t>(mesh.vertices());
        static_assert(sizeof(glm::vec2) == 2 * sizeof(float));
        const sim::front::Flow flow{{reinterpret_cast<const glm::vec2*>(velocities.data()), vertices},
                                    scalar ? std::span(scalar->data(), vertices) : std::span<const float>()};
        {
            const py::gil_scoped_release released;
            tracker_.advance(flow, dt_, workers_);
        }
        py::array_t<FrontPoint> points(static_cast<py::ssize_t>(tracker_.points().size()));
        FrontPoint* out = points.mutable_data();
        for (const sim::front::Point& point : tracker_.points())
            *out++ = value_of(front_point(tracker_, point));
        return points;
    }
    int outrun() const { return tracker_.outrun(); }

  private:
    sim::front::Tracker tracker_;
    sim::Workers workers_;
    double dt_;
    bool is_advancing_ = false;
};

// The choices of a tracker by their names.
struct TrackArguments {
    std::string source;
    std::optional<std::string> rule;
    std::optional<double> threshold, jump, level;
    bool hold;
};

TrackRule rule_from(const TrackArguments& arguments) {
    TrackRule rule{sim::front::source_named(arguments.source),
                   std::nullopt,
                   arguments.threshold,
                   arguments.jump,
                   arguments.level,
                   arguments.hold};
    if (!rule.source)
        throw refusal(fmt::format("source is '{}', not one of half, paper, fit, level", arguments.source));
    if (arguments.rule) {
        rule.rule = track_rule_named(*arguments.rule);
        if (!rule.rule)
            throw refusal(fmt::format("rule is '{}', not one of paper, relative", *arguments.rule));
    }
    if (rule.threshold) checked(*rule.threshold, {TrackRule::kLeast, TrackRule::kMost}, "threshold");
    if (rule.jump) checked(*rule.jump, {TrackRule::kLeast, TrackRule::kMost}, "jump");
    if (rule.level) checked(*rule.level, {-TrackRule::kFarthestLevel, TrackRule::kFarthestLevel}, "level");
    value_of(complete(rule, rule.source == sim::front::PointSource::kLevel, ""));
    return rule;
}

}  // namespace

void add_fronts(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(FrontPoint, i, j, f, x, y, w);
    py::class_<Mesh> mesh(module, "Mesh");
    mesh.def(py::init(&mesh_of_arrays), py::arg("positions"), py::arg("triangles"));
    mesh.def_static(
        "read", [](const std::filesystem::path& file) { return value_of(read_obj(file)); }, py::arg("file"));
    mesh.def_static("grid", &mesh_of_grid, py::arg("ny"), py::arg("nx"), py::arg("cell"));
    mesh.def_property_readonly("vertices", &Mesh::vertices);
    mesh.def_property_readonly("edges", &Mesh::edges);
    mesh.def_property_readonly("positions", [](const py::object& self) {
        const auto& of = py::cast<const Mesh&>(self);
        return read_only({py::dtype::of<float>(), {of.vertices(), 2}, &of.position.front().x, self});
    });

    py::class_<FrontTracker> tracker(module, "Tracker");
    tracker.def(py::init([](const Mesh& on, double dt, std::string source, std::optional<std::string> rule,
                            std::optional<double> threshold, std::optional<double> jump,
                            std::optional<double> level, bool hold, int threads) {
                    return std::make_unique<FrontTracker>(
                        on, rule_from({std::move(source), std::move(rule), threshold, jump, level, hold}), dt,
                        threads);
                }),
                py::keep_alive<1, 2>(), py::arg("mesh"), py::kw_only(), py::arg("dt") = 1.0 / 60,
                py::arg("source") = "fit", py::arg("rule") = py::none(), py::arg("threshold") = py::none(),
                py::arg("jump") = py::none(), py::arg("level") = py::none(), py::arg("hold") = false,
                py::arg("threads") = 1);
    tracker.def("advance", &FrontTracker::advance, py::arg("velocities"), py::arg("scalar") = py::none());
    tracker.def_property_readonly("outrun", &FrontTracker::outrun);

    module.def(
        "track",
        [tracker](const py::object& on, const py::object& velocities, const py::object& scalars,
                  const py::kwargs& arguments) {
            const py::object follows = tracker(on, **arguments);
            py::list frames;
            const py::ssize_t count = py::len(velocities);
            if (!scalars.is_none() && static_cast<py::ssize_t>(py::len(scalars)) != count)
                throw refusal(
                    fmt::format("velocities has {} frames and scalars has {}", count, py::len(scalars)));
            for (py::ssize_t frame = 0; frame < count; ++frame)
                frames.append(follows.attr("advance")(
                    velocities[py::int_(frame)],
                    scalars.is_none() ? scalars : py::object(scalars[py::int_(frame)])));
            return frames;
        },
        py::arg("mesh"), py::arg("velocities"), py::arg("scalars") = py::none());
}

}  // namespace game::python
