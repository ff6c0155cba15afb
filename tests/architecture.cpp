#include "tests/architecture.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "tests/support/include_rules.h"

namespace architecture {

namespace {

namespace fs = std::filesystem;

// A room is a folder with sources, by its path from the top of the checkout.
struct Room {
    std::string_view path;
    int column;  // of its panel, in half columns from the left
    std::string_view name, duty;
};

constexpr Room kRooms[] = {
    {"game", 5, "main", "options, exit status"},
    {"game/commands", 5, "commands", "one subcommand each"},
    {"game/python", 2, "python", "import couloir"},
    {"game/compare", 2, "compare", "two runs side by side"},
    {"game/ensemble", 0, "ensemble", "how likely"},
    {"game/figures", 4, "figures", "the paper's figures"},
    {"game/bench", 6, "bench", "cost of each stage"},
    {"game/app", 8, "app", "window and its frame"},
    {"game/share", 0, "share", "a slide as a page"},
    {"game/analysis", 3, "analysis", "run-out, exports"},
    {"game/pages", 5, "pages", "tables and plots"},
    {"game/ui", 8, "ui", "panels"},
    {"game/live", 10, "live", "a page that plays"},
    {"game/controls", 8, "controls", "input, brush, cameras"},
    {"game/sound", 10, "sound", "what is heard, OpenAL"},
    {"game/session", 5, "session", "a running world, undo"},
    {"game/recording", 5, "recording", "recorder, reader"},
    {"game/scene", 5, "scene", "TOML to a scenario"},
    {"game/files", 4, "files", "text, TOML, OBJ, NPY"},
    {"game/words", 9, "words", "languages"},
    {"game/base", 5, "base", "outcomes, limits"},
    {"render", 3, "draw", "all passes, in order"},
    {"render/passes", 3, "passes", "one pass each"},
    {"render/gl", 5, "gl", "contexts, GL names"},
    {"render/frame", 2, "frame", "what a frame shows"},
    {"render/flow", 0, "flow", "slides and powder"},
    {"render/buildings", 1, "buildings", "their triangles"},
    {"render/woods", 3, "woods", "trees, and their light"},
    {"render/mountain", 1, "mountain", "ground, shadows"},
    {"render/view", 0, "view", "camera, light, look"},
    {"render/textures", 4, "textures", "recipes of textures"},
    {"render/base", 2, "base", "noise, rectangles"},
    {"render/pictures", 6, "pictures", "PNG, by a module"},
    {"terrains", 0, "terrains", "mountains from files"},
    {"terrains/massif", 0, "massif", "a mountain by erosion"},
    {"sim", 1, "step", "a tick, on one screen"},
    {"sim/verification", 1, "verification", "exact answers"},
    {"sim/sweep", 1, "sweep", "many cells at a time"},
    {"sim/bcre", 0, "bcre", "model with one speed"},
    {"sim/momentum", 2, "momentum", "models with forces"},
    {"sim/stages", 0, "stages", "shared by the models"},
    {"sim/weather", 4, "weather", "snow, hour by hour"},
    {"sim/world", 1, "world", "state, commands, hash"},
    {"sim/fields", 6, "fields", "known fronts"},
    {"sim/powder", 4, "powder", "powder above a flow"},
    {"sim/carried", 8, "carried", "boulders and trunks"},
    {"sim/front", 6, "front", "fronts and textures"},
    {"sim/simd", 2, "simd", "numbers of any width"},
    {"sim/core", 2, "core", "grid, field, threads"},
    {"files", 0, "files", "whole or not at all"},
};

// A top-level folder. Sizes are pixels.
struct Panel {
    std::string_view name, duty;
    int left, top, width;
};

constexpr int kBoxWidth = 150, kBoxHeight = 36, kFloor = 56, kColumn = 80;
constexpr int kPad = 14, kHeading = 32, kGap = 40;
constexpr int kTop = 92, kLeft = 24, kRight = kLeft + 5 * kPad + 8 * kColumn + 2 * kBoxWidth;
constexpr int kWaysLeft = kRight + 30, kWidth = 1360;

// A stop of a way, in the files that do its work.
struct Stop {
    std::string_view name;
    std::vector<std::string_view> files;
};

struct Way {
    std::string_view title, duty, colour;
    bool round;  // its marks: circles, or else squares
    std::vector<Stop> stops;
};

const std::vector<Way>& ways() {
    static const std::vector<Way> kWays{
        {"The way of a grain",
         "from a terrain file to pixels",
         "#b45309",
         true,
         {{"terrain file", {"terrains/dem_gdal.cpp"}},
          {"terrain", {"terrains/resample.cpp"}},
          {"state", {"sim/world/state.h"}},
          {"command", {"sim/world/command.cpp"}},
          {"stages", {"sim/bcre/stages.h", "sim/momentum/stages.h"}},
          {"velocities", {"sim/bcre/velocity.h", "sim/momentum/forces.h"}},
          {"detector", {"sim/front/detector.cpp"}},
          {"tracker", {"sim/front/tracker.cpp"}},
          {"textures", {"sim/front/texture_layers.cpp"}},
          {"upload", {"render/passes/flow_to_gpu.cpp"}},
          {"remesh", {"render/passes/remesher.cpp"}},
          {"passes", {"render/passes/flow_pass.cpp"}},
          {"pixels", {"render/passes/target.cpp"}}}},
        {"The way of a command",
         "the only way to change a world",
         "#1d4ed8",
         false,
         {{"input or recording", {"game/controls/brush.cpp", "game/recording/reader.cpp"}},
          {"manifest", {"sim/world/command.h"}},
          {"recorder", {"game/recording/recorder.cpp"}},
          {"apply", {"sim/step.cpp"}},
          {"stages", {"sim/sweep/sweep.h"}},
          {"hash", {"sim/world/state_hash.cpp"}}}},
    };
    return kWays;
}

using Names = std::set<std::string>;
using Graph = std::map<std::string, Names>;  // what each room or panel includes

std::string panel_of(const std::string& room) {
    return room.substr(0, room.find('/'));
}

Graph includes_of_rooms(const fs::path& top) {
    Graph graph;
    for (const fs::path& source : support::sources_of(top)) {
        const std::string file = source.generic_string(), room = source.parent_path().generic_string();
        if (panel_of(room) == "tests") continue;
        std::ifstream stream(top / source);
        const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        Names& included = graph[room];
        for (const support::Include& include : support::includes_of(file, text))
            if (const fs::path header = include.header; header.has_parent_path() && fs::exists(top / header))
                included.insert(header.parent_path().generic_string());
    }
    for (auto& [room, included] : graph) {
        included.erase(room);
        std::erase_if(included, [&](const std::string& name) { return !graph.contains(name); });
    }
    return graph;
}

// The rooms of one panel, without the others.
Graph within(const Graph& graph, std::string_view panel) {
    Graph part;
    for (const auto& [room, included] : graph) {
        if (panel_of(room) != panel) continue;
        for (const std::string& name : included)
            if (panel_of(name) == panel) part[room].insert(name);
        part[room];
    }
    return part;
}

Graph between_panels(const Graph& graph) {
    Graph panels;
    for (const auto& [room, included] : graph)
        for (const std::string& name : included)
            if (panel_of(name) != panel_of(room)) panels[panel_of(room)].insert(panel_of(name));
    return panels;
}

Names reach_of(const Graph& graph, const std::string& from) {
    Names reached;
    std::vector<std::string> open{from};
    while (!open.empty()) {
        const std::string name = open.back();
        open.pop_back();
        if (!graph.contains(name)) continue;
        for (const std::string& next : graph.at(name))
            if (reached.insert(next).second) open.push_back(next);
    }
    return reached;
}

bool reaches(const Graph& graph, const std::string& from, const std::string& to) {
    return reach_of(graph, from).contains(to);
}

// Without arrows that follow from others, and without those between rooms that include one another.
Graph reduced(const Graph& graph) {
    Graph rest;
    for (const auto& [name, included] : graph)
        for (const std::string& to : included) {
            const bool mutual = reaches(graph, to, name);
            const bool follows =
                std::any_of(included.begin(), included.end(), [&, from = name](const std::string& over) {
                    return over != to && reaches(graph, over, to) && !reaches(graph, over, from);
                });
            if (!mutual && !follows) rest[name].insert(to);
        }
    return rest;
}

// The floor of each room, 0 at the bottom: above all that it includes, and close below what includes it.
std::map<std::string, int> floors_of(const Graph& graph) {
    const Graph arrows = reduced(graph);
    std::map<std::string, int> floors;
    for (const auto& [name, included] : graph) floors[name] = 0;
    for (std::size_t round = 0; round < graph.size(); ++round)
        for (const auto& [name, included] : arrows)
            for (const std::string& to : included) floors[name] = std::max(floors[name], floors[to] + 1);
    for (std::size_t round = 0; round < graph.size(); ++round)
        for (auto& [name, floor] : floors) {
            int lowest_user = -1;
            for (const auto& [user, included] : arrows)
                if (included.contains(name) && (lowest_user < 0 || floors[user] < lowest_user))
                    lowest_user = floors[user];
            if (lowest_user >= 0) floor = lowest_user - 1;
        }
    return floors;
}

// About the most that words take in a common sans-serif font, pixels.
int width_of(std::string_view words, int size) {
    int hundredths = 0;
    for (const char letter : words)
        if (std::string_view("mwMW").find(letter) != std::string_view::npos)
            hundredths += 95;
        else
            hundredths += std::string_view("fijlrt,.'/ ").find(letter) != std::string_view::npos ? 38 : 64;
    return hundredths * size / 100;
}

struct Box {
    int left, top, width, height;

