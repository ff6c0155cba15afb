#include "game/app/window.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <thread>

#include <epoxy/gl.h>
#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "game/base/one_line.h"
#include "render/gl/context.h"

namespace game {
namespace {

constexpr int kLeastWidth = 480, kLeastHeight = 270;  // of the window; panels are unreadable below this
constexpr int kUsualRate = 60;                        // Hz, for a monitor that reports no rate
constexpr std::size_t kEventsPerFrame = 1024;         // room for a fast mouse and a slow frame

struct NamedKey {
    int glfw;
    Key key;
};
constexpr NamedKey kNamedKeys[] = {
    {GLFW_KEY_ESCAPE, Key::kEscape},
    {GLFW_KEY_ENTER, Key::kEnter},
    {GLFW_KEY_KP_ENTER, Key::kEnter},
    {GLFW_KEY_TAB, Key::kTab},
    {GLFW_KEY_BACKSPACE, Key::kBackspace},
    {GLFW_KEY_DELETE, Key::kDelete},
    {GLFW_KEY_LEFT, Key::kLeft},
    {GLFW_KEY_RIGHT, Key::kRight},
    {GLFW_KEY_UP, Key::kUp},
    {GLFW_KEY_DOWN, Key::kDown},
    {GLFW_KEY_HOME, Key::kHome},
    {GLFW_KEY_END, Key::kEnd},
    {GLFW_KEY_PAGE_UP, Key::kPageUp},
    {GLFW_KEY_PAGE_DOWN, Key::kPageDown},
    {GLFW_KEY_LEFT_SHIFT, Key::kShift},
    {GLFW_KEY_RIGHT_SHIFT, Key::kShift},
    {GLFW_KEY_LEFT_CONTROL, Key::kControl},
    {GLFW_KEY_RIGHT_CONTROL, Key::kControl},
    {GLFW_KEY_LEFT_ALT, Key::kAlt},
    {GLFW_KEY_KP_ADD, Key::kEqual},
    {GLFW_KEY_KP_SUBTRACT, Key::kMinus},
    {GLFW_KEY_KP_DECIMAL, Key::kPeriod},
};

static_assert(GLFW_KEY_A == 'A' && GLFW_KEY_WORLD_1 == static_cast<int>(Key::kExtra1) &&
                  GLFW_KEY_WORLD_2 == static_cast<int>(Key::kExtra2),
              "keys that print have one number here and there");

bool prints(int glfw_key) {
    return glfw_key <= GLFW_KEY_WORLD_2 && KeyboardLayout::is_place(static_cast<Key>(glfw_key));
}

// Of a key that prints nothing, or lies on the keypad.
Key key_of(int glfw_key) {
    if (glfw_key == GLFW_KEY_SPACE) return Key::kSpace;
    if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F12) return function_key(glfw_key - GLFW_KEY_F1 + 1);
    if (glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_9)
        return key(static_cast<char>('0' + glfw_key - GLFW_KEY_KP_0));
    const auto* named = std::find_if(std::begin(kNamedKeys), std::end(kNamedKeys),
                                     [&](const NamedKey& candidate) { return candidate.glfw == glfw_key; });
    return named == std::end(kNamedKeys) ? Key::kNone : named->key;
}

// The character that a key prints alone; 0 if there is none.
char32_t printed_on(int glfw_key) {
    const char* const name = glfwGetKeyName(glfw_key, 0);
    if (name == nullptr) return 0;
    const auto byte = [name](int i) { return static_cast<unsigned char>(name[i]); };
    const int more = byte(0) < 0x80 ? 0 : byte(0) < 0xe0 ? 1 : byte(0) < 0xf0 ? 2 : 3;
    char32_t character = more == 0 ? byte(0) : byte(0) & (0x3fU >> more);
    for (int i = 1; i <= more; ++i) {
        if ((byte(i) & 0xc0U) != 0x80) return 0;
        character = character << 6 | (byte(i) & 0x3fU);
    }
    return byte(more + 1) == 0 ? character : 0;  // several characters are none
}

KeyboardLayout layout_now() {
    KeyboardLayout::Printed printed{};
    for (std::size_t place = 0; place < printed.size(); ++place)
        if (prints(static_cast<int>(place))) printed[place] = printed_on(static_cast<int>(place));
    return KeyboardLayout(printed);
}

Modifiers modifiers(int bits) {
    return {(bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_ALT) != 0};
}

// For events that do not carry modifiers.
Modifiers modifiers_held(GLFWwindow* window) {
    const auto held = [&](int left, int right) {
        return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
    };
    return {held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
            held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL), held(GLFW_KEY_LEFT_ALT, GLFW_KEY_LEFT_ALT)};
}

