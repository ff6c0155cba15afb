// An ensemble on several processes: played by threads that talk as processes do, and by mpirun where it is installed.

#include <cstdlib>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/ensemble/other_ranks.h"
#include "tests/ensemble/small_ensemble.h"

namespace game::test {
namespace {

// What was sent to each rank and not yet received.
class Post {
  public:
    explicit Post(int ranks) : boxes_(static_cast<std::size_t>(ranks)) {}
    void send(int from, int to, std::string_view bytes) {
        const std::lock_guard lock(mutex_);
        boxes_.at(static_cast<std::size_t>(to)).push_back({from, std::string(bytes)});
    }
    std::optional<Ranks::Message> received(int by) {
        const std::lock_guard lock(mutex_);
        std::deque<Ranks::Message>& box = boxes_.at(static_cast<std::size_t>(by));
        if (box.empty()) return std::nullopt;
        Ranks::Message message = std::move(box.front());
        box.pop_front();
        return message;
    }
    int ranks() const { return static_cast<int>(boxes_.size()); }

  private:
    std::mutex mutex_;
    std::vector<std::deque<Ranks::Message>> boxes_;
};

class ThreadRank final : public Ranks {
  public:
    ThreadRank(Post& post, int rank) : post_(post), rank_(rank) {}
    int rank() const override { return rank_; }
    int count() const override { return post_.ranks(); }
    void send(int to, std::string_view bytes) override { post_.send(rank_, to, bytes); }
    std::optional<Message> received() override { return post_.received(rank_); }

  private:
    Post& post_;
    int rank_;
};

class EnsembleOnRanks : public SmallEnsemble {
  protected:
    // Ranks 1 and up, each with its spec and so many threads.
    struct Other {
        Outcome<EnsembleSpec> spec;
        int threads;
    };
    void play(std::vector<Other> others, const std::function<void(Ranks&)>& rank_0) {
        Post post(static_cast<int>(others.size()) + 1);
        std::vector<std::jthread> processes;
        for (std::size_t i = 0; i < others.size(); ++i)
            processes.emplace_back([&, i] {
                ThreadRank rank(post, static_cast<int>(i) + 1);
                play_for_rank_0(rank, others[i].spec, others[i].threads);
            });
        ThreadRank first(post, 0);
        const Dismissal dismissal(first);
        rank_0(first);
    }
    std::string refused(std::vector<Other> others) {
        std::string sentence;
        play(std::move(others), [&](Ranks& ranks) {
            const auto result = run_ensemble(spec(), at("out"), 1, &ranks);
            EXPECT_FALSE(result);
            if (!result) sentence = result.error().sentence;
        });
        return sentence;
    }
};

TEST_F(EnsembleOnRanks, has_the_same_results_as_on_one) {
    const auto alone = played(spec(), "alone", 1);
    play({{spec(), 1}, {spec(), 2}}, [&](Ranks& ranks) {
        EXPECT_EQ(played(spec(), "together", 1, &ranks), alone);
        EXPECT_EQ(played(spec(), "together", 1, &ranks), alone) << "nothing is left to play";
    });
}

TEST_F(EnsembleOnRanks, is_refused_if_a_rank_has_another_ensemble_or_fails) {
    EnsembleSpec other = spec();
    other.identity = "0123456789abcdef";
    EXPECT_NE(refused({{other, 1}}).find("rank 1 has another "), std::string::npos);
    EXPECT_EQ(refused({{spec(), 1}, {unusable("spec.toml: is not there"), 1}}),
              "rank 2: spec.toml: is not there");
}

// Keeps what rank 1 says of one member.
std::string said_of_member(const EnsembleSpec& spec, std::int64_t number) {
    Post post(2);
    ThreadRank first(post, 0), second(post, 1);
    std::jthread process([&] { play_for_rank_0(second, spec, 1); });
    std::string play = "P";
    for (int i = 0; i < 8; ++i) play += static_cast<char>(i == 0 ? number : 0);
    first.send(1, play);
    std::string said;
    while (said.empty())
        if (const auto message = first.received(); message && message->bytes.front() == 'D')
            said = message->bytes;
    first.send(1, "E");
    return said;
}

TEST_F(EnsembleOnRanks, is_refused_if_what_a_rank_sent_is_damaged) {
    const EnsembleSpec few = spec(4);
    const std::string said = said_of_member(few, 2);
    int answers = 0;
    const auto answer = [&](const std::string& bytes) {
        auto journal = Journal::open(at(fmt::format("{}", ++answers)) / kJournalName, few);
        EXPECT_TRUE(journal);
        VertexCounts counts(few.scene.scenario, few.maps);
        Work work(few, *journal, counts);
        Post post(2);
        ThreadRank first(post, 0), second(post, 1);
        OtherRanks others(first, few, work);
        second.send(0, "R");
        others.look();
        second.send(0, bytes);
        others.look();
        return !work.is_stopped();
    };
    EXPECT_TRUE(answer(said));
    for (std::size_t length = 1; length < said.size(); length += length < 300 ? 1 : 97)
        EXPECT_FALSE(answer(said.substr(0, length))) << length;
}

#ifdef COULOIR_MPIRUN
// The exit status of the program on so many ranks.
int mpirun(int ranks, const std::string& arguments) {
    // Its libraries keep memory to the end, which is not ours to free.
    const int status = std::system(fmt::format("ASAN_OPTIONS=detect_leaks=0 {} -n {} --oversubscribe "
                                               "--allow-run-as-root {} ensemble {} >/dev/null",
                                               COULOIR_MPIRUN, ranks, support::program().string(), arguments)
                                       .c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(EnsembleOnRanks, has_the_same_results_under_mpirun) {
    const auto alone = results(spec(), "alone", 1);
    const std::string file = spec_file(8).string();
    for (const int ranks : {1, 3}) {
        const std::string name = fmt::format("on {}", ranks);
        ASSERT_EQ(mpirun(ranks, fmt::format("{} --out '{}' 2>/dev/null", file, at(name).string())), 0);
        EXPECT_EQ(files_in(name), alone) << ranks;
    }
}
#else
TEST_F(EnsembleOnRanks, has_the_same_results_under_mpirun) {
    GTEST_SKIP() << "built without MPI, or with sanitizers";
}
#endif

}  // namespace
}  // namespace game::test
