// What the Markdown files promise: their commands parse, and their test filters match tests. And which
// files stand beside README.md.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/support/places.h"

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// A command as it stands in a page.
struct Quoted {
    std::string page, text;
};

std::vector<fs::path> pages() {
    std::vector<fs::path> all;
    for (fs::recursive_directory_iterator entry(support::source_dir()), end; entry != end; ++entry) {
        const std::string name = entry->path().filename().string();
        if (entry->is_directory() && (name == "build" || name == ".git")) entry.disable_recursion_pending();
        if (entry->is_regular_file() && entry->path().extension() == ".md") all.push_back(entry->path());
    }
    std::sort(all.begin(), all.end());
    return all;
}

// Lines of code blocks, continued lines joined, without comments; and the code within sentences, which may go
// on in the next line.
std::vector<Quoted> code_in(const std::string& page, std::istream& lines) {
    std::vector<Quoted> code;
    std::string prose, continued;
    bool fenced = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            fenced = !fenced;
        } else if (fenced || line.starts_with("    ")) {
            continued += std::regex_replace(line, std::regex(" +#.*"), "");
            if (continued.ends_with('\\')) {
                continued.back() = ' ';
                continue;
            }
            code.push_back({page, continued});
            continued.clear();
        } else {
            prose += line + ' ';
        }
    }
    const std::regex span("`([^`]+)`");
    for (std::sregex_iterator found(prose.begin(), prose.end(), span), end; found != end; ++found)
        code.push_back({page, (*found)[1]});
    return code;
}

std::vector<Quoted> all_code() {
    std::vector<Quoted> all;
    for (const fs::path& page : pages()) {
        std::ifstream lines(page);
        for (Quoted& each : code_in(fs::relative(page, support::source_dir()).string(), lines))
            all.push_back(std::move(each));
    }
    return all;
}

