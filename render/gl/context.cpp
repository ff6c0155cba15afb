#include "render/gl/context.h"

#include <algorithm>
#include <array>

#include <epoxy/gl.h>

namespace render {
namespace {

std::string_view gl_text(GLenum which) {
    const GLubyte* value = glGetString(which);
    return value == nullptr ? "" : reinterpret_cast<const char*>(value);
}

}  // namespace

std::string renderer_name() {
    return std::string(gl_text(GL_RENDERER)) + ", " + std::string(gl_text(GL_VERSION));
}

bool is_software_renderer() {
    constexpr std::array<std::string_view, 3> kNames{"llvmpipe", "softpipe", "swrast"};
    const std::string_view name = gl_text(GL_RENDERER);
    return std::any_of(kNames.begin(), kNames.end(), [&](std::string_view software) {
        return name.find(software) != std::string_view::npos;
    });
}

}  // namespace render
