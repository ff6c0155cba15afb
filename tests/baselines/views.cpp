#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/figures/gallery_views.h"
#include "tests/baselines/image_baseline.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

// The views of `couloir gallery`: whole frames, of fine quality. The program draws all of them once, and simulates
// each scene once.

namespace baselines {
namespace {

// Names of the views of shipped scenes. The view of a real hill needs a terrain.
std::vector<std::string> names_of_views() {
    std::vector<std::string> names;
    for (const game::GalleryView& view : game::gallery_views())
        if (*view.scene) names.emplace_back(view.name);
    return names;
}

std::string with_underscores(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

class View : public testing::TestWithParam<std::string> {
  protected:
    static void SetUpTestSuite() {
        folder_.emplace();
        const auto drawn =
            game::test::couloir({"gallery", "--size", "256x144", "--out", folder_->path().string()});
        ASSERT_EQ(drawn.status, 0) << drawn.err;
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static render::Picture image_of(const std::string& view) {
        return read_image(folder_->path() / (view + ".png"));
    }

  private:
    inline static std::optional<support::TemporaryFolder> folder_;
};

TEST_P(View, is_drawn_as_in_its_baseline) {
    EXPECT_TRUE(matches_baseline(image_of(GetParam()), "view_" + with_underscores(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Gallery, View, testing::ValuesIn(names_of_views()),
                         [](const auto& view) { return with_underscores(view.param); });

}  // namespace
}  // namespace baselines
