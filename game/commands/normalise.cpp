#include <fmt/format.h>

#include "game/analysis/summary.h"
#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/compare/comparison.h"
#include "game/files/file_use.h"
#include "game/recording/recording_file.h"
#include "game/session/verifier.h"

namespace game {

Outcome<int> normalise(const NormaliseOptions& options) {
    const auto old = open_recording(options.recording, options.memory);
    if (!old) return tl::unexpected(old.error());
    const Header& header = old->recording.header;
    if (header.minor > kFormatMinor)
        return unusable(
            fmt::format("{}: recorded in format {}.{}, newer than this program's {}.{}; rewriting would lose "
                        "the members it does not know",
                        options.recording, kFormatMajor, header.minor, kFormatMajor, kFormatMinor));
    Header rewritten = header;
    rewritten.physics_version = kPhysicsVersion;
    rewritten.ticks_per_state = kTicksPerState;
    rewritten.rewritten_from = Origin{header.minor, header.physics_version, header.program};
    FileUse use;
    if (auto sound = use.reads(old->path).writes("--out", options.out).check(); !sound)
        return tl::unexpected(sound.error());
    auto recorder = record_into(options.out, rewritten, RecordingReplaces::kWhenDone);
    if (!recorder) return tl::unexpected(recorder.error());

    auto session = Session::begin(header.scenario, options.step_options, std::move(*recorder));
    if (!session) return tl::unexpected(session.error());
    Verifier verifier(old->recording);
    verifier.look_at(*session);
    Watchers watchers;
    watchers.after_tick = [&](const Session& now) { verifier.look_at(now); };
    if (auto done = play_headless(*session, old->recording.commands, Until::after(old->recording.last_tick()),
                                  watchers, "rewriting");
        !done)
        return tl::unexpected(done.error());
    if (auto closed = session->finish(); !closed) return tl::unexpected(closed.error());

    const std::size_t commands = old->recording.commands.size();
    const std::int64_t ticks = session->state().tick;
    print_line(stdout, "{}: format {}.{}, physics {} → {}: format {}.{}, physics {}; {} {}, {} {}",
               options.recording, kFormatMajor, header.minor, header.physics_version, options.out.string(),
               kFormatMajor, kFormatMinor, kPhysicsVersion, commands, commands == 1 ? "command" : "commands",
               ticks, ticks == 1 ? "tick" : "ticks");
    print_text(to_text(verifier.verdict()));
    return verifier.verdict().parted ? Failure::kBadAnswer : 0;
}

}  // namespace game
