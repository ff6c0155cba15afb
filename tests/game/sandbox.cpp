#include "game/session/sandbox.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "game/controls/catalogue.h"
#include "game/files/recordings_folder.h"
#include "game/recording/recording_file.h"
#include "tests/game/full_disk.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

sim::Command pour_here(const Scenario& scenario, double rate) {
    sim::Command pour;
    pour.x = 0.5 * scenario.grid.nx * static_cast<double>(scenario.grid.dx);
    pour.y = 0.7 * scenario.grid.ny * static_cast<double>(scenario.grid.dx);
    pour.radius = 5;
    pour.rate = rate;
    return pour;
}

LoadedWorld small_opening() {
    LoadedWorld loaded;
    loaded.scene.scenario = small_scenario();
    loaded.scene.commands = {{12, pour_here(loaded.scene.scenario, 300)},
                             {40, pour_here(loaded.scene.scenario, 100)}};
    return loaded;
}

Sandbox recorded(const std::filesystem::path& path) {
    LoadedWorld loaded = small_opening();
    auto recorder = record_into(path, loaded.scene.scenario);
    return Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::move(*recorder)).value();
}

void run(Sandbox& sandbox, int ticks) {
    for (int i = 0; i < ticks; ++i) ASSERT_TRUE(sandbox.tick({}));
}

void stroke(Sandbox& sandbox, const char* name, int ticks) {
    sandbox.begin_action(name);
    const sim::Command pour = pour_here(sandbox.scenario(), 500);
    for (int i = 0; i < ticks; ++i) ASSERT_TRUE(sandbox.tick({&pour, 1}));
}

// The hash at the end of a recording played again without a window, proven on the way.
std::uint64_t replayed_hash(const std::filesystem::path& path) {
    const Recording recording = read_recording(path).value();
    LoadedWorld loaded;
    loaded.scene = {recording.header.scenario, recording.commands};
    loaded.watched = recording;
    Sandbox sandbox = Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::nullopt).value();
    while (sandbox.looks_back()) EXPECT_TRUE(sandbox.tick({}));
    EXPECT_FALSE(sandbox.verdict()->parted) << *sandbox.verdict()->parted;
    EXPECT_EQ(sandbox.verdict()->proven_tick, recording.last_tick());
    return sandbox.session().state_line().hash;
}

TEST(Sandbox, takes_back_the_last_action_to_the_bit_in_the_world_and_in_the_file) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "hand.couloir";
    Sandbox sandbox = recorded(path);
    run(sandbox, 20);
    stroke(sandbox, "pour", 30);
    run(sandbox, 7);
    const StateLine before = sandbox.session().state_line();
    const Peaks peaks = sandbox.session().peaks();
    stroke(sandbox, "pour again", 25);
    run(sandbox, 31);
    ASSERT_NE(sandbox.session().state_line().hash, before.hash);

    EXPECT_EQ(sandbox.undo().value(), "pour again");
    EXPECT_EQ(sandbox.session().state_line(), before);
    EXPECT_EQ(sandbox.session().peaks().depth, peaks.depth);
    EXPECT_EQ(sandbox.actions(), 1u);

    // The file goes on as if the action had never been, what the scene had in store included.
    run(sandbox, 50);
    ASSERT_TRUE(sandbox.finish());
    const Recording recording = read_recording(path).value();
    EXPECT_FALSE(recording.warning);
    EXPECT_EQ(recording.commands.size(), 2u + 30u);
    EXPECT_EQ(replayed_hash(path), sandbox.session().state_line().hash);
}

TEST(Sandbox, plays_on_from_an_undo_to_the_bits_it_would_have_had) {
    Sandbox straight = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    Sandbox bent = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    run(straight, 80);
    run(bent, 10);
    stroke(bent, "pour", 40);  // over both ticks at which the scene pours
    ASSERT_TRUE(bent.undo());
    run(bent, 70);
    EXPECT_EQ(bent.session().state_line(), straight.session().state_line());
}

void go_to_present(Sandbox& sandbox) {
    ASSERT_TRUE(sandbox.go_toward(sandbox.known_until(), [] { return true; }).value());
}

