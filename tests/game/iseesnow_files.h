#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "tests/game/program.h"

// Files of ISeeSnow (github.com/avaframe/ISeeSnow), and how its participants' results were measured:
// docs/results/iseesnow.md.
namespace game::test::iseesnow {

// A raster as ISeeSnow writes it. Rows from north to south.
struct Raster {
    std::map<std::string, std::string> header;  // keys in lower case
    int columns = 0, rows = 0;
    double west = 0, south = 0, cell = 0;  // of the centre of the south-west pixel
    std::vector<double> values;

    static Raster read(const std::filesystem::path& path) {
        std::ifstream file(path);
        Raster raster;
        std::string key, value;
        for (int i = 0; i < 6; ++i) {
            file >> key >> value;
            std::transform(key.begin(), key.end(), key.begin(), [](char c) { return std::tolower(c); });
            raster.header[key] = value;
        }
        const auto number = [&](const char* name) { return std::stod(raster.header.at(name)); };
        raster.columns = static_cast<int>(number("ncols")), raster.rows = static_cast<int>(number("nrows"));
        raster.west = number("xllcenter"), raster.south = number("yllcenter");
        raster.cell = number("cellsize");
        while (file >> value)
            raster.values.push_back(value == "nan" ? std::numeric_limits<double>::quiet_NaN()
                                                   : std::stod(value));
        return raster;
    }
    double x(int column) const { return west + cell * column; }
    double y(int row) const { return south + cell * (rows - 1 - row); }
    double at(int column, int row) const {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
    // Bilinear.
    double between(double px, double py) const {
        const double c = (px - west) / cell, r = rows - 1 - (py - south) / cell;
        const int i = std::clamp(static_cast<int>(c), 0, columns - 2),
                  j = std::clamp(static_cast<int>(r), 0, rows - 2);
        const double u = c - i, v = r - j;
        return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
               v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
    }
    double greatest() const {
        double most = 0;
        for (const double value : values) most = std::max(most, std::isnan(value) ? 0 : value);
        return most;
    }
};

struct Point {
    double x, y;
};

// The first polyline of a shapefile.
inline std::vector<Point> read_path(const std::filesystem::path& path) {
    const std::string bytes = read_bytes(path);
    const auto number = [&]<class T>(std::size_t at, T value) {
        std::memcpy(&value, bytes.data() + at, sizeof value);
        return value;
    };
    constexpr std::size_t kRecord = 100 + 8;  // after the file's and the record's header
    const auto parts = number(kRecord + 36, std::int32_t{}), points = number(kRecord + 40, std::int32_t{});
    std::vector<Point> line;
    for (int i = 0; i < points; ++i) {
        const std::size_t at =
            kRecord + 44 + 4 * static_cast<std::size_t>(parts) + 16 * static_cast<std::size_t>(i);
        line.push_back({number(at, 0.), number(at + 8, 0.)});
    }
    return line;
}

// The farthest station along the path, m in plan, of a pixel that reaches `least` within 700 m of the path.
inline double run_out(const Raster& raster, const std::vector<Point>& path, double least) {
    constexpr double kWidth = 700;
    double farthest = 0;
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column) {
            if (!(raster.at(column, row) >= least)) continue;
            double nearest = kWidth, station = 0, passed = 0;
            for (std::size_t i = 1; i < path.size(); ++i) {
                const double dx = path[i].x - path[i - 1].x, dy = path[i].y - path[i - 1].y;
                const double length = std::hypot(dx, dy);
                const double px = raster.x(column) - path[i - 1].x, py = raster.y(row) - path[i - 1].y;
                const double along = std::clamp((px * dx + py * dy) / length, 0., length);
                const double away = std::hypot(px - dx * along / length, py - dy * along / length);
                if (away <= nearest) nearest = away, station = passed + along;
                passed += length;
            }
            if (nearest < kWidth) farthest = std::max(farthest, station);
        }
    return farthest;
}

inline Point place_at(const std::vector<Point>& path, double station) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double length = std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
        if (station <= length || i + 1 == path.size()) {
            const double share = station / length;
            return {path[i - 1].x + share * (path[i].x - path[i - 1].x),
                    path[i - 1].y + share * (path[i].y - path[i - 1].y)};
        }
        station -= length;
    }
    return path.front();
}

}  // namespace game::test::iseesnow
