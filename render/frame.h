#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "render/camera.h"
#include "render/context.h"
#include "render/draw_times.h"
#include "render/look.h"
#include "render/marks.h"
#include "render/picture.h"
#include "sim/front/flow_view.h"
#include "sim/world/state.h"

namespace render {

enum class Quality {
    kFast,  // one sample per pixel
    kFine,  // two by two, for exported pictures: three to four times the time without a GPU
};

// Draws a world. Needs a current GL 4.5 context, from headless EGL or a window, for as long as it lives.
// Views are read, never kept; nothing flows back into the simulation. A frame depends on the arguments of
// draw() alone.
class Renderer {
  public:
    // `assets` is the folder that holds shaders/. Errors name the shader file and line.
    static tl::expected<Renderer, std::string> create(const std::filesystem::path& assets,
                                                      Quality quality = Quality::kFine);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Before a look with this pattern is drawn, once. Errors: its pictures are missing or damaged.
    tl::expected<void, std::string> load(FlowPattern pattern);

    // For the frames to come.
    void set_quality(Quality quality);

    // All passes, in order, into an offscreen target of the given size in pixels, > 0. `flow` is drawn as
    // look.flow says; its mesh is the heightfield of the world's grid. Without either nothing carries a
    // texture. GL's state is left as it was found, but for bindings of texture units, which are emptied, and
    // of uniform block and image units. Allocates nothing while size, quality and terrain are those of the
    // frame before.
    void draw(const sim::View& world, const Camera& camera, const Light& light, const Look& look,
              const Marks& marks, int width, int height, const sim::front::FlowView* flow = nullptr);

    // The last drawn frame, top row first, sRGB 8 bit, 3 channels. Waits for the frame.
    Picture read_back() const;

    // The last drawn frame, stretched over a framebuffer (0 is the window's) of the given size in pixels,
    // which is left bound for what is drawn on top.
    void show_on(unsigned framebuffer, int width, int height) const;

    // From the next frame on, or no longer. Costs what it waits for.
    void time_stages(Timing timing);
    // Of the last frame, for which it waits. Nothing where none was timed.
    std::optional<DrawTimes> stage_times() const;

    // Until GL has done all that it was told.
    void wait() const;

  private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace render
