#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "tests/game/program.h"
#include "tests/web/browser_test.h"
#include "tests/web/chromium.h"
#include "tests/web/loopback.h"
#include "tests/web/shared_slide.h"

// The page of a slide in a browser: what it shows, what hands do with it, and what it says if it cannot.
namespace game::test {
namespace {

constexpr const char* kHostileTitle =
    "</script><script>document.title = 'mine'</script><b onclick=x>& \"quoted\"";
constexpr std::int64_t kTicks = 1503;  // the last state is no multiple of six

const SharedSlide& avalanche() {
    static const SharedSlide slide = share_slide("winter-avalanche", kTicks, kHostileTitle);
    return slide;
}

std::size_t count_of(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
}

TEST(WebPageText, names_no_address_to_fetch_from) {
    const std::string& page = avalanche().page;
    for (const char* words :
         {"http:", "https:", "src=", "href=\"http", "@import", "url(", "fetch(", "XMLHttp"})
        EXPECT_EQ(count_of(page, words), 0u) << words;
    EXPECT_EQ(count_of(page, "content=\"default-src 'none';"), 1u);
}

TEST(WebPageText, closes_each_of_its_scripts_once) {
    const std::string& page = avalanche().page;
    EXPECT_EQ(count_of(page, "</script>"), count_of(page, "<script"));
}

class WebPage : public BrowserTest {
  protected:
    void SetUp() override {
        BrowserTest::SetUp();
        if (shared_) browser().size(640, 400);
    }

    static std::string page_file() {
        if (shared_->address.empty()) shared_->address = file_of(avalanche().page);
        return shared_->address;
    }
    // Opens an address afresh. Fails the test if it is not ready.
    static void open_anew(const std::string& address) {
        shared_->opened = address;
        ASSERT_EQ(browser().open(address), "ready") << sentence();
        browser().value("couloir.freeze(0.25)");
    }
    // Opens the avalanche's page with a small picture of fixed resolution, at tick 0 as it looks. To load it takes
    // seconds in software, so that a test takes over the page of the one before.
    static void open() {
        if (shared_->opened != page_file()) open_anew(page_file());
        browser().value("couloir.play(false), couloir.choose(0), couloir.seek(0), couloir.freeze(0.25)");
        browser().press("Escape");
        browser().press("v");
        EXPECT_TRUE(browser().comes("couloir.camera.arrived"));
    }

    static std::string sentence() {
        return browser().value("document.getElementById('note').textContent").get<std::string>();
    }
    static double number(const std::string& expression) { return browser().value(expression).get<double>(); }

    // A hash of the picture.
    static std::string picture() {
        return browser()
            .value(R"((() => {
                let hash = 5381;
                for (const byte of couloir.pixels().p) hash = Math.imul(hash, 33) ^ byte;
                return String(hash >>> 0);
            })())")
            .get<std::string>();
    }
    // Opens a page that is not the avalanche's and returns its state.
    static std::string open_other(const std::string& page) {
        shared_->opened.clear();
        return browser().open(file_of(page));
    }
    // Opens a page that cannot be shown and returns its sentence.
    static std::string refusal(const std::string& page) {
        EXPECT_EQ(open_other(page), "failed");
        EXPECT_TRUE(holds("document.getElementById('note').checkVisibility()"));
        EXPECT_TRUE(browser().messages().empty()) << browser().messages().front();
        return sentence();
    }
};

