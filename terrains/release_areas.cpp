// Slopes and curvatures are those of the plane and the quadric that are fitted to 3 × 3 heights by least squares (Evans 1972):
//
//     z7 z8 z9     p = dz/dx = (z3 + z6 + z9 - z1 - z4 - z7) / 6 h      r = d²z/dx² = (row sums of z1 - 2 z2 + z3) / 3 h²
//     z4 z5 z6     q = dz/dy = (z7 + z8 + z9 - z1 - z2 - z3) / 6 h      t = d²z/dy²   likewise by columns
//     z1 z2 z3     s = d²z/dxdy = (z9 + z1 - z3 - z7) / 4 h²

#include "terrains/release_areas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrains/outlines.h"

namespace terrains {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

struct Shape {
    bool is_known = false;  // all nine heights are
    double p = 0, q = 0;    // slopes to the east and to the north
    double curvature = 0;   // of the contour line, rad per 100 m

    double slope() const { return std::atan(std::hypot(p, q)) * kDegrees; }
    glm::dvec3 normal() const { return glm::normalize(glm::dvec3(-p, -q, 1)); }
};

// Fields over a grid whose values beyond its border are those of the border.
class Ground {
  public:
    Ground(const sim::Grid& grid, std::span<const float> surface, std::span<const std::uint8_t> has_data)
        : grid_(grid), surface_(surface), has_data_(has_data) {}

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.nx) + static_cast<std::size_t>(x);
    }
    // Calls see(index) for each vertex of a square around one that is on the grid.
    template <class See>
    void around(int x, int y, int reach, const See& see) const {
        for (int v = std::max(y - reach, 0); v <= std::min(y + reach, grid_.ny - 1); ++v)
            for (int u = std::max(x - reach, 0); u <= std::min(x + reach, grid_.nx - 1); ++u) see(at(u, v));
    }
    Shape shape(int x, int y) const;

  private:
    const sim::Grid& grid_;
    std::span<const float> surface_;
    std::span<const std::uint8_t> has_data_;
};

Shape Ground::shape(int x, int y) const {
    Shape shape;
    if (x < 1 || y < 1 || x >= grid_.nx - 1 || y >= grid_.ny - 1) return shape;
    shape.is_known = true;
    around(x, y, 1, [&](std::size_t i) { shape.is_known &= has_data_.empty() || has_data_[i] != 0; });
    if (!shape.is_known) return shape;
    const auto z = [&](int i, int j) { return static_cast<double>(surface_[at(x + i, y + j)]); };
    const double h = grid_.dx;
    double r = 0, t = 0;
    for (int k = -1; k <= 1; ++k) {
        shape.p += (z(1, k) - z(-1, k)) / (6 * h);
        shape.q += (z(k, 1) - z(k, -1)) / (6 * h);
        r += (z(-1, k) - 2 * z(0, k) + z(1, k)) / (3 * h * h);
        t += (z(k, -1) - 2 * z(k, 0) + z(k, 1)) / (3 * h * h);
    }
    const double s = (z(1, 1) + z(-1, -1) - z(1, -1) - z(-1, 1)) / (4 * h * h);
    const double p = shape.p, q = shape.q, steep = p * p + q * q;
    constexpr double kHundredMetres = 100;
    if (steep > 0)
        shape.curvature = -kHundredMetres * (q * q * r - 2 * p * q * s + p * p * t) / std::pow(steep, 1.5);
    return shape;
}

// How favourable a slope and a ruggedness are (Veitinger and others 2016, their bell curves and their fuzzy "and").
double favour_of(double slope, double ruggedness) {
    const auto bell = [](double x, double a, double b, double c) {
        return 1 / (1 + std::pow(std::fabs((x - c) / a), 2 * b));
    };
    const double by_slope = bell(slope, 11, 4, 43), by_ruggedness = bell(ruggedness, 0.01, 5, -0.007);
    const double least = std::min(by_slope, by_ruggedness);
    return (1 - least) * least + least * (by_slope + by_ruggedness) / 2;
}

