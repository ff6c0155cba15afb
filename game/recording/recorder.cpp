#include "game/recording/recorder.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "files/input.h"
#include "game/base/limits.h"

namespace game {
namespace {

tl::unexpected<Failure> cannot_write(const std::filesystem::path& path) {
    return machine_fails(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
}

}  // namespace

Outcome<void> Recorder::open(Replaces replaces) {
    using Fault = files::GrowingFile::Fault;
    replaces_ = replaces;
    std::error_code error;
    if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
    switch (to_.open(path_, replaces)) {
        case Fault::kNone:
            return {};
        case Fault::kSystem:
            return cannot_write(path_);
        case Fault::kBeingWritten:
            break;
    }
    return machine_fails(
        fmt::format("{}: another program is recording into it; close that program, or choose another file",
                    path_.string()));
}

Outcome<Recorder> Recorder::create(const std::filesystem::path& path, const Scenario& scenario,
                                   std::optional<Parent> parent) {
    Header header;
    header.scenario = scenario;
    header.parent = std::move(parent);
    return create(path, header);
}

Outcome<Recorder> Recorder::create(const std::filesystem::path& path, const Header& header,
                                   Replaces replaces) {
    Recorder recorder(path);
    if (auto opened = recorder.open(replaces); !opened) return tl::unexpected(opened.error());
    // A file name may be invalid UTF-8, but a recording must be valid.
    recorder.line_ = to_json(header).dump(-1, ' ', false, Json::error_handler_t::replace);
    if (const auto written = recorder.write_line(); !written) return tl::unexpected(written.error());
    recorder.line_ = {};  // frees the header's memory, which is not needed again
    return recorder;
}

Outcome<Recorder> Recorder::fork(const std::filesystem::path& path, const Recording& of,
                                 const std::string& name, std::int64_t tick) {
    const bool comparable = is_comparable(of.header);
    if (!comparable && tick > kMostTicksOfParent)
        return unusable(
            fmt::format("{} was recorded with another version of the physics, so it cannot be continued "
                        "after tick {}; use couloir normalise first",
                        name, kMostTicksOfParent));
    auto recorder = create(path, of.header.scenario, Parent{name, tick});
    if (!recorder) return recorder;
    auto state = of.states.begin();
    // A command applies at the start of its tick, so it follows that tick's state line.
    const auto write_states = [&](std::int64_t until) {
        for (; state != of.states.end() && state->tick <= until; ++state)
            if (comparable)
                if (auto written = recorder->state(*state); !written) return written;
        return Outcome<void>();
    };
    for (const TimedCommand& command : of.commands) {
        if (command.tick >= tick) break;
        if (auto written = write_states(command.tick); !written) return tl::unexpected(written.error());
        if (auto written = recorder->command(command); !written) return tl::unexpected(written.error());
    }
    if (auto written = write_states(tick); !written) return tl::unexpected(written.error());
    return recorder;
}

Outcome<void> Recorder::command(const TimedCommand& command) {
    write(command, line_);
    return add_line();
}
Outcome<void> Recorder::state(const StateLine& line) {
    write(line, line_);
    if (auto written = add_line(); !written) return written;
    mark_.last_state = line.tick;
    return {};
}
Outcome<void> Recorder::claim(const ClaimLine& line) {
    write(line, line_);
    return add_line();
}
Outcome<void> Recorder::end(std::int64_t tick) {
    write(EndLine{tick}, line_);
    if (auto written = write_line(); !written) return written;
    if (!to_.file().settle()) return cannot_write(path_);
    return appear();
}

Outcome<void> Recorder::add_line() {
    if (auto written = write_line(); !written) return written;
    return replaces_ == Replaces::kAsItGrows ? appear() : Outcome<void>();
}

Outcome<void> Recorder::appear() {
    if (!to_.appear()) return cannot_write(path_);
    return {};
}

Outcome<std::string> Recorder::copy_ended_at(std::int64_t tick, const StateLine* last) const {
    auto file = files::open_input(to_.place());
    if (!file) return machine_fails(file.error());
    std::string copy(static_cast<std::size_t>(mark_.bytes), '\0');
    if (!file->read(copy.data(), mark_.bytes))
        return machine_fails(fmt::format("{}: has lost what was recorded into it", path_.string()));
    Chain chain = mark_.chain;
    std::string text;
    const auto add = [&](const auto& line) {
        write(line, text);
        chain.close(text);
        copy += text + '\n';
        text.clear();
    };
    if (last) add(*last);
    add(EndLine{tick});
    return copy;
}

Outcome<void> Recorder::rewind(const Mark& mark) {
    if (!to_.file().cut(static_cast<off_t>(mark.bytes))) return cannot_write(path_);
    mark_ = mark;
    return {};
}

Outcome<void> Recorder::write_line() {
    Mark after = mark_;
    after.chain.close(line_);
    line_ += '\n';
    after.bytes += static_cast<std::int64_t>(line_.size());
    const bool whole = to_.file().write(line_);
    line_.clear();
    if (!whole) {
        const auto failed = cannot_write(path_);
        if (to_.regular()) static_cast<void>(to_.file().cut(static_cast<off_t>(mark_.bytes)));
        return failed;
    }
    mark_ = after;
    return {};
}

}  // namespace game
