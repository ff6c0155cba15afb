#include "tests/support/include_rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <utility>

namespace support {

namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string_view>;

// The headers that sources of one folder may include. A folder within a room may have its own rule, which
// replaces the room's. An entry that ends in '/' covers a folder and all below it; any other entry covers
// headers whose path begins with it.
struct Room {
    std::string name;
    bool anything = false;    // all libraries; rooms are still checked
    Names rooms;              // our own headers
    Names libraries = {};     // beside standard headers
    Names not_standard = {};  // forbidden standard headers
};

const Names kSimLibraries{"glm/", "xxhash.h", "xxh_x86dispatch.h", "experimental/simd"};
const Names kNotInSim{"filesystem", "fstream", "chrono", "ctime"};

// Folders of game/, lowest floor first: each may include only those before it.
const Names kGameFloors{"game/base/",  "game/words/",     "game/files/",    "game/pages/",
                        "game/scene/", "game/recording/", "game/session/",  "game/analysis/",
                        "game/share/", "game/compare/",   "game/ensemble/", "game/figures/",
                        "game/bench/", "game/controls/",  "game/sound/",    "game/live/",
                        "game/ui/",    "game/app/",       "game/commands/", "game/python/"};

// Folders of render/ without OpenGL, lowest floor first: each may include only those before it.
const Names kRenderFloors{"render/base/", "render/pictures/",  "render/view/",  "render/mountain/",
                          "render/flow/", "render/buildings/", "render/woods/", "render/frame/"};

std::vector<Room> make_rooms() {
    std::vector<Room> rooms;
    const auto in_sim = [&](std::string name, Names may) {
        rooms.push_back({.name = std::move(name),
                         .rooms = std::move(may),
                         .libraries = kSimLibraries,
                         .not_standard = kNotInSim});
    };
    in_sim("sim/core", {"sim/core/"});
    in_sim("sim/simd", {"sim/simd/", "sim/core/"});
    in_sim("sim/world", {"sim/world/", "sim/simd/", "sim/core/"});
    in_sim("sim/stages", {"sim/stages/", "sim/world/", "sim/simd/", "sim/core/"});
    in_sim("sim/bcre", {"sim/bcre/", "sim/stages/", "sim/world/", "sim/simd/", "sim/core/"});
    in_sim("sim/momentum", {"sim/momentum/", "sim/stages/", "sim/world/", "sim/simd/", "sim/core/"});
    in_sim("sim/sweep", {"sim/sweep/", "sim/bcre/", "sim/momentum/", "sim/stages/", "sim/world/", "sim/simd/",
                         "sim/core/"});
    in_sim("sim/weather", {"sim/weather/", "sim/world/", "sim/simd/", "sim/core/"});
    in_sim("sim/front", {"sim/front/", "sim/simd/", "sim/core/"});
    in_sim("sim/powder", {"sim/powder/", "sim/world/", "sim/core/"});
    in_sim("sim/carried", {"sim/carried/", "sim/world/", "sim/core/"});
    in_sim("sim/fields", {"sim/fields/", "sim/front/", "sim/core/"});
    in_sim("sim", {"sim/"});

    const Names below_game{"render/", "terrains/", "files/", "sim/", "assets/"};
    Names may = below_game;
    for (const std::string_view floor : kGameFloors) {
        may.push_back(floor);
        rooms.push_back(
            {.name = std::string(floor.substr(0, floor.size() - 1)), .anything = true, .rooms = may});
    }
    may.push_back("game/");
    rooms.push_back({.name = "game", .anything = true, .rooms = may});

    rooms.push_back({.name = "files",
                     .rooms = {"files/"},
                     .libraries = {"dlfcn.h", "link.h", "fcntl.h", "unistd.h", "sys/", "fmt/", "tl/"}});
    rooms.push_back(
        {.name = "terrains",
         .rooms = {"terrains/", "files/", "sim/core/grid.h", "sim/core/check.h"},
         .libraries = {"gdal", "ogr_", "ogrsf_", "proj.h", "fcntl.h", "unistd.h", "sys/stat.h", "cpl_",
                       "OpenImageIO/", "GeographicLib/", "nlohmann/", "glm/", "fmt/", "tl/"}});
    rooms.push_back({.name = "terrains/massif", .rooms = {"terrains/massif/", "sim/core/angle.h"}});
    const Names below_render{"files/", "sim/", "assets/"};
    const Names gl{"glm/", "epoxy/", "EGL/", "fmt/", "tl/"};
    may = below_render;
    for (const std::string_view floor : kRenderFloors) {
        may.push_back(floor);
        rooms.push_back({.name = std::string(floor.substr(0, floor.size() - 1)),
                         .rooms = may,
                         .libraries = {"glm/", "OpenImageIO/", "fmt/", "tl/"}});
    }
    rooms.push_back(
        {.name = "render/textures",
         .rooms = {"render/textures/", "render/base/", "render/pictures/", "assets/shaders/slots.glsl"},
         .libraries = {"glm/", "tl/"}});
    rooms.push_back({.name = "render/gl",
                     .rooms = {"render/gl/", "render/base/", "files/", "sim/core/", "assets/"},
                     .libraries = gl});
    may.insert(may.end(), {"render/gl/", "render/passes/"});
    rooms.push_back({.name = "render/passes", .rooms = may, .libraries = gl});
    may.push_back("render/");
    rooms.push_back({.name = "render", .rooms = may, .libraries = gl});
    rooms.push_back({.name = "tests",
                     .anything = true,
                     .rooms = {"tests/", "game/", "render/", "terrains/", "files/", "sim/", "assets/"}});
    return rooms;
}

const std::vector<Room>& rooms() {
    static const std::vector<Room> kRooms = make_rooms();
    return kRooms;
}

// Libraries that only one file or folder may use.
struct Keeper {
    std::string_view library, place;
};
constexpr std::array<Keeper, 3> kKeepers{
    {{"CLI/", "game/command_line.cpp"}, {"GLFW/", "game/app/window.cpp"}, {"pybind11/", "game/python/"}}};

bool begins_with_one_of(std::string_view path, const std::vector<std::string_view>& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view beginning) { return path.starts_with(beginning); });
}

