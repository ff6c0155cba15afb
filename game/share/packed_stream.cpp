#include "game/share/packed_stream.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sim/core/check.h"

namespace game {

struct PackedStream::Deflate {
    z_stream stream{};
    std::string bytes;

    Deflate() {
        // Level 9 takes seven times as long as 7, for a page that is 4 % smaller.
        constexpr int kGzip = 15 + 16, kLevel = 7, kMemory = 8;
        const int begun = deflateInit2(&stream, kLevel, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY);
        CHECK(begun == Z_OK);
    }
    ~Deflate() { deflateEnd(&stream); }
    Deflate(const Deflate&) = delete;
    Deflate& operator=(const Deflate&) = delete;

    void run(std::span<const std::uint8_t> plain, int flush) {
        std::array<Bytef, 1 << 16> buffer;
        stream.next_in = const_cast<Bytef*>(plain.data());  // zlib reads it only
        stream.avail_in = static_cast<uInt>(plain.size());
        do {
            stream.next_out = buffer.data();
            stream.avail_out = static_cast<uInt>(buffer.size());
            deflate(&stream, flush);
            bytes.append(buffer.begin(), buffer.end() - static_cast<std::ptrdiff_t>(stream.avail_out));
        } while (stream.avail_out == 0);
    }
};

PackedStream::PackedStream() : deflate_(std::make_unique<Deflate>()) {}
PackedStream::~PackedStream() = default;
PackedStream::PackedStream(PackedStream&&) noexcept = default;
PackedStream& PackedStream::operator=(PackedStream&&) noexcept = default;

void PackedStream::add(std::string_view name, std::span<const std::uint8_t> bytes) {
    parts_.push_back({name, bytes.size()});
    plain_ += bytes.size();
    constexpr std::size_t kMost = std::size_t{1} << 30;  // that zlib takes at once
    for (; bytes.size() > kMost; bytes = bytes.subspan(kMost)) deflate_->run(bytes.first(kMost), Z_NO_FLUSH);
    deflate_->run(bytes, Z_NO_FLUSH);
}

void PackedStream::add(std::string_view name, std::string_view text) {
    add(name, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

double PackedStream::add(std::string_view name, std::span<const double> numbers, const Packing& packing,
                         int width) {
    if (numbers.empty()) return packing.least_step;
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    const double zero = *least, largest = std::ldexp(1.0, 8 * packing.planes) - 1;
    const double step = std::max(packing.least_step, (*most - zero) / largest);
    std::vector<std::uint32_t> whole;
    whole.reserve(numbers.size());
    for (const double number : numbers)
        whole.push_back(
            static_cast<std::uint32_t>(std::min(std::floor((number - zero) / step + 0.5), largest)));
    add(name, whole, zero, step, packing.planes, packing.predict, width);
    return step;
}

void PackedStream::add(std::string_view name, std::span<const std::uint32_t> numbers, double zero,
                       double step, int planes, Packing::Predict predict, int width) {
    CHECK(planes >= 1 && planes <= 4 && (predict != Packing::Predict::kPlane || width > 0));
    const auto w = static_cast<std::size_t>(width);
    std::vector<std::vector<std::uint8_t>> bytes(static_cast<std::size_t>(planes));
    for (auto& plane : bytes) plane.reserve(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::uint32_t expected = 0;
        switch (predict) {
            case Packing::Predict::kNone:
                break;
            case Packing::Predict::kLast:
                if (i > 0) expected = numbers[i - 1];
                break;
            case Packing::Predict::kPlane: {
                const bool west = i % w > 0, south = i >= w;
                expected = (west ? numbers[i - 1] : 0) + (south ? numbers[i - w] : 0) -
                           (west && south ? numbers[i - w - 1] : 0);
                break;
            }
        }
        std::uint32_t rest = zigzag(numbers[i] - expected, planes);
        for (auto& plane : bytes) {
            plane.push_back(static_cast<std::uint8_t>(rest));
            rest >>= 8;
        }
    }
    constexpr std::array kNames{"none", "last", "plane"};
    Json size = predict == Packing::Predict::kPlane ? Json{width, numbers.size() / w} : Json{numbers.size()};
    arrays_[std::string(name)] = {{"size", std::move(size)},
                                  {"planes", planes},
                                  {"predict", kNames[static_cast<std::size_t>(predict)]},
                                  {"zero", zero},
                                  {"step", step}};
    for (std::size_t plane = 0; plane < bytes.size(); ++plane)
        add(fmt::format("{}.{}", name, plane), bytes[plane]);
}

std::size_t PackedStream::compressed() const {
    return deflate_->bytes.size();
}

std::string PackedStream::finish() {
    deflate_->run({}, Z_FINISH);
    return std::move(deflate_->bytes);
}

}  // namespace game
