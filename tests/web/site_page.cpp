#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "game/share/site.h"
#include "tests/game/program.h"
#include "tests/support/places.h"
#include "tests/web/browser_test.h"
#include "tests/web/chromium.h"
#include "tests/web/loopback.h"

// A site in a browser: from a server with and without a policy, without a network, in another version.
namespace game::test {
namespace {

constexpr const char* kStrict =
    "Content-Security-Policy: default-src 'self'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; "
    "style-src 'self' "
    "'unsafe-inline'; img-src 'self' data:; worker-src 'self' blob:\r\nX-Content-Type-Options: nosniff\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\nCross-Origin-Embedder-Policy: require-corp\r\n";

class SiteInBrowser : public BrowserTest {
  protected:
    void SetUp() override {
        BrowserTest::SetUp();
        if (IsSkipped()) return;
        const auto made = shared_->folder.path() / "site";
        if (!std::filesystem::exists(made)) {
            const Finished done =
                couloir({"site", "quarry", "quarry-hard", "open-at-five", "--out", made.string()});
            ASSERT_EQ(done.status, 0) << done.err;
        }
        std::filesystem::copy(made, folder_.path());
    }

    // Ends the server, and the browser has no network.
    void cut() { server_.reset(); }
    void serve(const char* headers = "") {
        const int port = server_ ? server_->port() : port_;
        server_.reset();
        server_ = std::make_unique<Loopback>(folder_.path(), headers, port);
        port_ = server_->port();
    }
    std::string address(const std::string& name = {}) const {
        return "http://127.0.0.1:" + std::to_string(port_) + "/" + name;
    }
    static bool keeps(int pages) {
        return browser().comes("countKept().then(kept => kept === " + std::to_string(pages) + ")", 20);
    }

