#include "tests/game/ui_hand.h"

namespace game::test {

UiHand::UiHand() {
    const support::Ground ground = support::plane(20, 5, 0.6, 2);
    scenario_.scene = "valley";
    scenario_.title = "A valley";
    scenario_.material = "snow-dry";
    scenario_.terrain = "plane";
    scenario_.licence = "CC0";
    scenario_.grid = ground.grid;
    scenario_.params = support::lively(sim::Model::kBcreInertial);
    state_ = sim::make_state(ground.world(), scenario_.params);
    catalogue_.scenes = {{"slope", "A slope", "/scenes/slope.toml"},
                         {"valley", "A valley", "/scenes/valley.toml"}};
    catalogue_.materials = {{"sand", "dry sand", "/materials/sand.toml"},
                            {"snow-dry", "loose dry snow", "/materials/snow-dry.toml"}};
    catalogue_.recordings = {{"slope", "A slope that slid", "/recordings/slope.couloir"}};
    times_.add({{1, 2, 3, 4, 5}, 16, 2, 1});
    begin_anew({1280, 720, 1});
}

void UiHand::begin_anew(ScreenSize size, const std::optional<std::filesystem::path>& font) {
    ui_.reset();  // ImGui has one context
    screen_.resize(size);
    ui_.emplace(font);
    settle();
}

ui::Facts UiHand::facts() const {
    return {.scenario = scenario_,
            .state = state_,
            .clock = clock_,
            .brush = brush_,
            .deed = deed_of(brush_.tool, modifiers_),
            .touched = touched_,
            .goal_use = goal_use_,
            .card = card_ ? &*card_ : nullptr,
            .section = section_,
            .history = history_,
            .slide_labels = slide_labels_,
            .compass = compass_,
            .lesson = lesson_,
            .lesson_marks = lesson_marks_,
            .best_runs = best_runs_,
            .actions_to_undo = actions_to_undo_,
            .actions_to_redo = actions_to_redo_,
            .under_cursor = under_cursor_,
            .camera_mode = camera_mode_,
            .display = display_,
            .times = times_,
            .notices = notices_,
            .catalogue = catalogue_,
            .keys = {screen_.layout(), keys_},
            .timeline = timeline_,
            .recording = recording_,
            .renderer = "scripted",
            .languages = languages_.choices(),
            .now_s = screen_.seconds(),
            .sharing = sharing_,
            .filming = filming_,
            .path = path_,
            .photo = photo_};
}

Actions UiHand::frame() {
    Actions actions;
    screen_.pass(1.0 / 60);
    ui_->begin(screen_.poll(), screen_, display_.letters, 1.0 / 60);
    ui_->build(facts(), actions);
    return actions;
}

void UiHand::settle(int frames) {
    for (int i = 0; i < frames; ++i) EXPECT_TRUE(frame().empty());
}

ui::Ui::Place UiHand::place(std::string_view label) {
    const auto found = ui_->find(label);
    EXPECT_TRUE(found) << "'" << label << "' is not to be seen";
    return found.value_or(ui::Ui::Place{});
}

void UiHand::point_at(std::string_view label) {
    const auto at = place(label);
    screen_.move(at.x + at.width / 2, at.y + at.height / 2);
}

Actions UiHand::click(std::string_view label) {
    point_at(label);
    Actions all;
    const auto go_on = [&] {
        for (const Action& action : frame()) all.push_back(action);
    };
    go_on();
    screen_.press(Button::kLeft);
    go_on();
    screen_.release(Button::kLeft);
    for (int i = 0; i < 3; ++i) go_on();
    return all;
}

Actions UiHand::type_into(std::string_view label, std::string_view text) {
    Actions all = click(label);
    screen_.type(text);
    screen_.tap(Key::kEnter);
    for (int i = 0; i < 4; ++i)
        for (const Action& action : frame()) all.push_back(action);
    return all;
}

}  // namespace game::test