TEST(Sandbox, redoes_what_was_undone_to_the_bit_in_the_world_and_in_the_file) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "hand.couloir";
    Sandbox sandbox = recorded(path);
    run(sandbox, 20);
    stroke(sandbox, "pour", 30);
    run(sandbox, 7);
    stroke(sandbox, "pour again", 25);
    run(sandbox, 31);
    const StateLine after = sandbox.session().state_line();
    const Peaks peaks = sandbox.session().peaks();

    ASSERT_TRUE(sandbox.undo());
    run(sandbox, 11);  // time that goes on is not something else done
    ASSERT_TRUE(sandbox.undo());
    EXPECT_EQ(sandbox.undone(), 2u);
    EXPECT_EQ(sandbox.redo().value(), "pour");
    go_to_present(sandbox);
    EXPECT_EQ(sandbox.redo().value(), "pour again");
    EXPECT_EQ(sandbox.known_until(), after.tick);
    go_to_present(sandbox);
    EXPECT_EQ(sandbox.session().state_line(), after);
    EXPECT_EQ(sandbox.session().peaks().depth, peaks.depth);
    EXPECT_EQ(sandbox.actions(), 2u);
    EXPECT_EQ(sandbox.undone(), 0u);

    ASSERT_TRUE(sandbox.finish());
    const Recording recording = read_recording(path).value();
    EXPECT_FALSE(recording.warning);
    EXPECT_EQ(recording.commands.size(), 2u + 30u + 25u);
    EXPECT_EQ(replayed_hash(path), after.hash);
}

TEST(Sandbox, undoes_and_redoes_on_the_way_to_what_is_redone) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "hand.couloir";
    Sandbox sandbox = recorded(path);
    run(sandbox, 20);
    const StateLine first = sandbox.session().state_line();
    stroke(sandbox, "pour", 30);
    run(sandbox, 7);
    stroke(sandbox, "pour again", 25);
    const StateLine after = sandbox.session().state_line();
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(sandbox.undo());

    for (int i = 0; i < 2; ++i) ASSERT_TRUE(sandbox.redo());  // no tick between them
    EXPECT_EQ(sandbox.session().state().tick, first.tick);
    run(sandbox, 5);
    EXPECT_EQ(sandbox.undo().value(), "pour again");
    EXPECT_EQ(sandbox.undo().value(), "pour");
    EXPECT_EQ(sandbox.session().state_line(), first);
    EXPECT_FALSE(sandbox.looks_back());
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(sandbox.redo());
    go_to_present(sandbox);
    EXPECT_EQ(sandbox.session().state_line(), after);
    ASSERT_TRUE(sandbox.finish());
    EXPECT_EQ(replayed_hash(path), after.hash);
}

TEST(Sandbox, undoes_and_redoes_in_a_branch_what_was_done_before_it) {
    const support::TemporaryFolder folder;
    const auto first = folder.path() / "first.couloir", second = folder.path() / "second.couloir";
    Sandbox sandbox = recorded(first);
    run(sandbox, 20);
    const StateLine start = sandbox.session().state_line();
    stroke(sandbox, "pour", 30);
    run(sandbox, 7);
    const StateLine between = sandbox.session().state_line();
    stroke(sandbox, "pour again", 25);
    run(sandbox, 5);
    stroke(sandbox, "later", 5);
    ASSERT_TRUE(sandbox.go_toward(70, [] { return true; }).value());
    ASSERT_TRUE(sandbox.take_over(into_file(second)));
    const StateLine branch = sandbox.session().state_line();
    EXPECT_EQ(sandbox.actions(), 2u);  // the third is in the first recording alone

    EXPECT_EQ(sandbox.undo().value(), "pour again");
    EXPECT_EQ(sandbox.session().state_line(), between);
    EXPECT_EQ(sandbox.undo().value(), "pour");
    EXPECT_EQ(sandbox.session().state_line(), start);
    EXPECT_EQ(read_recording(second).value().header.parent, (Parent{"first", start.tick}));
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(sandbox.redo());
    go_to_present(sandbox);
    EXPECT_EQ(sandbox.session().state_line(), branch);
    stroke(sandbox, "dig", 9);
    ASSERT_TRUE(sandbox.undo());
    EXPECT_EQ(sandbox.session().state_line(), branch);
    run(sandbox, 20);
    ASSERT_TRUE(sandbox.finish());
    EXPECT_EQ(replayed_hash(second), sandbox.session().state_line().hash);
    EXPECT_EQ(read_recording(first).value().commands.size(), 2u + 30u + 25u + 5u);
}

