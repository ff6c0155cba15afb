#include "tests/fuzz/try_recording.h"

#include <algorithm>
#include <sstream>

#include "game/recording/chain.h"
#include "game/recording/recording_file.h"

namespace game::test {
namespace {

constexpr const char* kName = "x.couloir";

Outcome<Recording> read(const std::string& bytes) {
    std::istringstream stream(bytes);
    return read_recording(stream, kName);
}

std::string written(const Recording& recording) {
    std::string text, line;
    Chain chain;
    const auto close = [&] {
        chain.close(line);
        text += line + "\n";
        line.clear();
    };
    line = to_json(recording.header).dump(-1, ' ', false, Json::error_handler_t::replace);
    close();
    auto state = recording.states.begin();
    const auto states_until = [&](std::int64_t tick) {
        for (; state != recording.states.end() && state->tick <= tick; ++state) {
            write(*state, line);
            close();
        }
    };
    for (const TimedCommand& command : recording.commands) {
        states_until(command.tick);
        write(command, line);
        close();
    }
    states_until(INT64_MAX);
    if (recording.end) {
        write(EndLine{*recording.end}, line);
        close();
    }
    return text;
}

bool same(const Recording& a, const Recording& b) {
    const auto equal = [](const TimedCommand& x, const TimedCommand& y) {
        return x.tick == y.tick && x.command == y.command;
    };
    return a.states == b.states && a.end == b.end && a.header.scenario.params == b.header.scenario.params &&
           a.header.scenario.bedrock == b.header.scenario.bedrock &&
           a.header.scenario.depth == b.header.scenario.depth &&
           a.header.scenario.standing == b.header.scenario.standing &&
           std::equal(a.commands.begin(), a.commands.end(), b.commands.begin(), b.commands.end(), equal);
}

std::string_view fault_of(const std::string& bytes) {
    const auto first = read(bytes);
    if (!first) {
        const std::string& sentence = first.error().sentence;
        if (first.error().status != Failure::kUnusable) return "refused with another status";
        if (sentence.rfind(kName, 0) != 0) return "a sentence that does not name the file";
        if (sentence.find('\n') != std::string::npos) return "more than one line of complaint";
        return {};
    }
    const auto second = read(written(*first));
    if (!second) return "what was accepted and written anew is refused";
    return same(*first, *second) ? std::string_view() : "what was accepted is another when written anew";
}

}  // namespace

std::string chained_anew(std::string_view bytes) {
    std::string text;
    Chain chain;
    while (!bytes.empty()) {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        std::string line(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
        if (const std::size_t old = line.rfind(",\"chain\":"); old != std::string::npos) line.resize(old + 1);
        if (line.empty()) line.push_back('}');
        chain.close(line);
        text += line + "\n";
    }
    return text;
}

std::string_view fault_of_reading(std::string_view bytes) {
    const std::string_view fault = fault_of(std::string(bytes));
    return fault.empty() ? fault_of(chained_anew(bytes)) : fault;
}

}  // namespace game::test