TEST_F(WebPage, opens_from_a_file_with_one_request_and_without_a_message) {
    open_anew(page_file());
    EXPECT_EQ(browser().requests(), std::vector{page_file()});
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

TEST_F(WebPage, opens_from_a_server_with_one_request_and_without_a_message) {
    const Loopback server(avalanche().page);
    open_anew(server.address());
    EXPECT_EQ(browser().requests(), std::vector{server.address()});
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
    EXPECT_EQ(server.requests(), 1);
}

TEST_F(WebPage, fits_large_small_and_touched_screens) {
    struct Screen {
        int width, height;
        double pixels;
        bool touch;
    };
    for (const Screen& screen : {Screen{390, 844, 2, true}, Screen{844, 390, 2, true},
                                 Screen{1280, 720, 1, false}, Screen{1920, 1080, 1, false}}) {
        SCOPED_TRACE(std::to_string(screen.width));
        browser().size(screen.width, screen.height, screen.pixels, screen.touch);
        if (screen.width == 390) open_anew(page_file());
        EXPECT_EQ(number("document.documentElement.scrollWidth"), screen.width);
        EXPECT_EQ(number("document.getElementById('view').clientHeight"), screen.height);
        EXPECT_TRUE(
            holds(R"([...document.querySelectorAll('header, footer, footer button, footer select, #scrub')]
            .filter(each => each.checkVisibility()).every(each => {
                const {left, top, right, bottom, width} = each.getBoundingClientRect();
                return width > 0 && left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
            }))"));
        EXPECT_TRUE(
            holds("document.querySelector('header').getBoundingClientRect().bottom < "
                  "document.querySelector('footer').getBoundingClientRect().top"));
        EXPECT_EQ(browser().messages(), std::vector<std::string>());
    }
}

TEST_F(WebPage, draws_a_time_the_same_after_the_end_and_back) {
    open();
    browser().value("couloir.seek(900)");
    const std::string then = picture();
    browser().value("couloir.seek(couloir.info.last)");
    EXPECT_NE(picture(), then);
    browser().value("couloir.seek(0)");
    browser().value("couloir.seek(900)");
    EXPECT_EQ(picture(), then);
}

// Chromium once left the canvas black after its size had changed.
TEST_F(WebPage, shows_on_the_canvas_what_it_drew) {
    open();
    for (const char* scale : {"0.3", "1", "0.25"}) {
        browser().value(std::string("couloir.freeze(") + scale + ")");
        EXPECT_TRUE(holds(R"((() => {
            const {p} = couloir.pixels(), gl = document.getElementById('view').getContext('webgl2');
            const shown = new Uint8Array(p.length);
            gl.bindFramebuffer(gl.FRAMEBUFFER, null);
            gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, shown);
            return new Set(shown).size > 50 && p.every((byte, i) => i % 4 === 3 || byte === shown[i]);
        })())"))
            << scale;
    }
}

TEST_F(WebPage, draws_other_colours_for_each_quantity) {
    open();
    browser().value("couloir.seek(900)");
    std::set<std::string> pictures{picture()};
    const int overlays = static_cast<int>(number("couloir.info.overlays.length"));
    for (int i = 1; i <= overlays; ++i) {
        browser().value("couloir.choose(" + std::to_string(i) + ")");
        pictures.insert(picture());
    }
    EXPECT_EQ(pictures.size(), static_cast<std::size_t>(overlays) + 1);
}

// Reads 300 points of a page, most of them where something moves, and compares them with the program's own states.
void compare_readings(Chromium& browser, const SharedSlide& slide) {
    const auto nx = static_cast<std::size_t>(slide.scenario.grid.nx);
    const std::size_t vertices = nx * static_cast<std::size_t>(slide.scenario.grid.ny);
    const Json info = browser.value("couloir.info");
    const Json& error = info["error"];
    const double rounding = 1e-5, ground = error["ground"].get<double>() + rounding,
                 depth = error["depth"].get<double>() + rounding,
                 rolling = error["moving"].get<double>() + rounding,
                 speed = error["speed"].get<double>() + rounding;
    EXPECT_LT(depth, 0.0052) << "m";
    EXPECT_LT(rolling, 0.0052) << "m";
    EXPECT_LT(speed, 0.064) << "m/s";

    std::mt19937 random(7);
    std::vector<std::int64_t> ticks;
    for (const auto& [tick, kept] : slide.kept) ticks.push_back(tick);
    int moving = 0;
    for (int i = 0; i < 20; ++i) {
        const std::int64_t tick = i == 0 ? ticks.back() : ticks[random() % ticks.size()];
        const SharedSlide::Kept& kept = slide.kept.at(tick);
        Json points = Json::array();
        std::vector<std::size_t> places;
        for (int tries = 0; places.size() < 15; ++tries) {
            const std::size_t place = random() % vertices;
            if (tries < 2000 && kept.rolling[place] < 0.02f) continue;
            if (!slide.scenario.has_data[place]) continue;
            moving += kept.rolling[place] > 0;
            places.push_back(place);
            points.push_back({place % nx, place / nx});
        }
        const Json answers = browser.value(
            "(couloir.seek(" + std::to_string(tick) + "), " + points.dump() +
            ".map(([x, y]) => couloir.read(x * couloir.info.grid.dx, y * couloir.info.grid.dx)))");
        for (std::size_t k = 0; k < places.size(); ++k) {
            const std::size_t at = places[k];
            const Json& answer = answers[k];
            const auto value = [&](const char* name) { return answer[name].get<double>(); };
            const double d = static_cast<double>(kept.depth[at]), r = static_cast<double>(kept.rolling[at]),
                         d0 = static_cast<double>(slide.kept.at(0).depth[at]);
            EXPECT_EQ(answer["tick"], tick);
            EXPECT_NEAR(value("standing"), d, depth);
            EXPECT_NEAR(value("rolling"), r, rolling);
            EXPECT_NEAR(value("speed"), static_cast<double>(kept.speed[at]), speed);
            EXPECT_NEAR(value("change"), d - d0, 2 * depth);
            EXPECT_NEAR(value("height"),
                        slide.scenario.datum + static_cast<double>(slide.scenario.bedrock[at]) + d + r,
                        ground + depth + rolling);
            EXPECT_NEAR(value("peakDepth"), static_cast<double>(slide.peaks.depth[at]), 0.0051);
            EXPECT_NEAR(value("peakSpeed"), static_cast<double>(slide.peaks.speed_plan[at]), 0.063);
            if (!kept.mixture.empty()) {
                EXPECT_NEAR(255 * value("lowerStanding"), kept.mixture[2 * at], 0.51);
                EXPECT_NEAR(255 * value("lowerRolling"), kept.mixture[2 * at + 1], 0.51);
            }
        }
    }
    EXPECT_GT(moving, 100);
}