// Whether the right Alt key is held as AltGr, which X11 reports as no modifier and Windows as Ctrl+Alt.
bool is_alt_gr(GLFWwindow* window, Modifiers with) {
    return glfwGetKey(window, GLFW_KEY_RIGHT_ALT) == GLFW_PRESS && with.alt == with.control;
}

std::optional<Button> button_of(int glfw_button) {
    switch (glfw_button) {
        case GLFW_MOUSE_BUTTON_LEFT:
            return Button::kLeft;
        case GLFW_MOUSE_BUTTON_RIGHT:
            return Button::kRight;
        case GLFW_MOUSE_BUTTON_MIDDLE:
            return Button::kMiddle;
        default:
            return std::nullopt;
    }
}

// The monitor that shows a point of the desktop; else the primary monitor; null if there is no monitor.
GLFWmonitor* monitor_at(int x, int y) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        int left = 0, top = 0;
        glfwGetMonitorPos(monitors[i], &left, &top);
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (mode != nullptr && x >= left && x < left + mode->width && y >= top && y < top + mode->height)
            return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

GLFWmonitor* monitor_of(GLFWwindow* window) {
    if (GLFWmonitor* full = glfwGetWindowMonitor(window)) return full;
    int x = 0, y = 0, width = 0, height = 0;
    glfwGetWindowPos(window, &x, &y);
    glfwGetWindowSize(window, &width, &height);
    return monitor_at(x + width / 2, y + height / 2);
}

// GLFW's description of its last error.
std::string last_words() {
    const char* words = nullptr;
    glfwGetError(&words);
    return words == nullptr ? "nothing" : words;
}

std::string display_tried() {
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY"})
        if (const char* value = std::getenv(variable); value != nullptr && *value != '\0')
            return fmt::format("{}={}", variable, value);
    return "no DISPLAY";
}

tl::unexpected<Failure> no_window(std::string_view what, std::string_view why) {
    return machine_fails(fmt::format("no window: {} ({}; {}); to draw without a window, use couloir replay",
                                     what, display_tried(), why));
}

// Whether the primary monitor asks for windows that are larger, and not smaller, than on one of 96 dpi.
bool asks_for_larger_windows() {
    float x = 1, y = 1;
    if (GLFWmonitor* const monitor = glfwGetPrimaryMonitor()) glfwGetMonitorContentScale(monitor, &x, &y);
    return std::max(x, y) > 1;
}

void set_hints(bool reports_resets) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    // Without this hint, a window whose driver was reset would show its last image for ever.
    if (reports_resets) glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_ALPHA_BITS, 0);  // otherwise the desktop may show through
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, asks_for_larger_windows() ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "couloir");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "couloir");
}

// A window whose context reports resets of the driver, if the driver has such contexts.
GLFWwindow* create_window(const std::string& title, int width, int height) {
    GLFWwindow* window = nullptr;
    for (const bool reports_resets : {true, false}) {
        set_hints(reports_resets);
        window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        if (window != nullptr) break;
    }
    return window;
}

int longest_side_of_device() {
    GLint texture = 0;
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    return std::min({texture, viewport[0], viewport[1]});
}

// Exceptions must not pass through GLFW, which is C. If memory runs out here, an event is lost.
template <class Work>
void guarded(Work&& work) noexcept {
    try {
        work();
    } catch (...) {
    }
}

}  // namespace

struct Window::Callbacks {
    static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

    static void take(GLFWwindow* window, const Event& event) {
        guarded([&] {
            of(window).keyboard_.settle(of(window).events_);
            of(window).events_.push_back(event);
        });
    }

