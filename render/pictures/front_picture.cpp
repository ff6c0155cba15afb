#include "render/pictures/front_picture.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "render/pictures/sheet.h"

namespace render {
namespace {

using sim::front::Mesh;

// The palette of Okabe and Ito, which colour-blind people can distinguish.
constexpr glm::vec3 kEdge{196, 196, 196}, kCut{253, 231, 196}, kFront{0, 114, 178}, kPoint{213, 94, 0};
constexpr float kMargin = 16;  // pixels

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
    // A front runs from point to point within a triangle. Three points are joined through their mean.
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
