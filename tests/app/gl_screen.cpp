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
    resize(width, height);
}

void GlScreen::drop(std::filesystem::path path) {
    dropped_ = {std::move(path)};
    give(game::DropEvent{});
}

void GlScreen::resize(int width, int height) {
    size_ = {width, height, 1};
    if (width == 0) return;
    colour_ = render::make_texture(GL_RGBA8, width, height, GL_NEAREST);
    framebuffer_ = render::make_framebuffer();
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
}

render::Picture GlScreen::picture() const {
    const auto row = static_cast<std::ptrdiff_t>(3) * size_.width;
    render::Picture picture{size_.width, size_.height,
                            std::vector<std::uint8_t>(static_cast<std::size_t>(row * size_.height))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(colour_.name(), 0, GL_RGB, GL_UNSIGNED_BYTE, static_cast<GLsizei>(picture.pixels.size()),
                      picture.pixels.data());
    for (int y = 0; y < size_.height / 2; ++y)
        std::swap_ranges(picture.pixels.begin() + y * row, picture.pixels.begin() + (y + 1) * row,
                         picture.pixels.begin() + (size_.height - 1 - y) * row);
    return picture;
}

std::span<const game::Event> GlScreen::poll() {
    given_.swap(waiting_);
    waiting_.clear();
    return given_;
}

void GlScreen::present() {
    ++shown;
    seconds_ += frame_s;
}

}  // namespace app_test