    int right() const { return left + width; }
    int bottom() const { return top + height; }
    bool holds(int x, int y) const { return x > left && x < right() && y > top && y < bottom(); }
    bool touches(const Box& other) const {
        return left < other.right() && other.left < right() && top < other.bottom() && other.top < bottom();
    }
};

// Writes the elements of an SVG file. All coordinates are whole, so the text is the same on every machine.
class Canvas {
  public:
    std::string text() const { return out_.str(); }

    void rectangle(const Box& box, int round, std::string_view style) {
        out_ << "<rect x=\"" << box.left << "\" y=\"" << box.top << "\" width=\"" << box.width
             << "\" height=\"" << box.height << "\" rx=\"" << round << "\" " << style << "/>\n";
    }
    void circle(int x, int y, int radius, std::string_view style) {
        out_ << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << radius << "\" " << style << "/>\n";
    }
    void line(int x0, int y0, int x1, int y1, std::string_view style) {
        out_ << "<path d=\"M" << x0 << " " << y0 << "L" << x1 << " " << y1 << "\" " << style << "/>\n";
    }
    void curve(int x0, int y0, int x1, int y1) {
        const int bend = (y1 - y0) / 2;
        out_ << "<path d=\"M" << x0 << " " << y0 << "C" << x0 << " " << y0 + bend << " " << x1 << " "
             << y1 - bend << " " << x1 << " " << y1 << "\" class=\"arrow\"/>\n";
    }
    void write(int x, int y, std::string_view style, std::string_view words) {
        out_ << "<text x=\"" << x << "\" y=\"" << y << "\" " << style << ">" << words << "</text>\n";
    }