TEST_F(WebPage, reads_what_the_program_computed) {
    open();
    compare_readings(browser(), avalanche());
}

TEST_F(WebPage, reads_both_materials) {
    const SharedSlide slide = share_slide("snow-on-soil", 900);
    open_anew(file_of(slide.page));
    compare_readings(browser(), slide);
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

TEST_F(WebPage, blends_between_the_states_while_it_plays_and_stops_on_one) {
    open();
    browser().value("couloir.seek(600)");
    browser().value("couloir.play(true)");
    EXPECT_TRUE(browser().comes("couloir.tick > 620 && couloir.tick % couloir.info.every !== 0"));
    browser().value("couloir.play(false)");
    EXPECT_TRUE(holds("couloir.tick % couloir.info.every === 0"));
    EXPECT_GT(number("couloir.tick"), 615);
}

TEST_F(WebPage, opens_at_a_telling_moment_and_plays_from_the_beginning) {
    open_anew(page_file());
    EXPECT_GT(number("couloir.tick"), 0);
    EXPECT_FALSE(holds("couloir.playing"));
    browser().click(320, 200);  // the large button
    EXPECT_TRUE(holds("couloir.playing"));
    EXPECT_LT(number("couloir.tick"), 300);
    EXPECT_TRUE(browser().comes("couloir.tick > 6"));
}

TEST_F(WebPage, opens_at_the_time_of_its_address) {
    open_anew(page_file() + "#t=12.5");
    EXPECT_EQ(number("couloir.tick"), 750);
}

TEST_F(WebPage, is_used_by_keys_alone) {
    browser().size(800, 500);
    open_anew(page_file());
    std::vector<std::string> order;
    for (int i = 0; i < 10; ++i) {
        browser().press("Tab");
        order.push_back(browser()
                            .value("document.activeElement.id || document.activeElement.tagName")
                            .get<std::string>());
        EXPECT_TRUE(holds("getComputedStyle(document.activeElement).outlineStyle === 'solid'"))
            << order.back();
    }
    EXPECT_EQ(order, (std::vector<std::string>{"view", "start", "SUMMARY", "play", "scrub", "take-over",
                                               "rate", "overlay", "home", "help"}));
    browser().value("document.getElementById('view').focus()");

    const auto tick = [] { return number("couloir.tick"); };
    browser().press("End");
    EXPECT_EQ(tick(), kTicks);
    browser().press("Home");
    EXPECT_EQ(tick(), 0);
    browser().press(".");
    EXPECT_EQ(tick(), 6);
    browser().press(">", true);
    EXPECT_EQ(tick(), 6) << "a key of another place on the keyboard";
    browser().press(".", true);
    EXPECT_EQ(tick(), 66) << "a second later";
    browser().press(",");
    EXPECT_EQ(tick(), 60);

    browser().press("2");
    EXPECT_TRUE(holds("document.getElementById('legend').checkVisibility()"));
    browser().press("0");
    EXPECT_FALSE(holds("document.getElementById('legend').checkVisibility()"));

    const std::string first = browser().value("JSON.stringify(couloir.camera.goal)").get<std::string>();
    const auto changes = [&](const char* key, bool shift, const std::string& number_of) {
        const double before = number("couloir.camera.goal." + number_of);
        browser().press(key, shift);
        EXPECT_NE(number("couloir.camera.goal." + number_of), before) << key;
    };
    changes("ArrowRight", false, "azimuth");
    changes("ArrowUp", false, "elevation");
    changes("ArrowLeft", true, "target[0]");
    changes("+", false, "distance");
    changes("-", false, "distance");
    browser().press("v");
    EXPECT_EQ(browser().value("JSON.stringify(couloir.camera.goal)"), first);
    EXPECT_TRUE(browser().comes("couloir.camera.arrived"));

    browser().press("r");
    EXPECT_TRUE(holds("document.getElementById('reading').checkVisibility()"));
    browser().press("Escape");
    EXPECT_FALSE(holds("document.getElementById('reading').checkVisibility()"));
    browser().press("?", true);
    EXPECT_TRUE(holds("document.getElementById('keys').open"));
    browser().press("Escape");
    EXPECT_FALSE(holds("document.getElementById('keys').open"));
    browser().press(" ");
    EXPECT_TRUE(holds("couloir.playing"));
    browser().press(" ");
    EXPECT_FALSE(holds("couloir.playing"));
}

// The ground under a hand, east and north; it must be there.
glm::dvec2 ground_under(Chromium& browser, double x, double y) {
    const Json at = browser.value("couloir.pick(" + std::to_string(x) + ", " + std::to_string(y) + ")");
    if (!at.is_object()) {
        ADD_FAILURE() << "no ground";
        return {};
    }
    return {at["x"].get<double>(), at["y"].get<double>()};
}

TEST_F(WebPage, keeps_the_ground_under_the_hand) {
    open();
    const double side = number("(couloir.info.grid.nx - 1) * couloir.info.grid.dx"), near = 0.004 * side;
    const auto pose = [] { return browser().value("couloir.camera.pose"); };
    const auto first = pose();
    const auto place = ground_under(browser(), 350, 200);
    browser().drag(350, 200, 400, 280);
    const auto turned = pose();
    EXPECT_NEAR(turned["azimuth"].get<double>() - first["azimuth"].get<double>(), 180 * 50 / 640.0, 0.01);
    EXPECT_GT(turned["elevation"], first["elevation"]);
    EXPECT_LT(glm::distance(ground_under(browser(), 350, 200), place), near) << "m, after a turn about it";

    const auto grabbed = ground_under(browser(), 300, 240);
    browser().drag(300, 240, 340, 210, true);
    EXPECT_LT(glm::distance(ground_under(browser(), 340, 210), grabbed), near) << "m, after it was moved";

    const auto pointed = ground_under(browser(), 280, 260);
    browser().wheel(280, 260, -300);
    EXPECT_TRUE(
        browser().comes("couloir.camera.arrived && couloir.camera.distance < " + turned["distance"].dump()));
    EXPECT_LT(glm::distance(ground_under(browser(), 280, 260), pointed), near) << "m, after coming nearer";
}

TEST_F(WebPage, comes_nearer_and_turns_by_two_fingers) {
    browser().size(390, 844, 2, true);
    open();
    const auto first = browser().value("couloir.camera.pose");
    browser().pinch(195, 500, -60, 0, -120, 0);
    const auto nearer = browser().value("couloir.camera.pose");
    EXPECT_NEAR(nearer["distance"].get<double>() / first["distance"].get<double>(), 0.5, 0.05);
    browser().pinch(195, 500, -100, 0, 0, -100);
    const auto turned = browser().value("couloir.camera.pose");
    EXPECT_NEAR(turned["azimuth"].get<double>() - nearer["azimuth"].get<double>(), 90, 5) << "degrees";
}

TEST_F(WebPage, never_looks_from_below_the_ground) {
    open();
    EXPECT_GT(number(R"((() => {
        const {camera} = couloir;
        let seed = 1, least = Infinity;
        const any = (low, high) => {
            seed = seed * 48271 % 2147483647;
            return low + (high - low) * seed / 2147483647;
        };
        for (let i = 0; i < 2000; ++i) {
            if (i % 3 === 0) camera.turn(any(-60, 60), any(-40, 20));
            if (i % 3 === 1) camera.zoom(any(0.3, 1.6));
            if (i % 3 === 2) camera.pan(any(-1, 1), any(-1, 1));
            camera.glide(any(0, 0.2));
            const {eye} = camera.viewOf(160, 90);
            least = Math.min(least, eye[2] - camera.ground.heightAt(eye[0], eye[1]));
        }
        return least;
    })())"),
              1)
        << "m";
}

