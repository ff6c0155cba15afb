#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/architecture.h"
#include "tests/support/include_rules.h"
#include "tests/support/places.h"

namespace {

using support::Breach;
using support::breaches_in;

TEST(Layering, every_include_follows_the_arrows) {
    for (const auto& source : support::sources_of(support::source_dir())) {
        std::ifstream file(support::source_dir() / source);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        ASSERT_FALSE(text.empty()) << source << " cannot be read";
        for (const Breach& breach : breaches_in(source.generic_string(), text))
            ADD_FAILURE() << breach.file << ":" << breach.line << ": " << breach.fact;
    }
}

// A search that finds nothing would pass the test above.
TEST(Layering, sees_the_sources_of_every_room) {
    const auto sources = support::sources_of(support::source_dir());
    for (const std::string room : {"files", "sim", "terrains", "render", "game", "tests"})
        EXPECT_TRUE(std::any_of(sources.begin(), sources.end(),
                                [&](const auto& source) { return source.begin()->string() == room; }))
            << "no source seen in " << room;
}

TEST(Layering, names_the_line_of_a_planted_breach) {
    const auto breaches = breaches_in("sim/step.cpp", "#include <vector>\n\n#include \"render/frame.h\"\n");
    ASSERT_EQ(breaches.size(), 1u);
    EXPECT_EQ(breaches[0].file, "sim/step.cpp");
    EXPECT_EQ(breaches[0].line, 3);
    EXPECT_EQ(breaches[0].fact, "sim may not include render/frame.h");
}

// What a score is made of is the same on every processor only if no function of a mathematics library is in it whose last
// bits that library chooses: hypot, atan2 and exp of two common ones differ (docs/challenges.md).
bool is_of_a_score(const std::string& file) {
    const auto begins = [&](const char* with) { return file.rfind(with, 0) == 0; };
    return begins("game/analysis/measures.") || begins("game/analysis/score.") ||
           begins("game/analysis/thing_results.") || begins("game/session/attempt_watch.") ||
           begins("game/session/peak_watch.") || begins("game/session/session.") ||
           begins("game/scene/goal") || begins("game/scene/pressure.") || begins("game/scene/surface.") ||
           begins("sim/world/") || begins("sim/momentum/") || begins("sim/bcre/") || begins("sim/stages/") ||
           begins("sim/sweep/") || begins("sim/core/") || begins("sim/step") || begins("sim/load_things") ||
           begins("sim/ground");
}

// A call without a namespace is one too: where sim/simd/exponential.h is not included, the C library's exp is found.
std::vector<int> lines_with_library_functions(const std::string& text) {
    static const std::regex function(
        R"((\b(std|glm)::|(^|[^:.\w])(::)?)(hypot|exp2?|expm1|log(2|10|1p)?|pow|cbrt|a?(sin|cos|tan)h?|atan2)f?\s*\()");
    std::vector<int> lines;
    std::istringstream rest(text);
    std::string line;
    for (int number = 1; std::getline(rest, line); ++number)
        if (std::regex_search(line, function)) lines.push_back(number);
    return lines;
}

TEST(Scores, are_made_without_functions_whose_last_bits_a_library_chooses) {
    // Neither is read by a score: what a panel shows, and the check of a scene's numbers.
    const std::set<std::string> allowed{"sim/world/things.cpp: 1", "sim/world/params.cpp: 2"};
    std::set<std::string> found;
    for (const auto& source : support::sources_of(support::source_dir())) {
        if (!is_of_a_score(source.generic_string())) continue;
        std::ifstream file(support::source_dir() / source);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        const auto lines = lines_with_library_functions(text);
        if (!lines.empty()) found.insert(source.generic_string() + ": " + std::to_string(lines.size()));
    }
    EXPECT_EQ(found, allowed);
}

TEST(Scores, are_searched_for_every_such_function) {
    EXPECT_EQ(lines_with_library_functions("a = std::sqrt(b);\nc = std::hypot(a, b);\n"
                                           "d = glm::atan(c) + std::atan2(a, b);\ne = exp(Number(d));\n"
                                           "f = sim::exp(e) + view.log(e) + ::pow(e, 2);\n"
                                           "f = sim::exp(e) + view.log(e);\n"),
              (std::vector<int>{2, 3, 4, 5}));
}

struct Planted {
    const char* file;
    const char* line;
};

TEST(Layering, finds_every_kind_of_planted_breach) {
    for (const Planted& planted : {
             Planted{"sim/step.cpp", "#include \"terrains/terrain.h\""},
             Planted{"sim/step.cpp", "#include \"game/session/session.h\""},
             Planted{"sim/step.cpp", "#include \"files/whole_file.h\""},
             Planted{"files/lock.cpp", "#include \"game/base/outcome.h\""},
             Planted{"files/lock.cpp", "#include <gdal_priv.h>"},
             Planted{"sim/step.cpp", "#include <render/frame.h>"},
             Planted{"sim/core/grid.h", "#include \"sim/simd/rows.h\""},
             Planted{"sim/world/layers.cpp", "#include \"sim/bcre/stages.h\""},
             Planted{"sim/bcre/yield.h", "#include \"sim/momentum/yield.h\""},
             Planted{"sim/front/scan.h", "#include \"sim/sweep/sweep.h\""},
             Planted{"game/session/session.cpp", "#include \"game/analysis/summary.h\""},
             Planted{"game/ui/ui.cpp", "#include \"game/app/app.h\""},
             Planted{"sim/bcre/yield.cpp", "#include \"../../render/frame.h\""},
             Planted{"sim/bcre/yield.cpp", "  #  include <fstream>  // for a while"},
             Planted{"sim/step.cpp", "#include <filesystem>"},
             Planted{"sim/step.cpp", "#include <chrono>"},
             Planted{"sim/step.cpp", "#include <ctime>"},
             Planted{"sim/step.cpp", "#include <time.h>"},
             Planted{"sim/step.cpp", "#include <epoxy/gl.h>"},
             Planted{"sim/step.cpp", "#include <EGL/egl.h>"},
             Planted{"sim/step.cpp", "#include <gdal_priv.h>"},
             Planted{"sim/step.cpp", "#include <OpenImageIO/imageio.h>"},
             Planted{"sim/step.cpp", "#include HEADER"},
             Planted{"terrains/resample.cpp", "#include \"sim/world/state.h\""},
             Planted{"terrains/resample.cpp", "#include \"render/pictures/picture.h\""},
             Planted{"terrains/resample.cpp", "#include <epoxy/gl.h>"},
             Planted{"render/frame.cpp", "#include \"terrains/terrain.h\""},
             Planted{"render/frame.cpp", "#include \"game/scene/scene.h\""},
             Planted{"render/frame.cpp", "#include <GLFW/glfw3.h>"},
             Planted{"render/frame.cpp", "#include \"tests/support/places.h\""},
             Planted{"game/main.cpp", "#include \"tests/support/places.h\""},
             Planted{"game/app/app.cpp", "#include <GLFW/glfw3.h>"},
             Planted{"game/app/window.h", "#include <GLFW/glfw3.h>"},
             Planted{"game/main.cpp", "#include <CLI/CLI.hpp>"},
             Planted{"tests/window/sessions.cpp", "#include <GLFW/glfw3.h>"},
         })
        EXPECT_EQ(breaches_in(planted.file, planted.line).size(), 1u) << planted.file << ": " << planted.line;
}

TEST(Layering, lets_the_arrows_through) {
    for (const Planted& planted : {
             Planted{"sim/step.cpp", "#include \"sim/core/grid.h\""},
             Planted{"sim/bcre/plain.cpp", "#include \"plain.h\""},
             Planted{"sim/step.cpp", "#include <cmath>"},
             Planted{"sim/step.cpp", "#include <glm/vec2.hpp>"},
             Planted{"sim/world/state_hash.cpp", "#include <xxhash.h>"},
             Planted{"sim/step.cpp", "// #include <fstream> would be against the rules"},
             Planted{"files/lock.cpp", "#include <sys/file.h>"},
             Planted{"terrains/export.cpp", "#include \"files/whole_file.h\""},
             Planted{"terrains/dem_gdal.cpp", "#include <gdal_priv.h>"},
             Planted{"terrains/dem_gdal.cpp", "#include \"sim/core/grid.h\""},
             Planted{"render/frame.cpp", "#include \"sim/world/state.h\""},
             Planted{"render/frame.cpp", "#include <epoxy/gl.h>"},
             Planted{"render/passes/ground.cpp", "#include \"assets/shaders/slots.h\""},
             Planted{"game/app/window.cpp", "#include <GLFW/glfw3.h>"},
             Planted{"game/command_line.cpp", "#include <CLI/CLI.hpp>"},
             Planted{"game/main.cpp", "#include \"render/frame.h\""},
             Planted{"tests/layering.cpp", "#include \"game/scene/scene.h\""},
         })
        EXPECT_TRUE(breaches_in(planted.file, planted.line).empty()) << planted.file << ": " << planted.line;
}

// COULOIR_RENEW_ARCHITECTURE=1 writes the picture instead.
TEST(Architecture, picture_is_what_the_includes_say) {
    const auto file = support::source_dir() / "docs/architecture.svg";
    const architecture::Picture picture = architecture::draw(support::source_dir());
    for (const std::string& fault : picture.faults) ADD_FAILURE() << fault;
    ASSERT_TRUE(picture.faults.empty());
    if (std::getenv("COULOIR_RENEW_ARCHITECTURE")) {
        std::ofstream(file, std::ios::binary) << picture.svg;
        GTEST_SKIP() << "renewed " << file;
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string kept{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    EXPECT_TRUE(kept == picture.svg)
        << file << " differs from the includes; renew it with COULOIR_RENEW_ARCHITECTURE=1 layering_test";
}

}  // namespace
