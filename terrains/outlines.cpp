#include "terrains/outlines.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "terrains/plane_transform.h"
#include "terrains/well_known_text.h"

namespace terrains {

std::vector<int> patches_of(const sim::Grid& grid, std::span<const int> sign) {
    const auto nx = static_cast<std::size_t>(grid.nx);
    std::vector<int> patch(grid.size());
    std::vector<std::size_t> open;
    int count = 0;
    for (std::size_t first = 0; first < patch.size(); ++first) {
        if (sign[first] < 0 || patch[first] != 0) continue;
        const auto take = [&](std::size_t vertex) {
            if (patch[vertex] != 0 || sign[vertex] != sign[first]) return;
            patch[vertex] = count;
            open.push_back(vertex);
        };
        ++count;
        for (take(first); !open.empty();) {
            const std::size_t here = open.back(), x = here % nx;
            open.pop_back();
            if (x > 0) take(here - 1);
            if (x + 1 < nx) take(here + 1);
            if (here >= nx) take(here - nx);
            if (here + nx < patch.size()) take(here + nx);
        }
    }
    return patch;
}

namespace {

// Corners of cells: corner (x, y) is the south-west corner of the cell of vertex (x, y).
struct Corner {
    int x = 0, y = 0;
    bool operator==(const Corner&) const = default;
};
using Ring = std::vector<Corner>;  // closed: the first corner again at the end

class Patches {
  public:
    // `patch`: of each vertex its number, from 1 and none left out, or 0.
    Patches(const sim::Grid& grid, std::span<const int> patch)
        : grid_(grid), patch_(patch), count_(patch.empty() ? 0 : std::ranges::max(patch)) {}

    // Rings of every patch: the outer one first, counter-clockwise (inside on the left), then holes
    // clockwise.
    std::vector<std::vector<Ring>> rings() const;

  private:
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * grid_.nx + x; }
    int patch(int x, int y) const { return grid_.contains(x, y) ? patch_[at(x, y)] : 0; }
    Ring trace(int patch_number, Corner start, std::vector<bool>& done) const;

    const sim::Grid& grid_;
    std::span<const int> patch_;
    int count_;
};

// Follows a patch's border with the patch on the left, from a corner where the border runs east. Where two
// cells of the patch touch only in a corner, one side of them is a hole. Turning right there keeps the hole's
// ring apart from the outer one, so that no ring touches itself.
Ring Patches::trace(int patch_number, Corner start, std::vector<bool>& done) const {
    constexpr int kStepX[] = {1, 0, -1, 0}, kStepY[] = {0, 1, 0, -1};  // east, north, west, south
    // Cells to the left and right of the side that leaves a corner in a direction.
    constexpr int kLeftX[] = {0, -1, -1, 0}, kLeftY[] = {0, 0, -1, -1};
    constexpr int kRightX[] = {0, 0, -1, -1}, kRightY[] = {-1, 0, 0, -1};
    const auto is_border = [&](Corner c, int d) {
        return patch(c.x + kLeftX[d], c.y + kLeftY[d]) == patch_number &&
               patch(c.x + kRightX[d], c.y + kRightY[d]) != patch_number;
    };
    Ring ring{start};
    Corner corner = start;
    int direction = 0;
    do {
        if (direction == 0) done[at(corner.x, corner.y)] = true;
        corner = {corner.x + kStepX[direction], corner.y + kStepY[direction]};
        int next = (direction + 3) % 4;                                    // right
        if (!is_border(corner, next)) next = direction;                    // straight on
        if (!is_border(corner, next)) next = (direction + 1) % 4;          // left
        if (next != direction || corner == start) ring.push_back(corner);  // only where the ring turns
        direction = next;
    } while (!(corner == start && direction == 0));
    return ring;
}

std::vector<std::vector<Ring>> Patches::rings() const {
    std::vector<std::vector<Ring>> all(static_cast<std::size_t>(count_));
    std::vector<bool> done(grid_.size());
    // Scanning from the south, a patch's first border that runs east is on its outer ring.
    for (int y = 0; y < grid_.ny; ++y)
        for (int x = 0; x < grid_.nx; ++x)
            if (patch(x, y) != 0 && patch(x, y - 1) != patch(x, y) && !done[at(x, y)])
                all[static_cast<std::size_t>(patch(x, y) - 1)].push_back(trace(patch(x, y), {x, y}, done));
    return all;
}

struct Points {
    std::vector<double> x, y;
};

Points on_plane(const Ring& ring, const sim::Grid& grid, const Georeference& place) {
    Points points;
    for (const Corner& corner : ring) {
        points.x.push_back(place.origin_x() + (corner.x - 0.5) * grid.dx);
        points.y.push_back(place.origin_y() + (corner.y - 0.5) * grid.dx);
    }
    return points;
}

std::string ring_text(const Points& points, int decimals) {
    std::string text;
    for (std::size_t i = 0; i < points.x.size(); ++i)
        text += fmt::format("{}[{:.{}f}, {:.{}f}]", i == 0 ? "" : ", ", points.x[i], decimals, points.y[i],
                            decimals);
    return "[" + text + "]";
}

}  // namespace

tl::expected<std::string, std::string> outlines_of(const sim::Grid& grid, const Georeference& georeference,
                                                   std::span<const int> patch,
                                                   std::span<const Properties> properties) {
    const int decimals = georeference.placed() ? 8 : 3;  // one millimetre in both cases
    const auto to_degrees =
        PlaneTransform::between(georeference.placed() ? georeference.wkt() : wgs84_wkt(), wgs84_wkt());
    if (!to_degrees) return tl::unexpected(to_degrees.error());
    const Patches patches(grid, patch);
    std::string features;
    std::size_t number = 0;
    for (const auto& rings : patches.rings()) {
        std::string coordinates;
        double area = 0;
        for (const Ring& ring : rings) {
            for (std::size_t i = 0; i + 1 < ring.size(); ++i)
                area += 0.5 * (static_cast<double>(ring[i].x) * ring[i + 1].y -
                               static_cast<double>(ring[i + 1].x) * ring[i].y);
            Points points = on_plane(ring, grid, georeference);
            if (georeference.placed() && !to_degrees->apply(points.x, points.y))
                return tl::unexpected<std::string>("the outline has points without a position on Earth");
            coordinates += (coordinates.empty() ? "" : ", ") + ring_text(points, decimals);
        }
        std::string more;
        if (number < properties.size())
            for (const auto& [name, value] : properties[number])
                more += fmt::format(", \"{}\": {}", name, value);
        ++number;
        features += fmt::format(
            "{}\n{{ \"type\": \"Feature\", \"properties\": {{ \"area_m2\": {:.1f}{} }}, \"geometry\": {{ "
            "\"type\": "
            "\"Polygon\", \"coordinates\": [{}] }} }}",
            features.empty() ? "" : ",", area * grid.cell_area(), more, coordinates);
    }
    return fmt::format("{{\n\"type\": \"FeatureCollection\",{}\n\"features\": [{}\n]\n}}\n",
                       georeference.placed() ? "" : "\n\"coordinates\": \"local metres\",", features);
}

tl::expected<std::string, std::string> outlines_of(const sim::Grid& grid, const Georeference& georeference,
                                                   std::span<const std::uint8_t> mask) {
    std::vector<int> sign;
    for (const std::uint8_t each : mask) sign.push_back(each != 0 ? 0 : -1);
    return outlines_of(grid, georeference, patches_of(grid, sign), {});
}

}  // namespace terrains
