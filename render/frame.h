#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "render/frame/frame_input.h"
#include "render/frame/what_changed.h"
#include "render/gl/context.h"
#include "render/gl/draw_times.h"
#include "render/pictures/picture.h"

namespace render {

enum class Quality {
    kMoving,  // one sample per pixel, and light and detail of the ground for every second one along x and y
    kFast,    // one sample per pixel
    kFine,    // two by two, for exported images: takes three to four times as long without a GPU
};

// Draws a world. Needs a current GL 4.5 context, from headless EGL or a window, throughout its lifetime.
// Views are read, never kept, and rendering never affects the simulation. A frame depends only on its
// FrameInput and the quality.
class Renderer {
  public:
    // `assets` is the folder that holds shaders/. Errors name the shader file and line.
    static tl::expected<Renderer, std::string> create(const std::filesystem::path& assets,
                                                      Quality quality = Quality::kFine);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Loads what a world of this look needs: the shaders of its ground and the texture of its flow. Call it before such a
    // world is drawn; nothing is loaded twice. Fails if an image is missing or damaged; errors of shaders are as in create().
    tl::expected<void, std::string> load(const Look& look, bool two_materials);

    // Sets the quality of the following frames.
    void set_quality(Quality quality);

    // Runs all passes, in order, into an offscreen target of the frame's size. GL state is restored, except
    // that texture units are left empty and bindings of uniform blocks and image units may change. Allocates
    // nothing while size, quality and terrain are those of the last frame.
    //
    // While the camera stands still, only those parts are drawn anew that differ from the last frame, to the same bits
    // as if all were: a frame costs what moved.
    void draw(const FrameInput& input);
    // Draws all of the next frame anew.
    void forget();
    // Share of the last frame that was drawn anew, 0 to 1.
    double redrawn() const;
    // Sets how closely frames are redrawn, for tests.
    void set_redraw(const RedrawRules& rules);

    // Returns the last drawn frame, top row first, sRGB 8 bit, 3 channels. Waits for the frame.
    Picture read_back() const;

    // Stretches the last drawn frame over a framebuffer (0 is the window's) of the given size in pixels. The
    // framebuffer stays bound for what is drawn on top.
    void show_on(unsigned framebuffer, int width, int height) const;

    // Sets the timing from the next frame on. Timing adds the cost of its waits.
    void time_stages(Timing timing);
    // Times of the last frame; waits for it. Empty if it was not timed.
    std::optional<DrawTimes> stage_times() const;

    // Waits until GL has finished all commands.
    void wait() const;

  private:
    void draw_ground(const FrameInput& input);

    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace render
