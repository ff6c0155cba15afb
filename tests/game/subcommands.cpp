#include "tests/game/subcommands.h"

#include <algorithm>

#include <fmt/format.h>

#include "game/bench/report.h"
#include "game/scene/scene.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

constexpr int kRows = 17;

template <class Height>
std::string raster(Height height) {
    std::string text = fmt::format(
        "ncols {0}\nnrows {0}\nxllcorner 500000\nyllcorner 5200000\ncellsize 5\nNODATA_value -9999\n", kRows);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kRows; ++column) text += fmt::format("{} ", height(column, row));
    return text;
}

constexpr const char* kUtm32 =
    R"(PROJCS["WGS_1984_UTM_Zone_32N",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",)"
    R"(SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],)"
    R"(PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],)"
    R"(PARAMETER["Central_Meridian",9.0],PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0.0],)"
    R"(UNIT["Meter",1.0]])";

// A virtual raster of the size of raster(), whose values are those of another file in its folder.
std::string virtual_raster(const std::string& source) {
    return fmt::format(
        R"(<VRTDataset rasterXSize="{0}" rasterYSize="{0}"><SRS>EPSG:32632</SRS>)"
        R"(<GeoTransform>500000,5,0,5200085,0,-5</GeoTransform><VRTRasterBand dataType="Float32" band="1">)"
        R"(<SimpleSource><SourceFilename relativeToVRT="1">{1}</SourceFilename><SourceBand>1</SourceBand>)"
        R"(</SimpleSource></VRTRasterBand></VRTDataset>)",
        kRows, source);
}

std::string array(const std::string& shape, std::size_t bytes) {
    std::string header = fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': {}, }}", shape);
    while ((header.size() + 11) % 64 != 0) header += ' ';
    header += '\n';
    return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header +
           std::string(bytes, '\0');
}

}  // namespace

std::vector<std::string> Subcommand::with(const std::vector<std::pair<std::string, fs::path>>& given,
                                          const fs::path& folder) const {
    std::vector<std::string> all = arguments;
    const auto add = [&all](const std::string& option, const fs::path& path) {
        all.push_back(option);
        all.push_back(path.string());
    };
    for (const auto& [option, path] : given) add(option, path);
    for (const std::string& option : needed)
        if (std::none_of(given.begin(), given.end(), [&](const auto& each) { return each.first == option; }))
            add(option, folder / ("needed" + option));
    return all;
}

