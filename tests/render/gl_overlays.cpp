#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/render/gl_scene.h"
#include "tests/support/allocations.h"

namespace render::test {
namespace {

Colour of_legend(const LegendStop& stop) {
    return {255.0 * stop.colour.r, 255.0 * stop.colour.g, 255.0 * stop.colour.b};
}

Colour between(const LegendStop& a, const LegendStop& b, double share) {
    Colour mixed{};
    for (std::size_t c = 0; c < 3; ++c) mixed[c] = (1 - share) * of_legend(a)[c] + share * of_legend(b)[c];
    return mixed;
}

class Overlays : public Gl {
  protected:
    static World level() {
        return make_world(40, 4, [](double, double) { return 0; });
    }

    static World tilted(double slope_deg) {
        return make_world(40, 4,
                          [=](double, double y) { return std::tan(slope_deg * std::numbers::pi / 180) * y; });
    }

    Picture shot(const World& world, Overlay overlay, const Light& light = {}) {
        Marks marks;
        marks.overlay = overlay;
        const double z = static_cast<double>(world.bedrock(20, 20));
        return draw(world, from_above({80, 80, z}, 8), light, plain_look(), 96, 96, marks);
    }
    Colour middle(const World& world, Overlay overlay, const Light& light = {}) {
        return mean_colour(shot(world, overlay, light), 48, 48, 10);
    }

