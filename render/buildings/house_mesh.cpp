#include "render/buildings/house_mesh.h"

#include <algorithm>
#include <cmath>

#include "assets/shaders/slots.glsl"

namespace render {
namespace {

// Windows in a row on a wall.
struct Windows {
    vec3 middle, right;  // of the row; unit vector along it
    int count;
    float apart;                           // m
    float half = 0.55f, half_tall = 0.6f;  // m, of a window
};

template <class Add>
void for_each_window(const Windows& row, const Add& add) {
    const vec3 out = 0.04f * glm::cross(row.right, vec3(0, 0, 1));
    for (int i = 0; i < row.count; ++i)
        add(row.middle + out +
            row.right * (row.apart * (static_cast<float>(i) - 0.5f * static_cast<float>(row.count - 1))));
}

void add_pane(StructureBuilder& into, vec3 middle, vec3 wide, float half_tall, int material) {
    const vec3 tall(0, 0, half_tall);
    into.quad({middle - wide - tall, middle + wide - tall, middle + wide + tall, middle - wide + tall},
              material, 1, 1, -glm::length(wide));
}

void add_windows(const BuildingSite& site, StructureBuilder& into, const Windows& row, int material) {
    for_each_window(row, [&](vec3 middle) {
        into.set_number(
            site.own(500 + static_cast<int>(std::lround(8 * (middle.x + 31 * middle.y + 7 * middle.z)))));
        add_pane(into, middle, row.half * row.right, row.half_tall, material);
    });
}

// A frame is behind its pane, and larger.
void add_frames_and_shutters(StructureBuilder& into, const Windows& row) {
    constexpr float kFrame = 0.09f;  // m
    const vec3 out = 0.02f * glm::cross(row.right, vec3(0, 0, 1));
    for_each_window(row, [&](vec3 middle) {
        add_pane(into, middle - out, (row.half + kFrame) * row.right, row.half_tall + kFrame, BUILT_PLASTER);
        for (const float side : {-1.f, 1.f})
            add_pane(into, middle + side * (row.half + 0.3f) * row.right + out, 0.27f * row.right,
                     row.half_tall, BUILT_DARK);
    });
}

// A gable roof, m: half of the house's width and length, and heights.
struct Gable {
    float wide, long_, eave, ridge;
    float over = 0.9f, over_end = 1.1f;  // that it juts out
    int material = BUILT_ROOF;
};

// One side of a roof, from a share of its length to another, with the snow on it. `side`: −1 left, 1 right.
void add_roof(const BuildingSite& site, StructureBuilder& into, const Gable& roof, float side, float from,
              float to) {
    constexpr float kThick = 0.22f;
    const float slope = (roof.ridge - roof.eave) / roof.wide;
    const auto low = [&](float share, float in) {
        const float y = std::lerp(-roof.long_ - roof.over_end, roof.long_ + roof.over_end, share);
        const float x = std::lerp(roof.wide + roof.over, 0.f, in);
        return vec3(side * x, y, roof.ridge - slope * x);
    };
    const auto slab = [&](float first, float last, float rise, float thick, int material) {
        const vec3 up(0, 0, rise);
        // Counterclockwise on either side.
        const float one = side > 0 ? first : last, other = side > 0 ? last : first;
        into.prism({low(one, 0) + up, low(other, 0) + up, low(other, 1) + up, low(one, 1) + up},
                   {0, 0, thick}, material, material == BUILT_SNOW ? material : BUILT_WOOD);
    };
    slab(from, to, 0, kThick, roof.material);
    const float snow = std::min(0.15f + 0.4f * site.snow(), 0.75f);
    const float margin = 0.012f;
    // One that fell has shed most of it.
    if (site.state() == StructureState::kDestroyed) to = std::lerp(from, to, site.between(0.25f, 0.6f, 68));
    if (site.snow() > 0.1f) slab(std::max(from, margin), std::min(to, 1 - margin), kThick, snow, BUILT_SNOW);
}

}  // namespace

// A heap of beams and boards that drift downhill and rest on whatever lies there now.
void add_debris(const BuildingSite& site, StructureBuilder& into, int beams, float reach, float longest) {
    for (int i = 0; i < beams; ++i) {
        const int kind = 100 + 8 * i;
        const float away = reach * std::sqrt(site.own(kind)), angle = 6.2832f * site.own(kind + 1);
        const vec3 middle = site.pose().origin + away * vec3(std::cos(angle), std::sin(angle), 0) +
                            site.downhill() * (0.8f * reach * site.own(kind + 2));
        Pose pose{glm::mat3(1), vec3(glm::vec2(middle), 0)};
        pose = pose.turned({0, 0, 1}, 6.2832f * site.own(kind + 3));
        pose = pose.turned(pose.axes[0], site.between(-0.5f, 0.5f, kind + 4));
        pose.origin.z = site.surface().height(glm::vec2(middle)) + site.between(-0.1f, 0.5f, kind + 5);
        StructureBuilder beam = into.in(pose);
        beam.rest_on(glm::vec2(middle), site.surface());
        const bool board = site.own(kind + 6) < 0.35f;
        const float half = 0.5f * longest * site.between(0.4f, 1, kind + 7);
        beam.box({0, 0, 0}, board ? vec3(0.7f, half, 0.06f) : vec3(0.14f, half, 0.14f),
                 board ? BUILT_ROOF : BUILT_WOOD);
    }
}

void add_station_windows(const BuildingSite& site, StructureBuilder& into, vec3 middle, vec3 right) {
    add_windows(site, into, {middle, right, 2, 3}, BUILT_WINDOW);
}

namespace {

// How a house of a material looks.
struct HouseStyle {
    int wall, base, roof, rubble;
    float base_high;  // m
    bool flat;        // roof
    float apart;      // windows, m
    float half, half_tall;
};

HouseStyle style_of(HouseMaterial material) {
    switch (material) {
        case HouseMaterial::kGlass:
            return {BUILT_GLASS, BUILT_STONE, BUILT_GLASS, BUILT_GLASS, 0.3f, false, 0, 0, 0};
        case HouseMaterial::kWood:
            return {BUILT_WOOD, BUILT_STONE, BUILT_ROOF, BUILT_WOOD, 0.9f, false, 2.6f, 0.55f, 0.6f};
        case HouseMaterial::kBrick:
            return {BUILT_PLASTER, BUILT_STONE, BUILT_TILE, BUILT_BRICK, 0.7f, false, 2.9f, 0.6f, 0.8f};
        case HouseMaterial::kConcrete:
            break;
    }
    return {BUILT_CONCRETE, BUILT_CONCRETE, BUILT_CONCRETE, BUILT_CONCRETE, 0.5f, true, 3.6f, 1.35f, 0.65f};
}

// One of its four walls: upright, from one corner to the next, counterclockwise as seen from above.
struct Wall {
    vec3 from, to;
    float length() const { return glm::distance(from, to); }
    vec3 right() const { return glm::normalize(to - from); }
    vec3 out() const { return glm::cross(right(), vec3(0, 0, 1)); }
};

// A house of any size in its own axes: its roof's ridge along y.
class House {
  public:
    House(const BuildingSite& site, std::vector<StructureVertex>& faces, bool simple)
        : site_(site),
          style_(style_of(site.structure().material)),
          glass_(site.structure().material == HouseMaterial::kGlass),
          simple_(simple),
          in_(faces, pose_along_ridge(site), site.own(0)) {
        const glm::dvec2 half = half_footprint(site.structure());
        long_ = static_cast<float>(std::max(half.x, half.y));
        wide_ = static_cast<float>(std::min(half.x, half.y));
        high_ = static_cast<float>(height_of(site.structure()));
        base_ = std::min(style_.base_high, 0.3f * high_);
        low_ = site.lowest() - 1.5f;
        // Far down a slope there are storeys below the floor.
        if (style_.wall == BUILT_PLASTER && low_ < -kStorey) style_.base = BUILT_PLASTER;
        eave_ = style_.flat ? high_ : std::max(high_ - std::min(0.5f * wide_, 0.42f * high_), base_ + 1);
        const vec3 corners[] = {
            {-wide_, -long_, 0}, {wide_, -long_, 0}, {wide_, long_, 0}, {-wide_, long_, 0}};
        for (std::size_t i = 0; i < 4; ++i) walls_[i] = {corners[i], corners[(i + 1) % 4]};
    }

