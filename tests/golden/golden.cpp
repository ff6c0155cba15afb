#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>

#include <gtest/gtest.h>

#include "sim/engine.h"
#include "sim/world/state_hash.h"
#include "tests/golden/scenes.h"

// Known hashes of small scenes, for every compiler, optimisation level, instruction set, number of threads,
// kernel, tile size and tile sleep. tests/bits builds this with sim compiled in every way.

namespace {

using golden::kTicks;
using golden::Scene;
using sim::Model;
using sim::Scheme;
using sim::StepOptions;

struct Physics {
    const char* name;
    Model model;
    Scheme scheme;
};
constexpr Physics kPhysics[] = {{"lax-friedrichs", Model::kBcre, Scheme::kLaxFriedrichs},
                                {"local-lax-friedrichs", Model::kBcre, Scheme::kLocalLaxFriedrichs},
                                {"muscl", Model::kBcre, Scheme::kMuscl},
                                {"bcre-inertial", Model::kBcreInertial, Scheme::kLocalLaxFriedrichs},
                                {"voellmy", Model::kVoellmy, Scheme::kLocalLaxFriedrichs}};

// By scene, then as in kPhysics. A changed hash means changed physics.
constexpr std::array<std::array<std::uint64_t, 5>, 7> kHashes{{
    {0x026954590f475107, 0x8bdcbb479b2712bf, 0xf1d54f3ae2978a2c, 0x219a1963cd968cd4, 0xebaf127343a0fe48},
    {0x73a8cb299f766dae, 0x8077d936a06d1f27, 0x46a6da35d9fddc11, 0x4e1ec63558ed72a4, 0xb147f599b0b2737b},
    {0xbf0a4e823a96db1a, 0x83fcb21bdb8fadcb, 0x417b9e3346a00838, 0x62c3018411e7ed38, 0xd96ac46f0eaeb992},
    {0xa4744843dc0012a6, 0x0212aebd73d256f6, 0xa87b51b94f6cf98f, 0x3dfc18c59e14625d, 0x30c23276d69a4875},
    {0xdbc4152e503c1dca, 0x9c47921a856735b8, 0x5d172726c4a8f5e8, 0x77b446c8f8f6aa6d, 0xedcd739c5c638236},
    {0x53bcb5e8ffd27043, 0xf1b36d9144f2811e, 0x2ca08198d0018eaa, 0x10052c09b52d1a7e, 0x3eab5a91083e0557},
    {0x90674323ef7502f0, 0xdc3aeb77140d6224, 0x5a0f27ceaf48dfcf, 0xb04204a78b2faea9, 0x7aaf75ed61fc1d20},
}};

std::uint64_t hash_after(const Scene& scene, const Physics& physics, const StepOptions& options) {
    sim::Params params = scene.params;
    params.model = physics.model;
    params.scheme = physics.scheme;
    support::Play play(scene.ground, params, options);
    for (int tick = 0; tick < kTicks; ++tick) {
        std::vector<sim::Command> commands;
        for (const auto& [at, command] : scene.hand)
            if (at == tick) commands.push_back(command);
        play.ticks(1, commands);
    }
    EXPECT_EQ(play.state.ledger.mass_error(), 0) << scene.name;
    return sim::state_hash(play.state);
}

// All options; in unoptimised builds, where each takes minutes, not the tiles and most thread counts.
std::vector<StepOptions> ways() {
#ifdef __OPTIMIZE__
    constexpr bool kAll = true;
#else
    constexpr bool kAll = false;
#endif
    const std::vector<int> thread_counts = kAll ? std::vector{1, 2, 3, 5, 8} : std::vector{1, 3};
    std::vector<StepOptions> all;
    for (const int threads : thread_counts) all.push_back({.threads = threads, .plain = true});
    for (const auto set : sim::kInstructionSets)
        if (sim::has(set))
            for (const int threads : thread_counts)
                all.push_back({.threads = threads, .instruction_set = set});
    if (!kAll) return all;
    for (const auto& [width, height] :
         {std::pair(32, 1), std::pair(32, 7), std::pair(64, 16), std::pair(256, 256)})
        for (const bool may_sleep : {true, false})
            all.push_back(
                {.threads = 2, .tile_width = width, .tile_height = height, .tiles_may_sleep = may_sleep});
    return all;
}

std::string name_of(const StepOptions& options) {
    return std::string(options.plain ? "plain" : sim::to_string(options.instruction_set)) + ", threads " +
           std::to_string(options.threads) + ", tiles " + std::to_string(options.tile_width) + " by " +
           std::to_string(options.tile_height) + (options.tiles_may_sleep ? "" : ", awake");
}

class Golden : public testing::TestWithParam<std::size_t> {};

TEST_P(Golden, scene_has_its_hash_for_all_step_options) {
    const Scene scene = golden::scenes().at(GetParam());
    for (std::size_t i = 0; i < std::size(kPhysics); ++i) {
        const std::uint64_t known = kHashes.at(GetParam()).at(i);
        for (const StepOptions& options : ways()) {
            if (scene.ground.lower && !options.plain) continue;  // two materials use the plain step
            std::array<char, 32> text{};
            const std::uint64_t hash = hash_after(scene, kPhysics[i], options);
            std::snprintf(text.data(), text.size(), "0x%016" PRIx64, hash);
            ASSERT_EQ(hash, known) << scene.name << ", " << kPhysics[i].name << ", " << name_of(options)
                                   << ": " << text.data();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::Range<std::size_t>(0, 7), [](const auto& of) {
    std::string name(golden::scenes()[of.param].name);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

TEST(GoldenScenes, all_differ_and_all_move) {
    for (const Scene& scene : golden::scenes())
        for (const Physics& physics : kPhysics) {
            sim::Params params = scene.params;
            params.model = physics.model;
            params.scheme = physics.scheme;
            support::Play play(scene.ground, params);
            const std::uint64_t before = sim::state_hash(play.state);
            EXPECT_NE(hash_after(scene, physics, {}), before) << scene.name << ", " << physics.name;
        }
}

}  // namespace
