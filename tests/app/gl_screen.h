#pragma once

#include "render/gl/context.h"
#include "render/gl/gl_handle.h"
#include "render/pictures/picture.h"
#include "tests/support/scripted_screen.h"

namespace app_test {

// A scripted screen with OpenGL, whose frames can be read. A frame takes a sixtieth of a second.
class GlScreen final : public support::ScriptedScreen {
  public:
    GlScreen(int width, int height);  // throws without GL 4.5

    void resize_to(int width, int height);  // 0 × 0: minimised
    render::Picture picture() const;        // as shown last

    void present() override;
    std::string renderer_name() const override { return render::renderer_name(); }

  private:
    render::HeadlessContext context_;
    render::Texture colour_;
    render::Framebuffer framebuffer_;
};

}  // namespace app_test
