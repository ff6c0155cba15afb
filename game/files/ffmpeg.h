#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "files/descriptor.h"
#include "game/base/outcome.h"

namespace game {

// A run of the program ffmpeg, as PATH finds it, which reads from this one and writes files by itself. No shell takes part.
class Ffmpeg {
  public:
    // Errors (status 3): there is no such program, or the system starts none.
    static Outcome<Ffmpeg> start(std::vector<std::string> arguments);
    Ffmpeg(Ffmpeg&& other) noexcept;
    Ffmpeg& operator=(Ffmpeg&&) = delete;
    ~Ffmpeg();  // ends it if it still runs

    // On its standard input; waits until it has taken them. False: it takes no more. finish() knows why.
    bool write(std::span<const std::uint8_t> bytes) const;
    // Ends it at once, from any thread: a write() that waits returns.
    void stop() const;
    // Ends its input and waits until it is done. Errors (status 3): it failed; the sentence is the last that it printed.
    Outcome<void> finish();
    // What it prints on standard output until it closes that.
    std::string printed() const;

  private:
    Ffmpeg() = default;
    Outcome<void> begin(std::vector<std::string>& arguments, const files::Descriptor& its_end);
    void wait();

    pid_t process_ = 0;         // 0: it has ended
    int ended_ = 0;             // as waitpid() tells
    files::Descriptor socket_;  // its standard input and output
    files::Descriptor errors_;  // its standard error, kept in memory
};

// Names of the encoders that this machine's ffmpeg has. Errors: those of Ffmpeg.
Outcome<std::vector<std::string>> encoders_of_ffmpeg();

}  // namespace game
