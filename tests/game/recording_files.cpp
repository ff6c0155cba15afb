#include "tests/game/recording_files.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include "game/analysis/headless.h"
#include "game/recording/recording_file.h"
#include "game/session/session.h"

namespace game::test {

Scenario small_scenario() {
    Scenario scenario;
    scenario.scene = "small";
    scenario.title = "A small slope, \"quoted\"\n and öpen";
    scenario.material = "soil";
    scenario.params.stop_slope = 1.f / 3.f;
    scenario.params.friction = 0.3f;
    scenario.params.friction_thin = 1;
    scenario.params.tick_s = 1.f / 60.f;
    scenario.params.borders = {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink,
                               sim::Border::kOpen};
    scenario.terrain = "made up";
    scenario.licence = "nobody's";
    scenario.grid = {13, 11, 2.1f};
    scenario.datum = 1234.1;
    for (int y = 0; y < scenario.grid.ny; ++y)
        for (int x = 0; x < scenario.grid.nx; ++x) {
            scenario.bedrock.push_back(0.7f * static_cast<float>(y) * scenario.grid.dx +
                                       0.1f * std::fabs(6.f - x));
            scenario.depth.push_back(0.25f + 0.01f * static_cast<float>((7 * x + 5 * y) % 11));
            scenario.rolling.push_back(std::hypot(x - 6.f, y - 8.f) < 2 ? 1.f : 0.f);
            scenario.has_data.push_back(x + y > 2 ? 1 : 0);
        }
    scenario.georeference = terrains::Georeference::local({47.3, 11.43}, -12.5, 1.0 / 3);
    scenario.look.standing = {0.1f, 1.f / 3.f, 0.7f};
    scenario.look.flow = render::FlowLook{render::FlowPattern::kSoil};
    scenario.light = {255.1, 1.0 / 0.3};
    scenario.camera = render::Camera{{10.1, 1.0 / 3, 1240}, 205.7, 32.1, 285.3, 35.9};
    return scenario;
}

std::vector<TimedCommand> some_commands() {
    sim::Command pour;
    pour.x = 12.6 + 1.0 / 3;
    pour.y = 16.1;
    pour.radius = 4.1;
    pour.rate = 10.1;
    pour.duration = 0.3;
    sim::Command heap = pour;
    heap.layer = sim::Layer::kStanding;
    heap.profile = sim::Profile::kCone;
    sim::Command dig = pour;
    dig.kind = sim::CommandKind::kDig;
    dig.rate = 0.1;
    sim::Command blast;
    blast.x = pour.x;
    blast.y = pour.y;
    blast.radius = pour.radius;
    blast.kind = sim::CommandKind::kBlast;
    blast.depth = 0.2;
    return {{0, pour}, {3, dig}, {3, heap}, {20, blast}};
}

StateLine record(const std::filesystem::path& path, const Scenario& scenario, int ticks,
                 const std::vector<TimedCommand>& commands) {
    auto session = Session::begin(scenario, sim::StepOptions{}, record_into(path, scenario).value()).value();
    Until until;
    until.tick = ticks;
    play_headless(session, commands, until, {}, "").value();
    if (!session.finish()) throw std::runtime_error(path.string() + " cannot be written");
    return session.state_line();
}

namespace {

constexpr std::string_view kChainKey = ",\"chain\":\"";

}  // namespace

std::vector<std::string> bodies_of(const std::string& recording) {
    std::vector<std::string> bodies;
    std::istringstream stream(recording);
    for (std::string line; std::getline(stream, line);)
        bodies.push_back(line.substr(0, line.rfind(kChainKey)));
    return bodies;
}

std::string chained(const std::vector<std::string>& bodies) {
    std::string text;
    XXH64_hash_t last = 0;
    for (const std::string& body : bodies) {
        last = XXH3_64bits_withSeed(body.data(), body.size(), last);
        text += fmt::format("{}{}{:016x}\"}}\n", body, kChainKey, last);
    }
    return text;
}

Json json_of(const std::string& body) {
    return Json::parse(body + "}");
}

std::string body_of(const Json& json) {
    std::string text = json.dump();
    text.pop_back();
    return text;
}

}  // namespace game::test
