#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/analysis/headless.h"
#include "game/recording/ground_data.h"
#include "game/recording/recording_file.h"
#include "game/scene/material.h"
#include "game/scene/standing.h"
#include "game/session/session.h"
#include "tests/game/program.h"
#include "tests/game/recording_files.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

// A recording with an edited header, rechained: only the header's own checks can detect the change.
class ForgedHeader : public testing::Test {
  protected:
    ForgedHeader() : path_(folder_.path() / "forged.couloir") {
        record(path_, small_scenario(), 20, some_commands());
        bodies_ = bodies_of(read_bytes(path_));
        header_ = json_of(bodies_[0]);
    }

    Outcome<Recording> read(const Json& header) {
        bodies_[0] = body_of(header);
        write_bytes(path_, chained(bodies_));
        return read_recording(path_);
    }

    std::string refused(const Json& header) {
        const auto outcome = read(header);
        if (outcome) {
            ADD_FAILURE() << "accepted";
            return {};
        }
        const std::string& sentence = outcome.error().sentence;
        EXPECT_EQ(outcome.error().status, Failure::kUnusable) << sentence;
        EXPECT_EQ(sentence.rfind(path_.string() + ":1: ", 0), 0u) << sentence;
        EXPECT_EQ(sentence.find("exception"), std::string::npos) << sentence;
        return sentence;
    }

    support::TemporaryFolder folder_;
    std::filesystem::path path_;
    std::vector<std::string> bodies_;
    Json header_;
};

TEST_F(ForgedHeader, with_a_camera_path_out_of_order_or_of_another_length_is_refused) {
    const auto row = [](double time) {
        return Json{{"time_s", time},      {"target", {0, 0, 0}}, {"azimuth_deg", 0},
                    {"elevation_deg", 10}, {"distance_m", 1},     {"field_of_view_deg", 30}};
    };
    Json& path = header_["view"]["camera_path"];
    path = {row(1), row(2)};
    EXPECT_EQ(read(header_)->header.scenario.camera_path.size(), 2u);
    for (const Json& wrong :
         {Json{row(2), row(1)}, Json{row(1), row(1)}, Json{row(1)}, Json{row(-1), row(1)}, Json{row(1), 3},
          Json{row(1), Json::object()}, Json("path"), Json(std::vector<Json>(65, row(1)))}) {
        path = wrong;
        refused(header_);
    }
}

TEST_F(ForgedHeader, is_accepted_unchanged) {
    const auto recording = read(header_);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_FALSE(recording->warning);
}

TEST_F(ForgedHeader, of_a_newer_major_version_is_refused_with_the_version) {
    header_["version"] = {2, 0};
    // Another format may differ in everything else, including the chain.
    write_bytes(path_, header_.dump() + "\n");
    const auto outcome = read_recording(path_);
    ASSERT_FALSE(outcome);
    EXPECT_NE(outcome.error().sentence.find("format 2.0"), std::string::npos) << outcome.error().sentence;
    EXPECT_NE(refused(header_).find("format 2.0"), std::string::npos);
    for (const Json& never : {Json{0, 1}, Json{-1, 0}, Json{1, -1}}) {
        header_["version"] = never;
        EXPECT_NE(refused(header_).find("format "), std::string::npos);
    }
}

