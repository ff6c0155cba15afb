#include <array>
#include <cmath>
#include <cstdio>

#include "game/controls/key_map.h"
#include "game/ui/panels.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr float kInOneRow = 70;      // em, of the bar
constexpr float kTimesWidth = 2.6f;  // em, of a button for a size

struct TimesName {
    int times;
    const char* name;
};
constexpr std::array kTimesNames{TimesName{1, "1 ×"}, TimesName{2, "2 ×"}, TimesName{4, "4 ×"}};

// A slider below its name; a group, so that the next one stands beside it.
bool captioned(Desk& desk, const char* label, double& value, Slide slide, const char* tooltip) {
    ImGui::BeginGroup();
    desk.widgets.caption(label, slide.width);
    const bool changed = desk.widgets.slider(label, value, slide, tooltip);
    ImGui::EndGroup();
    return changed;
}

bool focal_length(Desk& desk, const PhotoNote& photo, PhotoSettings& settings, float width) {
    return captioned(desk, "Focal length", settings.focal_mm,
                     {photo.focal.least, photo.focal.most, "%.0f mm", true, false, width},
                     "Focal length in front of a sensor 36 mm wide: short shows much, long brings near.");
}

bool exposure(Desk& desk, PhotoSettings& settings, float width) {
    constexpr double kMost = PhotoSettings::kMostExposure, kStep = 0.1;
    if (!captioned(desk, "Exposure", settings.exposure, {-kMost, kMost, "%+.1f EV", false, false, width},
                   "Each EV more is twice the light."))
        return false;
    settings.exposure = kStep * std::round(settings.exposure / kStep);
    return true;
}

bool time_of_day(Desk& desk, const PhotoNote& photo, PhotoSettings& settings, float width) {
    constexpr int kMinutes = 60, kStep = 5;
    const auto in_steps = [](double hour) {
        return kStep * static_cast<int>(std::lround(hour * kMinutes / kStep));
    };
    const int minutes = in_steps(photo.hour);
    std::array<char, 16> shown;  // without a placeholder: a slider shows it as it is
    std::snprintf(shown.data(), shown.size(), "%02d:%02d", minutes / kMinutes, minutes % kMinutes);
    double hour = photo.hour;
    if (!captioned(desk, "Time of day", hour, {0, 24, shown.data(), false, false, width},
                   "The sun of a day in winter, or in summer where there is no snow. Afterwards the light is "
                   "as before."))
        return false;
    settings.hour = static_cast<double>(in_steps(hour)) / kMinutes;
    return true;
}

// Steps of the aperture, of which the first makes all sharp.
bool aperture(Desk& desk, const PhotoNote& photo, PhotoSettings& settings, float width) {
    std::size_t step = 0;
    for (std::size_t i = 0; i < kFNumbers.size(); ++i)
        if (kFNumbers.at(i) == settings.f_number) step = i;
    std::array<char, 48> shown;
    if (step == 0)
        std::snprintf(shown.data(), shown.size(), "%s", tr("all is sharp"));
    else
        std::snprintf(shown.data(), shown.size(), "f/%.3g, %.0f m", settings.f_number, photo.focus_m);
    auto value = static_cast<double>(step);
    if (!captioned(
            desk, "Depth of field", value,
            {0, static_cast<double>(kFNumbers.size() - 1), shown.data(), false, false, width},
            "To the right less is sharp. Click on what is to be sharp. The lens sees a model 500 times "
            "smaller."))
        return false;
    settings.f_number = kFNumbers.at(static_cast<std::size_t>(std::lround(value)));
    return true;
}