  private:
    std::ostringstream out_;
};

class Drawing {
  public:
    Drawing(const fs::path& top, Picture& picture)
        : top_(top), graph_(includes_of_rooms(top)), picture_(picture) {}

    void draw() {
        place();
        if (!picture_.faults.empty()) return;
        check_ways();
        draw_panels();
        draw_arrows();
        draw_boxes();
        const int end = std::max(bottom_, draw_ways()) + 24;
        picture_.svg = heading(end) + canvas_.text() + "</svg>\n";
    }

  private:
    void fault(std::string fact) { picture_.faults.push_back(std::move(fact)); }

    static const Room* room_at(std::string_view path) {
        const auto* found = std::find_if(std::begin(kRooms), std::end(kRooms),
                                         [&](const Room& room) { return room.path == path; });
        return found == std::end(kRooms) ? nullptr : found;
    }

    void place() {
        for (const auto& [room, included] : graph_)
            if (!room_at(room)) fault(room + " has no line in kRooms");
        for (const Room& room : kRooms)
            if (!graph_.contains(std::string(room.path)))
                fault("kRooms has a line for " + std::string(room.path) + ", which has no sources");
        if (!picture_.faults.empty()) return;

        const int whole = kRight - kLeft;
        const int narrow = 2 * kPad + kBoxWidth;
        int y = kTop;
        y = place_panel({"game", "what a person does and sees", kLeft, y, whole}) + kGap;
        const int middle = y;
        y = place_panel({"render", "pixels from views", kLeft, middle, whole - narrow - kPad}) + kGap;
        place_panel({"terrains", "", kRight - narrow, middle, narrow});
        bottom_ = place_panel({"sim", "the world; knows none of the above", kLeft, y, whole - narrow - kPad});
        place_panel({"files", "", kRight - narrow, y, narrow});
        for (const auto& [panel, box] : panels_)
            if (within(graph_, panel).empty()) fault(panel + " has no rooms");
        for (const auto& [room, included] : graph_)
            if (!boxes_.contains(room)) fault(panel_of(room) + " has no panel");
        for (auto a = boxes_.begin(); a != boxes_.end(); ++a)
            for (auto b = std::next(a); b != boxes_.end(); ++b)
                if (a->second.touches(b->second)) fault(a->first + " would lie upon " + b->first);
    }

