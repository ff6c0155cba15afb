#include "tests/app/gl_screen.h"

#include <algorithm>
#include <stdexcept>

namespace app_test {
namespace {

render::HeadlessContext open_context() {
    auto context = render::HeadlessContext::create("auto");
    if (!context) throw std::runtime_error(context.error());
    return std::move(*context);
}

}  // namespace

GlScreen::GlScreen(int width, int height) : context_(open_context()) {
    resize_to(width, height);
}

void GlScreen::resize_to(int width, int height) {
    resize({width, height, 1});
    if (width == 0) return;
    colour_ = render::make_texture(GL_RGBA8, width, height, GL_NEAREST);
    framebuffer_ = render::make_framebuffer();
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
    draw_into(framebuffer_.name());
}

render::Picture GlScreen::picture() const {
    const auto row = static_cast<std::ptrdiff_t>(3) * size().width;
    render::Picture picture{size().width, size().height,
                            std::vector<std::uint8_t>(static_cast<std::size_t>(row * size().height))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(colour_.name(), 0, GL_RGB, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(picture.pixels.size()), picture.pixels.data());
    for (int y = 0; y < picture.height / 2; ++y)
        std::swap_ranges(picture.pixels.begin() + y * row, picture.pixels.begin() + (y + 1) * row,
                         picture.pixels.begin() + (picture.height - 1 - y) * row);
    return picture;
}

void GlScreen::present() {
    ScriptedScreen::present();
    pass(1.0 / 60);
}

}  // namespace app_test
