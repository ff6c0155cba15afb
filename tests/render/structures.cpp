#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/buildings/structure_mesh.h"
#include "tests/render/world.h"

// Meshes of structures; without GL.
namespace render::test {
namespace {

const glm::vec3 kSun = glm::normalize(glm::vec3(1, 0, 1));

class MeshOfStructures : public testing::Test {
  protected:
    StructureMesh mesh(const Structures& structures, float snow = 0, glm::vec2 snowy = {1, 1}) const {
        const std::vector<float> depth(world_.grid.size(), snow);
        const std::vector<glm::vec2> cover(world_.grid.size(), {snow, 0});
        return structure_mesh(structures, {world_.view(), depth, cover, snowy}, kSun);
    }
    static constexpr double kLength = 11, kWidth = 9, kHeight = 7.5;
    static Structures cabin(StructureState state, double heading = 0) {
        Structures structures;
        structures.all.push_back({StructureKind::kHouse,
                                  {100, 100},
                                  heading,
                                  state,
                                  kLength,
                                  kWidth,
                                  kHeight,
                                  HouseMaterial::kWood});
        return structures;
    }
    static std::size_t made_of(const StructureMesh& mesh, int material) {
        return static_cast<std::size_t>(std::ranges::count_if(mesh.faces, [&](const StructureVertex& vertex) {
            return static_cast<int>(vertex.at.w) == material;
        }));
    }

    World world_ = make_world(40, 5, [](double x, double) { return 0.2 * x; });
};

TEST_F(MeshOfStructures, is_equal_for_equal_arguments) {
    for (const auto state : {StructureState::kIntact, StructureState::kDamaged, StructureState::kDestroyed}) {
        const StructureMesh first = mesh(cabin(state), 1), second = mesh(cabin(state), 1);
        ASSERT_EQ(first.faces.size(), second.faces.size());
        EXPECT_EQ(
            std::memcmp(first.faces.data(), second.faces.data(), first.faces.size() * sizeof first.faces[0]),
            0);
    }
}

TEST_F(MeshOfStructures, stays_within_its_size_and_stands_on_the_ground) {
    for (const double heading : {0.0, 33.0, 90.0, 211.0})
        for (const StructureVertex& vertex : mesh(cabin(StructureState::kIntact, heading), 1.5f).faces) {
            const glm::vec3 from = glm::vec3(vertex.at) - glm::vec3(100, 100, 20);
            EXPECT_LT(glm::length(glm::vec2(from)), 10);
            EXPECT_LT(from.z, kHeight + 2) << "with snow on its roof";
        }
    const StructureMesh stands = mesh(cabin(StructureState::kIntact));
    const auto lowest =
        std::ranges::min(stands.faces, {}, [](const auto& vertex) { return vertex.at.z; }).at.z;
    EXPECT_LT(lowest, 20 - 0.2 * kLength) << "no corner hangs over the slope";
}

TEST_F(MeshOfStructures, has_faces_that_look_outward) {
    // Of a closed body with its faces outward the volume is positive: that of walls and roof is about 11 × 9 × 6 m.
    const StructureMesh whole = mesh(cabin(StructureState::kIntact));
    double volume = 0;
    for (std::size_t i = 0; i < whole.faces.size(); i += 3) {
        const auto at = [&](std::size_t k) {
            return glm::dvec3(whole.faces[i + k].at) - glm::dvec3(100, 100, 20);
        };
        volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
        EXPECT_GT(glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), glm::dvec3(whole.faces[i].normal)), 0);
    }
    EXPECT_GT(volume, 400);
}

TEST_F(MeshOfStructures, has_snow_on_its_roof_only_where_snow_lies) {
    EXPECT_GT(made_of(mesh(cabin(StructureState::kIntact), 1), BUILT_SNOW), 0u);
    EXPECT_EQ(made_of(mesh(cabin(StructureState::kIntact), 0), BUILT_SNOW), 0u);
    EXPECT_EQ(made_of(mesh(cabin(StructureState::kIntact), 1, {0, 1}), BUILT_SNOW), 0u)
        << "the upper material is soil";
}

TEST_F(MeshOfStructures, loses_its_windows_its_roof_and_its_shadow) {
    const StructureMesh whole = mesh(cabin(StructureState::kIntact)),
                        damaged = mesh(cabin(StructureState::kDamaged)),
                        destroyed = mesh(cabin(StructureState::kDestroyed));
    EXPECT_GT(made_of(whole, BUILT_WINDOW), 0u);
    EXPECT_EQ(made_of(damaged, BUILT_WINDOW), 0u);
    EXPECT_FALSE(damaged.shadows.empty());
    EXPECT_TRUE(destroyed.shadows.empty());
    const auto rests = [](const StructureVertex& vertex) { return vertex.rests.w == 1; };
    EXPECT_TRUE(std::ranges::none_of(whole.faces, rests));
    EXPECT_TRUE(std::ranges::any_of(destroyed.faces, rests)) << "debris lies on the deposit";
    EXPECT_TRUE(mesh(cabin(StructureState::kBuried)).faces.empty());
}

