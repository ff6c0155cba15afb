#include "terrains/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace terrains {
namespace {

constexpr int kSamples = 8;  // per cell and axis

// An outline crossing a line of samples. Sample line k lies at y = ((k + ½) / kSamples − ½) dx, samples along
// it alike.
struct Crossing {
    std::int32_t line;
    std::int32_t area;
    double x;  // in samples
    bool operator<(const Crossing& other) const {
        return std::tie(line, area, x) < std::tie(other.line, other.area, other.x);
    }
};

// Metres to samples: sample k is at k.
double to_samples(double metres, double dx) {
    return (metres / dx + 0.5) * kSamples - 0.5;
}

bool add_crossings(const sim::Grid& grid, const std::vector<Area>& areas, std::vector<Crossing>& crossings) {
    constexpr std::size_t kMost = 20'000'000;
    const double lines = static_cast<double>(grid.ny) * kSamples;
    for (std::size_t area = 0; area < areas.size(); ++area)
        for (const auto& ring : areas[area].rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const LocalPoint &from = ring[i], &to = ring[(i + 1) % ring.size()];
                const double x0 = to_samples(from.x, grid.dx), y0 = to_samples(from.y, grid.dx);
                const double x1 = to_samples(to.x, grid.dx), y1 = to_samples(to.y, grid.dx);
                // Half-open, so that a corner on a line is crossed once.
                const auto first =
                    static_cast<std::int32_t>(std::clamp(std::ceil(std::min(y0, y1)), 0.0, lines));
                const auto last =
                    static_cast<std::int32_t>(std::clamp(std::ceil(std::max(y0, y1)), 0.0, lines));
                for (std::int32_t line = first; line < last; ++line) {
                    if (crossings.size() == kMost) return false;
                    crossings.push_back(
                        {line, static_cast<std::int32_t>(area), x0 + (x1 - x0) * (line - y0) / (y1 - y0)});
                }
            }
    return true;
}

}  // namespace

tl::expected<std::vector<float>, std::string> mean_thickness(const sim::Grid& grid,
                                                             const std::vector<Area>& areas) {
    std::vector<Crossing> crossings;
    if (!add_crossings(grid, areas, crossings))
        return tl::unexpected<std::string>("its outlines are too intricate for this grid");
    std::sort(crossings.begin(), crossings.end());
    std::vector<double> line(static_cast<std::size_t>(grid.nx) * kSamples), sum(grid.size());
    std::size_t next = 0;
    while (next < crossings.size()) {
        const std::int32_t at = crossings[next].line;
        std::fill(line.begin(), line.end(), 0.0);
        // Rings are closed, so crossings of one area on one line come in pairs: inside between the two.
        for (; next + 1 < crossings.size() && crossings[next].line == at; next += 2) {
            const double most = static_cast<double>(line.size()),
                         thickness = areas[crossings[next].area].thickness;
            const double first = std::clamp(std::ceil(crossings[next].x), 0.0, most);
            const double last = std::clamp(std::ceil(crossings[next + 1].x), 0.0, most);
            for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
                line[i] = std::max(line[i], thickness);
        }
        double* row = sum.data() + static_cast<std::size_t>(at / kSamples) * grid.nx;
        for (std::size_t i = 0; i < line.size(); ++i) row[i / kSamples] += line[i];
    }
    std::vector<float> mean(sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) mean[i] = static_cast<float>(sum[i] / (kSamples * kSamples));
    return mean;
}

}  // namespace terrains
