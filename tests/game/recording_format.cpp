#include "game/recording/chain.h"
#include "game/recording/format.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "tests/game/recording_files.h"

namespace game::test {
namespace {

// Round-trips through text, as a file would.
Json through_text(const Json& json) {
    return Json::parse(json.dump());
}

Scenario through_header(const Scenario& scenario) {
    Header header;
    header.scenario = scenario;
    const auto read = header_from(through_text(to_json(header)));
    EXPECT_TRUE(read) << read.error();
    return read.value().scenario;
}

TEST(RecordingHeader, keeps_physics_ground_and_names_bit_identical) {
    const Scenario before = small_scenario(), after = through_header(before);
    EXPECT_EQ(after.params, before.params);
    EXPECT_EQ(ground_hash(after), ground_hash(before));
    EXPECT_EQ(after.bedrock, before.bedrock);
    EXPECT_EQ(after.depth, before.depth);
    EXPECT_EQ(after.rolling, before.rolling);
    EXPECT_EQ(after.has_data, before.has_data);
    EXPECT_EQ(after.grid, before.grid);
    EXPECT_EQ(after.datum, before.datum);
    EXPECT_EQ(after.scene, before.scene);
    EXPECT_EQ(after.title, before.title);
    EXPECT_EQ(after.material, before.material);
    EXPECT_EQ(after.terrain, before.terrain);
    EXPECT_EQ(after.licence, before.licence);
}

TEST(RecordingHeader, keeps_the_view_bit_identical) {
    const Scenario before = small_scenario(), after = through_header(before);
    EXPECT_EQ(after.look.rock, before.look.rock);
    EXPECT_EQ(after.look.meadow, before.look.meadow);
    EXPECT_EQ(after.look.standing, before.look.standing);
    EXPECT_EQ(after.look.rolling, before.look.rolling);
    EXPECT_EQ(after.look.roughness, before.look.roughness);
    EXPECT_EQ(after.look.cover_visible_m, before.look.cover_visible_m);
    EXPECT_EQ(after.look.rolling_visible_m, before.look.rolling_visible_m);
    EXPECT_EQ(after.look.flow, before.look.flow);
    EXPECT_EQ(after.look.turf, std::nullopt);
    Scenario green = before;
    green.look.turf = glm::vec3(0.135f, 0.15f, 0.052f);
    EXPECT_EQ(through_header(green).look.turf, green.look.turf);
    green.look.date = render::Date{10, 9};
    EXPECT_EQ(through_header(green).look.date, green.look.date);
    EXPECT_EQ(after.look.powder, render::PowderLook());
    Scenario dusty = before;
    dusty.look.powder = {0.7f, 3.1f, {0.5f, 1.f / 3.f, 0.2f}};
    EXPECT_EQ(through_header(dusty).look.powder, dusty.look.powder);
    Scenario plain = before;
    plain.look.flow.reset();
    EXPECT_EQ(through_header(plain).look.flow, std::nullopt);
    EXPECT_EQ(after.light.azimuth_deg, before.light.azimuth_deg);
    EXPECT_EQ(after.light.elevation_deg, before.light.elevation_deg);
    ASSERT_TRUE(after.camera);
    EXPECT_EQ(after.camera->target, before.camera->target);
    EXPECT_EQ(after.camera->azimuth_deg, before.camera->azimuth_deg);
    EXPECT_EQ(after.camera->elevation_deg, before.camera->elevation_deg);
    EXPECT_EQ(after.camera->distance_m, before.camera->distance_m);
    EXPECT_EQ(after.camera->field_of_view_deg, before.camera->field_of_view_deg);
    Scenario without = before;
    without.camera.reset();
    EXPECT_FALSE(through_header(without).camera);
}

TEST(RecordingHeader, keeps_the_style_and_refuses_an_unknown_one) {
    Header header;
    header.scenario = small_scenario();
    const Json landscape = to_json(header);
    EXPECT_FALSE(landscape["view"]["look"].contains("style"));
    EXPECT_FALSE(header_from(landscape).value().scenario.model);
    header.scenario.model = true;
    EXPECT_TRUE(through_header(header.scenario).model);
    for (const Json& unknown : {Json("cubist"), Json("landscape "), Json(true), Json(nullptr)}) {
        Json wrong = landscape;
        wrong["view"]["look"]["style"] = unknown;
        const auto refused = header_from(wrong);
        ASSERT_FALSE(refused) << unknown;
        EXPECT_NE(refused.error().find("style"), std::string::npos) << refused.error();
    }
}

// Headers with one of these values in a table of their view are refused.
void expect_refused(const Json& sound, const char* table,
                    const std::vector<std::pair<const char*, Json>>& values) {
    for (const auto& [key, value] : values) {
        Json wrong = sound;
        wrong["view"][table][key] = value;
        EXPECT_FALSE(header_from(wrong)) << table << key << value;
    }
}

TEST(RecordingHeader, keeps_the_trees_and_refuses_impossible_ones) {
    Header header;
    header.scenario = small_scenario();
    EXPECT_FALSE(to_json(header)["view"].contains("trees"));
    EXPECT_EQ(through_header(header.scenario).trees, render::TreeRules());
    header.scenario.trees = {.density = 123.5, .line_m = 1512.25, .seed = 77};
    EXPECT_EQ(through_header(header.scenario).trees, header.scenario.trees);
    expect_refused(to_json(header), "trees",
                   {{"density", 1e7}, {"density", "many"}, {"line_m", 1e5}, {"seed", -1}, {"seed", nullptr}});
}

TEST(RecordingHeader, keeps_what_stands_bit_identical_and_has_no_key_if_nothing_does) {
    Header header;
    header.scenario = small_scenario();
    EXPECT_FALSE(to_json(header).contains("things"));
    EXPECT_TRUE(through_header(header.scenario).standing.empty());
    header.scenario.rolling.assign(header.scenario.grid.size(), 0.f);  // under which no earth is moved
    Scenario::Standing& standing = header.scenario.standing;
    standing.earth_budget = 1.0 / 3;
    EXPECT_EQ(through_header(header.scenario).standing, standing);
    standing.water.assign(header.scenario.grid.size(), 0.f);
    standing.water[7] = 1, standing.water[8] = 12345 * sim::kWaterQuantum;
    EXPECT_EQ(through_header(header.scenario).standing, standing);
    standing.forest.resize(header.scenario.grid.size());
    standing.forest[7] = {2000, 1, 60, 35};
    standing.forest[8] = {257, 0, 10, 5};
    sim::Command plant;
    plant.kind = sim::CommandKind::kPlant;
    plant.x = 12.6 + 1.0 / 3, plant.y = -0.0;
    plant.stems = 400.1, plant.diameter = 0.3, plant.height = 22;
    plant.least_slope = 30.1, plant.most_slope = 1e-7 + 45;
    sim::Command sculpt;
    sculpt.kind = sim::CommandKind::kSculpt;
    sculpt.x = 9, sculpt.y = 9, sculpt.rise = -0.7;
    sculpt.profile = sim::Profile::kCone;
    standing.placed = {plant, sculpt};
    EXPECT_EQ(through_header(header.scenario).standing, standing);
}

TEST(RecordingHeader, keeps_the_wind_and_refuses_an_impossible_one) {
    Header header;
    header.scenario = small_scenario();
    EXPECT_FALSE(to_json(header)["view"].contains("wind"));
    EXPECT_EQ(through_header(header.scenario).wind, render::Wind());
    header.scenario.wind = {.from_deg = -123.25, .speed = 7.1};
    EXPECT_EQ(through_header(header.scenario).wind, header.scenario.wind);
    expect_refused(
        to_json(header), "wind",
        {{"speed", 1000}, {"speed", -1}, {"speed", "strong"}, {"from_deg", 361}, {"from_deg", nullptr}});
}

TEST(RecordingHeader, keeps_where_trees_may_grow_and_refuses_impossible_places) {
    Header header;
    header.scenario = small_scenario();
    render::TreeRules& trees = header.scenario.trees;
    trees.density = 100;
    trees.polygon = {{0.5, 1}, {20, 1.25}, {10, 30}};
    trees.shares.resize(header.scenario.grid.size());
    for (std::size_t i = 0; i < trees.shares.size(); ++i) trees.shares[i] = static_cast<std::uint8_t>(7 * i);
    EXPECT_EQ(through_header(header.scenario).trees, trees);
    const Json far_corner = {1, 1e8};
    const Json corner = {1, 2};
    expect_refused(to_json(header), "trees",
                   {{"polygon", "round"},
                    {"polygon", Json::array({corner, corner})},
                    {"polygon", Json::array({corner, corner, 3})},
                    {"polygon", Json::array({corner, corner, far_corner})},
                    {"polygon", Json(std::vector<Json>(257, corner))},
                    {"shares", 1},
                    {"shares", "AAAA"}});
    header.scenario.trees.shares.push_back(0);
    EXPECT_FALSE(header_from(to_json(header))) << "one share more than there are vertices";
}

TEST(RecordingHeader, keeps_the_density_of_each_material_or_that_it_is_unknown) {
    Header header;
    header.scenario = small_scenario();
    header.scenario.lower = Scenario::Lower{
        "soil", header.scenario.params, std::vector<float>(header.scenario.depth.size()), {}, {}, {}};
    const Header unknown = header_from(to_json(header)).value();
    EXPECT_FALSE(unknown.scenario.density);
    EXPECT_FALSE(unknown.scenario.lower->density);
    header.scenario.density = 212.5;
    header.scenario.lower->density = 1800;
    const Header known = header_from(to_json(header)).value();
    EXPECT_EQ(known.scenario.density, 212.5);
    EXPECT_EQ(known.scenario.lower->density, 1800);
    for (const Json& never : {Json(0), Json(-200), Json(3001), Json("heavy")}) {
        Json json = to_json(header);
        json["density"] = never;
        EXPECT_FALSE(header_from(json)) << never;
    }
}

TEST(RecordingHeader, keeps_the_place_on_earth) {
    Scenario scenario = small_scenario();
    const auto here = scenario.georeference.to_lat_lon({7, 9}).value();
    const auto there = through_header(scenario).georeference.to_lat_lon({7, 9}).value();
    EXPECT_NEAR(there.latitude, here.latitude, 1e-9);
    EXPECT_NEAR(there.longitude, here.longitude, 1e-9);
    scenario.georeference = terrains::Georeference::unnamed(1000.5, -2000.25);
    const auto unnamed = through_header(scenario).georeference;
    EXPECT_EQ(unnamed.placed(), scenario.georeference.placed());
    EXPECT_EQ(unnamed.origin_x(), 1000.5);
    EXPECT_EQ(unnamed.origin_y(), -2000.25);
    scenario.georeference = {};
    EXPECT_FALSE(through_header(scenario).georeference.has_coordinates());
}

TEST(RecordingHeader, keeps_every_parameter_bit_identical) {
    for (const sim::ParamInfo& info : sim::kParams) {
        Scenario scenario = small_scenario();
        const float usual = scenario.params.*info.value;
        // Neighbouring floats, which only the shortest exact decimal distinguishes.
        for (const float value : {std::nextafter(usual, 1e9f), std::nextafter(usual, -1e9f)}) {
            scenario.params.*info.value = value;
            if (sim::fault_of(scenario.params)) continue;
            const float after = through_header(scenario).params.*info.value;
            EXPECT_EQ(std::bit_cast<std::uint32_t>(after), std::bit_cast<std::uint32_t>(value)) << info.name;
        }
    }
}

TEST(RecordingHeader, keeps_every_model_scheme_and_border) {
    Scenario scenario = small_scenario();
    for (const auto model : sim::kEveryModel)
        for (const auto scheme :
             {sim::Scheme::kLaxFriedrichs, sim::Scheme::kLocalLaxFriedrichs, sim::Scheme::kMuscl})
            for (const auto border : {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink}) {
                scenario.params.model = model;
                scenario.params.scheme = scheme;
                scenario.params.borders[sim::kNorth] = border;
                EXPECT_EQ(through_header(scenario).params, scenario.params);
            }
    for (const auto law : {sim::Law::kConstant, sim::Law::kSlope, sim::Law::kShear}) {
        scenario.params.law = law;
        EXPECT_EQ(through_header(scenario).params, scenario.params);
    }
}

const std::size_t kAnyParam = sim::param_from("start_depth").value();

template <class Value>
Json through_line(const Value& value) {
    std::string line;
    write(value, line);
    return Json::parse(line);
}

// A valid command of a kind: each number is as near to 0 as it may be.
sim::Command least_of(const sim::CommandInfo& info) {
    sim::Command command;
    command.kind = info.kind;
    for (const sim::CommandNumber& number : info.numbers)
        command.*number.value = std::clamp(command.*number.value, number.least, number.most);
    if (info.has_param) command.param = kAnyParam;
    return command;
}

TEST(RecordingLine, keeps_every_number_of_every_command_bit_identical) {
    constexpr std::array kAwkward{
        0.1,  1.0 / 3,           1e7,         -1e7,  5e-324, 2.2250738585072014e-308,
        -0.0, 99999.99999999999, 1 + 2.3e-16, 100.0, 0.3,    7e-7};
    for (const sim::CommandInfo& info : sim::kCommands)
        for (const sim::CommandNumber& number : info.numbers)
            for (const double value : kAwkward) {
                if (value < number.least || value > number.most) continue;
                TimedCommand before{123456789012, least_of(info)};
                before.command.*number.value = value;
                if (sim::fault_of(before.command)) continue;  // a parameter's own range is narrower
                const auto line = line_from(through_line(before));
                ASSERT_TRUE(line) << line.error();
                const auto& after = std::get<TimedCommand>(*line);
                EXPECT_EQ(after.tick, before.tick);
                EXPECT_EQ(after.command, before.command);
                EXPECT_EQ(std::bit_cast<std::uint64_t>(after.command.*number.value),
                          std::bit_cast<std::uint64_t>(value))
                    << info.name << " " << number.name;
            }
}

// The state hash covers these members; if a line dropped one, the replay would have another state.
TEST(RecordingLine, keeps_every_member_of_any_valid_command) {
    constexpr double sim::Command::*kMembers[] = {
        &sim::Command::x,        &sim::Command::y,     &sim::Command::radius, &sim::Command::rate,
        &sim::Command::duration, &sim::Command::depth, &sim::Command::value,  &sim::Command::to_x,
        &sim::Command::to_y,     &sim::Command::rise,  &sim::Command::level,  &sim::Command::turn};
    std::mt19937 random(7);
    const auto maybe = [&](auto usual, auto other) { return random() % 4 == 0 ? other : usual; };
    int taken = 0;
    for (int i = 0; i < 24'000; ++i) {
        const sim::Command usual;
        TimedCommand before{i, usual};
        sim::Command& c = before.command;
        c.kind = sim::kCommands[random() % std::size(sim::kCommands)].kind;
        for (const auto member : kMembers) c.*member = maybe(usual.*member, maybe(0.5, -0.0));
        c.layer = maybe(usual.layer, sim::Layer::kStanding);
        c.profile = maybe(usual.profile, sim::Profile::kCone);
        c.of = maybe(usual.of, sim::Part::kLower);
        c.param = maybe(usual.param, kAnyParam);
        for (const sim::CommandNumber& number : sim::info_of(c.kind).numbers)
            if (number.least > 0) c.*number.value = number.least;
        c.least_slope = maybe(usual.least_slope, 20.5);
        if (sim::fault_of(c)) continue;
        ++taken;
        const auto line = line_from(through_line(before));
        ASSERT_TRUE(line) << line.error();
        const sim::Command& after = std::get<TimedCommand>(*line).command;
        EXPECT_EQ(after, c);
        for (const auto member : kMembers) EXPECT_EQ(std::signbit(after.*member), std::signbit(c.*member));
    }
    EXPECT_GE(taken, 600);
}

TEST(RecordingLine, keeps_layer_profile_and_material) {
    TimedCommand pour;
    for (const auto layer : {sim::Layer::kRolling, sim::Layer::kStanding})
        for (const auto profile : {sim::Profile::kDisc, sim::Profile::kCone})
            for (const auto part : {sim::Part::kUpper, sim::Part::kLower}) {
                pour.command.layer = layer;
                pour.command.profile = profile;
                pour.command.of = part;
                EXPECT_EQ(std::get<TimedCommand>(line_from(through_line(pour)).value()).command,
                          pour.command);
            }
}

TEST(RecordingLine, has_a_slope_only_if_a_command_chooses_one) {
    TimedCommand dig;
    dig.command.kind = sim::CommandKind::kDig;
    EXPECT_FALSE(through_line(dig)["dig"].contains("slope"));
    dig.command.least_slope = 30, dig.command.most_slope = 44.9;
    EXPECT_EQ(through_line(dig)["dig"]["slope"], (Json{30, 44.9}));
    EXPECT_EQ(std::get<TimedCommand>(line_from(through_line(dig)).value()).command, dig.command);
    for (const Json& wrong : {Json{30, 30}, Json{31, 30}, Json{-1, 30}, Json{30, 90.1}, Json{30},
                              Json{30, "x"}, Json(30), Json{10, 20, 30}, Json(nullptr)}) {
        Json line = through_line(dig);
        line["dig"]["slope"] = wrong;
        const auto refused = line_from(line);
        ASSERT_FALSE(refused) << wrong;
        EXPECT_NE(refused.error().find("slope"), std::string::npos) << refused.error();
    }
}

TEST(RecordingLine, keeps_every_parameter_that_can_be_set_and_refuses_fixed_ones_and_values_out_of_range) {
    for (std::size_t i = 0; i < std::size(sim::kParams); ++i) {
        TimedCommand set;
        set.command.kind = sim::CommandKind::kSet;
        set.command.param = i;
        set.command.value = static_cast<double>(sim::kParams[i].most);
        const auto line = line_from(through_line(set));
        ASSERT_EQ(line.has_value(), !sim::kParams[i].fixed) << sim::kParams[i].name;
        if (!line) continue;
        EXPECT_EQ(std::get<TimedCommand>(*line).command, set.command);
        // The minimum is a float without a short decimal; a value that a user writes for it must work.
        TimedCommand least = set;
        least.command.value = shortest(sim::kParams[i].least);
        EXPECT_TRUE(line_from(through_line(least))) << sim::kParams[i].name;
        set.command.value *= 1.001;
        EXPECT_FALSE(line_from(through_line(set))) << sim::kParams[i].name;
    }
}

TEST(RecordingLine, refuses_each_command_number_just_outside_its_range) {
    for (const sim::CommandInfo& info : sim::kCommands)
        for (const sim::CommandNumber& number : info.numbers)
            for (const double value :
                 {std::nextafter(number.least, -1e300), std::nextafter(number.most, 1e300)}) {
                TimedCommand command{0, least_of(info)};
                command.command.*number.value = value;
                const auto line = line_from(through_line(command));
                ASSERT_FALSE(line) << info.name << " " << number.name << " " << value;
                EXPECT_NE(line.error().find(number.name), std::string::npos) << line.error();
            }
}

TEST(RecordingLine, keeps_hash_and_mass_of_a_state) {
    const StateLine before{77,
                           0x00fedcba98765432u,
                           {1, 0xffffffffffffffffu},
                           {0, 9007199254740993, 1, 1152921504606846975, 5, -6}};
    EXPECT_EQ(std::get<StateLine>(line_from(through_line(before)).value()), before);
    StateLine alone = before;
    alone.before.clear();
    EXPECT_EQ(std::get<StateLine>(line_from(through_line(alone)).value()), alone);
    EXPECT_EQ(std::get<EndLine>(line_from(through_line(EndLine{42})).value()).tick, 42);
}

std::string closed(Chain& chain, std::string line) {
    chain.close(line);
    return line;
}

TEST(Chain, is_xxh3_of_each_line_seeded_with_the_one_before) {
    Chain ours;
    const std::string first = closed(ours, R"({"a":1})"), second = closed(ours, R"({"b":2})");
    EXPECT_EQ(chained({"{\"a\":1", "{\"b\":2"}), first + "\n" + second + "\n");
}

TEST(Chain, refuses_lines_that_changed_places) {
    Chain writer, reader;
    const std::string first = closed(writer, R"({"a":1})"), second = closed(writer, R"({"b":2})");
    EXPECT_FALSE(reader.read(second));
    EXPECT_TRUE(reader.read(first));
    EXPECT_FALSE(reader.read(first));
    EXPECT_TRUE(reader.read(second));
}

TEST(Hex, reads_back_only_what_it_writes) {
    EXPECT_EQ(hex(0x0123456789abcdefu), "0123456789abcdef");
    EXPECT_EQ(from_hex("0123456789abcdef"), 0x0123456789abcdefu);
    for (const char* wrong :
         {"", "123", "0123456789abcdeg", "0123456789abcdef0", "-123456789abcdef", "0x23456789abcdef"})
        EXPECT_FALSE(from_hex(wrong)) << wrong;
}

}  // namespace
}  // namespace game::test