bool size(Desk& desk, const PhotoNote& photo, PhotoSettings& settings) {
    bool changed = false;
    ImGui::BeginGroup();
    desk.widgets.caption("Size", 3 * kTimesWidth * desk.em());
    for (const TimesName& each : kTimesNames) {
        if (each.times > 1) ImGui::SameLine(0, desk.em() * 0.2f);
        std::array<char, 96> tooltip;
        std::snprintf(tooltip.data(), tooltip.size(), tr("%d × %d pixels"), each.times * photo.screen.width,
                      each.times * photo.screen.height);
        const bool on = settings.times == each.times;
        if (!desk.widgets.button(each.name, tooltip.data(), on, kTimesWidth * desk.em()) || on) continue;
        settings.times = each.times;
        changed = true;
    }
    ImGui::EndGroup();
    return changed;
}

void buttons(Desk& desk, const Facts& facts, Actions& actions) {
    constexpr const char* kTake = "Take the photo";
    std::array<char, 160> tooltip;
    ImGui::BeginGroup();
    desk.widgets.caption("", 0);
    std::snprintf(tooltip.data(), tooltip.size(), tr("%s or %s: writes it into the folder of screenshots."),
                  name_of(facts.keys, Verb::kTakeOver).c_str(),
                  name_of(facts.keys, Verb::kScreenshot).c_str());
    const float width = ImGui::CalcTextSize(tr(kTake)).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (facts.photo->taken) {
        std::array<char, 32> share;
        std::snprintf(share.data(), share.size(), "%.0f %%", 100 * *facts.photo->taken);
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram, faded(kAccent, 0.6f));
        ImGui::ProgressBar(static_cast<float>(*facts.photo->taken), {width, 0}, share.data());
        ImGui::PopStyleColor();
        desk.widgets.note("Taking the photo");
        ImGui::SameLine();
        if (desk.widgets.button("Cancel", "Stops the photo; nothing of it is kept."))
            actions.emplace_back(Verb::kClosePanel);
        return ImGui::EndGroup();
    }
    if (desk.widgets.button(kTake, tooltip.data(), true, width)) actions.emplace_back(Verb::kScreenshot);
    ImGui::SameLine();
    std::snprintf(tooltip.data(), tooltip.size(), tr("%s or %s: leaves the photo mode."),
                  name_of(facts.keys, Verb::kClosePanel).c_str(), name_of(facts.keys, Verb::kPhoto).c_str());
    if (desk.widgets.button("Leave", tooltip.data())) actions.emplace_back(Verb::kPhoto);
    ImGui::EndGroup();
}

}  // namespace

// One row, or two where there is no room.
void photo_bar(Desk& desk, const Facts& facts, Actions& actions) {
    const PhotoNote& photo = *facts.photo;
    const float em = desk.em(), most = desk.size.x - 2 * desk.margin(), gap = ImGui::GetStyle().ItemSpacing.x;
    const bool one_row = most >= kInOneRow * em;
    const float wide = one_row ? 9.5f * em : 9 * em;
    ImGui::SetNextWindowPos({desk.size.x / 2, desk.size.y - desk.margin()}, ImGuiCond_Always, {0.5f, 1});
    ImGui::Begin("Photo", nullptr, kFixedWindow | ImGuiWindowFlags_AlwaysAutoResize);
    PhotoSettings settings = photo.settings;
    ImGui::BeginDisabled(photo.taken.has_value());
    bool changed = focal_length(desk, photo, settings, wide);
    ImGui::SameLine(0, gap);
    changed |= exposure(desk, settings, wide);
    ImGui::SameLine(0, gap);
    changed |= time_of_day(desk, photo, settings, wide);
    ImGui::SameLine(0, gap);
    changed |= aperture(desk, photo, settings, wide);
    if (one_row) ImGui::SameLine(0, 2 * gap);
    changed |= size(desk, photo, settings);
    ImGui::EndDisabled();
    ImGui::SameLine(0, 2 * gap);
    buttons(desk, facts, actions);
    if (changed) actions.emplace_back(SetPhoto{settings});
    desk.lower_edge = ImGui::GetWindowPos().y;
    desk.widgets.keep_window_clear("Photo bar");
    ImGui::End();
}

}  // namespace game::ui