    static void on_key(GLFWwindow* window, int glfw_key, int /*scancode*/, int action, int mods) {
        if (glfw_key < 0) return;  // a key unknown to GLFW
        guarded([&] {
            const auto number = static_cast<std::size_t>(glfw_key);
            Keyboard& keyboard = of(window).keyboard_;
            auto& events = of(window).events_;
            const Key key = key_of(glfw_key);
            // For a modifier's own key, GLFW reports the modifiers from before the event.
            const bool is_modifier = key == Key::kShift || key == Key::kControl || key == Key::kAlt;
            const Modifiers with = is_modifier ? modifiers_held(window) : modifiers(mods);
            if (action == GLFW_RELEASE) return keyboard.release(number, with, events);
            if (action == GLFW_REPEAT) return keyboard.repeat(number, with, events);
            if (!prints(glfw_key)) return keyboard.press(number, {key, with}, events);
            keyboard.set(layout_now());  // it may change at any time
            keyboard.press(number, static_cast<Key>(glfw_key), with, is_alt_gr(window, with), events);
        });
    }

    static void on_button(GLFWwindow* window, int glfw_button, int action, int mods) {
        if (const auto button = button_of(glfw_button))
            take(window, ButtonEvent{*button, action == GLFW_PRESS, modifiers(mods)});
    }

    static void on_move(GLFWwindow* window, double x, double y) {
        const Window& self = of(window);
        if (self.window_size_.x == 0 || self.window_size_.y == 0) return;
        take(window, MoveEvent{x * self.framebuffer_size_.x / self.window_size_.x,
                               y * self.framebuffer_size_.y / self.window_size_.y});
    }

    static void on_wheel(GLFWwindow* window, double x, double y) {
        take(window, WheelEvent{y, modifiers_held(window), x});
    }

    static void on_text(GLFWwindow* window, unsigned character) {
        guarded([&] { of(window).keyboard_.type(character, of(window).events_); });
    }

    static void on_focus(GLFWwindow* window, int focused) { take(window, FocusEvent{focused == GLFW_TRUE}); }

    static void on_drop(GLFWwindow* window, int count, const char** paths) {
        guarded([&] { of(window).dropped_.assign(paths, paths + count); });
        take(window, DropEvent{});
    }

    // The app decides whether the window closes.
    static void on_close(GLFWwindow* window) {
        glfwSetWindowShouldClose(window, GLFW_FALSE);
        take(window, CloseEvent{});
    }

    static void on_iconify(GLFWwindow* window, int iconified) {
        of(window).iconified_ = iconified == GLFW_TRUE;
    }
    static void on_place(GLFWwindow* window, int /*x*/, int /*y*/) { of(window).follow_monitor(); }
    static void on_size(GLFWwindow* window, int /*width*/, int /*height*/) { of(window).measure(); }
    static void on_scale(GLFWwindow* window, float /*x*/, float /*y*/) { of(window).measure(); }

    static void set(GLFWwindow* window) {
        glfwSetKeyCallback(window, on_key);
        glfwSetMouseButtonCallback(window, on_button);
        glfwSetCursorPosCallback(window, on_move);
        glfwSetScrollCallback(window, on_wheel);
        glfwSetCharCallback(window, on_text);
        glfwSetWindowFocusCallback(window, on_focus);
        glfwSetDropCallback(window, on_drop);
        glfwSetWindowCloseCallback(window, on_close);
        glfwSetWindowIconifyCallback(window, on_iconify);
        glfwSetWindowPosCallback(window, on_place);
        glfwSetWindowSizeCallback(window, on_size);
        glfwSetFramebufferSizeCallback(window, on_size);
        glfwSetWindowContentScaleCallback(window, on_scale);
    }
};

Outcome<std::unique_ptr<Window>> Window::open(const std::string& title, int width, int height) {
#ifdef GLFW_PLATFORM  // since GLFW 3.4, which asks Wayland first
    // Without a folder for its sockets, the Wayland library prints a line itself.
    if (std::getenv("XDG_RUNTIME_DIR") == nullptr) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfwInit() == GLFW_FALSE) return no_window("no display is available", "GLFW: " + last_words());
    GLFWwindow* window = create_window(title, width, height);
    if (window == nullptr) {
        const std::string why = "GLFW: " + last_words();
        glfwTerminate();
        return no_window("the display has no OpenGL 4.5 core context through EGL", why);
    }
    std::unique_ptr<Window> opened(new Window(window));
    if (const int version = epoxy_gl_version(); version < 45)
        return no_window("the OpenGL version of the display is below 4.5", opened->renderer_name());
    return opened;
}

