#include "game/app/challenge_maker.h"

#include <exception>
#include <system_error>
#include <utility>

#include "game/base/process.h"
#include "game/files/shelf.h"
#include "game/files/user_folders.h"

namespace game {

namespace {

// Nothing remains of an unfinished challenge.
Outcome<ChallengeMaker::Made> make_file(const Scenario& scenario, const History& history,
                                        const sim::StepOptions& options, const std::atomic<bool>& stopped) {
    const auto folder = shelf_folder(ShelfKind::kChallenge);
    if (!folder) return tl::unexpected(folder.error());
    const auto file = new_file(*folder, shelf_name(scenario.title), "couloir");
    if (!file) return tl::unexpected(file.error());
    Outcome<Scenario> made;
    try {
        made = make_challenge(scenario, history, options, *file, stopped);
    } catch (const std::exception& thrown) {  // such as out of memory
        made = tl::unexpected(failure_of(thrown));
    }
    if (made) return ChallengeMaker::Made{*file, made->goal->medals.back()};
    std::error_code ignored;  // then it stays empty, and nobody can open it
    std::filesystem::remove(*file, ignored);
    return tl::unexpected(made.error());
}

}  // namespace

Outcome<void> ChallengeMaker::begin(Scenario scenario, History history, const sim::StepOptions& options,
                                    std::optional<render::Picture> picture) {
    picture_ = std::move(picture);
    return job_.begin([scenario = std::move(scenario), history = std::move(history),
                       options](const std::atomic<bool>& stopped) {
        return make_file(scenario, history, options, stopped);
    });
}

}  // namespace game
