#include "game/figures/gallery_views.h"

namespace game {
namespace {

constexpr std::int64_t kTicksPerSecond = 60;
constexpr std::int64_t seconds(std::int64_t s) {
    return s * kTicksPerSecond;
}

// Of the sun: azimuth and height above the horizon, degrees.
constexpr render::Light kDawn{110, 3}, kForenoon{120, 44}, kNoon{215, 42}, kTorrent{135, 38},
    kAfternoon{260, 18}, kDusk{262, -3}, kNight{75, -14};

}  // namespace

std::vector<GalleryView> gallery_views() {
    // Target (m), azimuth, elevation (degrees), distance (m), field of view (degrees).
    const render::Camera valley{{1040, 1040, 1485}, 205, 7, 1400, 50};
    const render::Camera far{{1030, 1080, 1520}, 158, 32, 1900, 35};
    const render::Camera near{{1080, 850, 1305}, 150, 15, 260, 45};
    const render::Camera front{{1075, 800, 1290}, 170, 5, 90, 50};
    const render::Camera against_sun{{1060, 640, 1240}, 98, 9, 330, 55};
    const render::Camera deposit{{1110, 420, 1200}, 95, 16, 260, 45};
    const render::Camera across{{700, 460, 930}, 200, 14, 800, 50};
    const render::Camera village{{1010, 290, 905}, 215, 7, 150, 50};
    const render::Camera slope{{985, 440, 950}, 185, 12, 190, 50};
    const render::Camera fan{{1005, 310, 905}, 205, 12, 120, 50};
    const render::Camera apex{{752, 530, 947}, 184, -6, 125, 50};
    const render::Camera lobe{{708, 438, 917}, 224, 12, 140, 46};
    return {
        {"valley-dawn", "A winter valley at dawn", "winter-valley", 0, valley, kDawn},
        {"valley-noon", "A winter valley at noon", "winter-valley", 0, valley, kNoon},
        {"valley-dusk", "A winter valley at dusk", "winter-valley", 0, valley, kDusk},
        {"valley-night", "A winter valley at night", "winter-valley", 0, valley, kNight},
        {"slide-front", "At its front", "winter-avalanche", seconds(33), front, kAfternoon},
        {"slide-far", "A slide from far away", "winter-avalanche", seconds(33), far, kAfternoon},
        {"slide-near", "The same slide from near", "winter-avalanche", seconds(33), near, kAfternoon},
        {"slide-valley", "From the valley", "winter-avalanche", seconds(40), std::nullopt, kAfternoon},
        {"slide-dusk", "From the valley at dusk", "winter-avalanche", seconds(40), std::nullopt, kDusk},
        {"slide-sun", "Against the sun", "winter-avalanche", seconds(40), against_sun, kAfternoon},
        {"deposit", "The deposit", "winter-avalanche", std::nullopt, deposit, kAfternoon},
        {"landslide", "A landslide", "landslide", seconds(15), std::nullopt, kAfternoon},
        {"two-materials", "Wet snow on soil", "snow-on-soil", seconds(60), std::nullopt, kAfternoon},
        {"summer-valley", "A valley in July", "hillside", 0, std::nullopt, kForenoon},
        {"autumn-valley", "The same in October", "hillside", 0, across, kAfternoon, render::Date{10, 9}},
        {"summer-village", "The village", "hillside", 0, village, kForenoon},
        {"summer-slide", "The slope lets go", "hillside", seconds(24), slope, kForenoon},
        {"summer-deposit", "What it left in the village", "hillside", std::nullopt, fan, kAfternoon},
        {"torrent-front", "A debris flow leaves its gully", "torrent", seconds(51), apex, kTorrent},
        {"torrent-deposit", "What it left on its fan", "torrent", std::nullopt, lobe, kTorrent},
        {"hill", "A real hill", "", 0, std::nullopt, kAfternoon},
    };
}

}  // namespace game
