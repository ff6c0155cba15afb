#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sim/world/command.h"
#include "sim/world/thing_places.h"
#include "sim/world/things.h"
#include "terrains/limits.h"

// Limits on input files, by reader. docs/limits.md repeats this table; a test compares the two.
namespace game {

// Recordings.
inline constexpr std::size_t kLongestHeader = std::size_t{256} << 20;  // bytes of the first line
inline constexpr terrains::JsonLimits kHeaderLimits{.depth = 8, .values = 50'000, .members = 256};
inline constexpr std::size_t kLongestLine = std::size_t{64} << 10;  // bytes of any other line
inline constexpr terrains::JsonLimits kLineLimits{.depth = 4, .values = 4096, .members = 64};
inline constexpr int kMostVertices = terrains::kMostSquares + 1;  // along a side of the ground
inline constexpr int kMostTicksPerState = 600;
inline constexpr std::int64_t kMostTicksOfParent = 1'000'000;  // before the first state line of a fork
inline constexpr std::size_t kMostCommands = 4'000'000;

// Reports of bench.
inline constexpr std::size_t kMostReportBytes = std::size_t{64} << 20;
inline constexpr terrains::JsonLimits kReportLimits{.depth = 16, .values = 1'000'000, .members = 1000};

// Ensembles. A line of a journal has the limits of a recording's.
inline constexpr std::size_t kMostJournalBytes = std::size_t{256} << 20;

// Scenes and materials.
inline constexpr std::size_t kMostTomlBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMostTomlKeys = 20'000;  // and table headers
inline constexpr std::size_t kMostDottedKeys = 1000;
inline constexpr std::size_t kMostKeyParts = 8;
inline constexpr std::size_t kMostTomlDepth = 32;                             // of nested lists and tables
inline constexpr double kFarthestPlace = 1e7;                                 // m, of a coordinate of a place
inline constexpr std::size_t kFewestCameraKeys = 2, kMostCameraKeys = 64;     // of a camera path
inline constexpr std::size_t kFewestTreeCorners = 3, kMostTreeCorners = 256;  // of the polygon of [trees]

// Lessons, which are TOML too. Of texts: bytes.
inline constexpr std::size_t kMostLessonBytes = std::size_t{64} << 10;
inline constexpr std::size_t kFewestStops = 2, kMostStops = 12, kFewestAnswers = 2, kMostAnswers = 4;
inline constexpr std::size_t kMostLessonHeading = 80, kMostLessonAbout = 200, kMostLessonText = 600;
inline constexpr std::size_t kMostLessonQuestion = 200, kMostLessonAnswer = 80, kMostLessonWhy = 300;

// Languages.
inline constexpr std::size_t kMostLanguageBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMostMessages = 10'000, kLongestMessage = 4096;  // bytes

inline constexpr std::size_t kMostPlaced = 2000;  // commands of things, done before tick 0

// Meshes and arrays.
inline constexpr std::size_t kLongestMeshLine = std::size_t{64} << 10;  // bytes
inline constexpr std::size_t kMostMeshParts = 20'000'000;               // vertices, and as many triangles
inline constexpr std::uint32_t kLongestArrayHeader = 64u << 10;         // bytes
inline constexpr std::size_t kMostAxes = 8;

struct ReaderLimit {
    std::string_view reader, what;
    std::uint64_t most;
    std::string_view unit;
};
inline constexpr auto kReaderLimits = std::to_array<ReaderLimit>({
    {"recording", "first line", kLongestHeader, "bytes"},
    {"recording", "values in the first line", kHeaderLimits.values, ""},
    {"recording", "members of an object in the first line", kHeaderLimits.members, ""},
    {"recording", "depth of the first line", kHeaderLimits.depth, "levels"},
    {"recording", "vertices along a side", kMostVertices, ""},
    {"recording", "any other line", kLongestLine, "bytes"},
    {"recording", "values in any other line", kLineLimits.values, ""},
    {"recording", "members of an object in any other line", kLineLimits.members, ""},
    {"recording", "depth of any other line", kLineLimits.depth, "levels"},
    {"recording", "ticks from a state line to the next, or to the end", kMostTicksPerState, "ticks"},
    {"recording", "ticks of a fork before its first state line", kMostTicksOfParent, "ticks"},
    {"recording", "commands in all", kMostCommands, ""},
    {"recording, scene", "commands in one tick", sim::kMostCommandsPerTick, ""},
    {"recording, scene", "commands that run at once", sim::kMostRunningCommands, ""},
    {"recording, scene", "corners of a polygon of trees", kMostTreeCorners, ""},
    {"recording, scene, camera path", "keys of a camera path", kMostCameraKeys, ""},
    {"recording, scene", "commands of things before tick 0", kMostPlaced, ""},
    {"recording, scene", "objects that stand in a world", sim::kMostThings, ""},
    {"recording, scene", "vertices that commands of things before tick 0 visit", sim::kAlwaysVisitsBefore,
     ""},
    {"recording, scene", "the same in one tick", sim::kAlwaysVisits, ""},
    {"recording, scene", "the same on a larger grid, of its vertices", sim::kMostVisits, "times"},
    {"journal of an ensemble", "file", kMostJournalBytes, "bytes"},
    {"scene, material, camera path", "file", kMostTomlBytes, "bytes"},
    {"scene, material, camera path", "keys and table headers", kMostTomlKeys, ""},
    {"scene, material, camera path", "dotted keys and table headers", kMostDottedKeys, ""},
    {"scene, material, camera path", "parts of a dotted key", kMostKeyParts, ""},
    {"scene, material, camera path", "lists and tables within each other", kMostTomlDepth, "levels"},
    {"lesson", "file", kMostLessonBytes, "bytes"},
    {"lesson", "stops", kMostStops, ""},
    {"lesson", "answers of a question", kMostAnswers, ""},
    {"lesson", "title, heading, name of the recording", kMostLessonHeading, "bytes"},
    {"lesson", "about", kMostLessonAbout, "bytes"},
    {"lesson", "text of a stop", kMostLessonText, "bytes"},
    {"lesson", "question", kMostLessonQuestion, "bytes"},
    {"lesson", "answer", kMostLessonAnswer, "bytes"},
    {"lesson", "why", kMostLessonWhy, "bytes"},
    {"GeoJSON", "file", terrains::kMostGeoJsonBytes, "bytes"},
    {"GeoJSON", "values", terrains::kGeoJsonLimits.values, ""},
    {"GeoJSON", "members of an object", terrains::kGeoJsonLimits.members, ""},
    {"GeoJSON", "depth", terrains::kGeoJsonLimits.depth, "levels"},
    {"GeoJSON", "points of all rings", terrains::kMostGeoJsonPoints, ""},
    {"elevation raster", "along a side", terrains::kMostDemSide, "pixels"},
    {"elevation raster", "in all", terrains::kMostDemPixels, "pixels"},
    {"elevation raster, picture", "squares along a side that it becomes", terrains::kMostSquares, ""},
    {"depth raster", "in all", terrains::kMostDepthPixels, "pixels"},
    {"picture", "in all", terrains::kMostHeightmapPixels, "pixels"},
    {"picture", "channels", terrains::kMostHeightmapChannels, ""},
    {"language", "file", kMostLanguageBytes, "bytes"},
    {"language", "messages", kMostMessages, ""},
    {"language", "a message", kLongestMessage, "bytes"},
    {"OBJ", "line", kLongestMeshLine, "bytes"},
    {"OBJ", "vertices, and as many triangles", kMostMeshParts, ""},
    {"NPY", "header", kLongestArrayHeader, "bytes"},
    {"NPY", "axes", kMostAxes, ""},
    {"bench report", "file", kMostReportBytes, "bytes"},
    {"bench report", "values", kReportLimits.values, ""},
    {"bench report", "members of an object", kReportLimits.members, ""},
    {"bench report", "depth", kReportLimits.depth, "levels"},
});

}  // namespace game
