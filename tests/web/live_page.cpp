#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "game/recording/base64.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "game/share/slide_page.h"
#include "tests/game/program.h"
#include "tests/support/places.h"
#include "tests/web/browser_test.h"
#include "tests/web/chromium.h"
#include "tests/web/loopback.h"
#include "tests/web/shared_slide.h"

// A page that is taken over: the module in it, tools by real mouse and touch, and what the program says of what was saved.
namespace game::test {
namespace {

std::string asset(const std::string& name) {
    return read_bytes(support::source_dir() / "assets" / name);
}

// A page with the module's worker and recordings, and nothing else.
std::string page_of_worker(const std::vector<std::string>& recordings) {
    std::string page = "<!doctype html><html><body><script>\nconst files = {";
    const auto add = [&](const std::string& name, const std::string& bytes) {
        page += "'" + name + "': '" + to_base64(bytes) + "',\n";
    };
    add("module", asset("web/couloir.wasm"));
    add("worker", asset("web/live_worker.js"));
    for (const std::string& name : recordings) add(name, asset("recordings/" + name + ".couloir"));
    return page + R"(};
const bytesOf = name => Uint8Array.from(atob(files[name]), letter => letter.charCodeAt(0));
// Opens a recording in a worker of its own, and waits until it has been replayed. Returns the last word about its proof.
const prove = (name, text = new TextDecoder().decode(bytesOf(name))) => new Promise((resolve, reject) => {
    const worker = new Worker(URL.createObjectURL(new Blob([bytesOf('worker')], {type: 'text/javascript'})));
    worker.onmessage = ({data}) => {
        if (data.failed) reject(data.failed);
        if (data.proof && data.proof.whole) {
            worker.terminate();
            resolve(data.proof);
        }
    };
    worker.onerror = event => reject(event.message);
    worker.postMessage({id: 1, kind: 'open', bytes: bytesOf('module'), name, recording: text});
});
document.documentElement.dataset.state = 'ready';
</script></body></html>)";
}

TEST(LiveModule, computes_every_recorded_state_of_what_ships) {
    if (!installed_chromium()) GTEST_SKIP() << "chromium is not installed";
    const std::vector<std::string> names{"landslide", "landslide-bcre", "snow-avalanche", "winter-avalanche",
                                         "couloir-avalanche"};
    const support::TemporaryFolder folder;
    write_bytes(folder.path() / "worker.html", page_of_worker(names));
    Chromium browser;
    ASSERT_EQ(browser.open("file://" + (folder.path() / "worker.html").string()), "ready");
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "'" : ", '") + name + "'";
    browser.value("window.proofs = {}; for (const name of [" + all +
                  "]) prove(name).then(p => proofs[name] = p, e => proofs[name] = {failed: String(e)}); 0");
    ASSERT_TRUE(browser.comes("Object.keys(proofs).length === " + std::to_string(names.size()), 300));
    for (const std::string& name : names) {
        const Json proof = browser.value("proofs['" + name + "']");
        ASSERT_FALSE(proof.contains("failed")) << name << ": " << proof["failed"];
        EXPECT_EQ(proof["exact"], true) << name;
        const std::string text = asset("recordings/" + name + ".couloir");
        const auto end = text.rfind("\"end\"");
        EXPECT_NE(text.find(std::to_string(proof["until"].get<std::int64_t>()), end), std::string::npos)
            << name << " up to " << proof["until"];
    }
}

// Mean time of a whole tick and all that a reader says of damage are the program's own (tests/game/live_world.cpp).
TEST(LiveModule, says_what_is_wrong_with_a_recording) {
    if (!installed_chromium()) GTEST_SKIP() << "chromium is not installed";
    const support::TemporaryFolder folder;
    write_bytes(folder.path() / "worker.html", page_of_worker({"landslide"}));
    Chromium browser;
    ASSERT_EQ(browser.open("file://" + (folder.path() / "worker.html").string()), "ready");
    const auto sentence = [&](const std::string& text) {
        return browser.value("prove('mine', " + text + ").then(() => 'opened', failed => String(failed))")
            .get<std::string>();
    };
    const std::string whole = "new TextDecoder().decode(bytesOf('landslide'))";
    EXPECT_EQ(sentence("''"), "mine: empty");
    EXPECT_EQ(sentence("'nonsense'"), "mine:1: not a couloir recording");
    EXPECT_TRUE(sentence(whole + ".replace('\"tick\":12', '\"tick\":13')").starts_with("mine:"))
        << "a changed line";
    EXPECT_TRUE(sentence(whole + ".slice(0, 900)").starts_with("mine:1: "));
    EXPECT_TRUE(sentence(R"('{"format":"couloir",' + '[' .repeat(100000))").starts_with("mine:1: "));
}

