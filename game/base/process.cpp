#include "game/base/process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "game/base/one_line.h"

namespace game {
namespace {

constexpr rlim_t kLeastStack = 1 << 20;  // bytes; half of it is a margin

// Opens each for the opposite of its use, so that using it still fails as if it were closed.
void open_standard_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
            // open() returns the lowest free number, which is this one. Without /dev, a folder is opened.
            if (open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0)
                static_cast<void>(open("/", O_RDONLY | O_DIRECTORY));
}

Outcome<void> check_stack() {
    rlimit stack{};
    if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= kLeastStack) return {};
    return machine_fails(fmt::format("the stack is limited to {} kB, but {} kB are needed: run ulimit -s {}",
                                     stack.rlim_cur / 1024, kLeastStack / 1024, kLeastStack / 1024));
}

[[noreturn]] void end_by_exception() {
    try {
        if (std::current_exception()) std::rethrow_exception(std::current_exception());
    } catch (const std::exception& thrown) {
        std::fprintf(stderr, "couloir: %s\n", one_line(failure_of(thrown).sentence).c_str());
        std::_Exit(Failure::kMachine);
    } catch (...) {
    }
    std::abort();
}

// The one state that a signal may change.
volatile std::sig_atomic_t was_interrupted = 0;

extern "C" void note_interrupt(int signal) {
    was_interrupted = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

Outcome<void> prepare_process() {
    open_standard_descriptors();
    std::signal(SIGXFSZ, SIG_IGN);
    std::set_terminate(end_by_exception);
    return check_stack();
}

Failure failure_of(const std::exception& thrown) {
    if (dynamic_cast<const std::bad_alloc*>(&thrown))
        return {Failure::kMachine, "not enough memory; use a smaller --grid, or raise the limit (ulimit -v)"};
    const auto* of_system = dynamic_cast<const std::system_error*>(&thrown);
    if (of_system && of_system->code() == std::errc::resource_unavailable_try_again)
        return {Failure::kMachine, "the system cannot start more threads; use a smaller --threads"};
    return {Failure::kMachine, thrown.what()};
}

void note_interrupts() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, note_interrupt);
}

bool interrupted() {
    return was_interrupted != 0;
}

Outcome<void> finish_standard_output() {
    errno = 0;
    const bool failed_before = std::ferror(stdout) != 0;
    const bool flushed = std::fflush(stdout) == 0;
    const int reason = errno;
    // Some file systems report only on close that they are full.
    const int copy = flushed ? dup(STDOUT_FILENO) : -1;
    const bool closed = copy < 0 || close(copy) == 0;
    if (!failed_before && flushed && closed) return {};
    std::string sentence = "standard output: cannot be written";
    if (const int number = closed ? reason : errno; number != 0)
        sentence += fmt::format(": {}", std::strerror(number));
    return machine_fails(std::move(sentence));
}

int processors() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void lower_priority_of_thread() {
    constexpr int kLowest = 19;
    // In Linux this concerns the thread alone. Without it, the work is only less considerate.
    static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLowest));
}

bool show_folder(const std::filesystem::path& folder) {
    std::string program = "xdg-open", path = folder.string();
    char* const arguments[] = {program.data(), path.data(), nullptr};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&files, descriptor, "/dev/null", O_RDWR, 0);
    // It outlives this program, and a Ctrl+C in its terminal.
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
    pid_t process = 0;
    const int error = posix_spawnp(&process, program.c_str(), &files, &attributes, arguments, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) return false;
    // It may end only when its window is closed, so a thread waits for it.
    try {
        std::thread([process] { waitpid(process, nullptr, 0); }).detach();
    } catch (const std::system_error&) {  // then it stays a zombie until this program ends
    }
    return true;
}

}  // namespace game
