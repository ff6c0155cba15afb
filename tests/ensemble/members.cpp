// What becomes of an ensemble's members: the same results in any order, on any number of threads, and after any end.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/ensemble/ensemble.h"
#include "game/ensemble/results.h"
#include "game/files/text_file.h"
#include "game/recording/format.h"
#include "game/recording/recording_file.h"
#include "tests/ensemble/small_ensemble.h"
#include "tests/game/full_disk.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

class Ensemble : public SmallEnsemble {
  protected:
    // Why it does not run in this folder.
    Failure refused(const EnsembleSpec& of, const std::string& name) {
        const auto result = run_ensemble(of, at(name), 1);
        EXPECT_FALSE(result);
        return result ? Failure{Failure::kBadAnswer, ""} : result.error();
    }
};

TEST_F(Ensemble, has_the_same_results_on_any_number_of_threads_and_after_any_end) {
    const EnsembleSpec eight = spec();
    const auto alone = results(eight, "alone", 1);
    ASSERT_EQ(alone.size(), 12u);  // members.csv, ensemble.json, report.html, counts.bin, and four maps twice
    EXPECT_EQ(results(eight, "together", 3), alone);
    const auto kept = played(eight, "alone", 1);

    // A process that was killed: some members are in the journal, one of them in part, and none in the counts.
    const std::string lines = journal("alone");
    ASSERT_TRUE(write_text(at("killed") / kJournalName, lines.substr(0, lines.size() * 2 / 3)));
    EXPECT_EQ(played(eight, "killed", 2), kept);
    // The same, with counts that lack members of the journal.
    ASSERT_TRUE(run_ensemble(spec(3), at("later"), 1));
    fs::copy_file(at("alone") / kJournalName, at("later") / kJournalName,
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(played(eight, "later", 2), kept);
    // More members go on where fewer ended.
    ASSERT_TRUE(run_ensemble(spec(5), at("grown"), 2));
    const auto grown = run_ensemble(eight, at("grown"), 2);
    ASSERT_TRUE(grown);
    EXPECT_EQ(grown->before, 5);
    EXPECT_EQ(played(eight, "grown", 1), kept);
}

TEST_F(Ensemble, counts_what_its_members_passed) {
    const EnsembleSpec few = spec(4);
    const auto result = run_ensemble(few, at("out"), 2);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->members.size(), 4u);
    std::vector<int> counts(few.scene.scenario.grid.size());
    const VertexCounts none(few.scene.scenario, few.maps);
    for (int member = 1; member <= 4; ++member) {
        const auto played = play_member(few, member, none, [] { return false; });
        ASSERT_TRUE(played);
        EXPECT_EQ(played->member, result->members.at(member));
        for (std::size_t i = 0; i < played->marks.vertices.size(); ++i)
            counts[played->marks.vertices[i]] += (played->marks.passed[i] >> 1) & 1;
    }
    const std::vector<float> share = result->counts.probability(1);
    int most = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        EXPECT_EQ(share[i], static_cast<float>(counts[i]) / 4) << i;
        most = std::max(most, counts[i]);
    }
    EXPECT_EQ(most, 4);
    EXPECT_NE(result->members.at(1).hash, result->members.at(2).hash);
}