Window::Window(GLFWwindow* window) : window_(window), keyboard_(GLFW_KEY_LAST + 1) {
    events_.reserve(kEventsPerFrame);
    keyboard_.set(layout_now());
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    longest_side_ = longest_side_of_device();
    glfwSetWindowSizeLimits(window_, kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(window_, this);
    Callbacks::set(window_);
    measure();
    follow_monitor();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

// Caches the sizes, because each query goes to the display server and a frame needs them often.
void Window::measure() {
    glfwGetWindowSize(window_, &window_size_.x, &window_size_.y);
    glfwGetFramebufferSize(window_, &framebuffer_size_.x, &framebuffer_size_.y);
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    scale_ = static_cast<double>(std::max(x, y));
}

// Rates are reported in whole hertz, 59.94 as 59. Adding one keeps this limit from delaying a synchronised
// swap.
void Window::follow_monitor() {
    GLFWmonitor* monitor = monitor_of(window_);
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    const int rate = mode == nullptr || mode->refreshRate <= 0 ? kUsualRate : mode->refreshRate + 1;
    period_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / rate));
}

std::span<const Event> Window::poll() {
    events_.clear();
    if (minimised())
        glfwWaitEventsTimeout(0.1);
    else
        glfwPollEvents();
    keyboard_.settle(events_);
    if (!events_.empty()) keyboard_.set(layout_now());  // another one is chosen by an event
    read_pad();
    return events_;
}

void Window::read_pad() {
    static_assert(kPadButtons == GLFW_GAMEPAD_BUTTON_LAST + 1 && kPadAxes == GLFW_GAMEPAD_AXIS_LAST + 1);
    pad_.reset();
    for (int number = GLFW_JOYSTICK_1; number <= GLFW_JOYSTICK_LAST && !pad_; ++number) {
        GLFWgamepadstate state;
        if (glfwGetGamepadState(number, &state) != GLFW_TRUE) continue;
        pad_.emplace();
        pad_number_ = number;
        std::ranges::copy(state.axes, pad_->axes.begin());
        std::ranges::transform(state.buttons, pad_->buttons.begin(),
                               [](unsigned char button) { return button == GLFW_PRESS; });
    }
}

std::string Window::pad_name() const {
    const char* const name = pad_ ? glfwGetGamepadName(pad_number_) : nullptr;
    return name ? name : "";
}

ScreenSize Window::size() const {
    if (minimised()) return {0, 0, scale_};
    return {framebuffer_size_.x, framebuffer_size_.y, scale_};
}

double Window::seconds() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void Window::present() {
    glfwSwapBuffers(window_);
    due_ += period_;
    const auto now = Clock::now();
    if (now < due_)
        std::this_thread::sleep_until(due_);
    else
        due_ = now;
}

DeviceFault Window::device_fault() {
    DeviceFault fault = DeviceFault::kNone;
    // A lost context may return errors without end.
    for (int i = 0; i < 8; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        if (error == GL_CONTEXT_LOST) return DeviceFault::kLost;
        if (error == GL_OUT_OF_MEMORY) fault = DeviceFault::kOutOfMemory;
        if (error == GL_INVALID_FRAMEBUFFER_OPERATION && fault == DeviceFault::kNone)
            fault = DeviceFault::kRefused;
    }
    return glGetGraphicsResetStatus() == GL_NO_ERROR ? fault : DeviceFault::kLost;
}

void Window::show_title(const std::string& title) {
    glfwSetWindowTitle(window_, one_line(title).c_str());
}

void Window::set_fullscreen(bool on) {
    if (on == fullscreen()) return;
    if (!on) {
        glfwSetWindowMonitor(window_, nullptr, place_.x, place_.y, extent_.x, extent_.y, GLFW_DONT_CARE);
        follow_monitor();
        return;
    }
    GLFWmonitor* monitor = monitor_of(window_);
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    glfwGetWindowPos(window_, &place_.x, &place_.y);
    glfwGetWindowSize(window_, &extent_.x, &extent_.y);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    follow_monitor();
}

bool Window::fullscreen() const {
    return glfwGetWindowMonitor(window_) != nullptr;
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(window_);
    return text == nullptr ? std::string() : text;
}

void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}

std::string Window::renderer_name() const {
    return render::renderer_name();
}

}  // namespace game
