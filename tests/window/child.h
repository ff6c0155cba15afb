#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace game::test {

// Variables to set in a child's environment, over our own; none: removed.
using Environment = std::map<std::string, std::optional<std::string>>;

// A program that runs beside the test. It is ended with this object, or with the test itself.
class Child {
  public:
    // `arguments` begins with the program, by path or by a name that PATH finds. Standard output and error go
    // into files. `pipe`: its descriptor 3 writes to where read_pipe() reads. Throws std::runtime_error if
    // the program cannot be started.
    Child(const std::vector<std::string>& arguments, const Environment& environment,
          const std::filesystem::path& out, const std::filesystem::path& err, bool pipe = false);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // The first line that the program writes to its descriptor 3; none after the time limit, or if it ends
    // first.
    std::string read_pipe(double seconds);
    void signal(int number);
    bool ended();
    // Its exit status, or 128 + n after signal n; none if it still runs after that time.
    std::optional<int> wait(double seconds);

  private:
    pid_t pid_ = -1;
    int pipe_ = -1;
    std::optional<int> status_;
};

// Polls until the condition holds; false after the time limit.
bool within(double seconds, const std::function<bool()>& question);

void rest(double seconds);

// Whether PATH has a program of this name.
bool is_installed(const std::string& program);

}  // namespace game::test
