#include "game/recording/recorder.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace game {

Outcome<Recorder> Recorder::create(const std::filesystem::path& path, const Start& start) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file)
        return machine_fails(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
    Recorder recorder(path, file);
    Header header;
    header.start = start;
    if (const auto written = recorder.write(to_json(header)); !written)
        return tl::unexpected(written.error());
    return recorder;
}

Outcome<void> Recorder::command(const TimedCommand& command) {
    return write(to_json(command));
}
Outcome<void> Recorder::state(const StateLine& line) {
    return write(to_json(line));
}
Outcome<void> Recorder::end(std::int64_t tick) {
    return write(to_json(EndLine{tick}));
}

Outcome<void> Recorder::write(const Json& json) {
    const std::string line = chain_.write(json) + '\n';
    if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0)
        return machine_fails(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
    return {};
}

}  // namespace game
