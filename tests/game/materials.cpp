#include "game/material.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/assets.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

TEST(ShippedMaterials, load_for_the_models_they_have_numbers_for_and_for_no_other) {
    const auto names = asset_names(AssetKind::kMaterial).value();
    ASSERT_GE(names.size(), 3u);
    int loaded = 0, refused = 0;
    for (const std::string& name : names) {
        const std::string text = read_bytes(find_asset(AssetKind::kMaterial, name).value());
        for (const sim::Model model : {sim::Model::kBcre, sim::Model::kBcreInertial}) {
            const std::string block = fmt::format("[{}]", sim::to_string(model));
            const auto material = load_material(name, model);
            if (text.find("\n" + block) != std::string::npos) {
                ASSERT_TRUE(material) << material.error().sentence;
                EXPECT_EQ(material->params.model, model);
                EXPECT_EQ(material->name, name);
                EXPECT_FALSE(material->title.empty());
                ++loaded;
            } else {
                ASSERT_FALSE(material) << name;
                EXPECT_EQ(material.error().status, Failure::kUnusable);
                EXPECT_NE(material.error().sentence.find(name + ".toml: has no " + block), std::string::npos)
                    << material.error().sentence;
                ++refused;
            }
        }
    }
    EXPECT_GT(loaded, 0);
    EXPECT_GT(refused, 0);
}

TEST(Material, takes_angles_as_slopes_and_paint_as_light) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_bytes(path, "[look]\nstanding = [255, 0, 188]\n[bcre]\nstop_angle = 25\nstart_slope = 0.8125\n");
    const auto material = load_material(path.string(), sim::Model::kBcre);
    ASSERT_TRUE(material) << material.error().sentence;
    EXPECT_FLOAT_EQ(material->params.stop_slope, 0.46630766f);  // tan 25°
    EXPECT_EQ(material->params.start_slope, 0.8125f);
    EXPECT_FLOAT_EQ(material->look.standing.x, 1);
    EXPECT_FLOAT_EQ(material->look.standing.y, 0);
    EXPECT_NEAR(material->look.standing.z, 0.5028865, 1e-6);  // sRGB 188
    EXPECT_EQ(material->title, "mine");
}

TEST(Material, with_a_fault_is_refused_with_file_line_and_key) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    const std::pair<const char*, const char*> faults[] = {
        {"[bcre]\nviscosity = 3\n", ":2: bcre.viscosity"},
        {"[bcre]\ndeposit_speed = 3\n", ":2: bcre.deposit_speed"},  // of the other model
        {"[bcre]\nrolling_speed = -1\n", ":2: bcre.rolling_speed"},
        {"[bcre]\n[bcre-inertial]\nmax_speed = -1\n", ":3: bcre-inertial.max_speed"},
        {"[bcre]\nstop_angle = \"steep\"\n", ":2: bcre.stop_angle"},
        {"[look]\nstanding = [1, 2, 256]\n[bcre]\n", ":2: look.standing"},
        {"[look]\nstanding = [1, 2]\n[bcre]\n", ":2: look.standing"},
        {"[look]\nsparkle = 1\n[bcre]\n", ":2: look.sparkle"},
        {"[look]\nroughness = 2\n[bcre]\n", ":2: look.roughness"},
        {"price = 1\n[bcre]\n", ":1: price"},
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