TEST_F(WebPage, reads_the_ground_under_a_finger) {
    browser().size(390, 844, 2, true);
    open();
    EXPECT_FALSE(holds("document.getElementById('reading').checkVisibility()"));
    browser().tap(195, 600);
    EXPECT_TRUE(browser().comes("document.getElementById('reading').checkVisibility()"));
}

TEST_F(WebPage, moves_at_once_if_motion_is_to_be_reduced) {
    browser().call("Emulation.setEmulatedMedia",
                   {{"features", {{{"name", "prefers-reduced-motion"}, {"value", "reduce"}}}}});
    open();
    browser().value("document.getElementById('view').focus()");
    EXPECT_TRUE(browser().comes("!couloir.camera.smooth"));
    const double azimuth = number("couloir.camera.azimuth");
    browser().press("ArrowRight");
    EXPECT_NEAR(number("couloir.camera.azimuth"), azimuth + 4, 1e-9) << "degrees";
    browser().call("Emulation.setEmulatedMedia", {{"features", Json::array()}});
}

TEST_F(WebPage, draws_only_if_something_changes) {
    open();
    rest(1);
    const double frames = number("couloir.frames");
    rest(1);
    EXPECT_EQ(number("couloir.frames"), frames);
    browser().value("couloir.seek(60)");
    EXPECT_TRUE(browser().comes("couloir.frames > " + std::to_string(frames)));
}

