#include <algorithm>
#include <cmath>

#include "game/ui/panels.h"

namespace game::ui {

// Where runs ended: a dot for each place, larger for more of them, and words beside the one under the
// cursor.
void run_ends(Desk& desk, const Facts& facts) {
    if (!facts.runs || !facts.display.ends) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float em = desk.em();
    const auto px = [](glm::dvec2 at) { return ImVec2{static_cast<float>(at.x), static_cast<float>(at.y)}; };
    const auto radius = [&](const RunEnd& end) {
        return em * std::min(0.16f + 0.06f * std::sqrt(static_cast<float>(end.runs)), 0.7f);
    };
    for (const bool is_open : {false, true})  // on top
        for (const RunEnd& end : facts.runs->ends) {
            if (end.is_open != is_open) continue;
            list.AddCircleFilled(px(end.at), radius(end) + 0.1f * em, faded(kAccentText, 0.7f));
            list.AddCircleFilled(px(end.at), radius(end), is_open ? kWarning : palette().text);
        }
    if (!facts.runs->under) return;
    const RunsNote::Under& under = *facts.runs->under;
    const char *from = under.words.data(), *to = from + under.words.size();
    const ImVec2 at = px(under.at), size = ImGui::CalcTextSize(from, to);
    const float edge = 0.5f * em;
    list.AddCircle(at, 0.9f * em, kAccent, 0, 0.12f * em);
    const ImVec2 corner{std::min(at.x + 1.5f * em, desk.size.x - size.x - edge),
                        std::max(at.y - size.y - em, edge)};
    list.AddRectFilled({corner.x - edge, corner.y - edge},
                       {corner.x + size.x + edge, corner.y + size.y + edge}, palette().panel, edge);
    list.AddText(corner, palette().text, from, to);
    desk.widgets.note("Run under the cursor", corner, {corner.x + size.x, corner.y + size.y});
}

}  // namespace game::ui
