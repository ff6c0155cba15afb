#include "game/analysis/release_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace game {
namespace {

constexpr double kTold = 0.05;  // m³, and m² of an extent: what a number with one decimal shows

const char* thickness_of(const terrains::Release& release) {
    if (!release.normal) return "vertical";
    return release.vertical ? "vertical and normal" : "normal";
}

std::string skipped_text(const char* what, std::size_t without_geometry) {
    if (without_geometry == 0) return {};
    return fmt::format("{}: {} feature{} without a geometry skipped\n", what, without_geometry,
                       without_geometry == 1 ? "" : "s");
}

}  // namespace

Json to_json(const terrains::Release& release) {
    const terrains::ReleaseVolumes& v = release.volumes;
    return {{"thickness", thickness_of(release)},
            {"file_m3", v.in_file},
            {"ground_m3", v.on_ground},
            {"lost_m3", {{"outside", v.outside}, {"no_data", v.on_no_data}, {"overlap", v.overlap}}},
            {"features_without_geometry", release.without_geometry}};
}

Json to_json(const terrains::Reference& reference) {
    const char* unit = reference.extent.empty() ? "m3" : "m2";
    return {{fmt::format("file_{}", unit), reference.in_file},
            {fmt::format("outside_{}", unit), reference.outside},
            {"features_without_geometry", reference.without_geometry}};
}

std::string to_text(const terrains::Release& release) {
    const terrains::ReleaseVolumes& v = release.volumes;
    const char* taken = !release.normal    ? "vertically"
                        : release.vertical ? "vertically, and thickness_normal normal to the slope"
                                           : "normal to the slope";
    std::string text =
        fmt::format("release: thickness taken {}; {:.1f} m3 in the file, {:.1f} m3 on ground\n", taken,
                    v.in_file, v.on_ground);
    if (v.lost() > kTold) {
        text += fmt::format("release: LOST {:.1f} m3 ({:.1f} %):", v.lost(), 100 * v.lost() / v.in_file);
        const char* comma = " ";
        for (const auto& [volume, cause] :
             {std::pair{v.outside, "outside the grid"},
              {v.on_no_data, "where the terrain has no data"},
              {v.overlap, "where polygons overlap, of which the thickest counts"}}) {
            if (volume <= kTold) continue;
            text += fmt::format("{}{:.1f} m3 {}", comma, volume, cause);
            comma = ", ";
        }
        text += '\n';
    }
    return text + skipped_text("release", release.without_geometry);
}

std::string to_text(const terrains::Reference& reference) {
    const bool extent = !reference.extent.empty();
    std::string text;
    if (reference.outside > kTold)
        text = fmt::format("reference: {:.1f} {} of {:.1f} {} outside the grid\n", reference.outside,
                           extent ? "m2" : "m3", reference.in_file, extent ? "m2" : "m3");
    return text + skipped_text("reference", reference.without_geometry);
}

}  // namespace game
