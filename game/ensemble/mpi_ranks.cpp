// The module through which the program uses MPI (game/ensemble/ranks.h). MPI's own errors end all processes, with a sentence of
// its own.

#include <memory>

#include <mpi.h>

#include "game/ensemble/ranks.h"

namespace game {
namespace {

class MpiRanks final : public Ranks {
  public:
    MpiRanks() {
        int given = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
    }
    ~MpiRanks() override { MPI_Finalize(); }
    MpiRanks(const MpiRanks&) = delete;
    MpiRanks& operator=(const MpiRanks&) = delete;

    int rank() const override { return rank_; }
    int count() const override { return count_; }
    void send(int to, std::string_view bytes) override {
        // A member of the greatest grid has far fewer bytes than an int can say.
        MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, kTag, MPI_COMM_WORLD);
    }
    std::optional<Message> received() override {
        int has_come = 0, size = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &has_come, &status);
        if (has_come == 0) return std::nullopt;
        MPI_Get_count(&status, MPI_BYTE, &size);
        Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
        MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, kTag, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        return message;
    }

  private:
    static constexpr int kTag = 0;
    int rank_ = 0, count_ = 1;
};

}  // namespace

}  // namespace game

// ranks.cpp finds this symbol by name.
extern "C" {
[[gnu::visibility("default")]] extern const game::MpiDoor couloir_mpi;
const game::MpiDoor couloir_mpi{
    []() -> std::unique_ptr<game::Ranks> { return std::make_unique<game::MpiRanks>(); }};
}
