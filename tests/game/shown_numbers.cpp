// docs/scenes.md states the range of every number that a list of the program has.
#include "game/scene/shown_numbers.h"

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/recording/json_values.h"
#include "sim/world/params.h"
#include "terrains/generators.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// As the page writes it: −12000, 10⁶.
std::string in_page(double number) {
    if (number == 1e6) return "10⁶";
    return number < 0 ? fmt::format("−{}", -number) : fmt::format("{}", number);
}

std::string range_in_page(double least, double most) {
    if (least == -most) return "±" + in_page(most);
    return in_page(least) + " to " + in_page(most);
}

class ScenesPage {
  public:
    ScenesPage() {
        std::ifstream page(support::source_dir() / "docs/scenes.md");
        for (std::string line; std::getline(page, line);) lines_.push_back(line);
    }
    // The second columns of the rows of a key, without a unit and what is usual: a key may stand in several tables.
    std::set<std::string> ranges_of(const std::string& key) const {
        std::set<std::string> ranges;
        const std::string begin = "| `" + key + "` | ";
        for (const std::string& line : lines_) {
            if (!line.starts_with(begin)) continue;
            std::string range = line.substr(begin.size(), line.find(" |", begin.size()) - begin.size());
            if (const auto usual = range.find(" ["); usual != std::string::npos) range.resize(usual);
            if (const auto unit = range.find(", "); unit != std::string::npos) range.erase(0, unit + 2);
            ranges.insert(range);
        }
        return ranges;
    }
    // `table`: what stands before the key, such as "camera."
    template <class List>
    void expect(const std::string& table, const List& list) const {
        for (const auto& each : list) expect(table + std::string(each.in_scene), each.least, each.most);
    }
    void expect(const std::string& key, double least, double most) const {
        EXPECT_TRUE(ranges_of(key).contains(range_in_page(least, most)))
            << key << " has the range " << range_in_page(least, most);
    }

  private:
    std::vector<std::string> lines_;
};

TEST(ShownNumbers, have_the_ranges_that_the_page_of_scenes_states) {
    const ScenesPage page;
    page.expect("light.", kLightNumbers);
    page.expect("camera.", kCameraNumbers);
    page.expect("wind.", kWindNumbers);
    page.expect("trees.", kTreeNumbers);
    page.expect("", kLookNumbers);
    page.expect("", kPowderNumbers);
    page.expect("", kFlowLookNumbers);
    page.expect("", kFlowNumbers);
    for (const sim::ParamInfo& info : sim::kParams)
        page.expect(std::string(info.name), shortest(info.least), shortest(info.most));
    for (const terrains::Generator& generator : terrains::generators())
        for (const terrains::GeneratorNumber& number : generator.numbers)
            page.expect(number.name, number.lowest, number.highest);
}

TEST(ShownNumbers, of_the_page_are_found_and_told_apart) {
    const ScenesPage page;
    EXPECT_EQ(page.ranges_of("camera.distance"), std::set<std::string>{"0.1 to 10⁶"});
    EXPECT_TRUE(page.ranges_of("camera.nothing").empty());
    EXPECT_EQ(range_in_page(-360, 360), "±360");
    EXPECT_EQ(range_in_page(-12000, 9000), "−12000 to 9000");
}

}  // namespace
}  // namespace game::test