// Against the sorted values themselves.
TEST_F(Ensemble, has_percentiles_within_three_in_a_hundred) {
    const EnsembleSpec few = spec();
    const std::size_t size = few.scene.scenario.grid.size();
    Maps maps;
    for (const double share : {1.0, 10.0, 50.0, 90.0, 99.0}) {
        maps.percentiles.push_back({Mapped::kSpeed, share});
        maps.percentiles.push_back({Mapped::kArrival, share});
    }
    constexpr std::int64_t kMembers = 200;
    VertexCounts counts(few.scene.scenario, maps), other(few.scene.scenario, maps);
    std::vector<std::vector<float>> speeds(size), arrivals(size);
    for (std::int64_t member = 1; member <= kMembers; ++member) {
        Peaks peaks{std::vector<float>(size, 0),
                    {},
                    std::vector<float>(size, 0),
                    {},
                    std::vector<std::uint32_t>(size, Peaks::kNever)};
        for (std::size_t i = 0; i < size; ++i) {
            // Every other place is reached by 60 % of all members.
            const auto chance =
                static_cast<std::uint32_t>(member) * 7919u + static_cast<std::uint32_t>(i) * 104729u;
            float speed = 0, arrival = std::numeric_limits<float>::infinity();
            if (i % 2 == 0 && chance % 100 < 60) {
                peaks.depth[i] = 1;
                speed = peaks.speed_slope[i] = 0.5f + static_cast<float>(chance % 4001) / 100;
                peaks.arrival[i] = chance % 3001;
                arrival = static_cast<float>(peaks.arrival[i]) * few.scene.scenario.params.tick_s;
            }
            speeds[i].push_back(speed), arrivals[i].push_back(arrival);
        }
        const Marks marks = counts.marks(peaks);
        EXPECT_TRUE(counts.can_count(marks));
        counts.add(member, marks);
    }
    ASSERT_TRUE(other.take(counts.bytes(few.identity), few.identity));
    for (const Percentile& percentile : maps.percentiles) {
        const std::vector<float> found = counts.percentile(percentile);
        const std::vector<float> again = other.percentile(percentile);
        auto& values = percentile.of == Mapped::kSpeed ? speeds : arrivals;
        for (std::size_t i = 0; i < size; ++i) {
            std::ranges::sort(values[i]);
            const auto rank = static_cast<std::size_t>(std::lround(percentile.share / 100 * kMembers));
            const float wanted = values[i][rank - 1];
            if (std::isinf(wanted)) {
                EXPECT_TRUE(std::isnan(found[i])) << percentile.share;
                continue;
            }
            ASSERT_NEAR(found[i], wanted, 0.032f * wanted + 1e-3f) << percentile.share << " at " << i;
            EXPECT_EQ(again[i], found[i]);
        }
    }
}

TEST_F(Ensemble, plays_a_member_alone_to_the_same_state_as_a_recording) {
    const EnsembleSpec few = spec(2);
    const auto result = run_ensemble(few, at("out"), 1);
    ASSERT_TRUE(result);
    const VertexCounts none(few.scene.scenario, few.maps);
    const auto played = play_member(
        few, 2, none, [] { return false; }, at("second.couloir"));
    ASSERT_TRUE(played);
    const auto recording = read_recording(at("second.couloir"));
    ASSERT_TRUE(recording);
    EXPECT_EQ(hex(recording->states.back().hash), result->members.at(2).hash);
    EXPECT_EQ(recording->header.scenario.params.friction, static_cast<float>(few.sample(2)[0]));
}

TEST_F(Ensemble, refuses_a_folder_of_another_one_and_damage) {
    const EnsembleSpec few = spec(2);
    ASSERT_TRUE(run_ensemble(few, at("out"), 1));
    EnsembleSpec other = spec(2);
    other.identity = "0123456789abcdef";
    EXPECT_NE(refused(other, "out").sentence.find("journal.jsonl:1: is the journal of another ensemble"),
              std::string::npos);

    EXPECT_NE(refused(spec(1), "out").sentence.find("has member 2, and"), std::string::npos);

    const std::string lines = journal("out");
    const std::size_t second = lines.find('\n') + 1;
    const auto damaged = [&](const std::string& text) {
        EXPECT_TRUE(write_text(at("bad") / kJournalName, text));
        const Failure failure = refused(few, "bad");
        EXPECT_EQ(failure.status, Failure::kUnusable);
        EXPECT_EQ(read_text(at("bad") / kJournalName).value(), text) << "nothing is lost";
        return failure.sentence;
    };
    EXPECT_NE(damaged(lines.substr(0, second) + "{}\n" + lines.substr(second)).find(":2: is no member"),
              std::string::npos);
    EXPECT_NE(damaged(lines + lines.substr(second)).find("a second time"), std::string::npos);
    EXPECT_NE(damaged("words without a line break").find(":1: is not the journal"), std::string::npos);

    const std::string counts = read_text(at("out") / kCountsName).value();
    for (std::size_t i = 0; i < counts.size(); i += 97) {
        std::string flipped = counts;
        flipped[i] = static_cast<char>(flipped[i] ^ 4);
        EXPECT_FALSE(VertexCounts(few.scene.scenario, few.maps).take(flipped, few.identity)) << i;
        EXPECT_FALSE(VertexCounts(few.scene.scenario, few.maps).take(counts.substr(0, i), few.identity)) << i;
    }
    EXPECT_TRUE(VertexCounts(few.scene.scenario, few.maps).take(counts, few.identity));
    EXPECT_FALSE(VertexCounts(few.scene.scenario, few.maps).take(counts, other.identity));
    EXPECT_FALSE(VertexCounts(few.scene.scenario, {}).take(counts, few.identity));
}

