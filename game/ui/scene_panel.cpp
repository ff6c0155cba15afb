#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "game/analysis/score.h"
#include "game/ui/panels.h"
#include "game/words/words.h"

namespace game::ui {
namespace {

constexpr const char* kAsTheSceneSays = "scene default";
constexpr std::array<int, 5> kGrids{40, 80, 160, 256, 512};
constexpr std::array<const char*, 5> kGridNames{"40 squares", "80 squares", "160 squares", "256 squares",
                                                "512 squares"};
constexpr std::array kModels{sim::Model::kBcreInertial, sim::Model::kBcre, sim::Model::kVoellmy};
constexpr std::array<const char*, 3> kModelNames{"bcre-inertial: with inertia", "bcre: no inertia",
                                                 "voellmy: gravity and friction"};

const char* name_of(sim::Model model) {
    return sim::to_string(model).data();  // a literal
}

// Shows the file name, with the full path in the tooltip.
void recording_file(Desk& desk, std::string_view path) {
    const std::string_view name = path.substr(path.rfind('/') + 1);
    desk.widgets.fact("Recording", "%.*s", static_cast<int>(name.size()), name.data());
    std::array<char, 512> text;
    std::snprintf(text.data(), text.size(), tr("This session is recorded in %.*s"),
                  static_cast<int>(path.size()), path.data());
    desk.widgets.tooltip(text.data());
}

void what_is_loaded(Desk& desk, const Facts& facts) {
    Widgets& widgets = desk.widgets;
    const Scenario& scenario = facts.scenario;
    const sim::Grid& grid = facts.state.grid;
    const double dx = static_cast<double>(grid.dx);
    widgets.heading("This scene");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, desk.em() * 0.12f});
    widgets.fact("Terrain", "%s", scenario.terrain.c_str());
    if (!scenario.licence.empty()) widgets.fact("Licence", "%s", scenario.licence.c_str());
    widgets.fact("Material", "%s", tr(title_in(facts.catalogue.materials, scenario.material)));
    if (scenario.lower)
        widgets.fact("Lower material", "%s",
                     tr(title_in(facts.catalogue.materials, scenario.lower->material)));
    widgets.fact("Model", "%s", name_of(scenario.params.model));
    widgets.fact("Grid", "%d × %d squares of %.4g m", grid.nx - 1, grid.ny - 1, dx);
    widgets.fact("Extent", "%.4g × %.4g m", (grid.nx - 1) * dx, (grid.ny - 1) * dx);
    if (facts.recording.empty())
        widgets.fact("Recording", "none");
    else
        recording_file(desk, facts.recording);
    ImGui::PopStyleVar(2);
}

// The initial choice: the loaded scene if it is shipped, else the first.
int scene_at_first(const Facts& facts) {
    const auto& scenes = facts.catalogue.scenes;
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const auto& scene) { return scene.name == facts.scenario.scene; });
    return found == scenes.end() ? 0 : static_cast<int>(found - scenes.begin());
}

// A list whose first entry is the scene's default, for which `chosen` is −1.
template <class Name>
void choice_or_scenes(Desk& desk, const char* label, int& chosen, std::size_t count, const char* tooltip,
                      Name&& name) {
    int at = chosen + 1;
    desk.widgets.row(label);
    desk.widgets.choice(label, at, static_cast<int>(count) + 1, tooltip, [&](int i) {
        return i == 0 ? kAsTheSceneSays : name(static_cast<std::size_t>(i - 1));
    });
    chosen = at - 1;
}

Open begin_of(const SceneChoice& choice, const Facts& facts) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    Open open{facts.catalogue.scenes[at(choice.scene)].name, {}};
    if (choice.material >= 0) open.overrides.material = facts.catalogue.materials[at(choice.material)].name;
    if (choice.model >= 0) open.overrides.model = kModels[at(choice.model)];
    if (choice.grid >= 0) open.overrides.squares = kGrids[at(choice.grid)];
    return open;
}

// A list of the runs of the challenge that is open; the one that is chosen is played.
void best_runs_of_challenge(Desk& desk, const Facts& facts, Actions& actions) {
    if (facts.best_runs.empty()) return;
    std::array<char, 64> text{};
    const auto name = [&](std::size_t i) {
        const BestRun& run = facts.best_runs[i];
        std::snprintf(text.data(), text.size(), "%lld, %s, %.16s", static_cast<long long>(run.score),
                      tr(medal_name(run.medal)), run.when.c_str());
        return text.data();
    };
    std::array<char, 32> best{};
    std::snprintf(best.data(), best.size(), "%lld, %s", static_cast<long long>(facts.best_runs.front().score),
                  tr(medal_name(facts.best_runs.front().medal)));
    int chosen = -1;
    desk.widgets.row("Best runs");
    if (desk.widgets.choice(
            "Best runs", chosen, static_cast<int>(facts.best_runs.size()),
            "Your best tries at this challenge. Choose one to watch its recording.",
            [&](int i) { return name(static_cast<std::size_t>(i)); }, 0, best.data()))
        actions.emplace_back(Open{facts.best_runs[static_cast<std::size_t>(chosen)].file.string(), {}});
}

