#include "game/recording/recorder.h"

#include <utility>

#include <fmt/format.h>

#include "game/base/limits.h"

namespace game {
namespace {

class MemoryStore final : public RecordingStore {
  public:
    explicit MemoryStore(std::string name) : name_(std::move(name)) {}

    Outcome<void> write(std::string_view line, bool /*is_header*/) override {
        bytes_ += line;
        return {};
    }
    Outcome<void> cut(std::int64_t bytes) override {
        bytes_.resize(static_cast<std::size_t>(bytes));
        return {};
    }
    Outcome<std::string> read(std::int64_t bytes) const override {
        return bytes_.substr(0, static_cast<std::size_t>(bytes));
    }
    std::string_view in_place() const override { return bytes_; }
    Outcome<void> end() override { return {}; }
    std::string name() const override { return name_; }
    Open again() const override { return in_memory(name_); }

  private:
    std::string name_, bytes_;
};

}  // namespace

RecordingStore::Open in_memory(std::string name) {
    return [name = std::move(name)]() -> Outcome<std::unique_ptr<RecordingStore>> {
        return std::make_unique<MemoryStore>(name);
    };
}

Outcome<Recorder> Recorder::create(const RecordingStore::Open& open, const Header& header) {
    auto store = open();
    if (!store) return tl::unexpected(store.error());
    Recorder recorder(std::move(*store));
    // A file name may be invalid UTF-8, but a recording must be valid.
    recorder.line_ = to_json(header).dump(-1, ' ', false, Json::error_handler_t::replace);
    if (const auto written = recorder.write_line(); !written) return tl::unexpected(written.error());
    recorder.line_ = {};  // frees the header's memory, which is not needed again
    return recorder;
}

Outcome<Recorder> Recorder::fork(const RecordingStore::Open& open, const Recording& of,
                                 const std::string& name, std::int64_t tick) {
    const bool comparable = is_comparable(of.header);
    if (!comparable && tick > kMostTicksOfParent)
        return unusable(
            fmt::format("{} was recorded with another version of the physics, so it cannot be continued "
                        "after tick {}; use couloir normalise first",
                        name, kMostTicksOfParent));
    Header header;
    header.scenario = of.header.scenario;
    header.parent = Parent{name, tick};
    header.ticks_per_state =
        std::max(header.ticks_per_state, of.header.ticks_per_state);  // its states come as rarely
    auto recorder = create(open, header);
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
    return write_line();
}
Outcome<void> Recorder::state(const StateLine& line) {
    write(line, line_);
    if (auto written = write_line(); !written) return written;
    mark_.last_state = line.tick;
    return {};
}
Outcome<void> Recorder::claim(const ClaimLine& line) {
    write(line, line_);
    return write_line();
}
Outcome<void> Recorder::end(std::int64_t tick) {
    write(EndLine{tick}, line_);
    if (auto written = write_line(); !written) return written;
    return store_->end();
}

Outcome<std::string> Recorder::copy_ended_at(std::int64_t tick, const StateLine* last) const {
    auto copy = store_->read(mark_.bytes);
    if (!copy) return copy;
    Chain chain = mark_.chain;
    std::string text;
    const auto add = [&](const auto& line) {
        write(line, text);
        chain.close(text);
        *copy += text + '\n';
        text.clear();
    };
    if (last) add(*last);
    add(EndLine{tick});
    return copy;
}

Outcome<void> Recorder::rewind(const Mark& mark) {
    if (auto done = store_->cut(mark.bytes); !done) return done;
    mark_ = mark;
    return {};
}

Outcome<void> Recorder::write_line() {
    Mark after = mark_;
    after.chain.close(line_);
    line_ += '\n';
    after.bytes += static_cast<std::int64_t>(line_.size());
    auto written = store_->write(line_, mark_.bytes == 0);
    line_.clear();
    if (written) mark_ = after;
    return written;
}

}  // namespace game
