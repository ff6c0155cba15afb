#include "tests/window/play_session.h"

#include <iostream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/slope_scene.h"

namespace game::test {
namespace {

using nlohmann::json;

constexpr double kSoon = 20;  // s, for a busy machine without a GPU

constexpr const char* kCamera = R"([camera]
target = [80, 84, -33]
azimuth = 207
elevation = 33
distance = 318
field_of_view = 35
)";

constexpr const char* kKinds[] = {"pour", "dig", "blast", "settle", "set"};

}  // namespace

PlaySession::PlaySession() : desktop_(1024, 768) {
    const auto scene = desktop_.folder() / "hands.toml";
    write_bytes(scene, support::slope_scene("A slope to try hands on", 40) + kCamera);
    desktop_.start({support::program().string(), "play", scene.string(), "--record", recording().string(),
                    "--size", std::to_string(kWidth) + "x" + std::to_string(kHeight), "--threads", "1"},
                   "Couloir");
    if (!runs()) throw std::runtime_error("the world does not run: " + desktop_.out());
    desktop_.key("Tab");
    desktop_.move(kMiddleX, kMiddleY);
}

std::vector<json> PlaySession::lines() const {
    std::vector<json> lines;
    std::istringstream text(read_bytes(recording()));
    std::string line;
    std::getline(text, line);
    // The last line may be incomplete.
    while (std::getline(text, line) && !text.eof()) lines.push_back(json::parse(line));
    return lines;
}

std::vector<json> PlaySession::commands(const std::string& kind) const {
    std::vector<json> found;
    for (const json& line : lines())
        if (line.contains(kind)) found.push_back(line[kind]);
    return found;
}

std::size_t PlaySession::commands() const {
    std::size_t count = 0;
    for (const char* kind : kKinds) count += commands(kind).size();
    return count;
}

json PlaySession::last_state() const {
    json last = json::object();
    for (json& line : lines())
        if (line.contains("hash")) last = std::move(line);
    return last;
}

bool PlaySession::comes_to(const std::string& kind, std::size_t count) const {
    return within(kSoon, [&] { return commands(kind).size() >= count; });
}

bool PlaySession::runs(std::int64_t ticks) const {
    const std::int64_t from = tick();
    return within(kSoon, [&] { return tick() >= from + ticks; });
}

bool PlaySession::stands() const {
    const std::int64_t from = tick();
    return !within(0.7, [&] { return tick() != from; });
}

void PlaySession::leave() {
    desktop_.key("ctrl+q");
    check_ending();
}

void PlaySession::check_ending() {
    const Finished finished = desktop_.finish();
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_NE(finished.out.find(recording().string()), std::string::npos) << finished.out;
    const auto all = lines();
    EXPECT_TRUE(!all.empty() && all.back().contains("end")) << "the recording has no end";
    check_replay();
}

void PlaySession::check_replay() const {
    const Finished replayed = couloir({"replay", recording().string(), "--verify"});
    EXPECT_EQ(replayed.status, 0) << replayed.err;
    EXPECT_NE(replayed.out.find("exact"), std::string::npos) << replayed.out << replayed.err;
    const json state = last_state();
    std::cout << "tick " << state.value("tick", -1) << ", hash " << state.value("hash", "none") << ", "
              << commands() << " commands: replays exactly\n";
}

}  // namespace game::test
