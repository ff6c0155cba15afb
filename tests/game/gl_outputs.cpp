// The image folders that subcommands draw with OpenGL; tests/game/outputs.cpp has the other outputs.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/game/subcommands.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_below(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder).string());
    return names;
}

TEST(DrawnOutputs, in_a_folder_never_replace_an_input) {
    const support::TemporaryFolder in, out;
    for (const Subcommand& each : writing_subcommands(in.path()))
        for (const std::string& option : each.only_refused ? std::vector<std::string>() : each.drawn) {
            const fs::path made = out.path() / "made", again = out.path() / "again";
            const auto draw = [&](const fs::path& folder) {
                auto call = each.with({{option, folder}}, in.path());
                call.insert(call.end(), {"--size", "64x64"});
                return couloir(call);
            };
            ASSERT_EQ(draw(made).status, 0) << each.name << " " << option;
            const fs::path& input = each.inputs.front();
            const std::string before = read_bytes(input);
            for (const std::string& name : names_below(made)) {
                fs::create_directories((again / name).parent_path());
                fs::create_symlink(input, again / name);
                const Finished finished = draw(again);
                EXPECT_EQ(finished.status, 2) << each.name << " " << option << " " << name << finished.err;
                EXPECT_EQ(read_bytes(input), before);
                EXPECT_EQ(std::distance(fs::recursive_directory_iterator(again), {}),
                          name.find('/') == std::string::npos ? 1 : 2);
                fs::remove_all(again);
            }
            fs::remove_all(made);
        }
}

// Of a simulation; `track` counts the frames of its input instead, and an export has none.
TEST(DrawnOutputs, come_every_so_many_ticks_as_the_option_says) {
    const support::TemporaryFolder in, out;
    std::size_t tried = 0;
    for (const Subcommand& each : writing_subcommands(in.path()))
        for (const std::string& option : each.drawn) {
            if (option != "--frames") continue;
            ++tried;
            auto call = each.with({{option, out.path() / "made"}}, in.path());
            call.insert(call.end(), {"--size", "64x64", "--every", "6"});
            const Finished finished = couloir(call);
            ASSERT_EQ(finished.status, 0) << finished.err;
            std::size_t frames = 0;
            for (const std::string& name : names_below(out.path() / "made"))
                frames += name.find("tick_") != std::string::npos;
            EXPECT_EQ(frames, 4u) << each.name << " " << option << ": 18 ticks, and the first state";
            fs::remove_all(out.path() / "made");
        }
    EXPECT_GE(tried, 5u);
}

TEST(DrawnOutputs, that_do_not_fit_the_disk_leave_no_half_picture) {
    const support::TemporaryFolder in, out;
    for (const Subcommand& each : writing_subcommands(in.path()))
        for (const std::string& option : each.only_refused ? std::vector<std::string>() : each.drawn)
            for (const rlim_t limit : {300u, 1500u}) {  // enough for the error message
                const fs::path made = out.path() / "made";
                auto call = each.with({{option, made}}, in.path());
                call.insert(call.end(), {"--size", "128x128"});
                const Finished full = couloir(call, {.out = "/dev/null", .limits = {{RLIMIT_FSIZE, limit}}});
                EXPECT_EQ(full.status, 3) << each.name << " " << option << full.err;
                EXPECT_NE(full.err.find(": cannot be written: "), std::string::npos) << full.err;
                for (const std::string& name : names_below(made)) {
                    EXPECT_EQ(name.find(".part"), std::string::npos) << name;
                    EXPECT_GT(fs::file_size(made / name), 0u) << name;
                    if (name.ends_with(".png")) {
                        EXPECT_EQ(read_bytes(made / name).substr(read_bytes(made / name).size() - 8, 4),
                                  "IEND");
                    }
                }
                fs::remove_all(made);
            }
}

}  // namespace
}  // namespace game::test
