// A message is a letter and what follows it:
//
//     to rank 0    H identity            who it is: the ensemble that it read
//                  R                     it could play one more member
//                  D line length, line, marks    it played a member, and could play one more
//                  F status, sentence    it failed
//     from rank 0  P number              play this member
//                  E                     end

#include "game/ensemble/other_ranks.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/base/process.h"
#include "game/ensemble/bytes.h"

namespace game {
namespace {

template <class Number>
void put_all(const std::vector<Number>& numbers, std::string& bytes) {
    put(static_cast<std::uint64_t>(numbers.size()), bytes);
    for (const Number number : numbers) put(number, bytes);
}

template <class Number>
std::vector<Number> all_of(ByteTaker& taker) {
    const auto many = std::min<std::uint64_t>(taker.next<std::uint64_t>(), taker.left());
    std::vector<Number> numbers;
    for (std::uint64_t i = 0; i < many && !taker.has_failed(); ++i) numbers.push_back(taker.next<Number>());
    return numbers;
}

std::string message_of(const PlayedMember& played) {
    const std::string line = line_of(played.member);
    std::string bytes = "D";
    put(static_cast<std::uint64_t>(line.size()), bytes);
    bytes += line;
    put_all(played.marks.vertices, bytes);
    put_all(played.marks.passed, bytes);
    put_all(played.marks.bins, bytes);
    std::vector<std::uint32_t> hardness;
    for (const float each : played.marks.hardness) hardness.push_back(std::bit_cast<std::uint32_t>(each));
    put_all(hardness, bytes);
    return bytes;
}

std::string message_of(const Failure& failure) {
    std::string bytes = "F";
    put(static_cast<std::uint32_t>(failure.status), bytes);
    return bytes + failure.sentence;
}

// Errors: what is wrong with it.
tl::expected<PlayedMember, std::string> played_from(std::string_view bytes) {
    ByteTaker taker(bytes);
    const auto length = taker.next<std::uint64_t>();
    const std::string_view line = taker.take(length);
    PlayedMember played;
    played.marks.vertices = all_of<std::uint32_t>(taker);
    played.marks.passed = all_of<std::uint16_t>(taker);
    played.marks.bins = all_of<std::uint16_t>(taker);
    for (const std::uint32_t each : all_of<std::uint32_t>(taker))
        played.marks.hardness.push_back(std::bit_cast<float>(each));
    if (taker.has_failed() || taker.left() > 0) return tl::unexpected(std::string("was cut"));
    auto member = member_of(std::string(line));
    if (!member) return tl::unexpected(member.error());
    played.member = std::move(*member);
    return played;
}

// The members that a process other than rank 0 was given, played on its threads.
class Crew {
  public:
    Crew(const EnsembleSpec& spec, int threads) : spec_(spec), counts_(spec.scene.scenario, spec.maps) {
        for (int i = 0; i < threads; ++i) team_.emplace_back([this] { play(); });
    }
    ~Crew() {
        const std::lock_guard lock(mutex_);
        stop_ = true;
        changed_.notify_all();
    }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    void give(std::int64_t number) {
        const std::lock_guard lock(mutex_);
        given_.push_back(number);
        changed_.notify_one();
    }
    // Messages for rank 0, oldest first; waits a little for one.
    std::deque<std::string> messages() {
        constexpr std::chrono::milliseconds kLook{2};
        std::unique_lock lock(mutex_);
        said_.wait_for(lock, kLook, [this] { return !messages_.empty(); });
        return std::exchange(messages_, {});
    }

  private:
    void play() {
        std::unique_lock lock(mutex_);
        while (!stop_) {
            changed_.wait(lock, [this] { return stop_ || !given_.empty(); });
            if (stop_) return;
            const std::int64_t number = given_.front();
            given_.pop_front();
            lock.unlock();
            std::string message = played(number);
            lock.lock();
            messages_.push_back(std::move(message));
            said_.notify_one();
        }
    }
    std::string played(std::int64_t number) {
        try {
            const auto member = play_member(spec_, number, counts_, [this] { return stop_.load(); });
            return member ? message_of(*member) : message_of(member.error());
        } catch (const std::exception& thrown) {  // such as out of memory; none may leave the thread
            return message_of(failure_of(thrown));
        }
    }

    const EnsembleSpec& spec_;
    const VertexCounts counts_;
    std::mutex mutex_;  // of all that follows
    std::condition_variable changed_, said_;
    std::deque<std::int64_t> given_;
    std::deque<std::string> messages_;
    std::atomic<bool> stop_ = false;
    std::vector<std::jthread> team_;  // last, so that it ends first
};

}  // namespace

void OtherRanks::look() {
    while (const auto message = ranks_.received()) take(*message);
    while (!waiting_.empty()) {
        const auto number = work_.next();
        if (!number) return;
        std::string bytes = "P";
        put(*number, bytes);
        ranks_.send(waiting_.front(), bytes);
        waiting_.pop_front();
        ++out_;
    }
}

void OtherRanks::take(const Ranks::Message& message) {
    const char letter = message.bytes.empty() ? ' ' : message.bytes.front();
    const std::string_view bytes = std::string_view(message.bytes).substr(message.bytes.empty() ? 0 : 1);
    switch (letter) {
        case 'H':
            if (bytes != spec_.identity)
                work_.fail(
                    {Failure::kUnusable,
                     fmt::format("rank {} has another {}, ground or version of the physics than rank 0",
                                 message.from, spec_.file.string())});
            return;
        case 'R':
            return waiting_.push_back(message.from);
        case 'F': {
            ByteTaker taker(bytes);
            const auto status = static_cast<Failure::Status>(taker.next<std::uint32_t>());
            return work_.fail({status, fmt::format("rank {}: {}", message.from, taker.take(taker.left()))});
        }
        default:
            break;
    }
    const auto played = played_from(bytes);
    if (letter != 'D' || out_ == 0 || !played || !work_.counts().can_count(played->marks))
        return work_.fail({Failure::kMachine, fmt::format("what rank {} sent cannot be read", message.from)});
    --out_;
    work_.finish(*played);
    waiting_.push_back(message.from);
}

Dismissal::~Dismissal() {
    for (int rank = 1; rank < ranks_.count(); ++rank) ranks_.send(rank, "E");
}

void play_for_rank_0(Ranks& ranks, const Outcome<EnsembleSpec>& spec, int threads) {
    std::optional<Crew> crew;
    if (spec) {
        ranks.send(0, "H" + spec->identity);
        crew.emplace(*spec, threads);
        for (int i = 0; i < threads; ++i) ranks.send(0, "R");
    } else {
        ranks.send(0, message_of(spec.error()));
    }
    while (true) {
        if (crew)
            for (const std::string& message : crew->messages()) ranks.send(0, message);
        else
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        while (const auto message = ranks.received()) {
            if (message->bytes == "E") return;
            crew->give(ByteTaker(std::string_view(message->bytes).substr(1)).next<std::int64_t>());
        }
    }
}

}  // namespace game
