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
            // A run to beat, as an earlier try left it.
            const Surroundings around{
                .environment = {{"XDG_DATA_HOME", (shared_->folder.path() / "data").string()}}};
            const auto won = support::source_dir() / "tests/challenges/quarry_won.couloir";
            ASSERT_EQ(couloir({"replay", won.string(), "--keep"}, around).status, 0);
            const Finished done =
                couloir({"site", "quarry", "quarry-hard", "open-at-five", "--out", made.string()}, around);
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

// Digs by a real mouse, as in tests/challenges/quarry_won.couloir.
TEST_F(SiteInBrowser, lets_a_challenge_be_won_as_the_program_scores_it_and_shows_what_was_won) {
    serve();
    browser().size(1280, 720);
    ASSERT_EQ(browser().open(address("quarry.html")), "ready");
    browser().value("couloir.freeze(0.2)");
    browser().press("t");
    ASSERT_TRUE(browser().comes("couloir.live.on", 60)) << text("told");
    browser().value("couloir.live.setRadius(3.126)");
    for (const char* place : {"51.9, 142.1", "34.3, 142.0"}) {
        // Where a point of the ground is seen, px.
        const Json at = browser().value(R"(((x, y) => {
            let best = {d: Infinity};
            const look = (u0, v0, u1, v1, n) => {
                for (let i = 0; i <= n * n; ++i) {
                    const u = u0 + (u1 - u0) * (i % n) / n, v = v0 + (v1 - v0) * Math.floor(i / n) / n;
                    const at = document.elementFromPoint(u, v)?.id === 'view' && couloir.pick(u, v), d = Math.hypot(at?.x - x, at?.y - y);
                    if (d < best.d) best = {u, v, d};
                }
            };
            look(0, 0, innerWidth - 1, innerHeight - 1, 50);
            for (let s = 16; s > 0.4; s /= 2) look(best.u - s, best.v - s, best.u + s, best.v + s, 8);
            return best;
        })()" + std::string(place) + ")");
        ASSERT_LT(at["d"].get<double>(), 0.5) << "m";
        Json mouse{{"type", "mousePressed"}, {"x", at["u"]}, {"y", at["v"]},
                   {"button", "left"},       {"buttons", 1}, {"clickCount", 1}};
        const std::string dug =
            "couloir.live.status.tick - " + browser().value("couloir.live.status.tick").dump();
        browser().call("Input.dispatchMouseEvent", mouse);
        ASSERT_TRUE(browser().comes(dug + " > 150", 60));  // ticks
        mouse["type"] = "mouseReleased";
        browser().call("Input.dispatchMouseEvent", mouse);
    }
    browser().value(
        "document.getElementById('rate').value = 8, document.getElementById('rate').dispatchEvent(new "
        "Event('change'))");
    browser().size(160, 120);  // which is drawn sooner
    ASSERT_TRUE(browser().comes("document.getElementById('card').open", 120));
    EXPECT_EQ(text("verdict"), "Won: gold");
    EXPECT_NE(text("say").find("9\u202f813 points were scored before you"), std::string::npos) << text("say");
    EXPECT_TRUE(holds("couloir.live.slide.extent.inside.some(inside => inside === 1)"))
        << "the ghost of that run";
    const auto score = browser().value("couloir.live.status.card.points").get<std::int64_t>();
    const std::string recording =
        browser().value("couloir.live.recorded().then(file => file.text())").get<std::string>();
    write_bytes(folder_.path() / "mine.couloir", recording);
    const Finished proven =
        couloir({"replay", (folder_.path() / "mine.couloir").string(), "--verify", "--score"});
    EXPECT_EQ(proven.status, 0) << proven.err;
    EXPECT_NE(proven.out.find("score " + std::to_string(score)), std::string::npos) << proven.out;
    EXPECT_NE(proven.out.find("exact: all"), std::string::npos) << proven.out;

    // Once more, where nothing can be kept: the card says so.
    browser().value(
        "localStorage.setItem('couloir.best', '{'), Storage.prototype.kept = Storage.prototype.setItem, "
        "Storage.prototype.setItem = () => { throw new DOMException('', 'QuotaExceededError'); }, "
        "couloir.live.showCard(couloir.live.status.card)");
    EXPECT_NE(text("points").find("This browser keeps no medal"), std::string::npos) << text("points");
    browser().value(
        "Storage.prototype.setItem = Storage.prototype.kept, "
        "couloir.live.showCard(couloir.live.status.card)");
    EXPECT_EQ(text("points").find("This browser keeps no medal"), std::string::npos) << text("points");

    ASSERT_EQ(browser().open(address()), "ready");
    EXPECT_EQ(
        browser().value("document.querySelector('.best[data-best=quarry]').textContent.replace(/\\D/g, '')"),
        std::to_string(score));
    EXPECT_TRUE(holds("document.querySelector('.best[data-best=quarry]').textContent.endsWith(', gold')"));
    EXPECT_EQ(browser().value("document.querySelectorAll('.medals .won').length"), 3);
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
    write_bytes(folder.path() / "of another name.png", "picture");
    const SitePage page{.name = "a",
                        .title = "<script>alert(1)</script>",
                        .words = "3 m3 & \"more\"",
                        .picture = folder.path() / "of another name.png",
                        .bytes = 1};
    ASSERT_TRUE(write_site(folder.path(), std::vector{page}));
    EXPECT_EQ(read_bytes(folder.path() / "a.png"), "picture");
    const std::string index = read_bytes(folder.path() / "index.html");
    EXPECT_EQ(index.find("<script>alert"), std::string::npos);
    EXPECT_NE(index.find("&lt;script&gt;alert(1)"), std::string::npos);
    EXPECT_NE(index.find("3 m³ &amp; "), std::string::npos);
    EXPECT_NE(index.find("<img src=\"a.png\""), std::string::npos);
    for (const char* name : {"", "index", "a b", "../a", "a.b", "ä", "a\"b"})
        EXPECT_FALSE(names_a_site_page(name)) << name;
    EXPECT_TRUE(names_a_site_page("one-shovel_2"));
}

}  // namespace
}  // namespace game::test