TEST(Sandbox, redoes_in_a_branch_what_was_undone_before_it) {
    const support::TemporaryFolder folder;
    Sandbox sandbox = recorded(folder.path() / "first.couloir");
    run(sandbox, 20);
    stroke(sandbox, "pour", 30);
    run(sandbox, 7);
    const StateLine after = sandbox.session().state_line();
    ASSERT_TRUE(sandbox.undo());
    run(sandbox, 15);
    ASSERT_TRUE(sandbox.go_toward(10, [] { return true; }).value());
    const auto second = folder.path() / "second.couloir";
    ASSERT_TRUE(sandbox.take_over(into_file(second)));
    EXPECT_EQ(sandbox.redo().value(), "pour");  // what it begins with is still to come
    go_to_present(sandbox);
    EXPECT_EQ(sandbox.session().state_line(), after);
    ASSERT_TRUE(sandbox.finish());
    EXPECT_EQ(replayed_hash(second), after.hash);
}

TEST(Sandbox, redoes_nothing_once_something_else_was_done) {
    Sandbox sandbox = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    EXPECT_EQ(sandbox.redo().error().sentence, "Nothing to redo");
    stroke(sandbox, "pour", 3);
    ASSERT_TRUE(sandbox.undo());
    stroke(sandbox, "dig", 3);
    EXPECT_EQ(sandbox.undone(), 0u);
    EXPECT_FALSE(sandbox.redo());
    ASSERT_TRUE(sandbox.undo());
    ASSERT_TRUE(sandbox.go_toward(0, [] { return true; }));
    run(sandbox, 9);
    ASSERT_TRUE(sandbox.go_toward(4, [] { return true; }));
    EXPECT_FALSE(sandbox.redo());  // in the past
    EXPECT_EQ(sandbox.undone(), 1u);
}

TEST(CommandSource, gathers_in_order_and_within_the_limits_of_a_tick) {
    const Scenario scenario = small_scenario();
    sim::State state = sim::make_state(initial_state_of(scenario), scenario.params);
    const std::vector<TimedCommand> known{
        {0, pour_here(scenario, 1)}, {0, pour_here(scenario, 2)}, {1, pour_here(scenario, 3)}};
    CommandSource source;
    const auto due = source.due(state, known);
    ASSERT_EQ(due.size(), 2u);
    EXPECT_EQ(due[1].rate, 2);
    source.add_new(std::vector<sim::Command>(300, pour_here(scenario, 4)));
    ASSERT_EQ(source.commands().size(), sim::kMostCommandsPerTick);
    EXPECT_EQ(source.commands()[2].rate, 4);
    EXPECT_TRUE(check_tick(state, source.commands()));
    EXPECT_TRUE(source.due(state, {}).empty());
}

TEST(CommandSource, leaves_out_what_clashes_and_keeps_what_was_there_before) {
    const Scenario scenario = small_scenario();
    const sim::State state = sim::make_state(initial_state_of(scenario), scenario.params);
    const auto set = [](const char* name, double value) {
        sim::Command command;
        command.kind = sim::CommandKind::kSet;
        command.param = sim::param_from(name).value();
        command.value = value;
        return command;
    };
    CommandSource source;
    const std::vector<TimedCommand> known{{0, set("exchange_rate", 3)}};
    source.due(state, known);
    EXPECT_TRUE(source.leave_out_clashing());
    const std::vector<sim::Command> hand{set("friction", 1.5), pour_here(scenario, 1)};
    source.add_new(hand);
    EXPECT_FALSE(source.leave_out_clashing());
    ASSERT_EQ(source.commands().size(), 2u);
    EXPECT_EQ(source.commands()[0].kind, sim::CommandKind::kSet);
    EXPECT_EQ(source.commands()[1].kind, sim::CommandKind::kPour);
    EXPECT_FALSE(check_tick(state, hand));
}

