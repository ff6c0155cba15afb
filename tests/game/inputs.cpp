// A file that cannot be read to its end, or that leads out of its folder, is refused at once.

#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/bench/against.h"
#include "game/files/array_file.h"
#include "game/files/mesh_file.h"
#include "game/files/toml_table.h"
#include "game/recording/recording_file.h"
#include "game/session/loaded_world.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

fs::path pipe_in(const support::TemporaryFolder& folder, const char* name) {
    const fs::path path = folder.path() / name;
    EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
    return path;
}

template <class T>
void expect_unusable(const Outcome<T>& outcome, const fs::path& path) {
    ASSERT_FALSE(outcome) << path;
    EXPECT_EQ(outcome.error().status, Failure::kUnusable);
    EXPECT_EQ(outcome.error().sentence.rfind(path.string() + ": ", 0), 0u) << outcome.error().sentence;
}

TEST(Inputs, that_are_pipes_devices_or_folders_block_no_reader) {
    const support::TemporaryFolder folder;
    for (const fs::path& path : {pipe_in(folder, "pipe"), fs::path("/dev/zero"), folder.path()}) {
        expect_unusable(read_recording(path), path);
        expect_unusable(parse_toml(path), path);
        expect_unusable(read_obj(path), path);
        expect_unusable(ArrayFile::open(path), path);
        expect_unusable(read_report(path), path);
        expect_unusable(open_anything(path.string(), {}), path);
    }
    for (const char* name : {"pipe.toml", "pipe.couloir", "pipe.tif"})
        expect_unusable(open_anything(pipe_in(folder, name).string(), {}), folder.path() / name);
}

TEST(Inputs, that_are_pipes_end_every_command_with_status_2) {
    const support::TemporaryFolder folder;
    const std::string pipe = pipe_in(folder, "pipe").string(), out = (folder.path() / "out").string();
    const std::string hill = (folder.path() / "hill.asc").string();
    write_bytes(hill, "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n");
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"run", pipe, "--seconds", "1"},
             {"run", "landslide", "--seconds", "1", "--material", pipe},
             {"run", "--terrain", pipe, "--release", hill, "--seconds", "1"},
             {"run", "--terrain", hill, "--release", pipe, "--seconds", "1"},
             {"run", "landslide", "--reference", pipe, "--seconds", "1"},
             {"play", pipe},
             {"replay", pipe, "--no-render"},
             {"compare", pipe, "landslide"},
             {"edit", pipe, "--tick", "1", "--delete", "--out", out},
             {"normalise", pipe, "--out", out},
             {"track", pipe, hill, "--jump", "1"},
             {"bench", "--against", pipe},
         })
        EXPECT_EQ(couloir(arguments).status, Failure::kUnusable) << arguments.front();
}

class SceneOfStranger : public testing::Test {
  protected:
    SceneOfStranger() {
        fs::create_directories(folder_.path() / "scenes" / "hills");
        for (const fs::path& hill :
             {folder_.path() / "hill.asc", scene_.parent_path() / "hills" / "hill.asc"}) {
            std::string asc = "ncols 9\nnrows 9\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
            for (int i = 0; i < 81; ++i) asc += std::to_string(1000 + i % 9) + ' ';
            write_bytes(hill, asc);
        }
        fs::create_symlink(folder_.path() / "hill.asc", scene_.parent_path() / "link.asc");
    }

    Outcome<Scene> load(const std::string& file, terrains::References references,
                        const std::string& material = "soil", const std::string& under = "") {
        write_bytes(scene_, "[terrain]\nfile = \"" + file + "\"\ngrid = 8\n[cover]\nmaterial = \"" +
                                material + "\"\ndepth = 1\n[physics]\n" +
                                (under.empty() ? "" : "[under]\ndepth = 1\nmaterial = \"" + under + "\"\n"));
        Overrides overrides;
        overrides.references = references;
        return load_scene(scene_.string(), overrides);
    }

    support::TemporaryFolder folder_;
    fs::path scene_ = folder_.path() / "scenes" / "hill.toml";
};

