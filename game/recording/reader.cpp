#include "game/recording/reader.h"

#include <algorithm>
#include <istream>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/recording/chain.h"
#include "terrains/json_reader.h"

namespace game {
namespace {

using terrains::read_json;

constexpr std::string_view kBeginning =
    R"({"format":"couloir)";  // after it, a quote or what older formats were called

enum class Read { kLine, kTorn, kEnd, kTooLong };

// Reads the next line without its break. kTorn: the file ends before the break.
Read next_line(std::istream& stream, std::string& line, std::size_t longest) {
    line.clear();
    std::streambuf& bytes = *stream.rdbuf();
    for (int c = bytes.sbumpc(); c != std::char_traits<char>::eof(); c = bytes.sbumpc()) {
        if (c == '\n') return Read::kLine;
        if (line.size() == longest) return Read::kTooLong;
        line.push_back(static_cast<char>(c));
    }
    return line.empty() ? Read::kEnd : Read::kTorn;
}

class Reader {
  public:
    Reader(std::istream& stream, std::string name, const Memory& memory)
        : stream_(stream), name_(std::move(name)), memory_(memory) {}

    Outcome<Recording> read() {
        if (const auto header = read_header(); !header) return tl::unexpected(header.error());
        for (;;) {
            ++line_number_;
            const Read got = next_line(stream_, line_, kLongestLine);
            if (got == Read::kEnd) break;
            if (got == Read::kTooLong) return wrong(fmt::format("longer than {} bytes", kLongestLine));
            if (got == Read::kTorn) {
                recording_.warning =
                    fmt::format("{}:{}: cut off: bytes {} to {} are lost; the lines before them are whole",
                                name_, line_number_, whole_bytes_, whole_bytes_ + line_.size() - 1);
                break;
            }
            if (const auto taken = take_line(); !taken) return tl::unexpected(taken.error());
            whole_bytes_ += line_.size() + 1;
        }
        if (const auto fault = fault_of_commands(recording_.header.scenario.params, recording_.commands))
            return unusable(noting(fmt::format("{}: {}", name_, *fault)));
        if (!recording_.end && !recording_.warning)
            recording_.warning =
                fmt::format("{}: has no end line; cut off after line {}", name_, line_number_ - 1);
        if (recording_.header.minor > kFormatMinor)
            warn(noting(fmt::format("{}: what is new in it is left out", name_)));
        return std::move(recording_);
    }

  private:
    void warn(const std::string& warning) {
        recording_.warning = recording_.warning ? *recording_.warning + "; " + warning : warning;
    }

    std::string noting(std::string fact) const {
        return noting_newer(std::move(fact), recording_.header.minor);
    }

    // What is wrong with this line, and how much before it is whole.
    tl::unexpected<Failure> wrong(const std::string& fact) const {
        const std::string before =
            line_number_ == 1
                ? ""
                : fmt::format("; the {} bytes before it are whole, up to tick {}", whole_bytes_, latest_);
        return unusable(fmt::format("{}:{}: {}{}", name_, line_number_, noting(fact), before));
    }

    // Check this first, so that a file that is not a recording,
    // or has an endless line, is not read into memory.
    Outcome<void> look_at_header() {
        std::string beginning(kBeginning.size(), ' ');
        stream_.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
        beginning.resize(static_cast<std::size_t>(stream_.gcount()));
        if (beginning.empty()) return unusable(fmt::format("{}: empty", name_));
        if (beginning != kBeginning.substr(0, beginning.size())) return wrong("not a couloir recording");
        stream_.ignore(kLongestHeader, '\n');
        const auto length = beginning.size() + static_cast<std::size_t>(stream_.gcount());
        if (length > kLongestHeader) return wrong("longer than any header may be");
        line_.reserve(length);
        stream_.clear();
        stream_.seekg(0);
        return {};
    }

    Outcome<void> read_header() {
        line_number_ = 1;
        if (auto begun = look_at_header(); !begun) return begun;
        const Read got = next_line(stream_, line_, kLongestHeader);
        auto json = read_json<Json>(line_, kHeaderLimits);
        if (!json) return wrong(got == Read::kTorn ? "cut off within the header" : json.error());
        if (const auto known = check_format(*json); !known) return wrong(known.error());
        if (const auto linked = chain_.read(line_); !linked) return wrong(linked.error());
        auto header = header_from(*json, memory_);
        if (!header) return wrong(header.error());
        if (got == Read::kTorn) return wrong("cut off within the header");
        recording_.header = std::move(*header);
        if (const auto& parent = recording_.header.parent)
            proven_until_ = std::min(parent->tick, kMostTicksOfParent);
        whole_bytes_ = line_.size() + 1;
        return {};
    }