    void add(OpenPart& part) {
        if (site_.state() == StructureState::kDestroyed) {
            add_ruin();
            return;
        }
        add_walls();
        add_top();
        if (site_.state() == StructureState::kDamaged) {
            add_wounds();
            add_heap(simple_ ? kSimpleHeap : 14 + static_cast<int>(std::min(area() / 10, 36.f)), 1.5f, 4,
                     style_.wall == BUILT_WOOD ? 0 : 0.5f);
        }
        part.begin_details();
        add_details();
    }

  private:
    static Pose pose_along_ridge(const BuildingSite& site) {
        Pose pose = site.pose();
        const glm::dvec2 half = half_footprint(site.structure());
        if (half.y > half.x) pose.axes = glm::mat3(-pose.axes[1], pose.axes[0], pose.axes[2]);
        return pose;
    }
    // How far the base juts out, m.
    float base_out() const { return style_.base == style_.wall ? 0.f : 0.1f; }
    bool whole() const { return site_.state() == StructureState::kIntact; }
    float area() const { return 4 * long_ * wide_; }
    Gable gable() const {
        const float over = std::min(0.9f, 0.25f * wide_);
        return {wide_, long_, eave_, high_ - 0.22f, over, over + 0.1f, style_.roof};
    }
    // Height of the ground or of the snow before a wall, m.
    float ground_before(const Wall& wall) const {
        float highest = -1e6f;
        for (const float share : {0.1f, 0.5f, 0.9f}) {
            const vec3 at = in_.pose().at(glm::mix(wall.from, wall.to, share) + 0.5f * wall.out());
            highest = std::max(highest, site_.surface().height(glm::vec2(at)));
        }
        return highest - in_.pose().origin.z;
    }