class LivePage : public BrowserTest {
  protected:
    // Opens a page with a small picture at a tick, and takes it over.
    static void take_over(const std::string& page, int tick, int width = 640, int height = 480,
                          bool touch = false) {
        browser().size(width, height, 1, touch);
        ASSERT_EQ(browser().open(file_of(page)), "ready") << text("note");
        browser().value("couloir.freeze(0.25), couloir.seek(" + std::to_string(tick) + ")");
        browser().press("t");
        ASSERT_TRUE(browser().comes("couloir.live.on", 60)) << text("told");
    }
    // Opens a page whose world cannot be taken over, and asks for it until a sentence is shown.
    static void ask_in_vain(const std::string& address) {
        browser().size(640, 480);
        ASSERT_EQ(browser().open(address), "ready") << text("note");
        browser().value("couloir.freeze(0.25)");
        browser().press("t");
        EXPECT_TRUE(browser().comes("document.getElementById('told').checkVisibility()", 20));
    }
    // Saves what was done; the program proves it. Returns what it prints.
    static std::string proven(const std::vector<std::string>& more = {"--verify"}) {
        const std::string recording =
            browser().value("couloir.live.recorded().then(file => file.text())").get<std::string>();
        const auto path = shared_->folder.path() / "mine.couloir";
        write_bytes(path, recording);
        std::vector<std::string> arguments{"replay", path.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished done = couloir(arguments);
        EXPECT_EQ(done.status, 0) << done.err;
        return done.out;
    }
    // Where ground of the slide is seen, px: beside the middle of the picture.
    static std::pair<double, double> ground(double across, double down) {
        const Json at = browser().value(
            "(() => { const {clientWidth: w, clientHeight: h} = document.getElementById('view');"
            "for (let k = 0; k < 40; ++k) { const x = w * (" +
            std::to_string(across) + " + 0.005 * k), y = h * (" + std::to_string(down) +
            " + 0.008 * k);"
            "if (couloir.pick(x, y) && document.elementFromPoint(x, y).id === 'view') return [x, y]; } "
            "return null; })()");
        EXPECT_FALSE(at.is_null()) << "no ground is seen";
        return at.is_null() ? std::pair(0., 0.) : std::pair(at[0].get<double>(), at[1].get<double>());
    }

    static const SharedSlide& avalanche() {
        static const SharedSlide slide = share_slide("winter-avalanche", 303);
        return slide;
    }
};

TEST_F(LivePage, is_taken_over_and_every_tool_by_mouse_is_proven_by_the_program) {
    take_over(avalanche().page, 0);
    browser().press(" ");  // under a flow the ground cannot be changed
    EXPECT_EQ(browser().value("couloir.live.facts.tools.map(tool => tool.key).join('')"), "123456789RC");
    for (const char* key : {"4", "5", "6", "7", "8", "9", "r", "c", "1", "2", "3"}) {
        SCOPED_TRACE(key);
        browser().press(key);
        const int before = browser().value("couloir.live.status.undo").get<int>();
        const auto [x, y] = ground(0.3 + 0.015 * before, 0.2);
        browser().drag(x, y, x + 60, y + 20);
        EXPECT_TRUE(browser().comes("couloir.live.status.undo === " + std::to_string(before + 1), 20))
            << text("told");
    }
    browser().value("document.getElementById('undo').click()");
    EXPECT_TRUE(browser().comes("couloir.live.status.redo === 1", 20));
    browser().value("document.getElementById('redo').click()");
    EXPECT_TRUE(browser().comes("couloir.live.status.redo === 0 && !couloir.live.status.looks_back", 20));
    const std::string said = proven();
    EXPECT_NE(said.find("exact: all"), std::string::npos) << said;
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
    for (const std::string& request : browser().requests())
        EXPECT_TRUE(request.starts_with("file://") || request.starts_with("blob:")) << request;
}

TEST_F(LivePage, shows_exactly_what_the_world_has) {
    take_over(avalanche().page, 150);
    browser().press(" ");
    browser().press("2");
    const auto [x, y] = ground(0.4, 0.25);
    browser().drag(x, y, x + 20, y + 10);
    browser().comes("couloir.live.status.undo === 1 && !couloir.live.running", 20);
    const Json shown = browser().value(
        "(() => { const {slide} = couloir.live; return {tick: slide.tick, rolling: [...slide.rolling], "
        "depth: [...slide.depth]}; })()");
    const std::string recording =
        browser().value("couloir.live.recorded().then(file => file.text())").get<std::string>();
    const support::TemporaryFolder folder;
    write_bytes(folder.path() / "mine.couloir", recording);
    const Finished done =
        couloir({"replay", (folder.path() / "mine.couloir").string(), "--verify", "--json"});
    EXPECT_EQ(done.status, 0) << done.err;
    double volume = 0;
    for (const auto& each : shown["rolling"]) volume += each.get<double>();
    EXPECT_GT(volume, 0);
    EXPECT_EQ(shown["rolling"].size(), 49u * 49u);
    // What flows has its own triangles, and they are drawn otherwise than what a page makes of a recorded slide.
    EXPECT_TRUE(holds("couloir.live.slide.flow.indices.length > 30"));
    EXPECT_TRUE(
        holds("Math.max(...couloir.live.slide.flow.indices) < couloir.live.slide.flow.vertices.length / 20"));
    EXPECT_TRUE(holds(R"((() => {
        const {page, slide} = couloir.live, {picture} = page;
        const drawn = () => { picture.draw({view: page.view()}); return picture.pixels().bytes; };
        const carried = drawn(), {flow} = slide;
        slide.flow = undefined;
        const other = drawn();
        slide.flow = flow;
        return carried.some((byte, i) => Math.abs(byte - other[i]) > 8) && drawn().every((byte, i) => byte === carried[i]);
    })())"));
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

// In a world in which nothing was built before.
TEST_F(LivePage, shows_the_ground_and_the_forest_as_they_were_once_that_is_undone) {
    take_over(share_slide("landslide", 6).page, 0);
    const auto has = [](const std::string& what) {
        return browser().comes("(() => { const {slide} = couloir.live; return " + what + "; })()", 20);
    };
    for (const auto& [key, made] : {std::pair("4", "slide.earth?.some(rise => rise !== 0) ?? false"),
                                    std::pair("7", "slide.planted?.trees.length > 0")}) {
        SCOPED_TRACE(key);
        browser().press(key);
        const auto [x, y] = ground(0.4, 0.4);
        browser().drag(x, y, x + 40, y + 10);
        EXPECT_TRUE(has(made)) << text("told");
        browser().value("document.getElementById('undo').click()");
        EXPECT_TRUE(has("slide.tick === couloir.live.status.tick && couloir.live.status.undo === 0"));
        EXPECT_TRUE(has("!(" + std::string(made) + ")"));
    }
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

TEST_F(LivePage, acts_under_one_finger_and_turns_under_two) {
    take_over(avalanche().page, 60, 390, 780, true);
    const auto [x, y] = ground(0.4, 0.25);
    browser().tap(x, y);
    EXPECT_TRUE(browser().comes("couloir.live.status.undo === 1", 20));
    const Json before = browser().value("couloir.camera.azimuth ?? couloir.camera.goal.azimuth");
    browser().pinch(x, y, 40, 40, 80, 60);
    EXPECT_TRUE(browser().comes("!couloir.live.held", 20));
    EXPECT_NE(browser().value("couloir.camera.azimuth ?? couloir.camera.goal.azimuth"), before)
        << "two fingers turn the view";
    EXPECT_NE(proven().find("exact: all"), std::string::npos);
}

TEST_F(LivePage, fits_large_small_and_touched_screens) {
    struct Screen {
        int width, height;
        bool touch;
    };
    for (const Screen& screen : {Screen{390, 844, true}, Screen{844, 390, true}, Screen{1280, 720, false},
                                 Screen{1920, 1080, false}}) {
        SCOPED_TRACE(std::to_string(screen.width));
        if (screen.width == 390)
            take_over(avalanche().page, 60, screen.width, screen.height, screen.touch);
        else
            browser().size(screen.width, screen.height, 1, screen.touch);
        EXPECT_EQ(browser().value("document.documentElement.scrollWidth"), screen.width);
        EXPECT_EQ(
            browser().value(
                R"([...document.querySelectorAll('footer, #live, #deeds button, #tools, footer button, #settings')]
            .filter(each => each.checkVisibility()).filter(each => {
                const {left, top, right, bottom, width} = each.getBoundingClientRect();
                return !(width > 0 && left >= 0 && top >= 0 && right <= innerWidth + 0.5 && bottom <= innerHeight + 0.5);
            }).map(each => each.id || each.textContent))"),
            Json::array());
        EXPECT_TRUE(
            holds("document.getElementById('live').getBoundingClientRect().bottom <= "
                  "document.querySelector('footer').getBoundingClientRect().top"));
        EXPECT_TRUE(holds("document.getElementById('live').getBoundingClientRect().top > 0.3 * innerHeight"))
            << "ground is left to act on";
    }
}

TEST_F(LivePage, goes_back_continues_from_there_and_outlives_a_lost_context) {
    take_over(avalanche().page, 150);
    EXPECT_TRUE(browser().comes("couloir.live.status.known > 200", 60));
    browser().press(" ");
    browser().value("couloir.seek(60)");
    EXPECT_TRUE(browser().comes("couloir.live.status.tick === 60 && couloir.live.status.looks_back", 20));
    const auto [x, y] = ground(0.4, 0.25);
    browser().drag(x, y, x + 10, y + 5);
    EXPECT_TRUE(browser().comes("document.getElementById('told').checkVisibility()", 20));
    EXPECT_TRUE(text("told").starts_with("This is the past.")) << text("told");
    EXPECT_EQ(browser().value("couloir.live.status.undo"), 0);
    browser().value("document.getElementById('continue').click()");
    EXPECT_TRUE(browser().comes("couloir.live.status.known === 60", 20)) << text("told");
    browser().value(R"((async () => {
        const lost = document.getElementById('view').getContext('webgl2').getExtension('WEBGL_lose_context');
        lost.loseContext();
        await new Promise(resolve => setTimeout(resolve, 300));
        lost.restoreContext();
    })())");
    EXPECT_TRUE(browser().comes(
        "document.documentElement.dataset.state === 'ready' && document.getElementById('note').hidden", 60));
    browser().value("couloir.freeze(0.25)");
    browser().drag(x, y, x + 10, y + 5);
    EXPECT_TRUE(browser().comes("couloir.live.status.undo === 1", 20)) << text("told");
    EXPECT_NE(proven().find("exact: all"), std::string::npos);
}