    Outcome<void> take_line() {
        if (recording_.end) return wrong("stands after the end line");
        if (const auto linked = chain_.read(line_); !linked) return wrong(linked.error());
        const auto json = read_json<Json>(line_, kLineLimits);
        if (!json) return wrong(json.error());
        const auto line = line_from(*json);
        if (!line) return wrong(line.error());
        return std::visit([&](const auto& each) { return keep(each); }, *line);
    }

    Outcome<void> keep(const TimedCommand& command) {
        if (const auto fault = sim::fault_of(command.command, recording_.header.scenario.lower.has_value()))
            return wrong(*fault);
        // A command applies at the start of its tick, so it follows that tick's state line.
        if (command.tick < latest_)
            return wrong(fmt::format("goes back to tick {} from {}", command.tick, latest_));
        if (auto proven = check_states(command.tick); !proven) return proven;
        if (recording_.commands.size() == kMostCommands)
            return wrong(fmt::format("more than {} commands", kMostCommands));
        latest_ = command.tick;
        recording_.commands.push_back(command);
        return {};
    }

    Outcome<void> keep(const StateLine& state) {
        if (state.tick < latest_ ||
            (!recording_.states.empty() && state.tick <= recording_.states.back().tick))
            return wrong(fmt::format("goes back to tick {} from {}", state.tick, latest_));
        if (auto proven = check_states(state.tick); !proven) return proven;
        latest_ = proven_until_ = state.tick;
        recording_.states.push_back(state);
        return {};
    }

    Outcome<void> keep(const ClaimLine& claim) {
        if (!recording_.header.scenario.goal) return wrong("claims a score, and the recording has no goal");
        if (claim.tick < latest_)
            return wrong(fmt::format("goes back to tick {} from {}", claim.tick, latest_));
        if (auto proven = check_states(claim.tick); !proven) return proven;
        // Who goes back and plays the end of a try again claims the same again.
        if (recording_.claim && *recording_.claim != claim)
            return wrong(fmt::format("claims a score of {} at tick {}, and an earlier line {} at tick {}",
                                     claim.score, claim.tick, recording_.claim->score,
                                     recording_.claim->tick));
        latest_ = claim.tick;
        recording_.claim = claim;
        return {};
    }

    Outcome<void> keep(const EndLine& end) {
        if (end.tick < latest_) return wrong(fmt::format("ends at tick {}, before {}", end.tick, latest_));
        if (auto proven = check_states(end.tick); !proven) return proven;
        recording_.end = end.tick;
        return {};
    }

    // Every tick is at most ticks_per_state after a state line,
    // so a long file has at least as many ticks as lines.
    Outcome<void> check_states(std::int64_t tick) const {
        const std::int64_t until = proven_until_ + recording_.header.ticks_per_state;
        if (tick <= until) return {};
        return wrong(fmt::format("names tick {}, but the state lines after tick {} are missing", tick,
                                 std::max<std::int64_t>(proven_until_, 0)));
    }

    std::istream& stream_;
    std::string name_;
    std::string line_;
    std::size_t line_number_ = 0;
    std::size_t whole_bytes_ = 0;  // of the lines read so far
    std::int64_t latest_ = 0;
    std::int64_t proven_until_ =
        0;  // tick of the last state line; before any, that of the scenario or the parent
    const Memory& memory_;
    Chain chain_;
    Recording recording_;
};

}  // namespace

std::int64_t Recording::last_tick() const {
    if (end) return *end;
    const std::int64_t commanded = commands.empty() ? 0 : commands.back().tick;
    return std::max(commanded, states.empty() ? 0 : states.back().tick);
}

Outcome<void> check_tick(const Recording& recording, std::int64_t tick, const std::string& name) {
    if (tick <= recording.last_tick()) return {};
    return unusable(fmt::format("{}: ends at tick {}, before {}", name, recording.last_tick(), tick));
}

Outcome<Recording> read_recording(std::istream& stream, const std::string& name, const Memory& memory) {
    return Reader(stream, name, memory).read();
}

}  // namespace game