    void add_walls() {
        const float out = base_out();
        in_.box({0, 0, (base_ + low_) / 2}, {wide_ + out, long_ + out, (base_ - low_) / 2}, style_.base);
        for (const Wall& wall : walls_) {
            const vec3 a = wall.from + vec3(0, 0, base_), b = wall.to + vec3(0, 0, base_),
                       up(0, 0, eave_ - base_);
            in_.quad({a, b, b + up, a + up}, style_.wall, 1, style_.flat ? 0.9f : 0.62f);
        }
        if (!style_.flat)
            for (const float end : {-1.f, 1.f})
                in_.triangle({-end * wide_, end * long_, eave_}, {0, end * long_, gable().ridge + 0.1f},
                             {end * wide_, end * long_, eave_}, style_.wall);
        if (glass_) return;
        const auto add = [&](const Windows& row) {
            add_windows(site_, in_, row, whole() ? BUILT_WINDOW : BUILT_DARK);
        };
        for (const Wall& wall : walls_) for_each_row(wall, add);
        for_each_row_of_attic(add);
    }

    // Windows under both gables, where these are high enough.
    template <class Add>
    void for_each_row_of_attic(const Add& add) const {
        const float high = high_ - eave_, half_tall = std::min(0.24f * high, 0.55f);
        if (style_.flat || high < 1.7f) return;
        for (const float end : {-1.f, 1.f})
            add({{0, end * long_, eave_ + 0.36f * high},
                 {-end, 0, 0},
                 wide_ > 3.5f ? 2 : 1,
                 0.62f * wide_,
                 0.8f * half_tall,
                 half_tall});
    }

