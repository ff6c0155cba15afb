#include "game/scene/memory.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/files/assets.h"
#include "game/recording/recording_file.h"
#include "game/scene/scene.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/readers/work.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

using ::test::work;

Scenario even_ground(int side, bool two_materials) {
    Scenario scenario = small_scenario();
    scenario.grid = {side, side, 2.f};
    const std::size_t vertices = scenario.grid.size();
    scenario.bedrock.assign(vertices, 0.f), scenario.depth.assign(vertices, 1.f);
    scenario.rolling.assign(vertices, 0.f), scenario.has_data.assign(vertices, 1);
    if (two_materials)
        scenario.lower =
            Scenario::Lower{"soil", scenario.params, std::vector<float>(vertices, 0.5f), {}, {}, {}};
    return scenario;
}

// Plays six ticks, which need no state line.
void write_recording(const std::filesystem::path& path, int side, bool two_materials,
                     bool has_things = false) {
    Header header;
    header.scenario = even_ground(side, two_materials);
    if (has_things) header.scenario.standing.forest.assign(header.scenario.grid.size(), {400, 0, 30, 22});
    write_bytes(path, chained({body_of(to_json(header)), "{\"end\":6"}));
}

TEST(Memory, is_read_from_the_text_of_an_option) {
    EXPECT_EQ(bytes_from("1"), 1u);
    EXPECT_EQ(bytes_from("3K"), 3u << 10);
    EXPECT_EQ(bytes_from("512M"), 512u << 20);
    EXPECT_EQ(bytes_from("4G"), std::uint64_t{4} << 30);
    EXPECT_EQ(bytes_from("2T"), std::uint64_t{2} << 40);
    for (const char* wrong : {"", "0", "-1", "M", "1.5G", "4 G", "4GB", "4g", "0x10", "99999999999999999999",
                              "18446744073709551615K", "nan"})
        EXPECT_FALSE(bytes_from(wrong)) << wrong;
}

TEST(Memory, for_a_vast_ground_in_a_small_recording_is_refused_before_allocation) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "vast.couloir";
    write_recording(path, 4097, false);
    ASSERT_LT(std::filesystem::file_size(path), 40'000u);
    Memory memory;
    memory.most = std::uint64_t{1} << 30;
    const auto before = work();
    const auto refused = read_recording(path, memory);
    const auto taken = work() - before;
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Failure::kUnusable);
    EXPECT_LT(taken.bytes, 1 << 20);
}

TEST(Memory, for_a_fine_grid_is_refused_before_allocation) {
    Overrides overrides;
    overrides.squares = 4096;
    overrides.memory.most = std::uint64_t{1} << 30;
    for (const char* scene : {"landslide", "snow-avalanche", "alpine-valley"}) {
        const auto before = work();
        const auto refused = load_scene(scene, overrides);
        ASSERT_FALSE(refused) << scene;
        EXPECT_EQ(refused.error().status, Failure::kUnusable);
        EXPECT_LT((work() - before).bytes, 1 << 20) << scene;
    }
}

TEST(Memory, is_an_option_of_every_subcommand_that_builds_a_world) {
    const support::TemporaryFolder folder;
    const std::string out = (folder.path() / "out.couloir").string();
    const std::vector<std::vector<std::string>> commands{
        {"play", "alpine-valley"},
        {"play", "landslide.couloir"},
        {"run", "landslide", "--seconds", "1"},
        {"replay", "landslide"},
        {"compare", "landslide", "landslide-bcre"},
        {"edit", "landslide", "--tick", "60", "--delete", "--out", out},
        {"normalise", "landslide", "--out", out},
        {"bench", "landslide", "--ticks", "10", "--no-render"}};
    for (std::vector<std::string> arguments : commands) {
        arguments.insert(arguments.end(), {"--max-memory", "20M"});
        EXPECT_EQ(couloir(arguments).status, 2) << arguments[0];
    }
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Memory, that_is_too_little_for_the_images_is_refused_with_both_figures) {
    const support::TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const std::vector<std::vector<std::string>> commands{
        {"play", "alpine-valley"},
        {"play", "landslide.couloir"},
        {"run", "landslide", "--grid", "64", "--seconds", "0", "--frames", out},
        {"run", "flow-disc", "--seconds", "0", "--frames", out},
        {"replay", "landslide", "--frames", out},
        {"bench", "landslide", "--ticks", "1"}};
    for (std::vector<std::string> arguments : commands) {
        arguments.insert(arguments.end(), {"--size", "8192x8192", "--max-memory", "3G"});
        const Finished refused = couloir(arguments);
        EXPECT_EQ(refused.status, 2) << arguments[0] << refused.err;
        const auto first = refused.err.find(" GiB"), second = refused.err.find(" 3.0 GiB");
        EXPECT_LT(first, second) << refused.err;
        EXPECT_NE(second, std::string::npos) << refused.err;
    }
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Memory, is_checked_for_every_scene_and_recording) {
    for (const AssetKind kind : {AssetKind::kScene, AssetKind::kRecording}) {
        const std::vector<std::string> names = asset_names(kind).value();
        for (const std::string& name : names) {
            const bool scene = kind == AssetKind::kScene;
            std::vector<std::string> arguments{scene ? "run" : "replay", name, "--max-memory", "1M"};
            if (scene) arguments.insert(arguments.end(), {"--seconds", "0"});
            const Finished refused = couloir(arguments);
            EXPECT_EQ(refused.status, 2) << name;
            EXPECT_NE(refused.err.find("1.0 MiB"), std::string::npos) << refused.err;
        }
    }
    const Finished flow =
        couloir({"run", "flow-disc", "--grid", "512", "--seconds", "0", "--max-memory", "1M"});
    EXPECT_EQ(flow.status, 2) << flow.err;
}

struct Use {
    const char* name;
    std::vector<std::string> before, after;  // of the recording
    WorldUse use;
};

TEST(Memory, estimate_is_at_least_the_measured_peak) {
    const support::TemporaryFolder folder;
    const std::vector<Use> uses{
        {"replay", {"replay"}, {}, {}},
        {"paranoid", {"replay", "--paranoid"}, {}, {.runs = 2}},
        {"compare", {"compare"}, {}, {.sessions = 2, .runs = 2}},
    };
    constexpr int kSide = 901;
    struct World {
        const char* name;
        bool two_materials, has_things;
    };
    for (const World& world :
         {World{"one", false, false}, World{"two", true, false}, World{"forest", false, true}}) {
        const std::string path = (folder.path() / fmt::format("{}.couloir", world.name)).string();
        write_recording(path, kSide, world.two_materials, world.has_things);
        for (const Use& each : uses) {
            std::vector<std::string> arguments = each.before;
            arguments.push_back(path);
            if (each.before[0] == "compare") arguments.push_back(path);
            Memory memory;
            memory.use = each.use;
            const std::uint64_t expected =
                expected_bytes({kSide, kSide, 2.f}, world.two_materials, memory, world.has_things);
            const auto [status, taken] = peak_of(arguments);
            EXPECT_EQ(status, 0) << arguments[0];
            RecordProperty(fmt::format("{}_{}", each.name, world.name),
                           bytes_text(expected) + " " + bytes_text(taken));
            EXPECT_LE(taken, expected) << each.name << " " << world.name;
            EXPECT_LE(expected, 3 * taken) << each.name << " " << world.name;
        }
    }
}

}  // namespace
}  // namespace game::test
