#include "game/ensemble/exceedances.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include "xxhash.h"

#include "game/analysis/measures.h"
#include "game/recording/format.h"
#include "sim/core/check.h"

namespace game {
namespace {

constexpr std::string_view kMagic = "couloir exceedances 1\n";
constexpr std::size_t kDigits = 16;  // of the identity, and of the hash at the end
constexpr std::size_t kHead = kMagic.size() + kDigits + 8;

// Appends a whole number, the lowest byte first.
template <class Number>
void put(Number number, std::string& bytes) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
}

template <class Number>
Number got(std::string_view bytes, std::size_t at) {
    Number number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        number |=
            static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(bytes[at + i])) << (8 * i));
    return number;
}

}  // namespace

Exceedances::Exceedances(const Scenario& scenario, std::vector<Threshold> thresholds)
    : scenario_(scenario),
      thresholds_(std::move(thresholds)),
      counts_(thresholds_.size() * scenario.grid.size()) {
    CHECK(thresholds_.size() <= 16);
}

Exceedances::Passed Exceedances::passed(const Peaks& peaks) const {
    Passed passed(scenario_.grid.size());
    const bool needs_thickness = std::ranges::any_of(
        thresholds_, [](const Threshold& each) { return each.of == Threshold::Of::kThickness; });
    const std::vector<float> thickness =
        needs_thickness ? peak_thickness_of(scenario_, peaks) : std::vector<float>();
    for (std::size_t t = 0; t < thresholds_.size(); ++t) {
        const Threshold& threshold = thresholds_[t];
        const std::vector<float>& field = threshold.of == Threshold::Of::kThickness ? thickness
                                          : threshold.of == Threshold::Of::kSpeed   ? peaks.speed_slope
                                                                                    : peaks.pressure;
        const auto bit = static_cast<std::uint16_t>(1u << t);
        for (std::size_t i = 0; i < passed.size(); ++i)
            if (static_cast<double>(field[i]) >= threshold.least)
                passed[i] = static_cast<std::uint16_t>(passed[i] | bit);
    }
    return passed;
}

void Exceedances::add(std::int64_t member, const Passed& passed) {
    CHECK(!has(member) && passed.size() == scenario_.grid.size());
    if (member >= std::ssize(done_)) done_.resize(index(member) + 1);
    done_[index(member)] = 1;
    ++members_;
    for (std::size_t i = 0; i < passed.size(); ++i) {
        if (passed[i] == 0) continue;
        for (std::size_t t = 0; t < thresholds_.size(); ++t)
            counts_[t * passed.size() + i] += (passed[i] >> t) & 1u;
    }
}

std::vector<float> Exceedances::probability(std::size_t threshold) const {
    const std::size_t size = scenario_.grid.size();
    std::vector<float> share(size, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < size; ++i)
        if (scenario_.has_data.empty() || scenario_.has_data[i] != 0)
            share[i] = members_ == 0 ? 0
                                     : static_cast<float>(static_cast<double>(counts_[threshold * size + i]) /
                                                          static_cast<double>(members_));
    return share;
}

std::uintmax_t Exceedances::most_bytes() const {
    return kHead + static_cast<std::uintmax_t>(EnsembleSpec::kMostMembers) + 1 + 4 * counts_.size() + kDigits;
}

std::string Exceedances::bytes(const std::string& identity) const {
    CHECK(identity.size() == kDigits);
    std::string bytes(kMagic);
    bytes += identity;
    put(static_cast<std::uint64_t>(done_.size()), bytes);
    bytes.append(done_.begin(), done_.end());
    for (const std::uint32_t count : counts_) put(count, bytes);
    return bytes + hex(XXH3_64bits(bytes.data(), bytes.size()));
}

tl::expected<void, std::string> Exceedances::take(std::string_view bytes, const std::string& identity) {
    if (bytes.size() < kHead + kDigits || bytes.substr(0, kMagic.size()) != kMagic)
        return tl::unexpected(std::string("has no counts of members"));
    const std::string_view body = bytes.substr(0, bytes.size() - kDigits);
    if (hex(XXH3_64bits(body.data(), body.size())) != bytes.substr(body.size()))
        return tl::unexpected(std::string("is damaged: its hash differs"));
    if (bytes.substr(kMagic.size(), kDigits) != identity)
        return tl::unexpected(std::string("is of another ensemble, ground or version of the physics"));
    const auto many = got<std::uint64_t>(bytes, kMagic.size() + kDigits);
    if (many > static_cast<std::uint64_t>(EnsembleSpec::kMostMembers) + 1 ||
        body.size() != kHead + many + 4 * counts_.size())
        return tl::unexpected(fmt::format("has {} bytes, which do not fit its grid and maps", bytes.size()));
    done_.assign(bytes.begin() + kHead, bytes.begin() + kHead + static_cast<std::ptrdiff_t>(many));
    members_ = std::ranges::count(done_, 1);
    for (std::size_t i = 0; i < counts_.size(); ++i)
        counts_[i] = got<std::uint32_t>(bytes, kHead + many + 4 * i);
    return {};
}

}  // namespace game