    // Rows of windows, one for each storey that looks out of the ground.
    template <class Add>
    void for_each_row(const Wall& wall, const Add& add) const {
        const int most = simple_ ? 4 : 12;
        const int across = std::min(static_cast<int>((wall.length() - 1) / style_.apart), most);
        if (across < 1) return;
        const float apart = wall.length() / (static_cast<float>(across) + 0.35f);
        const float half = std::min(style_.half * apart / style_.apart, 2.5f);
        const int storeys =
            std::clamp(static_cast<int>(std::lround((eave_ - base_) / kStorey)), 1, simple_ ? 2 : 10);
        const float storey = (eave_ - base_) / static_cast<float>(storeys), sill = 0.52f * storey;
        const float from = ground_before(wall);
        for (int k = static_cast<int>(std::floor(low_ / storey)); k < storeys; ++k) {
            const float z = base_ + sill + storey * static_cast<float>(k);
            if (z - style_.half_tall < from + 0.2f || z + style_.half_tall > eave_ - 0.15f) continue;
            const vec3 out = k < 0 ? base_out() * wall.out() : vec3(0);
            add({0.5f * (wall.from + wall.to) + out + vec3(0, 0, z), wall.right(), across, apart, half,
                 style_.half_tall});
        }
    }

    void add_top() {
        if (style_.flat) {
            add_flat_top();
            return;
        }
        const Gable roof = gable();
        add_roof(site_, in_, roof, -1, 0, 1);
        add_roof(site_, in_, roof, 1, 0, whole() ? 1 : 0.45f);
        if (!whole()) {
            // Half of one side is gone, and its rafters stand bare.
            const int rafters = std::clamp(static_cast<int>(long_ / 1.4f), 3, 14);
            for (int i = 0; i < rafters; ++i) {
                const float y =
                    std::lerp(0.f, long_ - 0.2f, static_cast<float>(i) / static_cast<float>(rafters - 1));
                const vec3 low(wide_ + 0.5f * roof.over, y, eave_ - 0.25f), ridge(0, y, roof.ridge - 0.05f),
                    thick(0, 0.16f, 0);
                if (site_.own(40 + i) > 0.25f)
                    in_.prism({low, low + thick, ridge + thick, ridge}, {0, 0, 0.2f},
                              glass_ ? BUILT_STEEL : BUILT_WOOD, glass_ ? BUILT_STEEL : BUILT_WOOD);
            }
        }
        if (!glass_ && wide_ > 2.5f)
            in_.box({-0.4f * wide_, -0.35f * long_, roof.ridge - 0.3f}, {0.45f, 0.45f, 1.1f}, style_.base);
    }

    void add_flat_top() {
        constexpr float kThick = 0.35f;
        const float snow = std::min(0.1f + 0.4f * site_.snow(), 0.7f);
        // What is gone of it: a corner.
        const float hole_x = 0.15f * wide_, hole_y = 0.2f * long_;
        const auto slab = [&](float x0, float x1, float y0, float y1) {
            const float x = 0.5f * (x0 + x1), y = 0.5f * (y0 + y1), z = high_ - kThick / 2;
            in_.box({x, y, z}, {0.5f * (x1 - x0) + 0.25f, 0.5f * (y1 - y0) + 0.25f, kThick / 2},
                    BUILT_CONCRETE);
            if (site_.snow() > 0.1f)
                in_.box({x, y, high_ + snow / 2},
                        {0.5f * (x1 - x0) - 0.1f, 0.5f * (y1 - y0) - 0.1f, snow / 2}, BUILT_SNOW);
        };
        if (whole()) {
            slab(-wide_, wide_, -long_, long_);
        } else {
            in_.quad({vec3(hole_x, hole_y, high_ - 1.2f), vec3(wide_, hole_y, high_ - 1.2f),
                      vec3(wide_, long_, high_ - 1.2f), vec3(hole_x, long_, high_ - 1.2f)},
                     BUILT_DARK);
            slab(-wide_, hole_x, -long_, long_);
            slab(hole_x, wide_, -long_, hole_y);
        }
        in_.box({-0.35f * wide_, -0.3f * long_, high_ + 1.1f},
                {std::min(1.6f, 0.4f * wide_), std::min(2.f, 0.4f * long_), 1.1f}, BUILT_CONCRETE);
    }