TEST_F(Ensemble, ends_with_a_sentence_where_a_member_comes_out_otherwise_than_before) {
    const EnsembleSpec few = spec(2);
    ASSERT_TRUE(run_ensemble(few, at("out"), 1));
    fs::remove(at("out") / kCountsName);
    std::string lines = journal("out");
    const std::size_t hash = lines.rfind("\"hash\":\"") + 8;
    lines.replace(hash, 16, "0123456789abcdef");
    ASSERT_TRUE(write_text(at("out") / kJournalName, lines));
    const Failure failure = refused(few, "out");
    EXPECT_EQ(failure.status, Failure::kBadAnswer);
    EXPECT_NE(failure.sentence.find("came to 0123456789abcdef before"), std::string::npos)
        << failure.sentence;
}

TEST_F(Ensemble, is_read_for_a_view_without_a_trace) {
    const EnsembleSpec eight = spec();
    const auto none = read_ensemble(eight, at("out"));
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().status, Failure::kUnusable);
    EXPECT_NE(none.error().sentence.find("has no results"), std::string::npos) << none.error().sentence;
    const auto kept = played(eight, "out", 2);
    const std::string whole = journal("out"), torn = whole + "{\"member\":9";
    ASSERT_TRUE(write_text(at("out") / kJournalName, torn));
    const auto read = read_ensemble(eight, at("out"));
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->members.size(), 8u);
    EXPECT_EQ(read->counts.members(), 8);
    EXPECT_EQ(read->counts.bytes(eight.identity), kept.second);
    EXPECT_EQ(journal("out"), torn);
    const auto again = run_ensemble(eight, at("out"), 1);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->members, read->members) << "with the places where they ended";
    const auto smaller = read_ensemble(spec(3), at("out"));
    ASSERT_FALSE(smaller);
    EXPECT_EQ(smaller.error().status, Failure::kUnusable);
}

TEST_F(Ensemble, has_one_writer) {
    const EnsembleSpec few = spec(2);
    const auto first = Journal::open(at("out") / kJournalName, few);
    ASSERT_TRUE(first);
    const Failure failure = refused(few, "out");
    EXPECT_EQ(failure.status, Failure::kMachine);
    EXPECT_EQ(failure.sentence, (at("out") / kJournalName).string() + ": another process writes it");
}

TEST_F(Ensemble, keeps_whole_lines_on_a_full_disk_and_goes_on_from_them) {
    const EnsembleSpec eight = spec();
    const auto all = played(eight, "all", 1);
    {
        const FullDisk disk(1500);
        const Failure failure = refused(eight, "full");
        EXPECT_EQ(failure.status, Failure::kMachine);
        EXPECT_NE(failure.sentence.find(kJournalName), std::string::npos) << failure.sentence;
    }
    EXPECT_EQ(journal("full").back(), '\n');
    EXPECT_EQ(played(eight, "full", 2), all);
}

// A slope of 25° on which two squares may be released, and one that lies far away.
class Region : public Ensemble {
  protected:
    void SetUp() override {
        std::string heights = "ncols 41\nnrows 41\nxllcorner 680000\nyllcorner 5240000\ncellsize 10\n";
        for (int row = 0; row < 41; ++row)
            for (int column = 0; column < 41; ++column)
                heights += fmt::format("{} ", 2000 - 4.7 * row + 0.01 * column * (column % 3));
        EXPECT_TRUE(write_text(at("hill.asc"), heights));
        const auto square = [](double x, double y, double thickness) {
            const double e = 11.38 + x, n = 47.2885 + y, w = 0.0008, h = 0.0006;
            return fmt::format(
                R"({{"type":"Feature","properties":{{"thickness":{}}},"geometry":{{"type":"Polygon","coordinates":[[[{},{}],[{},{}],[{},{}],[{},{}],[{},{}]]]}}}})",
                thickness, e, n, e + w, n, e + w, n + h, e, n + h, e, n);
        };
        EXPECT_TRUE(write_text(at("areas.geojson"),
                               R"({"type":"FeatureCollection","features":[)" + square(0.0015, 0.002, 1) +
                                   "," + square(0.0035, 0.002, 2) + "," + square(1, 0.002, 1) + "]}"));
    }
    Outcome<EnsembleSpec> region(const std::string& lines = "") {
        EXPECT_TRUE(write_text(at("region.toml"),
                               "terrain = \"hill.asc\"\ncrs = \"EPSG:32632\"\nrelease = \"areas.geojson\"\n"
                               "polygons = \"one at a time\"\ngrid = 40\nseconds = 40\n" +
                                   lines + "[[map]]\nof = \"thickness\"\nover = [0.1]\n"));
        return read_ensemble_spec(at("region.toml"), {});
    }
};

