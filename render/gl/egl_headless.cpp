#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include "render/gl/context.h"

namespace render {

struct HeadlessContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

namespace {

using Outcome = tl::expected<std::pair<EGLDisplay, EGLContext>, std::string>;

std::vector<EGLDeviceEXT> devices() {
    EGLint count = 0;
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base"))
        return {};
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
    if (!eglQueryDevicesEXT(count, found.data(), &count)) return {};
    found.resize(static_cast<std::size_t>(count));
    return found;
}

bool is_hardware(EGLDeviceEXT device) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return extensions != nullptr &&
           std::string_view(extensions).find("EGL_MESA_device_software") == std::string_view::npos;
}

// Makes a 4.5 core context on a display current. An error names what is missing and the way that was tried.
Outcome make_current(EGLDisplay display, const std::string& way) {
    const auto missing = [&](const char* what) { return tl::unexpected(fmt::format("{}: {}", way, what)); };
    if (display == EGL_NO_DISPLAY) return missing("no EGL display");
    if (!eglInitialize(display, nullptr, nullptr)) return missing("the EGL display does not start");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (epoxy_has_egl_extension(display, "EGL_KHR_no_config_context") &&
        epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") && eglBindAPI(EGL_OPENGL_API))
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    const bool current =
        context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    if (current && epoxy_gl_version() >= 45) return std::pair(display, context);
    if (current) eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
    return missing("no OpenGL 4.5 core context without a window");
}

Outcome open_surfaceless() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return tl::unexpected(std::string("surfaceless: EGL_MESA_platform_surfaceless is missing"));
    return make_current(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
                        "surfaceless");
}

Outcome open_device(std::size_t index) {
    const std::vector<EGLDeviceEXT> all = devices();
    if (index >= all.size())
        return tl::unexpected(
            fmt::format("device:{}: EGL has {} devices, counted from 0", index, all.size()));
    return make_current(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, all[index], nullptr),
                        fmt::format("device:{}", index));
}

Outcome open_any() {
    std::string tried;
    const std::vector<EGLDeviceEXT> all = devices();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!is_hardware(all[i])) continue;
        Outcome outcome = open_device(i);
        if (outcome) return outcome;
        tried += outcome.error() + "; ";
    }
    Outcome outcome = open_surfaceless();
    if (outcome) return outcome;
    return tl::unexpected(fmt::format("no headless OpenGL: {}{}", tried, outcome.error()));
}

Outcome open(std::string_view which) {
    if (which == "auto") return open_any();
    if (which == "surfaceless") return open_surfaceless();
    if (which == "device") return open_device(0);
    std::size_t index = 0;
    if (constexpr std::string_view kPrefix = "device:"; which.substr(0, kPrefix.size()) == kPrefix) {
        const char* end = which.data() + which.size();
        auto [stopped, error] = std::from_chars(which.data() + kPrefix.size(), end, index);
        if (error == std::errc{} && stopped == end) return open_device(index);
    }
    return tl::unexpected(fmt::format(
        "'{}' is not a headless OpenGL backend: use auto, surfaceless, device or device:N", which));
}

}  // namespace

tl::expected<HeadlessContext, std::string> HeadlessContext::create(std::string_view which) {
    const Outcome outcome = open(which);
    if (!outcome) return tl::unexpected(outcome.error());
    auto handles = std::make_unique<Handles>();
    handles->display = outcome->first;
    handles->context = outcome->second;
    return HeadlessContext(std::move(handles));
}

HeadlessContext::HeadlessContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
HeadlessContext::~HeadlessContext() = default;
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;

std::string HeadlessContext::renderer_name() const {
    return render::renderer_name();
}

}  // namespace render