TEST_F(MeshOfStructures, casts_its_shadow_away_from_the_sun) {
    float farthest = 0;
    for (const StructureShadowVertex& vertex : mesh(cabin(StructureState::kIntact)).shadows) {
        EXPECT_GT(vertex.at.x, 100 - kLength - 2 * kHeight);
        EXPECT_NEAR(vertex.at.z, 0.2 * vertex.at.x, 0.01) << "on the ground";
        farthest = std::max(farthest, 100 - vertex.at.x);
    }
    EXPECT_GT(farthest, kWidth / 2 + 3) << "the sun is in the east";
}

TEST_F(MeshOfStructures, lights_the_ground_around_a_house_that_stands_less_with_distance) {
    const auto lights = [&](StructureState state) {
        std::vector<std::pair<float, float>> found;  // distance from the middle, strength
        for (const StructureShadowVertex& vertex : mesh(cabin(state)).shadows)
            if (vertex.foot.w > 0)
                found.emplace_back(glm::distance(glm::vec2(vertex.at), {100, 100}), vertex.at.w);
        return found;
    };
    const auto intact = lights(StructureState::kIntact);
    ASSERT_FALSE(intact.empty());
    for (const auto& [distance, strength] : intact) {
        if (distance < 7) {
            EXPECT_GT(strength, 0.5);
        }
        if (distance > 15) {
            EXPECT_EQ(strength, 0);
        }
        EXPECT_LT(distance, 20);
    }
    EXPECT_TRUE(lights(StructureState::kDamaged).empty());
    EXPECT_TRUE(lights(StructureState::kDestroyed).empty());
}

TEST_F(MeshOfStructures, is_joined_by_roads_that_follow_the_ground_and_by_ropes_between_heads) {
    Structures structures;
    structures.roads.push_back({{{10, 50}, {100, 60}, {190, 20}}, 6});
    structures.all = {{StructureKind::kStation, {20, 150}, 90},
                      {StructureKind::kPylon, {100, 150}, 90},
                      {StructureKind::kStation, {180, 150}, 90}};
    structures.lifts.push_back({0, 3});
    const StructureMesh all = mesh(structures);
    for (const StructureVertex& vertex : all.faces) {
        if (static_cast<int>(vertex.at.w) == BUILT_ROAD) {
            EXPECT_NEAR(vertex.at.z, 0.2f * vertex.at.x, 0.9f);
        }
    }
    ASSERT_FALSE(all.ropes.empty());
    const auto [first, last] =
        std::ranges::minmax(all.ropes, {}, [](const RopeVertex& vertex) { return vertex.at.x; });
    EXPECT_NEAR(first.at.x, 20, 0.1);
    EXPECT_NEAR(last.at.x, 180, 0.1);

    structures.all[1].state = StructureState::kDestroyed;
    const StructureMesh broken = mesh(structures);
    EXPECT_LT(broken.ropes.size(), all.ropes.size()) << "the chairs have fallen";
}

TEST_F(MeshOfStructures, has_parts_that_lie_in_their_balls_and_hold_each_face_once) {
    Structures structures = cabin(StructureState::kDamaged);
    structures.roads.push_back({{{10, 50}, {100, 60}, {190, 20}}, 6});
    const StructureMesh mesh = this->mesh(structures, 1);
    std::vector<int> times(mesh.faces.size());
    for (const StructurePart& part : mesh.parts) {
        EXPECT_LT(part.far.count, part.near.count);
        const bool same = part.far.first == part.near.first;  // a beginning of what is near, or apart from it
        for (std::uint32_t i = part.near.first; i < part.near.first + part.near.count; ++i) ++times[i];
        for (std::uint32_t i = part.far.first; i < part.far.first + part.far.count && !same; ++i) ++times[i];
        for (std::uint32_t i = part.near.first; i < part.near.first + part.near.count; ++i)
            EXPECT_LE(glm::distance(part.middle, glm::vec3(mesh.faces[i].at)), part.radius + 0.01f);
    }
    EXPECT_EQ(std::ranges::count(times, 1), std::ssize(times));
}

