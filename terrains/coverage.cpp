#include "terrains/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>

namespace terrains {
namespace {

constexpr int kSamples = 8;  // per cell and axis

// A crossing of an outline and a line of samples. Sample line k is at y = ((k + ½) / kSamples − ½) dx;
// samples along it are spaced likewise.
struct Crossing {
    std::int32_t line;
    std::int32_t area;
    double x;  // in samples
    bool operator<(const Crossing& other) const {
        return std::tie(line, area, x) < std::tie(other.line, other.area, other.x);
    }
};

// Converts metres to samples: sample k is at k.
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
                // Half-open, so that a corner on a sample line is crossed once.
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

// Samples of one line, from `first` up to `last`, within the line.
struct Span {
    std::size_t first, last;
    double thickness;
};

// Rings are closed, so crossings of one area on one line come in pairs that bound the inside.
void add_spans(std::span<const Crossing> crossings, const std::vector<Area>& areas, std::size_t samples,
               std::vector<Span>& spans) {
    const double most = static_cast<double>(samples);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const double first = std::clamp(std::ceil(crossings[i].x), 0.0, most);
        const double last = std::clamp(std::ceil(crossings[i + 1].x), 0.0, most);
        spans.push_back({static_cast<std::size_t>(first), static_cast<std::size_t>(last),
                         areas[static_cast<std::size_t>(crossings[i].area)].thickness});
    }
}

// A line of samples that spans fill, each sample with the greatest thickness. Every sample is written once,
// however many spans overlap.
class Line {
  public:
    explicit Line(std::size_t samples) : thickness_(samples), free_(samples + 1) {}

    // Sorts the spans.
    const std::vector<double>& fill(std::vector<Span>& spans) {
        std::fill(thickness_.begin(), thickness_.end(), 0.0);
        std::iota(free_.begin(), free_.end(), std::size_t{0});
        std::sort(spans.begin(), spans.end(),
                  [](const Span& a, const Span& b) { return a.thickness > b.thickness; });
        for (const Span& span : spans)
            for (std::size_t i = first_free(span.first); i < span.last; i = first_free(i)) {
                thickness_[i] = span.thickness;
                free_[i] = i + 1;
            }
        return thickness_;
    }

  private:
    // Returns the first unfilled sample from i on, or one past the end.
    std::size_t first_free(std::size_t i) {
        while (free_[i] != i) i = free_[i] = free_[free_[i]];
        return i;
    }

    std::vector<double> thickness_;
    std::vector<std::size_t> free_;  // for a filled sample: a later one on the path to the next free one
};

}  // namespace

tl::expected<std::vector<float>, std::string> mean_thickness(const sim::Grid& grid,
                                                             const std::vector<Area>& areas) {
    std::vector<Crossing> crossings;
    if (!add_crossings(grid, areas, crossings))
        return tl::unexpected<std::string>("its outlines are too complex for this grid; simplify them");
    std::sort(crossings.begin(), crossings.end());
    const std::size_t samples = static_cast<std::size_t>(grid.nx) * kSamples;
    Line line(samples);
    std::vector<Span> spans;
    std::vector<double> sum(grid.size());
    for (std::size_t first = 0, last = 0; first < crossings.size(); first = last) {
        const std::int32_t at = crossings[first].line;
        while (last < crossings.size() && crossings[last].line == at) ++last;
        spans.clear();
        add_spans(std::span(crossings).subspan(first, last - first), areas, samples, spans);
        const std::vector<double>& thickness = line.fill(spans);
        double* row =
            sum.data() + static_cast<std::size_t>(at / kSamples) * static_cast<std::size_t>(grid.nx);
        for (std::size_t i = 0; i < samples; ++i) row[i / kSamples] += thickness[i];
    }
    std::vector<float> mean(sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) mean[i] = static_cast<float>(sum[i] / (kSamples * kSamples));
    return mean;
}

}  // namespace terrains
