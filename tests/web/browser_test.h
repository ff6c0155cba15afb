#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/game/program.h"
#include "tests/support/places.h"
#include "tests/web/chromium.h"

namespace game::test {

// Tests in one browser, which all of a suite share. They are skipped where there is none.
class BrowserTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        if (installed_chromium()) shared_ = std::make_unique<Shared>();
    }
    static void TearDownTestSuite() { shared_.reset(); }
    void SetUp() override {
        if (!shared_) GTEST_SKIP() << "chromium is not installed";
        if (browser().is_stuck()) shared_ = std::make_unique<Shared>();
    }

    static Chromium& browser() { return shared_->browser; }
    static bool holds(const std::string& expression) { return browser().value(expression) == true; }
    static std::string text(const std::string& id) {
        return browser().value("document.getElementById('" + id + "').textContent").get<std::string>();
    }
    // Writes a page and returns its address.
    static std::string file_of(const std::string& page) {
        const auto path = shared_->folder.path() / ("page-" + std::to_string(++shared_->files) + ".html");
        write_bytes(path, page);
        return "file://" + path.string();
    }

    struct Shared {
        Chromium browser;
        support::TemporaryFolder folder;
        int files = 0;
        std::string address, opened;  // of a page that several tests use; of the one that is open
    };
    static inline std::unique_ptr<Shared> shared_;
};

}  // namespace game::test