    // Level ground with each value of the overlay's legend and the values midway between.
    void expect_colours_of_the_legend(Overlay overlay, World& world, sim::Field<float>& field) {
        const auto stops = legend_of(overlay).stops;
        for (std::size_t i = 0; i < stops.size(); ++i) {
            field.fill(std::max(stops[i].value, 0.001f));
            EXPECT_LT(colour_distance(middle(world, overlay), of_legend(stops[i])), 2) << stops[i].value;
            if (i == 0) continue;
            field.fill((stops[i - 1].value + stops[i].value) / 2);
            EXPECT_LT(colour_distance(middle(world, overlay), between(stops[i - 1], stops[i], 0.5)), 2)
                << "below " << stops[i].value;
        }
        field.fill(3 * stops.back().value);
        EXPECT_LT(colour_distance(middle(world, overlay), of_legend(stops.back())), 2) << "beyond";
    }
};

TEST_F(Overlays, of_slope_has_the_colour_of_the_class_from_edge_to_edge) {
    for (const LegendStop& stop : legend_of(Overlay::kSlope).stops) {
        for (const double slope_deg : {stop.value + 0.3, stop.value + 4.7}) {
            // From the south and so steeply lit that the slope receives as much sun as level ground.
            const Light light{180, 90 - slope_deg / 2};
            EXPECT_LT(colour_distance(middle(tilted(slope_deg), Overlay::kSlope, light), of_legend(stop)), 5)
                << slope_deg;
        }
    }
}

// Any two, for people who lack one kind of cone too.
TEST(Legends, have_stops_that_everybody_can_tell_apart) {
    for (const Overlay overlay : {Overlay::kSlope, Overlay::kStanding, Overlay::kSpeed, Overlay::kStretch,
                                  Overlay::kPressure, Overlay::kProbability, Overlay::kWater}) {
        const auto stops = legend_of(overlay).stops;
        for (const LegendStop& one : stops)
            for (const LegendStop& other : stops) {
                if (one.value >= other.value) continue;
                const Colour a = of_legend(one), b = of_legend(other);
                double least = colour_distance(a, b);
                for (const Cone cone : kCones)
                    least = std::min(least, colour_distance(without(cone, a), without(cone, b)));
                EXPECT_GT(least, 10) << "overlay " << static_cast<int>(overlay) << ", " << one.value
                                     << " and " << other.value;
            }
    }
}

TEST_F(Overlays, of_slope_do_not_colour_ground_below_30_degrees) {
    EXPECT_TRUE(alike(shot(tilted(29.5), Overlay::kSlope), shot(tilted(29.5), Overlay::kNone)));
}

TEST_F(Overlays, of_the_standing_layer_has_the_colours_of_its_legend) {
    World world = level();
    expect_colours_of_the_legend(Overlay::kStanding, world, world.depth);
}

TEST_F(Overlays, of_the_rolling_layer_has_the_colours_of_its_legend) {
    World world = level();
    expect_colours_of_the_legend(Overlay::kRolling, world, world.rolling);
}

TEST_F(Overlays, of_speed_has_the_colours_of_its_legend_in_every_direction) {
    World world = level();
    world.rolling.fill(0.5f);
    expect_colours_of_the_legend(Overlay::kSpeed, world, world.velocity_x);
    world.velocity_x.fill(-6);
    world.velocity_y.fill(8);
    EXPECT_LT(colour_distance(middle(world, Overlay::kSpeed), of_legend(legend_of(Overlay::kSpeed).stops[3])),
              2);
}

// On level ground and down a plane of 45°, where speed along the slope is √2 times that in plan.
TEST_F(Overlays, of_pressure_have_the_colour_of_the_class_of_density_times_speed_squared) {
    const auto seen = [&](World world, float speed, glm::vec2 density) {
        world.rolling.fill(0.5f);
        world.velocity_y.fill(-speed);
        Marks marks;
        marks.overlay = Overlay::kPressure;
        marks.density = density;
        const double z = static_cast<double>(world.bedrock(20, 20));
        return draw(world, from_above({80, 80, z}, 8), {180, z > 0 ? 67.5 : 90}, plain_look(), 96, 96, marks);
    };
    const auto colour = [](const Picture& picture) { return mean_colour(picture, 48, 48, 10); };
    const auto stops = legend_of(Overlay::kPressure).stops;
    for (std::size_t i = 0; i < stops.size(); ++i)
        for (const float density : {200.f, 1800.f}) {
            const float speed = std::sqrt(1000 * 1.02f * stops[i].value / density);
            EXPECT_LT(colour_distance(colour(seen(level(), speed, {density, density})), of_legend(stops[i])),
                      5)
                << stops[i].value;
            EXPECT_LT(colour_distance(colour(seen(tilted(45), speed / std::sqrt(2.f), {density, density})),
                                      of_legend(stops[i])),
                      5)
                << stops[i].value;
            if (i > 0) {
                EXPECT_LT(colour_distance(colour(seen(level(), speed * 0.98f, {density, density})),
                                          of_legend(stops[i - 1])),
                          5)
                    << "below " << stops[i].value;
            }
        }
    World flow = level();
    flow.rolling.fill(0.5f);
    flow.velocity_y.fill(-20);
    EXPECT_TRUE(alike(shot(flow, Overlay::kPressure), shot(flow, Overlay::kNone))) << "unknown density";
}

TEST_F(Overlays, of_probability_have_the_colour_of_the_class_and_follow_the_field_that_they_are_given) {
    const World world = level();
    std::vector<float> field(world.grid.size());
    const auto seen = [&](std::int32_t number) {
        Marks marks;
        marks.overlay = Overlay::kProbability;
        marks.probability = number;
        renderer_->draw({.world = world.view(),
                         .camera = from_above({80, 80, 0}, 8),
                         .look = plain_look(),
                         .marks = marks,
                         .width = 96,
                         .height = 96,
                         .probability = field});
        return mean_colour(renderer_->read_back(), 48, 48, 10);
    };
    const auto stops = legend_of(Overlay::kProbability).stops;
    std::int32_t number = 0;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        std::ranges::fill(field, (stops[i].value + 0.1f) / 100);
        const Colour colour = seen(++number);
        EXPECT_LT(colour_distance(colour, of_legend(stops[i])), 5) << stops[i].value;
        std::ranges::fill(field, 1.f);
        EXPECT_EQ(seen(number), colour) << "of the same number, so that it is not looked at";
    }
    const Colour plain = middle(world, Overlay::kNone);
    std::ranges::fill(field, std::numeric_limits<float>::quiet_NaN());
    EXPECT_LT(colour_distance(seen(++number), plain), 1) << "nothing is known";
    EXPECT_LT(colour_distance(seen(0), plain), 1) << "there is none";
}

TEST_F(Overlays, of_water_have_the_colours_of_the_share_and_follow_it_in_a_world_with_or_without_things) {
    World world = level();
    const Colour plain = middle(world, Overlay::kNone);
    EXPECT_LT(colour_distance(middle(world, Overlay::kWater), plain), 1) << "without things";
    world.things.emplace(world.grid);
    world.things->natural = world.bedrock;
    EXPECT_LT(colour_distance(middle(world, Overlay::kWater), plain), 1) << "dry";
    const auto stops = legend_of(Overlay::kWater).stops;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        world.things->water.fill(stops[i].value / 100);
        EXPECT_LT(colour_distance(middle(world, Overlay::kWater), of_legend(stops[i])), 2) << stops[i].value;
    }
    world.things->water.fill(0);
    for (int y = 0; y <= 40; ++y)
        for (int x = 19; x <= 21; ++x) world.things->water(x, y) = 0.5f;
    EXPECT_LT(colour_distance(middle(world, Overlay::kWater), of_legend(stops[2])), 2) << "a part of it";
    EXPECT_LT(colour_distance(middle(world, Overlay::kNone), plain), 1);
    world.things.reset();
    EXPECT_LT(colour_distance(middle(world, Overlay::kWater), plain), 1) << "without them again";
}

