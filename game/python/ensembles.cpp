#include <atomic>
#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "game/base/process.h"
#include "game/ensemble/member.h"
#include "game/python/runs.h"
#include "game/python/world.h"

namespace game::python {
namespace {

// An ensemble whose members Python plays. Its counts are not kept: `couloir ensemble` makes maps.
struct Ensemble {
    Ensemble(EnsembleSpec read, int threads)
        : spec(std::move(read)), counts(spec.scene.scenario, spec.maps), threads(threads) {}

    void check(std::int64_t number) const {
        if (number < 1 || number > spec.members)
            throw refusal(fmt::format("there is no member {}: {} has 1 to {}", number, spec.file.string(),
                                      spec.members));
    }
    py::dict sample_of(const std::vector<double>& sample) const {
        py::dict named;
        for (std::size_t i = 0; i < spec.variables.size(); ++i)
            named[py::str(std::string(spec.variables[i].name()))] = sample[i];
        return named;
    }

    EnsembleSpec spec;
    VertexCounts counts;
    int threads;
};

// A finished member, with the names of its variables.
struct NamedMember {
    Member member;
    std::shared_ptr<const Ensemble> of;
};

NamedMember play(const std::shared_ptr<const Ensemble>& ensemble, std::int64_t number,
                 const std::optional<std::filesystem::path>& record) {
    ensemble->check(number);
    WhilePythonRuns running;
    return {value_of(play_member(
                         ensemble->spec, number, ensemble->counts,
                         [&] {
                             running.look();
                             return false;
                         },
                         record))
                .member,
            ensemble};
}

// Plays the members in order, some at a time on threads of their own, and hands them out in order.
class MembersInOrder {
  public:
    explicit MembersInOrder(std::shared_ptr<const Ensemble> ensemble) : ensemble_(std::move(ensemble)) {}
    ~MembersInOrder() { stop_ = true; }
    MembersInOrder(const MembersInOrder&) = delete;
    MembersInOrder& operator=(const MembersInOrder&) = delete;

    NamedMember next() {
        const Busy busy(is_waited_for_, "another thread waits for the next member");
        while (next_ <= ensemble_->spec.members &&
               playing_.size() < static_cast<std::size_t>(ensemble_->threads)) {
            playing_.push_back(std::async(std::launch::async, [this, number = next_] {
                return play_member(ensemble_->spec, number, ensemble_->counts,
                                   [this] { return stop_.load(); });
            }));
            ++next_;
        }
        if (playing_.empty()) throw py::stop_iteration();
        WhilePythonRuns running;
        while (playing_.front().wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
            running.look();
        auto played = playing_.front().get();
        playing_.pop_front();
        return {value_of(std::move(played)).member, ensemble_};
    }

  private:
    std::shared_ptr<const Ensemble> ensemble_;
    bool is_waited_for_ = false;
    std::atomic<bool> stop_ = false;
    std::int64_t next_ = 1;
    std::deque<std::future<Outcome<PlayedMember>>> playing_;  // waited for when they are destroyed
};

template <class Value>
void add_number(py::class_<NamedMember>& member, const char* name, Value Member::*value) {
    member.def_property_readonly(name, [value](const NamedMember& self) { return self.member.*value; });
}

}  // namespace

void add_ensembles(py::module_& module) {
    py::class_<NamedMember> member(module, "Member");
    member.def_property_readonly(
        "sample", [](const NamedMember& self) { return self.of->sample_of(self.member.sample); });
    member.def_property_readonly("fault", [](const NamedMember& self) {
        return self.member.fault.empty() ? std::nullopt : std::optional(self.member.fault);
    });
    add_number(member, "number", &Member::number);
    add_number(member, "ended", &Member::ended);
    add_number(member, "seconds", &Member::seconds);
    add_number(member, "released", &Member::released);
    add_number(member, "run_out", &Member::run_out);
    add_number(member, "fall", &Member::fall);
    add_number(member, "extent", &Member::extent);
    add_number(member, "eroded", &Member::eroded);
    add_number(member, "top_speed", &Member::top_speed);
    add_number(member, "thickness", &Member::thickness);
    add_number(member, "toe_x", &Member::toe_x);
    add_number(member, "toe_y", &Member::toe_y);
    add_number(member, "hash", &Member::hash);
    member.def("__repr__", [](const NamedMember& self) {
        const Member& of = self.member;
        return of.fault.empty() ? fmt::format("<couloir.Member {}: run-out {:.0f} m, {:.1f} m/s>", of.number,
                                              of.run_out, of.top_speed)
                                : fmt::format("<couloir.Member {}: could not run: {}>", of.number, of.fault);
    });

    py::class_<MembersInOrder>(module, "Members")
        .def("__iter__", [](py::object self) { return self; })
        .def("__next__", &MembersInOrder::next);

    py::class_<Ensemble, std::shared_ptr<Ensemble>> ensemble(module, "Ensemble");
    ensemble.def_property_readonly("title", [](const Ensemble& self) { return self.spec.title; });
    ensemble.def_property_readonly("identity", [](const Ensemble& self) { return self.spec.identity; });
    ensemble.def_property_readonly("warnings", [](const Ensemble& self) { return self.spec.scene.warnings; });
    ensemble.def_property_readonly("variables", [](const Ensemble& self) {
        std::vector<std::string> names;
        for (const Variable& variable : self.spec.variables) names.emplace_back(variable.name());
        return names;
    });
    ensemble.def("__len__", [](const Ensemble& self) { return self.spec.members; });
    ensemble.def(
        "sample",
        [](const Ensemble& self, std::int64_t number) {
            self.check(number);
            return self.sample_of(self.spec.sample(number));
        },
        py::arg("member"));
    ensemble.def(
        "world",
        [](const Ensemble& self, std::int64_t number, int threads) {
            self.check(number);
            return World(Scene{value_of(self.spec.scenario_of(number)), self.spec.scene.commands}, threads);
        },
        py::arg("member"), py::kw_only(), py::arg("threads") = 1);
    ensemble.def(
        "play",
        [](const std::shared_ptr<Ensemble>& self, std::int64_t number,
           const std::optional<std::filesystem::path>& record) { return play(self, number, record); },
        py::arg("member"), py::kw_only(), py::arg("record") = py::none());
    ensemble.def("__iter__", [](const std::shared_ptr<Ensemble>& self) {
        return std::make_unique<MembersInOrder>(self);
    });

    module.def(
        "ensemble",
        [](const std::filesystem::path& spec, std::optional<int> threads) {
            const int many = checked_threads(threads.value_or(std::min(processors(), kMostThreads)));
            Overrides overrides;
            overrides.memory.use.sessions = many;
            return std::make_shared<Ensemble>(value_of(read_ensemble_spec(spec, overrides)), many);
        },
        py::arg("spec"), py::kw_only(), py::arg("threads") = py::none());
}

}  // namespace game::python
