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

using Outline = std::vector<LocalPoint>;

double area_within(const Outline& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const LocalPoint &from = ring[i], &to = ring[(i + 1) % ring.size()];
        // About the first point, because coordinates are large beside the ring.
        twice += (from.x - ring[0].x) * (to.y - ring[0].y) - (to.x - ring[0].x) * (from.y - ring[0].y);
    }
    return std::abs(twice) / 2;
}

// The part of a ring where `coordinate` is at least `least`, after Sutherland and Hodgman (1974). Parts of a concave
// ring stay joined along the line, which adds no area.
Outline clip(const Outline& ring, double LocalPoint::*coordinate, double sign, double least) {
    Outline kept;
    kept.reserve(ring.size() + 4);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const LocalPoint &from = ring[i], &to = ring[(i + 1) % ring.size()];
        const double before = sign * from.*coordinate - least, after = sign * to.*coordinate - least;
        if (before >= 0) kept.push_back(from);
        if ((before >= 0) != (after >= 0)) {
            const double t = before / (before - after);
            kept.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
        }
    }
    return kept;
}

template <class AreaOfRing>
double less_holes(const Area& area, AreaOfRing area_of_one) {
    double sum = 0;
    for (std::size_t i = 0; i < area.rings.size(); ++i) {
        const double one = area_of_one(area.rings[i]);
        sum += i == 0 ? one : -one;
    }
    return std::max(sum, 0.0);
}

}  // namespace

double area_of(const Area& area) {
    return less_holes(area, area_within);
}

double area_on_grid(const Area& area, const sim::Grid& grid) {
    const double dx = static_cast<double>(grid.dx);
    return less_holes(area, [&](const Outline& ring) {
        Outline inside = clip(ring, &LocalPoint::x, 1, -dx / 2);
        inside = clip(inside, &LocalPoint::x, -1, -(grid.nx - 0.5) * dx);
        inside = clip(inside, &LocalPoint::y, 1, -dx / 2);
        return area_within(clip(inside, &LocalPoint::y, -1, -(grid.ny - 0.5) * dx));
    });
}

tl::expected<Coverage, std::string> cover(const sim::Grid& grid, const std::vector<Area>& areas) {
    std::vector<Crossing> crossings;
    if (!add_crossings(grid, areas, crossings))
        return tl::unexpected<std::string>("its outlines are too complex for this grid; simplify them");
    std::sort(crossings.begin(), crossings.end());
    const std::size_t samples = static_cast<std::size_t>(grid.nx) * kSamples;
    Line line(samples);
    std::vector<Span> spans;
    std::vector<double> sum(grid.size());
    double of_all = 0, of_thickest = 0;  // thickness of all samples of all areas, and of those that count
    for (std::size_t first = 0, last = 0; first < crossings.size(); first = last) {
        const std::int32_t at = crossings[first].line;
        while (last < crossings.size() && crossings[last].line == at) ++last;
        spans.clear();
        add_spans(std::span(crossings).subspan(first, last - first), areas, samples, spans);
        const std::vector<double>& thickness = line.fill(spans);
        double* row =
            sum.data() + static_cast<std::size_t>(at / kSamples) * static_cast<std::size_t>(grid.nx);
        for (std::size_t i = 0; i < samples; ++i) row[i / kSamples] += thickness[i];
        of_thickest = std::accumulate(thickness.begin(), thickness.end(), of_thickest);
        for (const Span& span : spans)
            if (span.last > span.first)
                of_all += static_cast<double>(span.last - span.first) * span.thickness;
    }
    Coverage coverage;
    coverage.mean.resize(sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i)
        coverage.mean[i] = static_cast<float>(sum[i] / (kSamples * kSamples));
    const double side = static_cast<double>(grid.dx) / kSamples;  // of a sample's square, m
    coverage.overlap = std::max(of_all - of_thickest, 0.0) * side * side;
    return coverage;
}

}  // namespace terrains
