#include "game/app/result_card.h"

#include <array>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "game/ui/widgets.h"

namespace game {
namespace {

// The medal that comes next, and what it asks.
std::string next_medal(const Goal& goal, const Score& score) {
    const int next = score.medal + 1;
    if (next > 3) return "";
    return fmt::format(" ({} from {})", medal_name(next), goal.medals.at(static_cast<std::size_t>(next - 1)));
}

}  // namespace

ui::ResultCard card_of(const Scenario& scenario, const Score& score) {
    const Goal& goal = *scenario.goal;
    const Measures& m = score.measures;
    ui::ResultCard card{scenario.title,
                        verdict_of(score),
                        reason_of(goal, score),
                        score.won() ? goal.learn : "",
                        score.medal,
                        {}};
    card.rows.push_back({"Score", fmt::format("{}{}", score.points, next_medal(goal, score))});
    for (std::size_t i = 0; i < goal.needs.size(); ++i) {
        NeedText need = text_of(goal.needs[i], score.needs[i]);
        need.what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(need.what.front())));
        card.rows.push_back({need.what, fmt::format("{} ({})", need.value, need.bound)});
    }
    if (m.run_out > 0) {
        constexpr double kKmPerHour = 3.6;
        card.rows.push_back({"Run-out", fmt::format("{:.0f} m", m.run_out)});
        card.rows.push_back({"Drop", fmt::format("{:.0f} m", m.fall)});
        card.rows.push_back({"Top speed", fmt::format("{:.0f} m/s, {:.0f} km/h", m.peak_speed_slope,
                                                      kKmPerHour * m.peak_speed_slope)});
        std::array<char, 40> volume{};
        card.rows.push_back({"Swept along", ui::write_volume(volume, m.eroded)});
    }
    return card;
}

}  // namespace game
