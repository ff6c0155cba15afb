// What foreign names and texts look like on standard output and standard error.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/base/one_line.h"
#include "game/files/text_file.h"
#include "game/recording/json_values.h"
#include "tests/game/program.h"
#include "tests/game/subcommands.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHostile =
    "x\x1b[31m\x07\n\r\x7f\xc2\x9b"
    "2Jy";

void expect_harmless(const Finished& finished) {
    for (const std::string* text : {&finished.out, &finished.err}) EXPECT_EQ(printable(*text), *text);
}

TEST(OneLine, has_no_control_characters) {
    EXPECT_EQ(one_line("a\nb\x1b[0m\t\x7f\xc2\x9bz"), "a?b?[0m???z");
    EXPECT_EQ(one_line(std::string("\0", 1)), "?");
    EXPECT_EQ(one_line("Höhe → ½ °"), "Höhe → ½ °");
    EXPECT_EQ(one_line("\xc2"), "\xc2");
    EXPECT_EQ(printable("a\nb\r\n"), "a\nb?\n");
}

std::string utf8(char32_t code) {
    const auto byte = [](char32_t bits) { return static_cast<char>(bits); };
    if (code < 0x80) return {byte(code)};
    if (code < 0x800) return {byte(0xc0 | code >> 6), byte(0x80 | (code & 0x3f))};
    if (code < 0x10000)
        return {byte(0xe0 | code >> 12), byte(0x80 | (code >> 6 & 0x3f)), byte(0x80 | (code & 0x3f))};
    return {byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 0x3f)), byte(0x80 | (code >> 6 & 0x3f)),
            byte(0x80 | (code & 0x3f))};
}

// Characters that turn text around, that nobody sees, or that are none.
std::vector<char32_t> hidden_characters() {
    std::vector<char32_t> hidden{0x00ad, 0x034f, 0x061c, 0x115f, 0x180e, 0x2028, 0x2029,  0x3164,
                                 0xfeff, 0xfffb, 0xfdd0, 0xfdef, 0xfffe, 0xffff, 0x1fffe, 0x10ffff};
    const auto add = [&](char32_t first, char32_t last) {
        for (char32_t code = first; code <= last; ++code) hidden.push_back(code);
    };
    add(0x80, 0x9f), add(0x200b, 0x200f), add(0x202a, 0x202e), add(0x2060, 0x206f), add(0xe0000, 0xe007f);
    return hidden;
}

TEST(OneLine, has_no_character_that_hides_or_turns_text) {
    for (const char32_t code : hidden_characters()) {
        EXPECT_EQ(one_line(fmt::format("a{}b", utf8(code))), "a?b") << static_cast<unsigned>(code);
        EXPECT_EQ(printable(utf8(code) + "\n"), "?\n") << static_cast<unsigned>(code);
    }
    // Words of any script, and signs beside those above.
    for (const char* text :
         {"Lawine, обвал, 雪崩, انهيار, מפולת, हिमस्खलन", "❄ 🏔 “½ °” … – ‰ €",
          "\u2027\u202f\u2010\u2070\u2030\ufdcf\ufdf0\ufffd\u00a0\u00ae"})
        EXPECT_EQ(printable(text), text);
    // Bytes that are no UTF-8: overlong, a surrogate, cut off, and a control of ISO 8859-1.
    EXPECT_EQ(one_line("\xc0\x8a\xff"), "\xc0?\xff");
    EXPECT_EQ(one_line("h\xfcgel\x9b\xe2\x80"), "h\xfcgel?\xe2?");
}

TEST(PrintableJson, means_the_same_and_hides_nothing) {
    for (const char32_t code : hidden_characters()) {
        const std::string text = fmt::format("a{}b", utf8(code));
        const std::string shown = printable_json(Json(text).dump());
        EXPECT_EQ(printable(shown), shown) << static_cast<unsigned>(code);
        EXPECT_EQ(Json::parse(shown), text) << static_cast<unsigned>(code);
    }
}