// Rain on a part of the ground, once all of it has been seen.
TEST_F(Overlays, of_water_allocate_nothing_while_it_rains) {
    World world = level();
    world.things.emplace(world.grid);
    world.things->natural = world.bedrock;
    Marks marks;
    marks.overlay = Overlay::kWater;
    const auto frame = [&](float share) {
        world.things->water(20, 20) = world.things->water(21, 23) = share;
        const std::int64_t before = support::allocations();
        renderer_->draw({.world = world.view(),
                         .camera = from_above({80, 80, 0}, 8),
                         .look = plain_look(),
                         .marks = marks,
                         .width = 96,
                         .height = 96});
        return support::allocations() - before;
    };
    for (int i = 0; i < 8; ++i) frame(0.01f * static_cast<float>(i));
    std::int64_t allocated = 0;
    for (int i = 10; i < 20; ++i) allocated += frame(0.01f * static_cast<float>(i));
    EXPECT_EQ(allocated, 0);
}

TEST_F(Overlays, of_depth_and_speed_do_not_colour_bare_or_resting_ground) {
    const World bare = level();
    for (const Overlay overlay : {Overlay::kStanding, Overlay::kRolling, Overlay::kSpeed})
        EXPECT_TRUE(alike(shot(bare, overlay), shot(bare, Overlay::kNone)));
}

TEST_F(Overlays, of_speed_keep_the_speed_of_a_front_up_to_its_edge) {
    World front = level();
    for (int y = 0; y <= 40; ++y) {
        for (int x = 0; x <= 20; ++x) front.rolling(x, y) = 1, front.velocity_x(x, y) = 20;
    }
    // 8 m across 96 pixels; the edge lies midway between x = 80 and 84, at pixel 72.
    const Picture p = shot(front, Overlay::kSpeed), plain = shot(front, Overlay::kNone);
    const Colour twenty = of_legend(legend_of(Overlay::kSpeed).stops[4]);
    EXPECT_LT(colour_distance(mean_colour(p, 20, 48, 3), twenty), 12);
    EXPECT_LT(colour_distance(mean_colour(p, 64, 48, 3), twenty), 12);
    EXPECT_EQ(mean_colour(p, 80, 48, 3), mean_colour(plain, 80, 48, 3));
}

TEST_F(Overlays, show_the_shape_of_the_ground_by_its_shade) {
    const Light east{90, 40};
    const auto faces = [](double sign) {
        World world = make_world(40, 4, [=](double x, double) { return sign * 0.5 * x; });
        world.depth.fill(1);
        return world;
    };
    const Colour sunny = middle(faces(-1), Overlay::kStanding, east);
    const Colour shady = middle(faces(1), Overlay::kStanding, east);
    EXPECT_GT(colour_distance(sunny, shady), 8);
}

TEST_F(Overlays, have_stops_distinguishable_in_all_colour_vision) {
    for (const Overlay overlay : {Overlay::kSlope, Overlay::kStanding, Overlay::kRolling, Overlay::kSpeed,
                                  Overlay::kPressure, Overlay::kProbability, Overlay::kWater}) {
        const auto stops = legend_of(overlay).stops;
        for (std::size_t i = 1; i < stops.size(); ++i) {
            const Colour a = of_legend(stops[i - 1]), b = of_legend(stops[i]);
            EXPECT_GT(colour_distance(a, b), 15) << stops[i].value;
            for (const Cone cone : {Cone::kLong, Cone::kMiddle})
                EXPECT_GT(colour_distance(without(cone, a), without(cone, b)), 10) << stops[i].value;
        }
    }
}

}  // namespace
}  // namespace render::test
