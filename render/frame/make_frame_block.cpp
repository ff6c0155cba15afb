#include "render/frame/make_frame_block.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/base/ramp.h"
#include "render/mountain/ground_mesh.h"
#include "render/view/sky_light.h"

namespace render {
namespace {

static_assert(OVERLAY_SLOPE == static_cast<int>(Overlay::kSlope));
static_assert(OVERLAY_STANDING == static_cast<int>(Overlay::kStanding));
static_assert(OVERLAY_ROLLING == static_cast<int>(Overlay::kRolling));
static_assert(OVERLAY_SPEED == static_cast<int>(Overlay::kSpeed));
static_assert(OVERLAY_STRETCH == static_cast<int>(Overlay::kStretch));
static_assert(OVERLAY_PRESSURE == static_cast<int>(Overlay::kPressure));
static_assert(OVERLAY_PROBABILITY == static_cast<int>(Overlay::kProbability));
static_assert(OVERLAY_WATER == static_cast<int>(Overlay::kWater));

constexpr double kWidestDetail = 600;    // m, least width of a tile of the broadest detail
constexpr double kWidestFlowTile = 130;  // m; the largest blocks on it are some 7 m
// Detail that moves is as fine as that of samples so many times as high: of twice as high it would be soft, beside the same
// ground at rest.
constexpr float kCoarser = 1.3f;
constexpr double kFinishedRows = 1440;  // samples, of a finished image of 1280×720 pixels
constexpr double kMostCoarse =
    1.5;  // levels of detail that a coarser image is coarser, at most: beyond, cover would not cover as much
constexpr double kHazeLength = 24000;  // m, in which clear mountain air keeps 1/e of green light
constexpr double kWideView =
    3000;  // m, side of a terrain from which on the air is drawn clearer in proportion
constexpr double kHighestLamp = 89;  // degrees; at 90 there is no horizontal direction to sweep along
constexpr double kLowestLamp = 1;    // degrees; below it a sweep has no end
constexpr double kLampsOff = 6, kLampsOn = -1;  // degrees, height of the sun at which people light them
// Of summer against winter, where snow is bright and sends light into the shade. Without snow the sky is darker than ground in
// the sun, not lighter.
const glm::vec3 kSummerSun(3.1f, 2.95f, 2.6f), kSummerShade(1.8f, 1.72f, 1.62f), kSummerSky(1.5f);
constexpr double kDiscRadius =
    0.6;  // degrees, twice that of sun and moon: a screen shows less than the eye sees

// Sets the sun sweep over the grid, see sun_sweep.h. Its rows run across the larger horizontal component of
// the sun's direction.
void set_sweep(FrameBlock& block, const sim::Grid& grid) {
    const glm::dvec2 toward = glm::normalize(glm::dvec2(block.sun));
    const bool rows_are_columns = std::abs(toward.x) > std::abs(toward.y);
    const double main = rows_are_columns ? toward.x : toward.y;
    const double aside = rows_are_columns ? toward.y : toward.x;
    const int rows = rows_are_columns ? grid.nx : grid.ny, columns = rows_are_columns ? grid.ny : grid.nx;
    const double shear = -aside / std::abs(main);
    const double first_ray = shear > 0 ? -shear * (rows - 1) : 0;
    const double fall = block.sun.w * grid.dx / std::abs(main);
    block.size = {grid.nx, grid.ny,
                  static_cast<int>(std::ceil(2 * (columns - 1 + std::abs(shear) * (rows - 1)))) + 1, rows};
    block.sweep = glm::dvec4(shear, first_ray, fall, rows_are_columns ? 1 : 0);
    block.haze.z = main > 0 ? 1.f : 0.f;
}

glm::dvec3 direction(double azimuth, double elevation) {
    return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
}

// Sets the lamp (sun or moon) and all colours of light and sky. The moon stands opposite the sun, as a full
// moon does.
void set_light(FrameBlock& block, const Light& light) {
    const SkyLight sky = sky_light(std::clamp(light.elevation_deg, kLowestSunDeg, kHighestSunDeg));
    const double sun_azimuth = glm::radians(light.azimuth_deg);
    const double azimuth = sky.moon ? sun_azimuth + glm::pi<double>() : sun_azimuth;
    const double elevation = glm::radians(std::clamp(sky.lamp_elevation_deg, kLowestLamp, kHighestLamp));
    block.sun = glm::dvec4(direction(azimuth, elevation), std::tan(elevation));
    block.lamp = glm::dvec4(sky.lamp, sky.openness_contrast);
    block.above = glm::dvec4(sky.above, sky.stars);
    block.below = glm::dvec4(sky.below, sky.haze);
    block.toward = glm::dvec4(sky.toward, std::sin(sun_azimuth));
    block.away = glm::dvec4(sky.away, std::cos(sun_azimuth));
    block.zenith = glm::dvec4(sky.zenith, sky.sunward);
    block.glow = glm::dvec4(sky.glow, sky.moon ? 3 : 6);
    block.cloud = glm::dvec4(sky.cloud, ramp(kLampsOff, kLampsOn, light.elevation_deg));
    block.disc = glm::dvec4(direction(azimuth, glm::radians(sky.lamp_elevation_deg)),
                            std::cos(glm::radians(kDiscRadius)));
}

// Makes all light brighter, as an eye that is used to ground without snow sees it. `summer`: 0 in winter, 1 in summer.
void expose(FrameBlock& block, float summer) {
    const auto brighten = [summer](glm::vec4& light, glm::vec3 factor) {
        light *= glm::vec4(glm::mix(glm::vec3(1), factor, summer), 1);
    };
    brighten(block.lamp, kSummerSun);
    for (glm::vec4* light : {&block.above, &block.below}) brighten(*light, kSummerShade);
    for (glm::vec4* light : {&block.toward, &block.away, &block.zenith, &block.glow, &block.cloud})
        brighten(*light, kSummerSky);
}

// The block of a part of the frame's image: the rectangle around `middle`, `size` times as large.
void set_part(FrameBlock& block, glm::dvec2 size, glm::dvec2 middle) {
    block.ray_middle += glm::vec4(
        glm::dvec4(middle.x * glm::dvec3(block.ray_right) + middle.y * glm::dvec3(block.ray_up), 0));
    block.ray_right = glm::vec4(size.x * glm::dvec4(block.ray_right));
    block.ray_up = glm::vec4(size.y * glm::dvec3(block.ray_up), block.ray_up.w);
    glm::dmat4 place(1);
    place[0][0] = 1 / size.x, place[1][1] = 1 / size.y;
    place[3][0] = -middle.x / size.x, place[3][1] = -middle.y / size.y;
    block.clip_from_world = glm::mat4(place * glm::dmat4(block.clip_from_world));
}

void set_view(FrameBlock& block, const Camera& camera, double datum, double aspect) {
    const glm::dmat4 view = view_matrix(camera);
    const glm::dvec3 up_by_datum(0, 0, datum);
    block.clip_from_world = projection_matrix(camera, aspect) * glm::translate(view, up_by_datum);
    block.eye = glm::dvec4(eye(camera) - up_by_datum, block.eye.w);
    const double reach = std::tan(glm::radians(camera.field_of_view_deg) / 2);
    const glm::dmat4 axes = glm::transpose(view);  // its columns: right, up and backward in the world
    block.ray_right = glm::dvec4(glm::dvec3(axes[0]) * reach * aspect, 0);
    block.ray_up = glm::dvec4(glm::dvec3(axes[1]) * reach, 0);
    block.ray_up.w = glm::length(glm::vec3(block.ray_up));
    block.ray_forward = glm::dvec4(-glm::dvec3(axes[2]), kNear);
    block.ray_middle = glm::vec4(glm::vec3(block.ray_forward), 0);
}

void set_marks(FrameBlock& block, const Marks& marks, HeightRange heights, double datum) {
    if (marks.ring) {
        block.ring = glm::dvec4(marks.ring->centre, marks.ring->radius, 1);
        block.ring_colour = glm::vec4(marks.ring->colour, 0);
    }
    if (marks.outline) {
        const Outline& outline = *marks.outline;
        block.outline = glm::dvec4(outline.from, outline.to);
        const double half = outline.width / 2;
        block.outline_colour = glm::vec4(outline.colour, outline.front ? -half : half);
    }
    if (marks.contours) {
        // Measured from the fifth contour below the lowest height: a float measured from sea level would lose
        // its precision.
        const double interval = contour_interval(heights), five = 5 * interval;
        block.contours = glm::dvec4(1 / interval, (datum - five * std::floor(datum / five)) / interval, 0, 0);
    }
    if (marks.extent != 0) block.contours.z = 1;
    const Legend legend = legend_of(marks.overlay);
    block.overlay = {static_cast<int>(marks.overlay), static_cast<int>(legend.stops.size()), legend.stepped,
                     marks.overlay == Overlay::kProbability ? marks.probability : 0};
    block.density = glm::vec4(marks.density, 0, 0);
    for (std::size_t i = 0; i < legend.stops.size(); ++i)
        block.stops[i] = glm::vec4(legend.stops[i].colour, legend.stops[i].value);
}

}  // namespace

FrameBlock make_frame_block(const FrameInput& input, HeightRange heights, int samples,
                            const std::optional<glm::vec3>& flow_tint) {
    const sim::View& world = input.world;
    const Look& look = input.look;
    const double side = static_cast<double>(std::max(world.grid.nx, world.grid.ny) - 1) * world.grid.dx;
    FrameBlock block{};
    block.eye.w = static_cast<float>(1 / std::max(kWidestDetail, side / 3));
    const WholeImage image = input.image();
    set_view(block, input.camera, world.datum, static_cast<double>(image.width) / image.height);
    set_light(block, input.light);
    block.ground = glm::dvec4(world.grid.dx, heights.lowest - block_depth(world.grid), heights.lowest,
                              std::max(heights.highest, heights.lowest + 1));
    block.haze =
        glm::dvec4(1 / (kHazeLength * std::max(1.0, side / kWideView)), heights.lowest, 0, look.detail);
    set_sweep(block, world.grid);
    block.rock = glm::vec4(look.rock, look.sheen);
    block.meadow = glm::vec4(look.meadow, look.old_cover_m);
    block.standing = glm::vec4(look.standing, look.cover_visible_m);
    block.rolling = glm::vec4(look.rolling, look.rolling_visible_m);
    block.lower_standing = glm::vec4(look.lower_standing, world.mixture ? 1 : 0);
    block.lower_rolling =
        glm::dvec4(glm::dvec3(look.lower_rolling),
                   std::clamp(std::log2(kFinishedRows / (image.height * samples)), 0.0, kMostCoarse));
    if (look.turf) block.turf = glm::vec4(*look.turf, 1);
    if (look.lower_turf) block.lower_turf = glm::vec4(*look.lower_turf, 1);
    if (look.date) {
        const Season season = season_on(*look.date);
        block.season = {season.green, season.leaves, season.turned, 1};
        expose(block, std::max(season.green, season.leaves));
    }
    const double pixel = 2 * glm::length(glm::dvec3(block.ray_up)) / (image.height * samples);
    if (input.whole) {
        const glm::dvec2 all(image.width, image.height), frame(input.width, input.height);
        set_part(block, frame / all, (2.0 * glm::dvec2(image.left, image.bottom) + frame) / all - 1.0);
    }
    if (flow_tint) {
        block.flow = glm::dvec4(std::max(look.flow->repeats / side, 1 / kWidestFlowTile),
                                look.flow->everywhere ? FLOW_EVERYWHERE : FLOW_ROLLING, 0, 0);
        block.flow_tint = glm::vec4(*flow_tint, 0);
    }
    block.material =
        glm::dvec4(look.roughness * look.detail, pixel, samples, input.untouched().empty() ? 0 : 1);
    if (input.surroundings && !input.surroundings->empty())
        block.beyond = glm::dvec4(input.surroundings->rough_origin(), input.surroundings->rough_cell(), 1);
    set_marks(block, input.marks, heights, world.datum);
    return block;
}

// The middles of coarse samples are those of the first of each two by two samples of the frame, not between them.
FrameBlock coarse_frame_block(const FrameBlock& frame, int samples_across, int samples_up) {
    const glm::dvec2 samples(samples_across, samples_up),
        coarse((samples_across + 1) / 2, (samples_up + 1) / 2);
    const glm::dvec2 scale = 2.0 * coarse / samples, shift = (2.0 * coarse - 1.0) / samples - 1.0;
    FrameBlock block = frame;
    set_part(block, scale, shift);
    block.material.y *= kCoarser;
    block.contours.x = block.contours.z = block.ring.w = block.outline_colour.w = 0;
    return block;
}

}  // namespace render
