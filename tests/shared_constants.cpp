// What a shader or the page computes as C++ does names the C++ file in a comment. Constants that both name are the same.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace {

namespace fs = std::filesystem;
using Constants = std::map<std::string, double>;

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// Names in "const kThin = 0.5, kThick = 1'000.f;" that have a number.
Constants constants_in(const std::string& text) {
    static const std::regex declaration(R"(\bconst(expr)?\s[^;{]*;)");
    static const std::regex constant(R"(\b(k[A-Z]\w*)\s*=\s*(-?[\d.][\d.e_'+-]*)f?\s*[,;])");
    Constants found;
    for (std::sregex_iterator each(text.begin(), text.end(), declaration), end; each != end; ++each) {
        const std::string declared = each->str();
        for (std::sregex_iterator one(declared.begin(), declared.end(), constant); one != end; ++one) {
            std::string number = (*one)[2];
            std::erase_if(number, [](char c) { return c == '_' || c == '\''; });
            found.emplace((*one)[1], std::stod(number));
        }
    }
    return found;
}

std::set<std::string> sources_named_in(const std::string& text) {
    static const std::regex source(R"(\b(sim|render|game|terrains)/[\w/]+\.(cpp|h)\b)");
    std::set<std::string> named;
    for (std::sregex_iterator each(text.begin(), text.end(), source), end; each != end; ++each)
        named.insert(each->str());
    return named;
}

TEST(SharedConstants, are_the_same_in_cpp_shaders_and_the_page) {
    int compared = 0;
    for (const char* folder : {"assets/shaders", "assets/web"})
        for (const auto& entry : fs::recursive_directory_iterator(support::source_dir() / folder)) {
            if (!entry.is_regular_file()) continue;
            const std::string text = text_of(entry.path());
            const Constants own = constants_in(text);
            for (const std::string& source : sources_named_in(text)) {
                const fs::path path = support::source_dir() / source;
                ASSERT_TRUE(fs::exists(path)) << entry.path() << " names " << source;
                for (const auto& [name, value] : constants_in(text_of(path)))
                    if (const auto same = own.find(name); same != own.end()) {
                        ++compared;
                        EXPECT_EQ(same->second, value) << name << " of " << entry.path() << " and " << source;
                    }
            }
        }
    EXPECT_GE(compared, 30);  // a search that finds nothing would pass
}

TEST(SharedConstants, are_read_from_every_way_of_writing_them) {
    const Constants found = constants_in(
        "constexpr float kWide = 0.5f, kLow = -3;  // m\n"
        "inline constexpr int kMany = 1'000;\nconst kFar = 15, kFaint = 1e-3;\nconst float kThin = .25;\n"
        "constexpr double kHalf = kWide / 2;\nint kNot = 3;\n");
    const Constants expected{{"kWide", 0.5}, {"kLow", -3},     {"kMany", 1000},
                             {"kFar", 15},   {"kFaint", 1e-3}, {"kThin", 0.25}};
    EXPECT_EQ(found, expected);
}

}  // namespace
