#include "render/pictures/frame_writer.h"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace render {
namespace {

Picture picture_of(int width, int height, int seed) {
    Picture picture{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i)
        picture.pixels.push_back(static_cast<std::uint8_t>(i * 7 + seed * 31));
    return picture;
}

std::vector<std::uint8_t> read_png(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) return {};
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(input->spec().image_pixels()) * 3);
    input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data());
    return pixels;
}

TEST(Picture, survives_a_png_round_trip_and_leaves_no_other_file) {
    for (const PngCompression& compression :
         {kFramePngCompression, kFastPngCompression, kSmallestPngCompression}) {
        const support::TemporaryFolder folder;
        const Picture picture = picture_of(33, 17, 5);
        ASSERT_TRUE(write_png(picture, folder.path() / "a.png", compression));
        EXPECT_EQ(read_png(folder.path() / "a.png"), picture.pixels) << compression.level;
        const std::filesystem::directory_iterator files(folder.path());
        EXPECT_EQ(std::distance(begin(files), end(files)), 1);
    }
}

std::size_t bytes_of(const Picture& picture, const PngCompression& compression) {
    const support::TemporaryFolder folder;
    EXPECT_TRUE(write_png(picture, folder.path() / "a.png", compression));
    return file_size(folder.path() / "a.png");
}

// Each compression has its reason (render/pictures/picture.h). They fail if OpenImageIO ignores what it is asked for.
TEST(Picture, is_smallest_with_the_smallest_compression) {
    Picture noisy_slope = picture_of(64, 48, 0);
    for (std::size_t i = 0; i < noisy_slope.pixels.size(); ++i)
        noisy_slope.pixels[i] = static_cast<std::uint8_t>(i / 64 + (i * i * 2654435761u >> 16) % 4);
    EXPECT_LE(bytes_of(noisy_slope, kSmallestPngCompression), bytes_of(noisy_slope, kFastPngCompression));
    EXPECT_LE(bytes_of(noisy_slope, kFramePngCompression), noisy_slope.pixels.size() / 2);
}

TEST(Picture, is_smaller_with_repetitions_unless_it_is_a_frame) {
    const Picture plain{64, 64, std::vector<std::uint8_t>(3 * 64 * 64, 200)};
    EXPECT_LT(2 * bytes_of(plain, kFastPngCompression), bytes_of(plain, kFramePngCompression));
}

class FrameWriterOf : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(workers, FrameWriterOf, testing::Values(1, 2, 8));

TEST_P(FrameWriterOf, writes_every_frame_when_the_queue_is_full) {
    const support::TemporaryFolder folder;
    FrameWriter writer(2, GetParam());
    for (int i = 0; i < 24; ++i)
        writer.submit(picture_of(64, 40, i), folder.path() / (std::to_string(i) + ".png"));
    const auto finished = writer.finish();
    ASSERT_TRUE(finished) << finished.error();
    for (int i = 0; i < 24; ++i)
        EXPECT_EQ(read_png(folder.path() / (std::to_string(i) + ".png")), picture_of(64, 40, i).pixels) << i;
}

TEST_P(FrameWriterOf, writes_queued_frames_when_destroyed) {
    const support::TemporaryFolder folder;
    {
        FrameWriter writer(8, GetParam());
        for (int i = 0; i < 4; ++i)
            writer.submit(picture_of(8, 8, i), folder.path() / (std::to_string(i) + ".png"));
    }
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(read_png(folder.path() / (std::to_string(i) + ".png")), picture_of(8, 8, i).pixels) << i;
}

TEST_P(FrameWriterOf, names_the_first_file_that_cannot_be_written_and_does_not_hang) {
    const support::TemporaryFolder folder;
    std::ofstream(folder.path() / "no_folder") << "a file where a folder should be";
    FrameWriter writer(1, GetParam());
    for (int i = 0; i < 20; ++i)
        writer.submit(picture_of(8, 8, i), folder.path() / "no_folder" / (std::to_string(i) + ".png"));
    const auto finished = writer.finish();
    ASSERT_FALSE(finished);
    EXPECT_NE(finished.error().find("no_folder/0.png: cannot be written"), std::string::npos)
        << finished.error();
}

// A large image takes longer to encode than a small one, so that with two workers the later error comes first.
TEST_P(FrameWriterOf, reports_the_error_of_the_frame_that_was_submitted_first) {
    const support::TemporaryFolder folder;
    for (const char* name : {"large.png", "small.png"})
        std::filesystem::create_symlink("/dev/full", folder.path() / name);
    FrameWriter writer(2, GetParam());
    writer.submit(picture_of(800, 600, 1), folder.path() / "large.png");
    writer.submit(picture_of(8, 8, 2), folder.path() / "small.png");
    const auto finished = writer.finish();
    ASSERT_FALSE(finished);
    EXPECT_NE(finished.error().find("large.png: cannot be written"), std::string::npos) << finished.error();
}

TEST(FrameWriter, writes_nothing_after_the_disk_is_full) {
    const support::TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder.path() / "full.png");
    FrameWriter writer(4, 1);
    writer.submit(picture_of(8, 8, 0), folder.path() / "full.png");
    for (int i = 0; i < 6; ++i)
        writer.submit(picture_of(8, 8, i), folder.path() / (std::to_string(i) + ".png"));
    EXPECT_FALSE(writer.finish());
    const std::filesystem::directory_iterator files(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);  // the link
}

// A FIFO that nobody reads holds each worker up.
TEST_P(FrameWriterOf, lets_no_more_images_wait_than_its_capacity) {
    constexpr int kCapacity = 3;
    const int held = GetParam() + kCapacity;
    const support::TemporaryFolder folder;
    const auto path = [&](int i) { return folder.path() / (std::to_string(i) + ".png"); };
    for (int i = 0; i < held + 2; ++i) ASSERT_EQ(mkfifo(path(i).c_str(), 0600), 0);

    std::atomic<int> submitted = 0;
    std::thread submitter([&] {
        FrameWriter writer(kCapacity, GetParam());
        for (int i = 0; i < held + 2; ++i, ++submitted) writer.submit(picture_of(8, 8, i), path(i));
    });
    while (submitted < held) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(submitted, held);
    for (int i = 0; i < held + 2; ++i) EXPECT_GT(std::ifstream(path(i)).get(), 0);
    submitter.join();
    EXPECT_EQ(submitted, held + 2);
}

TEST(FrameWriter, leaves_a_core_for_drawing_and_has_at_least_one_worker) {
    const int workers = FrameWriter::suitable_workers();
    EXPECT_GE(workers, 1);
    EXPECT_LE(workers, FrameWriter::kMostWorkers);
    EXPECT_LE(workers, std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1));
}

}  // namespace
}  // namespace render
