#include "game/ensemble/ranks.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "files/module.h"

namespace game {
namespace {

// What launchers tell the processes that they start: Open MPI's and those that speak its PMIx, as srun does; MPICH's.
bool has_launcher() {
    constexpr const char* kSigns[] = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"};
    return std::ranges::any_of(kSigns, [](const char* sign) { return std::getenv(sign) != nullptr; });
}

}  // namespace

Outcome<std::unique_ptr<Ranks>> join_ranks() {
    if (!has_launcher()) return nullptr;
    const MpiDoor* door = nullptr;
    try {
        door = static_cast<const MpiDoor*>(files::symbol_of_module("libcouloir_mpi.so", "couloir_mpi"));
    } catch (const std::runtime_error&) {
        return machine_fails(
            "started by mpirun, and this program was built without MPI: install libopenmpi-dev and build it "
            "again, or start it "
            "without mpirun");
    }
    auto ranks = door->join();
    if (ranks->count() == 1) return nullptr;
    return ranks;
}

}  // namespace game
