#include "game/app/challenge_maker.h"

#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "game/base/process.h"
#include "game/files/own_worlds.h"
#include "game/files/user_folders.h"
#include "sim/core/check.h"

namespace game {

ChallengeMaker::~ChallengeMaker() {
    stop_ = true;
    if (job_.valid()) job_.wait();
}

Outcome<void> ChallengeMaker::begin(Scenario scenario, Deeds deeds, const sim::StepOptions& options) {
    CHECK(!job_.valid());
    try {
        job_ = std::async(std::launch::async, [this, scenario = std::move(scenario), deeds = std::move(deeds),
                                               options] { return make(scenario, deeds, options); });
    } catch (const std::system_error& thrown) {
        return tl::unexpected(failure_of(thrown));
    }
    return {};
}

std::optional<Outcome<ChallengeMaker::Made>> ChallengeMaker::result() {
    if (!job_.valid() || job_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    return job_.get();
}

// Catches exceptions, because none may leave the thread.
Outcome<ChallengeMaker::Made> ChallengeMaker::make(const Scenario& scenario, const Deeds& deeds,
                                                   const sim::StepOptions& options) const {
    lower_priority_of_thread();
    const auto folder = own_folder(OwnKind::kChallenge);
    if (!folder) return tl::unexpected(folder.error());
    const auto file = new_file(*folder, dated_name(scenario.title), "couloir");
    if (!file) return tl::unexpected(file.error());
    Outcome<Scenario> made;
    try {
        made = make_challenge(scenario, deeds, options, *file, stop_);
    } catch (const std::exception& thrown) {  // such as out of memory
        made = tl::unexpected(failure_of(thrown));
    }
    if (made) return Made{*file, made->goal->medals.back()};
    std::error_code ignored;  // then it stays empty, and nobody can open it
    std::filesystem::remove(*file, ignored);
    return tl::unexpected(made.error());
}

}  // namespace game