TEST_F(LivePage, is_taken_over_from_a_plain_and_from_a_strict_server_by_one_request) {
    for (const char* headers :
         {"",
          "Content-Security-Policy: default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; "
          "style-src "
          "'unsafe-inline'; img-src data:; worker-src blob:\r\nX-Content-Type-Options: nosniff\r\n"
          "Cross-Origin-Opener-Policy: same-origin\r\nCross-Origin-Embedder-Policy: require-corp\r\n"}) {
        SCOPED_TRACE(headers);
        const Loopback server(avalanche().page, headers);
        browser().size(640, 480);
        ASSERT_EQ(browser().open(server.address()), "ready") << text("note");
        browser().value("couloir.freeze(0.25), couloir.seek(0)");
        browser().press("t");
        EXPECT_TRUE(browser().comes("couloir.live.on", 60)) << text("told");
        EXPECT_EQ(server.requests(), 1);
        EXPECT_EQ(browser().messages(), std::vector<std::string>());
    }
}

// A server whose policy forbids modules.
TEST_F(LivePage, plays_back_with_a_sentence_where_a_policy_forbids_its_world) {
    const Loopback server(avalanche().page,
                          "Content-Security-Policy: script-src 'unsafe-inline'; worker-src blob:\r\n");
    ask_in_vain(server.address());
    EXPECT_NE(text("told").find("can be watched only"), std::string::npos) << text("told");
    browser().press("Home");
    EXPECT_EQ(browser().value("couloir.tick"), 0);
}

