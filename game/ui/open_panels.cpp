#include <algorithm>
#include <array>
#include <cstdio>

#include "game/ui/panels.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kColumn = 24, kReadingsHeight = 11.6f, kHelp = 78,
                kBesides = 20;  // em: sizes, and the gap between two columns

bool in_left_column(Panel panel) {
    return panel == Panel::kScene || panel == Panel::kDisplay || panel == Panel::kFilm ||
           panel == Panel::kMeasure;
}

void build(Desk& desk, Panel panel, const Facts& facts, Actions& actions) {
    switch (panel) {
        case Panel::kScene:
            return scene_panel(desk, facts, actions);
        case Panel::kPhysics:
            return physics_panel(desk, facts, actions);
        case Panel::kDisplay:
            return display_panel(desk, facts, actions);
        case Panel::kPerformance:
            return performance_panel(desk, facts);
        case Panel::kFilm:
            return film_panel(desk, facts, actions);
        case Panel::kMeasure:
            return measure_panel(desk, facts, actions);
        case Panel::kHelp:
            return help_panel(desk, facts.keys);
    }
}

// Title on the left, close button on the right.
void header(Desk& desk, const PanelInfo& info) {
    const float side = ImGui::GetFrameHeight();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr(info.title));
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - side * 1.2f);
    char label[32];
    std::snprintf(label, sizeof label, "Close %s", info.title);
    if (desk.widgets.icon_button(label, Icon::kClose, "Closes this panel.")) desk.panels.toggle(info.panel);
    ImGui::Separator();
}

struct PanelFrame {
    float x, y, width, most_height;
};

// Returns the panel's height.
float draw(Desk& desk, const PanelInfo& info, const PanelFrame& frame, const Facts& facts, Actions& actions) {
    ImGui::SetNextWindowPos({frame.x, frame.y});
    // Panels that overlap others are nearly opaque.
    ImGui::SetNextWindowBgAlpha(info.panel == Panel::kHelp || desk.narrow() ? 0.97f : 0.9f);
    ImGui::SetNextWindowSizeConstraints({frame.width, 0}, {frame.width, frame.most_height});
    ImGui::Begin(info.title, nullptr,
                 (kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize) & ~ImGuiWindowFlags_NoScrollbar);
    header(desk, info);
    build(desk, info.panel, facts, actions);
    const float height = ImGui::GetWindowSize().y;
    std::array<char, 32> label;
    std::snprintf(label.data(), label.size(), "Panel %s", info.title);
    desk.widgets.keep_window_clear(label.data());
    ImGui::End();
    return height;
}

// Stacks the panels of a column; each gets an equal share of the remaining height.
void column(Desk& desk, bool left, const Facts& facts, Actions& actions) {
    const auto mine = [&](const PanelInfo& info) {
        return info.panel != Panel::kHelp && in_left_column(info.panel) == left &&
               desk.panels.is_open(info.panel);
    };
    auto waiting = std::count_if(std::begin(kPanelInfos), std::end(kPanelInfos), mine);
    const float width = std::min(kColumn * desk.em(), desk.size.x - 2 * desk.margin());
    // Above the readings in the corner, if there is enough room.
    float bottom = desk.time_bar_top;
    if (left && desk.beside_time_bar())
        bottom = desk.size.y - desk.margin() - std::max(desk.readings_height, kReadingsHeight * desk.em());
    if (desk.narrow()) bottom = desk.size.y;
    (left ? desk.left_column : desk.right_column) = waiting > 0 ? width + desk.margin() : 0;
    PanelFrame frame{left ? desk.margin() : desk.size.x - desk.margin() - width,
                     desk.toolbar_bottom + desk.margin(), width, 0};
    for (const PanelInfo& info : kPanelInfos) {
        if (!mine(info)) continue;
        const float gaps = static_cast<float>(waiting) * desk.margin();
        frame.most_height = std::max((bottom - frame.y - gaps) / static_cast<float>(waiting), desk.em() * 5);
        frame.y += draw(desk, info, frame, facts, actions) + desk.margin();
        --waiting;
    }
}

}  // namespace

void OpenPanels::toggle(Panel panel) {
    bool& open = open_[static_cast<std::size_t>(panel)];
    open = hidden_ || !open;  // a hidden panel counts as closed
    hidden_ = false;
    if (open) last_ = panel;
}

bool OpenPanels::any_open() const {
    return !hidden_ && std::ranges::find(open_, true) != open_.end();
}

void OpenPanels::close_one() {
    for (const Panel panel : {Panel::kHelp, last_})
        if (is_open(panel)) return toggle(panel);
    const auto any = std::find(open_.begin(), open_.end(), true);
    if (any != open_.end()) *any = false;
}

void OpenPanels::keep_only_last() {
    const bool open = is_open(last_);
    open_.fill(false);
    open_[static_cast<std::size_t>(last_)] = open;
}

void open_panels(Desk& desk, const Facts& facts, Actions& actions) {
    if (desk.size.x < (2 * kColumn + kBesides) * desk.em()) desk.panels.keep_only_last();
    column(desk, true, facts, actions);
    column(desk, false, facts, actions);
    if (!desk.panels.is_open(Panel::kHelp)) return;
    const PanelInfo& info = kPanelInfos[static_cast<std::size_t>(Panel::kHelp)];
    const float width = std::min(kHelp * desk.em(), desk.size.x - 2 * desk.margin());
    const float top = desk.toolbar_bottom + desk.margin();
    draw(desk, info, {(desk.size.x - width) / 2, top, width, desk.size.y - top - desk.margin()}, facts,
         actions);
}

const char* title_in(const std::vector<Catalogue::Entry>& entries, const std::string& name) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Catalogue::Entry& entry) { return entry.name == name; });
    return found == entries.end() ? name.c_str() : found->title.c_str();
}

}  // namespace game::ui