    support::TemporaryFolder folder_;
    std::unique_ptr<Loopback> server_;
    int port_ = 0;
};

TEST_F(SiteInBrowser, opens_without_a_network_once_it_was_opened_from_a_plain_or_a_strict_server) {
    for (const char* headers : {"", kStrict}) {
        SCOPED_TRACE(headers);
        port_ = 0;
        serve(headers);
        browser().size(390, 844);
        ASSERT_EQ(browser().open(address()), "ready");
        EXPECT_TRUE(browser().comes("!document.getElementById('offline').hidden", 20));
        EXPECT_EQ(text("kept"), "0 of 3 mountains are on this device. One that you have opened stays.");
        EXPECT_EQ(browser().call("Page.getAppManifest", Json::object()).at("errors"), Json::array());
        EXPECT_EQ(browser().call("Page.getInstallabilityErrors", Json::object()).at("installabilityErrors"),
                  Json::array());
        EXPECT_EQ(browser().messages(), std::vector<std::string>());

        ASSERT_EQ(browser().open(address("quarry.html")), "ready");
        EXPECT_TRUE(holds("document.getElementById('site').checkVisibility()"));
        browser().value("couloir.freeze(0.25)");
        browser().press("t");
        EXPECT_TRUE(browser().comes("couloir.live.on", 60)) << text("told");
        EXPECT_EQ(browser().messages(), std::vector<std::string>());
        ASSERT_EQ(browser().open(address()), "ready");
        EXPECT_TRUE(keeps(1));
        browser().value("document.getElementById('keep').click()");
        EXPECT_TRUE(
            browser().comes("document.getElementById('kept').textContent.startsWith('All mountains')", 60))
            << text("kept");

        cut();
        for (const char* name : {"quarry-hard.html", "open-at-five", "index.html", ""})
            EXPECT_EQ(browser().open(address(name)), "ready") << name;
        EXPECT_TRUE(browser().comes(
            "[...document.images].every(image => image.complete && image.naturalWidth > 0)", 20));
    }
}

TEST_F(SiteInBrowser, takes_a_new_version_whole_and_keeps_no_damaged_page) {
    serve();
    ASSERT_EQ(browser().open(address()), "ready");
    ASSERT_EQ(browser().open(address("quarry.html")), "ready");

    // A new version, of which one page does not arrive whole.
    const auto page = folder_.path() / "quarry.html", other = folder_.path() / "open-at-five.html";
    write_bytes(page, read_bytes(page) + "<!-- another version -->");
    const SitePage quarry{.name = "quarry", .title = "Quarry", .words = "Dig.", .bytes = 1},
        five{.name = "open-at-five", .title = "Five", .words = "Plough.", .bytes = 1};
    ASSERT_TRUE(write_site(folder_.path(), std::vector{quarry, five}));
    write_bytes(other, read_bytes(other) + "<!-- not what the site has -->");
    ASSERT_EQ(browser().open(address()), "ready");  // the old one, and it looks for another
    browser().value("navigator.serviceWorker.getRegistration().then(each => each.update())");
    ASSERT_TRUE(browser().comes(
        "navigator.serviceWorker.getRegistration().then(each => !each.installing && !each.waiting)", 20));
    ASSERT_EQ(browser().open(address()), "ready");
    EXPECT_EQ(browser().value("document.querySelectorAll('[data-world]').length"), 2);
    EXPECT_TRUE(keeps(1)) << "what was kept is kept in the new version";
    browser().value("document.getElementById('keep').click()");
    EXPECT_TRUE(
        browser().comes("document.getElementById('kept').textContent.includes('could not be kept')", 60))
        << text("kept");

    cut();
    ASSERT_EQ(browser().open(address("quarry.html")), "ready");
    EXPECT_TRUE(holds("document.lastChild.data.includes('another version')"));
    browser().call("Page.navigate", {{"url", address("open-at-five.html")}});
    EXPECT_TRUE(browser().comes("document.body.textContent.startsWith('There is no network')", 20));
}

TEST_F(SiteInBrowser, shows_what_was_won_in_this_browser) {
    serve();
    ASSERT_EQ(browser().open(address("quarry-hard.html")), "ready");
    browser().value("couloir.live.keepBest({won: true, points: 4500, medal: 2})");
    browser().value("couloir.live.keepBest({won: true, points: 4400, medal: 2})");
    browser().value("couloir.live.keepBest({won: false, points: 9000, medal: 3})");
    ASSERT_EQ(browser().open(address("quarry.html")), "ready");
    browser().value("couloir.live.keepBest({won: true, points: 5000, medal: 2})");
    ASSERT_EQ(browser().open(address()), "ready");
    EXPECT_EQ(browser().value("document.querySelector('.best[data-best=quarry]').textContent"),
              "Your best here: 5\u202f000, silver");
    EXPECT_EQ(browser().value("document.querySelector('[data-after]').textContent"), ": 4\u202f500, silver");
    EXPECT_EQ(browser().value("document.querySelectorAll('.medals .won').length"), 2);
    browser().value("localStorage.setItem('couloir.best', '{')");
    EXPECT_EQ(browser().open(address()), "ready") << "what is no record is left alone";
}

TEST_F(SiteInBrowser, is_laid_out_at_four_sizes_and_from_a_file) {
    for (const auto& [width, height] : {std::pair{1920, 1080}, {1280, 720}, {844, 390}, {390, 844}}) {
        browser().size(width, height);
        ASSERT_EQ(browser().open("file://" + (folder_.path() / "index.html").string()), "ready");
        EXPECT_TRUE(holds("document.documentElement.scrollWidth <= innerWidth")) << width;
        EXPECT_TRUE(holds("document.getElementById('offline').hidden"));
        EXPECT_EQ(browser().messages(), std::vector<std::string>());
    }
    browser().press("Tab");
    EXPECT_EQ(browser().value("document.activeElement.dataset.world"), "quarry");
}

TEST(Site, has_titles_as_text_and_only_names_that_are_files) {
    const support::TemporaryFolder folder;
    write_bytes(folder.path() / "a.html", "a");
    const SitePage page{
        .name = "a", .title = "<script>alert(1)</script>", .words = "3 m3 & \"more\"", .bytes = 1};
    ASSERT_TRUE(write_site(folder.path(), std::vector{page}));
    const std::string index = read_bytes(folder.path() / "index.html");
    EXPECT_EQ(index.find("<script>alert"), std::string::npos);
    EXPECT_NE(index.find("&lt;script&gt;alert(1)"), std::string::npos);
    EXPECT_NE(index.find("3 m³ &amp; "), std::string::npos);
    for (const char* name : {"", "index", "a b", "../a", "a.b", "ä", "a\"b"})
        EXPECT_FALSE(names_a_site_page(name)) << name;
    EXPECT_TRUE(names_a_site_page("one-shovel_2"));
}

}  // namespace
}  // namespace game::test
