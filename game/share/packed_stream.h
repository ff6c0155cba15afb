#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/recording/format.h"

namespace game {

// How the numbers of an array become bytes. docs/web.md has the format.
struct Packing {
    enum class Predict {
        kNone,   // each number by itself
        kLast,   // as the difference from the one before
        kPlane,  // from the plane through its western, southern and south-western neighbours
    };
    double least_step = 0;  // > 0; a quantum is larger if the numbers do not fit otherwise
    int planes = 2;         // bytes of a number, 1 to 4
    Predict predict = Predict::kLast;
};

// The data of a page: named parts, one after another, compressed as they come. Parts of the same name continue each
// other. Equal parts give equal bytes.
class PackedStream {
  public:
    PackedStream();
    ~PackedStream();
    PackedStream(PackedStream&&) noexcept;
    PackedStream& operator=(PackedStream&&) noexcept;

    void add(std::string_view name, std::span<const std::uint8_t> bytes);
    void add(std::string_view name, std::string_view text);
    // Adds numbers, all finite, as whole quanta from the least of them on. Returns the quantum, whose half is the
    // largest error. `width`: of a row, for kPlane.
    double add(std::string_view name, std::span<const double> numbers, const Packing& packing, int width = 0);
    // Adds whole numbers as they are: value = zero + step · number. 0 ≤ number < 2^(8 planes).
    void add(std::string_view name, std::span<const std::uint32_t> numbers, double zero, double step,
             int planes, Packing::Predict predict, int width = 0);

    // Until now, bytes. What was added last may not be part of it.
    std::size_t compressed() const;
    std::size_t plain() const { return plain_; }
    // Ends the stream: a gzip file.
    std::string finish();

    const Json& parts() const { return parts_; }    // [[name, bytes], …]
    const Json& arrays() const { return arrays_; }  // by name

  private:
    struct Deflate;
    std::unique_ptr<Deflate> deflate_;
    std::size_t plain_ = 0;
    Json parts_ = Json::array(), arrays_ = Json::object();
};

// A whole number with its sign in its lowest bit, so that small numbers of either sign have few bits. Both are numbers
// modulo 2^(8 planes).
constexpr std::uint32_t zigzag(std::uint32_t difference, int planes) {
    const auto shift = static_cast<unsigned>(32 - 8 * planes);
    const auto whole = static_cast<std::int32_t>(difference << shift) >> shift;
    return static_cast<std::uint32_t>(whole) << 1 ^ static_cast<std::uint32_t>(whole >> 31);
}

}  // namespace game
