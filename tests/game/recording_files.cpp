#include "tests/game/recording_files.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include "game/analysis/headless.h"
#include "game/session/session.h"

namespace game::test {

Start small_start() {
    Start start;
    start.scene = "small";
    start.title = "A small slope, \"quoted\"\n and öpen";
    start.material = "soil";
    start.params.stop_slope = 1.f / 3.f;
    start.params.stop_slope_thick = 0.1f;
    start.params.tick_s = 1.f / 60.f;
    start.params.borders = {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink, sim::Border::kOpen};
    start.terrain = "made up";
    start.licence = "nobody's";
    start.grid = {13, 11, 2.1f};
    start.datum = 1234.1;
    for (int y = 0; y < start.grid.ny; ++y)
        for (int x = 0; x < start.grid.nx; ++x) {
            start.bedrock.push_back(0.7f * static_cast<float>(y) * start.grid.dx + 0.1f * std::fabs(6.f - x));
            start.depth.push_back(0.25f + 0.01f * static_cast<float>((7 * x + 5 * y) % 11));
            start.rolling.push_back(std::hypot(x - 6.f, y - 8.f) < 2 ? 1.f : 0.f);
            start.has_data.push_back(x + y > 2 ? 1 : 0);
        }
    start.georeference = terrains::Georeference::local({47.3, 11.43}, -12.5, 1.0 / 3);
    start.seed = 0xfedcba9876543210u;
    start.look.standing = {0.1f, 1.f / 3.f, 0.7f};
    start.look.flow = render::FlowLook{render::FlowPattern::kSoil};
    start.light = {255.1, 1.0 / 0.3};
    start.camera = render::Camera{{10.1, 1.0 / 3, 1240}, 205.7, 32.1, 285.3, 35.9};
    return start;
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

StateLine record(const std::filesystem::path& path, const Start& start, int ticks,
                 const std::vector<TimedCommand>& commands) {
    auto session = Session::begin(start, sim::How{}, Recorder::create(path, start).value()).value();
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
