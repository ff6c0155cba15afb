#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "files/growing_file.h"
#include "game/base/outcome.h"
#include "game/recording/format.h"
#include "game/recording/reader.h"
#include "game/recording/recorder.h"

namespace game {

// read_recording() of a file.
Outcome<Recording> read_recording(const std::filesystem::path& path, const Memory& memory = {});

// Recorders into files. Every line is passed to the system before the world continues, so a recording survives a `kill -9`
// up to its last whole line. The file is locked, so that no other process records into it. Its folder is made.
//
// A file of this name is replaced when the first line after the header is written, and kept beside the new one until
// Recorder::delete_replaced(). With kWhenDone nothing is seen of the new one, and nothing replaced, before the end line. A
// recorder that writes no line after its header leaves everything as it was.
using RecordingReplaces = files::GrowingFile::Replaces;
Outcome<Recorder> record_into(const std::filesystem::path& path, const Scenario& scenario,
                              std::optional<Parent> parent = std::nullopt);
Outcome<Recorder> record_into(const std::filesystem::path& path, const Header& header,
                              RecordingReplaces replaces = RecordingReplaces::kAsItGrows);
// Opens such a file. Without a path: an error.
RecordingStore::Open into_file(std::optional<std::filesystem::path> path,
                               RecordingReplaces replaces = RecordingReplaces::kAsItGrows);

}  // namespace game
