#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#define XXH_STATIC_LINKING_ONLY  // for a digest on the stack
#include <xxhash.h>

#include "game/assets.h"
#include "game/commands/commands.h"
#include "game/headless.h"
#include "game/measures.h"
#include "game/recording/reader.h"
#include "game/summary.h"
#include "game/text_file.h"

namespace game {
namespace {

// Compares each recorded state with the replay's as it passes.
class Verifier {
  public:
    explicit Verifier(const Recording& recording) : states_(recording.states) {
        verdict_.comparable = recording.header.physics_version == kPhysicsVersion;
    }

    void look_at(const Session& session) {
        if (next_ == states_.size() || states_[next_].tick != session.state().tick) return;
        const StateLine recorded = states_[next_++];
        if (!verdict_.comparable || verdict_.parted) return;
        ++verdict_.compared;
        StateLine replayed = session.state_line();
        const std::int64_t initial = replayed.ledger.initial;
        replayed.ledger.initial = 0;
        if (replayed.hash != recorded.hash)
            verdict_.parted = fmt::format("at tick {} the state's hash is {}, and {} was recorded",
                                          recorded.tick, hex(replayed.hash), hex(recorded.hash));
        else if (replayed.ledger != recorded.ledger)
            verdict_.parted =
                fmt::format("at tick {} the mass ledger is not the recorded one", recorded.tick);
        else if (const auto error = recorded.ledger.mass_error() - initial; error != 0)
            verdict_.parted =
                fmt::format("at tick {} the recorded mass is off by {} quanta", recorded.tick, error);
        else
            verdict_.proven_tick = recorded.tick;
    }

    const Verdict& verdict() const { return verdict_; }

  private:
    const std::vector<StateLine>& states_;
    std::size_t next_ = 0;
    Verdict verdict_;
};

std::string file_hash(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    XXH3_state_t digest;
    XXH3_64bits_reset(&digest);
    std::vector<char> block(1 << 16);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0)
        XXH3_64bits_update(&digest, block.data(), static_cast<std::size_t>(stream.gcount()));
    return hex(XXH3_64bits_digest(&digest));
}

}  // namespace

Outcome<int> replay(const ReplayOptions& options) {
    const auto path = find_asset(AssetKind::kRecording, options.recording);
    if (!path) return tl::unexpected(path.error());
    const auto recording = read_recording(*path);
    if (!recording) return tl::unexpected(recording.error());
    if (recording->warning) fmt::print(stderr, "couloir: warning: {}\n", *recording->warning);
    const Start& start = recording->header.start;

    for (const auto& file : {options.perf, options.summary})
        if (file)
            if (auto placed = make_place_for(*file); !placed) return tl::unexpected(placed.error());
    auto session = Session::begin(start, options.threads, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    std::optional<Gallery> gallery;
    if (options.pictures.folder) {
        auto opened =
            Gallery::open(*options.pictures.folder, options.pictures.size, options.pictures.gl, start);
        if (!opened) return tl::unexpected(opened.error());
        gallery = std::move(*opened);
    }
    PerfLog perf({start.scene, file_hash(*path), options.threads, gallery ? gallery->renderer_name() : ""});
    Verifier verifier(*recording);

    Until until;
    until.tick = until.most_ticks =
        std::min(options.until.value_or(recording->last_tick()), recording->last_tick());
    Watchers watchers;
    watchers.gallery = gallery ? &*gallery : nullptr;
    watchers.ticks_per_picture = options.pictures.every;
    watchers.perf = &perf;
    if (options.verify) {
        verifier.look_at(*session);
        watchers.after_tick = [&](const Session& now) { verifier.look_at(now); };
    }
    if (auto played = play_headless(*session, recording->commands, until, watchers, "replaying"); !played)
        return tl::unexpected(played.error());
    if (gallery)
        if (auto closed = gallery->close(); !closed) return tl::unexpected(closed.error());

    const Measures measures = measure(start, *session, release_area(start, recording->commands), {});
    Summary summary{start, *session, measures, &perf, std::nullopt, std::nullopt};
    if (options.verify) summary.verdict = verifier.verdict();
    if (options.perf)
        if (auto written = perf.write_csv(*options.perf); !written) return tl::unexpected(written.error());
    if (options.summary)
        if (auto written = write_text(*options.summary, printed(to_json(summary))); !written)
            return tl::unexpected(written.error());
    fmt::print("{}", options.json ? printed(to_json(summary)) : to_text(summary));
    return options.verify && verifier.verdict().parted ? Failure::kBadAnswer : 0;
}

}  // namespace game
