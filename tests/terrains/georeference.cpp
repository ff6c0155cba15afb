#include "terrains/georeference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/terrains/files.h"

namespace terrains {
namespace {

TEST(Georeference, finds_a_known_place_in_utm) {
    // 682607.998 E, 5243710.308 N in zone 32 is 47° 19′ 16.95″ N, 11° 24′ 59.45″ E.
    const auto utm = Georeference::projected(test::utm_32n(), 682'000, 5'243'000);
    const auto there = utm.to_lat_lon({607.998, 710.308}).value();
    EXPECT_NEAR(there.latitude, 47 + 19 / 60.0 + 16.95 / 3600, 0.005 / 3600);
    EXPECT_NEAR(there.longitude, 11 + 24 / 60.0 + 59.45 / 3600, 0.005 / 3600);
}

TEST(Georeference, survives_a_round_trip) {
    for (const auto& georeference :
         {Georeference::projected(test::utm_32n(), 683'000, 5'240'000),
          Georeference::local({47.3, 11.43}, -900, -2000), Georeference::local({-43.6, 170.14}, 0, 0),
          Georeference::local({65, 179.999}, -500, -500)}) {
        const auto back = georeference.to_local(georeference.to_lat_lon({1234.5, 678.9}).value()).value();
        EXPECT_NEAR(back.x, 1234.5, 1e-6);
        EXPECT_NEAR(back.y, 678.9, 1e-6);
    }
}

TEST(Georeference, measures_true_metres_on_a_local_plane) {
    const auto plane = Georeference::local({47.3, 11.43}, 0, 0);
    // WGS 84 at 47.3° N: radii of curvature 6369.96 km along the meridian and 6389.71 km across it.
    const auto north = plane.to_local({47.31, 11.43}).value(), east = plane.to_local({47.3, 11.44}).value();
    EXPECT_NEAR(north.y, 0.01 * 3.14159265 / 180 * 6'369'960, 0.02);
    EXPECT_NEAR(north.x, 0, 1e-6);
    EXPECT_NEAR(east.x, 0.01 * 3.14159265 / 180 * 6'389'706 * 0.678160, 0.02);
}

TEST(Georeference, is_empty_if_not_placed) {
    for (const auto& nowhere : {Georeference(), Georeference::unnamed(361'015, 70'223)}) {
        EXPECT_FALSE(nowhere.placed());
        EXPECT_FALSE(nowhere.to_lat_lon({0, 0}));
        EXPECT_FALSE(nowhere.to_local({47, 11}));
        EXPECT_EQ(nowhere.describe({0, 0}), "");
        EXPECT_EQ(nowhere.wkt(), "");
    }
}

TEST(Georeference, refuses_invalid_positions) {
    const auto plane = Georeference::local({47.3, 11.43}, 0, 0);
    EXPECT_FALSE(plane.to_local({91, 11}));
    EXPECT_FALSE(plane.to_local({std::nan(""), 11}));
    EXPECT_FALSE(Georeference::projected("no system at all", 0, 0).to_lat_lon({0, 0}));
    EXPECT_FALSE(Georeference::projected(test::utm_32n(), 0, 0).to_lat_lon({1e12, 0}));
}

TEST(Georeference, describes_degrees_and_zone_on_both_hemispheres) {
    EXPECT_EQ(Georeference::local({47.30012, 11.4321}, 0, 0).describe({0, 0}),
              "47.30012° N 11.43210° E, UTM 32T 683860 5241385");
    EXPECT_EQ(Georeference::local({-43.595, -170.142}, 0, 0).describe({0, 0}),
              "43.59500° S 170.14200° W, UTM 02G 569256 5172750");
    EXPECT_EQ(Georeference::local({89, 0}, 0, 0).describe({0, 0}),
              "89.00000° N 0.00000° E, UPS Z 2000000 1888973");
}

}  // namespace
}  // namespace terrains