TEST_F(WebPage, lowers_its_resolution_while_it_plays_and_raises_it_again) {
    open();
    browser().size(1280, 720);
    browser().value("couloir.freeze(0)");
    browser().value("couloir.play(true)");
    EXPECT_TRUE(browser().comes("couloir.scale < 1"));
    browser().value("couloir.play(false)");
    EXPECT_TRUE(browser().comes("couloir.scale >= 1"));
}

TEST_F(WebPage, shows_any_title_as_plain_text) {
    open();
    EXPECT_EQ(browser().value("document.getElementById('title').textContent"), kHostileTitle);
    EXPECT_EQ(browser().value("document.title"), kHostileTitle);
    EXPECT_EQ(number("document.querySelectorAll('b').length"), 0);
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

// Whatever is brought into a page, its policy lets nothing of it run.
TEST_F(WebPage, runs_no_script_but_its_own) {
    std::string page = avalanche().page;
    const std::string body = "<body>";
    page.insert(page.find(body) + body.size(),
                "<script>document.documentElement.dataset.mine = 1</script>"
                "<img src=\"data:,\" onerror=\"document.documentElement.dataset.mine = 2\">"
                "<base href=\"https://example.org/\">");
    EXPECT_EQ(open_other(page), "ready");
    EXPECT_FALSE(holds("'mine' in document.documentElement.dataset"));
    EXPECT_TRUE(holds("document.baseURI.startsWith('file:')"));
}

TEST_F(WebPage, says_that_its_data_is_damaged) {
    std::string page = avalanche().page;
    const std::size_t fields = page.find("id=\"fields\">"),
                      middle = fields + (page.find("</script>", fields) - fields) / 2;
    page[middle] = page[middle] == 'A' ? 'B' : 'A';
    EXPECT_NE(refusal(page).find("damaged"), std::string::npos);
}

TEST_F(WebPage, says_that_its_numbers_are_damaged) {
    std::string page = avalanche().page;
    page[page.find('{', page.find("id=\"slide\">"))] = '[';
    EXPECT_NE(refusal(page).find("damaged"), std::string::npos);
}

TEST_F(WebPage, says_that_its_end_is_missing) {
    const std::string& page = avalanche().page;
    for (const char* place : {"id=\"slide\">", "id=\"fields\">", "'use strict'"})
        EXPECT_NE(refusal(page.substr(0, page.find(place) + 500)).find("missing"), std::string::npos)
            << place;
}

TEST_F(WebPage, says_that_the_browser_cannot_draw) {
    Chromium plain({"--disable-3d-apis"});
    EXPECT_EQ(plain.open(page_file()), "failed");
    EXPECT_NE(plain.value("document.getElementById('note').textContent").get<std::string>().find("WebGL 2"),
              std::string::npos);
}

TEST_F(WebPage, returns_after_the_browser_took_its_graphics_memory) {
    open();
    browser().value("couloir.seek(900)");
    const std::string before = picture();
    browser().value(
        "lost = document.getElementById('view').getContext('webgl2').getExtension('WEBGL_lose_context'), "
        "lost.loseContext()");
    EXPECT_TRUE(browser().comes("document.documentElement.dataset.state === 'failed'"));
    EXPECT_NE(sentence().find("memory"), std::string::npos);
    browser().value("lost.restoreContext()");
    EXPECT_TRUE(browser().comes("document.documentElement.dataset.state === 'ready'", 240));
    EXPECT_FALSE(holds("document.getElementById('note').checkVisibility()"));
    EXPECT_EQ(picture(), before);
}

}  // namespace
}  // namespace game::test
