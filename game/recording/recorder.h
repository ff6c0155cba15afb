#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "game/base/outcome.h"
#include "game/recording/chain.h"
#include "game/recording/format.h"
#include "game/recording/reader.h"

namespace game {

// Where the bytes of a recording are kept while it is made. Errors of all calls: they cannot be kept (status 3); what was
// written whole remains.
class RecordingStore {
  public:
    // Opens a new and empty one.
    using Open = std::function<Outcome<std::unique_ptr<RecordingStore>>()>;

    virtual ~RecordingStore() = default;
    // Adds a line, whole or not at all. `is_header`: it is the first one.
    virtual Outcome<void> write(std::string_view line, bool is_header) = 0;
    // Keeps the first so many bytes.
    virtual Outcome<void> cut(std::int64_t bytes) = 0;
    // The first so many bytes.
    virtual Outcome<std::string> read(std::int64_t bytes) const = 0;
    // All of it where it is; nothing if it is not in memory.
    virtual std::string_view in_place() const { return {}; }
    // The last line is written.
    virtual Outcome<void> end() = 0;

    // What it is called: the path of a file.
    virtual std::string name() const = 0;
    // Opens one of the same name, which replaces this one. Call it when nothing writes to this one any more.
    virtual Open again() const = 0;
    // What the recording that this one replaced is called, while it is kept.
    virtual std::optional<std::string> replaced() const { return std::nullopt; }
    virtual void delete_replaced() {}
};

// Keeps it in memory, as the bytes of a file that nobody has written.
RecordingStore::Open in_memory(std::string name);

// Writes a recording as it happens: lines in the order of time, each with its link of the chain. Every line is passed to
// the store before the world continues. Errors of all calls: those of the store.
class Recorder {
  public:
    // Writes the header.
    static Outcome<Recorder> create(const RecordingStore::Open& open, const Header& header);

    // Continues from `of` at `tick`. The recording includes everything in `of` up to there, except states of another
    // version of the physics. `name`: the name of `of`. Errors: without these states, more than kMostTicksOfParent ticks
    // would lie before the first one, and no reader would accept the recording (status 2).
    static Outcome<Recorder> fork(const RecordingStore::Open& open, const Recording& of,
                                  const std::string& name, std::int64_t tick);

    Outcome<void> command(const TimedCommand& command);
    Outcome<void> state(const StateLine& line);
    Outcome<void> claim(const ClaimLine& line);
    Outcome<void> end(std::int64_t tick);

    // The text so far as if it ended at `tick`, with a last state line if there is one; the recording goes on.
    // Errors: the store cannot be read, as a device or a pipe.
    Outcome<std::string> copy_ended_at(std::int64_t tick, const StateLine* last) const;

    // A position in the recording to return to.
    struct Mark {
        std::int64_t bytes = 0;
        std::int64_t last_state = -1;
        Chain chain;
    };
    Mark mark() const { return mark_; }
    // Removes all lines since `mark`.
    Outcome<void> rewind(const Mark& mark);

    // The whole text so far. Errors: as copy_ended_at().
    Outcome<std::string> text() const { return store_->read(mark_.bytes); }
    // The same without taking memory, of one that is kept in memory.
    std::string_view text_in_place() const {
        return store_->in_place().substr(0, static_cast<std::size_t>(mark_.bytes));
    }

    // Tick of the last state written; −1 if there is none.
    std::int64_t last_state() const { return mark_.last_state; }
    std::string name() const { return store_->name(); }
    RecordingStore::Open again() const { return store_->again(); }
    std::optional<std::string> replaced() const { return store_->replaced(); }
    void delete_replaced() { store_->delete_replaced(); }

  private:
    explicit Recorder(std::unique_ptr<RecordingStore> store) : store_(std::move(store)) {}
    Outcome<void> write_line();  // closes line_, writes and empties it

    std::unique_ptr<RecordingStore> store_;
    Mark mark_;         // after what was written
    std::string line_;  // reused to avoid allocation
};

}  // namespace game
