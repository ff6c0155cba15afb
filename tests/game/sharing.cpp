#include "game/app/sharing.h"

#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

#include "game/files/text_file.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

class SharedSlide : public testing::Test {
  protected:
    SharedSlide() { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }

    fs::path shared() const { return folder_.path() / "couloir/shared"; }
    std::vector<fs::path> all_shared() const {
        std::vector<fs::path> all;
        if (!fs::exists(shared())) return all;
        for (const auto& entry : fs::recursive_directory_iterator(shared())) all.push_back(entry.path());
        return all;
    }

    static Outcome<Sharing::Shared> wait_for(Sharing& sharing) {
        while (true)
            if (auto result = sharing.result()) return std::move(*result);
    }

    support::TemporaryFolder folder_;
};

Outcome<PageReport> write_a_page(const fs::path& recording, const fs::path& page, const PageOptions& options,
                                 const std::atomic<bool>*, std::atomic<float>*) {
    if (auto written = write_text(
            page, read_bytes(recording) + " seen from " + std::to_string(options.camera->distance_m));
        !written)
        return tl::unexpected(written.error());
    return PageReport{123, 4};
}

// Works until it is stopped.
Outcome<PageReport> write_for_ever(const fs::path& recording, const fs::path&, const PageOptions&,
                                   const std::atomic<bool>* stop, std::atomic<float>* progress) {
    EXPECT_TRUE(fs::exists(recording));
    *progress = 0.25f;
    while (!*stop) std::this_thread::yield();
    return machine_fails("stopped");
}

TEST_F(SharedSlide, is_a_page_and_a_recording_side_by_side) {
    Sharing sharing(write_a_page);
    for (const char* name : {"a", "a-2"}) {
        ASSERT_TRUE(sharing.begin("lines", "a", {.camera = render::Camera{.distance_m = 7}}));
        const auto result = wait_for(sharing);
        ASSERT_TRUE(result) << result.error().sentence;
        EXPECT_EQ(result->folder, shared() / name);
        EXPECT_EQ(result->page.bytes, 123u);
        EXPECT_EQ(read_bytes(shared() / name / "slide.couloir"), "lines");
        EXPECT_EQ(read_bytes(shared() / name / "slide.html").rfind("lines seen from 7", 0), 0u);
        EXPECT_FALSE(sharing.progress());
        EXPECT_FALSE(sharing.result()) << "once";
    }
}

TEST_F(SharedSlide, leaves_nothing_if_it_is_stopped) {
    {
        Sharing sharing(write_for_ever);
        EXPECT_FALSE(sharing.progress());
        ASSERT_TRUE(sharing.begin("lines", "a", {}));
        while (sharing.progress() != 0.25) EXPECT_FALSE(sharing.result());
    }
    EXPECT_TRUE(fs::is_empty(shared()));
}

TEST_F(SharedSlide, leaves_nothing_if_its_page_cannot_be_written) {
    Sharing refused([](const auto&, const auto& page, const auto&, auto*, auto*) -> Outcome<PageReport> {
        return machine_fails(page.string() + ": cannot be written");
    });
    ASSERT_TRUE(refused.begin("lines", "a", {}));
    EXPECT_EQ(wait_for(refused).error().sentence,
              (shared() / "a/slide.html").string() + ": cannot be written");
    EXPECT_TRUE(all_shared().empty());
    Sharing without_memory([](const auto&, const auto&, const auto&, auto*, auto*) -> Outcome<PageReport> {
        throw std::bad_alloc();
    });
    ASSERT_TRUE(without_memory.begin("lines", "a", {}));
    EXPECT_EQ(wait_for(without_memory).error().status, Failure::kMachine);
    EXPECT_TRUE(all_shared().empty());
}

TEST_F(SharedSlide, says_that_its_folder_cannot_be_made) {
    write_bytes(folder_.path() / "couloir", "a file");
    Sharing sharing(write_a_page);
    ASSERT_TRUE(sharing.begin("lines", "a", {}));
    const auto result = wait_for(sharing);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().status, Failure::kMachine);
    EXPECT_NE(result.error().sentence.find(shared().string()), std::string::npos) << result.error().sentence;
}

}  // namespace
}  // namespace game::test
