#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/base/outcome.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "render/gl/draw_times.h"
#include "render/mountain/surroundings.h"
#include "render/pictures/picture.h"
#include "render/view/camera.h"

namespace game {

struct PictureSize {
    int width = 1280, height = 720;  // pixels, 16 to 8192
};

// File names of the images of a run or a replay, with * for
// any characters: ticks, maps, the divergence of two runs.
inline const std::vector<std::string> kFrameNames{"tick_*.png", "map_*.png", "desync.png"};

// A camera straight above the middle, just high enough to see all of the ground, with north up. `aspect`: of the image,
// width / height.
render::Camera map_camera(const sim::View& world, double aspect);

// Draws a world into images without a window, and writes numbered ones while the world continues.
class Gallery {
  public:
    // `gl` as in render::HeadlessContext::create. Makes `folder`; without one, only image() draws.
    // Errors: no GL, or the folder cannot be written (status 3).
    static Outcome<Gallery> open(const std::optional<std::filesystem::path>& folder, PictureSize size,
                                 const std::string& gl, const Scenario& scenario);
    ~Gallery();
    Gallery(Gallery&&) noexcept;
    Gallery& operator=(Gallery&&) noexcept;

    // Draws the world now, with the advected texture, if any, and queues the image to be written as NAME.png.
    // Returns the time of each stage, without the read-back.
    render::DrawTimes draw(const Session& session, const std::string& name);
    // Seen from straight above, with north up.
    render::DrawTimes draw_map(const sim::View& world, const std::string& name);
    // The world now as `camera` sees it, without a file.
    render::Picture image(const Session& session, const render::Camera& camera);
    // What the user should know of the frames; may be empty.
    std::string notice() const;
    // Waits for the last image. Errors: one could not be written (status 3).
    Outcome<void> close();

    std::string renderer_name() const;
    render::DrawnBy drawn_by() const;
    int pictures() const;
    PictureSize size() const;
    const render::Surroundings& surroundings() const;

  private:
    struct Parts;
    explicit Gallery(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace game
