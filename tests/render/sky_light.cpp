#include "render/view/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace render {
namespace {

constexpr int kTenths = 10;  // per degree

// Calls `check` for every tenth of a degree, with the light there and the height of the sun.
template <typename Check>
void for_all_heights(const Check& check) {
    for (int tenth = -90 * kTenths; tenth <= 90 * kTenths; ++tenth) {
        const double h = static_cast<double>(tenth) / kTenths;
        check(sky_light(h), h);
    }
}

std::array<glm::dvec3, 9> colours(const SkyLight& light) {
    return {light.lamp,   light.above, light.below,
            light.toward, light.away,  light.zenith,
            light.glow,   light.cloud, {light.stars, light.openness_contrast, light.haze}};
}

double luminance(const glm::dvec3& c) {
    return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722));
}

// Light that level snow reflects under an open sky.
glm::dvec3 level_snow(double sun_deg) {
    const SkyLight light = sky_light(sun_deg);
    const double facing = std::max(0.0, std::sin(light.lamp_elevation_deg * std::numbers::pi / 180));
    return glm::dvec3(0.86, 0.89, 0.93) * (light.lamp * facing + light.above);
}

// As in assets/shaders/tone_curve.glsl.
double shown(double light) {
    return light < 0.6 ? light : 0.6 + 0.4 * (1 - std::pow(1 + (light - 0.6) / 1.6, -4));
}

TEST(SkyLight, is_finite_and_never_negative_at_any_height_of_the_sun) {
    for_all_heights([](const SkyLight& light, double h) {
        for (const glm::dvec3& colour : colours(light)) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_TRUE(std::isfinite(colour[c])) << h;
                EXPECT_GE(colour[c], 0) << h;
                EXPECT_LE(colour[c], 2.5) << h;
            }
        }
        EXPECT_LE(light.stars, 1) << h;
        EXPECT_LE(light.openness_contrast, 1) << h;
    });
}

TEST(SkyLight, changes_by_less_than_a_twentieth_in_a_tenth_of_a_degree) {
    SkyLight before = sky_light(-90);
    for_all_heights([&](const SkyLight& light, double h) {
        const auto was = colours(before), is = colours(light);
        for (std::size_t i = 0; i < is.size(); ++i)
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(is[i][c], was[i][c], 0.05) << h << ", colour " << i;
        EXPECT_NEAR(light.sunward, before.sunward, 0.05) << h;
        before = light;
    });
}

TEST(SkyLight, changes_from_sun_to_moon_while_neither_shines) {
    bool moon = true;
    for_all_heights([&](const SkyLight& light, double h) {
        if (light.moon == moon) return;
        for (const double near : {h - 1.0 / kTenths, h}) {
            EXPECT_EQ(sky_light(near).lamp, glm::dvec3(0)) << near;
            EXPECT_EQ(sky_light(near).glow, glm::dvec3(0)) << near;
        }
        moon = light.moon;
    });
    EXPECT_FALSE(moon);
}

TEST(SkyLight, reddens_the_sun_as_it_sinks) {
    double red_to_green = 0, green_to_blue = 0;
    for (double h = 90; h >= 0; h -= 0.5) {
        const glm::dvec3 sun = sky_light(h).lamp;
        EXPECT_GT(sun.r / sun.g, red_to_green) << h;
        EXPECT_GT(sun.g / sun.b, green_to_blue) << h;
        red_to_green = sun.r / sun.g, green_to_blue = sun.g / sun.b;
    }
    const glm::dvec3 noon = sky_light(60).lamp, evening = sky_light(3.5).lamp;
    EXPECT_LT(noon.r / noon.b, 1.25);  // slightly warm
    EXPECT_GT(evening.r / evening.b, 4);
}

// Air mass 1.994 at 30 degrees (Kasten and Young 1989, Table II), so e^(−1.994 · (0.098 − 0.052)).
TEST(SkyLight, dims_the_sun_by_the_air_mass_of_kasten_and_young) {
    const glm::dvec3 sun = sky_light(30).lamp;
    EXPECT_NEAR(sun.g / sun.r, std::exp(-1.994 * 0.046), 1e-3);
    EXPECT_NEAR(sun.b / sun.r, std::exp(-1.994 * 0.138), 1e-3);
}

TEST(SkyLight, is_bluer_and_darker_from_the_sky_than_from_the_sun_by_day) {
    for (double h = 10; h <= 90; h += 5) {
        const SkyLight light = sky_light(h);
        EXPECT_GT(light.above.b / light.above.r, 1.3 * light.lamp.b / light.lamp.r) << h;
        EXPECT_LT(luminance(light.above), 0.5 * luminance(light.lamp)) << h;
    }
}

TEST(SkyLight, is_brighter_on_the_side_of_the_sun_and_at_night_of_the_moon) {
    for (double h = 80; h >= -6; h -= 0.5) EXPECT_GT(sky_light(h).sunward, 0) << h;
    for (double h = -15; h >= -90; h -= 0.5) EXPECT_LT(sky_light(h).sunward, 0) << h;
    for_all_heights([](const SkyLight& light, double h) { EXPECT_LT(std::abs(light.sunward), 1) << h; });
}

// A slope of snow that faces the sun is then the brightest ground of a frame; if it were white it would have no
// shape.
TEST(SkyLight, keeps_snow_that_faces_the_sun_at_noon_below_white) {
    for (double h = 50; h <= 70; h += 0.5) {
        const SkyLight light = sky_light(h);
        const glm::dvec3 snow = glm::dvec3(0.86, 0.89, 0.93) * (light.lamp + light.above);
        EXPECT_LT(shown(std::max({snow.r, snow.g, snow.b})), 0.79) << h;  // sRGB 230
    }
}

TEST(SkyLight, darkens_level_snow_from_day_over_dusk_to_night) {
    double before = std::numeric_limits<double>::infinity();
    for (double h = 60; h >= -18; h -= 0.5) {
        const double now = luminance(level_snow(h));
        EXPECT_LE(now, before + 1e-9) << h;
        before = now;
    }
    EXPECT_LT(luminance(level_snow(-6)), 0.65 * luminance(level_snow(3.5)));
    EXPECT_LT(luminance(level_snow(-16)), 0.85 * luminance(level_snow(-6)));
}

TEST(SkyLight, keeps_level_snow_below_clipping_by_day_and_visible_at_night) {
    for_all_heights([](const SkyLight&, double h) {
        const glm::dvec3 snow = level_snow(h);
        EXPECT_LT(shown(std::max({snow.r, snow.g, snow.b})), 0.85) << h;  // sRGB 238 of 255
        EXPECT_GT(shown(luminance(snow)), 0.06) << h;                     // sRGB 71
    });
}

}  // namespace
}  // namespace render
