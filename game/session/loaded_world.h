#pragma once

#include <optional>
#include <string>

#include "game/base/outcome.h"
#include "game/recording/reader.h"
#include "game/scene/scene.h"

namespace game {

// Something that a sandbox can begin with.
struct LoadedWorld {
    Scene scene;
    std::string name;  // of a recording: that of its file
    std::optional<Recording>
        watched;       // a recording that goes on by itself up to its end, and then is the person's
    std::string told;  // what was loaded, as a sentence
    Memory memory;     // under which it was opened
};

// Opens a scene by its name, or a file: a scene (.toml), a recording (.couloir) or else an elevation raster.
// Shipped recordings are found by NAME.couloir. `overrides` hold for scenes and rasters; a recording is what
// it is. Errors: whatever is wrong with the file.
Outcome<LoadedWorld> open_anything(const std::string& name_or_path, const Overrides& overrides);

}  // namespace game
