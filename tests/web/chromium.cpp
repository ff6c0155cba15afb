#include "tests/web/chromium.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <stdexcept>

#include "tests/game/program.h"

namespace game::test {
namespace {

constexpr double kToAnswer = 240;  // s, on a busy machine that draws in software
constexpr double kBetweenLooks = 0.02;

int open_pipe(const std::filesystem::path& path) {
    // For both directions, so that neither side waits for the other.
    const int descriptor = mkfifo(path.c_str(), 0600) == 0 ? open(path.c_str(), O_RDWR | O_CLOEXEC) : -1;
    if (descriptor < 0) throw std::runtime_error("no pipe");
    return descriptor;
}

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Key codes of Windows, by which the browser knows a key's own action.
int key_code(const std::string& key) {
    static const std::vector<std::pair<std::string, int>> kCodes{
        {"Tab", 9},        {"Enter", 13},   {"Escape", 27},     {" ", 32},         {"End", 35}, {"Home", 36},
        {"ArrowLeft", 37}, {"ArrowUp", 38}, {"ArrowRight", 39}, {"ArrowDown", 40}, {"=", 187},  {"+", 187},
        {",", 188},        {"-", 189},      {".", 190},         {"?", 191}};
    for (const auto& [name, code] : kCodes)
        if (name == key) return code;
    return std::toupper(static_cast<unsigned char>(key[0]));
}

}  // namespace

std::optional<std::string> installed_chromium() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (is_installed(name)) return name;
    return std::nullopt;
}

Chromium::Chromium(const std::vector<std::string>& switches)
    : to_(open_pipe(file("to"))), from_(open_pipe(file("from"))) {
    // The browser reads its descriptor 3 and writes to 4.
    const std::string home = folder_.path().string();
    std::vector<std::string> words{
        "sh", "-c", "exec \"$@\" 3<\"$0/to\" 4>\"$0/from\"", home, installed_chromium().value_or("chromium"),
        "--headless=new", "--remote-debugging-pipe", "--user-data-dir=" + home + "/profile", "--no-first-run",
        "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
        // Nothing but our pages: no update, no lists of addresses, no account.
        "--disable-background-networking", "--disable-component-update", "--disable-sync",
        "--disable-extensions", "--disable-default-apps"};
    words.insert(words.end(), switches.begin(), switches.end());
    words.emplace_back("about:blank");
    browser_ = std::make_unique<Child>(words, Environment{{"HOME", home}, {"DISPLAY", std::nullopt}},
                                       file("out"), file("err"));
    const Json target = call({{"method", "Target.createTarget"}, {"params", {{"url", "about:blank"}}}});
    const Json attached = call({{"method", "Target.attachToTarget"},
                                {"params", {{"targetId", target.at("targetId")}, {"flatten", true}}}});
    session_ = attached.at("sessionId").get<std::string>();
    for (const char* domain : {"Page", "Runtime", "Log", "Network"}) call(std::string(domain) + ".enable");
}

Chromium::~Chromium() {
    try {
        if (!stuck_) {
            call({{"method", "Browser.close"}});
            browser_->wait(kToAnswer);
        }
    } catch (const std::exception&) {  // then it is ended by ~Child()
    }
    browser_.reset();
    close(to_);
    close(from_);
}

Json Chromium::call(const std::string& method, const Json& parameters) {
    return call({{"method", method}, {"params", parameters}, {"sessionId", session_}});
}

Json Chromium::call(Json message) {
    message["id"] = ++last_id_;
    const std::string text = message.dump() + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
        const auto some = write(to_, text.data() + sent, text.size() - sent);
        if (some <= 0) stop("the browser does not listen");
        sent += static_cast<std::size_t>(some);
    }
    for (const double end = seconds_now() + kToAnswer;;) {
        const Json answer = read_message(end - seconds_now());
        if (answer.value("id", 0) != last_id_) {
            keep(answer);
            continue;
        }
        if (answer.contains("error"))
            give_up(message["method"].get<std::string>() + ": " + answer["error"].dump());
        return answer.at("result");
    }
}

Json Chromium::read_message(double seconds) {
    const double end = seconds_now() + seconds;
    std::size_t length = unread_.find('\0');
    while (length == std::string::npos) {
        pollfd asked{from_, POLLIN, 0};
        if (poll(&asked, 1, 200) > 0) {
            std::string some(1 << 16, '\0');
            const auto count = read(from_, some.data(), some.size());
            if (count <= 0) stop("the browser's pipe is closed");
            const std::size_t from = unread_.size();
            unread_.append(some, 0, static_cast<std::size_t>(count));
            length = unread_.find('\0', from);
        } else if (browser_->ended()) {
            stop("the browser ended");
        } else if (seconds_now() > end) {
            stop("the browser does not answer");
        }
    }
    Json message = Json::parse(unread_.substr(0, length));
    unread_.erase(0, length + 1);
    return message;
}

