#include "tests/window/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace game::test {
namespace {

constexpr int kPipe = 3;

// "NAME=value" for all of the child's environment.
std::vector<std::string> environment_of(const Environment& changes) {
    std::vector<std::string> all;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text(*variable);
        if (!changes.contains(std::string(text.substr(0, text.find('='))))) all.emplace_back(text);
    }
    for (const auto& [name, value] : changes)
        if (value) all.push_back(name + "=" + *value);
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

void redirect(const char* path, int flags, int descriptor) {
    const int file = open(path, flags, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) std::_Exit(127);
    if (file != descriptor) close(file);
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const Environment& environment,
             const std::filesystem::path& out, const std::filesystem::path& err, bool pipe) {
    std::vector<std::string> words = arguments, variables = environment_of(environment);
    const std::vector<char*> argv = pointers(words), envp = pointers(variables);
    int ends[2] = {-1, -1};
    if (pipe && pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no child process");
    if (pid_ == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) std::_Exit(127);
        redirect("/dev/null", O_RDONLY, STDIN_FILENO);
        redirect(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
        redirect(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
        if (pipe && ends[1] == kPipe) fcntl(kPipe, F_SETFD, 0);
        if (pipe && ends[1] != kPipe && dup2(ends[1], kPipe) < 0) std::_Exit(127);
        execvpe(argv[0], argv.data(), envp.data());
        std::_Exit(127);
    }
    if (pipe) close(ends[1]);
    pipe_ = ends[0];
}

Child::~Child() {
    if (!ended()) {
        kill(pid_, SIGTERM);
        if (!wait(2)) kill(pid_, SIGKILL);
        wait(10);
    }
    if (pipe_ >= 0) close(pipe_);
}

std::string Child::read_pipe(double seconds) {
    std::string line;
    within(seconds, [&] {
        pollfd asked{pipe_, POLLIN, 0};
        char letter = 0;
        while (::poll(&asked, 1, 0) > 0) {
            if (read(pipe_, &letter, 1) != 1 || letter == '\n') return true;
            line += letter;
        }
        return false;
    });
    return line;
}

void Child::signal(int number) {
    if (!ended()) kill(pid_, number);
}

bool Child::ended() {
    int options = 0;
    if (!status_ && waitpid(pid_, &options, WNOHANG) == pid_)
        status_ = WIFEXITED(options) ? WEXITSTATUS(options) : 128 + WTERMSIG(options);
    return status_.has_value();
}

std::optional<int> Child::wait(double seconds) {
    within(seconds, [&] { return ended(); });
    return status_;
}

bool within(double seconds, const std::function<bool()>& question) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!question()) {
        if (std::chrono::steady_clock::now() > end) return false;
        rest(0.005);
    }
    return true;
}

void rest(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

bool is_installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

}  // namespace game::test