// Every subcommand, whose inputs, outputs and folders have hostile names: run to its end and refused.
TEST(Printing, shows_no_control_character_of_any_path) {
    const support::TemporaryFolder folder;
    const fs::path plain = folder.path() / "in", in = folder.path() / kHostile,
                   out = folder.path() / "out" / kHostile;
    fs::create_directories(plain);
    fs::create_directories(out);
    fs::create_directory_symlink(plain, in);
    const auto renamed = [&](const std::string& path) {
        return path.starts_with(plain.string()) ? in.string() + path.substr(plain.string().size()) : path;
    };
    for (Subcommand each : writing_subcommands(plain)) {
        for (std::string& argument : each.arguments) argument = renamed(argument);
        for (fs::path& input : each.inputs) input = renamed(input.string());
        SCOPED_TRACE(each.name);
        std::vector<std::pair<std::string, fs::path>> outputs;
        for (const auto* options : {&each.outputs, &each.folders})
            for (const std::string& option : *options)
                outputs.emplace_back(option, out / (each.name + option));
        if (!each.only_refused) {
            const Finished done = couloir(each.with(outputs, out));
            EXPECT_EQ(done.status, 0) << done.err;
            expect_harmless(done);
        }
        for (const auto& [option, path] : outputs)
            for (const fs::path& wrong : each.inputs) {
                const Finished refused = couloir(each.with({{option, wrong}}, out));
                expect_harmless(refused);
                EXPECT_LE(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
            }
        for (std::size_t i = 0; i < each.arguments.size(); ++i) {  // each argument in turn
            std::vector<std::string> call = each.with({}, out);
            call[i] = kHostile;
            if (i > 0 && each.arguments[0] == "play") continue;  // would open a window
            const Finished refused = couloir(call);
            expect_harmless(refused);
            EXPECT_LE(std::count(refused.err.begin(), refused.err.end(), '\n'), 2) << refused.err;
        }
    }
}

TEST(Printing, shows_no_control_character_of_the_environment) {
    const support::TemporaryFolder folder;
    for (const char* variable : {"COULOIR_ASSETS", "XDG_DATA_HOME", "HOME"})
        for (const std::string& value : {std::string(kHostile), (folder.path() / kHostile).string()}) {
            const Finished finished = couloir({"run", "nothing"}, {.environment = {{variable, value}}});
            EXPECT_EQ(finished.status, 2) << variable << finished.err;
            expect_harmless(finished);
            expect_harmless(
                couloir({"play", "landslide"}, {.environment = {{variable, value}, {"DISPLAY", kHostile}}}));
            expect_harmless(couloir({"list"}, {.environment = {{variable, value}}}));
        }
}

// A text that a file carries is as foreign as its name.
TEST(Printing, shows_no_control_character_of_a_scene) {
    const support::TemporaryFolder folder;
    const fs::path scene = folder.path() / "scene.toml";
    write_bytes(
        scene,
        "title = \"a\\u001b[31m\\nb\"\n" +
            read_bytes(support::source_dir() / "assets/scenes/landslide.toml")
                .substr(
                    read_bytes(support::source_dir() / "assets/scenes/landslide.toml").find("[terrain]")));
    const Finished finished = couloir({"run", scene.string(), "--grid", "8", "--seconds", "0"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(finished.out.substr(0, 10), "a?[31m?b: ");
    expect_harmless(finished);
}

TEST(Printing, turns_no_text_around_that_a_scene_carries) {
    const support::TemporaryFolder folder;
    const fs::path scene = folder.path() / "a\u202ehtaed.toml", page = folder.path() / "page.html";
    const std::string landslide = read_bytes(support::source_dir() / "assets/scenes/landslide.toml");
    write_bytes(scene, "title = \"a\\u202ehtaed\"\n" + landslide.substr(landslide.find("[terrain]")));
    const std::vector<std::string> call{"run", scene.string(), "--grid", "8", "--seconds", "0"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), call.begin(), call.end());
        return couloir(more);
    };
    const Finished text = with({"--web", page.string()}), json = with({"--json"});
    EXPECT_EQ(text.out.substr(0, 8), "a?htaed:") << text.err;
    EXPECT_EQ(Json::parse(json.out).at("scene"), "a\u202ehtaed");
    const std::string html = read_bytes(page);
    EXPECT_NE(html.find("<title>a?htaed</title>"), std::string::npos);
    for (const std::string* shown : {&text.out, &json.out, &html})
        EXPECT_EQ(shown->find("\u202e"), std::string::npos);
}

// Text reaches a terminal only by game/base/print.h and main.cpp, which replace control characters.
TEST(Printing, goes_through_one_place) {
    for (const auto& entry : fs::recursive_directory_iterator(support::source_dir() / "game")) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_regular_file() || name == "print.h" || name == "progress.cpp") continue;
        const std::string text = read_bytes(entry.path());
        for (const char* call : {"fmt::print(", "std::printf", "std::cout", "std::cerr", "std::puts"})
            EXPECT_EQ(text.find(call), std::string::npos) << entry.path() << " " << call;
    }
}

}  // namespace
}  // namespace game::test