void what_to_begin(Desk& desk, const Facts& facts, Actions& actions) {
    SceneChoice& choice = desk.choice;
    const auto& scenes = facts.catalogue.scenes;
    const auto& materials = facts.catalogue.materials;
    if (scenes.empty()) return;
    if (choice.scene < 0) choice.scene = scene_at_first(facts);
    desk.widgets.heading("Start with another material, model or grid");
    desk.widgets.row("Scene");
    desk.widgets.choice("Choose a scene", choice.scene, static_cast<int>(scenes.size()),
                        "Terrain, initial layers, light and scheduled commands.",
                        [&](int i) { return scenes[static_cast<std::size_t>(i)].title.c_str(); });
    choice_or_scenes(desk, "New material", choice.material, materials.size(),
                     "Material of the standing and rolling layers.",
                     [&](std::size_t i) { return materials[i].title.c_str(); });
    choice_or_scenes(
        desk, "New model", choice.model, kModels.size(),
        "bcre-inertial computes the velocity of the flow; bcre takes its speed from a law; voellmy "
        "has forces, but neither erosion nor deposits.",
        [&](std::size_t i) { return kModelNames[i]; });
    choice_or_scenes(desk, "New grid", choice.grid, kGrids.size(),
                     "Squares along the longer side; more squares are finer and slower.",
                     [&](std::size_t i) { return kGridNames[i]; });
    if (desk.widgets.button("Start", "Starts this scene; the current session stays in its recording.", true,
                            ImGui::GetContentRegionAvail().x))
        actions.emplace_back(begin_of(choice, facts));
}

// Keeps the world as it stands as a scene of the user's own.
void save_world(Desk& desk, const Facts& facts, Actions& actions) {
    const char* const obstacle =
        facts.scenario.flow  ? "A flow demo has no world to save."
        : facts.looks_back() ? "Only the present can be saved. Go there, or continue from here, first."
                             : nullptr;
    desk.widgets.heading("A world of your own");
    ImGui::BeginDisabled(obstacle != nullptr);
    desk.widgets.text_field("Name of this world", tr(facts.scenario.title.c_str()), desk.name_of_world,
                            ImGui::GetContentRegionAvail().x);
    if (desk.widgets.button(
            "Save this world",
            obstacle ? obstacle
                     : "Keeps the mountain as it stands now as a scene of your own: layers, forest, "
                       "earth and what is built.",
            false, ImGui::GetContentRegionAvail().x))
        actions.emplace_back(SaveWorld{std::exchange(desk.name_of_world, {}).data()});
    ImGui::EndDisabled();
}

void hints(Desk& desk, const Facts& facts, Actions& actions) {
    if (facts.guide && desk.widgets.button("Show hints again", "Leads through the first steps once more."))
        actions.emplace_back(GuideWish{GuideWish::kAgain});
}

// What happens after a slide was shared.
void sharing(Desk& desk, const Facts& facts, Actions& actions) {
    Display display = facts.display;
    if (desk.widgets.toggle("Open shared", display.shows_shared,
                            "Shows the folder of a shared slide in the file manager of the desktop."))
        actions.emplace_back(SetDisplay{display});
}

}  // namespace

void scene_panel(Desk& desk, const Facts& facts, Actions& actions) {
    desk.widgets.plain("%s", tr(facts.scenario.title.c_str()));
    if (desk.widgets.button("Other scenes", "Shows all scenes, challenges and recordings in the menu.", true,
                            ImGui::GetContentRegionAvail().x))
        actions.emplace_back(Verb::kMenu);
    hints(desk, facts, actions);
    save_world(desk, facts, actions);
    best_runs_of_challenge(desk, facts, actions);
    what_is_loaded(desk, facts);
    what_to_begin(desk, facts, actions);
    sharing(desk, facts, actions);
    ImGui::Dummy({0, desk.em() * 0.2f});
    desk.widgets.dim("You can also drop a scene, a terrain file or a recording onto the window.");
}

}  // namespace game::ui