TEST_F(LivePage, plays_back_with_a_sentence_where_its_world_is_damaged) {
    std::string page = avalanche().page;
    const auto at = page.find("id=\"world\">") + 2000;
    page.replace(at, 8, "AAAAAAAA");
    ask_in_vain(file_of(page));
    EXPECT_EQ(
        text("told"),
        "The world in this page is damaged, so it can be watched only. Copy or download the file again.");
    browser().press("Home");
    EXPECT_EQ(browser().value("couloir.tick"), 0);
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

// Runs `words` in the worker before its own.
class InWorker {
  public:
    InWorker(Chromium& browser, const std::string& words)
        : browser_(browser),
          script_(browser.call("Page.addScriptToEvaluateOnNewDocument",
                               {{"source",
                                 "globalThis.Blob = class extends Blob { constructor(parts, options) { "
                                 "super(options?.type === 'text/javascript' ? [" +
                                     Json(words).dump() + ", ...parts] : parts, options); } };"}})) {}
    ~InWorker() { browser_.call("Page.removeScriptToEvaluateOnNewDocument", script_); }
    InWorker(const InWorker&) = delete;
    InWorker& operator=(const InWorker&) = delete;

  private:
    Chromium& browser_;
    Json script_;
};

TEST_F(LivePage, plays_back_with_a_sentence_where_memory_for_its_world_is_refused) {
    const InWorker refuses(browser(),
                           "WebAssembly.instantiate = async () => { throw new RangeError('no memory'); };");
    ask_in_vain(file_of(avalanche().page));
    EXPECT_EQ(
        text("told"),
        "This slide can be watched only: the browser refuses memory for the world in this page (no memory)");
    browser().press("End");
    EXPECT_GT(browser().value("couloir.tick"), 0);
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

// The module may take less memory than its world comes to need.
TEST_F(LivePage, keeps_what_was_done_when_no_memory_is_left) {
    const InWorker bounds(browser(), R"(
        const compile = WebAssembly.compile;
        WebAssembly.compile = bytes => {
            const text = bytes.slice(), number = at => {  // LEB128; returns the value and where it ends
                let value = 0, shift = 0, byte;
                do byte = text[at++], value |= (byte & 127) << shift, shift += 7; while (byte & 128);
                return [value, at];
            };
            for (let at = 8; at < text.length;) {
                const section = text[at], [size, begin] = number(at + 1);
                if (section === 5) {  // one memory with bounds, in pages of 64 KiB
                    let [, maximum] = number(begin + 2);
                    const [, end] = number(maximum), pages = 380;  // a tenth more than to take over
                    for (let left = pages; maximum < end; left >>= 7) text[maximum] = left & 127 | (++maximum < end ? 128 : 0);
                }
                at = begin + size;
            }
            return compile(text);
        };)");
    take_over(avalanche().page, 150);
    browser().press("2");
    for (int i = 0; i < 60 && holds("!couloir.live.ended"); ++i) {
        const auto [x, y] = ground(0.3 + 0.004 * i, 0.25);
        browser().drag(x, y, x + 30, y + 10);
        browser().comes("Boolean(couloir.live.ended) || couloir.live.status.undo > " + std::to_string(i), 20);
    }
    ASSERT_TRUE(browser().comes("Boolean(couloir.live.ended)", 60));
    EXPECT_EQ(text("told"),
              "The world of this page has ended: no memory is left. Save keeps what was done in it. Load the "
              "page again to go on.");
    EXPECT_NE(proven().find("exact: all"), std::string::npos);
    browser().press("Home");  // it is a picture now
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

TEST_F(LivePage, waits_while_nobody_looks_and_outlives_a_frozen_tab) {
    take_over(avalanche().page, 150);
    const auto look = [](bool on) {
        browser().value("Object.defineProperty(document, 'hidden', {configurable: true, value: " +
                        std::string(on ? "false" : "true") +
                        "}), document.dispatchEvent(new Event('visibilitychange'))");
    };
    const auto tick = [] { return browser().value("couloir.live.status.tick").get<int>(); };
    ASSERT_TRUE(browser().comes("couloir.live.status.tick > 160", 20));
    look(false);
    ASSERT_TRUE(browser().comes("!couloir.live.running", 20));
    const int left = tick();
    std::this_thread::sleep_for(std::chrono::seconds(2));
    EXPECT_EQ(tick(), left);
    look(true);
    EXPECT_TRUE(browser().comes("couloir.live.status.tick > " + std::to_string(left), 20)) << text("told");
    EXPECT_LT(tick(), left + 100) << "what was slept through is not computed";

    browser().call("Page.setWebLifecycleState", {{"state", "frozen"}});
    std::this_thread::sleep_for(std::chrono::seconds(1));
    browser().call("Page.setWebLifecycleState", {{"state", "active"}});
    EXPECT_EQ(browser().value("couloir.live.ended"), Json());
    EXPECT_NE(proven().find("exact: all"), std::string::npos);
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
}

TEST_F(LivePage, is_watched_only_where_there_is_no_web_assembly) {
    const Json script = browser().call("Page.addScriptToEvaluateOnNewDocument",
                                       {{"source", "delete globalThis.WebAssembly"}});
    browser().size(640, 480);
    EXPECT_EQ(browser().open(file_of(avalanche().page)), "ready");
    EXPECT_EQ(browser().value("couloir.live"), Json());
    EXPECT_TRUE(holds("!document.getElementById('take-over').checkVisibility()"));
    EXPECT_EQ(browser().messages(), std::vector<std::string>());
    browser().call("Page.removeScriptToEvaluateOnNewDocument", script);
}

}  // namespace
}  // namespace game::test
