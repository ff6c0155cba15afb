#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace game {

// Why a command ends early: one sentence for the person, and the exit status.
struct Failure {
    enum Status { kBadAnswer = 1, kUnusable = 2, kMachine = 3 };
    Status status;
    std::string sentence;
};

template <class T>
using Outcome = tl::expected<T, Failure>;

// Outside data that cannot be used: file, place, fact.
inline tl::unexpected<Failure> unusable(std::string sentence) {
    return tl::unexpected(Failure{Failure::kUnusable, std::move(sentence)});
}
// The machine cannot do it: no GL, a folder that cannot be written, a full disk.
inline tl::unexpected<Failure> machine_fails(std::string sentence) {
    return tl::unexpected(Failure{Failure::kMachine, std::move(sentence)});
}

}  // namespace game