    // Returns its bottom.
    int place_panel(const Panel& panel) {
        const auto floors = floors_of(within(graph_, panel.name));
        int highest = 0;
        for (const auto& [room, floor] : floors) highest = std::max(highest, floor);
        const int height = kHeading + highest * kFloor + kBoxHeight + kPad;
        panels_[std::string(panel.name)] = {panel.left, panel.top, panel.width, height};
        duties_[std::string(panel.name)] = panel.duty;
        int columns = 0;
        for (const auto& [room, floor] : floors) columns = std::max(columns, room_at(room)->column);
        const int margin = (panel.width - columns * kColumn - kBoxWidth) / 2;
        if (margin < kPad) fault(std::string(panel.name) + " is too narrow for its rooms");
        for (const auto& [room, floor] : floors) {
            const int x = panel.left + margin + kColumn * room_at(room)->column;
            boxes_[room] = {x, panel.top + kHeading + (highest - floor) * kFloor, kBoxWidth, kBoxHeight};
        }
        return panel.top + height;
    }

    void check_ways() {
        for (const Way& way : ways())
            for (const Stop& stop : way.stops)
                for (const std::string_view file : stop.files) {
                    const std::string name = std::string(way.title) + ": " + std::string(stop.name);
                    if (!fs::exists(top_ / file)) fault(name + ": no " + std::string(file));
                    if (!boxes_.contains(fs::path(file).parent_path().generic_string()))
                        fault(name + ": no room holds " + std::string(file));
                }
    }

    void draw_panels() {
        for (const auto& [name, box] : panels_) {
            canvas_.rectangle(box, 8, "class=\"panel\"");
            canvas_.write(box.left + kPad, box.top + 21, "class=\"folder\"", name + "/");
            canvas_.write(box.left + kPad + 12 + width_of(name + "/", 15), box.top + 21, "class=\"duty\"",
                          duties_[name]);
        }
    }

    // An arrow starts and ends at equal distances along the sides of its boxes, in the order of the other ends.
    void draw_arrows() {
        for (const auto& [panel, box] : panels_) {
            const Graph arrows = reduced(within(graph_, panel));
            for (const auto& [from, included] : arrows)
                for (const std::string& to : included) {
                    const int x0 = port(boxes_[from], ends_below(arrows, from), to);
                    const int x1 = port(boxes_[to], ends_above(arrows, to), from);
                    arrow(from, to, x0, x1);
                }
            draw_tie(panel);
        }
        draw_arrows_between_panels();
    }

    using Ends = std::vector<std::string>;

    Ends in_order(Ends ends) const {
        std::sort(ends.begin(), ends.end(), [&](const std::string& a, const std::string& b) {
            return std::pair(boxes_.at(a).left, a) < std::pair(boxes_.at(b).left, b);
        });
        return ends;
    }
    Ends ends_below(const Graph& arrows, const std::string& from) const {
        return in_order({arrows.at(from).begin(), arrows.at(from).end()});
    }
    Ends ends_above(const Graph& arrows, const std::string& to) const {
        Ends ends;
        for (const auto& [from, included] : arrows)
            if (included.contains(to)) ends.push_back(from);
        return in_order(ends);
    }
    static int port(const Box& box, const Ends& ends, const std::string& end) {
        const auto at = std::find(ends.begin(), ends.end(), end) - ends.begin() + 1;
        return box.left + box.width * static_cast<int>(at) / (static_cast<int>(ends.size()) + 1);
    }

