#include "game/ui/label_layout.h"

#include <algorithm>
#include <utility>

#include <glm/vec2.hpp>

namespace game::ui {
namespace {

using Label = LabelLayout::Label;

// Where a plate may stand, the best first: all sides near its place, then farther away.
constexpr std::array<glm::vec2, 8> kSides{
    {{0.8f, -0.6f}, {-0.8f, -0.6f}, {1, 0}, {-1, 0}, {0.8f, 0.6f}, {-0.8f, 0.6f}, {0, -1}, {0, 1}}};
constexpr std::array<float, 4> kAway{2, 4, 6.5f, 10};  // em
constexpr std::uint8_t kStands = kSides.size() * kAway.size();

// How far an edge lies from a middle, in sides of a plate: 0 if the plate lies toward that side of it.
float share_before(float side) {
    return side > 0 ? 0 : side < 0 ? 1 : 0.5f;
}

Box plate_at(const Label& label, std::uint8_t stand, float em) {
    const glm::vec2 side = kSides[stand % kSides.size()];
    const float away = kAway[stand / kSides.size()] * em;
    const ImVec2 from{label.at.x + away * side.x - share_before(side.x) * label.size.x,
                      label.at.y + away * side.y - share_before(side.y) * label.size.y};
    return {from, {from.x + label.size.x, from.y + label.size.y}};
}

Box widened(const Box& box, float by) {
    return {{box.from.x - by, box.from.y - by}, {box.to.x + by, box.to.y + by}};
}

bool is_inside(const Box& box, const Box& room) {
    return contains(room, box.from) && contains(room, box.to);
}

ImVec2 nearest_on(const Box& box, ImVec2 point) {
    return {std::clamp(point.x, box.from.x, box.to.x), std::clamp(point.y, box.from.y, box.to.y)};
}

// Whether a line passes through a box: the part of it between each pair of edges is cut out (Liang and Barsky, 1984).
bool passes(ImVec2 from, ImVec2 to, const Box& box) {
    float first = 0, last = 1;
    const auto cut = [&](float start, float step, float least, float most) {
        if (step == 0) return least <= start && start <= most;
        const float one = (least - start) / step, other = (most - start) / step;
        first = std::max(first, std::min(one, other)), last = std::min(last, std::max(one, other));
        return first <= last;
    };
    return cut(from.x, to.x - from.x, box.from.x, box.to.x) &&
           cut(from.y, to.y - from.y, box.from.y, box.to.y);
}

float turn(ImVec2 a, ImVec2 b, ImVec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross(const Label& one, const Label& other) {
    const auto parts = [](const Label& line, const Label& points) {
        return turn(line.at, line.line_end, points.at) * turn(line.at, line.line_end, points.line_end) < 0;
    };
    return parts(one, other) && parts(other, one);
}

// Whether a label at its plate leaves the others their room.
bool fits(const Label& label, std::span<const Label> labels, const Box& room, std::span<const Box> taken,
          float em) {
    const Box around = widened(label.plate, 0.3f * em);
    if (!is_inside(label.plate, room)) return false;
    if (std::ranges::any_of(taken, [&](const Box& box) {
            return overlap(around, box) || passes(label.at, label.line_end, box);
        }))
        return false;
    return std::ranges::none_of(labels, [&](const Label& other) {
        if (&other == &label) return false;
        if (contains(around, other.at)) return true;
        return other.has_room &&
               (overlap(around, other.plate) || passes(label.at, label.line_end, other.plate) ||
                passes(other.at, other.line_end, around) || cross(label, other));
    });
}

}  // namespace

bool overlap(const Box& one, const Box& other) {
    return one.from.x < other.to.x && other.from.x < one.to.x && one.from.y < other.to.y &&
           other.from.y < one.to.y;
}

bool contains(const Box& box, ImVec2 point) {
    return box.from.x <= point.x && point.x <= box.to.x && box.from.y <= point.y && point.y <= box.to.y;
}

void LabelLayout::lay(std::span<Label> labels, const Box& room, std::span<const Box> taken, float em) {
    const auto before = std::exchange(side_, {});
    for (Label& label : labels) label.has_room = false;
    for (Label& label : labels) {
        if (!contains(room, label.at) ||
            std::ranges::any_of(taken, [&](const Box& box) { return contains(box, label.at); }))
            continue;
        const auto try_stand = [&](std::uint8_t stand) {
            label.plate = plate_at(label, stand, em);
            label.line_end = nearest_on(label.plate, label.at);
            label.has_room = fits(label, labels, room, taken, em);
            if (label.has_room) side_[label.key] = stand;
            return label.has_room;
        };
        if (before[label.key] && try_stand(*before[label.key])) continue;
        for (std::uint8_t stand = 0; stand < kStands && !try_stand(stand); ++stand) {
        }
    }
}

}  // namespace game::ui