// Vertices of one sign that lie side by side, by number from 0, and how they are joined to areas.
class Pieces {
  public:
    Pieces(const sim::Grid& grid, const std::vector<int>& sign, const std::vector<glm::dvec2>& fall)
        : grid_(&grid), piece_(patches_of(grid, sign)) {
        joined_.resize(static_cast<std::size_t>(std::ranges::max(piece_)));
        for (int& piece : piece_) --piece;  // from 0, and -1 for none
        std::iota(joined_.begin(), joined_.end(), 0);
        count(fall);
    }
    // Joins pieces smaller than so many cells, the smallest first.
    void join(double least_cells);
    // The piece that a vertex belongs to now, or -1.
    int of(std::size_t vertex) const { return piece_[vertex] < 0 ? -1 : root(piece_[vertex]); }
    double cells(int piece) const { return cells_[static_cast<std::size_t>(piece)]; }
    const glm::dvec2& fall(int piece) const { return fall_[static_cast<std::size_t>(piece)]; }

  private:
    int root(int piece) const {
        while (joined_[static_cast<std::size_t>(piece)] != piece)
            piece = joined_[static_cast<std::size_t>(piece)];
        return piece;
    }
    template <class See>
    void beside(std::size_t vertex, const See& see) const {
        const auto nx = static_cast<std::size_t>(grid_->nx);
        const std::size_t x = vertex % nx;
        if (x > 0) see(vertex - 1);
        if (x + 1 < nx) see(vertex + 1);
        if (vertex >= nx) see(vertex - nx);
        if (vertex + nx < piece_.size()) see(vertex + nx);
    }
    void count(const std::vector<glm::dvec2>& fall);

    const sim::Grid* grid_;
    std::vector<int> piece_;   // per vertex, before any was joined
    std::vector<int> joined_;  // the piece that it was joined to, or itself
    std::vector<double> cells_;
    std::vector<glm::dvec2> fall_;            // sum of directions down the slope
    std::vector<std::map<int, int>> border_;  // how many sides of cells it shares with which
};

void Pieces::count(const std::vector<glm::dvec2>& fall) {
    cells_.resize(joined_.size());
    fall_.resize(joined_.size());
    border_.resize(joined_.size());
    for (std::size_t i = 0; i < piece_.size(); ++i) {
        if (piece_[i] < 0) continue;
        const auto piece = static_cast<std::size_t>(piece_[i]);
        ++cells_[piece], fall_[piece] += fall[i];
        beside(i, [&](std::size_t other) {
            if (piece_[other] >= 0 && piece_[other] != piece_[i]) ++border_[piece][piece_[other]];
        });
    }
}

void Pieces::join(double least_cells) {
    const double kLeastCosine = std::cos(70 / kDegrees);
    using Small = std::pair<double, int>;  // cells, piece
    std::priority_queue<Small, std::vector<Small>, std::greater<>> open;
    for (std::size_t i = 0; i < cells_.size(); ++i)
        if (cells_[i] < least_cells) open.emplace(cells_[i], static_cast<int>(i));
    while (!open.empty()) {
        const auto [cells, piece] = open.top();
        open.pop();
        const auto from = static_cast<std::size_t>(piece);
        if (joined_[from] != piece || cells_[from] != cells) continue;  // joined, or grown since
        int best = -1, longest = 0;
        for (const auto& [other, sides] : border_[from]) {
            const glm::dvec2 theirs = fall_[static_cast<std::size_t>(other)];
            const double turn = glm::dot(fall_[from], theirs);
            if (sides > longest && turn >= kLeastCosine * glm::length(fall_[from]) * glm::length(theirs))
                best = other, longest = sides;
        }
        if (best < 0) continue;
        const auto to = static_cast<std::size_t>(best);
        joined_[from] = best;
        cells_[to] += cells_[from], fall_[to] += fall_[from];
        for (const auto& [other, sides] : std::exchange(border_[from], {})) {
            auto& theirs = border_[static_cast<std::size_t>(other)];
            theirs.erase(piece);
            if (other == best) continue;
            theirs[best] += sides, border_[to][other] += sides;
        }
        if (cells_[to] < least_cells) open.emplace(cells_[to], best);
    }
    for (std::size_t i = 0; i < joined_.size(); ++i)
        joined_[i] = root(static_cast<int>(i));  // short ways from now on
}

struct Cell {
    int x, y;
    std::size_t vertex;
};

