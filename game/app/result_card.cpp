#include "game/app/result_card.h"

#include <array>
#include <cctype>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "game/ui/widgets.h"
#include "game/words/words.h"

namespace game {
namespace {

// As all numbers of the card.
std::string grouped(std::int64_t points) {
    std::array<char, 40> text{};
    return ui::write_number(text, "%.0f", static_cast<double>(points));
}

// Of a try that meets all needs: the medal that comes next, and what it asks, or by how little it was missed.
std::string next_medal(const Goal& goal, const Score& score) {
    constexpr std::int64_t kNear = 10;  // less than one part in so many was missing
    const int next = score.medal + 1;
    if (next > kGold) return "";
    const std::int64_t least = goal.medals.at(static_cast<std::size_t>(next - 1));
    const std::int64_t missing = least - score.points;
    if (missing < least / kNear) return said(", {} short of {}", grouped(missing), tr(medal_name(next)));
    return said(" ({} from {})", tr(medal_name(next)), grouped(least));
}

// How a try compares with the best one before it; empty if there is nothing to compare.
std::string beside_best(const Score& score, std::span<const BestRun> earlier) {
    if (earlier.empty()) return score.meets_needs() ? tr("this one") : "";
    const BestRun& best = earlier.front();
    if (score.meets_needs() && std::pair(score.medal, score.points) > std::pair(best.medal, best.score))
        return said("this one; before it {}", grouped(best.score));
    return fmt::format("{}, {}", grouped(best.score), tr(medal_name(best.medal)));
}

// `seconds`: of the world, when it was measured; the rolling layer may erode and deposit more afterwards.
void add_rows(const Measures& m, double seconds, ui::ResultCard& card) {
    if (m.run_out <= 0) return;
    card.top = {m.top.x, m.top.y}, card.toe = {m.toe.x, m.toe.y};
    constexpr double kKmPerHour = 3.6;
    std::array<char, 40> text{};
    card.rows.push_back({tr("Run-out"), ui::write_number(text, "%.0f m", m.run_out)});
    card.rows.push_back({tr("Drop"), ui::write_number(text, "%.0f m", m.fall)});
    card.rows.push_back({tr("Top speed"), fmt::format("{:.0f} m/s, {:.0f} km/h", m.peak_speed_slope,
                                                      kKmPerHour * m.peak_speed_slope)});
    card.rows.push_back(
        {tr("Swept along"), said("{} by {:.0f} s", ui::write_volume(text, m.eroded), seconds)});
}

}  // namespace

ui::ResultCard card_of(const Scenario& scenario, const Score& score, std::span<const BestRun> earlier,
                       const std::string& advice) {
    const Goal& goal = *scenario.goal;
    const std::string learn = tr(goal.learn.c_str());
    ui::ResultCard card{
        scenario.title,
        verdict_of(score),
        reason_of(goal, score),
        advice.empty() || goal.learn.empty() ? advice + learn : fmt::format("{} {}", advice, learn),
        score.medal,
        {}};
    card.rows.push_back({tr("Score"), score.meets_needs() ? fmt::format("{}{}", grouped(score.points),
                                                                        next_medal(goal, score))
                                                          : tr("none, because it is lost")});
    if (std::string best = beside_best(score, earlier); !best.empty())
        card.rows.push_back({tr("Best run"), std::move(best)});
    for (std::size_t i = 0; i < goal.needs.size(); ++i) {
        NeedText need = text_of(goal.needs[i], score.needs[i]);
        need.what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(need.what.front())));
        card.rows.push_back({need.what, fmt::format("{} ({})", need.value, need.bound)});
    }
    add_rows(score.measures, static_cast<double>(score.tick) * static_cast<double>(scenario.params.tick_s),
             card);
    return card;
}

ui::ResultCard card_of_slide(const Scenario& scenario, const Measures& measures, double seconds) {
    ui::ResultCard card{scenario.title, tr("Your slide"), "", "", std::nullopt, {}};
    add_rows(measures, seconds, card);
    if (measures.peak_pressure)
        card.rows.push_back({tr("Top pressure"), fmt::format("{:.0f} kPa", *measures.peak_pressure)});
    return card;
}

}  // namespace game
