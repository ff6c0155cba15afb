#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "game/base/limits.h"
#include "game/controls/path_maker.h"
#include "game/ui/panels.h"

namespace game::ui {
namespace {

struct ViewName {
    FilmView view;
    const char* name;
};
constexpr std::array kViews{
    ViewName{FilmView::kScene, "as you see it now"},
    ViewName{FilmView::kChase, "follows the front"},
    ViewName{FilmView::kFront, "from where it comes to rest"},
    ViewName{FilmView::kTop, "from above"},
    ViewName{FilmView::kPath, "along the camera path"},
};
struct SizeName {
    int width, height;
    const char* name;
};
constexpr std::array kSizes{SizeName{854, 480, "854 × 480"}, SizeName{1280, 720, "1280 × 720"},
                            SizeName{1920, 1080, "1920 × 1080"}, SizeName{3840, 2160, "3840 × 2160"}};
constexpr std::array kFilmRates{24, 30, 60};
constexpr std::array kRateNames{"24", "30", "60"};
constexpr std::array kKindNames{"MP4: for every player", "WebM: for web pages", "MKV with AV1: smallest"};

// The place of what is chosen in its list.
template <class List, class Is>
int place_in(const List& list, const Is& is) {
    return static_cast<int>(std::find_if(list.begin(), list.end(), is) - list.begin());
}

template <class List, class Name>
int choose(Desk& desk, const char* label, const List& list, int at, const char* tooltip, const Name& name) {
    desk.widgets.row(label);
    desk.widgets.choice(label, at, static_cast<int>(list.size()), tooltip,
                        [&](int i) { return name(static_cast<std::size_t>(i)); });
    return at;
}

void choices(Desk& desk) {
    FilmWish& wish = desk.film;
    const int view = choose(desk, "Film camera", kViews,
                            place_in(kViews, [&](const ViewName& v) { return v.view == wish.view; }),
                            "Where the film is seen from.", [](std::size_t i) { return kViews.at(i).name; });
    wish.view = kViews.at(static_cast<std::size_t>(view)).view;
    const int size = choose(desk, "Film size", kSizes,
                            place_in(kSizes, [&](const SizeName& s) { return s.width == wish.width; }),
                            "Width and height in pixels.", [](std::size_t i) { return kSizes.at(i).name; });
    wish.width = kSizes.at(static_cast<std::size_t>(size)).width;
    wish.height = kSizes.at(static_cast<std::size_t>(size)).height;
    const int rate = choose(
        desk, "Images per second", kFilmRates, place_in(kFilmRates, [&](int fps) { return fps == wish.fps; }),
        "More are smoother and take longer.", [](std::size_t i) { return kRateNames.at(i); });
    wish.fps = kFilmRates.at(static_cast<std::size_t>(rate));
    const int kind = choose(desk, "Kind of file", kKindNames, static_cast<int>(wish.kind),
                            "How the film is encoded.", [](std::size_t i) { return kKindNames.at(i); });
    wish.kind = static_cast<FilmWish::Kind>(kind);
    bool sound = !wish.silent;
    if (desk.widgets.toggle("With sound", sound, "What is heard at the camera of the film."))
        wish.silent = !sound;
}

void film(Desk& desk, const Facts& facts, Actions& actions) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::BeginDisabled(facts.filming.has_value());
    choices(desk);
    ImGui::EndDisabled();
    if (facts.filming) {
        std::array<char, 32> text;
        std::snprintf(text.data(), text.size(), "%.0f %%", 100 * *facts.filming);
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram, faded(kAccent, 0.6f));
        ImGui::ProgressBar(static_cast<float>(*facts.filming), {width, 0}, text.data());
        ImGui::PopStyleColor();
        desk.widgets.note("Filming");
        if (desk.widgets.button("Stop filming", "Ends the film; nothing of it is kept.", false, width))
            actions.emplace_back(StopFilm{});
        desk.widgets.dim("The slide is played again in the background. You can go on.");
        return;
    }
    const bool is_flow = facts.scenario.flow.has_value();
    ImGui::BeginDisabled(is_flow);
    if (desk.widgets.button("Film it",
                            is_flow ? "A flow demo has no slide to film."
                                    : "Films what was done here, from the first action until nothing moves.",
                            true, width))
        actions.emplace_back(FilmSlide{desk.film});
    ImGui::EndDisabled();
    desk.widgets.dim("The program ffmpeg writes it; the film comes into couloir/films of your data folder.");
}

// Two in a row.
void key_rows(Desk& desk, const PathNote& path, Actions& actions) {
    const float gap = ImGui::GetStyle().ItemSpacing.x, close = ImGui::GetFrameHeight() * 1.2f;
    const float width = (ImGui::GetContentRegionAvail().x - gap) / 2 - close - gap / 2;
    for (std::size_t k = 0; k < path.keys.size(); ++k) {
        const double time = path.keys[k].time_s;
        std::array<char, 48> go, remove;
        std::snprintf(go.data(), go.size(), "%.1f s", time);
        std::snprintf(remove.data(), remove.size(), "##Remove key %zu", k + 1);
        if (k % 2 == 1) ImGui::SameLine();
        ImGui::PushID(static_cast<int>(k));
        if (desk.widgets.button(go.data(), "Goes to this key: its time and its camera.",
                                std::abs(time - path.now_s) < PathMaker::kSameTime, width))
            actions.emplace_back(EditPath{EditPath::What::kGoTo, k});
        ImGui::SameLine(0, gap / 2);
        if (desk.widgets.icon_button(remove.data(), Icon::kClose, "Removes this key."))
            actions.emplace_back(EditPath{EditPath::What::kRemove, k});
        ImGui::PopID();
    }
}

void camera_path(Desk& desk, const PathNote& path, Actions& actions) {
    desk.widgets.heading("Camera path");
    if (path.keys.size() < kFewestCameraKeys)
        desk.widgets.dim("Go to a time, turn the view, add a key. A path has two keys or more.");
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    const auto ask = [&](const char* label, const char* tooltip, EditPath::What what, bool may, bool on) {
        ImGui::BeginDisabled(!may);
        if (desk.widgets.button(label, tooltip, on, half)) actions.emplace_back(EditPath{what});
        ImGui::EndDisabled();
    };
    ask("Add key", "Keeps this camera for this time, or replaces the key that is there.",
        EditPath::What::kAdd, true, false);
    ImGui::SameLine();
    if (path.plays)
        ask("Stop the preview", "The camera stays where it is.", EditPath::What::kStop, true, true);
    else
        ask("Play the path", "The camera moves from key to key while time runs.", EditPath::What::kPlay,
            path.keys.size() >= kFewestCameraKeys, false);
    ask("Save path", "Writes these keys to a file beside the recording.", EditPath::What::kSave,
        path.keys.size() >= kFewestCameraKeys, false);
    ImGui::SameLine();
    ask("Load path", "Reads the keys that were saved beside the recording.", EditPath::What::kLoad, true,
        false);
    key_rows(desk, path, actions);
}

}  // namespace

void film_panel(Desk& desk, const Facts& facts, Actions& actions) {
    film(desk, facts, actions);
    camera_path(desk, facts.path, actions);
}

}  // namespace game::ui
