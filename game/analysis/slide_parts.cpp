#include "game/analysis/slide_parts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "game/analysis/measures.h"
#include "sim/world/disc.h"

namespace game {
namespace {

// Marks of a vertex.
constexpr std::uint8_t kSeen = 1, kOfSlide = 2, kOfSlab = 4, kSeenOfSlab = 8, kReleased = 16;

}  // namespace

struct SlideParts::Sight {
    const Scenario& start;
    const sim::View& world;
    const Peaks& peaks;
    std::span<const std::span<const TimedCommand>> commands;

    const sim::Grid& grid() const { return start.grid; }
    int column(std::uint32_t vertex) const { return static_cast<int>(vertex) % grid().nx; }
    int row(std::uint32_t vertex) const { return static_cast<int>(vertex) / grid().nx; }
    glm::dvec2 place(std::uint32_t vertex) const {
        return static_cast<double>(grid().dx) * glm::dvec2(column(vertex), row(vertex));
    }
    double height(std::size_t vertex) const {  // m, of the ground at tick 0
        return static_cast<double>(start.bedrock[vertex]) + static_cast<double>(start.depth[vertex]);
    }
    double speed(std::uint32_t vertex) const {
        const int x = column(vertex), y = row(vertex);
        return glm::length(glm::dvec2(world.velocity_x(x, y), world.velocity_y(x, y)));
    }
    double rolling(std::uint32_t vertex) const {
        return static_cast<double>(world.rolling(column(vertex), row(vertex)));
    }
    // Uphill, over some cells.
    glm::dvec2 rise(std::uint32_t vertex) const {
        constexpr int kReach = 3;
        const int x = column(vertex), y = row(vertex);
        const auto at = [&](int i, int j) {
            return height(index_of(grid(), std::clamp(i, 0, grid().nx - 1), std::clamp(j, 0, grid().ny - 1)));
        };
        return {at(x + kReach, y) - at(x - kReach, y), at(x, y + kReach) - at(x, y - kReach)};
    }
};

void SlideParts::find(const Scenario& start, const sim::View& world, const Peaks& peaks,
                      std::span<const std::span<const TimedCommand>> commands) {
    const std::size_t size = start.grid.size();
    at_ = {};
    marks_.assign(size, 0);
    for (Vertices* list : {&slide_, &released_, &flooded_}) list->clear(), list->reserve(size);
    const Sight sight{start, world, peaks, commands};
    find_slide(sight);
    if (slide_.empty()) return;
    find_slab(sight);
    if (!has_slab_) find_first(sight);
    find_edges(sight);
    find_front_or_deposit(sight);
    find_track(sight);
}

// The vertices around one that are connected with it, into flooded_; each gets the mark.
template <class Inside>
void SlideParts::flood(const sim::Grid& grid, std::uint32_t from, std::uint8_t mark, const Inside& inside) {
    flooded_.clear();
    const auto add = [&](std::uint32_t vertex) {
        marks_[vertex] |= mark;
        flooded_.push_back(vertex);
    };
    add(from);
    for (std::size_t k = 0; k < flooded_.size(); ++k) {
        const int x = static_cast<int>(flooded_[k]) % grid.nx, y = static_cast<int>(flooded_[k]) / grid.nx;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, grid.ny - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, grid.nx - 1); ++i)
                if (const auto other = static_cast<std::uint32_t>(index_of(grid, i, j));
                    !has(other, mark) && inside(other))
                    add(other);
    }
}

void SlideParts::find_slide(const Sight& sight) {
    const auto flowed = [&](std::uint32_t vertex) {
        return sight.peaks.depth[vertex] >= Measures::kExtentDepth;
    };
    for (std::uint32_t vertex = 0; vertex < marks_.size(); ++vertex) {
        if (has(vertex, kSeen) || !flowed(vertex)) continue;
        flood(sight.grid(), vertex, kSeen, flowed);
        if (flooded_.size() > slide_.size()) slide_.swap(flooded_);
    }
    for (const std::uint32_t vertex : slide_) marks_[vertex] |= kOfSlide;
}

// What a blast released had not moved before its tick. Of several slabs the largest.
void SlideParts::find_slab(const Sight& sight) {
    for (const std::uint32_t vertex : slide_)
        if (sight.start.rolling[vertex] > 0 && sight.peaks.arrival[vertex] == 0) marks_[vertex] |= kOfSlab;
    for (const auto& list : sight.commands)
        for (const TimedCommand& timed : list) {
            if (timed.command.kind != sim::CommandKind::kBlast || timed.tick >= sight.world.tick) continue;
            const sim::Disc disc(timed.command, static_cast<double>(sight.grid().dx));
            disc.each_vertex(sight.grid(), sim::Profile::kDisc, [&](int x, int y, double) {
                const std::size_t vertex = index_of(sight.grid(), x, y);
                const bool at_once = sight.peaks.arrival[vertex] == timed.tick + 1;
                if (at_once && has(static_cast<std::uint32_t>(vertex), kOfSlide)) marks_[vertex] |= kOfSlab;
            });
        }
    for (const std::uint32_t vertex : slide_) {
        if (!has(vertex, kOfSlab) || has(vertex, kSeenOfSlab)) continue;
        flood(sight.grid(), vertex, kSeenOfSlab, [&](std::uint32_t other) { return has(other, kOfSlab); });
        if (flooded_.size() > released_.size()) released_.swap(flooded_);
    }
    has_slab_ = !released_.empty();
}

