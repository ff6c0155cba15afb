#include "game/ensemble/vertex_counts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include "xxhash.h"

#include "game/analysis/measures.h"
#include "game/ensemble/bytes.h"
#include "game/recording/format.h"
#include "sim/core/check.h"

namespace game {
namespace {

constexpr std::string_view kCountsMagic = "couloir ensemble counts 2\n";
constexpr std::size_t kHashDigits = 16;  // of the identity, and of the hash at the end

// A bin has all values with the same binary exponent and the same four binary digits after the first: a sixteenth of an
// octave. The first bin has all below.
constexpr int kDigitsDropped = 19;  // of the 23 of a float
constexpr float kLeastBinned = 0x1p-10f;
constexpr std::uint16_t kBins = 1 + 16 * 31;  // up to 2²¹
constexpr std::uint16_t kNoBin = 0xffff;

std::uint32_t leading_bits(float value) {
    return std::bit_cast<std::uint32_t>(value) >> kDigitsDropped;
}
std::uint16_t bin_of(float value) {
    if (!(value >= kLeastBinned)) return 0;
    return static_cast<std::uint16_t>(
        std::min(leading_bits(value) - leading_bits(kLeastBinned) + 1, kBins - 1u));
}
// The least value of a bin.
double begin_of(std::uint16_t bin) {
    if (bin == 0) return 0;
    return static_cast<double>(
        std::bit_cast<float>((leading_bits(kLeastBinned) + bin - 1u) << kDigitsDropped));
}

}  // namespace

VertexCounts::VertexCounts(const Scenario& scenario, Maps maps)
    : scenario_(scenario),
      maps_(std::move(maps)),
      spread_(maps_.spread()),
      counts_(maps_.thresholds.size() * scenario.grid.size()),
      histograms_(spread_.size() * scenario.grid.size()),
      hardest_(maps_.hardest ? scenario.grid.size() : 0) {
    CHECK(maps_.thresholds.size() <= Maps::kMostThresholds);
}

bool VertexCounts::has_ground(std::size_t vertex) const {
    return scenario_.has_data.empty() || scenario_.has_data[vertex] != 0;
}

Marks VertexCounts::marks(const Peaks& peaks) const {
    const std::size_t size = scenario_.grid.size();
    const auto is_thickness = [](const auto& each) { return each.of == Mapped::kThickness; };
    const bool needs_thickness = std::ranges::any_of(maps_.thresholds, is_thickness) ||
                                 std::ranges::any_of(maps_.percentiles, is_thickness);
    const std::vector<float> thickness =
        needs_thickness ? peak_thickness_of(scenario_, peaks) : std::vector<float>();
    const auto peak = [&](Mapped quantity, std::size_t i) {
        return quantity == Mapped::kThickness ? thickness[i]
               : quantity == Mapped::kSpeed   ? peaks.speed_slope[i]
                                              : peaks.pressure[i];
    };
    const auto bin = [&](Mapped quantity, std::size_t i) {
        if (quantity == Mapped::kArrival)
            return peaks.arrival[i] == Peaks::kNever
                       ? kNoBin
                       : bin_of(static_cast<float>(peaks.arrival[i]) * scenario_.params.tick_s);
        const std::uint16_t found = bin_of(peak(quantity, i));
        return found == 0 ? kNoBin : found;  // as where the member did not come
    };
    Marks marks;
    std::vector<std::uint16_t> bins(spread_.size());
    for (std::size_t i = 0; i < size; ++i) {
        if (peaks.depth[i] == 0) continue;
        std::uint16_t passed = 0;
        for (std::size_t t = 0; t < maps_.thresholds.size(); ++t)
            if (static_cast<double>(peak(maps_.thresholds[t].of, i)) >= maps_.thresholds[t].least)
                passed = static_cast<std::uint16_t>(passed | (1u << t));
        for (std::size_t q = 0; q < bins.size(); ++q) bins[q] = bin(spread_[q], i);
        const float hardness = maps_.hardest ? peak(*maps_.hardest, i) : 0;
        if (passed == 0 && hardness == 0 &&
            std::ranges::all_of(bins, [](std::uint16_t each) { return each == kNoBin; }))
            continue;
        marks.vertices.push_back(static_cast<std::uint32_t>(i));
        marks.passed.push_back(passed);
        marks.bins.insert(marks.bins.end(), bins.begin(), bins.end());
        if (maps_.hardest) marks.hardness.push_back(hardness);
    }
    return marks;
}

bool VertexCounts::can_count(const Marks& marks) const {
    return marks.passed.size() == marks.vertices.size() &&
           marks.bins.size() == marks.vertices.size() * spread_.size() &&
           marks.hardness.size() == (maps_.hardest ? marks.vertices.size() : 0) &&
           std::ranges::all_of(marks.hardness, [](float each) { return each >= 0 && std::isfinite(each); }) &&
           std::ranges::adjacent_find(marks.vertices, std::greater_equal<>()) == marks.vertices.end() &&
           (marks.vertices.empty() || marks.vertices.back() < scenario_.grid.size()) &&
           std::ranges::all_of(marks.passed,
                               [&](std::uint16_t each) { return each >> maps_.thresholds.size() == 0; }) &&
           std::ranges::all_of(marks.bins, [](std::uint16_t each) { return each < kBins || each == kNoBin; });
}

void VertexCounts::add(std::int64_t member, const Marks& marks) {
    CHECK(!has(member) && can_count(marks));
    if (member >= std::ssize(done_)) done_.resize(index(member) + 1);
    done_[index(member)] = 1;
    ++members_;
    const std::size_t size = scenario_.grid.size();
    for (std::size_t m = 0; m < marks.vertices.size(); ++m) {
        const std::size_t vertex = marks.vertices[m];
        for (std::size_t t = 0; t < maps_.thresholds.size(); ++t)
            counts_[t * size + vertex] += (marks.passed[m] >> t) & 1u;
        if (maps_.hardest) {
            const Hardest here{marks.hardness[m], static_cast<std::uint32_t>(member)};
            Hardest& so_far = hardest_[vertex];
            if (here.value > so_far.value || (here.value == so_far.value && here.member < so_far.member))
                so_far = here;
        }
        for (std::size_t q = 0; q < spread_.size(); ++q) {
            const std::uint16_t bin = marks.bins[m * spread_.size() + q];
            if (bin == kNoBin) continue;
            Histogram& histogram = histograms_[q * size + vertex];
            const auto at = std::ranges::lower_bound(histogram, bin, {}, &Bin::bin);
            if (at == histogram.end() || at->bin != bin)
                histogram.insert(at, {bin, 1});
            else
                ++at->members;
        }
    }
}

std::vector<float> VertexCounts::probability(std::size_t threshold) const {
    const std::size_t size = scenario_.grid.size();
    std::vector<float> share(size, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < size; ++i)
        if (has_ground(i))
            share[i] = members_ == 0 ? 0
                                     : static_cast<float>(static_cast<double>(counts_[threshold * size + i]) /
                                                          static_cast<double>(members_));
    return share;
}

std::vector<float> VertexCounts::percentile(const Percentile& percentile) const {
    const std::size_t size = scenario_.grid.size();
    const auto q = static_cast<std::size_t>(std::ranges::find(spread_, percentile.of) - spread_.begin());
    CHECK(q < spread_.size());
    // The member that is asked for, from 1, in ascending order.
    constexpr double kTiny = 1e-9;  // shares such as 29 % of 100 have no exact product
    const auto rank = std::max(
        std::int64_t{1},
        static_cast<std::int64_t>(std::ceil(percentile.share / 100 * static_cast<double>(members_) - kTiny)));
    const bool is_arrival = percentile.of == Mapped::kArrival;
    std::vector<float> values(size, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < size; ++i) {
        if (!has_ground(i)) continue;
        const Histogram& histogram = histograms_[q * size + i];
        std::int64_t left = rank;
        if (!is_arrival) {
            std::int64_t reached = 0;
            for (const Bin& bin : histogram) reached += bin.members;
            left -= members_ - reached;
            values[i] = 0;
        }
        if (left <= 0) continue;
        for (const Bin& bin : histogram) {
            if (left > bin.members) {
                left -= bin.members;
                continue;
            }
            const double begin = begin_of(bin.bin), end = begin_of(static_cast<std::uint16_t>(bin.bin + 1));
            values[i] =
                static_cast<float>(begin + (end - begin) * (static_cast<double>(left) - 0.5) / bin.members);
            break;
        }
    }
    return values;
}

std::vector<std::int64_t> VertexCounts::hardest() const {
    std::vector<std::int64_t> members;
    for (const Hardest& each : hardest_) members.push_back(each.member);
    return members;
}

// Head, done_, counts_, hardest_, then of each vertex and quantity that was reached: its place in histograms_, how many bins, bins.
std::string VertexCounts::bytes(const std::string& identity) const {
    CHECK(identity.size() == kHashDigits);
    std::string bytes(kCountsMagic);
    bytes += identity;
    put(static_cast<std::uint64_t>(done_.size()), bytes);
    bytes.append(done_.begin(), done_.end());
    for (const std::uint32_t count : counts_) put(count, bytes);
    for (const Hardest& each : hardest_)
        put(std::bit_cast<std::uint32_t>(each.value), bytes), put(each.member, bytes);
    for (std::size_t i = 0; i < histograms_.size(); ++i) {
        if (histograms_[i].empty()) continue;
        put(static_cast<std::uint64_t>(i), bytes);
        put(static_cast<std::uint16_t>(histograms_[i].size()), bytes);
        for (const Bin& bin : histograms_[i]) put(bin.bin, bytes), put(bin.members, bytes);
    }
    return bytes + hex(XXH3_64bits(bytes.data(), bytes.size()));
}

std::uintmax_t VertexCounts::most_bytes() const {
    constexpr std::uintmax_t kHead = kCountsMagic.size() + 2 * kHashDigits + 8,
                             kHistogram = 8 + 2 + 6 * kBins;
    return kHead + static_cast<std::uintmax_t>(EnsembleSpec::kMostMembers) + 1 + 4 * counts_.size() +
           8 * hardest_.size() + kHistogram * histograms_.size();
}

tl::expected<void, std::string> VertexCounts::take(std::string_view bytes, const std::string& identity) {
    if (bytes.size() < kCountsMagic.size() + 2 * kHashDigits ||
        bytes.substr(0, kCountsMagic.size()) != kCountsMagic)
        return tl::unexpected(std::string("has no counts of members"));
    const std::string_view body = bytes.substr(0, bytes.size() - kHashDigits);
    if (hex(XXH3_64bits(body.data(), body.size())) != bytes.substr(body.size()))
        return tl::unexpected(std::string("is damaged: its hash differs"));
    ByteTaker taker(body.substr(kCountsMagic.size()));
    if (taker.take(kHashDigits) != identity)
        return tl::unexpected(std::string("is of another ensemble, ground or version of the physics"));
    const auto many = taker.next<std::uint64_t>();
    const auto unfit = [&] {
        return tl::unexpected(fmt::format("has {} bytes, which do not fit its grid and maps", bytes.size()));
    };
    if (many > static_cast<std::uint64_t>(EnsembleSpec::kMostMembers) + 1) return unfit();
    const std::string_view done = taker.take(many);
    VertexCounts read(scenario_, maps_);
    read.done_.assign(done.begin(), done.end());
    read.members_ = std::ranges::count(read.done_, 1);
    for (std::uint32_t& count : read.counts_) {
        count = taker.next<std::uint32_t>();
        if (count > read.members_) return unfit();
    }
    for (Hardest& each : read.hardest_) {
        each.value = std::bit_cast<float>(taker.next<std::uint32_t>());
        each.member = taker.next<std::uint32_t>();
        if (!(each.value >= 0) || !std::isfinite(each.value) || (each.member != 0 && !read.has(each.member)))
            return unfit();
    }
    std::size_t next = 0;
    while (taker.left() > 0) {
        const auto at = taker.next<std::uint64_t>();
        if (at < next || at >= histograms_.size()) return unfit();
        next = at + 1;
        std::int64_t sum = 0;
        for (auto bins = taker.next<std::uint16_t>(); bins > 0; --bins) {
            const auto bin = taker.next<std::uint16_t>();
            const auto members = taker.next<std::uint32_t>();
            Histogram& histogram = read.histograms_[at];
            sum += members;
            if (bin >= kBins || members == 0 || sum > read.members_ ||
                (!histogram.empty() && bin <= histogram.back().bin))
                return unfit();
            histogram.push_back({bin, members});
        }
    }
    if (taker.has_failed()) return unfit();
    done_ = std::move(read.done_), members_ = read.members_;
    counts_ = std::move(read.counts_), histograms_ = std::move(read.histograms_);
    hardest_ = std::move(read.hardest_);
    return {};
}

}  // namespace game
