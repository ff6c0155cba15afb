#pragma once

#include <optional>
#include <string>

#include "game/base/outcome.h"
#include "game/recording/reader.h"
#include "game/scene/lesson.h"
#include "game/scene/scene.h"

namespace game {

// What a sandbox can begin with.
struct LoadedWorld {
    Scene scene;
    std::string name;                   // of a recording: its file name
    std::optional<Recording> watched;   // played to its end, then handed to the user
    std::string told;                   // what was loaded, as a sentence
    Memory memory;                      // the limits under which it was opened
    std::optional<Lesson> lesson = {};  // that is given with the watched recording
};

// The text of the recording that is watched. Errors: its file cannot be read, or nothing is watched.
Outcome<std::string> watched_text(const LoadedWorld& world);

// Whether nothing was done in a recording, and no time passed: it is a world to play in, not a session to watch.
bool is_world(const Recording& recording);

// Woods of a hill whose file has none: below the tree line of its latitude, which is 2,000 m in the Alps and 1,000 m in the
// south of Norway. They are for the eye alone, so its physics are those of the file.
render::TreeRules woods_of_hill(const Scenario& scenario);

// Opens a lesson by its name, or its file, with its recording. Errors (status 2): one of them cannot be used, or a stop is after
// the end of the recording or looks at a place beside its ground.
Outcome<LoadedWorld> open_lesson(const std::string& name_or_path, const Overrides& overrides);

// Opens a scene by its name, or a file: a scene or a lesson (.toml), a recording (.couloir) or else an elevation raster.
// Shipped recordings are found by NAME.couloir. A recording that is_world() begins as a scene, called by its file. `overrides` apply to scenes and rasters; only `look` and
// `memory` apply to recordings.
// Errors: the file cannot be read or is damaged.
Outcome<LoadedWorld> open_anything(const std::string& name_or_path, const Overrides& overrides);

}  // namespace game
