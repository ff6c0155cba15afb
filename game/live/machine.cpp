// What the machine has, for the module (game/scene/machine.cpp is the program's): as much memory as it was linked to take.
#include "game/scene/memory.h"

namespace game {

// A world may take half of a machine, and here all of it is the world's.
std::uint64_t machine_memory() {
    return std::uint64_t{2} * COULOIR_LIVE_MEMORY;
}

// The browser draws, in memory of its own.
std::uint64_t drawing_bytes(const WorldUse& /*use*/) {
    return 0;
}

}  // namespace game
