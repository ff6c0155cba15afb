// What a page packs, unpacked by other code.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/share/packed_motion.h"
#include "game/share/packed_stream.h"
#include "tests/game/unpacked_page.h"

namespace game::test {
namespace {

UnpackedPage unpacked(PackedStream& stream) {
    const std::string plain = unzipped(stream.finish());
    return {stream.parts(), stream.arrays(), plain};
}

TEST(PackedStream, brings_numbers_back_within_half_a_quantum) {
    std::mt19937 random(36);
    using enum Packing::Predict;
    for (const Packing::Predict predict : {kNone, kLast, kPlane})
        for (int planes = 1; planes <= 4; ++planes)
            for (const double range : {0.0, 1e-3, 3.0, 4000.0}) {
                constexpr int kWidth = 7;
                std::vector<double> numbers(5 * kWidth);
                std::uniform_real_distribution<double> any(-range, range);
                for (double& number : numbers) number = any(random) + 100;
                PackedStream stream;
                const double step = stream.add("numbers", numbers, {0.01, planes, predict}, kWidth);
                EXPECT_GE(step, 0.01);
                EXPECT_LE(step, std::max(0.01, 2 * range / (std::ldexp(1.0, 8 * planes) - 1)) * 1.0001);
                const std::vector<double> back = unpacked(stream).array("numbers");
                ASSERT_EQ(back.size(), numbers.size());
                for (std::size_t i = 0; i < back.size(); ++i)
                    EXPECT_NEAR(back[i], numbers[i], 0.5001 * step) << planes << " planes, number " << i;
            }
}

TEST(PackedStream, brings_whole_numbers_back_exactly) {
    std::mt19937 random(37);
    using enum Packing::Predict;
    for (const Packing::Predict predict : {kNone, kLast, kPlane})
        for (int planes = 1; planes <= 4; ++planes) {
            const std::uint32_t most = planes == 4 ? ~0u : (1u << 8 * planes) - 1;
            std::vector<std::uint32_t> numbers{0, most, 0, most, most / 2, most / 2 + 1};
            for (int i = 0; i < 30; ++i) numbers.push_back(static_cast<std::uint32_t>(random()) & most);
            PackedStream stream;
            stream.add("whole", numbers, 0, 1, planes, predict, 6);
            const std::vector<double> back = unpacked(stream).array("whole");
            EXPECT_TRUE(std::equal(back.begin(), back.end(), numbers.begin(), numbers.end(),
                                   [](double a, std::uint32_t b) { return a == static_cast<double>(b); }))
                << planes;
        }
}

TEST(PackedStream, continues_parts_of_the_same_name) {
    PackedStream stream;
    stream.add("one", "abc");
    stream.add("two", "12");
    stream.add("one", "");
    stream.add("one", "def");
    EXPECT_EQ(stream.plain(), 8u);
    const UnpackedPage page = unpacked(stream);
    EXPECT_EQ(page.part("one"), "abcdef");
    EXPECT_EQ(page.part("two"), "12");
}

TEST(PackedStream, is_the_same_bytes_each_time) {
    const auto bytes = [] {
        PackedStream stream;
        stream.add("text", std::string(100000, 'x'));
        stream.add("numbers", std::vector<double>{1, 2, 3}, {});
        return stream.finish();
    };
    EXPECT_EQ(bytes(), bytes());
}

// Grids of whole and of broken tiles; values that jump, stay, and go back.
TEST(PackedMotion, brings_every_frame_back) {
    std::mt19937 random(38);
    for (const auto& [nx, ny] : {std::pair(8, 8), std::pair(9, 17), std::pair(21, 3), std::pair(40, 33)}) {
        PackedMotion motion("d", nx, ny, 0.01);
        const std::size_t size = static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny);
        std::vector<float> now(size);
        std::uniform_real_distribution<float> depth(0, 655);
        for (float& value : now) value = depth(random);
        ASSERT_TRUE(motion.begin_with(now));
        std::vector<std::uint16_t> first;
        for (const std::uint32_t q : motion.quanta()) first.push_back(static_cast<std::uint16_t>(q));
        PackedStream stream;
        std::vector<std::vector<float>> frames;
        for (int frame = 0; frame < 20; ++frame) {
            if (frame % 5 != 0)  // else nothing changes
                for (std::size_t n = 0; n < 1 + size / 16; ++n) now[random() % size] = depth(random);
            frames.push_back(now);
            ASSERT_TRUE(motion.add(now));
            if (frame % 7 == 6) motion.flush(stream);
        }
        motion.flush(stream);
        const UnpackedPage page = unpacked(stream);
        for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            const auto back = page.moving("d", nx, ny, static_cast<std::int64_t>(frame), first);
            for (std::size_t i = 0; i < size; ++i)
                ASSERT_NEAR(back[i] * 0.01, static_cast<double>(frames[frame][i]), motion.most_error())
                    << frame << ' ' << i;
        }
    }
}

TEST(PackedMotion, costs_nothing_but_its_map_where_nothing_changes) {
    PackedMotion motion("s", 160, 160, 0.125);
    PackedStream stream;
    const std::vector<float> still(160 * 160);
    for (int frame = 0; frame < 10; ++frame) ASSERT_TRUE(motion.add(still));
    motion.flush(stream);
    EXPECT_EQ(stream.plain(), 10u * 50u);
}

TEST(PackedMotion, refuses_what_it_could_not_bring_back) {
    for (const float wrong : {656.f, -0.1f, std::nanf(""), INFINITY}) {
        PackedMotion motion("d", 3, 3, 0.01);
        std::vector<float> values(9, 1.f);
        values[4] = wrong;
        const auto added = motion.add(values);
        ASSERT_FALSE(added) << wrong;
        EXPECT_NE(added.error().find("a page keeps 0 to 655"), std::string::npos) << added.error();
        EXPECT_FALSE(motion.begin_with(values));
    }
}

}  // namespace
}  // namespace game::test
