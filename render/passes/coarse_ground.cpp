#include "render/passes/coarse_ground.h"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/shaders/slots.glsl"
#include "render/gl/scoped_state.h"

namespace render {

tl::expected<CoarseGround, std::string> CoarseGround::create(const std::filesystem::path& shaders) {
    auto reduce = FullscreenPass::create(shaders, {"slots.glsl", "scene_depth.glsl", "coarse_depth.frag"});
    if (!reduce) return tl::unexpected(reduce.error());
    const auto spread = [&](std::vector<std::string_view> marks) {
        std::vector<std::string_view> files{
            "slots.glsl",      "frame.glsl",  "undated.glsl",     "light.glsl",         "ground.glsl",
            "tone_curve.glsl", "spline.glsl", "scene_depth.glsl", "surface_place.glsl", "coarse_spread.frag"};
        files.insert(files.end(), marks.begin(), marks.end());
        return RectanglePass::create(shaders, files);
    };
    auto plain = spread({"marks_none.glsl"}), marked = spread({"marks.glsl", "overlay_none.glsl"});
    if (!plain) return tl::unexpected(plain.error());
    if (!marked) return tl::unexpected(marked.error());
    CoarseGround ground;
    ground.reduce_ = std::move(*reduce);
    ground.plain_ = std::move(*plain);
    ground.marked_ = std::move(*marked);
    return ground;
}

void CoarseGround::begin(const Target& frame) const {
    frame.bind_scene(SLOT_COLOUR, SLOT_SCENE_DEPTH);
    const std::array<Rectangle, 1> all{target_.all()};
    target_.begin_scene(all);
    constexpr std::array<float, 4> kNothing{0, 0, 0, 0};  // where no ground is, because filters round
    glClearBufferfv(GL_COLOR, 0, kNothing.data());
    const Enabled depth_test(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    reduce_.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_GEQUAL);
}

void CoarseGround::spread(const Target& frame, bool marked) {
    target_.bind_scene(SLOT_COLOUR, SLOT_COARSE_DEPTH);
    frame.begin_shading();
    const std::array<Rectangle, 1> all{frame.all()};
    all_.send(all, frame.samples_across(), frame.samples_up());
    (marked ? marked_ : plain_).draw_on(all_, all);
}

}  // namespace render
