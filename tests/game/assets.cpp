#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace {

// The assets of the checkout, wherever the build folder is; for the test program and its children.
class AssetsOfTheCheckout : public testing::Environment {
  public:
    void SetUp() override { setenv("COULOIR_ASSETS", (support::source_dir() / "assets").c_str(), 0); }
};

[[maybe_unused]] const testing::Environment* const kAssets =
    testing::AddGlobalTestEnvironment(new AssetsOfTheCheckout);

}  // namespace
