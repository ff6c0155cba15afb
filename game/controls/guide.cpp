#include "game/controls/guide.h"

#include <algorithm>
#include <array>

namespace game {
namespace {

constexpr double kWaits = 8;  // s, until a place to click is shown
constexpr std::array<std::string_view, Guide::kSteps> kNames{"watch", "blast",     "rewind", "go-on",
                                                             "pour",  "challenge", "done"};

}  // namespace

std::string_view Guide::name_of(Step step) {
    return kNames.at(static_cast<std::size_t>(step));
}

std::optional<Guide::Step> Guide::step_of(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Step>(found - kNames.begin());
}

void Guide::see(const Seen& seen) {
    if (step_ == Step::kRewind && seen.may_play && seen.runs_back) go_to(Step::kGoOn);
    if (step_ == Step::kGoOn && !seen.looks_back && !seen.runs_back) go_to(Step::kPour);
    const bool slides = step_ != Step::kBlast && step_ != Step::kPour && seen.moves;
    speaks_ = seen.may_play && step_ != Step::kWatch && step_ != Step::kDone &&
              (step_ == Step::kGoOn ? !seen.runs_back : !slides && !seen.looks_back);
    if (step_ != Step::kBlast || !speaks_) waits_since_.reset();
    if (step_ == Step::kBlast && speaks_ && !waits_since_) waits_since_ = seen.now_s;
    shows_place_ = waits_since_ && seen.now_s - *waits_since_ >= kWaits;
}

void Guide::did(sim::CommandKind kind) {
    if (step_ == Step::kBlast && (kind == sim::CommandKind::kBlast || kind == sim::CommandKind::kPour))
        go_to(Step::kRewind);
    if (step_ == Step::kPour && kind == sim::CommandKind::kPour) go_to(Step::kChallenge);
}

void Guide::next() {
    if (step_ != Step::kDone) go_to(static_cast<Step>(static_cast<std::uint8_t>(step_) + 1));
}

void Guide::go_to(Step step) {
    step_ = step;
    speaks_ = shows_place_ = false;
}

}  // namespace game