std::vector<Subcommand> writing_subcommands(const fs::path& folder) {
    const auto put = [&folder](const char* name, const std::string& bytes) {
        write_bytes(folder / name, bytes);
        return (folder / name).string();
    };
    const std::string hill = put("hill.asc", raster([](int, int row) { return 1000 + 3 * (kRows - row); }));
    const std::string prj = put("hill.prj", kUtm32);
    const auto patch = [](int column, int row) {
        return column > 5 && column < 11 && row > 3 && row < 9 ? 1 : 0;
    };
    const std::string release = put("release.asc", raster(patch)),
                      reference = put("reference.asc", raster(patch));
    // Rasters that name others, which name others: every file of each chain is an input.
    const auto chain = [&put](const std::string& name, const std::string& values) {
        return std::vector<fs::path>{put((name + ".vrt").c_str(), virtual_raster(name + "_middle.vrt")),
                                     put((name + "_middle.vrt").c_str(), virtual_raster(name + "_base.asc")),
                                     put((name + "_base.asc").c_str(), values),
                                     put((name + "_base.prj").c_str(), kUtm32)};
    };
    const auto hill_chain = chain("far_hill", read_bytes(hill)),
               release_chain = chain("far_release", raster(patch)),
               reference_chain = chain("far_reference", raster(patch));
    std::vector<fs::path> chains = hill_chain;
    for (const auto* each : {&release_chain, &reference_chain})
        chains.insert(chains.end(), each->begin(), each->end());
    const std::string far_scene =
        put("far_scene.toml",
            "[terrain]\nfile = \"far_hill.vrt\"\ngrid = 8\n[cover]\nmaterial = \"soil\"\ndepth = 1\n"
            "[physics]\nmodel = \"bcre\"\n");
    // A binary raster, its header, and statistics beside it.
    const std::string bil = put("plane.bil", std::string(kRows * kRows * 2, '\4')),
                      header =
                          put("plane.hdr",
                              fmt::format("nrows {0}\nncols {0}\nnbands 1\nnbits 16\npixeltype signedint\n"
                                          "layout bil\nulxmap 500000\nulymap 5200080\nxdim 5\nydim 5\n",
                                          kRows)),
                      beside = put("plane.bil.aux.xml", "<PAMDataset></PAMDataset>"),
                      bil_prj = put("plane.prj", kUtm32);
    const std::string material =
        put("own.toml", read_bytes(support::source_dir() / "assets/materials/soil.toml"));
    const std::string scene =
        put("scene.toml",
            fmt::format("[terrain]\nfile = \"hill.asc\"\ngrid = 8\n[cover]\nmaterial = \"{}\"\ndepth = 1\n"
                        "[physics]\nmodel = \"bcre\"\n[[command]]\nat = 0\n"
                        "pour = {{ x = 40, y = 60, radius = 10, rate = 20, duration = 1 }}\n",
                        material));
    const std::string recording = (folder / "a.couloir").string(), other = (folder / "b.couloir").string();
    const Scene loaded = load_scene(scene, {}).value();
    for (const std::string& each : {recording, other}) record(each, loaded.scenario, 18, loaded.commands);
    const std::string lesson =
        put("lesson.toml",
            "title = \"A\"\nrecording = \"a.couloir\"\n[[stop]]\ntime = 0\nheading = \"A\"\ntext = "
            "\"b\"\n[[stop]]\ntime = 0.2\nheading = \"A\"\ntext = \"b\"\n");
    const std::string then = put(
        "then.json",
        fmt::format(
            R"({{"format":"{}","version":{},"cases":[{{"recording":"a","squares":8,"physics":"local-lax-friedrichs",)"
            R"("end_hash":"0","stages":{{"draw":{{"count":0}},"tick":{{"count":1,"median_ms":1}}}}}}]}})",
            kBenchFormat, kBenchVersion));
    const std::string mesh = put("mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    const std::string velocities = put("v.npy", array("(2, 4, 2)", 64)),
                      scalar = put("r.npy", array("(2, 4)", 32));

    return {
        {.name = "run a scene",
         .arguments = {"run", scene, "--seconds", "0.3"},
         .inputs = {scene, material, hill, prj},
         .outputs = {"--record", "--web", "--summary", "--perf", "--trace"},
         .folders = {"--export"},
         .drawn = {"--frames"}},
        {.name = "run a terrain",
         .arguments = {"run", "--terrain", hill, "--release", release, "--reference", reference, "--material",
                       material, "--grid", "8", "--seconds", "0.3"},
         .inputs = {hill, prj, release, reference, material},
         .outputs = {"--record", "--web", "--summary", "--perf", "--trace"},
         .folders = {"--export"},
         .drawn = {"--frames"}},
        {.name = "run rasters that name others",
         .arguments = {"run", "--terrain", hill_chain[0].string(), "--release", release_chain[0].string(),
                       "--reference", reference_chain[0].string(), "--grid", "8", "--seconds", "0.3",
                       "--allow-references"},
         .inputs = chains,
         .outputs = {"--record", "--summary", "--perf", "--trace"},
         .folders = {"--export"},
         .drawn = {"--frames"},
         .only_refused = true},
        {.name = "run a scene on a raster that names others",
         .arguments = {"run", far_scene, "--seconds", "0.3", "--allow-references"},
         .inputs = hill_chain,
         .outputs = {"--record", "--summary"},
         .folders = {"--export"},
         .drawn = {"--frames"},
         .only_refused = true},
        {.name = "run a raster of several files",
         .arguments = {"run", "--terrain", bil, "--release", release, "--grid", "8", "--seconds", "0.3"},
         .inputs = {bil, header, beside, bil_prj},
         .outputs = {"--record", "--summary"},
         .folders = {"--export"},
         .drawn = {"--frames"},
         .only_refused = true},
        {.name = "replay",
         .arguments = {"replay", recording},
         .inputs = {recording},
         .outputs = {"--web", "--summary", "--perf", "--trace"},
         .drawn = {"--frames"}},
        {.name = "compare",
         .arguments = {"compare", recording, other},
         .inputs = {recording, other},
         .folders = {"--out"}},
        {.name = "edit",
         .arguments = {"edit", recording, "--tick", "0", "--set", "rate=10"},
         .inputs = {recording},
         .outputs = {"--out"},
         .folders = {"--maps"},
         .needed = {"--out"}},
        {.name = "normalise",
         .arguments = {"normalise", recording},
         .inputs = {recording},
         .outputs = {"--out"},
         .needed = {"--out"}},
        {.name = "share a recording",
         .arguments = {"share", recording},
         .inputs = {recording},
         .outputs = {"--out"},
         .needed = {"--out"}},
        {.name = "share two slides",
         .arguments = {"share", recording, "--beside", other},
         .inputs = {recording, other},
         .outputs = {"--out"},
         .needed = {"--out"}},
        {.name = "share a lesson",
         .arguments = {"share", "--lesson", lesson},
         .inputs = {lesson, recording},
         .outputs = {"--out"},
         .needed = {"--out"}},
        {.name = "share a scene",
         .arguments = {"share", scene},
         .inputs = {scene, material, hill, prj},
         .outputs = {"--out"},
         .needed = {"--out"}},
        {.name = "site",
         .arguments = {"site", scene},
         .inputs = {scene, material, hill, prj},
         .folders = {"--out"},
         .needed = {"--out"}},
        {.name = "bench",
         .arguments = {"bench", recording, "--grid", "8", "--physics", "local-lax-friedrichs", "--repeats",
                       "1", "--no-render"},
         .inputs = {recording},
         .outputs = {"--summary", "--perf", "--page", "--trace"}},
        {.name = "bench against an earlier one",
         .arguments = {"bench", recording, "--grid", "8", "--physics", "local-lax-friedrichs", "--against",
                       then},
         .inputs = {then},
         .outputs = {"--summary", "--perf", "--page", "--trace"},
         .only_refused = true},
        {.name = "track",
         .arguments = {"track", mesh, velocities, "--source", "level", "--scalar", scalar, "--level", "0"},
         .inputs = {mesh, velocities, scalar},
         .outputs = {"--out"},
         .folders = {"--frames"}},
        {.name = "figures",
         .arguments = {"figures", "--only", "6", "--pixels", "16"},
         .inputs = {},
         .folders = {"--out"},
         .needed = {"--out"}},
        {.name = "gallery",
         .arguments = {"gallery", "--terrain", hill},
         .inputs = {hill, prj},
         .drawn = {"--out"},
         .needed = {"--out"},
         .only_refused = true},
        {.name = "play a scene",
         .arguments = {"play", scene},
         .inputs = {scene, material, hill, prj},
         .outputs = {"--record"},
         .only_refused = true},
        {.name = "play a raster that names others",
         .arguments = {"play", hill_chain[0].string(), "--allow-references"},
         .inputs = hill_chain,
         .outputs = {"--record"},
         .only_refused = true},
        {.name = "play a recording",
         .arguments = {"play", recording},
         .inputs = {recording},
         .outputs = {"--record"},
         .only_refused = true},
    };
}

std::vector<std::vector<std::string>> refusals_of(const Subcommand& subcommand) {
    const std::string& verb = subcommand.arguments[0];
    if (verb == "track") return {{"--dt", "-1"}, {"--every", "0"}};
    if (verb == "figures") return {{"--only", "99"}, {"--pixels", "1"}};
    std::vector<std::vector<std::string>> all{{"--max-memory", "1K"}};
    if (verb == "gallery") return {{"--size", "1x1"}};
    if (verb == "run") all.push_back({"--set", "friction=99"});
    if (verb == "replay") all.push_back({"--until", "99999"}), all.push_back({"--score"});
    if (verb == "compare") all.push_back({"--tick", "99999"});
    if (verb == "edit") all.push_back({"--command", "9"});
    if (verb == "bench") all.push_back({"--physics", "none"});
    if (verb == "play") all.push_back({"--until", "99999"});
    return all;
}

std::vector<Subcommand> subcommands_refused_by_content(const fs::path& folder) {
    const auto scene = [&folder](const char* name, const std::string& rest) {
        const fs::path path = folder / name;
        write_bytes(path,
                    "[terrain]\ngenerator = \"slope-of-soil\"\ngrid = 16\nlength = 64\nbreak_at = 32\n"
                    "[cover]\nmaterial = \"soil\"\n[physics]\n" +
                        rest);
        return path;
    };
    const std::string house =
        "house = { x = 20, y = 20, turn = 0, length = 5, width = 5, height = 5, "
        "strength = 5 }\n";
    const fs::path beside = scene("beside.toml",
                                  "[[command]]\nat = 0.5\nhouse = { x = 500, y = 500, turn = 0, "
                                  "length = 5, width = 5, height = 5, strength = 5 }\n"),
                   built = scene("built.toml", "[[command]]\nat = 0.1\n" + house);
    const fs::path recording = folder / "built.couloir";
    const Scene loaded = load_scene(built.string(), {}).value();
    record(recording, loaded.scenario, 18, loaded.commands);
    const std::vector<std::string> outputs{"--record", "--save-world", "--summary", "--perf", "--trace"};
    return {
        {.name = "a page of a flow",
         .arguments = {"run", "flow-disc", "--seconds", "0.1"},
         .outputs = outputs,
         .needed = {"--web"}},
        {.name = "a house beside the terrain at tick 30",
         .arguments = {"run", beside, "--seconds", "1"},
         .outputs = outputs},
        {.name = "a house that is moved beside the terrain",
         .arguments = {"edit", recording, "--tick", "6", "--move", "5000,5000"},
         .outputs = {"--out"}},
        {.name = "a house that is turned to no place",
         .arguments = {"edit", recording, "--tick", "6", "--set", "x=0,y=0"},
         .outputs = {"--out"}},
    };
}

}  // namespace game::test