Words words_of(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

// The arguments of the program if this is a call of it; the first word is a subcommand or a global option.
std::optional<Words> arguments_of(const Quoted& quoted) {
    if (quoted.text == "couloir recording") return std::nullopt;  // the format's name, a string in a file
    Words words = words_of(quoted.text);
    const auto program = std::find_if(words.begin(), words.end(), [](const std::string& word) {
        return word == "couloir" || word.ends_with("/couloir") || word == "./play";
    });
    // Nothing but variables and measuring programs stands before it.
    if (program == words.end() ||
        (program != words.begin() && words[0].find_first_of("=/") == std::string::npos))
        return std::nullopt;
    words.erase(words.begin(), program + 1);
    if (words.empty()) return std::nullopt;
    return words;
}

class Help {
  public:
    // The help of a subcommand, or of the program itself for ""; none: there is no such subcommand. `terrain generate` is a
    // subcommand of a subcommand.
    const std::optional<std::string>& of(const std::string& subcommand) {
        const auto [known, is_new] = known_.try_emplace(subcommand);
        if (!is_new) return known->second;
        Words words = words_of(subcommand);
        if (words.empty() || is_there(words)) {
            words.push_back("--help");
            known->second = game::test::couloir(words).out + " --help ";
        }
        return known->second;
    }
    // The subcommand that a call begins with.
    std::string named_by(const Words& call) {
        if (call[0].starts_with("-")) return {};
        const bool is_nested = call.size() > 1 && of(call[0]) && is_there({call[0], call[1]});
        return is_nested ? call[0] + " " + call[1] : call[0];
    }

  private:
    // The program prints its own help for a word that it does not know.
    bool is_there(Words words) {
        const std::string last = words.back();
        words.pop_back();
        const std::string& above = *of(words.empty() ? "" : words[0]);
        const auto list = above.find("\nSubcommands:");
        return list != std::string::npos && above.find("\n  " + last + " ", list) != std::string::npos;
    }

    std::map<std::string, std::optional<std::string>> known_;
};

// What is wrong with a documented call; empty if nothing.
std::string fault_of_call(const Words& words, Help& help) {
    const auto& known = help.of(help.named_by(words));
    if (!known) return "there is no subcommand " + words[0];
    for (const std::string& word : words) {
        if (!word.starts_with("--")) continue;
        const std::string option = word.substr(0, word.find_first_of("=,.;:)"));
        if (!std::regex_search(*known, std::regex(option + "[^a-z-]"))) return "there is no option " + option;
    }
    // Placeholders in capitals and "…" cannot be parsed, nor can a fragment that ends in an option. All else
    // can: --help ends the call before anything is run.
    const bool is_literal = !words.back().starts_with("--") &&
                            std::none_of(words.begin(), words.end(), [](const std::string& word) {
                                return word.find("…") != std::string::npos ||
                                       std::regex_match(word, std::regex("[A-Z]+(\\.[a-z]+)?"));
                            });
    if (!is_literal) return {};
    Words asked = words;
    asked.push_back("--help");
    const auto finished = game::test::couloir(asked);
    return finished.status == 0 ? "" : finished.err;
}

TEST(Documents, name_subcommands_options_and_values_that_the_program_has) {
    Help help;
    std::size_t tried = 0;
    for (const Quoted& quoted : all_code())
        if (const auto words = arguments_of(quoted)) {
            ++tried;
            EXPECT_EQ(fault_of_call(*words, help), "") << quoted.page << ": " << quoted.text;
        }
    EXPECT_GT(tried, 60u);  // a search that finds nothing would pass
}

TEST(Documents, find_every_kind_of_planted_fault) {
    Help help;
    for (const char* wrong :
         {"couloir rum landslide", "couloir run landslide --fast", "couloir run landslide --grid 3",
          "./play play landslide --gird 80", "build/release/bin/couloir replay x --versify"}) {
        const auto words = arguments_of({"", wrong});
        ASSERT_TRUE(words) << wrong;
        EXPECT_NE(fault_of_call(*words, help), "") << wrong;
    }
}

// What a shell command prints, by line; none if it fails.
std::optional<Words> lines_of(const std::string& call) {
    FILE* const pipe = popen(call.c_str(), "r");
    if (!pipe) return std::nullopt;
    Words lines;
    char line[4096];
    while (std::fgets(line, sizeof line, pipe)) lines.emplace_back(line);
    return pclose(pipe) == 0 ? std::optional(lines) : std::nullopt;
}

// Number of tests of a program that match a filter; none if there is no such program.
std::optional<int> matches(const std::string& program, const std::string& filter) {
    const fs::path path = support::build_dir() / "tests" / program;
    if (!fs::exists(path)) return std::nullopt;
    const std::string call = path.string() + " --gtest_list_tests --gtest_filter='" + filter + "'";
    const auto lines = lines_of(call);
    if (!lines) return std::nullopt;
    return static_cast<int>(
        std::count_if(lines->begin(), lines->end(), [](const std::string& line) { return line[0] == ' '; }));
}

// Whether a CMakeLists.txt below tests/ declares this program, although this build leaves it out, as the one with
// sanitizers does with some.
bool is_left_out(const std::string& program) {
    if (fs::exists(support::build_dir() / "tests" / program)) return false;
    const std::string call = "couloir_test(" + program.substr(0, program.rfind("_test")) + "\n";
    for (const auto& entry : fs::recursive_directory_iterator(support::source_dir() / "tests")) {
        if (entry.path().filename() != "CMakeLists.txt") continue;
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        if (text.find(call) != std::string::npos) return true;
    }
    return false;
}

// GoogleTest calls a filter that matches nothing a success.
TEST(Documents, name_test_filters_that_each_match_a_test) {
    const std::regex call(R"(([a-z_]+_test) (?:.* )?--gtest_filter=['"]?([^'" ]+))");
    std::size_t tried = 0;
    for (const Quoted& quoted : all_code()) {
        std::smatch found;
        if (!std::regex_search(quoted.text, found, call)) continue;
        std::istringstream parts(found[2]);
        for (std::string part; std::getline(parts, part, ':'); ++tried) {
            if (is_left_out(found[1])) continue;
            const auto count = matches(found[1], part);
            ASSERT_TRUE(count) << quoted.page << ": " << found[1]
                               << " is not built or does not list its tests";
            EXPECT_GT(*count, 0) << quoted.page << ": " << part << " matches no test of " << found[1];
        }
    }
    EXPECT_GT(tried, 8u);
    EXPECT_EQ(matches("documents_test", "Documents.*"), 3);
    EXPECT_EQ(matches("documents_test", "Nothing.*"), 0);
    EXPECT_FALSE(is_left_out("writers_test"));
}

// What tools drop there must not be committed.
TEST(Root, holds_only_these_files_and_folders) {
    const std::string call = "git -C '" + support::source_dir().string() + "' ls-files 2>/dev/null";
    const auto lines = lines_of(call);
    if (!lines) GTEST_SKIP() << "not a git checkout, or git is not installed";
    std::set<std::string> names;
    for (const std::string& line : *lines) names.insert(line.substr(0, line.find_first_of("/\n")));
    EXPECT_GT(names.size(), 20u);
    for (const char* known : {".ci",
                              ".clang-format",
                              ".clang-tidy",
                              ".editorconfig",
                              ".github",
                              ".gitignore",
                              ".pre-commit-config.yaml",
                              "CHANGELOG.md",
                              "CITATION.cff",
                              "CMakeLists.txt",
                              "CMakePresets.json",
                              "CONTRIBUTING.md",
                              "LICENSE",
                              "README.md",
                              "SECURITY.md",
                              "assets",
                              "check",
                              "docs",
                              "files",
                              "game",
                              "play",
                              "render",
                              "sim",
                              "terrains",
                              "tests"})
        names.erase(known);
    for (const std::string& name : names) ADD_FAILURE() << name << " does not belong there";
}

}  // namespace
