#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace game {

// Why a command ends early: one sentence for the user, and the exit status.
struct Failure {
    enum Status { kBadAnswer = 1, kUnusable = 2, kMachine = 3 };
    Status status;
    std::string sentence;
};

template <class T>
using Outcome = tl::expected<T, Failure>;

// Input that cannot be used. The sentence names the file, the place in it, and what is wrong.
inline tl::unexpected<Failure> unusable(std::string sentence) {
    return tl::unexpected(Failure{Failure::kUnusable, std::move(sentence)});
}
// The system fails: no OpenGL, a folder that cannot be written, a full disk.
inline tl::unexpected<Failure> machine_fails(std::string sentence) {
    return tl::unexpected(Failure{Failure::kMachine, std::move(sentence)});
}

}  // namespace game
