#include "game/ensemble/distribution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "game/base/number.h"

namespace game {
namespace {

using Kind = Distribution::Kind;

// Of the standard normal distribution: the share below x.
double normal_share(double x) {
    return std::erfc(-x / std::numbers::sqrt2) / 2;
}

// Where a share that rises from 0 at `least` to 1 at `most` reaches `share`.
template <class ShareBelow>
double inverted(double least, double most, double share, const ShareBelow& below) {
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = least + (most - least) / 2;
        (below(middle) < share ? least : most) = middle;
    }
    return least + (most - least) / 2;
}

double normal_at(const std::vector<double>& numbers, double share) {
    const double mean = numbers[0], deviation = numbers[1], least = numbers[2], most = numbers[3];
    const auto below = [&](double x) { return normal_share((x - mean) / deviation); };
    const double cut = below(least), kept = below(most) - cut;
    return inverted(least, most, share, [&](double x) { return (below(x) - cut) / kept; });
}

double triangular_at(const std::vector<double>& numbers, double share) {
    const double least = numbers[0], likely = numbers[1], most = numbers[2], range = most - least;
    const double rising = (likely - least) / range;  // share below the most likely value
    return share < rising ? least + std::sqrt(share * range * (likely - least))
                          : most - std::sqrt((1 - share) * range * (most - likely));
}

double pert_at(const std::vector<double>& numbers, double share) {
    constexpr int kSteps = 4096;
    const double least = numbers[0], likely = numbers[1], range = numbers[2] - least;
    const double rises = 4 * (likely - least) / range, falls = 4 - rises;
    // Its distribution function by the trapezium rule, in steps of a 4096th of the range.
    std::array<double, kSteps + 1> below{};
    const auto density = [&](int i) {
        const double x = static_cast<double>(i) / kSteps;
        return std::pow(x, rises) * std::pow(1 - x, falls);
    };
    for (std::size_t i = 1; i < below.size(); ++i)
        below[i] = below[i - 1] + (density(static_cast<int>(i) - 1) + density(static_cast<int>(i))) / 2;
    const double wanted = share * below.back();
    const auto above = std::ranges::upper_bound(below, wanted);
    const auto i = std::min<std::ptrdiff_t>(above - below.begin(), kSteps) - 1;
    const double from = below[static_cast<std::size_t>(i)], to = below[static_cast<std::size_t>(i) + 1];
    const double part = to > from ? (wanted - from) / (to - from) : 0;
    return least + range * (static_cast<double>(i) + part) / kSteps;
}

double exact_at(const Distribution& distribution, double share) {
    const std::vector<double>& numbers = distribution.numbers;
    switch (distribution.kind) {
        case Kind::kTriangular:
            return triangular_at(numbers, share);
        case Kind::kPert:
            return pert_at(numbers, share);
        case Kind::kNormal:
            return normal_at(numbers, share);
        case Kind::kList:
            return numbers[std::min(static_cast<std::size_t>(share * static_cast<double>(numbers.size())),
                                    numbers.size() - 1)];
        case Kind::kUniform:
            break;
    }
    return numbers[0] + share * (numbers[1] - numbers[0]);
}

}  // namespace

const std::vector<DistributionInfo>& distribution_infos() {
    static const std::vector<DistributionInfo> kInfos{
        {Kind::kUniform, "uniform", "least, most", 2},
        {Kind::kTriangular, "triangular", "least, most likely, most", 3},
        {Kind::kPert, "pert", "least, most likely, most", 3},
        {Kind::kNormal, "normal", "mean, standard deviation, least, most", 4},
        {Kind::kList, "list", "values", 0},
    };
    return kInfos;
}

const DistributionInfo& info_of(Kind kind) {
    return *std::ranges::find(distribution_infos(), kind, &DistributionInfo::kind);
}

std::optional<std::string> fault_of(const Distribution& distribution, double least, double most) {
    const std::vector<double>& numbers = distribution.numbers;
    if (numbers.empty()) return "has no value";
    const bool is_normal = distribution.kind == Kind::kNormal;
    // What it can yield: all of its numbers but mean and deviation.
    const std::size_t first = is_normal ? 2 : 0;
    for (std::size_t i = first; i < numbers.size(); ++i)
        if (!(numbers[i] >= least && numbers[i] <= most))
            return fmt::format("yields {}, which is not from {} to {}", numbers[i], least, most);
    if (distribution.kind == Kind::kList) return std::nullopt;
    if (is_normal && !(numbers[1] > 0)) return "has a deviation that is not above 0";
    if (!(numbers[first] < numbers.back())) return "has a least value that is not below the greatest";
    const bool has_likely = distribution.kind == Kind::kTriangular || distribution.kind == Kind::kPert;
    if (has_likely && (numbers[1] < numbers[0] || numbers[1] > numbers[2]))
        return "has a most likely value beyond its least or greatest";
    constexpr double kFarthest = 5;  // deviations beyond which hardly anything is left to draw from
    if (is_normal && (numbers[0] < numbers[2] - kFarthest * numbers[1] ||
                      numbers[0] > numbers[3] + kFarthest * numbers[1]))
        return "has a mean that lies more than five deviations outside its least or greatest";
    return std::nullopt;
}

double value_at(const Distribution& distribution, double share) {
    return number_from<double>(fmt::format("{:.6g}", exact_at(distribution, share))).value();
}

}  // namespace game
