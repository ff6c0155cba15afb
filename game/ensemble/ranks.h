#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "game/base/outcome.h"

namespace game {

// The processes that one `mpirun` started, of which this is one, and messages between them. One thread may use it.
class Ranks {
  public:
    struct Message {
        int from;
        std::string bytes;
    };
    virtual ~Ranks() = default;    // waits until all others are as far
    virtual int rank() const = 0;  // from 0
    virtual int count() const = 0;
    // Returns when the bytes may be changed; long ones once they are received.
    virtual void send(int to, std::string_view bytes) = 0;
    virtual std::optional<Message> received() = 0;  // the next message, if one has come
};

// Joins the other processes, if one of MPI's launchers started this one and there are others; else nothing. MPI is a module
// that is loaded for this alone (mpi_ranks.cpp). Errors: the program was built without it (status 3).
Outcome<std::unique_ptr<Ranks>> join_ranks();

struct MpiDoor {
    std::unique_ptr<Ranks> (*join)();
};

}  // namespace game
