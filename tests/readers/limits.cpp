#include "game/base/limits.h"

#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace game::test {
namespace {

std::string table() {
    std::string text = "| reader | what | at most |\n|---|---|---|\n";
    for (const ReaderLimit& limit : kReaderLimits)
        text += fmt::format("| {} | {} | {}{}{} |\n", limit.reader, limit.what, limit.most,
                            limit.unit.empty() ? "" : " ", limit.unit);
    return text;
}

TEST(Limits, are_those_of_the_documentation) {
    std::ifstream file(support::source_dir() / "docs/limits.md");
    const std::string docs{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(docs.find(table()), std::string::npos) << "docs/limits.md should have\n" << table();
}

}  // namespace
}  // namespace game::test