// Where the slide moved first, if no slab was released.
void SlideParts::find_first(const Sight& sight) {
    const auto& arrival = sight.peaks.arrival;
    std::uint32_t first = Peaks::kNever;
    for (const std::uint32_t vertex : slide_) first = std::min(first, arrival[vertex]);
    std::ranges::copy_if(slide_, std::back_inserter(released_),
                         [&](std::uint32_t vertex) { return arrival[vertex] == first; });
}

// An edge is named where it crosses the line of fall through the middle, or near that.
void SlideParts::find_edges(const Sight& sight) {
    glm::dvec2 rise(0), middle(0);
    for (const std::uint32_t vertex : released_) {
        marks_[vertex] |= kReleased;
        rise += sight.rise(vertex), middle += sight.place(vertex);
    }
    middle /= static_cast<double>(released_.size());
    from_ = middle;
    if (glm::length(rise) == 0) return;
    const glm::dvec2 up = glm::normalize(rise);
    std::uint32_t highest = released_.front(), lowest = released_.front();
    double most_up = -1e30, most_down = -1e30;
    for (const std::uint32_t vertex : released_) {
        constexpr double kAside = 0.5;  // what a metre beside that line counts against one along it
        const glm::dvec2 away = sight.place(vertex) - middle;
        const double along = glm::dot(away, up), aside = kAside * std::abs(away.x * up.y - away.y * up.x);
        if (along - aside > most_up) most_up = along - aside, highest = vertex;
        if (-along - aside > most_down) most_down = -along - aside, lowest = vertex;
    }
    from_ = sight.place(climb(sight, highest, up));
    put(Part::kCrown, from_);
    if (has_slab_ && lowest != highest) put(Part::kStauchwall, sight.place(lowest));
}

// What broke loose above the first part did so later, the higher the later; what came down from above had moved before.
std::uint32_t SlideParts::climb(const Sight& sight, std::uint32_t from, glm::dvec2 up) const {
    const sim::Grid& grid = sight.grid();
    constexpr double kPace = 0.5;  // cells
    glm::dvec2 cells(sight.column(from), sight.row(from));
    for (std::uint32_t highest = from;;) {
        cells += kPace * up;
        const auto x = static_cast<int>(std::lround(cells.x)), y = static_cast<int>(std::lround(cells.y));
        if (x < 0 || y < 0 || x >= grid.nx || y >= grid.ny) return highest;
        const auto vertex = static_cast<std::uint32_t>(index_of(grid, x, y));
        if (!has(vertex, kOfSlide) || sight.peaks.arrival[vertex] < sight.peaks.arrival[highest])
            return highest;
        highest = vertex;
    }
}

// Whatever still trickles behind a deposit is no front.
void SlideParts::find_front_or_deposit(const Sight& sight) {
    double fast = 0, at_rest = 0, farthest = -1, deepest = kLeastNew;
    std::optional<glm::dvec2> front, deposit;
    for (const std::uint32_t vertex : slide_) {
        const double rolling = sight.rolling(vertex), speed = sight.speed(vertex);
        const glm::dvec2 place = sight.place(vertex);
        if (speed >= kFast && rolling >= static_cast<double>(Measures::kExtentDepth)) {
            const double away = glm::distance(place, from_);
            if (away > farthest) farthest = away, front = place;
            fast += rolling;
        }
        double more = static_cast<double>(sight.world.depth(sight.column(vertex), sight.row(vertex))) -
                      static_cast<double>(sight.start.depth[vertex]);
        if (speed < kAtRest) more += rolling;
        if (more > deepest) deepest = more, deposit = place;
        at_rest += std::max(more, 0.0);
    }
    if (front && fast >= kLeastFast * at_rest)
        put(Part::kFront, *front);
    else if (deposit)
        put(Part::kDeposit, *deposit);
}

void SlideParts::find_track(const Sight& sight) {
    const auto& crown = at(Part::kCrown);
    if (!crown) return;
    const auto is_nearer = [&](std::uint32_t one, std::uint32_t other) {
        return glm::distance(sight.place(one), *crown) < glm::distance(sight.place(other), *crown);
    };
    const std::uint32_t toe = *std::ranges::max_element(slide_, is_nearer);
    const double cell = static_cast<double>(sight.grid().dx);
    if (glm::distance(sight.place(toe), *crown) < kLeastTrack * cell) return;
    const auto height_at = [&](glm::dvec2 place) {
        return sight.height(index_of(sight.grid(), static_cast<int>(std::lround(place.x / cell)),
                                     static_cast<int>(std::lround(place.y / cell))));
    };
    const double fall = height_at(*crown) - sight.height(toe), half = sight.height(toe) + fall / 2;
    if (fall <= 0) return;
    if (const auto& wall = at(Part::kStauchwall); wall && height_at(*wall) <= half) return;
    constexpr double kBand = 0.05;  // of the fall, above and below
    const auto each = [&](const auto& see) {
        for (const std::uint32_t vertex : slide_)
            if (!has(vertex, kReleased) && std::abs(sight.height(vertex) - half) <= kBand * fall) see(vertex);
    };
    double sum = 0;
    glm::dvec2 middle(0);
    each([&](std::uint32_t vertex) {
        const double weight =
            static_cast<double>(sight.peaks.depth[vertex] * sight.peaks.speed_slope[vertex]);
        sum += weight, middle += weight * sight.place(vertex);
    });
    if (sum <= 0) return;
    middle /= sum;
    double nearest = 1e30;  // of two branches the middle is in neither
    each([&](std::uint32_t vertex) {
        const double away = glm::distance(sight.place(vertex), middle);
        if (away < nearest) nearest = away, put(Part::kTrack, sight.place(vertex));
    });
}

}  // namespace game
