#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace game {

// How likely each value of an uncertain number is.
struct Distribution {
    enum class Kind : std::uint8_t {
        kUniform,     // least, most
        kTriangular,  // least, most likely, most
        kPert,        // the same; a beta distribution of shape 4 (Malcolm and others, 1959)
        kNormal,      // mean, standard deviation, least, most: values beyond these are left out
        kList,        // values, each as likely
    };
    Kind kind = Kind::kUniform;
    std::vector<double> numbers;

    static constexpr std::size_t kMostListed = 1000;
    bool operator==(const Distribution&) const = default;
};

struct DistributionInfo {
    Distribution::Kind kind;
    std::string_view name, numbers;  // "triangular", "least, most likely, most"
    std::size_t count;               // of its numbers; 0: any
};
const std::vector<DistributionInfo>& distribution_infos();
const DistributionInfo& info_of(Distribution::Kind kind);

// What is wrong with it, where values may lie from `least` to `most`; nothing if it can be drawn from.
std::optional<std::string> fault_of(const Distribution& distribution, double least, double most);

// The value below which lies this share of all, 0 < share < 1, to six significant digits: so mathematics libraries,
// whose last bits differ, agree on it. Needs a distribution without a fault.
double value_at(const Distribution& distribution, double share);

}  // namespace game