TEST(Session, knows_when_its_fields_changed_last) {
    LoadedWorld loaded = small_opening();
    loaded.scene.scenario.params.start_slope = 9;  // nothing starts by itself
    loaded.scene.scenario.rolling.assign(loaded.scene.scenario.grid.size(), 0.f);
    loaded.scene.commands = {{300, pour_here(loaded.scene.scenario, 200)}};
    Sandbox sandbox = Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::nullopt).value();
    const Session& session = sandbox.session();
    int still = 0;
    for (int i = 0; i < 400; ++i) {
        const sim::State before = session.state();
        ASSERT_TRUE(sandbox.tick({}));
        const sim::State& after = session.state();
        bool same = true;
        for (int y = 0; y < before.grid.ny; ++y)
            for (int x = 0; x < before.grid.nx; ++x)
                same &= before.depth(x, y) == after.depth(x, y) &&
                        before.rolling(x, y) == after.rolling(x, y) &&
                        before.velocity_x(x, y) == after.velocity_x(x, y);
        ASSERT_TRUE(same || session.changed_at() == after.tick) << after.tick;
        still += session.changed_at() < after.tick ? 1 : 0;
    }
    EXPECT_GT(still, 10);
    EXPECT_GT(session.changed_at(), 300);
}

TEST(Sandbox, undoes_a_number_that_was_set) {
    Sandbox sandbox = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    const float usual = sandbox.session().state().params.exchange_rate;
    sim::Command set;
    set.kind = sim::CommandKind::kSet;
    set.param = sim::param_from("exchange_rate").value();
    set.value = 7;
    sandbox.begin_action("set exchange_rate");
    ASSERT_TRUE(sandbox.tick({&set, 1}));
    ASSERT_EQ(sandbox.session().state().params.exchange_rate, 7.f);
    ASSERT_TRUE(sandbox.undo());
    EXPECT_EQ(sandbox.session().state().params.exchange_rate, usual);
}

TEST(Sandbox, leaves_out_numbers_that_do_not_go_together_and_time_goes_on) {
    Sandbox sandbox = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    run(sandbox, 3);
    const StateLine before = sandbox.session().state_line();
    sim::Command set;
    set.kind = sim::CommandKind::kSet;
    set.param = sim::param_from("friction").value();
    set.value = 1.5;
    const auto refused = sandbox.tick({&set, 1});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence.find("friction is above friction_thin"), std::string::npos);
    EXPECT_EQ(sandbox.session().state().params, sandbox.scenario().params);
    EXPECT_EQ(sandbox.session().state().tick, before.tick + 1);
    EXPECT_EQ(sandbox.actions(), 0u);
}

TEST(Sandbox, does_not_stick_where_what_is_in_store_clashes_with_what_a_person_has_set) {
    const auto set = [](const char* param, double value) {
        sim::Command command;
        command.kind = sim::CommandKind::kSet;
        command.param = sim::param_from(param).value();
        command.value = value;
        return command;
    };
    LoadedWorld loaded = small_opening();
    loaded.scene.commands = {{5, set("friction_thin", 0.4)}, {5, pour_here(loaded.scene.scenario, 100)}};
    Sandbox sandbox = Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::nullopt).value();
    const sim::Command own[] = {set("start_slope", 0.9), set("friction", 0.5)};
    ASSERT_TRUE(sandbox.tick(own));
    run(sandbox, 4);
    const auto clash = sandbox.tick({});
    ASSERT_FALSE(clash);
    EXPECT_NE(clash.error().sentence.find("friction is above friction_thin"), std::string::npos);
    EXPECT_EQ(sandbox.session().state().tick, 6);
    EXPECT_EQ(sandbox.session().state().params.start_slope, 0.9f);
    EXPECT_GT(sandbox.session().state().ledger.poured, 0);
}

TEST(Sandbox, has_nothing_to_undo_where_an_action_gave_no_command) {
    Sandbox sandbox = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    sandbox.begin_action("pour");
    run(sandbox, 5);
    EXPECT_EQ(sandbox.actions(), 0u);
    const auto undone = sandbox.undo();
    ASSERT_FALSE(undone);
    EXPECT_EQ(undone.error().sentence, "Nothing to undo");
    EXPECT_EQ(sandbox.session().state().tick, 5);
}