TEST_F(MeshOfStructures, has_a_bounded_number_of_faces_for_a_road_of_any_length) {
    Structures structures;
    structures.roads.push_back({{{0, 0}, {1e7, 0}}});
    EXPECT_LT(mesh(structures).faces.size(), 100'000u);
}

constexpr HouseMaterial kMaterials[] = {HouseMaterial::kGlass, HouseMaterial::kWood, HouseMaterial::kBrick,
                                        HouseMaterial::kConcrete};

class MeshOfHouse : public MeshOfStructures {
  protected:
    static Structures house(HouseMaterial material, StructureState state, glm::dvec3 size = {14, 10, 9}) {
        Structures structures;
        structures.all.push_back(
            {StructureKind::kHouse, {100, 100}, 40, state, size.x, size.y, size.z, material});
        return structures;
    }
    // Size of the box around it in its own axes: across, along, and the heights of its lowest and highest corner.
    static glm::vec4 extent(const StructureMesh& mesh) {
        const float turn = glm::radians(40.f);
        const glm::vec2 front(std::sin(turn), std::cos(turn)), right(front.y, -front.x);
        glm::vec4 most(0, 0, 1e6f, -1e6f);
        for (const StructureVertex& vertex : mesh.faces) {
            const glm::vec2 from = glm::vec2(vertex.at) - glm::vec2(100);
            most.x = std::max(most.x, std::abs(glm::dot(from, right)));
            most.y = std::max(most.y, std::abs(glm::dot(from, front)));
            most.z = std::min(most.z, vertex.at.z), most.w = std::max(most.w, vertex.at.z);
        }
        return most;
    }
};

TEST_F(MeshOfHouse, has_the_size_that_was_asked_for) {
    for (const HouseMaterial material : kMaterials)
        for (const glm::dvec3 size : {glm::dvec3(3, 3, 2), {14, 10, 9}, {8, 30, 12}, {120, 40, 30}}) {
            const glm::vec4 most = extent(mesh(house(material, StructureState::kIntact, size)));
            EXPECT_NEAR(most.x, size.y / 2, 1.5) << size.x;
            EXPECT_NEAR(most.y, size.x / 2, 1.5) << size.x;
            // On a slope of 0.2 it stands as high above the ground uphill as is left of its height, and reaches down
            // to the lowest ground.
            const double rise = 0.2 * 0.5 * (size.x * std::sin(0.698) + size.y * std::cos(0.698));
            EXPECT_GT(most.w, 20 + rise + 0.5 * size.z) << size.x;
            EXPECT_LT(most.w, 20 + rise + size.z + 2.5) << size.x;
            EXPECT_LT(most.z, 20 - rise) << size.x;
        }
}

TEST_F(MeshOfHouse, shows_its_material_and_its_state) {
    const int walls[] = {BUILT_GLASS, BUILT_WOOD, BUILT_PLASTER, BUILT_CONCRETE};
    for (const HouseMaterial material : kMaterials) {
        const StructureMesh whole = mesh(house(material, StructureState::kIntact)),
                            damaged = mesh(house(material, StructureState::kDamaged)),
                            destroyed = mesh(house(material, StructureState::kDestroyed));
        EXPECT_GT(made_of(whole, walls[static_cast<std::size_t>(material)]), 0u);
        EXPECT_EQ(made_of(whole, BUILT_WINDOW) > 0, material != HouseMaterial::kGlass);
        EXPECT_EQ(made_of(damaged, BUILT_WINDOW), 0u);
        EXPECT_GT(made_of(damaged, BUILT_DARK), 0u);
        EXPECT_GT(extent(damaged).w, extent(destroyed).w + 2);
        EXPECT_TRUE(destroyed.shadows.empty());
        EXPECT_TRUE(mesh(house(material, StructureState::kBuried)).faces.empty());
    }
}

TEST_F(MeshOfHouse, stays_small_for_as_many_as_there_may_be) {
    Structures structures;
    for (int i = 0; i < 2000; ++i)
        structures.all.push_back({StructureKind::kHouse,
                                  {5 * (i % 40), 4 * (i / 40)},
                                  0,
                                  static_cast<StructureState>(i % 3),
                                  200,
                                  200,
                                  30,
                                  kMaterials[i % 4]});
    EXPECT_LT(mesh(structures).faces.size(), 2'000'000u);
}

TEST_F(MeshOfHouse, is_covered_by_its_shadow_in_pieces_that_follow_the_ground) {
    for (const StructureShadowVertex& vertex :
         mesh(house(HouseMaterial::kBrick, StructureState::kIntact)).shadows)
        EXPECT_NEAR(vertex.at.z, 0.2 * vertex.at.x, 0.01);
}

TEST_F(MeshOfHouse, of_nets_stands_leans_lies_and_vanishes) {
    float highest = 1e6f;
    for (const StructureState state :
         {StructureState::kIntact, StructureState::kDamaged, StructureState::kDestroyed}) {
        Structures structures;
        structures.nets.push_back({{100, 90}, {100, 102}, 3, state});
        const StructureMesh net = mesh(structures);
        ASSERT_FALSE(net.ropes.empty());
        const float now = std::ranges::max(net.faces, {}, [](const auto& v) { return v.at.z; }).at.z - 20;
        EXPECT_LT(now, highest);
        highest = now;
        EXPECT_EQ(now > 2.7f, state == StructureState::kIntact);
    }
    EXPECT_LT(highest, 1.2);
    Structures buried;
    buried.nets.push_back({{100, 90}, {100, 102}, 3, StructureState::kBuried});
    EXPECT_TRUE(mesh(buried).ropes.empty());
}

TEST_F(MeshOfStructures, tears_its_ropes_where_a_pylon_fell) {
    Structures structures;
    structures.all = {{StructureKind::kStation, {20, 150}, 90},
                      {StructureKind::kPylon, {100, 150}, 90, StructureState::kDestroyed},
                      {StructureKind::kStation, {180, 150}, 90}};
    structures.lifts.push_back({0, 3});
    for (const RopeVertex& vertex : mesh(structures).ropes)
        EXPECT_GT(std::abs(vertex.at.x - 100), 60) << "nothing hangs between the stations";
}

}  // namespace
}  // namespace render::test