    // Cracks, and where walls lost their plaster, boards or panes.
    void add_wounds() {
        for (std::size_t i = 0; i < 4; ++i) {
            const Wall& wall = walls_[i];
            const int kind = 600 + 40 * static_cast<int>(i);
            const int patches = glass_ ? 5 : 2;
            const float low = std::max(base_, ground_before(wall));
            if (low > eave_ - 1) continue;
            for (int k = 0; k < patches; ++k) {
                const float half = std::min(site_.between(0.5f, 1.5f, kind + 4 * k), 0.2f * wall.length()),
                            tall =
                                std::min(site_.between(0.5f, 1.3f, kind + 4 * k + 1), 0.3f * (eave_ - low));
                add_patch(wall, std::lerp(0.12f, 0.88f, site_.own(kind + 4 * k + 2)),
                          std::lerp(low + tall, eave_ - tall, site_.own(kind + 4 * k + 3)), half, tall);
            }
            if (!simple_ && (style_.wall == BUILT_PLASTER || style_.wall == BUILT_CONCRETE))
                for (int k = 0; k < 3; ++k) add_crack(wall, low, kind + 20 + 6 * k);
        }
    }
    // A ragged hole of six corners.
    void add_patch(const Wall& wall, float share, float z, float half, float tall) {
        const vec3 middle = glm::mix(wall.from, wall.to, share) + vec3(0, 0, z) + 0.05f * wall.out();
        const int material = style_.wall == BUILT_PLASTER ? BUILT_BRICK : BUILT_DARK;
        const auto corner = [&](int i) {
            const float angle = 6.2832f * static_cast<float>(i) / 6;
            const float far = 0.65f + 0.35f * std::fmod(7.31f * static_cast<float>(i) + 3 * share, 1.f);
            return middle + wall.right() * (half * far * std::cos(angle)) +
                   vec3(0, 0, tall * far * std::sin(angle));
        };
        for (int i = 0; i < 6; ++i) in_.triangle(middle, corner(i), corner((i + 1) % 6), material);
    }
    // From the eave down, in steps to either side.
    void add_crack(const Wall& wall, float low, int kind) {
        constexpr int kSteps = 6;
        float along = std::lerp(0.1f, 0.9f, site_.own(kind)) * wall.length(), z = eave_ - 0.05f;
        const float step = (eave_ - low) * site_.between(0.5f, 1, kind + 1) / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            const float aside = step * (2 * site_.own(kind + 200 + i) - 1),
                        half = 0.09f - 0.012f * static_cast<float>(i);
            const auto at = [&](float x, float up) {
                return wall.from + wall.right() * std::clamp(x, 0.1f, wall.length() - 0.1f) + vec3(0, 0, up) +
                       0.045f * wall.out();
            };
            in_.quad({at(along + aside - half, z - step), at(along + aside + half, z - step),
                      at(along + half, z), at(along - half, z)},
                     BUILT_DARK);
            along += aside, z -= step;
        }
    }

