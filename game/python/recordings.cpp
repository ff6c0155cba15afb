#include <optional>
#include <string>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "game/files/assets.h"
#include "game/python/runs.h"
#include "game/python/world.h"
#include "game/recording/recording_file.h"
#include "game/session/verifier.h"

namespace game::python {
namespace {

// A recording to be played again.
class Replay {
  public:
    explicit Replay(const std::filesystem::path& file)
        : recording_(value_of(read_recording(value_of(find_asset(AssetKind::kRecording, file.string()))))) {}

    const Recording& recording() const { return recording_; }

    // Plays it to its end, and compares each recorded state.
    Verdict verify(int threads) const {
        World world = at_start(threads);
        return verified(world);
    }
    World at_start(int threads) const {
        return {Scene{recording_.header.scenario, recording_.commands}, threads};
    }

  private:
    Verdict verified(World& world) const;

    Recording recording_;
};

Verdict Replay::verified(World& world) const {
    Verifier verifier(recording_);
    verifier.look_at(world.session());
    world.step(recording_.last_tick(), [&](const Session& now) { verifier.look_at(now); });
    return verifier.verdict();
}

}  // namespace

void add_recordings(py::module_& module) {
    py::class_<Verdict> verdict(module, "Verdict");
    verdict.def_property_readonly("kind",
                                  [](const Verdict& self) { return std::string(to_string(self.kind())); });
    verdict.def_readonly("compared", &Verdict::compared);
    verdict.def_readonly("proven_tick", &Verdict::proven_tick);
    verdict.def_readonly("parted", &Verdict::parted);
    verdict.def("__bool__", [](const Verdict& self) { return self.kind() == Verdict::Kind::kExact; });
    verdict.def("__repr__", [](const Verdict& self) {
        return fmt::format("<couloir.Verdict {}: {} states, proven to tick {}>", to_string(self.kind()),
                           self.compared, self.proven_tick);
    });

    py::class_<Replay> replay(module, "Replay");
    replay.def_property_readonly("title",
                                 [](const Replay& self) { return self.recording().header.scenario.title; });
    replay.def_property_readonly("ticks", [](const Replay& self) { return self.recording().last_tick(); });
    replay.def_property_readonly("warning", [](const Replay& self) { return self.recording().warning; });
    replay.def("verify", &Replay::verify, py::kw_only(), py::arg("threads") = 1);
    replay.def("world", &Replay::at_start, py::kw_only(), py::arg("threads") = 1);
    module.def(
        "replay", [](const std::filesystem::path& file) { return Replay(file); }, py::arg("file"));
}

}  // namespace game::python