TEST(Sandbox, lets_a_person_take_over_a_recording_at_its_end_and_records_the_whole) {
    const support::TemporaryFolder folder;
    const auto first = folder.path() / "first.couloir", second = folder.path() / "second.couloir";
    Sandbox before = recorded(first);
    stroke(before, "pour", 45);
    ASSERT_TRUE(before.finish());

    LoadedWorld loaded;
    Recording recording = read_recording(first).value();
    loaded.scene = {recording.header.scenario, recording.commands};
    loaded.name = "first";
    loaded.watched = std::move(recording);
    Sandbox after = Sandbox::begin(std::move(loaded), sim::StepOptions{}, std::nullopt).value();
    EXPECT_EQ(after.known_until(), 45);
    while (after.looks_back()) ASSERT_TRUE(after.tick({}));
    EXPECT_EQ(after.session().state_line().hash, before.session().state_line().hash);
    EXPECT_EQ(after.verdict()->proven_tick, 45);
    ASSERT_TRUE(after.take_over(into_file(second)));
    stroke(after, "pour", 10);
    ASSERT_TRUE(after.finish());
    EXPECT_EQ(read_recording(second).value().last_tick(), 55);
    EXPECT_EQ(read_recording(second).value().header.parent, (Parent{"first", 45}));
    EXPECT_EQ(replayed_hash(second), after.session().state_line().hash);
}

// The recording that a copy holds; written, because a copy must be a whole file.
Recording read_copy(const Sandbox& sandbox, const std::filesystem::path& path) {
    write_bytes(path, sandbox.recorded_so_far().value());
    Recording recording = read_recording(path).value();
    EXPECT_FALSE(recording.warning) << *recording.warning;
    return recording;
}

TEST(Sandbox, copies_its_recording_as_if_it_ended_now_and_goes_on_with_it) {
    const support::TemporaryFolder folder;
    const auto own = folder.path() / "own.couloir", copy = folder.path() / "copy.couloir";
    Sandbox sandbox = recorded(own);
    EXPECT_EQ(read_copy(sandbox, copy).last_tick(), 0);
    run(sandbox, 15);
    stroke(sandbox, "pour", 7);
    const auto before = read_bytes(own);
    EXPECT_EQ(read_copy(sandbox, copy).last_tick(), 22);
    EXPECT_EQ(replayed_hash(copy), sandbox.session().state_line().hash);
    EXPECT_EQ(read_bytes(own), before) << "the recording itself has not changed";
    ASSERT_TRUE(sandbox.undo());
    EXPECT_EQ(read_copy(sandbox, copy).last_tick(), 15);
    run(sandbox, 30);
    const auto hash = sandbox.session().state_line().hash;
    ASSERT_TRUE(sandbox.go_toward(9, [] { return true; }));
    EXPECT_EQ(read_copy(sandbox, copy).last_tick(), 45) << "what is known, also if the past is shown";
    EXPECT_EQ(replayed_hash(copy), hash);
    ASSERT_TRUE(sandbox.go_toward(45, [] { return true; }));
    ASSERT_TRUE(sandbox.finish());
    EXPECT_EQ(read_bytes(own), read_bytes(copy));
}

TEST(Sandbox, copies_a_watched_recording_as_it_is) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "own.couloir";
    Sandbox own = recorded(path);
    run(own, 20);
    ASSERT_TRUE(own.finish());
    Sandbox watching = Sandbox::begin(open_anything(path.string(), {}).value(), {}, std::nullopt).value();
    run(watching, 5);
    EXPECT_EQ(watched_text(watching.opening()).value(), read_bytes(path));
}

TEST(Sandbox, says_why_there_is_no_recording_to_copy) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "own.couloir";
    const Sandbox unrecorded = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    EXPECT_EQ(unrecorded.recorded_so_far().error().status, Failure::kUnusable);
    Sandbox sandbox = recorded(path);
    run(sandbox, 10);
    std::filesystem::resize_file(path, 100);
    EXPECT_NE(sandbox.recorded_so_far().error().sentence.find(path.string()), std::string::npos);
    std::filesystem::remove(path);
    EXPECT_NE(sandbox.recorded_so_far().error().sentence.find(path.string()), std::string::npos);
    Sandbox into_device = recorded("/dev/null");
    EXPECT_FALSE(into_device.recorded_so_far());
}

