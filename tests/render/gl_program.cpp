#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/render/gl_scene.h"
#include "tests/support/places.h"

namespace render::test {
namespace {

namespace fs = std::filesystem;

// The shipped assets with one shader changed: `text` is inserted after line `line`.
class Shaders : public Gl {
  protected:
    void SetUp() override {
        Gl::SetUp();
        for (const char* folder : {"shaders", "textures"})
            fs::copy(support::source_dir() / "assets" / folder, folder_.path() / folder);
    }

    void insert_after(const std::string& shader, int line, const std::string& text) const {
        const fs::path path = folder_.path() / "shaders" / shader;
        std::ifstream in(path);
        std::ostringstream changed;
        std::string row;
        for (int i = 1; std::getline(in, row); ++i) changed << row << '\n' << (i == line ? text + '\n' : "");
        std::ofstream(path) << changed.str();
    }

    std::string error() const {
        auto renderer = Renderer::create(folder_.path());
        if (!renderer) return renderer.error();
        const auto loaded = renderer->load({}, false);
        return loaded ? "" : loaded.error();
    }

    support::TemporaryFolder folder_;
};

TEST_F(Shaders, are_whole_when_copied) {
    EXPECT_EQ(error(), "");
}

TEST_F(Shaders, that_do_not_compile_are_reported_with_file_and_line) {
    insert_after("terrain.frag", 6, "float broken = undeclared_thing;");
    EXPECT_NE(error().find("shaders/terrain.frag:7: "), std::string::npos) << error();
    EXPECT_NE(error().find("undeclared_thing"), std::string::npos) << error();
}

TEST_F(Shaders, are_reported_by_the_wrong_file_among_several) {
    insert_after("light.glsl", 2, "const vec3 kWrong = 1.0 + ;");
    EXPECT_NE(error().find("shaders/light.glsl:3: "), std::string::npos) << error();
}

TEST_F(Shaders, that_are_missing_are_named) {
    fs::remove(folder_.path() / "shaders" / "surface.comp");
    EXPECT_NE(error().find("shaders/surface.comp: cannot be read"), std::string::npos) << error();
}

TEST(HeadlessContext, names_an_unknown_backend) {
    const auto context = HeadlessContext::create("vulkan");
    ASSERT_FALSE(context);
    EXPECT_NE(context.error().find("'vulkan'"), std::string::npos) << context.error();
}

TEST(HeadlessContext, reports_the_number_of_devices_for_a_missing_device) {
    const auto context = HeadlessContext::create("device:4711");
    ASSERT_FALSE(context);
    EXPECT_NE(context.error().find("device:4711: EGL has "), std::string::npos) << context.error();
}

TEST_F(Gl, names_its_renderer_and_version) {
    const std::string name = context().renderer_name();
    EXPECT_NE(name.find(", 4."), std::string::npos) << name;
    EXPECT_NE(name.find(", 4."), 0u) << name;
}

}  // namespace
}  // namespace render::test