    // Stumps of walls and, on level ground, the base; a heap of what they were made of.
    void add_ruin() {
        constexpr float kLevel = -3.5f;
        if (low_ > kLevel)
            in_.box({0, 0, (0.3f + low_) / 2}, {wide_ + 0.1f, long_ + 0.1f, (0.3f - low_) / 2}, style_.base);
        const bool masonry = style_.rubble == BUILT_BRICK || style_.rubble == BUILT_CONCRETE;
        if (masonry)
            for (const Wall& wall : walls_) add_stump(wall);
        add_heap(simple_ ? kSimpleHeap : std::clamp(static_cast<int>(area() / 2), 34, 260), 1.15f,
                 std::clamp(0.6f * wide_, 3.f, 9.f), masonry ? 0.75f : 0);
        if (!style_.flat && !glass_) {
            add_fallen_roof(-1, 0, 1, 0.2f, -0.1f);
            add_fallen_roof(1, site_.between(0, 0.3f, 60), site_.between(0.6f, 1, 61), 0.9f, -0.8f);
        }
    }
    // One side of the roof, from one share of its length to another, on the heap: as far downhill as this share of half the
    // width, and with its eave as high above the ground, m.
    void add_fallen_roof(float side, float from, float to, float downhill, float high) {
        Pose pose = in_.pose();
        const vec3 moved = site_.downhill() * (downhill * wide_);
        pose.origin += moved;
        pose = pose.turned({0, 0, 1}, site_.between(-0.3f, 0.3f, side < 0 ? 62 : 63));
        pose = pose.turned(pose.axes[1], side * site_.between(0.05f, 0.25f, side < 0 ? 64 : 65));
        pose = pose.turned(pose.axes[0], site_.between(-0.12f, 0.12f, side < 0 ? 66 : 67));
        const glm::vec2 at(pose.origin);
        pose.origin.z = site_.surface().height(at) + high - eave_;
        StructureBuilder roof = in_.in(pose);
        roof.rest_on(at, site_.surface());
        add_roof(site_, roof, gable(), side, from, to);
    }
    // What is left of a wall: pieces of different heights.
    void add_stump(const Wall& wall) {
        const int pieces = std::clamp(static_cast<int>(wall.length() / 2.2f), 2, simple_ ? 3 : 12);
        for (int i = 0; i < pieces; ++i) {
            const int kind = 900 + i + static_cast<int>(17 * wall.from.x + 5 * wall.from.y);
            const float high = std::min(0.45f * high_, 3.5f) * std::pow(site_.own(kind), 1.7f);
            if (high < 0.35f) continue;
            const auto at = [&](int k) {
                const vec3 place =
                    glm::mix(wall.from, wall.to, static_cast<float>(k) / static_cast<float>(pieces));
                const float ground =
                    site_.surface().bedrock(glm::vec2(in_.pose().at(place))) - in_.pose().origin.z;
                return vec3(place.x, place.y, ground - 0.5f);
            };
            const vec3 a = at(i), b = at(i + 1), in = -0.35f * wall.out();
            in_.prism({a, b, b + in, a + in}, {0, 0, high + 0.5f}, style_.rubble, style_.wall);
        }
    }

    // Pieces on the footprint, times `spread`, and downhill of it, which rest on whatever lies there now. `blocks`: share
    // of them that are blocks of wall, not beams.
    void add_heap(int pieces, float spread, float longest, float blocks) {
        const int beam = glass_ ? BUILT_STEEL : style_.flat ? BUILT_CONCRETE : BUILT_WOOD;
        for (int i = 0; i < pieces; ++i) {
            const int kind = 2000 + 10 * i;
            const vec3 on(spread * wide_ * (2 * site_.own(kind) - 1),
                          spread * long_ * (2 * site_.own(kind + 1) - 1), 0);
            const vec3 middle = in_.pose().at(on) +
                                site_.downhill() * (0.7f * wide_ * site_.own(kind + 2) * site_.own(kind + 8));
            const float inward = 1 - std::max(std::abs(on.x) / wide_, std::abs(on.y) / long_);
            Pose pose{glm::mat3(1), vec3(glm::vec2(middle), 0)};
            pose = pose.turned({0, 0, 1}, 6.2832f * site_.own(kind + 3));
            pose = pose.turned(pose.axes[0], site_.between(-0.5f, 0.5f, kind + 4));
            pose.origin.z = site_.surface().height(glm::vec2(middle)) + site_.between(-0.1f, 0.5f, kind + 5) +
                            std::max(inward, 0.f) * std::min(0.3f * high_, 3.f) * site_.own(kind + 9);
            StructureBuilder piece = in_.in(pose);
            piece.rest_on(glm::vec2(middle), site_.surface());
            const float size = site_.between(0.4f, 1, kind + 7);
            if (site_.own(kind + 6) < blocks) {
                const float half = 0.16f * longest * size + 0.2f;
                piece.box({0, 0, 0}, {half, 1.3f * half, 0.35f * half + 0.1f},
                          site_.own(kind + 8) < 0.35f ? style_.wall : style_.rubble);
            } else if (glass_ ? site_.own(kind + 6) < 0.6f : site_.own(kind + 6) > 0.7f) {
                piece.box({0, 0, 0}, {0.6f * size, 0.8f * size, 0.04f}, glass_ ? BUILT_GLASS : style_.roof);
            } else {
                piece.box({0, 0, 0}, {0.13f, 0.5f * longest * size, 0.13f}, beam);
            }
        }
    }