// Where to cut an area: cells are on one side if their place in a direction is less than this.
struct Cut {
    glm::dvec2 direction;
    double place;
    bool is_before(const Cell& cell) const { return glm::dot(direction, glm::dvec2(cell.x, cell.y)) < place; }
};

Cut cut_of(const std::vector<Cell>& cells, std::span<const float> surface, const glm::dvec2& fall) {
    const double length = glm::length(fall);
    const glm::dvec2 down = length > 0 ? fall / length : glm::dvec2(0, -1), across(-down.y, down.x);
    // Heights above the plane of the area, whose slope is down its fall line, by place across it.
    glm::dvec3 mean(0);
    for (const Cell& cell : cells) mean += glm::dvec3(cell.x, cell.y, surface[cell.vertex]);
    mean /= static_cast<double>(cells.size());
    double along = 0, wide = 0, rise = 0;  // sums of squares, and of lengths times heights
    for (const Cell& cell : cells) {
        const glm::dvec2 place = glm::dvec2(cell.x, cell.y) - glm::dvec2(mean);
        const double s = glm::dot(down, place), w = glm::dot(across, place);
        along += s * s, wide += w * w, rise += s * (static_cast<double>(surface[cell.vertex]) - mean.z);
    }
    const double slope = along > 0 ? rise / along : 0;
    constexpr double kLong = 1.5;  // times as long as wide: into a higher and a lower half
    if (along > kLong * kLong * wide) return {down, glm::dot(down, glm::dvec2(mean))};
    struct Strip {
        double cells = 0, height = 0;
    };
    std::map<int, Strip> strips;  // one cell wide
    for (const Cell& cell : cells) {
        const glm::dvec2 place(cell.x, cell.y);
        Strip& strip = strips[static_cast<int>(std::floor(glm::dot(across, place)))];
        ++strip.cells;
        strip.height += static_cast<double>(surface[cell.vertex]) - mean.z -
                        slope * glm::dot(down, place - glm::dvec2(mean));
    }
    // The highest of its middle half, or the middle if none is a rib.
    constexpr double kLeastRib = 0.5;  // m above the middle
    const auto all = static_cast<double>(cells.size());
    std::optional<double> middle, best;
    double middle_height = 0, best_height = 0, so_far = 0;
    for (const auto& [place, strip] : strips) {
        const double before = so_far, height = strip.height / strip.cells;
        so_far += strip.cells;
        if (!middle && so_far >= all / 2) middle = place, middle_height = height;
        if (before >= all / 4 && so_far <= all * 3 / 4 && (!best || height > best_height))
            best = place, best_height = height;
    }
    return {across, best && best_height > middle_height + kLeastRib ? *best : *middle};
}

}  // namespace

