#include "game/app/measuring.h"

#include <glm/common.hpp>

namespace game {
namespace {

constexpr double kLeastCells = 2;  // of a line
constexpr int kPiecesOfSection = 96;

}  // namespace

void Measuring::move_to(glm::dvec2 at, double cell, double zero) {
    if (!from_) return;
    const SectionLine line{*from_, at};
    if (line.length() < kLeastCells * cell || section_.line() == line) return;
    section_.lay(line, zero);
    waits_ = false;
}

void Measuring::release() {
    from_.reset();
}

void Measuring::see_tick(const Session& session, std::int64_t known_until) {
    if (!history_.since()) return;
    const sim::State& state = session.state();
    history_.see(session.view(), session.peaks(), session.densities(),
                 static_cast<double>(state.params.tick_s), known_until);
}

void Measuring::see(const Session& session, std::int64_t known_until) {
    section_.see(session.view(), session.peaks());
    history_.begin(session.view());
    history_.forget_after(known_until);
    if (history_.samples().empty()) see_tick(session, known_until);
}

void Measuring::trace(const View& view, const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen) {
    if (view_ == view && traced_ == section_.line()) return;
    view_ = view;
    traced_ = section_.line();
    trace_line(seen);
    trace_houses(seen);
}

void Measuring::trace_line(const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen) {
    pieces_.clear();
    from_px_.reset(), to_px_.reset();
    if (!traced_) return;
    std::optional<glm::dvec2> before;
    for (int i = 0; i <= kPiecesOfSection; ++i) {
        const auto at = seen(glm::mix(traced_->from, traced_->to, static_cast<double>(i) / kPiecesOfSection));
        if (at && before) pieces_.push_back({*before, *at, ui::GoalLine::Around::kSection});
        if (i == 0) from_px_ = at;
        if (i == kPiecesOfSection) to_px_ = at;
        before = at;
    }
}

void Measuring::trace_houses(const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen) {
    houses_.clear();
    const auto houses = history_.houses();
    for (std::size_t i = 0; i < houses.size(); ++i)
        if (const auto at = houses[i].thing ? seen(houses[i].at) : std::nullopt) houses_.push_back({i, *at});
}

}  // namespace game
