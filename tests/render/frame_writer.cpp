#include "render/frame_writer.h"

#include <fstream>

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
    const support::TemporaryFolder folder;
    const Picture picture = picture_of(33, 17, 5);
    ASSERT_TRUE(write_png(picture, folder.path() / "a.png"));
    EXPECT_EQ(read_png(folder.path() / "a.png"), picture.pixels);
    const std::filesystem::directory_iterator files(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(FrameWriter, writes_every_frame_when_the_queue_is_full) {
    const support::TemporaryFolder folder;
    FrameWriter writer(2);
    for (int i = 0; i < 12; ++i)
        writer.submit(picture_of(64, 40, i), folder.path() / (std::to_string(i) + ".png"));
    const auto finished = writer.finish();
    ASSERT_TRUE(finished) << finished.error();
    for (int i = 0; i < 12; ++i)
        EXPECT_EQ(read_png(folder.path() / (std::to_string(i) + ".png")), picture_of(64, 40, i).pixels) << i;
}

TEST(FrameWriter, writes_queued_frames_when_destroyed) {
    const support::TemporaryFolder folder;
    {
        FrameWriter writer(8);
        for (int i = 0; i < 4; ++i)
            writer.submit(picture_of(8, 8, i), folder.path() / (std::to_string(i) + ".png"));
    }
    EXPECT_EQ(read_png(folder.path() / "3.png"), picture_of(8, 8, 3).pixels);
}

TEST(FrameWriter, names_the_first_file_that_cannot_be_written_and_does_not_hang) {
    const support::TemporaryFolder folder;
    std::ofstream(folder.path() / "no_folder") << "a file where a folder should be";
    FrameWriter writer(1);
    for (int i = 0; i < 6; ++i)
        writer.submit(picture_of(8, 8, i), folder.path() / "no_folder" / (std::to_string(i) + ".png"));
    const auto finished = writer.finish();
    ASSERT_FALSE(finished);
    EXPECT_NE(finished.error().find("no_folder/0.png: cannot be written"), std::string::npos)
        << finished.error();
}

}  // namespace
}  // namespace render
