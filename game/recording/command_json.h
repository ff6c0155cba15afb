#pragma once

#include <string>

#include "game/recording/json_values.h"
#include "sim/world/command.h"

// A command as JSON, by the manifest (sim/world/command.h): {"pour":{"x":80.0,"y":138.0,…}}. A line of a recording has
// its tick beside it.
namespace game::values {

// Appends the name and the members, `"pour":{…}`. Allocates only if the string must grow.
void write(const sim::Command& command, std::string& line);
// The kind that an object names; null if it names none.
const sim::CommandInfo* kind_in(const Json& json);
// Its command. Throws as the readers of json_values.h.
sim::Command command_from(const Json& json, const sim::CommandInfo& info);

}  // namespace game::values