    void arrow(const std::string& from, const std::string& to, int x0, int x1) {
        const int y0 = boxes_[from].bottom(), y1 = boxes_[to].top - 2;
        if (y1 <= y0) fault("the arrow from " + from + " to " + to + " would not go down");
        for (int step = 0; step <= 64; ++step) {
            const double t = step / 64.0, s = 1 - t, over = 3 * s * t * t + t * t * t;
            const int x = static_cast<int>(x0 + (x1 - x0) * over);
            const int y = static_cast<int>(y0 + (y1 - y0) * (1.5 * s * s * t + 1.5 * s * t * t + t * t * t));
            for (const auto& [room, box] : boxes_)
                if (room != from && room != to && box.holds(x, y))
                    fault("the arrow from " + from + " to " + to + " would run through " + room);
        }
        canvas_.curve(x0, y0, x1, y1);
    }

    // Rooms on one floor that include one another are joined by a bar.
    void draw_tie(const std::string& panel) {
        const Graph rooms = within(graph_, panel);
        for (const auto& [room, included] : rooms)
            for (const std::string& other : included)
                if (room < other && reaches(rooms, other, room)) {
                    const Box &a = boxes_[room], &b = boxes_[other];
                    const int y = a.top + a.height / 2;
                    canvas_.line(std::min(a.right(), b.right()), y, std::max(a.left, b.left), y,
                                 "class=\"tie\"");
                }
    }

    void draw_arrows_between_panels() {
        for (const auto& [from, included] : reduced(between_panels(graph_)))
            for (const std::string& to : included) {
                const Box &above = panels_[from], &below = panels_[to];
                if (below.top <= above.bottom()) fault(from + " does not stand above " + to);
                const int left = std::max(above.left, below.left);
                const int right = std::min(above.right(), below.right());
                const int middle = (left + right) / 2;
                if (left < right)
                    canvas_.line(middle, above.bottom(), middle, below.top - 2, "class=\"wide\"");
                else
                    canvas_.line(above.left < below.left ? above.right() - 20 : above.left + 20,
                                 above.bottom(),
                                 above.left < below.left ? below.left + 20 : below.right() - 20,
                                 below.top - 2, "class=\"wide\"");
            }
    }

    void draw_boxes() {
        for (const auto& [path, box] : boxes_) {
            const Room& room = *room_at(path);
            canvas_.rectangle(box, 5, "class=\"room\"");
            canvas_.write(box.left + 9, box.top + 15, "class=\"name\"", room.name);
            canvas_.write(box.left + 9, box.top + 29, "class=\"duty\"", room.duty);
            int x = box.right() - 11;
            for (auto way = ways().rbegin(); way != ways().rend(); ++way)
                for (std::size_t at = way->stops.size(); at-- > 0;) {
                    if (!stops_in(way->stops[at], path)) continue;
                    mark(*way, at, x, box.top + 11);
                    x -= 17;
                }
            const int name_end = box.left + 9 + width_of(room.name, 12);
            if (9 + width_of(room.duty, 11) > box.width - 4) fault("the duty of " + path + " is too long");
            if (x + 8 < name_end) fault("the marks of " + path + " would cover its name");
        }
    }

    static bool stops_in(const Stop& stop, const std::string& room) {
        return std::any_of(stop.files.begin(), stop.files.end(), [&](std::string_view file) {
            return fs::path(file).parent_path().generic_string() == room;
        });
    }

    // Grains have numbers, commands letters, so that black and white print tells them apart too.
    void mark(const Way& way, std::size_t at, int x, int y) {
        const std::string fill = "fill=\"" + std::string(way.colour) + "\"";
        if (way.round)
            canvas_.circle(x, y, 7, fill);
        else
            canvas_.rectangle({x - 7, y - 7, 14, 14}, 2, fill);
        const std::string sign =
            way.round ? std::to_string(at + 1) : std::string(1, static_cast<char>('a' + at));
        canvas_.write(x, y + 3, "class=\"mark\"", sign);
    }