// Its chain is whole, and so is the file: it is not damaged, and a program of then reads it.
TEST_F(ForgedHeader, of_before_the_first_release_is_refused_and_told_which_program_reads_it) {
    header_["format"] = "couloir recording";
    header_["version"] = {1, 9};
    const std::string sentence = refused(header_);
    EXPECT_NE(sentence.find("recorded before Couloir 0.1.0"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("the program of commit"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("damaged"), std::string::npos) << sentence;
}

// What an older program cannot read of it is not damage.
TEST_F(ForgedHeader, of_a_newer_minor_version_is_named_where_something_in_it_is_unknown) {
    header_["version"] = {1, kFormatMinor + 1};
    const auto refused_with = [this](const std::string& line) {
        bodies_[1] = line;
        const auto recording = read(header_);
        ASSERT_FALSE(recording);
        EXPECT_EQ(recording.error().status, Failure::kUnusable);
        for (const std::string& fact :
             {fmt::format("1.{}", kFormatMinor + 1), fmt::format("1.{}", kFormatMinor)})
            EXPECT_NE(recording.error().sentence.find(fact), std::string::npos) << recording.error().sentence;
    };
    refused_with(R"({"tick":0,"snow":{"rate":1})");
    refused_with(R"({"tick":0,"pour":{"x":1,"wind":2})");
    header_["physics"]["model"] = "newton";
    refused_with("{\"end\":0");
}

// A parameter that came later is its default in an older recording, and missing in one that should have it.
TEST_F(ForgedHeader, of_an_older_minor_version_lacks_what_came_later) {
    const Json whole = header_;
    for (const sim::ParamInfo& info : sim::kParams) {
        header_ = whole;
        header_["physics"].erase(std::string(info.name));
        for (int minor = 0; minor <= kFormatMinor; ++minor) {
            header_["version"] = {1, minor};
            const auto recording = read(header_);
            ASSERT_EQ(recording.has_value(), minor < info.since) << info.name << ", minor " << minor;
            if (recording)
                EXPECT_EQ(recording->header.scenario.params.*info.value, sim::Params().*info.value);
            else
                EXPECT_NE(recording.error().sentence.find(info.name), std::string::npos)
                    << recording.error().sentence;
        }
    }
}

TEST_F(ForgedHeader, of_a_newer_minor_version_may_have_unknown_fields) {
    header_["version"] = {1, kFormatMinor + 1};
    header_["snow_crystals"] = {{"kind", "dendrite"}};
    header_["physics"]["cohesion"] = 3;
    Json state = json_of(bodies_[1]);
    state["fronts"] = {1, 2, 3};
    bodies_[1] = body_of(state);
    const auto recording = read(header_);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_EQ(recording->header.scenario.params, small_scenario().params);
    ASSERT_TRUE(recording->warning);
    EXPECT_NE(recording->warning->find(fmt::format("recorded in format 1.{}", kFormatMinor + 1)),
              std::string::npos)
        << *recording->warning;
}

// What this program leaves out may be why its states differ.
TEST_F(ForgedHeader, of_a_newer_minor_version_with_other_states_is_not_comparable) {
    const auto last = std::find_if(bodies_.rbegin(), bodies_.rend(),
                                   [](const std::string& body) { return json_of(body).contains("hash"); });
    Json state = json_of(*last);
    state["hash"] = "0123456789abcdef";
    *last = body_of(state);
    for (const bool newer : {false, true}) {
        header_["version"] = {1, kFormatMinor + (newer ? 1 : 0)};
        bodies_[0] = body_of(header_);
        write_bytes(path_, chained(bodies_));
        const Finished replayed = couloir({"replay", path_.string(), "--verify", "--json"});
        EXPECT_EQ(replayed.status, 1) << replayed.err;
        EXPECT_EQ(Json::parse(replayed.out)["verified"]["outcome"], newer ? "not comparable" : "differs");
        EXPECT_EQ(replayed.err.find("use a newer couloir") != std::string::npos, newer) << replayed.err;
    }
}

TEST_F(ForgedHeader, of_a_newer_minor_version_is_named_beside_every_fault) {
    header_["version"] = {1, kFormatMinor + 1};
    bodies_.insert(bodies_.begin() + 2, R"({"tick":99999,"settle":{"x":1.0,"y":1.0,"radius":1.0})");
    const auto recording = read(header_);
    ASSERT_FALSE(recording);
    EXPECT_NE(recording.error().sentence.find("use a newer couloir"), std::string::npos)
        << recording.error().sentence;
}

TEST_F(ForgedHeader, keeps_its_valid_origin_and_refuses_an_invalid_one) {
    EXPECT_FALSE(read(header_)->header.parent || read(header_)->header.rewritten_from);
    Json told = header_;
    told["parent"] = {{"name", "valley"}, {"tick", 60}, {"change", "the pour is left out"}};
    told["rewritten_from"] = {{"version", {1, 0}}, {"physics_version", 2}, {"program", "couloir 0.0.9"}};
    const auto recording = read(told);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_EQ(recording->header.parent, (Parent{"valley", 60, "the pour is left out"}));
    EXPECT_EQ(recording->header.rewritten_from, (Origin{0, 2, "couloir 0.0.9"}));
    EXPECT_EQ(to_json(recording->header)["parent"], told["parent"]);
    EXPECT_EQ(to_json(recording->header)["rewritten_from"], told["rewritten_from"]);

    const std::pair<const char*, Json> nonsense[] = {{"/parent", "valley"},
                                                     {"/parent/name", 7},
                                                     {"/parent/tick", -1},
                                                     {"/parent/change", Json::array()},
                                                     {"/rewritten_from", 2},
                                                     {"/rewritten_from/version", "1.2"},
                                                     {"/rewritten_from/version", {9, 0}},
                                                     {"/rewritten_from/physics_version", 0.5}};
    for (const auto& [where, what] : nonsense) {
        Json wrong = told;
        wrong[Json::json_pointer(where)] = what;
        EXPECT_FALSE(refused(wrong).empty()) << where;
    }
}

TEST_F(ForgedHeader, with_the_ground_of_another_recording_is_refused) {
    Scenario other = small_scenario();
    other.bedrock[40] += 0.5f;
    Header of_other;
    of_other.scenario = other;
    const Json spliced = to_json(of_other)["terrain"]["data"];
    ASSERT_NE(header_["terrain"]["data"], spliced);
    header_["terrain"]["data"] = spliced;
    const std::string sentence = refused(header_);
    EXPECT_NE(sentence.find("'made up'"), std::string::npos) << sentence;
}

TEST_F(ForgedHeader, with_truncated_or_invalid_ground_data_is_refused) {
    const std::string data = header_["terrain"]["data"];
    for (const std::string& wrong : {std::string(), std::string("AAAA"), data.substr(0, data.size() / 2),
                                     data + data, std::string("%%%"), std::string(100000, 'A')}) {
        header_["terrain"]["data"] = wrong;
        EXPECT_NE(refused(header_).find("terrain data"), std::string::npos);
    }
}

TEST_F(ForgedHeader, with_another_grid_than_its_ground_is_refused) {
    for (const char* key : {"nx", "ny"})
        for (const int wrong : {0, 2, 3, 14, 4097, 4098, 2000000000}) {
            Json header = header_;
            header["terrain"][key] = wrong;
            refused(header);
        }
}

TEST_F(ForgedHeader, of_another_physics_version_plays_but_is_not_comparable) {
    header_["physics_version"] = kPhysicsVersion + 1;
    const auto recording = read(header_);
    ASSERT_TRUE(recording) << recording.error().sentence;
    EXPECT_EQ(recording->header.physics_version, kPhysicsVersion + 1);
    const Finished replayed = couloir({"replay", path_.string(), "--verify", "--json"});
    EXPECT_EQ(replayed.status, 1) << replayed.err;
    const Json summary = Json::parse(replayed.out);
    EXPECT_EQ(summary["ticks"], 20);
    EXPECT_EQ(summary["verified"]["comparable"], false);
    EXPECT_EQ(summary["verified"]["exact"], false);
    EXPECT_NE(couloir({"replay", path_.string(), "--verify"}).out.find("not comparable"), std::string::npos);
}

TEST_F(ForgedHeader, with_things_that_cannot_be_is_refused) {
    const Json fell = {{"fell", {{"x", 9.0}, {"y", 9.0}, {"radius", 3.0}}}};
    const Json pour = json_of(
        R"({"pour":{"x":1.0,"y":1.0,"radius":1.0,"rate":1.0,"duration":1.0,"as":"rolling","profile":"disc"})");
    header_["things"] = {{"placed", Json::array({fell})}, {"earth_budget", 12.5}};
    ASSERT_TRUE(read(header_)) << read(header_).error().sentence;
    const std::vector<sim::Stems> dense(
        header_["terrain"]["nx"].get<std::size_t>() * header_["terrain"]["ny"].get<std::size_t>(),
        sim::Stems{2001, 0, 30, 22});
    const auto one = [](sim::Stems stems) { return pack_forest(std::vector<sim::Stems>(143, stems)); };
    ASSERT_EQ(dense.size(), 143u);
    Json steep = fell, high = fell;
    steep["fell"]["slope"] = {50, 40}, high["fell"]["radius"] = 1e9;
    const std::vector<std::pair<const char*, Json>> nonsense{
        {"/things", 7},
        {"/things/placed", "many"},
        {"/things/placed", Json::array({7})},
        {"/things/placed", Json::array({Json::object()})},
        {"/things/placed", Json::array({pour})},
        {"/things/placed", Json::array({steep})},
        {"/things/placed", Json::array({high})},
        {"/things/placed", std::vector<Json>(kMostPlaced + 1, fell)},
        {"/things/earth_budget", -1},
        {"/things/earth_budget", "much"},
        {"/things/forest", 7},
        {"/things/forest", "AAAA"},
        {"/things/forest", pack_forest(std::span(dense).first(142))},
        {"/things/forest", pack_forest(dense)},
        {"/things/forest", one({0, 2001, 30, 22})},
        {"/things/forest", one({1, 0, 9, 22})},
        {"/things/forest", one({1, 0, 61, 22})},
        {"/things/forest", one({1, 0, 30, 0})},
        {"/things/forest", one({1, 0, 30, 36})},
        {"/things/forest", one({0, 0, 30, 22})},
        {"/things/water", 7},
        {"/things/water", pack_metres(std::vector<float>(142))},
        {"/things/water", pack_metres(std::vector<float>(143, 1.01f))},
        {"/things/water", pack_metres(std::vector<float>(143, -0.5f))},
        {"/things/water", pack_metres(std::vector<float>(143, 0x1p-25f))},
        {"/things/water", pack_metres(std::vector<float>(143, std::nanf("")))},
    };
    for (const auto& [where, what] : nonsense) {
        Json wrong = header_;
        wrong[Json::json_pointer(where)] = what;
        EXPECT_FALSE(refused(wrong).empty()) << where << " " << what;
    }
    header_["things"]["forest"] = one({2000, 2000, 60, 35});
    std::vector<float> wet(143);
    wet[80] = 0x1p-24f;
    header_["things"]["water"] = pack_metres(wet);
    EXPECT_TRUE(read(header_)) << read(header_).error().sentence;
}

TEST_F(ForgedHeader, with_a_number_beyond_double_range_is_refused) {
    std::string body = body_of(header_);
    const std::string key = "\"courant\":";
    const auto at = body.find(key) + key.size();
    body.replace(at, body.find(',', at) - at, "1e999");
    bodies_[0] = body;
    write_bytes(path_, chained(bodies_));
    EXPECT_FALSE(read_recording(path_));
}

// Valid values in these places are as good as the original ones.
bool may_stand(const std::string& place, const Json& value) {
    static const std::set<std::string> kNames{
        "/program",  "/scene",        "/title",           "/terrain/georeference/wkt",
        "/material", "/terrain/name", "/terrain/licence", "/view/look/texture"};
    static const std::set<std::string> kSigned{
        "/terrain/georeference/x",   "/terrain/georeference/y",  "/view/light/azimuth_deg",
        "/view/light/elevation_deg", "/view/camera/azimuth_deg", "/view/camera/elevation_deg",
        "/view/camera/target/0",     "/view/camera/target/1",    "/view/camera/target/2"};
    return value.is_string() ? kNames.contains(place) : value.is_number() && kSigned.contains(place);
}

TEST_F(ForgedHeader, with_a_wrong_kind_of_value_anywhere_is_refused) {
    std::set<std::string> places;
    const Json leaves = header_.flatten();
    for (const auto& [leaf, value] : leaves.items()) {
        const std::string path = leaf;
        for (auto end = path.size(); end != 0 && end != std::string::npos; end = path.rfind('/', end - 1))
            places.insert(path.substr(0, end));  // the leaf and everything that contains it
    }
    ASSERT_GT(places.size(), 50u);
    const std::array<Json, 5> wrongs{Json(nullptr), Json("snow"), Json(-1), Json::array(), Json(true)};
    for (const std::string& place : places)
        for (const Json& wrong : wrongs) {
            SCOPED_TRACE(place + " = " + wrong.dump());
            if (may_stand(place, wrong)) continue;
            Json header = header_;
            header[Json::json_pointer(place)] = wrong;
            refused(header);
        }
}

TEST_F(ForgedHeader, without_further_lines_plays_but_verifies_nothing) {
    bodies_.resize(1);
    ASSERT_TRUE(read(header_));
    const Finished replayed = couloir({"replay", path_.string(), "--verify"});
    EXPECT_EQ(replayed.status, 1) << replayed.err;
    EXPECT_NE(replayed.out.find("nothing is verified"), std::string::npos) << replayed.out;
    const Json summary = Json::parse(couloir({"replay", path_.string(), "--verify", "--json"}).out);
    EXPECT_EQ(summary["verified"]["exact"], false);
}

TEST_F(ForgedHeader, without_any_one_member_is_refused) {
    const auto without = [&](const char* parent) {
        const Json::json_pointer at(parent);
        for (const auto& [key, value] : header_.at(at).items()) {
            Json header = header_;
            header.at(at).erase(key);
            SCOPED_TRACE(std::string(parent) + "/" + key);
            const bool optional = key == "camera" || key == "georeference" || key == "texture";
            if (!optional) refused(header);
        }
    };
    for (const char* parent : {"", "/physics", "/physics/borders", "/view", "/view/look", "/view/light",
                               "/view/camera", "/terrain", "/terrain/georeference"})
        without(parent);
}

}  // namespace
}  // namespace game::test
