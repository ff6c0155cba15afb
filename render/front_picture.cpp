#include "render/front_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

// Lines, discs and triangles with soft edges: the library that draws such things (cairo) would be a package
// for this page alone.

namespace render {
namespace {

using sim::front::Mesh;

// Palette of Okabe and Ito, which colour-blind people can read.
constexpr glm::vec3 kEdge{196, 196, 196}, kCut{253, 231, 196}, kFront{0, 114, 178}, kPoint{213, 94, 0};
constexpr float kMargin = 16;  // pixels

class Sheet {
  public:
    Sheet(int width, int height) {
        picture.width = width, picture.height = height;
        picture.pixels.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
    }

    // From p to q, or a disc where they are one; pixels.
    void line(const glm::vec2& p, const glm::vec2& q, float thickness, const glm::vec3& colour) {
        const float reach = thickness / 2 + 1;
        const glm::vec2 along = q - p;
        const float length2 = glm::dot(along, along);
        each_pixel(
            glm::min(p, q) - reach, glm::max(p, q) + reach,
            [&](const glm::vec2& at) {
                const float share =
                    length2 > 0 ? std::clamp(glm::dot(at - p, along) / length2, 0.f, 1.f) : 0.f;
                return thickness / 2 + 0.5f - glm::length(at - p - share * along);
            },
            colour);
    }

    void triangle(const std::array<glm::vec2, 3>& corner, const glm::vec3& colour) {
        const auto side = [](const glm::vec2& from, const glm::vec2& to, const glm::vec2& at) {
            const glm::vec2 along = to - from, away = at - from;
            return (along.x * away.y - along.y * away.x) / glm::length(along);
        };
        const float turn = side(corner[0], corner[1], corner[2]) > 0 ? 1.f : -1.f;
        each_pixel(
            glm::min(corner[0], glm::min(corner[1], corner[2])) - 1.f,
            glm::max(corner[0], glm::max(corner[1], corner[2])) + 1.f,
            [&](const glm::vec2& at) {
                float least = 1;
                for (int k = 0; k < 3; ++k)
                    least = std::min(least, turn * side(corner[k], corner[(k + 1) % 3], at) + 0.5f);
                return least;
            },
            colour);
    }

    Picture picture;

  private:
    // Covers each pixel by what `cover` says of its middle, 0 … 1.
    template <class Cover>
    void each_pixel(const glm::vec2& from, const glm::vec2& to, const Cover& cover, const glm::vec3& colour) {
        const int x0 = std::max(static_cast<int>(from.x), 0), y0 = std::max(static_cast<int>(from.y), 0);
        const int x1 = std::min(static_cast<int>(to.x), picture.width - 1);
        const int y1 = std::min(static_cast<int>(to.y), picture.height - 1);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const glm::vec2 middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                const float share = std::clamp(cover(middle), 0.f, 1.f);
                if (share == 0) continue;
                std::uint8_t* pixel =
                    &picture
                         .pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                      static_cast<std::size_t>(x))];
                for (int c = 0; c < 3; ++c)
                    pixel[c] = static_cast<std::uint8_t>(
                        std::lround(static_cast<float>(pixel[c]) * (1 - share) + colour[c] * share));
            }
    }
};

}  // namespace

Picture front_picture(const sim::front::Tracker& tracker, int width, int height) {
    const Mesh& mesh = tracker.mesh();
    glm::vec2 low(std::numeric_limits<float>::infinity()), high = -low;
    for (const glm::vec2& position : mesh.position)
        low = glm::min(low, position), high = glm::max(high, position);
    const glm::vec2 room(static_cast<float>(width) - 2 * kMargin, static_cast<float>(height) - 2 * kMargin);
    const glm::vec2 extent = glm::max(high - low, glm::vec2(1e-30f));
    const float scale = std::min(room.x / extent.x, room.y / extent.y);  // pixels per metre
    const glm::vec2 middle = 0.5f * (low + high);
    const auto on_sheet = [&](const glm::vec2& position) {
        const glm::vec2 from = (position - middle) * scale;
        return glm::vec2(static_cast<float>(width) / 2 + from.x, static_cast<float>(height) / 2 - from.y);
    };

    Sheet sheet(width, height);
    const auto& detector = tracker.detector();
    const auto points = tracker.points();
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
        const auto& edges = mesh.triangle_edge[t];
        if (std::none_of(edges.begin(), edges.end(), [&](int e) { return detector.is_cut(e); })) continue;
        const auto& [a, b, c] = mesh.triangle[t];
        sheet.triangle({on_sheet(mesh.position[a]), on_sheet(mesh.position[b]), on_sheet(mesh.position[c])},
                       kCut);
    }
    for (const auto& [a, b] : mesh.edge)
        sheet.line(on_sheet(mesh.position[a]), on_sheet(mesh.position[b]), 1, kEdge);
    // A front runs from point to point within a triangle; of three, through their mean.
    for (const auto& edges : mesh.triangle_edge) {
        std::array<glm::vec2, 3> at;
        int count = 0;
        for (const int e : edges)
            if (detector.is_cut(e)) at[count++] = on_sheet(tracker.position(points[detector.slot(e)]));
        if (count == 2) sheet.line(at[0], at[1], 3, kFront);
        if (count == 3)
            for (const glm::vec2& end : at) sheet.line((at[0] + at[1] + at[2]) / 3.f, end, 3, kFront);
    }
    for (const auto& point : points) {
        const glm::vec2 at = on_sheet(tracker.position(point));
        sheet.line(at, at, 6, kPoint);
    }
    return std::move(sheet.picture);
}

}  // namespace render
