#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "game/ensemble/ranks.h"
#include "game/ensemble/work.h"

namespace game {

// Rank 0's side of an ensemble under `mpirun`: hands members to the other processes, and takes what came of them. A member
// comes as its line of the journal and its marks, so that a process that dies loses what it is playing and nothing else.
class OtherRanks {
  public:
    OtherRanks(Ranks& ranks, const EnsembleSpec& spec, Work& work)
        : ranks_(ranks), spec_(spec), work_(work) {}

    // Takes what has come, and hands out what is left.
    void look();
    bool are_playing() const { return out_ > 0; }

  private:
    void take(const Ranks::Message& message);

    Ranks& ranks_;
    const EnsembleSpec& spec_;
    Work& work_;
    std::deque<int> waiting_;  // ranks that could play one more member
    std::size_t out_ = 0;      // members that they play
};

// Tells all other processes that nothing is left to do. From rank 0; they wait for it, however rank 0 ends.
class Dismissal {
  public:
    explicit Dismissal(Ranks& ranks) : ranks_(ranks) {}
    ~Dismissal();
    Dismissal(const Dismissal&) = delete;
    Dismissal& operator=(const Dismissal&) = delete;

  private:
    Ranks& ranks_;
};

// The side of every other rank: plays members on so many threads until rank 0 says that nothing is left.
void play_for_rank_0(Ranks& ranks, const Outcome<EnsembleSpec>& spec, int threads);

}  // namespace game
