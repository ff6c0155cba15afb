#include "game/app/screenshots.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "game/base/process.h"
#include "game/base/version.h"
#include "game/files/user_folders.h"

namespace game {
namespace {

namespace fs = std::filesystem;

// "47.30012 N 11.43210 E, UTM 32T 683912 5240010"; empty if the world has no place on Earth. In ASCII, because
// programs differ in how they read other letters of a PNG.
std::string place_of(const Scenario& scenario, const glm::dvec3& at) {
    std::string place = scenario.georeference.describe({at.x, at.y});
    constexpr std::string_view kDegree = "°";
    for (std::size_t found; (found = place.find(kDegree)) != std::string::npos;)
        place.erase(found, kDegree.size());
    return place;
}

Outcome<fs::path> write_now(const render::Picture& picture, const std::string& name,
                            const render::PngTexts& texts) {
    const auto folder = screenshots_folder();
    if (!folder) return tl::unexpected(folder.error());
    auto path = new_file(*folder, name, "png");
    if (!path) return path;
    if (auto written = render::write_png(picture, *path, render::kFastPngCompression, texts); !written) {
        std::error_code error;
        fs::remove(*path, error);
        return machine_fails(written.error());
    }
    return path;
}

}  // namespace

render::PngTexts texts_of(const Shot& shot) {
    const Scenario& scenario = shot.scenario;
    const render::Camera& camera = shot.camera;
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    render::PngTexts texts{
        {"Title", scenario.title},
        {"Software", fmt::format("{}, commit {}", kProgram, kCommit)},
        {"Creation Time", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))},
        {"Scene", scenario.scene},
        {"Tick", std::to_string(shot.tick)},
        {"Time", fmt::format("{:.3f} s",
                             static_cast<double>(shot.tick) * static_cast<double>(scenario.params.tick_s))},
        {"Camera",
         fmt::format(
             "target = [{:.3f}, {:.3f}, {:.3f}], azimuth = {:.3f}, elevation = {:.3f}, distance = {:.3f}, "
             "field_of_view = {:.3f}",
             camera.target.x, camera.target.y, camera.target.z, camera.azimuth_deg, camera.elevation_deg,
             camera.distance_m, camera.field_of_view_deg)},
    };
    if (!shot.recording.empty()) texts.emplace_back("Recording", shot.recording.filename().string());
    if (const std::string place = place_of(scenario, render::eye(camera)); !place.empty())
        texts.emplace_back("Place of the camera", place);
    if (const std::string place = place_of(scenario, camera.target); !place.empty())
        texts.emplace_back("Place in view", place);
    if (shot.photo) {
        texts.emplace_back("Focal length",
                           fmt::format("{:.1f} mm, of a sensor 36 mm wide", shot.photo->focal_mm));
        texts.emplace_back("Exposure", fmt::format("{:+.1f} EV", shot.photo->exposure));
        if (shot.photo->f_number > 0)
            texts.emplace_back("Aperture", fmt::format("f/{}, focus at {:.0f} m, of a model 1:{}",
                                                       shot.photo->f_number, shot.focus_m, kModelScale));
    }
    return texts;
}

Outcome<void> Screenshots::write(render::Picture picture, std::string name, render::PngTexts texts) {
    if (jobs_.size() >= kMostAtOnce) jobs_.front().wait();
    try {
        jobs_.push_back(std::async(
            std::launch::async,
            [picture = std::move(picture), name = std::move(name),
             texts = std::move(texts)]() -> Outcome<fs::path> {
                try {
                    return write_now(picture, name, texts);
                } catch (const std::exception& thrown) {  // such as out of memory; none may leave the thread
                    return tl::unexpected(failure_of(thrown));
                }
            }));
    } catch (const std::system_error& thrown) {
        return tl::unexpected(failure_of(thrown));
    }
    return {};
}

std::optional<Outcome<fs::path>> Screenshots::result() {
    const auto is_ready = [](const auto& job) {
        return job.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    const auto ready = std::find_if(jobs_.begin(), jobs_.end(), is_ready);
    if (ready == jobs_.end()) return std::nullopt;
    auto result = ready->get();
    jobs_.erase(ready);
    return result;
}

}  // namespace game