    void add_details() {
        if (glass_) {
            add_frame();
            return;
        }
        if (whole() && !style_.flat && !simple_)
            for (const Wall& wall : walls_)
                for_each_row(wall, [&](const Windows& row) { add_frames_and_shutters(in_, row); });
        // A door in the front.
        const Wall& front = walls_[site_.structure().width_m > site_.structure().length_m ? 1 : 2];
        const float door = std::min(2.1f, eave_ - base_ - 0.2f);
        int across = 0;  // windows beside which it is
        float apart = 0;
        for_each_row(front, [&](const Windows& row) { across = row.count, apart = row.apart; });
        const float aside = across % 2 == 1 && across > 1 ? 0.5f * apart : 0;
        const vec3 at = glm::mix(front.from, front.to, 0.5f) + aside * front.right() + vec3(0, 0, base_) +
                        0.05f * front.out(),
                   half = std::min(0.5f, 0.2f * front.length()) * front.right(), up(0, 0, door);
        in_.quad({at - half, at + half, at + half + up, at - half + up}, BUILT_DARK);
        if (style_.wall != BUILT_WOOD || long_ > 9 || eave_ - base_ < 4.2f) return;
        // A balcony under the gable.
        in_.box({0, long_ + 0.6f, base_ + 2.6f}, {0.95f * wide_, 0.6f, 0.08f}, BUILT_WOOD);
        in_.box({0, long_ + 1.15f, base_ + 3.1f}, {0.95f * wide_, 0.05f, 0.35f}, BUILT_WOOD);
    }
    // Posts and beams that hold panes.
    void add_frame() {
        for (const Wall& wall : walls_) {
            const int posts = std::clamp(static_cast<int>(wall.length() / 1.5f), 1, simple_ ? 4 : 20);
            for (int i = 0; i <= posts; ++i) {
                const vec3 at =
                    glm::mix(wall.from, wall.to, static_cast<float>(i) / static_cast<float>(posts));
                in_.box(at + vec3(0, 0, 0.5f * (base_ + eave_)), {0.06f, 0.06f, 0.5f * (eave_ - base_)},
                        BUILT_STEEL);
            }
        }
    }

    static constexpr float kStorey = 2.9f;  // m
    static constexpr int kSimpleHeap = 8;   // pieces

    const BuildingSite& site_;
    HouseStyle style_;
    bool glass_, simple_;
    StructureBuilder in_;
    float long_ = 0, wide_ = 0;  // half of each, m
    float high_ = 0, base_ = 0, low_ = 0, eave_ = 0;
    std::array<Wall, 4> walls_;
};

}  // namespace

void add_house(const BuildingSite& site, std::vector<StructureVertex>& faces, OpenPart& part, bool simple) {
    House(site, faces, simple).add(part);
}

}  // namespace render
