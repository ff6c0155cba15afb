// What a person does with the camera path of the window.
#include <cmath>
#include <utility>

#include "game/app/app.h"
#include "game/controls/camera_room.h"
#include "game/files/assets.h"
#include "game/files/recordings_folder.h"
#include "game/files/shelf.h"
#include "game/files/text_file.h"
#include "game/scene/camera_keys.h"
#include "game/words/words.h"

namespace game {

void App::perform(const EditPath& wish) {
    switch (wish.what) {
        case EditPath::What::kAdd:
            if (!path_.add(sandbox_->session().seconds(), camera()))
                tell(tr("This camera path cannot have another key. Remove one first"));
            return;
        case EditPath::What::kGoTo:
            return go_to_key(wish.key);
        case EditPath::What::kRemove:
            return path_.remove(wish.key);
        case EditPath::What::kPlay:
            return play_path();
        case EditPath::What::kStop:
            return path_.stop();
        case EditPath::What::kSave:
            return save_path();
        case EditPath::What::kLoad:
            return load_path();
    }
}

// To its camera, and to its time if that is known.
void App::go_to_key(std::size_t key) {
    if (key >= path_.keys().size()) return;
    path_.stop();
    const CameraKey& there = path_.keys()[key];
    lookout_.control().cut_to(
        CameraRoom(sandbox_->session().view(), lookout_.surroundings()).inside(there.camera));
    const std::int64_t tick = tick_of(there);
    if (!sandbox_->can_go_back()) return;
    if (tick > sandbox_->known_until())
        return tell(said("Nothing was played yet until {:.1f} s", there.time_s));
    time_.clock().pause(true);  // to be looked at
    time_.go_to(tick);
}

// From the first key on, if the world can go there, else from now.
void App::play_path() {
    path_.play();
    if (!path_.plays()) return;
    const std::int64_t first = tick_of(path_.keys().front());
    time_.run_on();
    time_.clock().pause(false);
    if (sandbox_->can_go_back() && first <= sandbox_->known_until()) time_.go_to(first);
}

std::int64_t App::tick_of(const CameraKey& key) const {
    return std::llround(key.time_s / static_cast<double>(sandbox_->scenario().params.tick_s));
}

// Beside the recording that is written or watched; of one that ships, among the user's own.
Outcome<std::filesystem::path> App::path_file() const {
    if (!sandbox_->watches()) {
        if (file_.path()) return camera_path_of(*file_.path());
        return unusable(tr("this session is not recorded"));
    }
    const std::filesystem::path& watched = first_.scene.files.front();
    const auto shipped = assets_folder();
    if (!shipped || watched.parent_path() != *shipped / "recordings") return camera_path_of(watched);
    auto folder = recordings_folder();
    if (!folder) return folder;
    return camera_path_of(*folder / watched.filename());
}

void App::save_path() {
    const auto file = path_file();
    const auto saved = file.and_then(
        [&](const std::filesystem::path& path) { return write_text(path, camera_path_text(path_.keys())); });
    skip_wait();
    if (!saved) return warn(said("This camera path is not saved: {}", saved.error().sentence));
    file_.keep();
    tell(said("Camera path: {}", file->string()));
}

void App::load_path() {
    auto loaded = path_file().and_then(load_camera_path);
    skip_wait();
    if (!loaded) return warn(said("No camera path was loaded: {}", loaded.error().sentence));
    path_.begin(std::move(*loaded));
    tell(said("Camera path: {} keys", path_.keys().size()));
}

}  // namespace game
