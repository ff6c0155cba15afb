#include "game/commands/commands.h"
#include "game/compare/comparison.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"

namespace game {

Outcome<int> compare(const CompareOptions& options) {
    // Both recordings are played, then run again in lockstep.
    Memory memory = options.memory;
    memory.use = {.sessions = 2, .runs = 2};
    const auto a = open_recording(options.first, memory), b = open_recording(options.second, memory);
    for (const auto* each : {&a, &b})
        if (!*each) return tl::unexpected(each->error());
    if (auto comparable = check_ground(*a, *b); !comparable) return tl::unexpected(comparable.error());
    if (options.tick)
        for (const auto* each : {&*a, &*b})
            if (auto has = check_tick(each->recording, *options.tick, each->name); !has)
                return tl::unexpected(has.error());
    FileUse use;
    use.reads(a->path).reads(b->path).writes_into("--out", options.maps, kMapNames);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    if (options.maps)
        if (auto made = make_folder(*options.maps); !made) return tl::unexpected(made.error());

    const auto play = [&](const Named& each) {
        const std::int64_t end = options.tick.value_or(each.recording.last_tick());
        return played(each, Until::after(end), options.step_options, std::nullopt);
    };
    const auto one = play(*a);
    if (!one) return tl::unexpected(one.error());
    const auto other = play(*b);
    if (!other) return tl::unexpected(other.error());
    if (auto told = tell(comparison_of(*one, *other, options.step_options), options.maps, options.json);
        !told)
        return tl::unexpected(told.error());
    return 0;
}

}  // namespace game
