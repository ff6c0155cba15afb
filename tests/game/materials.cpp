#include "game/scene/material.h"

#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/base/number.h"
#include "game/files/assets.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

constexpr sim::Model kModels[] = {sim::Model::kBcre, sim::Model::kBcreInertial};

TEST(ShippedMaterials, have_parameters_for_either_model) {
    const auto names = asset_names(AssetKind::kMaterial).value();
    ASSERT_GE(names.size(), 5u);
    for (const std::string& name : names)
        for (const sim::Model model : kModels) {
            const auto material = load_material(name, model);
            ASSERT_TRUE(material) << material.error().sentence;
            EXPECT_EQ(material->params.model, model);
            EXPECT_EQ(material->name, name);
            EXPECT_FALSE(material->title.empty());
        }
}

// The unit of a parameter in a material file, where a slope is given as an angle.
std::string unit_of(std::string key) {
    if (const auto at = key.find("_angle"); at != std::string::npos) return "deg";
    if (key == "cohesion") return "Pa";
    if (key == "below") return "m3";
    for (const sim::ParamInfo& info : sim::kParams)
        if (info.name == key) return std::string(info.unit);
    return "unknown";
}

TEST(ShippedMaterials, state_unit_range_and_source_of_each_parameter) {
    const std::regex number(R"((\w+) = ([0-9.]+) +# ([^;]+); ([0-9.]+) to ([0-9.]+); (.+))");
    const auto names = asset_names(AssetKind::kMaterial).value();
    for (const std::string& name : names) {
        std::istringstream lines(read_bytes(find_asset(AssetKind::kMaterial, name).value()));
        int told = 0;
        bool physics = false, has_density = false;
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("density")) {
                EXPECT_TRUE(std::regex_match(line, number)) << name << ": " << line;
                has_density = true;
            }
            if (line.starts_with("["))
                physics = line.starts_with("[bcre") || line.starts_with("[voellmy") || line == "[[size]]";
            if (!physics || line.empty() || line.starts_with("[") || line.starts_with("name")) continue;
            std::smatch part;
            ASSERT_TRUE(std::regex_match(line, part, number)) << name << ": " << line;
            EXPECT_EQ(part[3], unit_of(part[1])) << name << ": " << line;
            const auto told_as = [&](std::size_t i) { return number_from<double>(part[i].str()); };
            const auto value = told_as(2), least = told_as(4), most = told_as(5);
            ASSERT_TRUE(value && least && most) << name << ": " << line;
            EXPECT_GE(*value, *least) << name << ": " << line;
            EXPECT_LE(*value, *most) << name << ": " << line;
            ++told;
        }
        EXPECT_GE(told, 20) << name;
        EXPECT_TRUE(has_density) << name;
    }
}

TEST(ShippedMaterials, support_voellmy_with_the_friction_of_bcre_inertial) {
    const auto names = asset_names(AssetKind::kMaterial).value();
    for (const std::string& name : names) {
        const auto material = load_material(name, sim::Model::kVoellmy);
        ASSERT_TRUE(material) << material.error().sentence;
        const auto exchanging = load_material(name, sim::Model::kBcreInertial);
        ASSERT_TRUE(exchanging) << exchanging.error().sentence;
        EXPECT_EQ(material->params.friction, exchanging->params.friction) << name;
        EXPECT_EQ(material->params.drag, exchanging->params.drag) << name;
    }
}

TEST(Material, without_a_block_for_a_model_is_refused_with_it) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_bytes(path, "[bcre]\nstop_angle = 25\n");
    EXPECT_TRUE(load_material(path.string(), sim::Model::kBcre));
    const auto material = load_material(path.string(), sim::Model::kBcreInertial);
    ASSERT_FALSE(material);
    EXPECT_EQ(material.error().status, Failure::kUnusable);
    EXPECT_NE(material.error().sentence.find("mine.toml: has no [bcre-inertial]"), std::string::npos)
        << material.error().sentence;
}

TEST(Material, converts_angles_to_slopes_and_srgb_to_linear_light) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_bytes(path,
                "[look]\nstanding = [255, 0, 188]\nturf = [188, 255, 0]\n[bcre]\nstop_angle = "
                "25\nstart_slope = 0.8125\n");
    const auto material = load_material(path.string(), sim::Model::kBcre);
    ASSERT_TRUE(material) << material.error().sentence;
    EXPECT_FLOAT_EQ(material->params.stop_slope, 0.46630766f);  // tan 25°
    EXPECT_EQ(material->params.start_slope, 0.8125f);
    EXPECT_FLOAT_EQ(material->look.standing.x, 1);
    EXPECT_FLOAT_EQ(material->look.standing.y, 0);
    EXPECT_NEAR(material->look.standing.z, 0.5028865, 1e-6);  // sRGB 188
    ASSERT_TRUE(material->look.turf);
    EXPECT_NEAR(material->look.turf->x, 0.5028865, 1e-6);
    EXPECT_EQ(material->look.powder.strength, 0);
    EXPECT_EQ(material->title, "mine");
    EXPECT_FALSE(material->density);
    write_bytes(path, "density = 312.5\n[bcre]\n");
    EXPECT_EQ(load_material(path.string(), sim::Model::kBcre).value().density, 312.5);
}

TEST(Material, converts_cohesion_to_the_thickness_that_weighs_as_much) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_bytes(path, "density = 200\n[voellmy]\ncohesion = 98.1\n");
    const auto material = load_material(path.string(), sim::Model::kVoellmy);
    ASSERT_TRUE(material) << material.error().sentence;
    EXPECT_FLOAT_EQ(material->params.cohesion_depth, 0.05f);  // N0/(rho g)
}