TEST_F(SceneOfStranger, reads_terrain_outside_its_folder_only_if_references_are_allowed) {
    using terrains::References;
    for (const auto& [file, is_inside] : std::vector<std::pair<std::string, bool>>{
             {"hills/hill.asc", true},
             {"hills/../hills/hill.asc", true},
             {"../hill.asc", false},
             {"link.asc", false},
             {(folder_.path() / "hill.asc").string(), false},
         }) {
        const auto refused = load(file, References::kRefused);
        EXPECT_EQ(refused.has_value(), is_inside) << file;
        if (!is_inside) {
            EXPECT_EQ(refused.error().status, Failure::kUnusable);
        }
        const auto allowed = load(file, References::kAllowed);
        EXPECT_TRUE(allowed) << file << ": " << allowed.error().sentence;
    }
}

TEST_F(SceneOfStranger, reads_materials_outside_its_folder_only_if_references_are_allowed) {
    using terrains::References;
    const std::string soil = read_bytes(support::source_dir() / "assets/materials/soil.toml");
    write_bytes(folder_.path() / "own.toml", soil);
    write_bytes(scene_.parent_path() / "hills" / "own.toml", soil);
    fs::create_symlink(folder_.path() / "own.toml", scene_.parent_path() / "link.toml");
    struct Named {
        std::string file;
        bool is_inside;
    };
    for (const Named& named : std::vector<Named>{
             {"hills/own.toml", true},
             {"../own.toml", false},
             {"link.toml", false},
             {(folder_.path() / "own.toml").string(), false},
             {"/etc/passwd", false},
         })
        for (const bool is_upper : {true, false}) {
            const auto read = [&](References references) {
                return load("hills/hill.asc", references, is_upper ? named.file : "soil",
                            is_upper ? "" : named.file);
            };
            const auto refused = read(References::kRefused);
            EXPECT_EQ(refused.has_value(), named.is_inside) << named.file;
            if (!named.is_inside) {
                EXPECT_NE(refused.error().sentence.find("--allow-references"), std::string::npos)
                    << refused.error().sentence;
            }
            if (named.file != "/etc/passwd") {
                EXPECT_TRUE(read(References::kAllowed)) << named.file;
            }
        }
}

// Also if the scene is named without a folder, as one does who stands in it.
TEST_F(SceneOfStranger, that_names_what_is_missing_is_not_said_to_lead_outside) {
    const auto hill = [](const std::string& file, const std::string& rest) {
        return "[terrain]\nfile = \"" + file + "\"\ngrid = 8\n[physics]\n" + rest;
    };
    const std::string cover = "[cover]\ndepth = 1\nmaterial = ", soil = cover + "\"soil\"\n";
    const fs::path before = fs::current_path();
    fs::current_path(scene_.parent_path());
    for (const auto& [scene, fact] : std::vector<std::pair<std::string, std::string>>{
             {hill("missing.asc", soil), "missing.asc: there is no such file"},
             {hill("Link.asc", soil), "Link.asc: there is no such file"},
             {hill("hills\\\\hill.asc", soil), "/ parts folders, not \\"},
             {hill("hills/hill.asc", cover + "\"soill\"\n"), "'soill'"},
             {hill("hills/hill.asc", soil + "[under]\ndepth = 1\nmaterial = \"soill\"\n"), "'soill'"},
             {hill("hills/hill.asc", soil + "[trees]\ndensity = 100\nraster = \"missing.asc\"\n"),
              "missing.asc: there is no such file"}}) {
        write_bytes("hill.toml", scene);
        for (const std::string name : {"hill.toml", "./hill.toml", "hills/../hill.toml"}) {
            const auto refused = load_scene(name, {});
            ASSERT_FALSE(refused) << scene;
            EXPECT_NE(refused.error().sentence.find(fact), std::string::npos) << refused.error().sentence;
            EXPECT_EQ(refused.error().sentence.find("outside"), std::string::npos)
                << refused.error().sentence;
        }
    }
    fs::current_path(before);
}

TEST_F(SceneOfStranger, with_an_unknown_material_is_refused_with_the_names_there_are) {
    const auto refused = load("hills/hill.asc", terrains::References::kRefused, "soill");
    ASSERT_FALSE(refused);
    for (const char* fact : {"'soill'", "snow-dry", "soil"})
        EXPECT_NE(refused.error().sentence.find(fact), std::string::npos) << refused.error().sentence;
}

}  // namespace
}  // namespace game::test