ReleaseAreas find_release_areas(const sim::Grid& grid, std::span<const float> surface,
                                std::span<const std::uint8_t> has_data, std::span<const std::uint8_t> forest,
                                const ReleaseRules& rules) {
    const Ground ground(grid, surface, has_data);
    const std::size_t size = grid.size();
    std::vector<Shape> shapes(size);
    std::vector<glm::dvec3> normals(size);
    const auto each_vertex = [&](const auto& see) {
        for (int y = 0; y < grid.ny; ++y)
            for (int x = 0; x < grid.nx; ++x) see(x, y, ground.at(x, y));
    };
    each_vertex([&](int x, int y, std::size_t i) {
        shapes[i] = ground.shape(x, y);
        if (shapes[i].is_known) normals[i] = shapes[i].normal();
    });

    std::vector<double> ruggedness(size);
    std::vector<std::uint8_t> keeps(size);
    each_vertex([&](int x, int y, std::size_t i) {
        if (!shapes[i].is_known) return;
        glm::dvec3 sum(0);
        double known = 0;
        ground.around(x, y, 1, [&](std::size_t j) { sum += normals[j], known += shapes[j].is_known; });
        ruggedness[i] = 1 - glm::length(sum) / known;
        const double slope = shapes[i].slope();
        keeps[i] = slope >= rules.least_slope && slope <= rules.most_slope &&
                   ruggedness[i] <= rules.most_ruggedness &&
                   std::fabs(shapes[i].curvature) <= rules.most_curvature &&
                   (forest.empty() || forest[i] <= 255 * rules.most_forest);
    });

    // The eighth of the compass that the ground around falls to, where most cells around keep all rules.
    constexpr double kReach = 15;  // m
    const int reach = std::max(1, static_cast<int>(std::lround(kReach / static_cast<double>(grid.dx))));
    std::vector<int> sector(size, -1);
    std::vector<glm::dvec2> fall(size);
    each_vertex([&](int x, int y, std::size_t i) {
        if (!shapes[i].is_known) return;
        int keeping = 0;
        ground.around(x, y, 1, [&](std::size_t j) { keeping += keeps[j]; });
        if (keeping < 5) return;
        ground.around(x, y, reach, [&](std::size_t j) { fall[i] += glm::dvec2(normals[j]); });
        constexpr double kSectors = 8;
        const double turn =
            std::atan2(fall[i].x, fall[i].y) / (2 * std::numbers::pi);  // clockwise from north
        sector[i] = static_cast<int>(std::lround((turn + 1) * kSectors)) % static_cast<int>(kSectors);
    });

    const double least_cells = rules.least_area / grid.cell_area(),
                 most_cells = std::max(rules.most_area, 2 * rules.least_area) / grid.cell_area();
    std::vector<int> sign = std::move(sector);
    Pieces pieces(grid, sign, fall);
    pieces.join(least_cells);
    constexpr int kMostCuts = 12;  // each halves what is too large
    for (int cut = 0; cut < kMostCuts; ++cut) {
        std::map<int, std::vector<Cell>> large;
        each_vertex([&](int x, int y, std::size_t i) {
            const int piece = pieces.of(i);
            sign[i] = piece < 0 ? -1 : 2 * piece;
            if (piece >= 0 && pieces.cells(piece) > most_cells) large[piece].push_back({x, y, i});
        });
        if (large.empty()) break;
        for (const auto& [piece, cells] : large) {
            const Cut at = cut_of(cells, surface, pieces.fall(piece));
            for (const Cell& cell : cells) sign[cell.vertex] += at.is_before(cell);
        }
        pieces = Pieces(grid, sign, fall);
        pieces.join(least_cells);
    }

    ReleaseAreas found{std::vector<int>(size), {}};
    struct Sums {
        ReleaseArea area;
        glm::dvec2 fall{0};
        double cells = 0;
        std::size_t first = 0;  // vertex
    };
    std::map<int, Sums> sums;
    each_vertex([&](int x, int y, std::size_t i) {
        const int piece = pieces.of(i);
        if (piece < 0 || pieces.cells(piece) < least_cells) return;
        const auto [at, is_new] = sums.try_emplace(piece);
        Sums& sum = at->second;
        ReleaseArea& area = sum.area;
        const double height = surface[i], slope = shapes[i].slope();
        if (is_new) sum.first = i, area.lowest = area.highest = height;
        ++sum.cells, sum.fall += fall[i];
        area.area_on_slope += grid.cell_area() / normals[i].z;
        area.slope += slope, area.favour += favour_of(slope, ruggedness[i]);
        area.lowest = std::min(area.lowest, height), area.highest = std::max(area.highest, height);
        area.middle.x += x * static_cast<double>(grid.dx), area.middle.y += y * static_cast<double>(grid.dx);
    });
    std::vector<std::pair<int, Sums>> order(sums.begin(), sums.end());
    std::ranges::sort(order, [](const auto& a, const auto& b) {
        return std::pair(b.second.cells, a.second.first) < std::pair(a.second.cells, b.second.first);
    });
    std::map<int, int> number;
    for (auto& [piece, sum] : order) {
        ReleaseArea& area = sum.area;
        area.area = sum.cells * grid.cell_area();
        area.slope /= sum.cells, area.favour /= sum.cells;
        area.middle.x /= sum.cells, area.middle.y /= sum.cells;
        const double aspect = std::atan2(sum.fall.x, sum.fall.y) * kDegrees;
        area.aspect = aspect < 0 ? aspect + 360 : aspect;
        found.areas.push_back(area);
        number[piece] = static_cast<int>(found.areas.size());
    }
    for (std::size_t i = 0; i < size; ++i)
        if (const auto at = number.find(pieces.of(i)); at != number.end()) found.number[i] = at->second;
    return found;
}

}  // namespace terrains