TEST(Sandbox, says_that_the_disk_is_full_and_plays_on_without_a_recording) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "full.couloir";
    Sandbox sandbox = recorded(path),
            unrecorded = Sandbox::begin(small_opening(), sim::StepOptions{}, std::nullopt).value();
    const sim::Command pour = pour_here(sandbox.scenario(), 500);
    const FullDisk full(std::filesystem::file_size(path) + 1000);
    int refused = 0;
    for (int i = 0; i < 40; ++i) {
        if (const auto done = sandbox.tick({&pour, 1}); !done) {
            ++refused;
            EXPECT_EQ(done.error().status, Failure::kMachine);
            EXPECT_NE(done.error().sentence.find(path.string()), std::string::npos);
        }
        ASSERT_TRUE(unrecorded.tick({&pour, 1}));
    }
    EXPECT_EQ(refused, 1);
    EXPECT_EQ(sandbox.session().recorder(), nullptr);
    EXPECT_EQ(sandbox.session().state_line(), unrecorded.session().state_line());
    EXPECT_TRUE(read_recording(path));  // what was whole by then is still there
}

TEST(Recordings, of_ones_own_are_offered_the_newest_first) {
    const support::TemporaryFolder folder;
    ASSERT_EQ(setenv("XDG_DATA_HOME", folder.path().c_str(), 1), 0);
    EXPECT_TRUE(own_entries(ShelfKind::kRecording).empty());  // no such folder yet
    std::filesystem::create_directories(folder.path() / "couloir/recordings");
    for (const char* name :
         {"2026-01-02_a.couloir", "2026-01-03_a.couloir", "2025-12-31_a.couloir", "note.txt"})
        std::ofstream(folder.path() / "couloir/recordings" / name) << "x";
    const auto own = own_entries(ShelfKind::kRecording);
    ASSERT_EQ(own.size(), 3u);
    EXPECT_EQ(own[0].name, "2026-01-03_a");
    EXPECT_EQ(own[2].name, "2025-12-31_a");
}

TEST(Recordings, of_windows_that_begin_at_once_have_names_of_their_own) {
    constexpr int kWindows = 4, kSessions = 25;
    const support::TemporaryFolder folder;
    ASSERT_EQ(setenv("XDG_DATA_HOME", folder.path().c_str(), 1), 0);
    const Scenario scenario = small_scenario();
    std::vector<std::vector<std::filesystem::path>> files(kWindows);
    std::vector<std::thread> windows;
    for (auto& own : files)
        windows.emplace_back([&] {
            for (int i = 0; i < kSessions; ++i) {
                own.push_back(next_recording("slope").value());
                auto recorder = record_into(own.back(), scenario);
                if (!recorder || !recorder->end(0)) own.back().clear();
            }
        });
    for (std::thread& window : windows) window.join();
    std::set<std::filesystem::path> all;
    for (const auto& own : files) all.insert(own.begin(), own.end());
    EXPECT_EQ(all.size(), std::size_t{kWindows} * kSessions);
    for (const auto& file : all) EXPECT_TRUE(read_recording(file)) << file;
}

TEST(Recordings, are_named_by_time_and_scene_and_never_replace_one_another) {
    const support::TemporaryFolder folder;
    ASSERT_EQ(setenv("XDG_DATA_HOME", folder.path().c_str(), 1), 0);
    const auto first = next_recording("my hill/2.tif").value();
    EXPECT_EQ(first.parent_path(), folder.path() / "couloir/recordings");
    EXPECT_NE(first.filename().string().find("_my-hill-2-tif.couloir"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(first));  // taken: the next finds another name
    EXPECT_NE(next_recording("my hill/2.tif").value(), first);
    ASSERT_EQ(setenv("XDG_DATA_HOME", "relative", 1), 0);
    ASSERT_EQ(setenv("HOME", "/nobody", 1), 0);
    EXPECT_EQ(recordings_folder().value(), "/nobody/.local/share/couloir/recordings");
}

}  // namespace
}  // namespace game::test
