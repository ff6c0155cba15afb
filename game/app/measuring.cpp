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

void Measuring::trace(const View& view, const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen) {
    const auto& line = section_.line();
    if (view_ == view && traced_ == line) return;
    view_ = view;
    traced_ = line;
    pieces_.clear();
    from_px_.reset(), to_px_.reset();
    if (!line) return;
    std::optional<glm::dvec2> before;
    for (int i = 0; i <= kPiecesOfSection; ++i) {
        const auto at = seen(glm::mix(line->from, line->to, static_cast<double>(i) / kPiecesOfSection));
        if (at && before) pieces_.push_back({*before, *at, ui::GoalLine::Around::kSection});
        if (i == 0) from_px_ = at;
        if (i == kPiecesOfSection) to_px_ = at;
        before = at;
    }
}

}  // namespace game