constexpr const char* kThreeSizes = R"(density = 200
[voellmy]
friction = 0.17
drag = 1208
[[size]]
name = "small"
below = 25000
friction = 0.22
cohesion = 98.1
[[size]]
name = "medium"
below = 60000
[[size]]
name = "large"
friction = 0.155
)";

TEST(Material, has_the_friction_of_the_class_of_a_volume) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_bytes(path, kThreeSizes);
    const auto material = load_material(path.string(), sim::Model::kVoellmy);
    ASSERT_TRUE(material) << material.error().sentence;
    const auto named = [&](double volume) { return size_of(*material, volume)->name; };
    EXPECT_EQ(named(0), "small");
    EXPECT_EQ(named(24'999.9), "small");
    EXPECT_EQ(named(25'000), "medium");
    EXPECT_EQ(named(60'000), "large");
    EXPECT_EQ(named(1e12), "large");
    EXPECT_EQ(size_of(*material, 1)->params.friction, 0.22f);
    EXPECT_FLOAT_EQ(size_of(*material, 1)->params.cohesion_depth, 0.05f);
    EXPECT_EQ(size_of(*material, 1)->params.drag, 1208) << "as the material";
    EXPECT_EQ(size_of(*material, 3e4)->params, material->params);
    write_bytes(path, kThreeSizes + std::string("[bcre]\n"));
    EXPECT_FALSE(size_of(load_material(path.string(), sim::Model::kBcre).value(), 1)) << "it has no friction";
    write_bytes(path, "[voellmy]\n");
    EXPECT_FALSE(size_of(load_material(path.string(), sim::Model::kVoellmy).value(), 1));
}

TEST(Material, with_a_fault_is_refused_with_file_line_and_key) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    const std::pair<const char*, const char*> faults[] = {
        {"[bcre]\nviscosity = 3\n", ":2: bcre.viscosity"},
        {"[bcre]\ndeposit_speed = 3\n", ":2: bcre.deposit_speed"},  // of the other model
        {"[bcre]\nrolling_speed = -1\n", ":2: bcre.rolling_speed"},
        {"[bcre]\n[bcre-inertial]\nrelaxation_time = 2\n", ":3: bcre-inertial.relaxation_time"},
        {"[bcre]\n[bcre-inertial]\nfriction = -1\n", ":3: bcre-inertial.friction"},
        {"[bcre]\nstop_angle = \"steep\"\n", ":2: bcre.stop_angle"},
        {"density = 200\n[bcre]\n[voellmy]\ncohesion = -50\n", ":4: voellmy.cohesion"},
        {"[bcre]\n[voellmy]\ncohesion = 50\n", ":3: voellmy.cohesion needs the density"},
        {"[bcre]\n[voellmy]\ndrag_exponent = 3\n", ":3: voellmy.drag_exponent"},
        {"[bcre]\n[[size]]\nname = \"small\"\nbelow = 100\n", ":4: size.below leaves a gap: from 100 m3 on"},
        {"[bcre]\n[[size]]\nname = \"a\"\n[[size]]\nname = \"b\"\n", ":4: size overlaps with 'a'"},
        {"[bcre]\n[[size]]\nname = \"a\"\nbelow = 9\n[[size]]\nname = \"b\"\nbelow = 9\n",
         ":7: size.below is 9, so the class overlaps with 'a', below 9"},
        {"[bcre]\n[[size]]\nname = \"a\"\nbelow = 9\n[[size]]\nname = \"a\"\n", ":6: size.name"},
        {"[bcre]\n[[size]]\nbelow = 9\n", ":2: size.name"},
        {"[bcre]\n[[size]]\nname = \"a\"\nerosion_rate = 1\n", ":4: size.erosion_rate"},
        {"[bcre]\n[voellmy]\ndrag_exponent = 0.3\n", ":3: voellmy.drag_exponent is no multiple of 0.125"},
        {"[look]\nstanding = [1, 2, 256]\n[bcre]\n", ":2: look.standing"},
        {"[look]\nstanding = [1, 2]\n[bcre]\n", ":2: look.standing"},
        {"[look]\nsparkle = 1\n[bcre]\n", ":2: look.sparkle"},
        {"[look]\ntexture = \"wood\"\n[bcre]\n", ":2: look.texture"},
        {"[look]\nroughness = 2\n[bcre]\n", ":2: look.roughness"},
        {"[look]\npowder = 1.5\n[bcre]\n", ":2: look.powder"},
        {"[look]\npowder_speed = 0\n[bcre]\n", ":2: look.powder_speed"},
        {"price = 1\n[bcre]\n", ":1: price"},
        {"density = 0\n[bcre]\n", ":1: density"},
        {"density = -200\n[bcre]\n", ":1: density"},
        {"density = 3001\n[bcre]\n", ":1: density"},
        {"density = \"heavy\"\n[bcre]\n", ":1: density"},
        {"[bcre]\nstop_angle = 40\nstart_angle = 30\n", ": start_slope is below stop_slope"},
        {"bcre = 3\n", ":1: bcre is not a table"},
    };
    for (const auto& [text, expected] : faults) {
        write_bytes(path, text);
        const auto material = load_material(path.string(), sim::Model::kBcre);
        ASSERT_FALSE(material) << text;
        EXPECT_EQ(material.error().status, Failure::kUnusable);
        EXPECT_EQ(material.error().sentence.rfind(path.string() + expected, 0), 0u)
            << material.error().sentence;
    }
}

}  // namespace
}  // namespace game::test
