#pragma once

#include <memory>
#include <string>

#include "game/analysis/gallery.h"
#include "game/base/outcome.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "render/gl/draw_times.h"

namespace game {

// How frames are drawn off screen to be timed.
struct CanvasOptions {
    PictureSize size{640, 360};
    std::string gl = "auto";  // as in render::HeadlessContext::create
    int samples = 1;          // along the edge of a pixel, 1 or 2
    bool turns = false;       // the camera, a little from frame to frame, so that all of each is new
};

// Draws frames off screen as fast as possible, and times them.
class Canvas {
  public:
    // Errors: no GL (status 3).
    static Outcome<Canvas> open(const CanvasOptions& options);
    ~Canvas();
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;

    // Sets camera, light, look and first depth of the following frames from
    // a scenario. Errors: a texture is missing (status 3).
    Outcome<void> show(const Scenario& scenario);
    // Draws one frame and waits for it.
    render::DrawTimes draw(const Session& session);

    render::DrawnBy drawn_by() const;

  private:
    struct Parts;
    explicit Canvas(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace game