TEST_F(Region, releases_its_polygons_in_turn_and_tells_which_is_hardest) {
    const auto each = region();
    ASSERT_TRUE(each) << each.error().sentence;
    EXPECT_EQ(each->members, 3);
    const auto all = results(*each, "each", 1);
    EXPECT_TRUE(all.contains("areas_thickness_over_0.1.tif") && all.contains("hardest_polygon.tif"));
    EXPECT_NE(all.at("members.csv").find("polygon 3 of its release covers no ground"), std::string::npos);
    EXPECT_EQ(played(*each, "again", 2), played(*each, "each", 1));

    const auto result = run_ensemble(*each, at("each"), 1);
    ASSERT_TRUE(result);
    const std::vector<std::int64_t> hardest = result->counts.hardest();
    const std::vector<float> share = result->counts.probability(0);
    for (const int member : {1, 2}) {
        EXPECT_GT(result->members.at(member).released, 2000) << member;
        const terrains::ReleasePatch& release =
            each->scene.patches[static_cast<std::size_t>(member) - 1].release;
        for (std::size_t i = 0; i < release.vertices.size(); ++i) {
            if (release.thickness[i] < 0.5f) continue;  // its edge
            EXPECT_EQ(hardest[release.vertices[i]], member);
            EXPECT_GE(share[release.vertices[i]], 0.5f);
        }
    }
    EXPECT_GT(result->members.at(2).released, 1.5 * result->members.at(1).released);
    EXPECT_EQ(*std::ranges::max_element(hardest), 2) << "of the polygons that could be released";

    // Twice each, with other numbers; the polygon follows from the number of the run.
    const auto twice = region("members = 6\n[[variable]]\nof = \"friction\"\nuniform = [0.2, 0.3]\n");
    ASSERT_TRUE(twice);
    EXPECT_NE(twice->identity, each->identity);
    EXPECT_EQ(twice->patch_of(5), 2u);
    const auto fifth = twice->scenario_of(5), second = each->scenario_of(2);
    ASSERT_TRUE(fifth && second);
    EXPECT_EQ(fifth->rolling, second->rolling);
    EXPECT_EQ(fifth->params.friction, static_cast<float>(twice->sample(5)[0]));
}

TEST_F(Region, has_polygons_that_add_up_to_all_released_together) {
    const auto each = region();
    ASSERT_TRUE(each);
    std::vector<float> sum(each->scene.scenario.grid.size());
    for (const auto& [release, params] : each->scene.patches)
        for (std::size_t i = 0; i < release.vertices.size(); ++i)
            sum[release.vertices[i]] += release.thickness[i];
    for (std::size_t i = 0; i < sum.size(); ++i)
        EXPECT_NEAR(sum[i], each->scene.scenario.rolling[i], 1e-5) << "they do not overlap";
}

TEST_F(Ensemble, tells_members_that_cannot_run_and_counts_the_others) {
    const fs::path file = at("steep.toml");
    ASSERT_TRUE(write_text(file,
                           "scene = \"landslide\"\ngrid = 20\nseconds = 5\nmembers = 6\nmodel = \"bcre\"\n"
                           "[[variable]]\nof = \"stop_slope\"\nlist = [0.3, 5]\n"));
    const auto steep = read_ensemble_spec(file, {});
    ASSERT_TRUE(steep) << steep.error().sentence;
    const auto result = run_ensemble(*steep, at("out"), 2);
    ASSERT_TRUE(result) << result.error().sentence;
    int faults = 0;
    for (const auto& [number, member] : result->members) faults += !member.fault.empty();
    EXPECT_EQ(faults, 3);
    EXPECT_EQ(result->counts.members(), 3);
    EXPECT_EQ(to_json(*steep, *result).at("could_not_run"), 3);
    EXPECT_EQ(played(*steep, "out", 1), played(*steep, "again", 1)) << "they are not tried again";
}

TEST(Spread, is_that_of_the_sorted_values) {
    const Spread spread = spread_of({5, 1, 4, 2, 3, 6, 7, 8, 9, 10, 0});
    EXPECT_EQ(spread.least, 0);
    EXPECT_EQ(spread.tenth, 1);
    EXPECT_EQ(spread.middle, 5);
    EXPECT_EQ(spread.nine_tenths, 9);
    EXPECT_EQ(spread.most, 10);
    EXPECT_EQ(spread_of({}).most, 0);
}

}  // namespace
}  // namespace game::test