bool is_one_of(std::string_view name, const std::vector<std::string_view>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view first_folder(std::string_view path) {
    return path.substr(0, path.find('/'));
}

bool is_in_the_house(std::string_view path) {
    const std::string_view folder = first_folder(path);
    return folder == "assets" ||
           std::any_of(rooms().begin(), rooms().end(), [&](const Room& room) { return room.name == folder; });
}

// The rule of the innermost folder that has one.
const Room* room_of(std::string_view file) {
    const Room* innermost = nullptr;
    for (const Room& room : rooms())
        if (file.starts_with(room.name + "/") && (!innermost || room.name.size() > innermost->name.size()))
            innermost = &room;
    return innermost;
}

// <vector>, but not <unistd.h> or <glm/vec3.hpp>.
bool is_standard(std::string_view header) {
    return header.find_first_of("./") == std::string_view::npos;
}

bool is_kept_from(std::string_view file, std::string_view header) {
    return std::any_of(kKeepers.begin(), kKeepers.end(), [&](const Keeper& keeper) {
        return header.starts_with(keeper.library) && !file.starts_with(keeper.place);
    });
}

bool may_include(const Room& room, std::string_view file, std::string_view header) {
    if (is_kept_from(file, header)) return false;
    if (is_in_the_house(header)) return begins_with_one_of(header, room.rooms);
    if (room.anything) return true;
    if (is_standard(header)) return !is_one_of(header, room.not_standard);
    return begins_with_one_of(header, room.libraries);
}

// For one of our own headers, its path from the top of the checkout; for a library's, the name as written. A
// quoted name that begins with no room is a neighbour of the file; "../" may lead it out of the room.
std::string resolve(std::string_view file, char quote, const std::string& name) {
    std::string normal = fs::path(name).lexically_normal().generic_string();
    if (quote == '<' || is_in_the_house(normal)) return normal;
    return (fs::path(file).parent_path() / name).lexically_normal().generic_string();
}

}  // namespace

std::vector<Include> includes_of(std::string_view file, std::string_view text) {
    static const std::regex kInclude(
        R"(^\s*#\s*(?:include|include_next|import)\b\s*(?:([<"])([^>"]+)[>"])?.*)");
    std::vector<Include> includes;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (!std::regex_match(line, match, kInclude)) continue;
        includes.push_back(
            {number, match[1].matched ? resolve(file, *match[1].first, match[2]) : std::string()});
    }
    return includes;
}

std::vector<Breach> breaches_in(std::string_view file, std::string_view text) {
    const Room* room = room_of(file);
    if (!room) return {{std::string(file), 0, "is in no room that the include rules know"}};

    std::vector<Breach> breaches;
    for (const auto& [line, header] : includes_of(file, text)) {
        if (header.empty()) {
            breaches.push_back({std::string(file), line, "includes a name that cannot be read off the line"});
            continue;
        }
        if (may_include(*room, file, header)) continue;
        const std::string shown = is_in_the_house(header) ? header : "<" + header + ">";
        breaches.push_back({std::string(file), line,
                            (is_kept_from(file, header) ? std::string(file) : std::string(room->name)) +
                                " may not include " + shown});
    }
    return breaches;
}

std::vector<fs::path> sources_of(const fs::path& top) {
    static const std::vector<std::string_view> kEndings{".h", ".hpp", ".cpp", ".cc", ".inc", ".inl"};
    std::vector<fs::path> sources;
    for (const Room& room : rooms()) {
        if (room.name.find('/') != std::string::npos) continue;  // is within another one
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top / room.name))
            if (entry.is_regular_file() && is_one_of(entry.path().extension().string(), kEndings))
                sources.push_back(entry.path().lexically_relative(top));
    }
    std::sort(sources.begin(), sources.end());
    return sources;
}

}  // namespace support
