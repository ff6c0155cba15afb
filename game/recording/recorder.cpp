#include "game/recording/recorder.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

namespace game {
namespace {

tl::unexpected<Failure> cannot_write(const std::filesystem::path& path) {
    return machine_fails(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
}

}  // namespace

Outcome<Recorder> Recorder::create(const std::filesystem::path& path, const Start& start,
                                   std::optional<Parent> parent) {
    Header header;
    header.start = start;
    header.parent = std::move(parent);
    return create(path, header);
}

Outcome<Recorder> Recorder::create(const std::filesystem::path& path, const Header& header) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) return cannot_write(path);
    Recorder recorder(path, file);
    // A file's name need not be UTF-8, and a recording is.
    recorder.line_ = to_json(header).dump(-1, ' ', false, Json::error_handler_t::replace);
    if (const auto written = recorder.write_line(); !written) return tl::unexpected(written.error());
    recorder.line_ = {};  // the header's memory is not needed again
    return recorder;
}

Outcome<Recorder> Recorder::fork(const std::filesystem::path& path, const Recording& of,
                                 const std::string& name, std::int64_t tick) {
    auto recorder = create(path, of.header.start, Parent{name, tick});
    if (!recorder) return recorder;
    const bool comparable = of.header.physics_version == kPhysicsVersion;
    auto state = of.states.begin();
    // A command is given at the start of its tick, so after the state of that tick.
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
    return write_line();
}
Outcome<void> Recorder::state(const StateLine& line) {
    mark_.last_state = line.tick;
    write(line, line_);
    return write_line();
}
Outcome<void> Recorder::end(std::int64_t tick) {
    write(EndLine{tick}, line_);
    return write_line();
}

Outcome<void> Recorder::rewind(const Mark& mark) {
    // Every line was flushed, so nothing of it is left in the stream.
    if (ftruncate(fileno(file_.get()), static_cast<off_t>(mark.bytes)) != 0 ||
        std::fseek(file_.get(), static_cast<long>(mark.bytes), SEEK_SET) != 0)
        return cannot_write(path_);
    mark_ = mark;
    return {};
}

Outcome<void> Recorder::write_line() {
    mark_.chain.close(line_);
    line_ += '\n';
    const std::size_t written = std::fwrite(line_.data(), 1, line_.size(), file_.get());
    const bool whole = written == line_.size() && std::fflush(file_.get()) == 0;
    mark_.bytes += static_cast<std::int64_t>(line_.size());
    line_.clear();
    if (!whole) return cannot_write(path_);
    return {};
}

}  // namespace game
