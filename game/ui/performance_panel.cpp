#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "game/ui/panels.h"
#include "game/words/words.h"
#include "sim/step.h"

namespace game::ui {
namespace {

// Okabe and Ito's colour-blind-safe palette (2008), in the order of Stage.
constexpr std::array<ImU32, kStages> kStageColours{IM_COL32(240, 228, 66, 255), IM_COL32(230, 159, 0, 255),
                                                   IM_COL32(86, 180, 233, 255), IM_COL32(0, 158, 115, 255),
                                                   IM_COL32(204, 121, 167, 255)};
constexpr ImU32 kRest = IM_COL32(110, 118, 128, 255);  // frame time outside the stages
constexpr std::array kRates{16.7f, 33.3f};             // ms, 60 and 30 frames/s

// The top of the axis: the least of a few round numbers that 95 % of the frames stay below.
float top_of(const FrameTimes& times) {
    constexpr std::array kTops{40.f, 80.f, 160.f, 320.f, 640.f, 1280.f, 2560.f};
    for (const float top : kTops) {
        std::size_t above = 0;
        for (std::size_t i = 0; i < times.size(); ++i) above += times[i].frame_ms > top;
        if (above * 20 <= times.size()) return top;
    }
    return kTops.back();
}

struct Chart {
    ImVec2 from, to;  // px
    float top;        // ms

    float y(float ms) const { return to.y - (to.y - from.y) * std::min(ms / top, 1.f); }
};

void bar(ImDrawList& list, const Chart& chart, float x, float width, const FrameTime& frame) {
    float ms = 0;
    const auto part = [&](float more, ImU32 colour) {
        if (more <= 0 || ms >= chart.top) return;
        list.AddRectFilled({x, chart.y(ms + more)}, {x + width, chart.y(ms)}, colour);
        ms += more;
    };
    for (std::size_t stage = 0; stage < kStages; ++stage) part(frame.stage_ms[stage], kStageColours[stage]);
    part(frame.frame_ms - ms, kRest);
    // Marks a frame that exceeds the axis.
    if (frame.frame_ms > chart.top)
        list.AddRectFilled({x, chart.from.y}, {x + width, chart.from.y + 3}, kWarning);
}

void axis(Desk& desk, ImDrawList& list, const Chart& chart) {
    ImFont* letters = desk.widgets.letters.small;
    const auto label = [&](float ms, const char* format) {
        std::array<char, 24> text;
        std::snprintf(text.data(), text.size(), format, static_cast<double>(ms));
        list.AddText(letters, letters->FontSize,
                     {chart.to.x + desk.em() * 0.3f, chart.y(ms) - letters->FontSize / 2}, palette().dim_text,
                     text.data());
    };
    for (const float ms : kRates) {
        list.AddLine({chart.from.x, chart.y(ms)}, {chart.to.x, chart.y(ms)}, IM_COL32(255, 255, 255, 90));
        // On a long axis the labels 16.7 and 33.3 would overlap.
        if (chart.top <= 160 || ms > 20) label(ms, "%.1f");
    }
    label(0, "%.0f");
    label(chart.top, "%.0f ms");
}

void chart(Desk& desk, const FrameTimes& times) {
    const float em = desk.em();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 7 * em;
    const Chart chart{
        {from.x, from.y + em * 0.5f}, {from.x + width - 3.4f * em, from.y + height}, top_of(times)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(chart.from, chart.to, IM_COL32(0, 0, 0, 70));
    const float each = (chart.to.x - chart.from.x) / static_cast<float>(FrameTimes::kKept);
    const std::size_t missing = FrameTimes::kKept - times.size();
    for (std::size_t i = 0; i < times.size(); ++i)
        bar(list, chart, chart.from.x + each * static_cast<float>(missing + i), each, times[i]);
    axis(desk, list, chart);
    ImGui::Dummy({width, height + em * 0.5f});
    desk.widgets.note("Chart");
}

// A stage in the left or the right half of a row.
void stage_cell(Desk& desk, const char* name, ImU32 colour, double ms, bool left) {
    const float em = desk.em(), side = em * 0.7f, half = (ImGui::GetWindowContentRegionMax().x) / 2;
    const float from = left ? ImGui::GetCursorPosX() : half + em;
    if (!left) ImGui::SameLine(from);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + (ImGui::GetTextLineHeight() - side) / 2;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + side, y + side}, colour, side * 0.2f);
    ImGui::Dummy({side, ImGui::GetTextLineHeight()});
    ImGui::SameLine();
    ImGui::TextUnformatted(tr(name));
    desk.widgets.note(name);
    std::array<char, 24> text;
    std::snprintf(text.data(), text.size(), "%.2f ms", ms);
    ImGui::SameLine(from + em * 10 - ImGui::CalcTextSize(text.data()).x);
    ImGui::TextUnformatted(text.data());
}

void stages(Desk& desk, const FrameTimes& times) {
    for (std::size_t stage = 0; stage < kStages; ++stage)
        stage_cell(desk, kStageNames[stage], kStageColours[stage], times.median_ms(static_cast<Stage>(stage)),
                   stage % 2 == 0);
    stage_cell(desk, "other", kRest, times.median_rest_ms(), kStages % 2 == 0);
}

}  // namespace

void performance_panel(Desk& desk, const Facts& facts) {
    Widgets& widgets = desk.widgets;
    const FrameTimes& times = facts.times;
    const sim::Grid& grid = facts.state.grid;
    chart(desk, times);
    widgets.dim("The last 240 frames; an amber tip exceeds the axis.");
    widgets.heading("In the last second");
    stages(desk, times);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    widgets.fact("Frames", "%.1f per second", times.frames_per_second());
    widgets.fact("Worst tick", "%.1f ms", static_cast<double>(times.worst_tick_ms()));
    widgets.fact("Ticks per frame", "%.1f", times.ticks_per_frame());
    widgets.heading("Now");
    widgets.fact("Image", "%d × %d, %s", facts.image.width, facts.image.height,
                 tr(facts.image.fine ? "2 × 2 samples" : "one sample"));
    widgets.fact("Sub-steps per tick", "%d", sim::substeps_of(facts.state).count);
    widgets.fact("Grid", "%d × %d squares", grid.nx - 1, grid.ny - 1);
    ImGui::PopStyleVar();
    widgets.dim("Drawn by %.*s", static_cast<int>(facts.renderer.size()), facts.renderer.data());
    widgets.note("Drawn by");
}

}  // namespace game::ui