void Chromium::keep(const Json& event) {
    const std::string method = event.value("method", "");
    if (method == "Network.requestWillBeSent")
        requests_.push_back(event["params"]["request"]["url"].get<std::string>());
    if (method == "Runtime.exceptionThrown" || method == "Runtime.consoleAPICalled" ||
        method == "Log.entryAdded")
        messages_.push_back(event["params"].dump());
}

void Chromium::stop(const std::string& what) {
    stuck_ = true;
    give_up(what);
}

void Chromium::give_up(const std::string& what) const {
    throw std::runtime_error(what + "\nThe browser printed: " + read_bytes(file("err")));
}

Json Chromium::value(const std::string& expression) {
    const Json answer = call("Runtime.evaluate",
                             {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
    if (answer.contains("exceptionDetails"))
        throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
    return answer["result"].value("value", Json());
}

void Chromium::size(int width, int height, double pixels, bool touch) {
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", pixels}, {"mobile", touch}});
    call("Emulation.setTouchEmulationEnabled", {{"enabled", touch}});
}

std::string Chromium::open(const std::string& address) {
    call("Page.navigate",
         {{"url", "about:blank"}});  // else an address that differs by its hash is no new page
    comes("location.href === 'about:blank' && document.readyState === 'complete'", kToAnswer);
    messages_.clear();
    requests_.clear();
    call("Page.navigate", {{"url", address}});
    const std::string state = "document.documentElement?.dataset.state ?? ''";
    if (!comes("(" + state + ") !== ''", kToAnswer)) give_up(address + " neither opens nor fails");
    return value(state).get<std::string>();
}

void Chromium::press(const std::string& key, bool shift) {
    const bool prints = key.size() == 1;
    Json event{{"key", key}, {"windowsVirtualKeyCode", key_code(key)}, {"modifiers", shift ? 8 : 0}};
    if (prints) event["text"] = key;
    if (key == "Enter") event["text"] = "\r";
    event["type"] = "keyDown";
    call("Input.dispatchKeyEvent", event);
    event.erase("text");
    event["type"] = "keyUp";
    call("Input.dispatchKeyEvent", event);
}

void Chromium::click(double x, double y) {
    Json event{{"x", x}, {"y", y}};
    for (const char* type : {"mouseMoved", "mousePressed", "mouseReleased"}) {
        event["type"] = type;
        call("Input.dispatchMouseEvent", event);
        event["button"] = "left";
        event["clickCount"] = 1;
    }
}

void Chromium::drag(double from_x, double from_y, double to_x, double to_y, bool shift) {
    constexpr int kSteps = 8;
    const auto send = [&](const char* type, double share, int buttons) {
        call("Input.dispatchMouseEvent", {{"type", type},
                                          {"x", from_x + share * (to_x - from_x)},
                                          {"y", from_y + share * (to_y - from_y)},
                                          {"button", "left"},
                                          {"buttons", buttons},
                                          {"clickCount", 1},
                                          {"modifiers", shift ? 8 : 0}});
    };
    send("mousePressed", 0, 1);
    for (int i = 1; i <= kSteps; ++i) send("mouseMoved", static_cast<double>(i) / kSteps, 1);
    send("mouseReleased", 1, 0);
}

void Chromium::wheel(double x, double y, double pixels) {
    call("Input.dispatchMouseEvent",
         {{"type", "mouseWheel"}, {"x", x}, {"y", y}, {"deltaX", 0}, {"deltaY", pixels}});
}

void Chromium::pinch(double x, double y, double from_x, double from_y, double to_x, double to_y) {
    constexpr int kSteps = 8;
    const auto fingers = [&](double share) {
        return Json{{{"x", x}, {"y", y}, {"id", 1}},
                    {{"x", x + from_x + share * (to_x - from_x)},
                     {"y", y + from_y + share * (to_y - from_y)},
                     {"id", 2}}};
    };
    call("Input.dispatchTouchEvent", {{"type", "touchStart"}, {"touchPoints", fingers(0)}});
    for (int i = 1; i <= kSteps; ++i)
        call("Input.dispatchTouchEvent",
             {{"type", "touchMove"}, {"touchPoints", fingers(static_cast<double>(i) / kSteps)}});
    call("Input.dispatchTouchEvent", {{"type", "touchEnd"}, {"touchPoints", Json::array()}});
}

void Chromium::tap(double x, double y) {
    call("Input.dispatchTouchEvent", {{"type", "touchStart"}, {"touchPoints", {{{"x", x}, {"y", y}}}}});
    call("Input.dispatchTouchEvent", {{"type", "touchEnd"}, {"touchPoints", Json::array()}});
}

bool Chromium::comes(const std::string& expression, double seconds) {
    for (const double end = seconds_now() + seconds; seconds_now() < end; rest(kBetweenLooks))
        if (value(expression) == true) return true;
    return false;
}

std::vector<std::string> Chromium::messages() {
    value("0");  // what came before has arrived
    return messages_;
}

std::vector<std::string> Chromium::requests() {
    value("0");
    return requests_;
}

}  // namespace game::test