    // Returns the bottom of the last one.
    int draw_ways() {
        int y = kTop;
        for (const Way& way : ways()) {
            const std::string fill = "fill=\"" + std::string(way.colour) + "\"";
            canvas_.write(kWaysLeft, y + 16, "class=\"folder\" " + fill, way.title);
            canvas_.write(kWaysLeft, y + 34, "class=\"duty\"", way.duty);
            y += 58;
            const int last = y + 40 * static_cast<int>(way.stops.size() - 1);
            canvas_.line(kWaysLeft + 8, y, kWaysLeft + 8, last,
                         "stroke=\"" + std::string(way.colour) + "\" stroke-width=\"2\" opacity=\"0.45\"");
            for (std::size_t at = 0; at < way.stops.size(); ++at, y += 40) {
                mark(way, at, kWaysLeft + 8, y);
                canvas_.write(kWaysLeft + 26, y + 1, "class=\"name\"", way.stops[at].name);
                canvas_.write(kWaysLeft + 26, y + 15, "class=\"duty\"", files_in(way.stops[at]));
            }
            y += 24;
        }
        return draw_legend(y);
    }

    static std::string files_in(const Stop& stop) {
        std::string words;
        for (const std::string_view file : stop.files)
            words += (words.empty() ? "" : ", ") + fs::path(file).replace_extension().generic_string();
        return words;
    }

    int draw_legend(int y) {
        canvas_.write(kWaysLeft, y + 8, "class=\"folder\"", "Signs");
        y += 34;
        canvas_.line(kWaysLeft + 8, y - 10, kWaysLeft + 8, y + 10, "class=\"arrow\"");
        canvas_.write(kWaysLeft + 26, y + 4, "class=\"duty\"", "includes; implied arrows are left out");
        y += 32;
        canvas_.line(kWaysLeft + 8, y - 10, kWaysLeft + 8, y + 8, "class=\"wide\"");
        canvas_.write(kWaysLeft + 26, y + 4, "class=\"duty\"", "the same between top-level folders");
        y += 28;
        canvas_.line(kWaysLeft, y, kWaysLeft + 16, y, "class=\"tie\"");
        canvas_.write(kWaysLeft + 26, y + 4, "class=\"duty\"", "rooms that include one another");
        return y + 10;
    }

    static std::string heading(int height) {
        const std::string size = std::to_string(kWidth) + " " + std::to_string(height);
        const std::string sides =
            "width=\"" + std::to_string(kWidth) + "\" height=\"" + std::to_string(height) + "\"";
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" " + sides +
               R"( font-family="sans-serif" role="img" aria-labelledby="title">
<title id="title">The rooms of Couloir, and the ways of a grain and of a command through them</title>
<!-- Drawn from the includes by tests/architecture.cpp: COULOIR_RENEW_ARCHITECTURE=1 layering_test -->
<style>
.panel { fill: #ffffff; stroke: #d5d2c8; }
.room { fill: #f1f4f6; stroke: #aeb9c2; }
.arrow { fill: none; stroke: #7b8794; stroke-width: 1.2; marker-end: url(#head); }
.wide { fill: none; stroke: #4a5560; stroke-width: 2; marker-end: url(#widehead); }
.tie { stroke: #7b8794; stroke-width: 4; }
.title { font-size: 22px; font-weight: bold; fill: #1f2933; }
.folder { font-size: 15px; font-weight: bold; }
.name { font-size: 12px; font-weight: bold; fill: #1f2933; }
.duty { font-size: 11px; fill: #4a5560; }
.mark { font-size: 9px; font-weight: bold; fill: #ffffff; text-anchor: middle; }
</style>
<defs>
<marker id="head" markerUnits="userSpaceOnUse" markerWidth="8" markerHeight="8" refX="6" refY="4" orient="auto">
<path d="M0 0.5L7 4L0 7.5z" fill="#7b8794"/></marker>
<marker id="widehead" markerUnits="userSpaceOnUse" markerWidth="12" markerHeight="12" refX="9" refY="6" orient="auto">
<path d="M0 0.5L11 6L0 11.5z" fill="#4a5560"/></marker>
</defs>
<rect width="100%" height="100%" fill="#faf8f3"/>
<text x="24" y="42" class="title">The rooms of Couloir</text>
<text x="24" y="66" class="duty">A room is a folder of sources. It includes only rooms below it. tests/ may include any room, and no room includes tests/.</text>
)";
    }

    const fs::path top_;
    const Graph graph_;
    Picture& picture_;
    Canvas canvas_;
    std::map<std::string, Box> panels_, boxes_;
    std::map<std::string, std::string> duties_;
    int bottom_ = 0;
};

}  // namespace

Picture draw(const fs::path& top) {
    Picture picture;
    Drawing(top, picture).draw();
    return picture;
}

}  // namespace architecture
